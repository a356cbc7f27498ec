"""Added resistance in waves from motions and their damping: an order of magnitude, no more.

.. [Havelock1937] T. H. Havelock, "The resistance of a ship among waves", Proc. R. Soc. Lond. A 161, 1937.
.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, eqs 6.4-6.6 and 9.1.3.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import GRAVITY
from workbench.errors import InputError, checked_number
from workbench.motions import translation_matrix

ORDER_OF_MAGNITUDE = (
    "Added resistance by Havelock's expression is an order of magnitude: it counts the energy that heave and pitch "
    "radiate, not diffraction, and stands or falls with the damping of the method."
)

_VERTICAL = (2, 4)


def added_resistance(hydrodynamics: xr.Dataset, motion_set: xr.Dataset, form: str = "coupled") -> xr.Dataset:
    """Added resistance per wave amplitude squared in regular waves (omega, wave_direction) [N/m2].

    Parameters
    ----------
    hydrodynamics : coefficients about the origin; motion_set : motions of the same waves.
    form : "coupled" is 6.5, -k/2 sum F_j xi_j sin(phase between them), with whatever the
        forces and motions hold; "damping" is 6.6, omega^2 |omega_e|/2g (B33 xi3^2 + B55 xi5^2),
        repaired: the source prints omega^3 for omega^2 omega_e, right at rest only.

    Notes
    -----
    Forces and damping are taken about the centre of gravity. The two forms agree where
    heave and pitch do not couple; with coupling 6.5 equals the whole quadratic form of
    the damping. Positive adds to the resistance in head seas.
    """
    if form not in ("coupled", "damping"):
        raise InputError(f"form must be coupled or damping, got {form!r}.")
    centre = translation_matrix(motion_set.attrs["centre_of_gravity"])
    back = np.linalg.inv(centre)
    motion = motion_set.motion_rao.values
    k = hydrodynamics.wavenumber.values[:, None]
    if form == "coupled":
        force = hydrodynamics.excitation_force.values @ back
        found = -k / 2 * sum((force[..., j] * np.conj(motion[..., j])).imag for j in _VERTICAL)
    else:
        damping = back.T @ hydrodynamics.radiation_damping.values @ back
        encounter = np.abs(hydrodynamics.encounter_frequency.values)
        found = k * encounter / 2 * sum(damping[..., j, j] * np.abs(motion[..., j]) ** 2 for j in _VERTICAL)
    return quantities.dataset(
        {"omega": hydrodynamics.omega, "wave_direction": hydrodynamics.wave_direction},
        method=hydrodynamics.attrs["method"],
        warnings=(*quantities.warnings_of(hydrodynamics), ORDER_OF_MAGNITUDE),
        attrs={"speed": hydrodynamics.attrs["speed"], "form": form},
        added_resistance=(("omega", "wave_direction"), found),
        encounter_frequency=(("omega", "wave_direction"), hydrodynamics.encounter_frequency.values),
    )


def mean_added_resistance(per_amplitude_squared, spectrum, omega) -> float:
    """Mean added resistance in an irregular sea, 2 int R S d omega [N] (6.4).

    Parameters
    ----------
    per_amplitude_squared : R_AW/zeta^2 [N/m2]; spectrum : [m2 s/rad]; both over ``omega``,
        wave or encounter frequency alike [rad/s].
    """
    omega = np.asarray(omega, float)
    if np.any(np.diff(omega) <= 0):
        raise InputError("omega must increase to integrate the added resistance.")
    return float(2 * np.trapezoid(np.asarray(per_amplitude_squared) * np.asarray(spectrum), omega))


def mean_from_coefficient(
    coefficient, spectrum, omega, density: float, beam: float, length: float
) -> float:  # fmt: skip
    """Mean added resistance from coefficients C_AW, 2 rho g B^2/L int C S d omega [N] (9.1.3)."""
    checked_number("length", length, "m", above=0)
    return density * GRAVITY * beam**2 / length * mean_added_resistance(coefficient, spectrum, omega)
