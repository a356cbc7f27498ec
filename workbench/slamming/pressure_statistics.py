"""How often a pressure is exceeded at every panel of the deck, and the largest one to expect.

Slams above a high pressure come as a Poisson process, so that the largest of some hours exceeds p with the
probability 1 - exp(-hours N(p)), N(p) being the number per hour above p.

.. [Ochi1964] M. K. Ochi, "Prediction of occurrence and severity of ship slamming
    at sea", 5th Symp. on Naval Hydrodynamics, Bergen, 1964, pp. 545-596.
.. [Garwood1936] F. Garwood, "Fiducial limits for the Poisson distribution",
    Biometrika 28, 437-442, 1936.
"""

import numpy as np
import xarray as xr
from scipy.stats import chi2

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.impact.pressure import PressureLaw
from workbench.impact.wagner import impact_pressure
from workbench.slamming.events import PARTS, grouping_dispersion, parts_of_record
from workbench.slamming.joint_law import ranked_pressures
from workbench.slamming.statistics import HOUR

BAND = 0.99
"""Probability of every band and range."""
LEAST_PER_HOUR = 1e-7
"""Number per hour down to which exceedance curves of the joint law reach [1/h]; once in a thousand years."""
DIMS = ("pressure_level", "x", "y")


def exponential_exceedance(
    moments: xr.Dataset,
    statistics: xr.Dataset,
    levels: np.ndarray,
    coefficient: float | np.ndarray,
    density: float,
) -> xr.Dataset:
    """Slams per hour above each pressure, for a fixed k: the exponential law of [Ochi1964]_.

    Parameters
    ----------
    moments, statistics : from `workbench.slamming.statistics`; the entry velocity is the time derivative.
    levels : pressures, growing [Pa].
    coefficient : k, pressure over rho V**2/2, one or (x, y) [-]; density : of the water [kg/m3].

    Returns
    -------
    Dataset over (pressure_level, x, y): ``exceedance_per_hour``.

    Notes
    -----
    N exp(-(p - p_t)/(rho k m2)), p_t = rho k v_t**2/2 being the pressure at the threshold velocity, below
    which all N slams lie. Costs microseconds a level.
    """
    levels = _checked_levels(levels)
    for value in np.ravel(coefficient):
        checked_number("coefficient", value, above=0, at_most=1e5, cure="give k of the panel")
    if statistics.attrs["velocity"] != "time-derivative":
        raise InputError(
            "The exponential law needs statistics of the time derivative, got the material velocity; take "
            "joint_exceedance with the law panel."
        )
    scale = density * np.asarray(coefficient, float) * moments.relative_velocity_std.values**2
    least = impact_pressure(statistics.attrs["threshold_velocity"], coefficient, density)
    beyond = np.maximum(levels[:, None, None] - least, 0.0) / np.maximum(scale, 1e-300)
    return _curve(
        statistics,
        levels,
        statistics.slams_per_hour.values * np.exp(-beyond),
        f"{statistics.attrs['method']}, exponential law of a fixed k",
    )


def joint_exceedance(
    moments: xr.Dataset,
    statistics: xr.Dataset,
    deck: xr.Dataset,
    levels: np.ndarray,
    law: PressureLaw,
    density: float,
) -> xr.Dataset:
    """Slams per hour above each pressure by any law, from the joint law of velocity and angle.

    Parameters
    ----------
    moments, statistics : from `workbench.slamming.statistics`, with the kind of velocity that is wanted.
    deck : with ``height`` and ``slope_x`` (x, y).
    levels : pressures, growing [Pa]; law : pressure law; density : of the water [kg/m3].

    Returns
    -------
    Dataset over (pressure_level, x, y): ``exceedance_per_hour``, down to `LEAST_PER_HOUR`.

    Notes
    -----
    See `workbench.slamming.joint_law`. Costs some 0.2 s for 60 levels and 400 points.
    """
    levels = _checked_levels(levels)
    ranked = ranked_pressures(moments, statistics, deck, law, density, LEAST_PER_HOUR)
    return _curve(
        statistics,
        levels,
        ranked.number_above(levels),
        f"{statistics.attrs['method']}, joint law of velocity and angle, {law.name}",
        law.validity,
    )


