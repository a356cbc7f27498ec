"""Water against the deck in time: rise, closing velocity and acceleration, from a spectrum or from records."""

from dataclasses import dataclass

import numpy as np

from workbench.errors import InputError, checked_choice, checked_number
from workbench.time_domain import record_blocks
from workbench.wet_deck_pressure.strip_profiles import slope_operator

FRAMES = ("material", "time-derivative")
"""Velocity that the impact is computed from: against the water particle, or that of the closing gap."""


@dataclass(frozen=True, eq=False)
class DeckMotion:
    """Water against the base plane of the deck at its grid points, evenly sampled.

    Parameters
    ----------
    x, y : of the grid [m].
    time_step : [s]; start : time of the first sample [s].
    rise, velocity, acceleration : (time, x, y) of the water towards the deck [m], [m/s], [m/s2].
    speed : of the ship through the water that velocity and acceleration allow for [m/s], 0 for the gap's own.
    """

    x: np.ndarray
    y: np.ndarray
    time_step: float
    rise: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    speed: float = 0.0
    start: float = 0.0

    @property
    def duration(self) -> float:
        """Length of the record [s]."""
        return self.time_step * (len(self.rise) - 1)

    def at(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rise, velocity and acceleration (t, x, y) at times within the record, by cubics through four samples."""
        place = (np.asarray(times) - self.start) / self.time_step
        index = np.clip(np.floor(place).astype(int), 1, len(self.rise) - 3)
        s = (place - index)[:, None, None]
        weights = (
            -s * (s - 1) * (s - 2) / 6,
            (s + 1) * (s - 1) * (s - 2) / 2,
            -(s + 1) * s * (s - 2) / 2,
            (s + 1) * s * (s - 1) / 6,
        )
        return tuple(
            sum(weight * field[index + step] for step, weight in zip((-1, 0, 1, 2), weights, strict=True))
            for field in (self.rise, self.velocity, self.acceleration)
        )


def motion_of_amplitudes(
    relative_amplitudes: np.ndarray,
    slope_amplitudes: np.ndarray,
    frequency: np.ndarray,
    x: np.ndarray,
    y: np.ndarray,
    *,
    duration: float,
    time_step: float,
    speed: float = 0.0,
    frame: str = "material",
    start: float = 0.0,
) -> DeckMotion:
    """Deck motion of a realisation from the complex amplitudes of its components.

    Parameters
    ----------
    relative_amplitudes, slope_amplitudes : (component, x, y) of relative motion [m] and of its slope along
        the ship [-].
    frequency : encounter frequencies of the components [rad/s].
    x, y : of the grid [m].
    duration, time_step, start : [s].
    speed : of the ship [m/s].
    frame : "material" takes what a two-dimensional theory needs, the velocity against the water particle D r
        with D = d/dt - U d/dx; "time-derivative" that of the gap at the moving point.

    Notes
    -----
    One hour at 20 Hz on 400 points takes about 1 s and 0.35 GB.
    """
    checked_choice("frame", frame, FRAMES)
    u = speed if frame == "material" else 0.0
    omega = frequency[:, None, None]
    velocity = -1j * omega * relative_amplitudes - u * slope_amplitudes
    along = -1j * omega * slope_amplitudes
    if u:
        along = along - u * np.einsum("ij,cjy->ciy", slope_operator(x), slope_amplitudes)
    acceleration = -1j * omega * velocity - u * along
    together = np.stack([relative_amplitudes, velocity, acceleration], axis=1)
    together = together * np.exp(-1j * frequency * start)[:, None, None, None]
    shape = together.shape[1:]
    parts = [
        block.T
        for _, block in record_blocks(together.reshape(len(frequency), -1), frequency, duration, time_step)
    ]
    series = np.concatenate(parts).reshape(-1, *shape)
    return DeckMotion(x, y, time_step, series[:, 0], series[:, 1], series[:, 2], float(u), start)


def motion_of_records(
    rise: np.ndarray,
    x: np.ndarray,
    y: np.ndarray,
    time_step: float,
    *,
    speed: float = 0.0,
    frame: str = "material",
) -> DeckMotion:
    """Deck motion from records of relative motion (time, x, y) [m], of a simulation or a model test.

    Parameters
    ----------
    rise : of the water towards the deck at its grid points; at least 8 samples.
    x, y : of the grid [m]; time_step : [s]; speed, frame : as for `motion_of_amplitudes`.

    Notes
    -----
    Derivatives in time by central differences of the fourth order, along the ship by a cubic spline.
    """
    checked_choice("frame", frame, FRAMES)
    checked_number("time_step", time_step, "s", above=0)
    rise = np.asarray(rise, float)
    if rise.ndim != 3 or rise.shape[0] < 8 or rise.shape[1:] != (len(x), len(y)):
        raise InputError(
            f"The record of relative motion must be (time, x, y) with at least 8 times on {len(x)} x {len(y)} points, "
            f"got {' x '.join(map(str, rise.shape))}."
        )
    if not np.all(np.isfinite(rise)):
        raise InputError(
            "The record of relative motion has gaps or values that are no numbers; fill or cut them first."
        )
    u = speed if frame == "material" else 0.0
    along = slope_operator(x)

    def following_the_water(values: np.ndarray) -> np.ndarray:
        rate = _time_derivative(values, time_step)
        return rate - u * np.einsum("ij,tjy->tiy", along, values) if u else rate

    velocity = following_the_water(rise)
    return DeckMotion(x, y, time_step, rise, velocity, following_the_water(velocity), float(u))


def _time_derivative(values: np.ndarray, step: float) -> np.ndarray:
    inside = (values[:-4] - 8 * values[1:-3] + 8 * values[3:-1] - values[4:]) / (12 * step)
    low = np.gradient(values[:5], step, axis=0, edge_order=2)[:2]
    high = np.gradient(values[-5:], step, axis=0, edge_order=2)[-2:]
    return np.concatenate([low, inside, high])
