"""Whether a slam is slow enough to be a steady load: natural period of the plate, and response to a pulse.

.. [Biggs1964] J. M. Biggs, "Introduction to structural dynamics", McGraw-Hill, 1964.
"""

import numpy as np

from workbench.conventions import SEAWATER_DENSITY
from workbench.errors import checked_number
from workbench.impact.quasi_static import Material, checked_plate

STRIP_ADDED_MASS = 0.1616030 / 0.39648
"""Added mass of the first clamped mode over rho times width: water on one side of a long strip [-]."""

CLAMPED_FREQUENCY = 22.3733
"""Square of the first eigenvalue of a clamped beam [-]."""

LARGEST_DEPARTURE = 0.1
"""Departure of the dynamic factor from 1 up to which a load counts as quasi-static [-]."""


def strip_natural_period(
    width: float, thickness: float, material: Material | None = None, water_density: float = SEAWATER_DENSITY
) -> float:
    """Natural period of a long clamped plate with water on one side; without with ``water_density`` 0 [s]."""
    material = material or Material()
    checked_plate(width, thickness)
    mass = material.density * thickness + STRIP_ADDED_MASS * water_density * width
    omega = CLAMPED_FREQUENCY / width**2 * np.sqrt(material.plate_rigidity(thickness) / mass)
    return float(2 * np.pi / omega)


def dynamic_factor(duration: float, natural_period: float) -> float:
    """Largest response to a half-sine pulse over its static response [-] ([Biggs1964]_).

    Parameters
    ----------
    duration : of the pulse; natural_period : of the member [s].

    Notes
    -----
    Undamped, one degree of freedom. Tends to 1 for long pulses: 1.1 needs about five
    natural periods; largest 1.77 at 0.8; below a half natural period it falls with the duration.
    """
    ratio = checked_number("duration of the pulse", duration, "s", above=0) / checked_number(
        "natural period", natural_period, "s", above=0
    )
    if abs(ratio - 0.5) < 1e-4:
        return np.pi / 2
    time = np.linspace(0, 1, 4001)
    lag = 1 / (2 * ratio)
    during = (np.sin(np.pi * time) - lag * np.sin(2 * np.pi * ratio * time)) / (1 - lag**2)
    after = abs(2 * lag / (1 - lag**2) * np.cos(np.pi * ratio))
    return float(max(np.abs(during).max(), after))


def quasi_static_notes(
    duration: float, natural_period: float, stress: float = 0.0, material: Material | None = None
) -> tuple[str, ...]:
    """Sentences on the limits of a quasi-static load: a pulse too short, a stress beyond the yield.

    Parameters
    ----------
    duration : of the pulse; natural_period : of the member [s].
    stress : that the steady load makes [Pa], of which material.
    """
    material = material or Material()
    factor = dynamic_factor(duration, natural_period)
    notes = [
        "Local loads only, small elastic deflections, quasi-static; fatigue and permanent set are not in it."
    ]
    if abs(factor - 1) > LARGEST_DEPARTURE:
        notes.append(
            f"The pulse of {1e3 * duration:.3g} ms is short against the natural period of {1e3 * natural_period:.3g} "
            f"ms: the response is {factor:.2f} times the static one."
        )
    if stress > material.yield_stress:
        notes.append(
            f"The stress of {stress / 1e6:.0f} MPa exceeds the yield of {material.yield_stress / 1e6:.0f} MPa: the "
            "member is bent for good, and the elastic formulas no longer hold."
        )
    return tuple(notes)