def counted_exceedance(record: xr.Dataset, levels: np.ndarray, deck: xr.Dataset | None = None) -> xr.Dataset:
    """Slams per hour above each pressure, counted in a record, with their 99 % bands.

    Parameters
    ----------
    record : slams with ``slam_panel_pressure`` (slam, x, y) [Pa] and ``slam_start`` (slam) [s], or the entries of
        `workbench.slamming.events.entries`; attribute ``duration`` [s].
    levels : pressures, growing [Pa].
    deck : with x and y; needed for entries, which do not name the points that stay dry.

    Returns
    -------
    Dataset over (pressure_level, x, y): ``exceedance_per_hour``, ``exceedance_low``, ``exceedance_high``;
    over pressure_level ``exceedance_dispersion``.

    Notes
    -----
    Intervals of [Garwood1936]_ for the number over the dispersion, times the dispersion: slams come in groups,
    so that their number spreads by more than Poisson's. The dispersion is that of the numbers in equal
    parts of the record, as in `events.counts`, at each pressure; where too few slams are left
    to tell, it is that of the next lower pressure, which is on the safe side. With no slam
    counted the upper end is that of a one-sided band.
    """
    levels = _checked_levels(levels)
    times, row, column, pressure, x, y = _slams(record, deck)
    duration = checked_number("duration of the record", record.attrs.get("duration"), "s", above=0)
    part = parts_of_record(times, duration)
    grouped = np.zeros((PARTS, len(levels) + 1, len(x), len(y)))
    np.add.at(grouped, (part, np.searchsorted(levels, pressure), row, column), 1.0)
    grouped = np.flip(np.cumsum(np.flip(grouped, 1), axis=1), 1)[:, 1:]
    number = grouped.sum(axis=0)
    dispersion = np.ones(len(levels))
    for index in range(len(levels)):
        few = (number[index] < PARTS).all()
        dispersion[index] = (
            (dispersion[index - 1] if index else 1.0) if few else grouping_dispersion(grouped[:, index])
        )
    low, high = rate_band(number, dispersion[:, None, None])
    per_hour = HOUR / duration
    return quantities.dataset(
        {"pressure_level": levels, "x": x, "y": y},
        method=f"{record.attrs.get('method', '')}, counted",
        warnings=quantities.warnings_of(record),
        attrs={"duration": duration},
        exceedance_per_hour=(DIMS, number * per_hour),
        exceedance_low=(DIMS, low * per_hour),
        exceedance_high=(DIMS, high * per_hour),
        exceedance_dispersion=("pressure_level", dispersion),
    )


