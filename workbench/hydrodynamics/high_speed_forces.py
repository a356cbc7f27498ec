"""From sectional potentials to forces on the ship: hulls alone and together, dry transoms, integrals lengthwise.

With S_j(x) the integral of potential times n_j over a section and the pressure force per
length ``rho (i omega_e - U d/dx) S_j`` (Ogilvie-Tuck, uniform stream), time factor
exp(+i omega_e t) and outward normals::

    F_3 = rho (i omega_e int S_3 dx + U S_3T)
    F_5 = rho (-i omega_e int x S_3 dx - U x_T S_3T - U int S_3 dx)

T marks a dry transom; sway and yaw alike with x and the other sign.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY, wavenumber
from workbench.hydrodynamics.high_speed_hulls import StationedHull, Stations
from workbench.hydrodynamics.high_speed_march import Sectional, Waves, incident_potential
from workbench.hydrodynamics.near_transom import TransomWeights, relaxation_length, transom_weights
from workbench.hydrodynamics.speed_terms import VENTILATION_FROUDE_NUMBER

LEAST_TRANSOM = 0.02
"""Breadth of the last section over the greatest from which a hull counts as ending in a transom [-]."""


@dataclass(frozen=True, eq=False)
class Ends:
    """How the pressure of one family of hulls is integrated lengthwise.

    Parameters
    ----------
    weights : of the cells; stern : number of the last wet station; x : of the transom [m].
    end_share : of the potential there that stays as an end term: 1 at a dry transom whose pressure is
        left alone, else 0.
    """

    weights: TransomWeights
    stern: int
    x: float
    end_share: float


def ends(stations: Stations, hull: StationedHull, speed: float, released: bool) -> Ends:
    """Lengthwise integration of a hull."""
    stern = int(np.flatnonzero(hull.wet)[-1])
    beam = float(hull.beams.max())
    at_end = abs(stations.x[stern] - hull.aft) < 1.5 * stations.spacing
    has_transom = at_end and hull.beams[stern] > LEAST_TRANSOM * beam
    draught = max(hull.last_draught, 1e-9)
    dry = bool(has_transom and speed > VENTILATION_FROUDE_NUMBER * np.sqrt(GRAVITY * draught))
    edges = np.concatenate([[stations.bow], stations.x])
    length = relaxation_length(beam, speed) if dry and released else None
    weights = transom_weights(edges, hull.aft, length)
    return Ends(weights, stern, hull.aft, weights.last if dry else 0.0)


def ship_sectional(
    stations: Stations, alone: dict[int, Sectional], waves: Waves, field_points: int = 0
) -> Sectional:
    """Sectional potentials of all families in ship axes, each hull by itself.

    Parameters
    ----------
    alone : by number of the first hull of each family, with elevations at ``field_points`` points about
        the axis of each hull of the family in turn.
    """
    first = next(iter(alone.values()))
    families = stations.families
    count, _, _, _, nodes = first.radiation.shape
    radiation = np.zeros((count, len(families), 3, 5, nodes), complex)
    diffraction = np.zeros((count, len(families), 3, len(waves.omega)), complex)
    radiated = np.zeros((count, field_points, 5, nodes), complex)
    diffracted = np.zeros((count, field_points, len(waves.omega)), complex)
    k_y = wavenumber(waves.omega) * np.sin(waves.direction)
    for family, numbers in enumerate(families):
        own = alone[numbers[0]]
        for place, number in enumerate(numbers):
            y = stations.hulls[number].y
            moved = own.radiation[:, 0].copy()
            moved[:, :, 2] += y * moved[:, :, 1]
            moved[:, 2] += y * moved[:, 1]
            radiation[:, family] += moved
            forces = own.diffraction[:, 0] * np.exp(-1j * k_y * y)
            forces[:, 2] += y * forces[:, 1]
            diffraction[:, family] += forces
            here = slice(place * field_points, (place + 1) * field_points)
            rise = own.radiated_elevation[:, here].copy()
            rise[:, :, 2] += y * rise[:, :, 1]
            radiated += rise
            diffracted += own.diffracted_elevation[:, here] * np.exp(-1j * k_y * y)
    return Sectional(radiation, diffraction, radiated, diffracted)


def reached(stations: Stations, family: int, encounter: np.ndarray, speed: float) -> np.ndarray:
    """Share (stations, frequencies) of the waves from other hulls that have reached a family, 0 or 1.

    Waves of the encounter frequency leave a hull sideways at the group velocity g/(2 omega_e), so that they
    are met at a distance 2 tau behind the bow of the hull that made them, per distance between centre planes.
    What the two-dimensional march puts ahead of that is the far field of an endless cylinder.
    """
    own = stations.hulls[stations.families[family][0]]
    others = [hull for hull in stations.hulls if hull is not own]
    reach = np.full((len(others), len(encounter)), np.inf)
    for row, other in enumerate(others):
        distance = abs(other.y - own.y)
        reach[row] = stations.bow - other.fore + 2 * speed * np.abs(encounter) / GRAVITY * distance
    behind = (stations.bow - stations.x)[:, None] - reach.min(axis=0)
    return np.clip(behind / stations.spacing + 0.5, 0.0, 1.0)


def joined(
    stations: Stations,
    apart: Sectional,
    together: Sectional,
    speed: float,
    frequencies: np.ndarray,
    waves: Waves,
) -> Sectional:
    """Each hull alone up to where waves of another have reached it, all together behind."""
    radiation, diffraction = apart.radiation.copy(), apart.diffraction.copy()
    for family in range(len(stations.families)):
        share = reached(stations, family, frequencies, speed)[:, None, None]
        radiation[:, family] += share * (together.radiation - apart.radiation)[:, family]
        share = reached(stations, family, waves.encounter, speed)[:, None]
        diffraction[:, family] += share * (together.diffraction - apart.diffraction)[:, family]
    share = reached(stations, 0, frequencies, speed)[:, None, None]
    radiated = apart.radiated_elevation + share * (together.radiated_elevation - apart.radiated_elevation)
    share = reached(stations, 0, waves.encounter, speed)[:, None]
    diffracted = apart.diffracted_elevation + share * (
        together.diffracted_elevation - apart.diffracted_elevation
    )
    return Sectional(radiation, diffraction, radiated, diffracted)


def lengthwise(
    values: np.ndarray, stations: Stations, end: Ends, frequency: np.ndarray, speed: float
) -> np.ndarray:
    """Six forces (6, ..., frequency) per density from sectional potentials (stations, 3, ..., frequency)."""
    before = np.concatenate([np.zeros_like(values[:1]), values[:-1]])
    middle = (before + values) / 2
    edges = np.concatenate([[stations.bow], stations.x])
    x = (edges[1:] + edges[:-1]) / 2
    whole, slope = end.weights.whole, end.weights.slope

    def total(weights):
        return np.tensordot(weights, middle, axes=1)

    rate = 1j * frequency
    direct = rate * total(whole) + speed * total(slope)
    turned = rate * total(x * whole) + speed * total(whole + x * slope)
    last = speed * end.end_share * values[end.stern]
    found = np.zeros((6, *direct.shape[1:]), complex)
    found[1:4] = direct + last
    moment = turned + end.x * last
    found[4], found[5] = -moment[1], moment[0]
    return found


def forces(
    potentials: Sectional,
    stations: Stations,
    family_ends: list[Ends],
    speed: float,
    density: float,
    frequencies: np.ndarray,
    waves: Waves,
) -> tuple[np.ndarray, np.ndarray]:
    """Radiation (frequencies, 6, 6) and diffraction forces (waves, 6) about the origin, time factor exp(+i omega t)."""
    radiation = np.zeros((6, 5, len(frequencies)), complex)
    diffraction = np.zeros((6, len(waves.omega)), complex)
    for family, end in enumerate(family_ends):
        radiation += lengthwise(potentials.radiation[:, family], stations, end, frequencies, speed)
        diffraction += lengthwise(potentials.diffraction[:, family], stations, end, waves.encounter, speed)
    full = np.zeros((len(frequencies), 6, 6), complex)
    full[:, :, 1:] = density * np.moveaxis(radiation, -1, 0)
    return full, density * diffraction.T


def froude_krylov(stations: Stations, family_ends: list[Ends], density: float, waves: Waves) -> np.ndarray:
    """Forces of the undisturbed wave on the wetted hulls, dry transoms left out, (waves, 6), exp(+i omega t)."""
    found = np.zeros((len(waves.omega), 6), complex)
    for numbers, end in zip(stations.families, family_ends, strict=True):
        for number in numbers:
            hull = stations.hulls[number]
            contours = np.where(hull.wet[:, None], hull.contours, 0.0)
            slope = np.gradient(contours, stations.x, axis=0)
            for station in np.flatnonzero(hull.wet):
                line = contours[station]
                centres, step = (line[1:] + line[:-1]) / 2, np.diff(line)
                normal = -1j * step  # times length
                lengthwise = -((slope[station, 1:] + slope[station, :-1]) / 2 * np.conj(normal)).real
                x = stations.x[station]
                cells = end.weights.whole[station] + (
                    end.weights.whole[station + 1] if station + 1 < len(stations.x) else 0.0
                )
                y, z = centres.real, centres.imag
                modes = np.stack(
                    [
                        lengthwise,
                        normal.real,
                        normal.imag,
                        y * normal.imag - z * normal.real,
                        z * lengthwise - x * normal.imag,
                        x * normal.real - y * lengthwise,
                    ]
                )
                pressure = 1j * waves.omega * incident_potential(y, z, x, waves)
                found += (cells / 2) * (modes @ pressure).T
    return density * found


def lost_stiffness(stations: Stations, family_ends: list[Ends], density: float) -> np.ndarray:
    """Hydrostatic stiffness that a released transom takes away, (6, 6) about the origin, negative."""
    found = np.zeros((6, 6))
    cells = np.concatenate([[stations.bow], stations.x])
    x = (cells[1:] + cells[:-1]) / 2
    for numbers, end in zip(stations.families, family_ends, strict=True):
        for number in numbers:
            hull = stations.hulls[number]
            inside = np.clip(cells - hull.aft, 0.0, None)
            lost = np.clip(-np.diff(inside) - end.weights.whole, 0.0, None)
            beams = hull.beams
            beams = (beams + np.concatenate([[0.0], beams[:-1]])) / 2
            area = lost * beams
            levers = np.stack([np.ones_like(x), np.full_like(x, hull.y), -x])
            found[2:5, 2:5] -= np.einsum("c,ic,jc->ij", area, levers, levers)
            found[3, 3] -= float(np.sum(lost * beams**3) / 12)
    return density * GRAVITY * found
