"""Axes, phases, headings and signs used everywhere, the constants, and the ways in from other conventions.

Axes
    x forward, y to port, z up; origin in the still-water plane, on the
    centreline, amidships (half way between the perpendiculars). The frame
    advances with the ship at the speed U along x.
Modes
    surge, sway, heave, roll, pitch, yaw: displacements along and right-handed
    rotations about x, y, z. Pitch is therefore positive bow **down**.
Wave direction
    beta [rad] is where the waves go, from +x towards +y: 0 following, pi head
    sea. ``heading_degrees`` at the edge is the same number in degrees: 180 is
    head seas.
Phasors
    ``Re[X exp(-i omega_e t)]`` per metre of wave *amplitude*, for a wave with a
    crest at the origin at t = 0: elevation
    ``Re[exp(i k (x cos(beta) + y sin(beta)) - i omega_e t)]``.
    The *lead* of a response over the wave is minus the angle of its phasor.
Encounter frequency
    ``omega_e = omega - k U cos(beta)``, **signed**: negative when the ship
    overtakes the waves.
Relative motion
    rise of the water towards the deck, at a point moving with the ship;
    relative velocity is its time derivative.

Three other axis systems occur in the sources [Grande2002]_: x forward with
heading 180 degrees for head seas (as here); x aft, y to starboard, heading 0
for head seas (its slam identification and its high-speed theory). The
conversion is in `from_aft_axes`.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

import numpy as np

GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s2]."""

SEAWATER_DENSITY = 1025.0
"""Density of sea water [kg/m3]."""

FRESHWATER_DENSITY = 1000.0
"""Density of fresh water [kg/m3]."""

KNOT = 1852.0 / 3600.0
"""One knot [m/s]."""

MODES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
"""The six rigid-body modes, in the order of every matrix and vector."""

TRANSLATIONS = MODES[:3]
ROTATIONS = MODES[3:]

_SIGN_IN_AFT_AXES = np.array([-1.0, -1.0, 1.0, -1.0, -1.0, 1.0])


def wavenumber(omega):
    """Wavenumber in deep water, omega**2/g [rad/m]; omega [rad/s] scalar or array."""
    return omega**2 / GRAVITY


def encounter_frequency(omega, speed, wave_direction):
    """Signed encounter frequency, omega - k U cos(beta) [rad/s], in deep water.

    Parameters broadcast: omega [rad/s], speed [m/s], wave_direction [rad].
    """
    return omega - wavenumber(omega) * speed * np.cos(wave_direction)


def froude_number(speed: float, length: float) -> float:
    """Froude number U/sqrt(g L) [-]."""
    return speed / np.sqrt(GRAVITY * length)


def from_aft_axes(motions):
    """Six motions given with x aft, y to starboard, z up, in the axes of this module.

    Last axis: the six modes. Surge, sway, roll and pitch change sign, heave and
    yaw do not; the same function converts back ([Grande2002]_ 2.2 and 4.2).
    """
    return np.asarray(motions) * _SIGN_IN_AFT_AXES


def wave_direction_from_head_zero(angle):
    """Wave direction [rad] of this module from one counted with 0 for head seas, and back."""
    return np.pi - angle
