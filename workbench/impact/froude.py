"""Froude scaling of what a model test measures: lengths, speeds, times, pressures, forces.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, pp. 11, 32-33.
"""

from dataclasses import dataclass

import numpy as np

from workbench.errors import checked_number


@dataclass(frozen=True, kw_only=True)
class FroudeScale:
    """From model to ship; `inverse` leads back.

    Parameters
    ----------
    ratio : length of the ship over that of the model [-].
    density_ratio : of the ship's water over the model's [-]; 1 as in [Chuang1975]_, 1.0258 from
        1.94 to 1.99 slug/ft3.

    Notes
    -----
    Air, surface tension and elasticity do not scale by Froude's law.
    """

    ratio: float
    density_ratio: float = 1.0

    def __post_init__(self):
        checked_number("ratio of a Froude scale", self.ratio, above=0)
        checked_number("density ratio of a Froude scale", self.density_ratio, above=0.5, below=2)

    @property
    def inverse(self) -> "FroudeScale":
        """From ship to model."""
        return FroudeScale(ratio=1 / self.ratio, density_ratio=1 / self.density_ratio)

    def length(self, value):
        """Length of the ship, in the unit of the model's."""
        return self.ratio * np.asarray(value, float)

    def speed(self, value):
        """Speed or velocity of the ship."""
        return np.sqrt(self.ratio) * np.asarray(value, float)

    def time(self, value):
        """Time, period or duration of the ship."""
        return np.sqrt(self.ratio) * np.asarray(value, float)

    def acceleration(self, value):
        """Acceleration of the ship, that of the model."""
        return np.asarray(value, float)

    def pressure(self, value):
        """Pressure on the ship."""
        return self.density_ratio * self.ratio * np.asarray(value, float)

    def force(self, value):
        """Force or weight of the ship."""
        return self.density_ratio * self.ratio**3 * np.asarray(value, float)


ASR_21 = FroudeScale(ratio=21.28)
"""Model 5116 of the catamaran ASR-21 in [Chuang1975]_."""
