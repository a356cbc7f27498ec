"""The true wave from what is measured: a relative-height meter at the bow, or a pressure recorder under water.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 3.2 (methods named, without formulas).
.. [DeanDalrymple1991] R. G. Dean and R. A. Dalrymple, "Water wave mechanics for engineers and
    scientists", 1991, 3.4 and 4.3.
"""

import numpy as np

from workbench.conventions import GRAVITY
from workbench.errors import InputError, checked_choice, checked_number
from workbench.records.integration import HIGH_PASS, displacement, rates

SENSES = ("gap", "rise")

LARGEST_GAIN = 5.0
"""Largest factor from pressure head to elevation; what is faster is noise made large."""


def true_wave(
    relative_height, meter_acceleration, time_step: float, sense: str, cutoff: float = HIGH_PASS
) -> np.ndarray:
    """Wave elevation from a meter carried by the ship, less what is slower than the cut-off (time) [m].

    Parameters
    ----------
    relative_height : reading of the meter [m].
    meter_acceleration : vertical acceleration at the meter [m/s2], upward positive; gravity may be in it.
    time_step : [s].
    sense : "gap", the distance from meter down to water, which grows when the ship
        rises: elevation = displacement - gap; or "rise", the height of the water on the
        ship, which falls: elevation = displacement + rise.
    cutoff : of the high-pass [rad/s].

    Notes
    -----
    The source leaves the sign open ([Grande2002]_ 3.2); a wrong one shows as a wave
    that grows with the ship's resonance. The displacement is the acceleration
    integrated twice; the relative height is high-passed alike. Such meters err by some
    10 % of the wave height. What is slower than the cut-off cannot be known.
    """
    checked_choice("sense", sense, SENSES)
    relative, acceleration = np.asarray(relative_height, float), np.asarray(meter_acceleration, float)
    if relative.shape != acceleration.shape:
        raise InputError(
            f"relative_height and meter_acceleration must have as many samples, "
            f"got {relative.shape} and {acceleration.shape}."
        )
    moved = displacement(acceleration, time_step, cutoff)
    kept = rates(relative, time_step, cutoff, 0)
    return moved - kept if sense == "gap" else moved + kept


def finite_depth_wavenumber(omega, depth: float) -> np.ndarray:
    """Wavenumber with omega^2 = g k tanh(k h) [rad/m].

    Parameters
    ----------
    omega : [rad/s], >= 0, any shape; depth : of the water h [m].

    Notes
    -----
    Newton's method from an explicit start that is within some percent; converges to
    rounding in six steps.
    """
    checked_number("depth", depth, "m", above=0)
    omega = np.asarray(omega, float)
    deep = omega**2 * depth / GRAVITY
    k = deep / np.sqrt(np.tanh(np.maximum(deep, 1e-300)))
    k = np.where(deep > 0, k, 0.0)
    for _ in range(6):
        tanh = np.tanh(k)
        slope = tanh + k * (1 - tanh**2)
        k = k - np.where(slope > 0, (k * tanh - deep) / np.where(slope > 0, slope, 1.0), 0.0)
    return k / depth


def pressure_gain(omega, depth: float, sensor_depth: float) -> np.ndarray:
    """Pressure head under a wave over its elevation, cosh k(h - d)/cosh kh [-] ([DeanDalrymple1991]_ 4.3).

    Parameters
    ----------
    omega : [rad/s]; depth : of the water h; sensor_depth : of the recorder below the surface d [m].
    """
    checked_number("sensor_depth", sensor_depth, "m", at_least=0, at_most=depth)
    k = finite_depth_wavenumber(omega, depth)
    above_bed = depth - sensor_depth
    return np.exp(-k * sensor_depth) * (1 + np.exp(-2 * k * above_bed)) / (1 + np.exp(-2 * k * depth))


def noise_cutoff(depth: float, sensor_depth: float, largest_gain: float = LARGEST_GAIN) -> float:
    """Frequency above which the correction exceeds a factor [rad/s]; infinite for a recorder at the surface."""
    checked_number("largest_gain", largest_gain, above=1)
    if sensor_depth <= 0:
        return np.inf
    low, high = 0.0, 1.0
    while pressure_gain(high, depth, sensor_depth) * largest_gain > 1:
        high *= 2
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (
            (middle, high) if pressure_gain(middle, depth, sensor_depth) * largest_gain > 1 else (low, middle)
        )
    return (low + high) / 2


def elevation_from_pressure(
    pressure, time_step: float, depth: float, sensor_depth: float, density: float,
    largest_gain: float = LARGEST_GAIN,
) -> np.ndarray:  # fmt: skip
    """Wave elevation from the pressure of a submerged recorder (time) [m].

    Parameters
    ----------
    pressure : (time) [Pa], its mean is taken off; time_step : [s].
    depth, sensor_depth : of the water, and of the recorder below the mean surface [m].
    density : of the water [kg/m3]; largest_gain : see `noise_cutoff`.

    Notes
    -----
    Linear waves, recorder at rest. What is faster than the noise cut-off is left out.
    """
    head = np.asarray(pressure, float) / (checked_number("density", density, "kg/m3", above=0) * GRAVITY)
    head = head - head.mean()
    omega = 2 * np.pi * np.fft.rfftfreq(len(head), time_step)
    known = omega <= noise_cutoff(depth, sensor_depth, largest_gain)
    gain = pressure_gain(np.where(known, omega, 0.0), depth, sensor_depth)
    return np.fft.irfft(np.where(known, np.fft.rfft(head) / gain, 0.0), len(head))


def elevation_spectrum_from_pressure(
    omega, pressure_spectrum, depth: float, sensor_depth: float, density: float,
    largest_gain: float = LARGEST_GAIN,
) -> np.ndarray:  # fmt: skip
    """Wave spectrum [m2 s/rad] from a pressure spectrum [Pa2 s/rad]; NaN above the noise cut-off."""
    omega = np.asarray(omega, float)
    known = omega <= noise_cutoff(depth, sensor_depth, largest_gain)
    gain = pressure_gain(np.where(known, omega, 0.0), depth, sensor_depth)
    head = np.asarray(pressure_spectrum, float) / (density * GRAVITY) ** 2
    return np.where(known, head / gain**2, np.nan)
