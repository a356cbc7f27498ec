"""Operating profile: how long a ship sails in which sea, at which speed and heading, and what it makes of the slams.

Each condition has its share of the time; what happens per hour at sea is the sum over the conditions of share
times rate, and the largest of many hours follows from that sum as in `workbench.slamming.pressure_statistics`.
Pure arithmetic on results per condition: whoever has them, from wherever, can weigh them here.
"""

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import KNOT
from workbench.errors import InputError, checked_number
from workbench.sea_scatter import PERIODS, ScatterDiagram, sea_by_period
from workbench.seas import Condition

_ROUNDING = 1e-6
COLUMNS = ("share", "speed_knots", "heading_degrees", "significant_wave_height")
"""Columns of an operating profile as CSV, beside one period of `PERIOD_COLUMNS`."""
PERIOD_COLUMNS = {f"{kind.replace('-', '_')}_period": kind for kind in PERIODS}


@dataclass(frozen=True, kw_only=True)
class OperatingProfile:
    """Share of the time in each condition.

    Parameters
    ----------
    name : in words.
    shares : of the time at sea [-], each above 0; the sum is 1, or less where the rest is time without slams
        (harbour, calm, seas in which the ship does not sail).
    conditions : speed, heading and sea of each share.
    """

    name: str
    shares: tuple[float, ...]
    conditions: tuple[Condition, ...]

    def __post_init__(self):
        shares = tuple(
            checked_number("share of the time", share, above=0, at_most=1 + _ROUNDING)
            for share in self.shares
        )
        object.__setattr__(self, "shares", shares)
        object.__setattr__(self, "conditions", tuple(self.conditions))
        if not shares or len(shares) != len(self.conditions):
            raise InputError(
                f"operating profile must have a share for each of its conditions, at least one, got {len(shares)} "
                f"shares and {len(self.conditions)} conditions."
            )
        if not all(isinstance(condition, Condition) for condition in self.conditions):
            raise InputError("conditions of an operating profile must be of the class Condition.")
        if sum(shares) > 1 + _ROUNDING:
            raise InputError(
                f"shares of the time must sum to 1 at most, got {sum(shares):.6g}; divide them by their sum, or leave "
                "something out."
            )

    @property
    def quiet_share(self) -> float:
        """Share of the time that is in no condition [-]."""
        return max(0.0, 1.0 - sum(self.shares))

    @property
    def speeds(self) -> tuple[float, ...]:
        """Speeds that occur [m/s], growing: motions are computed once for each."""
        return tuple(sorted({condition.speed for condition in self.conditions}))


def profile_of_scatter(
    diagram: ScatterDiagram,
    headings: Mapping[float, float],
    speeds: Sequence[tuple[float, float]],
    *,
    share_at_sea: float = 1.0,
    **others,
) -> OperatingProfile:
    """Operating profile from a scatter diagram, headings independent of the sea, and speeds by its height.

    Parameters
    ----------
    diagram : seas and how often they are.
    headings : wave directions [rad] and the share of each; sum 1.
    speeds : pairs (greatest significant height [m], speed [m/s]), heights growing: in seas up to that height the
        ship sails at that speed; above the last one she does not sail.
    share_at_sea : share of the time that she sails at all [-].
    others : as for `workbench.seas.SeaState`, such as ``spectrum``.
    """
    share_at_sea = checked_number("share of the time at sea", share_at_sea, above=0, at_most=1)
    total = sum(checked_number("share of a heading", share, at_least=0) for share in headings.values())
    checked_number("sum of the shares of headings", total, at_least=1 - _ROUNDING, at_most=1 + _ROUNDING)
    limits = np.array([height for height, _ in speeds])
    if not len(limits) or np.any(np.diff(limits) <= 0):
        raise InputError("speeds must be pairs (greatest height, speed) of growing height, at least one.")
    shares, conditions = [], []
    for share, sea in diagram.seas(**others):
        row = int(np.searchsorted(limits, sea.significant_wave_height))
        if row == len(limits):
            continue
        for direction, part in headings.items():
            if part > 0:
                shares.append(share_at_sea * share * part)
                conditions.append(Condition(speed=speeds[row][1], wave_direction=direction, sea_state=sea))
    if not shares:
        raise InputError(
            f"speeds must reach the lowest sea of the diagram, {min(diagram.heights):g} m, got {limits[-1]:g} m."
        )
    return OperatingProfile(name=diagram.name, shares=tuple(shares), conditions=tuple(conditions))


