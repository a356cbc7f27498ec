"""A regular head wave in deep water as a ship meets it: speed, slope and velocity of its surface.

Angles and velocities have the signs of `workbench.impact.chuang`: slope positive
where the surface rises towards the bow, velocity of the surface positive downward.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY
from workbench.errors import checked_number

STEEPEST = 0.4432
"""Wavenumber times amplitude of the steepest deep-water wave (height over length 0.141) [-]."""


def celerity(period):
    """Speed of a deep-water wave from its period, g T/2 pi [m/s]."""
    return GRAVITY * np.asarray(period, float) / (2 * np.pi)


def surface_velocity(slope, closing_speed):
    """Vertical velocity of the surface at a point moving with the ship, downward positive [m/s].

    Parameters
    ----------
    slope : of the surface [rad]; closing_speed : ship speed and celerity together [m/s].

    Notes
    -----
    -(V_h + V_w) tan(slope); not printed in [Chuang1975]_, but obeyed by 79 of the 81 rows of its table 2.
    """
    return -np.asarray(closing_speed) * np.tan(slope)


def surface_slope(velocity, closing_speed):
    """Slope of the surface [rad] from its velocity at a point moving with the ship; inverts `surface_velocity`."""
    return np.arctan(-np.asarray(velocity) / closing_speed)


@dataclass(frozen=True, kw_only=True)
class RegularWave:
    """A regular wave in deep water, met head on.

    Parameters
    ----------
    amplitude : half the wave height [m]; period : [s]; speed : of the ship [m/s].
    """

    amplitude: float
    period: float
    speed: float = 0.0

    def __post_init__(self):
        checked_number("amplitude of the wave", self.amplitude, "m", above=0)
        checked_number("period of the wave", self.period, "s", above=0)
        checked_number("speed", self.speed, "m/s", at_least=0, at_most=60)
        checked_number(
            "largest slope of the wave", self.wavenumber * self.amplitude, at_most=STEEPEST,
            cure="such a wave breaks; lower it or make it longer",
        )  # fmt: skip

    @property
    def celerity(self) -> float:
        """Speed of the wave [m/s]."""
        return float(celerity(self.period))

    @property
    def wavenumber(self) -> float:
        """Wavenumber [rad/m]."""
        return (2 * np.pi / self.period) ** 2 / GRAVITY

    @property
    def wavelength(self) -> float:
        """Wavelength [m]."""
        return 2 * np.pi / self.wavenumber

    @property
    def closing_speed(self) -> float:
        """Speed of the ship and celerity together [m/s]."""
        return self.speed + self.celerity

    @property
    def encounter_frequency(self) -> float:
        """Encounter frequency k (V_w + V_h) [rad/s]."""
        return self.wavenumber * self.closing_speed

    @property
    def largest_slope(self) -> float:
        """Slope of the surface between crest and trough, k h [rad]."""
        return self.wavenumber * self.amplitude

    @property
    def orbital_velocity(self) -> float:
        """Velocity of the water particles at the surface, k h V_w [m/s]."""
        return self.largest_slope * self.celerity
