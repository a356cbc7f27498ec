"""Structured panels of the wetted ship, and the lids that go with them."""

import numpy as np

from workbench.design import Hull
from workbench.errors import InputError, checked_number
from workbench.geometry.faceted import Panels, cleaned, grid_faces, joined
from workbench.geometry.lines import (
    CENTRE,
    FloatingHull,
    floating_hull,
    hull_positions,
    hull_shape,
    is_symmetric,
    station_positions,
    upright_position,
)
from workbench.geometry.mesh import wet_hulls, wetted_mesh
from workbench.geometry.waterline import waterline
from workbench.shapes import PanelMesh

PANEL_ASPECT = 3.0
"""Length over height of a typical panel."""

LEAST_STRIPS, LEAST_COLUMNS = 5, 8

__all__ = ["Panels", "hull_panels", "hull_positions", "lid_panels", "panels", "tunnel_lid"]


def panels(hull: Hull, target_count: int = 1000, *, panel_size: float | None = None) -> Panels:
    """Panels of the whole wetted ship.

    Parameters
    ----------
    target_count : wished number of panels of the whole ship.
    panel_size : typical side of a panel [m]; if given, `target_count` is not used.

    Notes
    -----
    An upright ship comes as its half y > 0 with ``mirrored`` true: the whole
    port hull of a twin, half of a single hull, both of these for three hulls.
    A heeled ship comes whole, without the hulls that it flies above the water.
    """
    return _counted(lambda size: _whole_ship(hull, size), hull, target_count, panel_size)


def _whole_ship(hull: Hull, size: float) -> Panels:
    """Return the panels of the whole ship for one size of panel."""
    if not is_symmetric(hull):
        parts = [_one_hull(hull, k, size, half=False) for k in wet_hulls(hull)]
        return joined(parts, mirrored=False)
    if hull.count == 1:
        return _one_hull(hull, 0, size, half=not isinstance(hull.shape, PanelMesh))
    parts = [_one_hull(hull, 0, size, half=False)]
    if hull.count == 3:
        parts.append(_one_hull(hull, CENTRE, size, half=True))
    return joined(parts, mirrored=True)


def hull_panels(
    hull: Hull, index: int, target_count: int = 500, *, panel_size: float | None = None
) -> Panels:
    """Panels of hull number `index` alone in its own axes (its centre plane at y = 0).

    The half y > 0 with ``mirrored`` true when upright; `target_count` counts
    this one hull. Its place in the ship is ``hull_positions(hull)[index]``.
    """
    shape = hull_shape(hull, index)
    half = is_symmetric(hull) and not isinstance(shape, PanelMesh)
    x, y = hull_positions(hull)[index]

    def make(size: float) -> Panels:
        made = _one_hull(hull, index, size, half)
        return made.translated(-x) if half else made.translated(-x, -y)

    return _counted(make, Hull(shape=shape, sinkage=hull.sinkage), target_count, panel_size)


def _counted(make, hull: Hull, target_count: int, panel_size: float | None) -> Panels:
    """Return make(size), with the size corrected once or twice to meet the wished number of panels."""
    size = _panel_size(hull, target_count, panel_size)
    made = make(size)
    for _ in range(0 if panel_size is not None else 2):
        count = len(made) * (2 if made.mirrored else 1)
        if abs(count - target_count) <= 0.05 * target_count:
            break
        size *= float(np.sqrt(count / target_count))
        made = make(size)
    return made


def _panel_size(hull: Hull, target_count: int, panel_size: float | None) -> float:
    """Return the height of a typical panel [m]."""
    if panel_size is not None:
        length = hull.length
        size = checked_number("panel size", panel_size, "m", at_least=1e-3 * length, at_most=length)
        return size / np.sqrt(PANEL_ASPECT)
    count = checked_number("number of panels", target_count, at_least=50, at_most=100_000)
    surface = 0.0
    for index in range(hull.count):
        shape = hull_shape(hull, index)
        surface += shape.length * 0.9 * (shape.beam + 2 * (shape.draught + hull.sinkage))
    return float(np.sqrt(surface / (PANEL_ASPECT * count)))


def _one_hull(hull: Hull, index: int, size: float, half: bool) -> Panels:
    """Return the panels of one hull: the whole of it in ship axes, or its half about its own centre plane."""
    if isinstance(hull_shape(hull, index), PanelMesh):
        return wetted_mesh(hull, hull_shape(hull, index), *upright_position(hull, index))
    floating = floating_hull(hull, index)
    aft, fore = floating.wetted_ends()
    middle = floating.wetted_grid([0.5 * (aft + fore)], 41, whole=not half)[0]
    girth = np.linalg.norm(np.diff(middle, axis=0), axis=1).sum()
    strips = max(LEAST_STRIPS * (1 if half else 2), round(girth / size))
    strips += 0 if half else strips % 2
    columns = max(LEAST_COLUMNS, round((fore - aft) / (PANEL_ASPECT * size)))
    return _structured(floating, station_positions(aft, fore, columns + 1), strips + 1, half, size)


