"""The attitude in which a ship floats when something heels it."""

from dataclasses import replace

import numpy as np
from scipy.optimize import brentq

from workbench.arrangement import Hull
from workbench.errors import InputError, checked_number
from workbench.geometry.sections import sections

STATIONS, POINTS = 61, 61
"""Sections of each hull, and points on each, from which the volume is taken here."""
LARGEST_SURPLUS = 1e-3
"""Share of the mass by which the found displacement may differ [-]."""


def heeled(hull: Hull, mass: float, density: float, heel: float) -> Hull:
    """Hull at a heel [rad], risen or sunk until it displaces the mass [kg]; it keeps its trim.

    Hulls on the high side may come out of the water. What heels the ship, such as the
    wind in its sails, is not asked for: a ship on one hull has no restoring moment in roll,
    which is then to be locked.

    Raises
    ------
    InputError where it would float with its deck edge under water, or not at all.
    """
    checked_number("mass", mass, "kg", above=0.0)
    tilted = replace(hull, heel=heel)

    def surplus(sinkage: float) -> float:
        try:
            parts = sections(replace(tilted, sinkage=sinkage), STATIONS, POINTS)
        except InputError as error:
            return 1.0 if "deck edge" in str(error) else -1.0  # too deep, or out of the water
        return density * sum(np.trapezoid(part.areas, part.x) for part in parts) / mass - 1.0

    draught = hull.shape.draught
    lowest, highest = -0.999 * draught, 0.999 * (hull.shape.depth - draught)
    if surplus(lowest) * surplus(highest) < 0.0:
        found = float(brentq(surplus, lowest, highest, xtol=1e-6 * draught))
        if abs(surplus(found)) < LARGEST_SURPLUS:
            return replace(tilted, sinkage=found)
    raise InputError(
        f"heel must leave the ship afloat with its deck edge dry, got {np.degrees(heel):.3g} degrees for "
        f"{mass:.4g} kg; heel it less, or give the hulls more depth."
    )
