"""The surface of one hull as a grid of points, and the treatment of contours.

A *contour* is an open polyline of points (y, z) in a plane of constant x. The
half contour of a symmetric hull runs from the keel to the deck edge, y >= 0.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.interpolate import PchipInterpolator

KNUCKLE_ANGLE = np.radians(40.0)
"""Change of direction of a contour above which a corner is meant, not a curve through few points [rad]."""


@dataclass(frozen=True, eq=False)
class Lines:
    """Half surface of a hull about its own centre plane, from keel to deck edge.

    Parameters
    ----------
    x : (stations,) strictly rising [m], x = 0 amidships.
    y : (stations, points) half-breadths [m].
    z : (stations, points) heights above the design waterline [m].

    Notes
    -----
    Points of equal index are joined lengthwise by monotone cubics, which do not
    overshoot between stations.
    """

    x: np.ndarray
    y: np.ndarray
    z: np.ndarray

    @cached_property
    def _loft(self) -> PchipInterpolator:
        return PchipInterpolator(self.x, np.stack([self.y, self.z], axis=-1), axis=0)

    def contours(self, x) -> tuple[np.ndarray, np.ndarray]:
        """Half contours (y, z), each (len(x), points) [m], at stations x (n,) inside the hull's length."""
        points = self._loft(np.clip(np.asarray(x, float), self.x[0], self.x[-1]))
        return np.maximum(points[..., 0], 0.0), points[..., 1]


def girth(points: np.ndarray) -> np.ndarray:
    """Length along a polyline (n, d) from its first point to each point (n,) [m]."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def knuckles(points: np.ndarray, angle: float = KNUCKLE_ANGLE) -> np.ndarray:
    """Indices of the corners of a polyline (n, 2) that turn by more than `angle` [rad]."""
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    kept = np.flatnonzero(lengths > 1e-9 * max(lengths.sum(), 1e-30))
    if kept.size < 2:
        return np.empty(0, int)
    directions = steps[kept] / lengths[kept, None]
    cosine = np.clip(np.sum(directions[:-1] * directions[1:], axis=1), -1.0, 1.0)
    return kept[1:][np.arccos(cosine) > angle]


def evenly_spaced(points: np.ndarray, count: int, angle: float = KNUCKLE_ANGLE) -> np.ndarray:
    """Points (count, 2) evenly spaced along a polyline (n, 2), the nearest moved onto each knuckle."""
    along = girth(points)
    if along[-1] <= 0.0:
        return np.repeat(points[:1], count, axis=0)
    wanted = np.linspace(0.0, along[-1], count)
    for corner in knuckles(points, angle):
        nearest = int(np.argmin(np.abs(wanted - along[corner])))
        if 0 < nearest < count - 1:
            wanted[nearest] = along[corner]
    return np.stack([np.interp(wanted, along, points[:, k]) for k in range(2)], axis=1)


def smooth_contour(points: np.ndarray, count: int) -> np.ndarray:
    """Curve (count, 2) through the points of a table (n, 2), straight only where the table has corners.

    Monotone cubics over the chord length, broken at knuckles; the result is evenly spaced.
    """
    corners = [0, *knuckles(points), len(points) - 1]
    pieces = [points[:1]]
    for start, end in pairwise(corners):
        piece = points[start : end + 1]
        along = girth(piece)
        keep = np.concatenate([[True], np.diff(along) > 0.0])
        piece, along = piece[keep], along[keep]
        if len(piece) < 3:
            pieces.append(piece[1:])
            continue
        fine = np.linspace(0.0, along[-1], 8 * len(piece))
        pieces.append(PchipInterpolator(along, piece, axis=0)(fine)[1:])
    return evenly_spaced(np.concatenate(pieces), count)


def wetted_part(points: np.ndarray) -> np.ndarray | None:
    """Part of a contour (n, 2) below z = 0, ending exactly on z = 0; None where it is dry.

    The part is the one that holds the lowest point: it runs from there both
    ways until it meets the water surface. An end of the contour that is itself
    under water (the keel of a half contour, or a flooded deck edge) stays.
    """
    z = points[:, 1]
    lowest = int(np.argmin(z))
    if z[lowest] >= 0.0:
        return None
    dry = z >= 0.0
    after = lowest + int(np.argmax(dry[lowest:])) if dry[lowest:].any() else None
    before = lowest - int(np.argmax(dry[lowest::-1])) if dry[: lowest + 1].any() else None
    first = 0 if before is None else before + 1
    last = len(points) if after is None else after
    parts = [points[first:last]]
    if before is not None:
        parts.insert(0, _crossing(points[before], points[before + 1])[None])
    if after is not None:
        parts.append(_crossing(points[after], points[after - 1])[None])
    return np.concatenate(parts)


def _crossing(dry: np.ndarray, wet: np.ndarray) -> np.ndarray:
    """Return the point of a segment on z = 0."""
    share = dry[1] / (dry[1] - wet[1])
    return np.array([dry[0] + share * (wet[0] - dry[0]), 0.0])
