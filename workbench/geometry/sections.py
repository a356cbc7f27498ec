"""Sections of the wetted ship by station, and the whole surface of the hulls for drawing."""

from dataclasses import dataclass

import numpy as np

from workbench.design import Hull
from workbench.errors import InputError, checked_number
from workbench.geometry.faceted import grid_faces
from workbench.geometry.lines import (
    floating_hull,
    hull_positions,
    hull_shape,
    station_positions,
    upright_position,
)
from workbench.geometry.mesh import is_wet, placed_vertices, wet_hulls, wetted_mesh
from workbench.hulls.lines import evenly_spaced, girth
from workbench.shapes import PanelMesh


@dataclass(frozen=True, eq=False)
class HullSections:
    """Wetted contours of one hull by station, in ship axes.

    Parameters
    ----------
    x : (stations,) rising [m]; the first and last are the ends of the wetted length.
    y, z : (stations, points) [m], from the starboard waterline round the keel to the port
        waterline; z = 0 at both ends. The contour of a dry end has shrunk to a point.
    position : (x, y) of the hull's own axes [m].
    """

    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    position: tuple[float, float]

    @property
    def areas(self) -> np.ndarray:
        """Section areas (stations,) [m2]."""
        y, z = self.y, self.z
        return -np.sum((y[:, 1:] - y[:, :-1]) * (z[:, 1:] + z[:, :-1]) / 2, axis=1)

    @property
    def beams(self) -> np.ndarray:
        """Breadths of the waterline (stations,) [m]."""
        return self.y[:, -1] - self.y[:, 0]

    @property
    def draughts(self) -> np.ndarray:
        """Depths of the lowest points below still water (stations,) [m]."""
        return -self.z.min(axis=1, initial=0.0)

    @property
    def girths(self) -> np.ndarray:
        """Wetted girths (stations,) [m]."""
        return np.hypot(np.diff(self.y, axis=1), np.diff(self.z, axis=1)).sum(axis=1)


def sections(hull: Hull, stations: int = 41, points: int = 41) -> tuple[HullSections, ...]:
    """Wetted contours of every hull, in the order of `hull_positions`.

    Parameters
    ----------
    stations : number of stations over the wetted length, closer at the ends.
    points : number of points of a contour, odd so that one lies on the keel; evenly spaced
        along it, with one on each knuckle.

    Notes
    -----
    A hull that flies above the water has no stations. Heel is a rotation about
    x; trim is a shear along z, which keeps the stations in their planes.
    """
    stations = int(checked_number("number of stations", stations, at_least=3, at_most=1000))
    points = int(checked_number("number of points of a section", points, at_least=3, at_most=1000)) | 1
    wet_hulls(hull)
    return tuple(_hull_sections(hull, index, stations, points) for index in range(hull.count))


def _hull_sections(hull: Hull, index: int, stations: int, points: int) -> HullSections:
    """Return the sections of one hull."""
    position = hull_positions(hull)[index]
    if not is_wet(hull, index):
        return HullSections(np.empty(0), np.empty((0, points)), np.empty((0, points)), position)
    if isinstance(hull_shape(hull, index), PanelMesh):
        return _mesh_sections(hull, index, stations, points)
    floating = floating_hull(hull, index)
    x = station_positions(*floating.wetted_ends(), stations)
    grid = floating.wetted_grid(x, points, whole=True)
    return HullSections(x, grid[..., 1], grid[..., 2], position)


def _mesh_sections(hull: Hull, index: int, stations: int, points: int) -> HullSections:
    """Return the sections of a hull that is a mesh, from cuts through its triangles."""
    shape = hull_shape(hull, index)
    wetted = wetted_mesh(hull, shape, *upright_position(hull, index))
    triangles = wetted.triangles
    aft, fore = triangles[..., 0].min(), triangles[..., 0].max()
    x = station_positions(aft, fore, stations)
    inside = np.clip(x, aft + 1e-4 * (fore - aft), fore - 1e-4 * (fore - aft))
    y, z = np.empty((stations, points)), np.empty((stations, points))
    for k, at in enumerate(inside):
        contour = _cut_contour(triangles, at)
        spaced = evenly_spaced(contour, points)
        y[k], z[k] = spaced.T
    z[:, 0] = z[:, -1] = 0.0
    return HullSections(x, y, np.minimum(z, 0.0), hull_positions(hull)[index])


