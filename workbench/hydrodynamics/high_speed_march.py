"""Sectional potentials of one cross-plane problem: five modes of motion and the diffraction of given waves.

Time factor exp(+i omega_e t) within the high-speed theory, normals into the water. Per unit motion::

    sway  i omega_e n2      heave  i omega_e n3     roll  i omega_e n4
    pitch (-i omega_e x + U) n3                     yaw   (i omega_e x - U) n2

and for diffraction minus the normal velocity of the incident wave in the cross-plane ([Grande2002]_
A1.103, A1.104 in these axes; the repaired forms).

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY, wavenumber
from workbench.hydrodynamics.cross_plane import Water, passage
from workbench.hydrodynamics.high_speed_hulls import Problem, Stations
from workbench.hydrodynamics.marched_contour import Contour
from workbench.hydrodynamics.section_waves import Waves

SWAY, HEAVE, ROLL, PITCH, YAW = range(5)
MODES_OF_PARITY = {1: (HEAVE, PITCH), -1: (SWAY, ROLL, YAW), 0: (SWAY, HEAVE, ROLL, PITCH, YAW)}


@dataclass(frozen=True, eq=False)
class Sectional:
    """Integrals of potential times (n2, n3, n4) along the ship, about the axis of the problem.

    Parameters
    ----------
    radiation : (stations, families, 3, 5, frequencies) per unit motion.
    diffraction : (stations, families, 3, waves), for crests at the origin of the problem.
    radiated_elevation : (stations, points, 5, frequencies); diffracted_elevation : (stations, points, waves).
    """

    radiation: np.ndarray
    diffraction: np.ndarray
    radiated_elevation: np.ndarray
    diffracted_elevation: np.ndarray


def incident_potential(y, z, x: float, waves: Waves) -> np.ndarray:
    """Potential of waves of unit amplitude at points (n,) of the cross-plane at x, (n, waves) [m2/s]."""
    k = wavenumber(waves.omega)
    along = x * np.cos(waves.direction) + y[:, None] * np.sin(waves.direction)
    return 1j * GRAVITY / waves.omega * np.exp(k * z[:, None] - 1j * k * along)


def incident_normal_velocity(points: np.ndarray, normals: np.ndarray, x: float, waves: Waves) -> np.ndarray:
    """Normal velocity in the cross-plane of the same waves (n, waves) [m/s]."""
    across = normals.imag[:, None] - 1j * np.sin(waves.direction) * normals.real[:, None]
    potential = incident_potential(points.real, points.imag, x, waves)
    return wavenumber(waves.omega) * potential * across


def sectional(
    problem: Problem,
    stations: Stations,
    speed: float,
    frequencies: np.ndarray,
    waves: Waves,
    half_width: float,
    spacing: float,
    field_y: np.ndarray,
) -> Sectional:
    """March one problem.

    Parameters
    ----------
    frequencies : encounter frequencies of the motions [rad/s].
    half_width, spacing : of the grid on the water [m].
    field_y : points of the wanted elevation, about the axis of the problem [m].
    """
    count, nodes, met = len(stations.x), len(frequencies), len(waves.omega)
    since_bow = (stations.bow - stations.x) / speed
    radiation = np.zeros((count, problem.families, 3, 5, nodes), complex)
    diffraction = np.zeros((count, problem.families, 3, met), complex)
    radiated = np.zeros((count, len(field_y), 5, nodes), complex)
    diffracted = np.zeros((count, len(field_y), met), complex)
    for parity in problem.parities:
        modes = MODES_OF_PARITY[parity]

        def normal_velocity(station: int, contour: Contour, modes=modes, parity=parity) -> np.ndarray:
            x, time = stations.x[station], since_bow[station]
            motion = _motion(contour, modes, x, speed, frequencies) * np.exp(1j * frequencies * time)
            wave = -_part(parity, contour, x, waves) * np.exp(1j * waves.encounter * time)
            return np.concatenate([motion.reshape(len(contour.starts), -1), wave], axis=1)

        found = passage(
            problem.contours,
            stations.spacing / speed,
            Water(half_width, spacing, parity),
            normal_velocity,
            len(modes) * nodes + met,
            problem.families,
            field_y,
        )
        split = len(modes) * nodes
        back = np.exp(-1j * np.outer(since_bow, frequencies))[:, None, None]
        back_of_waves = np.exp(-1j * np.outer(since_bow, waves.encounter))[:, None]
        potential, rise = found.section_potential, found.elevation
        shape = (count, problem.families, 3, len(modes), nodes)
        radiation[:, :, :, modes] += potential[..., :split].reshape(shape) * back[:, None]
        diffraction += potential[..., split:] * back_of_waves[:, None]
        radiated[:, :, modes] += rise[..., :split].reshape(count, len(field_y), len(modes), nodes) * back
        diffracted += rise[..., split:] * back_of_waves
    return Sectional(radiation, diffraction, radiated, diffracted)


def _motion(
    contour: Contour, modes: tuple[int, ...], x: float, speed: float, frequency: np.ndarray
) -> np.ndarray:
    """Return normal velocities per unit motion (panels, modes, frequencies)."""
    n2, n3 = contour.normals.real, contour.normals.imag
    n4 = contour.centres.real * n3 - contour.centres.imag * n2
    shapes = np.stack([n2, n3, n4, n3, n2], axis=1)
    rate = 1j * frequency
    steady = np.full_like(rate, speed)
    rates = np.stack([rate, rate, rate, -x * rate + steady, x * rate - steady])
    chosen = list(modes)
    return shapes[:, chosen, None] * rates[chosen]


def _part(parity: int, contour: Contour, x: float, waves: Waves) -> np.ndarray:
    """Return the even, odd or whole normal velocity of waves at the panels (panels, waves)."""
    points, normals = contour.centres, contour.normals
    found = incident_normal_velocity(points, normals, x, waves)
    if parity == 0:
        return found
    mirrored = incident_normal_velocity(-np.conj(points), -np.conj(normals), x, waves)
    return (found + parity * mirrored) / 2
