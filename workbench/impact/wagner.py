"""Wagner's wedge: peak pressure of a wedge entering calm water at constant velocity.

.. [Wagner1932] H. Wagner, "Ueber Stoss- und Gleitvorgaenge an der Oberflaeche von
    Fluessigkeiten", ZAMM 12(4), 193-215, 1932.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, eq. 6.8-6.10 and chapter 7.
"""

import numpy as np

AIR_CUSHION_ANGLE = np.radians(3.0)
"""Below this angle air is trapped and the theory, which tends to infinity, does not hold [rad]."""

PANEL_COEFFICIENTS = {
    "austal-63 wet deck": 113.7,
    "crowther-318 pod": 2.71,
    "crowther-318 main beam": 40.8,
}
"""Area-averaged k of three panels by a two-dimensional non-linear water-entry program ([Grande2002]_ 7.1-7.2)."""


def impact_coefficient(deadrise_angle, least_angle: float = AIR_CUSHION_ANGLE) -> np.ndarray:
    """Peak pressure over rho V**2/2, k = (pi**2/4) cot(beta)**2 [-] ([Grande2002]_ 6.10).

    Parameters
    ----------
    deadrise_angle : angle between body and water [rad]; the modulus counts.
    least_angle : smaller angles are taken as this one [rad].

    Notes
    -----
    Valid for small deadrise above about 3 degrees. The exact maximum of
    [Wagner1932]_'s outer and inner solution adds 1; the source drops it.
    """
    angle = np.clip(np.abs(np.asarray(deadrise_angle, float)), least_angle, np.pi / 2)
    return (np.pi / 2 / np.tan(angle)) ** 2


def impact_pressure(velocity, coefficient, density):
    """Peak pressure rho k V**2/2 [Pa] ([Grande2002]_ 6.9)."""
    return density * coefficient * np.square(velocity) / 2
