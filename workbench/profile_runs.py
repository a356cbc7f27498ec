"""Exceedance of slam pressure in every condition of an operating profile, motions once for each speed."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from workbench import pipeline, sea_energy
from workbench.design import Design
from workbench.hydrodynamics.recommended import TheorySettings
from workbench.impact.pressure import PressureLaw
from workbench.slamming.operating_profile import OperatingProfile
from workbench.slamming.pressure_statistics import joint_exceedance


def exceedance_of_profile(
    design: Design,
    profile: OperatingProfile,
    levels: np.ndarray,
    law: PressureLaw,
    settings: TheorySettings | None = None,
    *,
    threshold: float = 0.0,
    points: tuple[int, int] = pipeline.DECK_POINTS,
    progress: Callable[[float, str], None] = pipeline.silent,
) -> list[xr.Dataset]:
    """Exceedance curve of each condition of an operating profile, for `operating_profile.profile_exceedance`.

    Parameters
    ----------
    design : with a wet deck; profile : conditions; levels : pressures, growing [Pa]; law : of the pressure.
    settings : of the theory, None takes the recommended ones; threshold : least entry velocity [m/s].
    points : of the deck; few of them keep long profiles in memory; progress : called with fraction and sentence.

    Notes
    -----
    Motions are computed once for each speed. Costs then about 0.1 s a condition with few points, 0.3 s with 400.
    """
    curves: dict[int, xr.Dataset] = {}
    for number, speed in enumerate(profile.speeds):
        progress(number / len(profile.speeds), f"Motions at {speed:.1f} m/s")
        chosen = [index for index, condition in enumerate(profile.conditions) if condition.speed == speed]
        headings = {
            float(direction)
            for index in chosen
            for direction in np.atleast_1d(sea_energy.directions_for(profile.conditions[index]))
        }
        ship = pipeline.response(design, speed, sorted(headings), None, settings)
        relative = pipeline.deck_response(ship, design.wet_deck, points)
        for index in chosen:
            slam = pipeline.slamming(
                ship, relative, design.wet_deck, profile.conditions[index], threshold=threshold, law=law
            )
            curves[index] = joint_exceedance(
                slam.moments, slam.statistics, slam.deck, levels, law, design.density
            )
    progress(1.0, "All conditions done")
    return [curves[index] for index in range(len(profile.conditions))]
