"""Hulls as contours at evenly spaced stations from the bow aft, and the cross-plane problems they pose."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.lines import is_symmetric
from workbench.geometry.sections import HullSections, sections
from workbench.hydrodynamics.marched_contour import Contour

SECTION_STATIONS = 161
"""Stations at which the hull is cut; contours of the march are interpolated between them."""
LEAST_THICKNESS = 2.5e-4
"""Half the least thickness of a section, over the length: a plate has no inside to put sources round [-]."""


@dataclass(frozen=True, eq=False)
class StationedHull:
    """One hull at the stations of the march.

    Parameters
    ----------
    contours : (stations, points) complex y + i z in ship axes [m], starboard to port; nan where dry.
    aft, fore : ends of the wetted length [m].
    y : of its own axes [m].
    """

    contours: np.ndarray
    aft: float
    fore: float
    y: float

    @property
    def wet(self) -> np.ndarray:
        """Whether there is a section at each station (stations,)."""
        return ~np.isnan(self.contours[:, 0])

    @property
    def beams(self) -> np.ndarray:
        """Breadths of the waterline (stations,), 0 where dry [m]."""
        return np.where(self.wet, (self.contours[:, -1] - self.contours[:, 0]).real, 0.0)

    @property
    def last_draught(self) -> float:
        """Draught of the last wet section [m]."""
        return float(-self.contours[self.wet][-1].imag.min())


@dataclass(frozen=True, eq=False)
class Stations:
    """All hulls at common stations.

    Parameters
    ----------
    x : (stations,) falling from just aft of the bow to the stern [m]; bow : where the march begins [m].
    hulls : those that are wet; upright : whether the ship is its own mirror image.
    """

    x: np.ndarray
    bow: float
    hulls: tuple[StationedHull, ...]
    upright: bool

    @property
    def spacing(self) -> float:
        """Distance between stations [m]."""
        return float(self.bow - self.x[0])

    @property
    def families(self) -> tuple[tuple[int, ...], ...]:
        """Numbers of the hulls of each family: mirror images are one family."""
        if not self.upright or len(self.hulls) == 1:
            return tuple((number,) for number in range(len(self.hulls)))
        return ((0, 1), (2,))[: len(self.hulls) - 1]


def stationed(hull: Hull, count: int, panels: int) -> Stations:
    """Hulls at ``count`` stations with ``panels`` on each wetted contour.

    Raises
    ------
    InputError where a contour crosses itself or no hull is wet.
    """
    cut = [part for part in sections(hull, SECTION_STATIONS, panels + 1) if part.x.size]
    bow = max(float(part.x[-1]) for part in cut)
    aft = min(float(part.x[0]) for part in cut)
    x = bow - (bow - aft) / count * np.arange(1, count + 1)
    x[-1] = aft
    hulls = tuple(_at_stations(part, x) for part in cut)
    return Stations(x, bow, hulls, is_symmetric(hull) and len(cut) == hull.count)


def _at_stations(cut: HullSections, x: np.ndarray) -> StationedHull:
    """Return one hull at the stations."""
    rows = cut.y + 1j * cut.z
    place = np.interp(x, cut.x, np.arange(len(cut.x)))
    before = np.minimum(place.astype(int), len(cut.x) - 2)
    share = (place - before)[:, None]
    contours = (1 - share) * rows[before] + share * rows[before + 1]
    contours[:, [0, -1]] = contours[:, [0, -1]].real
    length = cut.x[-1] - cut.x[0]
    outside = (x < cut.x[0] - 1e-9 * length) | (x > cut.x[-1] + 1e-9 * length)
    panel = np.abs(np.diff(contours, axis=1))
    plate = np.abs(contours - contours[:, ::-1]).max(axis=1) < 2 * LEAST_THICKNESS * length
    middle = contours.shape[1] // 2
    contours[plate] += LEAST_THICKNESS * length * np.sign(np.arange(contours.shape[1]) - middle)
    contours[outside | (panel.min(axis=1) < 1e-7 * length)] = np.nan
    found = StationedHull(contours, float(cut.x[0]), float(cut.x[-1]), float(cut.position[1]))
    if not found.wet.any():
        raise InputError(
            f"hull at y = {found.y:g} m has no section to march along; check its stations or its immersion."
        )
    return found


@dataclass(frozen=True, eq=False)
class Problem:
    """One cross-plane problem: which hulls share the water, about which axis, even and odd or whole.

    Parameters
    ----------
    contours : of each station; families : how many families of hulls they have.
    axis : y of the origin of the problem in the ship [m].
    parities : of the marches it takes.
    """

    contours: tuple[Contour | None, ...]
    families: int
    axis: float
    parities: tuple[int, ...]


def hull_alone(stations: Stations, number: int) -> Problem:
    """One hull in its own axes: the half of it if it is upright."""
    hull = stations.hulls[number]
    rows = hull.contours - hull.y
    if stations.upright:
        return Problem(tuple(map(_contour, _halves(rows)[:, None])), 1, hull.y, (1, -1))
    return Problem(tuple(map(_contour, rows[:, None])), 1, hull.y, (0,))


def all_together(stations: Stations) -> Problem:
    """All hulls in one cross-plane, in ship axes: the port half of an upright ship."""
    if not stations.upright:
        rows = np.stack([hull.contours for hull in stations.hulls], axis=1)
        return Problem(tuple(map(_contour, rows)), len(stations.hulls), 0.0, (0,))
    port = [list(part) for part in stations.hulls[0].contours[:, None]]
    if len(stations.hulls) == 3:
        for row, half in zip(port, _halves(stations.hulls[2].contours), strict=True):
            row.append(half)
    return Problem(tuple(map(_contour, port)), len(stations.families), 0.0, (1, -1))


def _halves(rows: np.ndarray) -> np.ndarray:
    """Return the port halves, keel to waterline, of contours (stations, points)."""
    halves = rows[:, rows.shape[1] // 2 :].copy()
    halves[:, 0] = np.where(np.isnan(halves[:, 0]), np.nan, 1j * halves[:, 0].imag)
    return halves


def _contour(parts: Sequence[np.ndarray]) -> Contour | None:
    """Return the contour of one station from those of its hulls."""
    wet = [(family, part) for family, part in enumerate(parts) if not np.isnan(part[0])]
    if not wet:
        return None
    return Contour(
        np.concatenate([part[:-1] for _, part in wet]),
        np.concatenate([part[1:] for _, part in wet]),
        tuple((float(part[0].real), float(part[-1].real)) for _, part in wet),
        np.concatenate([np.full(len(part) - 1, family) for family, part in wet]),
    )
