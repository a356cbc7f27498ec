"""The Dataset of hydrodynamic coefficients and wave forces that every method returns."""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES, encounter_frequency, wavenumber


def coefficient_set(
    omega: np.ndarray,
    wave_directions: np.ndarray,
    speed: float,
    density: float,
    *,
    added_mass: np.ndarray,
    radiation_damping: np.ndarray,
    froude_krylov_force: np.ndarray,
    diffraction_force: np.ndarray,
    solver: str,
    method: str = "potential-flow",
    warnings: Sequence[str] = (),
) -> xr.Dataset:
    """Coefficients and forces as one Dataset with units, whichever way they were found.

    Parameters
    ----------
    added_mass, radiation_damping : (omega, wave_direction, influenced_dof, radiating_dof).
    froude_krylov_force, diffraction_force : (omega, wave_direction, influenced_dof).
    """
    matrix = ("omega", "wave_direction", "influenced_dof", "radiating_dof")
    modes = {name: list(MODES) for name in matrix[2:]}
    return quantities.dataset(
        {"omega": omega, "wave_direction": wave_directions, **modes},
        method=method,
        warnings=warnings,
        attrs={"speed": float(speed), "density": float(density), "solver": solver},
        added_mass=(matrix, added_mass),
        radiation_damping=(matrix, radiation_damping),
        froude_krylov_force=(matrix[:3], froude_krylov_force),
        diffraction_force=(matrix[:3], diffraction_force),
        excitation_force=(matrix[:3], froude_krylov_force + diffraction_force),
        encounter_frequency=(matrix[:2], encounter_frequency(omega[:, None], speed, wave_directions)),
        wavenumber=("omega", wavenumber(omega)),
    )
