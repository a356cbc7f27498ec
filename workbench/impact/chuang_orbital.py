"""Chuang's Method II: the velocity of the water particles in place of that of the wave surface.

Convention that makes the printed equations agree with one another: distance y is
counted **aft**, with the wave in a head sea; the phase k (y - V_w t) is 0 where the
slope is largest; the surface is then -h sin(phase) high, and its particles move up
with V_0 cos(phase) and forward with V_0 sin(phase). Other signs as in
`workbench.impact.chuang`.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, eqs 8-9.
"""

from typing import NamedTuple

import numpy as np

from workbench.impact import chuang
from workbench.impact.regular_wave import RegularWave


class Orbit(NamedTuple):
    """Slope of the surface [rad]; velocity of the water normal to it, upward, and along it, forward [m/s]."""

    slope: np.ndarray
    normal_velocity: np.ndarray
    tangential_velocity: np.ndarray


def orbit(wave: RegularWave, phase) -> Orbit:
    """Water particles at the surface of a regular wave ([Chuang1975]_ eq. 8); phase : k (y - V_w t) [rad]."""
    phase = np.asarray(phase, float)
    slope = wave.largest_slope * np.cos(phase)
    return Orbit(
        slope,
        wave.orbital_velocity * np.cos(phase + slope),
        wave.orbital_velocity * np.sin(phase + slope),
    )


def method_two(
    wave: RegularWave,
    phase,
    heave_velocity,
    pitch_velocity,
    pitch,
    density,
    small_angle_law: str = "program",
    trim=0.0,
) -> chuang.Prediction:
    """Peak pressure by orbital velocities ([Chuang1975]_ eqs 8-9, Method II).

    Parameters
    ----------
    wave : with the speed of the ship.
    phase : of the wave at the impact point, k (y - V_w t), 0 at the largest slope [rad].
    heave_velocity, pitch_velocity, pitch, density, trim : as for `chuang.method_one`.

    Notes
    -----
    Regular head waves only. The source gives no table for it ("reasonably good" in a
    few cases, further study needed). It is not Method I in other words: see
    `closing_difference`.
    """
    water = orbit(wave, phase)
    attitude = np.asarray(pitch, float) + trim
    velocity = heave_velocity * np.cos(attitude) + wave.speed * np.sin(attitude) + pitch_velocity
    normal, tangential, angle = chuang.on_wave_surface(velocity, attitude, water.slope)
    return chuang.predicted(
        normal + water.normal_velocity,
        tangential - water.tangential_velocity,
        angle,
        density,
        small_angle_law,
    )


def closing_difference(speed, wave_slope, pitch):
    """Normal velocity of Method I less that of Method II to first order in the angles, V_h (slope - pitch) [m/s].

    Notes
    -----
    Method I lets the surface come in at (V_h + V_w) slope, Method II the ship at
    V_h pitch and the water at V_w slope. A bow-down ship on a rising wave meets the
    water faster by Method I, by the speed times the impact angle.
    """
    return speed * (np.asarray(wave_slope) - pitch)