def _cut_contour(triangles: np.ndarray, x: float) -> np.ndarray:
    """Return the contour (n, 2) of triangles (m, 3, 3) at x, ordered from starboard to port."""
    near = triangles[(triangles[..., 0].min(axis=1) < x) & (triangles[..., 0].max(axis=1) >= x)]
    edges = np.stack([near, np.roll(near, -1, axis=1)], axis=2)  # (triangles, 3 edges, 2 ends, 3)
    below = edges[..., 0] < x
    crossed = below[..., 0] != below[..., 1]  # two edges of every triangle here
    start, end = np.moveaxis(edges[crossed], 1, 0)
    share = (x - start[:, 0]) / (end[:, 0] - start[:, 0])
    ends = start[:, 1:] + share[:, None] * (end[:, 1:] - start[:, 1:])
    points, numbers = np.unique(np.round(ends, 9), axis=0, return_inverse=True)
    return _chained(points, numbers.reshape(-1, 2))


def _chained(points: np.ndarray, pieces: np.ndarray) -> np.ndarray:
    """Return the points of an open contour in order along its pieces (m, 2), from starboard.

    Where no piece leads on, the nearest point left follows.
    """
    if len(points) < 2:
        return np.repeat(points, 2, axis=0)
    neighbours: list[set[int]] = [set() for _ in points]
    for one, other in pieces.tolist():
        neighbours[one].add(other)
        neighbours[other].add(one)
    at_waterline = np.flatnonzero(points[:, 1] > points[:, 1].max() - 1e-6 * max(np.ptp(points), 1e-12))
    order = [int(at_waterline[np.argmin(points[at_waterline, 0])])]
    left = set(range(len(points))) - set(order)
    while left:
        leading = sorted(neighbours[order[-1]] & left) or sorted(left)
        steps = np.linalg.norm(points[leading] - points[order[-1]], axis=1)
        order.append(leading[int(np.argmin(steps))])
        left.discard(order[-1])
    return points[order]


def surface(hull: Hull, stations: int = 61, points: int = 41) -> tuple[np.ndarray, np.ndarray]:
    """Whole surface of all hulls up to the deck edge, closed by transom and deck, in ship axes.

    Returns
    -------
    vertices : (nv, 3) [m].
    faces : (nf, 4) vertex numbers, counter-clockwise seen from outside; triangles repeat an index.
    """
    vertices, faces = [], []
    for index in range(hull.count):
        shape = hull_shape(hull, index)
        if isinstance(shape, PanelMesh):
            part = placed_vertices(hull, shape, *upright_position(hull, index)), np.array(shape.faces)
        else:
            part = _hull_surface(hull, index, stations, points)
        faces.append(part[1] + sum(map(len, vertices)))
        vertices.append(part[0])
    points, corners = np.concatenate(vertices), np.concatenate(faces)
    diagonals = points[corners[:, 2:]] - points[corners[:, :2]]
    areas = np.linalg.norm(np.cross(diagonals[:, 0], diagonals[:, 1]), axis=1)
    return points, corners[areas > 1e-9 * hull.length**2 / len(corners)]


def _hull_surface(hull: Hull, index: int, stations: int, points: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the closed surface of one hull to its deck edge."""
    floating = floating_hull(hull, index)
    x = station_positions(floating.lines.x[0], floating.lines.x[-1], stations) + floating.x
    points |= 1
    shell = np.empty((stations, points, 3))
    for k, contour in enumerate(floating.contours(x, whole=True)):
        if girth(contour)[-1] <= 0.0:
            raise InputError(f"hull has no section at x = {x[k]:g} m; check its stations.")
        shell[k, :, 0] = x[k]
        shell[k, :, 1:] = evenly_spaced(contour, points)
    deck = np.stack([shell[:, 0], shell[:, -1]], axis=1)
    rings = [shell, deck]
    faces = [grid_faces(stations, points), grid_faces(stations, 2, stations * points)[:, ::-1]]
    start = stations * points + 2 * stations
    for end, is_aft in ((shell[0], True), (shell[-1], False)):
        share = np.linspace(0.0, 1.0, points)[:, None]
        chord = end[0] + share * (end[-1] - end[0])
        rings.append(np.stack([chord, end]))
        closing = grid_faces(2, points, start)
        faces.append(closing if is_aft else closing[:, ::-1])
        start += 2 * points
    return np.concatenate([ring.reshape(-1, 3) for ring in rings]), np.concatenate(faces)
