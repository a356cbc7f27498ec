"""How a section moves: constant velocity, or a velocity against time that may turn upwards again."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from workbench.errors import InputError, checked_number


@dataclass(frozen=True)
class VelocityHistory:
    """Downward velocity of a section against time, from first contact at time 0.

    Parameters
    ----------
    times : from 0, growing [s]; velocities : downwards [m/s], the first above 0; later ones may turn
        upwards, below 0, while the section is in the water. Between them a cubic spline, so that
        there is an acceleration.
    """

    times: tuple[float, ...]
    velocities: tuple[float, ...]

    def __post_init__(self):
        if len(self.times) != len(self.velocities) or len(self.times) < 2:
            raise InputError(
                f"The velocity history needs as many velocities as times, at least 2, got {len(self.velocities)} and "
                f"{len(self.times)}."
            )
        if self.times[0] != 0 or np.any(np.diff(self.times) <= 0):
            raise InputError("The times of the velocity history must grow from 0, the first contact.")
        checked_velocity(self.velocities[0])
        for velocity in self.velocities:
            checked_number("velocity of the history", velocity, "m/s")

    def motion(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return penetration [m], velocity [m/s] and acceleration [m/s2] at times [s]."""
        if times[-1] > self.times[-1]:
            raise InputError(
                f"Time {times[-1]:g} s lies after the end of the velocity history, {self.times[-1]:g} s."
            )
        spline = CubicSpline(self.times, self.velocities)
        return spline.antiderivative()(times), spline(times), spline.derivative()(times)


def checked_velocity(velocity) -> float:
    """Return the velocity of first contact [m/s], or refuse one that is not downward."""
    return checked_number(
        "downward entry velocity", velocity, "m/s", above=0,
        cure="a section that turns and leaves the water is given as a velocity history",
    )  # fmt: skip


def motion_at_times(
    velocity: float | VelocityHistory, times: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return penetration [m], downward velocity [m/s] and acceleration [m/s2] at growing times [s] in the water."""
    if not isinstance(velocity, VelocityHistory):
        constant = checked_velocity(velocity)
        return constant * times, np.full(len(times), constant), np.zeros(len(times))
    penetration, speed, acceleration = velocity.motion(times)
    out = np.flatnonzero(penetration <= 0)
    if out.size:
        raise InputError(
            f"The section has left the water by {times[out[0]]:g} s; ask for times before, or give another history."
        )
    return penetration, speed, acceleration


def motion_function(velocity: float | VelocityHistory) -> Callable[[float], tuple[float, float, float]]:
    """Penetration [m], velocity [m/s] and acceleration [m/s2] as a function of one time [s]."""
    if not isinstance(velocity, VelocityHistory):
        return lambda time: (velocity * time, velocity, 0.0)
    spline = CubicSpline(velocity.times, velocity.velocities)
    penetration, acceleration = spline.antiderivative(), spline.derivative()
    return lambda time: (float(penetration(time)), float(spline(time)), float(acceleration(time)))
