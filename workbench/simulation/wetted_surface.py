"""Water pressure integrated over the part of a hull that is wet at the moment.

The hull is a closed surface of triangles up to its deck. The pressure is taken
linear over each triangle and is integrated exactly over the part where it is
above atmospheric, so that a triangle cut by the water surface counts as far as
it is wet and force and moment change smoothly as the surface moves. For still
water the result is the exact hydrostatics of the polyhedron.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

_APEX = np.array([0, 0, 1, 2, 2, 1, 0, 0])
"""Corner that is alone on its side of the water surface, by the code 1, 2, 4 of the wet corners."""

_PERTURBATION = 1e-6
_DECK = 0.7


@dataclass(frozen=True, eq=False)
class HullSurface:
    """A closed surface of triangles in axes fixed to the ship.

    Parameters
    ----------
    vertices : (nv, 3) [m], from the point about which moments are taken.
    triangles : (nt, 3) vertex numbers, counter-clockwise seen from outside.
    """

    vertices: np.ndarray
    triangles: np.ndarray

    @cached_property
    def _corners(self) -> np.ndarray:
        """Vertex numbers (3, nt), for a quick gathering of the pressures."""
        return np.ascontiguousarray(self.triangles.T)

    @cached_property
    def _full(self) -> np.ndarray:
        """Force and moment (3 nt, 6) of each triangle per pressure at each of its corners."""
        at = self.vertices[self.triangles]
        area = self._area_vectors
        arms = (at.sum(axis=1)[None] + np.moveaxis(at, 1, 0)) / 12
        force = np.broadcast_to(area / 3, arms.shape)
        return -np.concatenate([force, np.cross(arms, area[None])], axis=2).reshape(-1, 6)

    @cached_property
    def _tips(self) -> np.ndarray:
        """Force and moment (nt, 3, 3, 6) of the tip cut off each triangle at each corner.

        The third axis: constant, and the shares of the two edges from the corner.
        """
        at = self.vertices[self.triangles]
        area = self._area_vectors
        made = np.zeros((len(area), 3, 3, 6))
        for corner in range(3):
            first, second = at[:, (corner + 1) % 3] - at[:, corner], at[:, (corner + 2) % 3] - at[:, corner]
            made[:, corner, 0, :3] = 4 * area
            made[:, corner, 0, 3:] = np.cross(4 * at[:, corner], area)
            made[:, corner, 1, 3:] = np.cross(first, area)
            made[:, corner, 2, 3:] = np.cross(second, area)
        return -made / 12

    @cached_property
    def _area_vectors(self) -> np.ndarray:
        """Area vectors (nt, 3), outward [m2]."""
        a, b, c = np.moveaxis(self.vertices[self.triangles], 1, 0)
        return np.cross(b - a, c - a) / 2

    @cached_property
    def upper_vertices(self) -> np.ndarray:
        """Numbers of the vertices of triangles that look up: the deck."""
        area = self._area_vectors
        looks_up = area[:, 2] > _DECK * np.linalg.norm(area, axis=1)
        return np.unique(self.triangles[looks_up])

    @property
    def volume(self) -> float:
        """Volume inside the surface [m3]."""
        centres = self.vertices[self.triangles].mean(axis=1)
        return float(np.einsum("ij,ij->", centres, self._area_vectors) / 3)

    @property
    def opening(self) -> float:
        """Size of the sum of all area vectors [m2]; 0 for a closed surface."""
        return float(np.linalg.norm(self._area_vectors.sum(axis=0)))

    def pressure_force(self, pressure: np.ndarray) -> np.ndarray:
        """Force [N] and moment [N m] about the origin of the axes, (6,), in axes fixed to the ship.

        Parameters
        ----------
        pressure : (nv,) at the vertices above atmospheric [Pa]; where negative the
            vertex is dry, and the value says how far the water surface is away.

        Notes
        -----
        Costs some 0.1 ms for 1000 triangles.
        """
        corner = pressure[self._corners]
        weight, cut, apex, shares = _wet_shares(corner)
        whole = (corner * weight).reshape(-1) @ self._full
        if not cut.size:
            return whole
        return whole + shares.reshape(-1) @ self._tips[cut, apex].reshape(-1, 6)

    def force_gradient(self, pressure: np.ndarray) -> np.ndarray:
        """Derivative of `pressure_force` by the pressure at each vertex, (6, nv)."""
        step = _PERTURBATION * float(np.abs(pressure).max())
        corner = pressure[self._corners]
        gradient = np.zeros((len(self.vertices), 6))
        for which in range(3):
            moved = np.zeros_like(corner)
            moved[which] = step
            change = self._by_triangle(corner + moved) - self._by_triangle(corner - moved)
            np.add.at(gradient, self._corners[which], change / (2 * step))
        return gradient.T

    def _by_triangle(self, corner: np.ndarray) -> np.ndarray:
        """Force and moment (nt, 6) of each triangle from its corner pressures (3, nt)."""
        weight, cut, apex, shares = _wet_shares(corner)
        found = np.einsum("ct,ctj->tj", corner * weight, self._full.reshape(3, -1, 6))
        found[cut] += np.einsum("ts,tsj->tj", shares, self._tips[cut, apex])
        return found


def _wet_shares(corner: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """How triangles of corner pressures (3, nt) are wet.

    Returns
    -------
    Weight (nt,) of the integral over the whole triangle, the numbers of the cut
    triangles, the lone corner of each, and the factors (cut, 3) of `_tips`. A
    lone wet corner gives the tip alone; with a lone dry one the integral over the
    whole triangle counts the negative pressure of the tip, which is taken off.
    """
    wet = corner > 0
    code = wet[0] + 2 * wet[1].view(np.int8) + 4 * wet[2].view(np.int8)
    whole = (code == 7) | (code == 3) | (code == 5) | (code == 6)
    cut = np.flatnonzero((code != 0) & (code != 7))
    apex = _APEX[code[cut]]
    own = corner[apex, cut]
    first = own / (own - corner[(apex + 1) % 3, cut])
    second = own / (own - corner[(apex + 2) % 3, cut])
    size = first * second * np.abs(own)
    return whole, cut, apex, np.stack([size, size * first, size * second], axis=1)
