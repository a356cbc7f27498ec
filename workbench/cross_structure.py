"""Chuang's design procedure for a ship: motions in a regular head wave, impact pressure, timing, design load.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, conclusion 9.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench.errors import InputError, checked_number
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.impact.design_load import (
    HAYES_PEAK_AREA,
    AreaReduction,
    DesignLine,
    design_load,
    front_bulkhead_pressure,
)
from workbench.impact.regular_motion import RegularMotion, regular_motion, regular_wave_slams
from workbench.impact.slam_timing import SlamTiming, natural_periods, slam_timing
from workbench.pipeline import DECK_POINTS, Response


@dataclass(frozen=True, kw_only=True, eq=False)
class CrossStructure:
    """A cross structure in one regular head wave.

    Parameters
    ----------
    motion : of the ship; slams : prediction over the deck (x, y), NaN where the water does not reach.
    worst : indices of the point of the largest peak pressure, or where nothing slams, of that nearest to it.
    timing : checks at that point.
    load : design load with the largest predicted peak, or None where nothing slams.
    bulkhead_pressure : on a vertical front bulkhead [Pa].
    natural_periods : of heave and pitch [s], as far as the frequencies reach.
    """

    name: str
    motion: RegularMotion
    slams: xr.Dataset
    worst: dict[str, int]
    timing: SlamTiming
    load: xr.Dataset | None
    bulkhead_pressure: float
    natural_periods: dict[str, float]

    @property
    def peak_pressure(self) -> float:
        """Largest predicted peak pressure [Pa]; 0 where nothing slams."""
        value = float(self.slams.peak_pressure.isel(self.worst))
        return value if np.isfinite(value) else 0.0


def cross_structure(
    ship: Response,
    wave_period: float,
    wave_height: float,
    *,
    line: DesignLine | None = None,
    reduction: AreaReduction | None = None,
    area: float = HAYES_PEAK_AREA,
    deck_points: tuple[int, int] = DECK_POINTS,
) -> CrossStructure:
    """Chuang's prediction and design load for a ship in a regular head wave (milliseconds).

    Parameters
    ----------
    ship : from `workbench.pipeline.response`, with head seas among its directions.
    wave_period : [s]; wave_height : from trough to crest [m].
    line : whose shape the load takes, HAYES' unless given; its peak is the predicted one.
    reduction, area : as for `workbench.impact.design_load.design_load`.
    deck_points : along and across the deck.
    """
    design = ship.design
    if design.wet_deck is None:
        raise InputError(f"design must have a wet deck to slam on, {design.name} has none; add one.")
    checked_number("wave period", wave_period, "s", above=0)
    checked_number("wave height", wave_height, "m", above=0)
    motion = regular_motion(ship.motions, 2 * np.pi / wave_period, wave_height / 2)
    deck = wet_deck_grid(design.wet_deck, *deck_points)
    centre_x = design.masses.centre_of_gravity[0]
    slams = regular_wave_slams(motion, deck, centre_x, design.density)
    lever = deck.x.values[:, None] - centre_x
    pressure = slams.peak_pressure.values
    reach = np.abs(motion.relative_motion(lever)) / deck.height.values
    towards_centre = 1 - 1e-9 * np.abs(deck.y.values)
    ranked = np.nan_to_num(pressure) if np.isfinite(pressure).any() else reach
    row, column = np.unravel_index(np.argmax(ranked * towards_centre), pressure.shape)
    periods = _periods(ship)
    load = None
    if np.isfinite(pressure).any():
        shape = (line or DesignLine()).with_peak(float(np.nanmax(pressure)))
        load = design_load(
            deck, design.hull.length, design.wet_deck.width / 2, shape, reduction=reduction, area=area
        )
    return CrossStructure(
        name=design.name,
        motion=motion,
        slams=slams,
        worst={"x": int(row), "y": int(column)},
        timing=slam_timing(motion, float(lever[row, 0]), float(deck.height[row, column]), periods),
        load=load,
        bulkhead_pressure=float(front_bulkhead_pressure(ship.speed, motion.wave.celerity, design.density)),
        natural_periods=periods,
    )


def _periods(ship: Response) -> dict[str, float]:
    """Natural periods, or none where the frequencies do not reach them."""
    stiffness = stiffness_matrix(ship.design.hull, ship.design.masses, ship.design.density)
    try:
        return natural_periods(ship.hydrodynamics, ship.design.masses, stiffness)
    except InputError:
        return {}
