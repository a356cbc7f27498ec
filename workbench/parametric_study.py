"""Slamming of variants of a design in the same seas: motions once for each hull, decks as many as wanted.

After [Grande2002]_ 8: a hull variant needs its motions anew, a deck that is moved or raised does not.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench import pipeline, quantities, sea_energy
from workbench.design import Design
from workbench.errors import InputError
from workbench.hydrodynamics.recommended import TheorySettings
from workbench.seas import Condition
from workbench.variants import same_motions


def slamming_of_variants(
    designs: Sequence[Design],
    conditions: Sequence[Condition],
    settings: TheorySettings | None = None,
    *,
    threshold: str | float = 0.0,
) -> xr.Dataset:
    """Slams per hour of variants at the most exposed point of each deck, in each condition, in closed form.

    Parameters
    ----------
    designs : variants, each with a wet deck; the first one is the base.
    conditions : speeds, headings and seas.
    settings : of the theory; None takes the recommended one.
    threshold : least entry velocity [m/s], or "ochi".

    Returns
    -------
    Dataset over (variant, condition): ``slams_per_hour``, ``mean_entry_velocity`` and the place ``worst_x``
    at the point of each deck that slams most; ``change_of_slams`` against the base [-] (not a number where
    the base never slams). The names of the designs are in the attributes.

    Notes
    -----
    The hydrodynamics are computed once for all variants that move alike (`variants.same_motions`) and for
    all conditions of one speed.
    """
    if not designs or any(design.wet_deck is None for design in designs):
        raise InputError(
            f"variants must be designs with a wet deck, got {len(designs)} designs; give at least one."
        )
    if not conditions:
        raise InputError("conditions must be at least one, got none; give speed, heading and sea.")
    ships: dict[tuple[Design, float], pipeline.Response] = {}
    shape = (len(designs), len(conditions))
    rate, velocity, place = np.zeros(shape), np.zeros(shape), np.zeros(shape)
    notes: list[str] = []
    for row, design in enumerate(designs):
        for column, condition in enumerate(conditions):
            key = same_motions(design), condition.speed
            if key not in ships:
                ships[key] = _ship(key[0], condition.speed, conditions, settings)
            slam = _slamming(ships[key], design, condition, threshold)
            worst = slam.statistics.isel(slam.worst_point)
            rate[row, column] = float(worst.slams_per_hour)
            velocity[row, column] = float(worst.mean_entry_velocity)
            place[row, column] = float(worst.x)
            notes += quantities.warnings_of(slam.statistics)
    with np.errstate(divide="ignore", invalid="ignore"):
        change = np.where(rate[:1] > 0, rate / rate[:1] - 1.0, np.nan)
    dims = ("variant", "condition")
    return quantities.dataset(
        {"variant": np.arange(shape[0]), "condition": np.arange(shape[1])},
        method=next(iter(ships.values())).motions.attrs["method"],
        warnings=list(dict.fromkeys(notes)),
        attrs={"designs": [design.name for design in designs]},
        slams_per_hour=(dims, rate),
        mean_entry_velocity=(dims, velocity),
        worst_x=(dims, place),
        change_of_slams=(dims, change),
    )


def _ship(
    design: Design, speed: float, conditions: Sequence[Condition], settings: TheorySettings | None
) -> pipeline.Response:
    """Return the response for all headings of the conditions at this speed."""
    headings = {
        float(direction)
        for condition in conditions
        if condition.speed == speed
        for direction in np.atleast_1d(sea_energy.directions_for(condition))
    }
    return pipeline.response(design, speed, sorted(headings), None, settings)


def _slamming(
    ship: pipeline.Response, design: Design, condition: Condition, threshold: str | float
) -> pipeline.Slamming:
    relative = pipeline.deck_response(ship, design.wet_deck)
    return pipeline.slamming(ship, relative, design.wet_deck, condition, threshold=threshold)
