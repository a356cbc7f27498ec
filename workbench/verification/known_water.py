"""Water that meets a flat deck in ways whose impulse and force are known in closed form."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import xarray as xr

from workbench.conventions import GRAVITY
from workbench.design import WetDeck
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.deck_pressure import history
from workbench.wet_deck_pressure.settings import ATMOSPHERE, DeckPressureSettings
from workbench.wet_deck_pressure.strips import deck_strips

DENSITY, CLEARANCE = 1000.0, 3.0
Field = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


class Water(NamedTuple):
    """Rise above the deck [m], closing velocity [m/s] and acceleration [m/s2] as functions of (t, x, y)."""

    rise: Field
    velocity: Field
    acceleration: Field


def crest(curvature: float, velocity: float, celerity: float, speed: float, start: float) -> Water:
    """Crest of constant curvature that rises at a velocity and runs aft at a celerity past an advancing ship."""
    met = celerity + speed
    return Water(
        lambda t, x, y: velocity * (t - start) - curvature * (x + met * (t - start)) ** 2 / 2 + 0 * y,
        lambda t, x, y: velocity - curvature * celerity * (x + met * (t - start)) + 0 * y,
        lambda t, x, y: -curvature * celerity**2 + 0 * (t + x + y),
    )


def slope(gradient: float, velocity: float, start: float, end: float = 0.0) -> Water:
    """Water that slopes down aft of x = ``end`` and rises at a velocity; level with no gradient."""
    return Water(
        lambda t, x, y: velocity * (t - start) - gradient * (end - x) + 0 * y,
        lambda t, x, y: velocity + 0 * (t + x + y),
        lambda t, x, y: 0 * (t + x + y),
    )


def impact(
    water: Water,
    wet_deck: WetDeck,
    *,
    points: tuple[int, int] = (40, 2),
    speed: float = 0.0,
    step: float = 0.005,
    until: float,
) -> xr.Dataset:
    """Force on a deck without its buoyancy, step by step, in ``deck_force`` [N], from t = 0 on.

    Parameters
    ----------
    water : at the level of the deck's clearance; wet_deck : the deck; points : its panels.
    speed : of the ship [m/s]; step : [s]; until : end [s].
    """
    grid = wet_deck_grid(wet_deck, *points)
    sample = 0.02
    times = (np.arange(int(np.ceil(until / sample)) + 4) * sample)[:, None, None]
    x, y = grid.x.values[None, :, None], grid.y.values[None, None, :]
    shape = len(times), x.size, y.size
    rise, velocity, acceleration = (
        np.broadcast_to(field(times, x, y), shape).astype(float) for field in water
    )
    motion = DeckMotion(
        grid.x.values, grid.y.values, sample, rise + wet_deck.clearance, velocity, acceleration, speed
    )
    strips = deck_strips(wet_deck, grid)
    settings = DeckPressureSettings(suction=ATMOSPHERE, time_step=step)
    found = history(motion, strips, DENSITY, settings, 0.0, until)
    actual = found.attrs["time_step"]
    ends = np.append(found.time.values - actual / 2, found.time.values[-1] + actual / 2)
    depth = np.maximum(strips.by_strip(motion.at(ends)[0]) - strips.mean, 0.0)
    weight = DENSITY * GRAVITY * strips.panel_area * depth.sum(axis=(1, 2))
    found["deck_force"] = found.deck_force - (weight[1:] + weight[:-1]) / 2
    return found


def impulse(found: xr.Dataset) -> float:
    """Impulse of the force [N s]."""
    return float(found.deck_force.sum()) * found.attrs["time_step"]
