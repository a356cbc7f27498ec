"""Design load of a cross structure: pressure along, across and by area, and on its front bulkhead.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, pp. 28, 32-34.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_number

PSI = 6894.757293168361
"""Pound per square inch [Pa]."""

SQUARE_FOOT = 0.09290304
"""Square foot [m2]."""

SIDE_SHARE = 0.70
"""Pressure at the sides of the cross structure over that on its centreline [-]."""

STATIONS = 20
"""Stations in the length, counted from the fore perpendicular."""

HAYES_PLATE_AREA = 16.0 * SQUARE_FOOT
"""Area of one plate field of USNS HAYES, about 16 ft2 (22 to 24 by 96 in) [m2]."""

HAYES_PEAK_AREA = 300.0 * SQUARE_FOOT
"""Area over which the largest design pressure of HAYES was taken [m2]."""


@dataclass(frozen=True, kw_only=True)
class DesignLine:
    """Equivalent static pressure on the centreline: constant, then falling by a line, then constant.

    Parameters
    ----------
    forward_pressure, aft_pressure : before and behind the falling part [Pa].
    forward_station, aft_station : at which it begins and ends, 0 at the fore perpendicular, 20 aft.

    Notes
    -----
    Unless given, the criterion adopted for USNS HAYES: 50 psi at station 3, 10 psi from
    station 14 aft ([Chuang1975]_); forward of station 3 the source says nothing and the
    value is held.
    """

    forward_pressure: float = 50 * PSI
    aft_pressure: float = 10 * PSI
    forward_station: float = 3.0
    aft_station: float = 14.0

    def __post_init__(self):
        checked_number("forward pressure", self.forward_pressure, "Pa", above=0)
        checked_number(
            "aft pressure", self.aft_pressure, "Pa", at_least=0, at_most=self.forward_pressure,
            cure="the cross structure slams hardest forward",
        )  # fmt: skip
        checked_number("forward station", self.forward_station, at_least=0, below=STATIONS)
        checked_number("aft station", self.aft_station, above=self.forward_station, at_most=STATIONS)

    def pressure(self, station) -> np.ndarray:
        """Pressure at stations [Pa]."""
        return np.interp(
            np.asarray(station, float),
            [self.forward_station, self.aft_station],
            [self.forward_pressure, self.aft_pressure],
        )

    def with_peak(self, peak: float) -> "DesignLine":
        """Line of the same shape with another forward pressure, such as one predicted for the ship [Pa]."""
        share = checked_number("peak of the design line", peak, "Pa", above=0) / self.forward_pressure
        return dataclasses.replace(self, forward_pressure=peak, aft_pressure=share * self.aft_pressure)


@dataclass(frozen=True, kw_only=True)
class AreaReduction:
    """Share of the design pressure by loaded area, between the rows of a table.

    Parameters
    ----------
    areas : increasing [m2]; shares : in (0, 1], not increasing, the first 1.

    Notes
    -----
    The source's curve (its Fig. 9) is a picture of which only one point is stated in
    words; the table is the user's. Beyond its ends the end values are held. The logarithm
    of the area is interpolated.
    """

    areas: tuple[float, ...]
    shares: tuple[float, ...]

    def __post_init__(self):
        if len(self.areas) < 2 or len(self.areas) != len(self.shares):
            raise InputError(
                f"table of area reduction must have two rows or more, got {len(self.areas)} areas and "
                f"{len(self.shares)} shares."
            )
        for name, unit, values in (("area", "m2", self.areas), ("share", "", self.shares)):
            for value in values:
                checked_number(f"{name} of the area reduction", value, unit, above=0)
        if np.any(np.diff(self.areas) <= 0):
            raise InputError("areas of the area reduction must increase; sort the table.")
        if np.any(np.diff(self.shares) > 0) or self.shares[0] != 1:
            raise InputError(
                "shares of the area reduction must begin with 1 and not increase: a larger area bears a lower mean."
            )

    def share(self, area) -> np.ndarray:
        """Share of the pressure on an area [m2]."""
        return np.interp(np.log(np.asarray(area, float)), np.log(self.areas), self.shares)


def station(x, length: float) -> np.ndarray:
    """Station of a place forward of amidships [m], 0 at the fore perpendicular and 20 at the aft one."""
    checked_number("length", length, "m", above=0)
    return STATIONS * (0.5 - np.asarray(x, float) / length)


def transverse_share(y, half_width: float) -> np.ndarray:
    """Pressure across the deck over that on the centreline, 1 - 0.3 (y/half-width)^2 [-]; mean 0.9."""
    checked_number("half width", half_width, "m", above=0)
    share = np.abs(np.asarray(y, float)) / half_width
    if np.any(share > 1 + 1e-9):
        raise InputError(
            f"y must be inside the half width of {half_width:g} m, got {np.abs(np.asarray(y)).max():g} m."
        )
    return 1 - (1 - SIDE_SHARE) * share**2


def design_load(
    deck: xr.Dataset,
    length: float,
    half_width: float,
    line: DesignLine | None = None,
    *,
    reduction: AreaReduction | None = None,
    area: float = HAYES_PEAK_AREA,
) -> xr.Dataset:
    """Design pressure over a wet deck, to be applied quasi-statically (x, y).

    Parameters
    ----------
    deck : from `workbench.geometry.wet_deck.wet_deck_grid`.
    length : between the perpendiculars, amidships half way; half_width : of the deck [m].
    line : along the centreline; None takes that of USNS HAYES.
    reduction : table of the user; area : loaded area of the member [m2]. Without a table the
        pressure is that of the line, and the area only remarked upon.

    Returns
    -------
    Dataset (x, y): ``design_pressure`` [Pa]; ``design_line`` and ``station`` (x);
    ``transverse_share`` (y).
    """
    line = line or DesignLine()
    checked_number("area", area, "m2", above=0)
    at = station(deck.x.values, length)
    along, across = line.pressure(at), transverse_share(deck.y.values, half_width)
    notes = [
        "Local load of the cross structure in head seas, flat bottom, applied quasi-statically; whole-ship bending and "
        "whipping are not in it."
    ]
    if line == DesignLine():
        notes.append(
            "The line is the criterion adopted for one ship, USNS HAYES; set its peak by a prediction for another."
        )
    if np.any(at < line.forward_station):
        notes.append(f"Forward of station {line.forward_station:g} the pressure of that station is held.")
    share = 1.0
    if reduction is not None:
        share = float(reduction.share(area))
    elif area < 0.99 * HAYES_PEAK_AREA:
        notes.append(
            f"No reduction by area: the line holds for about {HAYES_PEAK_AREA:.0f} m2, and a peak on "
            f"{area:.3g} m2 is higher; give a table."
        )
    return quantities.dataset(
        {"x": deck.x, "y": deck.y},
        method="design line, parabola across",
        warnings=notes,
        attrs={"loaded_area": float(area), "area_share": share},
        design_pressure=(("x", "y"), share * along[:, None] * across[None, :]),
        design_line=("x", along),
        station=("x", at),
        transverse_share=("y", across),
    )


def front_bulkhead_pressure(speed, celerity, density):
    """Pressure on a vertical front bulkhead, twice the stagnation pressure of V_h + V_w [Pa] ([Chuang1975]_ eq. 10).

    Notes
    -----
    The factor 2 is for sudden application; the model's gauge read as much. By a footnote
    a bulkhead curved horizontally by 2 to 3 degrees may see less than half.
    """
    return 2 * stagnation_pressure(np.asarray(speed) + celerity, density)


def stagnation_pressure(velocity, density):
    """Stagnation pressure rho V**2/2 [Pa]."""
    return density * np.square(velocity) / 2
