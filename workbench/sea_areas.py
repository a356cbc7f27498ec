"""Sea areas with their mean seas, and the two-parameter spectrum by its printed constants.

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, eq. 9.2 and table 9.2
    (all-season data of N. Hogben and F. E. Lumb, "Ocean wave statistics", 1967).
"""

from dataclasses import dataclass

import numpy as np

from workbench.errors import checked_choice, checked_number
from workbench.seas import SeaState


@dataclass(frozen=True, kw_only=True)
class SeaArea:
    """A sea area: its number in the source, significant height [m] and mean period T01 [s]."""

    number: int
    name: str
    significant_wave_height: float
    mean_period: float

    def sea_state(self, spectrum: str = "bretschneider", **others) -> SeaState:
        """Mean sea of the area with a spectrum of `workbench.seas.SPECTRA`."""
        return SeaState.from_mean_period(
            self.significant_wave_height, self.mean_period, spectrum=spectrum, **others
        )


SEA_AREAS = (
    SeaArea(number=3, name="Irish Sea", significant_wave_height=2.9, mean_period=5.9),
    SeaArea(number=4, name="North Sea", significant_wave_height=2.8, mean_period=5.2),
)
"""Areas of [Couser1996]_ table 9.2."""


def sea_area(name: str) -> SeaArea:
    """Sea area by its name."""
    checked_choice("sea area", name, [area.name for area in SEA_AREAS])
    return next(area for area in SEA_AREAS if area.name == name)


def two_parameter_spectrum(significant_wave_height: float, mean_period: float, omega) -> np.ndarray:
    """ITTC two-parameter spectrum A omega^-5 exp(-B omega^-4) [m2 s/rad] ([Couser1996]_ 9.2).

    A = 173 H^2/T^4, B = 692/T^4, whence m0 = A/4B = H^2/16 exactly. With the mean period
    T01 it is Bretschneider's spectrum to 0.03 % of the period.
    """
    height = checked_number("significant_wave_height", significant_wave_height, "m", above=0)
    period = checked_number("mean_period", mean_period, "s", above=0)
    first, second = 173 * height**2 / period**4, 692 / period**4
    safe = np.maximum(np.asarray(omega, float), 0.5 / period)  # nothing is left so far below the peak
    return first * safe**-5.0 * np.exp(-second * safe**-4.0)


def modal_frequency(mean_period: float) -> float:
    """Frequency of the peak of `two_parameter_spectrum`, (4 B/5)^(1/4) [rad/s]."""
    return float((0.8 * 692) ** 0.25 / checked_number("mean_period", mean_period, "s", above=0))
