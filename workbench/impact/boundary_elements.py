"""Boundary elements of symmetric two-dimensional potential flow: influence of straight elements, far field, solution.

Potential and normal velocity vary linearly along each element; their integrals are exact. The
boundary is the right half; the left half is its mirror image. Beyond the last
node the free surface is level and the flow that of a vertical dipole.

.. [Zhao1993] R. Zhao, O. M. Faltinsen, "Water entry of two-dimensional bodies", Journal of
    Fluid Mechanics 246, 593-612, 1993.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, eq. 6.1-6.7.
"""

from typing import NamedTuple

import numpy as np
from scipy.linalg import lu_factor, lu_solve


class Layers(NamedTuple):
    """Integrals over the elements of log r (``source``) and its normal derivative (``dipole``), (point, element).

    Each with the weight 1 at the start of the element and 0 at its end (``first``) and the other way round.
    """

    source_first: np.ndarray
    source_second: np.ndarray
    dipole_first: np.ndarray
    dipole_second: np.ndarray


def layers(points: np.ndarray, nodes: np.ndarray) -> Layers:
    """Return the influence of a chain of straight elements on points.

    Parameters
    ----------
    points : complex, y + i z [m]; nodes : complex, (element + 1,) [m]. The normal is to the left of the chain.

    Notes
    -----
    A point that is a node is on the element itself: its dipole is zero there.
    """
    step = np.diff(nodes)
    length = np.abs(step)
    to_node = nodes[None, :] - points[:, None]
    distance = np.abs(to_node)
    logarithm = np.log(np.where(distance > 0, distance, 1.0))
    local = to_node[:, :-1] * (np.conj(step) / length)
    along, off = -local.real, -local.imag
    first, second = -along, length - along
    touches = (distance[:, :-1] == 0) | (distance[:, 1:] == 0)
    off = np.where(touches, 0.0, off)
    angle = np.where(touches, 0.0, np.arctan2(off * length, first * second + off**2))
    gain = logarithm[:, 1:] - logarithm[:, :-1]
    dipole_second = -(off * gain + along * angle) / length
    source = second * logarithm[:, 1:] - first * logarithm[:, :-1] - length + off * angle
    square = distance**2
    weighted = square * (logarithm / 2 - 0.25)
    source_second = (weighted[:, 1:] - weighted[:, :-1] + along * source) / length
    return Layers(source - source_second, source_second, -angle - dipole_second, dipole_second)


def mirrored_layers(nodes: np.ndarray) -> Layers:
    """Return the influence of a chain and its mirror image in y = 0 on the nodes of the chain."""
    count = len(nodes)
    both = layers(np.concatenate([nodes, -np.conj(nodes)]), nodes)
    return Layers(*(part[:count] + part[count:] for part in both))


def far_source(points: np.ndarray, edge: float) -> np.ndarray:
    """Integral of log r/eta**2 over the level surface z = 0 beyond ``edge`` [m] on both sides ([Grande2002]_ 6.7).

    Parameters
    ----------
    points : complex, y + i z [m], not both zero.
    """
    y, z = points.real, points.imag
    size = np.maximum(np.abs(points), 1e-300) ** 2
    total = np.zeros(len(points))
    for side in (y, -y):
        distance = np.hypot(edge - side, z)
        logarithm = np.log(np.where(distance > 0, distance, 1.0))
        total += logarithm / edge - side / size * (logarithm - np.log(edge))
        total += np.abs(z) / size * (np.pi / 2 - np.arctan2(edge - side, np.abs(z)))
    return total


def far_dipole(points: np.ndarray, edge: float) -> np.ndarray:
    """Integral of the normal derivative of log r over the level surface z = 0 beyond ``edge`` [m] on both sides."""
    y, z = points.real, np.abs(points.imag)
    angle = sum(np.pi / 2 - np.arctan2(edge - side, z) for side in (y, -y))
    return np.where(z == 0, 0.0, -np.sign(points.imag) * angle)


class Boundary:
    """Boundary of the right half of the water, and its solved matrix.

    Parameters
    ----------
    nodes : complex, y + i z [m], from the lowest point of the body along it, across the jet, along the free
        surface to the far field; the water lies to the right of the chain.
    body : number of elements on the body, where the normal velocity is given.
    cut : number of elements across the jet; 0 if the free surface meets the body. There and on the free
        surface the potential is given.
    """

    def __init__(self, nodes: np.ndarray, body: int, cut: int):
        self.nodes, self.body, self.cut = nodes, body, cut
        step = np.diff(nodes)
        self.normal = 1j * step / np.abs(step)
        edge = nodes[-1].real
        shifted = nodes - 1j * nodes[-1].imag
        found = mirrored_layers(nodes)
        dipole = np.zeros((len(nodes), len(nodes)))
        dipole[:, :-1] += found.dipole_first
        dipole[:, 1:] += found.dipole_second
        dipole[np.diag_indices(len(nodes))] -= dipole.sum(axis=1) + far_dipole(shifted, edge) + np.pi
        self._dipole, self._layers = dipole, found
        source = np.zeros((len(nodes), len(nodes)))
        source[:, body:-1] += found.source_first[:, body:]
        source[:, body + 1 :] += found.source_second[:, body:]
        source[:, -1] += edge**2 * far_source(shifted, edge)
        self._corner = body + cut
        if cut:
            # at the corner of jet cut and free surface the velocity is one vector with two normal components
            tangent = step[self._corner] / abs(step[self._corner])
            across = np.conj(self.normal[self._corner - 1])
            self._along, self._off = (tangent * across).real, (1j * tangent * across).real
            self._other = found.source_second[:, self._corner - 1]
            source[:, self._corner] -= (1 - self._off) * self._other
        self._factor = lu_factor(np.hstack([dipole[:, :body], -source[:, body:]]), check_finite=False)

    def solve(self, potential: np.ndarray, flux: np.ndarray, slope: float) -> tuple[np.ndarray, np.ndarray]:
        """Return potential at all nodes, and normal velocity at those of jet cut and free surface.

        Parameters
        ----------
        potential : at the nodes of jet cut and free surface; flux : normal velocity on each element of
            the body; slope : derivative of the potential along the free surface at its corner with the jet cut.
        """
        found = self._layers
        known = (found.source_first[:, : self.body] + found.source_second[:, : self.body]) @ flux
        known -= self._dipole[:, self.body :] @ potential
        if self.cut:
            known += self._other * self._along * slope
        unknown = lu_solve(self._factor, known, check_finite=False)
        return np.concatenate([unknown[: self.body], potential]), unknown[self.body :]