def _structured(floating: FloatingHull, x: np.ndarray, points: int, half: bool, size: float) -> Panels:
    """Return panels over the grid of stations and girth, with its ends closed."""
    grid = floating.wetted_grid(x, points, whole=not half)
    vertices, faces = [grid.reshape(-1, 3)], [grid_faces(len(x), points)]
    transom = [np.zeros(len(faces[0]), bool)]
    for end, is_aft in ((grid[0], True), (grid[-1], False)):
        ring = _end_grid(end, half, size)
        start = sum(map(len, vertices))
        closing = grid_faces(*ring.shape[:2], start)
        vertices.append(ring.reshape(-1, 3))
        faces.append(closing if is_aft else closing[:, ::-1])
        transom.append(np.full(len(closing), is_aft))
    return cleaned(np.concatenate(vertices), np.concatenate(faces), np.concatenate(transom), half)


def _end_grid(contour: np.ndarray, half: bool, size: float) -> np.ndarray:
    """Return points (layers + 1, n, 3) between the chord and the contour of an end that panels shall close.

    The chord is the trace of the centre plane for a half contour, of the water surface for a whole one.
    """
    share = np.linspace(0.0, 1.0, len(contour))[:, None]
    last = contour[-1] * (1.0, 0.0, 1.0) if half else contour[-1]
    chord = contour[0] + share * (last - contour[0])
    width = np.linalg.norm(contour - chord, axis=1).max()
    layers = max(1, round(width / (PANEL_ASPECT * size)))
    return np.stack([chord + k / layers * (contour - chord) for k in range(layers + 1)])


def lid_panels(hull: Hull, index: int | None = None, *, columns: int = 24, strips: int = 4) -> Panels:
    """Panels on the still-water plane inside the hulls, which suppress irregular frequencies.

    Parameters
    ----------
    index : number of one hull, for its lid in its own axes as in `hull_panels`; all hulls if None.
    columns, strips : number of panels along and across one whole waterplane.

    Notes
    -----
    The lid is the same half of the ship as `panels` gives, and is never empty.
    Its normals point down.
    """
    if index is not None:
        shape = hull_shape(hull, index)
        half = is_symmetric(hull) and not isinstance(shape, PanelMesh)
        x, y = hull_positions(hull)[index]
        made = _lid(waterline(hull, index, columns), strips, half=half, centre=y)
        return made.translated(-x, -y)
    if not is_symmetric(hull):
        parts = [_lid(waterline(hull, k, columns), strips, half=False) for k in wet_hulls(hull)]
        return joined(parts, mirrored=False)
    if hull.count == 1:
        return _lid(waterline(hull, 0, columns), strips, half=not isinstance(hull.shape, PanelMesh))
    parts = [_lid(waterline(hull, 0, columns), strips, half=False)]
    if hull.count == 3:
        parts.append(_lid(waterline(hull, CENTRE, columns), strips, half=True))
    return joined(parts, mirrored=True)


def tunnel_lid(hull: Hull, *, columns: int = 30, strips: int = 6) -> Panels:
    """Panels on the still-water plane between the hulls, y > 0, mirrored; for a damping lid.

    It reaches from the centreline (or the centre hull) to the inner waterline
    of the port hull, over the length of that hull's waterline; normals down.
    """
    if hull.count == 1 or not is_symmetric(hull):
        raise InputError(
            f"tunnel lid needs two or three upright hulls, got {hull.count} with heel {hull.heel:g} rad; "
            "set the heel to 0 or leave the lid out."
        )
    x, inner, _ = waterline(hull, 0, columns)
    from_y = np.zeros_like(x)
    if hull.count == 3:
        centre_x, _, centre_y = waterline(hull, CENTRE, columns)
        from_y = np.interp(x, centre_x, centre_y, left=0.0, right=0.0)
    return _flat_panels(x, from_y, inner, strips, mirrored=True)


def _lid(edges: tuple, strips: int, half: bool, centre: float = 0.0) -> Panels:
    """Return flat panels inside a waterline, its half on the port side of its centre plane or the whole."""
    x, starboard, port = edges
    if half:
        return _flat_panels(x, np.full_like(x, centre), port, max(2, strips // 2), mirrored=True)
    return _flat_panels(x, starboard, port, strips, mirrored=False)


def _flat_panels(x, from_y, to_y, strips: int, mirrored: bool) -> Panels:
    """Return panels at z = 0 between two curves y(x), normals down."""
    share = np.linspace(0.0, 1.0, strips + 1)
    y = from_y[:, None] + share * (to_y - from_y)[:, None]
    grid = np.stack([np.broadcast_to(x[:, None], y.shape), y, np.zeros_like(y)], axis=-1)
    faces = grid_faces(*y.shape)
    return cleaned(grid.reshape(-1, 3), faces, np.zeros(len(faces), bool), mirrored)
