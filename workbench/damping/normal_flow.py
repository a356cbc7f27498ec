"""Flow through small pieces of surface that move with the ship, and what forces along their normals do to it.

A piece at r with the unit normal n moves through the water, along n, with::

    q = (-i omega_e g + U h) . xi - n . v        g = (n, r x n),  h = (0, 0, 0, 0, n_z, -n_y)

per wave amplitude: g is the velocity of unit motions, U h the angle that the
stream U makes with a piece turned by pitch or yaw, v the velocity of the
undisturbed wave. A force -s q n on the piece adds s g (-i omega_e g + U h) to
the matrix of the equation of motion and s (n . v) g to the exciting force, and
vanishes where the ship goes with the water.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES
from workbench.hydrodynamics.incident_wave import incident_normal_velocity

MATRIX = ("influenced_dof", "radiating_dof")
FORCE = ("omega", "wave_direction", "influenced_dof")


def velocity_rows(points: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Normal velocity of pieces (n, 3) for unit velocities of the ship about the origin, (n, 6)."""
    return np.concatenate([normals, np.cross(points, normals)], axis=1)


def turning_rows(normals: np.ndarray) -> np.ndarray:
    """Normal part of a stream of unit speed from ahead, for unit motions of the ship, (n, 6)."""
    rows = np.zeros((len(normals), 6))
    rows[:, 4], rows[:, 5] = normals[:, 2], -normals[:, 1]
    return rows


def wave_velocity(points: np.ndarray, normals: np.ndarray, omega, wave_directions) -> np.ndarray:
    """Normal velocity of the undisturbed water per wave amplitude, (omega, wave_direction, n) [1/s]."""
    return np.stack(
        [incident_normal_velocity(points, normals, float(one), wave_directions) for one in np.asarray(omega)]
    )


def force_set(
    omega, wave_directions, *, excitation_force=None, method: str, warnings=(), attrs=None, **matrices
) -> xr.Dataset:
    """Contributions to the equation of motion as a Dataset that `motions.motions` takes.

    Parameters
    ----------
    excitation_force : (omega, wave_direction, 6) per wave amplitude, or None.
    matrices : ``added_mass``, ``damping``, ``stiffness``: (6, 6), or (omega, wave_direction, 6, 6).
    """
    coords = {"omega": omega, "wave_direction": wave_directions, **{name: list(MODES) for name in MATRIX}}
    variables = {
        name: ((*FORCE[:2], *MATRIX) if np.ndim(values) == 4 else MATRIX, values)
        for name, values in matrices.items()
    }
    if excitation_force is not None:
        variables["excitation_force"] = (FORCE, excitation_force)
    return quantities.dataset(coords, method=method, warnings=warnings, attrs=attrs, **variables)
