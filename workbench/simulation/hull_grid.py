"""Closed surface of the hulls up to the deck edge, with a line of vertices on the still waterline.

Fineness goes where pressure is: most of the points of a station lie below still
water, evenly spaced, and the rest between waterline and deck edge.
"""

import numpy as np

from workbench.design import Hull
from workbench.errors import InputError, checked_number
from workbench.geometry.faceted import grid_faces
from workbench.geometry.lines import (
    FloatingHull,
    floating_hull,
    hull_shape,
    station_positions,
    upright_position,
)
from workbench.geometry.mesh import is_wet, placed_vertices
from workbench.hulls.lines import evenly_spaced, girth
from workbench.shapes import PanelMesh
from workbench.simulation.wetted_surface import HullSurface

SHARE_BELOW = 0.6
"""Share of the points of a station below still water [-]."""

STATIONS_PER_POINT = 1.3

_LEAST_POINTS = 6


def hull_surface(hull: Hull, centre: tuple[float, float, float], panels: int = 1000) -> HullSurface:
    """Whole surface of all hulls up to the deck edge, closed by transom and deck, about a point.

    Parameters
    ----------
    hull : in the attitude in which it floats.
    centre : point about which moments are taken, in ship axes [m].
    panels : wished number of four-sided panels of the whole ship, 200 to 6000; a hull that is
        given as a mesh keeps its own faces.

    Notes
    -----
    The wet deck between the hulls is no part of it. With 1000 panels a twin hull has
    its volume to some 2 %.
    """
    panels = checked_number("panels of the simulation", panels, at_least=200, at_most=6000)
    vertices, faces = [], []
    for index in range(hull.count):
        shape = hull_shape(hull, index)
        if isinstance(shape, PanelMesh):
            part = placed_vertices(hull, shape, *upright_position(hull, index)), np.array(shape.faces)
        else:
            part = _closed_hull(floating_hull(hull, index), panels / hull.count, is_wet(hull, index))
        faces.append(part[1] + sum(map(len, vertices)))
        vertices.append(part[0])
    return _triangles(np.concatenate(vertices), np.concatenate(faces), np.asarray(centre, float))


def _closed_hull(floating: FloatingHull, panels: float, wet: bool) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of one hull to its deck edge."""
    segments = max(_LEAST_POINTS, round(np.sqrt(panels / STATIONS_PER_POINT) / 2))
    below = 2 * round(SHARE_BELOW * segments)
    above = segments - below // 2
    stations = max(2 * _LEAST_POINTS, round(panels / (2 * segments)))
    ends = floating.lines.x[0] + floating.x, floating.lines.x[-1] + floating.x
    wetted = floating.wetted_ends() if wet else ends
    x = station_positions(*wetted, stations)
    for end, wetted_end in zip(ends, wetted, strict=True):
        x = np.concatenate([x, np.linspace(wetted_end, end, 4)[1:]])
    x = np.unique(np.round(x, 9))
    shell = np.empty((len(x), below + 2 * above + 1, 3))
    for k, contour in enumerate(floating.contours(x, whole=True)):
        shell[k, :, 0] = x[k]
        shell[k, :, 1:] = _split_contour(contour, below, above)
    return _closed(shell)


def _split_contour(contour: np.ndarray, below: int, above: int) -> np.ndarray:
    """Points of a whole contour (n, 2): above to starboard, below still water, above to port."""
    z = contour[:, 1]
    lowest = int(np.argmin(z))
    if z[lowest] >= 0:
        starboard, wet, port = contour[: lowest + 1], contour[lowest : lowest + 1], contour[lowest:]
    else:
        starboard, first = _dry_branch(contour[lowest::-1])
        port, last = _dry_branch(contour[lowest:])
        starboard = starboard[::-1]
        wet = np.concatenate([starboard[-1:], contour[lowest - first : lowest + last + 1], port[:1]])
    return np.concatenate(
        [
            _spaced(starboard, above + 1)[:-1],
            _spaced(wet, below + 1),
            _spaced(port, above + 1)[1:],
        ]
    )


def _dry_branch(branch: np.ndarray) -> tuple[np.ndarray, int]:
    """Part of a branch that starts at the lowest point after it leaves the water, and its last wet point."""
    dry = branch[:, 1] >= 0
    if not dry.any():
        return branch[-1:], len(branch) - 1
    first = int(np.argmax(dry))
    inner, outer = branch[first - 1], branch[first]
    share = inner[1] / (inner[1] - outer[1])
    return np.concatenate([[inner + share * (outer - inner)], branch[first:]]), first - 1


def _spaced(points: np.ndarray, count: int) -> np.ndarray:
    """Points evenly spaced along a polyline, or one point repeated."""
    if len(points) == 1 or girth(points)[-1] <= 0:
        return np.repeat(points[:1], count, axis=0)
    return evenly_spaced(points, count)


def _closed(shell: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a shell (stations, points, 3) closed by deck and ends."""
    stations, points = shell.shape[:2]
    deck = np.stack([shell[:, 0], shell[:, -1]], axis=1)
    rings = [shell, deck]
    faces = [grid_faces(stations, points), grid_faces(stations, 2, stations * points)[:, ::-1]]
    start = stations * points + 2 * stations
    share = np.linspace(0.0, 1.0, points)[:, None]
    for end, is_aft in ((shell[0], True), (shell[-1], False)):
        rings.append(np.stack([end[0] + share * (end[-1] - end[0]), end]))
        closing = grid_faces(2, points, start)
        faces.append(closing if is_aft else closing[:, ::-1])
        start += 2 * points
    return np.concatenate([ring.reshape(-1, 3) for ring in rings]), np.concatenate(faces)


def _triangles(vertices: np.ndarray, faces: np.ndarray, centre: np.ndarray) -> HullSurface:
    """Triangles of the faces with coincident vertices merged; repeated corners are left out."""
    size = float(np.ptp(vertices[:, 0]))
    _, first, merged = np.unique(
        np.round(vertices / (1e-7 * size)).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    corners = merged.reshape(-1)[faces]
    port = (
        vertices[faces][..., 1].sum(axis=1) >= 0
    )  # other diagonals to starboard keep a ship its mirror image
    corners = np.concatenate(
        [
            corners[port][:, (0, 1, 2)],
            corners[port][:, (0, 2, 3)],
            corners[~port][:, (0, 1, 3)],
            corners[~port][:, (1, 2, 3)],
        ]
    )
    distinct = (corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2])
    corners = corners[distinct & (corners[:, 2] != corners[:, 0])]
    used, renumbered = np.unique(corners, return_inverse=True)
    made = HullSurface(vertices[first][used] - centre, renumbered.reshape(-1, 3))
    if made.volume <= 0 or made.opening > 1e-3 * made.volume ** (2 / 3):
        raise InputError(
            "surface of the hull must be closed up to its deck for a non-linear simulation, it has holes; "
            "close the mesh, or choose the linear simulation."
        )
    return made
