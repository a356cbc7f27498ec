"""The incident wave of unit amplitude: its potential, and the flow it drives through a panel."""

import numpy as np

from workbench.conventions import GRAVITY, wavenumber


def incident_potential(points: np.ndarray, omega: float, wave_direction) -> np.ndarray:
    """Potential of a deep-water wave of unit amplitude with its crest at the origin at t = 0 [m2/s].

    Parameters
    ----------
    points : (n, 3) [m]; omega : [rad/s]; wave_direction : one or several [rad].

    Returns
    -------
    (n,) or (wave_direction, n).
    """
    k = wavenumber(omega)
    beta = np.asarray(wave_direction)[..., None]
    along = points[:, 0] * np.cos(beta) + points[:, 1] * np.sin(beta)
    return -1j * GRAVITY / omega * np.exp(k * points[:, 2] + 1j * k * along)


def incident_normal_velocity(
    centres: np.ndarray, normals: np.ndarray, omega: float, wave_direction
) -> np.ndarray:
    """Normal velocity of the same wave at panel centres [m/s], shaped as `incident_potential`."""
    k = wavenumber(omega)
    beta = np.asarray(wave_direction)[..., None]
    across = 1j * (normals[:, 0] * np.cos(beta) + normals[:, 1] * np.sin(beta)) + normals[:, 2]
    return k * incident_potential(centres, omega, wave_direction) * across


def folded(directions: np.ndarray) -> np.ndarray:
    """Directions of a ship that is alike on both sides, mirrored into 0 to pi [rad]."""
    return np.round(np.abs(np.angle(np.exp(1j * directions))), 12)