def rate_band(number, dispersion=1.0) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper end of the 99 % band of the number expected, where so many were counted ([Garwood1936]_).

    Parameters
    ----------
    number : counted; dispersion : its variance over Poisson's, at least 1 [-].
    """
    outside = (1 - BAND) / 2
    number, dispersion = np.broadcast_arrays(np.asarray(number, float), np.asarray(dispersion, float))
    counted = np.maximum(number, 0.5) / dispersion
    low = np.where(number > 0, dispersion * chi2.ppf(outside, 2 * counted) / 2, 0.0)
    high = dispersion * chi2.ppf(1 - outside, 2 * counted + 2) / 2
    return low, np.where(number > 0, high, -dispersion * np.log(1 - BAND))


def largest_pressures(curve: xr.Dataset, hours: float, risk: float = 0.01) -> xr.Dataset:
    """Largest pressure of a number of hours, from an exceedance curve, at every point (x, y).

    Parameters
    ----------
    curve : with ``exceedance_per_hour`` over pressure_level and other dimensions.
    hours : at sea in what the curve holds for [h]; risk : of being exceeded in that time [-].

    Returns
    -------
    Dataset of ``most_probable_peak_pressure`` (one slam expected above it), ``extreme_pressure`` (exceeded
    with the probability ``risk``), ``largest_low`` and ``largest_high`` (range that holds the largest with
    99 %). 0 where no slam is that probable; not a number where the levels of the curve end before.

    Notes
    -----
    The largest is below p with the probability exp(-hours N(p)); read between levels in the
    logarithm of N, which is exact for the exponential law.
    """
    hours = checked_number("hours", hours, "h", above=0)
    risk = checked_number("risk", risk, above=0, below=1, cure="0.01 is one in a hundred")
    outside = (1 - BAND) / 2
    wanted = {
        "most_probable_peak_pressure": 1.0,
        "extreme_pressure": -np.log1p(-risk),
        "largest_low": -np.log(outside),
        "largest_high": -np.log1p(-outside),
    }
    number = curve.exceedance_per_hour.transpose("pressure_level", ...)
    dims = number.dims[1:]
    levels, values = curve.pressure_level.values, number.values
    found = {name: level_exceeded(levels, values, one / hours) for name, one in wanted.items()}
    notes = list(quantities.warnings_of(curve))
    if any(np.isnan(one).any() for one in found.values()):
        notes.append(
            f"The pressures of the curve end at {levels[-1] / 1e3:.4g} kPa, which is exceeded more often than is asked "
            "for; take higher ones."
        )
    return quantities.dataset(
        {name: curve[name] for name in dims if name in curve.coords},
        method=curve.attrs["method"],
        warnings=notes,
        attrs={"hours": hours, "risk": risk},
        **{name: (dims, one) for name, one in found.items()},
    )


def level_exceeded(levels: np.ndarray, number: np.ndarray, per_hour: float) -> np.ndarray:
    """Pressure exceeded so many times per hour [Pa], from falling numbers (level, ...).

    0 where the lowest level is exceeded less often, not a number where the highest is exceeded more often.
    """
    often = number > per_hour
    after = np.clip(often.sum(axis=0), 1, len(levels) - 1)[None]
    fewer, more = (np.take_along_axis(number, index, axis=0)[0] for index in (after, after - 1))
    lower, higher = levels[after[0] - 1], levels[after[0]]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.log(more / per_hour) / np.log(more / fewer)
    found = lower + np.clip(np.nan_to_num(share), 0.0, 1.0) * (higher - lower)
    found = np.where(often[-1], np.nan, found)
    return np.where(often[0], found, 0.0)


def _checked_levels(levels) -> np.ndarray:
    levels = np.asarray(levels, float)
    if levels.ndim != 1 or len(levels) < 2 or not np.all(np.isfinite(levels)) or levels[0] < 0:
        raise InputError("pressure levels must be at least 2 finite pressures >= 0 Pa in a row.")
    if np.any(np.diff(levels) <= 0):
        raise InputError("pressure levels must grow; sort them.")
    return levels


def _curve(statistics: xr.Dataset, levels, number, method: str, notes=()) -> xr.Dataset:
    return quantities.dataset(
        {"pressure_level": levels, "x": statistics.x, "y": statistics.y},
        method=method,
        warnings=[*quantities.warnings_of(statistics), *notes],
        exceedance_per_hour=(DIMS, number),
    )


def _slams(record: xr.Dataset, deck: xr.Dataset | None):
    """Return time, row, column and pressure of every wet panel in every slam, and x and y of the panels."""
    if "slam_panel_pressure" in record:
        pressures = record.slam_panel_pressure.transpose("slam", "x", "y").values
        slam, row, column = np.nonzero(pressures > 0)
        times = record.slam_start.values[slam]
        return times, row, column, pressures[slam, row, column], record.x.values, record.y.values
    if deck is None:
        raise InputError("deck must be given for entries, which do not name the points that stay dry.")
    x, y = deck.x.values, deck.y.values
    row, column = (
        np.argmin(np.abs(places.values[:, None] - known), axis=1) if len(places) else np.zeros(0, int)
        for places, known in ((record.event_x, x), (record.event_y, y))
    )
    return record.event_time.values, row, column, record.peak_pressure.values, x, y
