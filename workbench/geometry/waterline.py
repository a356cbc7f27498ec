"""The waterline of each hull: where its surface meets still water."""

import numpy as np

from workbench.design import Hull
from workbench.geometry.lines import floating_hull, hull_shape, station_positions, upright_position
from workbench.geometry.mesh import wetted_mesh
from workbench.shapes import PanelMesh


def waterline(hull: Hull, index: int, columns: int = 24) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Waterline of hull number `index`: x, starboard y and port y, each (columns + 1,) [m], ship axes."""
    shape = hull_shape(hull, index)
    if isinstance(shape, PanelMesh):
        return _of_mesh(hull, index, columns)
    floating = floating_hull(hull, index)
    x = station_positions(*floating.wetted_ends(), columns + 1)
    ends = floating.wetted_grid(x, 2, whole=True)
    return x, ends[:, 0, 1], ends[:, -1, 1]


def _of_mesh(hull: Hull, index: int, columns: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the waterline from the edges of a mesh that lie in the water surface."""
    panels = wetted_mesh(hull, hull_shape(hull, index), *upright_position(hull, index))
    faces = panels.faces
    edges = np.concatenate(
        [np.stack([faces[:, k], np.roll(faces, -1, axis=1)[:, k]], axis=1) for k in range(4)]
    )
    ends = panels.vertices[edges]
    size = np.ptp(panels.vertices[:, 0])
    ends = ends[(np.abs(ends[..., 2]) < 1e-6 * size).all(axis=1) & (edges[:, 0] != edges[:, 1])]
    first, last = np.sort(ends[..., 0], axis=1).T
    x = station_positions(first.min(), last.max(), columns + 1)
    inside = np.clip(x, x[0] + 1e-6 * size, x[-1] - 1e-6 * size)
    starboard, port = np.empty_like(x), np.empty_like(x)
    for k, at in enumerate(inside):
        crossed = ends[(first <= at) & (last >= at)]
        span = crossed[:, 1, 0] - crossed[:, 0, 0]
        share = np.where(span == 0.0, 0.0, (at - crossed[:, 0, 0]) / np.where(span == 0.0, 1.0, span))
        y = crossed[:, 0, 1] + share * (crossed[:, 1, 1] - crossed[:, 0, 1])
        starboard[k], port[k] = y.min(), y.max()
    return x, starboard, port
