"""The wetted contour at one station of a march: panels, and the sources on them with their images."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np


def panel_integrals(
    points: np.ndarray, starts: np.ndarray, ends: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Potential int ln|p - q| ds and complex velocity (y - i z components) of straight unit source panels.

    Parameters
    ----------
    points : (n,) complex y + i z; starts, ends : (m,) complex.

    Returns
    -------
    Two arrays (n, m). On a panel itself the potential holds, the velocity does not: its normal
    part is pi on the side of the normal.
    """
    along = (ends - starts) / np.abs(ends - starts)
    first = (points[:, None] - starts) / along
    second = (points[:, None] - ends) / along
    with np.errstate(divide="ignore", invalid="ignore"):
        log_first, log_second = np.log(first), np.log(second)
    log_first = np.where(first == 0, 0.0, log_first)
    log_second = np.where(second == 0, 0.0, log_second)
    potential = (first * log_first - second * log_second - (first - second)).real
    seen = np.angle(first * np.conj(second))  # one angle, not two across the cut of the logarithm
    return potential, (log_first.real - log_second.real + 1j * seen) / along


@dataclass(frozen=True, eq=False)
class Contour:
    """The wetted contour of all hulls at one station: panels with normals into the water.

    Parameters
    ----------
    starts, ends : (m,) complex y + i z [m]; from starboard round the keel to port.
    waterlines : (starboard, port) y of each hull [m].
    family : (m,) number of the hull, or pair of hulls, that each panel belongs to.
    """

    starts: np.ndarray
    ends: np.ndarray
    waterlines: tuple[tuple[float, float], ...]
    family: np.ndarray

    @property
    def lengths(self) -> np.ndarray:
        """Lengths of the panels [m]."""
        return np.abs(self.ends - self.starts)

    @property
    def centres(self) -> np.ndarray:
        """Centres of the panels, complex [m]."""
        return (self.starts + self.ends) / 2

    @property
    def normals(self) -> np.ndarray:
        """Unit normals into the water, complex."""
        return -1j * (self.ends - self.starts) / self.lengths

    @cached_property
    def _kept(self) -> dict[tuple[bool, float], tuple[np.ndarray, ...]]:
        """Influences that the even and the odd march share."""
        return {}

    def influence(self, points: np.ndarray, parity: int, on_panels: bool) -> tuple[np.ndarray, np.ndarray]:
        """Potential and complex velocity at points, of unit sources with their images (n, m).

        With ``on_panels`` the points are the centres of the panels; otherwise they are on the water, and
        the same ones in every call for marches of even and odd motions.
        """
        key = on_panels, len(points)
        if key not in self._kept:
            potential, velocity = panel_integrals(points, self.starts, self.ends)
            if on_panels:
                np.fill_diagonal(velocity, np.pi * np.conj(self.normals))
            above = np.conj(self.ends), np.conj(self.starts)
            found = [*_less(potential, velocity, panel_integrals(points, *above))]
            if parity:
                mirrored = panel_integrals(points, -above[0], -above[1])
                found += _less(*mirrored, panel_integrals(points, -self.starts, -self.ends))
            self._kept[key] = tuple(found)
        potential, velocity, *mirrored = self._kept[key]
        if not parity:
            return potential, velocity
        return potential + parity * mirrored[0], velocity + parity * mirrored[1]


def _less(
    potential: np.ndarray, velocity: np.ndarray, other: tuple[np.ndarray, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """Return influences less those of another set of sources."""
    return potential - other[0], velocity - other[1]


def section_weights(contour: Contour) -> np.ndarray:
    """Lengths times (n2, n3, y n3 - z n2), (3, m)."""
    n2, n3 = contour.normals.real, contour.normals.imag
    y, z = contour.centres.real, contour.centres.imag
    return contour.lengths * np.stack([n2, n3, y * n3 - z * n2])
