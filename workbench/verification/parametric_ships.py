"""Slams of the variants of the Austal 63 and the Crowther 318, each in the conditions of its parametric study.

The source states neither sea nor heading with its tables. Taken here: for the Austal head seas of 8 s mean
period and 4 m, where it has its worst slamming, and 3 m beside it; for the Crowther 4 s and 2.25 m, the
larger of its two seas with slams, 45 degrees off the bow, at the heel that goes with each speed.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import xarray as xr

from workbench import pipeline
from workbench.appendages import Foil
from workbench.conventions import KNOT
from workbench.design import Design
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hulls.library import design
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.relative_motion import relative_motion
from workbench.sailing import sailing_design, sailing_motions
from workbench.sails import TrueWind
from workbench.sea_energy import wave_energy
from workbench.seas import Condition, SeaState
from workbench.slamming.direct_statistics import direct_statistics
from workbench.slamming.statistics import response_moments
from workbench.variants import deck_moved, deck_raised, lengthened, same_motions, widened
from workbench.verification import published

CHANGES = "grande_2002_parametric_variants"
AUSTAL_KNOTS, CROWTHER_HEEL = (20, 30, 40), {5: 0.0, 10: 2.0, 15: 5.0}
"""Speeds [knots], and of the Crowther the heel at each [degrees]."""
AUSTAL_SEAS = ((4.0, 8.0), (3.0, 8.0))
"""Significant heights and mean periods [m, s]."""
CROWTHER_SEA = (2.25, 4.0)
OFF_HEAD = (0, 15, 30, 45, 60, 75)
"""Headings off head seas [degrees]."""
T_FOIL = Foil(name="forward T-foil", area=6.0, span=18.0**0.5, position=(28.0, 9.3, -3.5), pair=True)
"""One on each bow. That the ship has them is published; size and place are ours, usual for the ship."""
QUARTERING_BOW = (np.radians(135.0),)
CROWTHER_OMEGA = np.linspace(0.5, 6.0, 45)
COARSE = StripSettings(formulation="heave-only", stations=21, panels=20, frequencies=16)
DECK_POINTS = (40, 11)
POD, BEAM = [5], [1, 2, 8, 9]
"""Rows of deck points on the centreline, and beside the pod."""


def variants(base: Design, name: str) -> tuple[Design, ...]:
    """Return the base and the four variants of tables 8.1 and 8.5."""
    rows = {int(row["hull"]): row for row in published.rows(CHANGES) if row["vessel"] == name}
    return (
        base,
        lengthened(base, float(rows[1]["added_length"])),
        widened(base, float(rows[2]["added_beam"])),
        deck_moved(base, float(rows[3]["moved_aft"])),
        deck_raised(base, float(rows[4]["raised"])),
    )


@cache
def _austal() -> tuple[Design, ...]:
    return variants(replace(design("austal-63"), appendages=(T_FOIL,)), "austal-63")


@cache
def _crowther() -> tuple[Design, ...]:
    return variants(design("crowther-318"), "crowther-318")


@cache
def _ship(moving: Design, knots: int, headings: tuple[int, ...]) -> pipeline.Response:
    return pipeline.response(moving, knots * KNOT, np.radians([180.0 - off for off in headings]))


def austal_base() -> Design:
    """Return the stand-in for the Austal 63 with T-foils."""
    return _austal()[0]


def austal_response(knots: int) -> pipeline.Response:
    """Response of the Austal 63, with its own deck or a moved one, for all headings."""
    return _ship(same_motions(austal_base()), knots, OFF_HEAD)


@cache
def austal(
    hull: int, knots: int, height: float = 4.0, period: float = 8.0, off: int = 0
) -> tuple[float, float]:
    """Slams per hour of the most exposed point of the deck, and their mean velocity past the water [m/s]."""
    chosen = _austal()[hull]
    ship = austal_response(knots) if hull in (0, 3, 4) else _ship(same_motions(chosen), knots, (0,))
    condition = Condition(
        speed=knots * KNOT,
        wave_direction=float(np.radians(180.0 - off)),
        sea_state=SeaState.from_mean_period(height, period),
    )
    deck = wet_deck_grid(chosen.wet_deck, *pipeline.DECK_POINTS)
    return _worst(pipeline.deck_response(ship, chosen.wet_deck), deck.height, condition)


def _worst(relative: xr.Dataset, height: xr.DataArray, condition: Condition) -> tuple[float, float]:
    """Return slams per hour and mean velocity of the point that slams most, counted as the source counts."""
    energy = wave_energy(condition, relative.omega, relative.wave_direction)
    found = direct_statistics(response_moments(relative, energy), height)
    row, column = np.unravel_index(int(np.argmax(found.slams_per_hour.values)), found.slams_per_hour.shape)
    worst = found.isel(x=row, y=column)
    return float(worst.slams_per_hour), float(worst.mean_entry_velocity)


@cache
def _sailing(moving: Design, knots: int) -> xr.Dataset:
    return sailing_motions(
        moving, knots * KNOT, CROWTHER_OMEGA, QUARTERING_BOW, heel=-np.radians(CROWTHER_HEEL[knots]),
        wind=TrueWind(speed=8.0), settings=COARSE,
    )  # fmt: skip


@cache
def crowther(place: str, hull: int, knots: int) -> float:
    """Slams per hour of the most exposed point of pod or main beam, heeled with the ship."""
    chosen, heel = _crowther()[hull], -np.radians(CROWTHER_HEEL[knots])
    deck = wet_deck_grid(chosen.wet_deck, *DECK_POINTS)
    sinkage = sailing_design(same_motions(chosen), heel).hull.sinkage
    height = (deck.height - sinkage + deck.y * np.tan(heel)).clip(1e-3)
    relative = relative_motion(_sailing(same_motions(chosen), knots), deck)
    condition = Condition(
        speed=knots * KNOT,
        wave_direction=QUARTERING_BOW[0],
        sea_state=SeaState.from_mean_period(*CROWTHER_SEA),
    )
    across = {"y": POD if place == "pod" else BEAM}
    return _worst(relative.isel(across), height.isel(across), condition)[0]