def profile_of_text(text: str, *, name: str = "operating profile", **others) -> OperatingProfile:
    """Operating profile from CSV text, a condition a line.

    Columns of the head: ``share``, ``speed_knots``, ``heading_degrees`` (180 is head seas),
    ``significant_wave_height`` [m] and one of ``peak_period``, ``mean_period``, ``zero_crossing_period`` [s]; lines
    with # are remarks. ``others`` as for `workbench.seas.SeaState`.
    """
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    rows = list(csv.DictReader(lines, skipinitialspace=True))
    head = [] if not rows else [key.strip() for key in rows[0] if key]
    periods = [column for column in PERIOD_COLUMNS if column in head]
    missing = [column for column in COLUMNS if column not in head]
    if missing or len(periods) != 1:
        raise InputError(
            f"operating profile must have the columns {', '.join(COLUMNS)} and one of {', '.join(PERIOD_COLUMNS)}, "
            f"got {', '.join(head) or 'nothing'}."
        )
    shares, conditions = [], []
    for number, row in enumerate(rows, start=1):
        values = [_number(column, row[column], number) for column in (*COLUMNS, periods[0])]
        share, knots, degrees, height, period = values
        checked_number(f"heading_degrees of row {number}", degrees, "degrees", at_least=0, at_most=360)
        shares.append(share)
        conditions.append(
            Condition(
                speed=knots * KNOT,
                wave_direction=float(np.radians(degrees)),
                sea_state=sea_by_period(height, period, PERIOD_COLUMNS[periods[0]], **others),
            )
        )
    return OperatingProfile(name=name, shares=tuple(shares), conditions=tuple(conditions))


def weighted_slams(profile: OperatingProfile, slams_per_hour: xr.DataArray) -> xr.Dataset:
    """Slams per hour at sea over a profile, and how much of them each condition brings.

    Parameters
    ----------
    slams_per_hour : (condition, ...), in the order of the profile [1/h].

    Returns
    -------
    Dataset of ``slams_per_hour`` (...) and ``contribution`` (condition, ...), which sums to 1 (0 without slams).
    """
    return _weighted(profile, slams_per_hour, "slams_per_hour", "", ())


def profile_exceedance(profile: OperatingProfile, curves: Sequence[xr.Dataset]) -> xr.Dataset:
    """Slams per hour at sea above each pressure over a profile, and how much of them each condition brings.

    Parameters
    ----------
    curves : exceedance curves of `workbench.slamming.pressure_statistics`, one for each condition of the profile in
        its order, all for the same pressures and points.

    Returns
    -------
    Dataset over (pressure_level, x, y): ``exceedance_per_hour``; ``contribution`` (condition, ...); ``share`` and
    ``forward_speed``, ``wave_direction``, ``significant_wave_height`` and ``peak_period`` of the conditions. Of
    counted curves also ``exceedance_low`` and ``exceedance_high``: the records being independent, the
    half-widths of their bands are added in squares.

    Notes
    -----
    `workbench.slamming.pressure_statistics.largest_pressures` takes the result as it takes any curve: its hours
    are then those at sea, a life long if wanted.
    """
    if len(curves) != len(profile.conditions):
        raise InputError(
            f"exceedance curves must be one for each condition, {len(profile.conditions)}, got {len(curves)}."
        )
    first = curves[0]
    for curve in curves[1:]:
        for name in first.exceedance_per_hour.dims:
            if not np.array_equal(curve[name].values, first[name].values):
                raise InputError(f"exceedance curves must have the same {name}; compute them alike.")
    stacked = xr.concat([curve.exceedance_per_hour for curve in curves], dim="condition")
    found = _weighted(
        profile, stacked, "exceedance_per_hour", first.attrs["method"], quantities.warnings_of(*curves)
    )
    if not all("exceedance_low" in curve for curve in curves):
        return found
    ends = {}
    for name, sign in (("exceedance_low", -1.0), ("exceedance_high", 1.0)):
        squares = sum(
            (share * (curve[name] - curve.exceedance_per_hour)) ** 2
            for share, curve in zip(profile.shares, curves, strict=True)
        )
        ends[name] = (found.exceedance_per_hour + sign * np.sqrt(squares)).clip(min=0.0)
    return quantities.labelled(found.assign(ends))


def _weighted(
    profile: OperatingProfile, rates: xr.DataArray, name: str, method: str, warnings: Sequence[str]
) -> xr.Dataset:
    if rates.sizes.get("condition") != len(profile.conditions):
        raise InputError(
            f"results must be for each condition of the profile, {len(profile.conditions)}, got "
            f"{rates.sizes.get('condition', 0)}."
        )
    values = rates.transpose("condition", ...)
    dims = values.dims
    shares = np.asarray(profile.shares)
    parts = shares.reshape(-1, *[1] * (values.ndim - 1)) * values.values
    total = parts.sum(axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        contribution = np.where(total > 0, parts / total, 0.0)
    seas = [condition.sea_state for condition in profile.conditions]
    of_condition = {
        "share": shares,
        "forward_speed": [condition.speed for condition in profile.conditions],
        "wave_direction": [condition.wave_direction for condition in profile.conditions],
        "significant_wave_height": [sea.significant_wave_height for sea in seas],
        "peak_period": [sea.peak_period for sea in seas],
    }
    return quantities.dataset(
        {
            "condition": np.arange(len(shares)),
            **{one: values[one].values for one in dims[1:] if one in values.coords},
            **{key: ("condition", one) for key, one in of_condition.items()},
        },
        method=method,
        warnings=warnings,
        attrs={"profile": profile.name, "quiet_share": profile.quiet_share},
        **{name: (dims[1:], total), "contribution": (dims, contribution)},
    )


def _number(column: str, text: str | None, row: int) -> float:
    try:
        return checked_number(f"{column} of row {row}", float(text or ""))
    except ValueError:
        raise InputError(f"{column} of row {row} must be a number, got {text!r}.") from None
