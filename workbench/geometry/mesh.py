"""Wetted panels of a hull that is given as a mesh."""

import math

import numpy as np

from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.faceted import Panels, cleaned
from workbench.geometry.lines import floating_hull, hull_shape, upright_position
from workbench.hulls.surface_mesh import below_water, check_closed
from workbench.shapes import PanelMesh


def placed_vertices(hull: Hull, shape: PanelMesh, x: float, y: float) -> np.ndarray:
    """Vertices (n, 3) of a mesh hull in ship axes [m]; its own axes stand at (x, y) before heel.

    Heel is a rotation about x, trim a shear, z - x tan(trim).
    """
    vertices = np.array(shape.vertices)
    along, across, up = vertices[:, 0] + x, vertices[:, 1] + y, vertices[:, 2]
    cosine, sine = math.cos(hull.heel), math.sin(hull.heel)
    across, up = across * cosine - up * sine, across * sine + up * cosine
    return np.stack([along, across, up - along * math.tan(hull.trim) - hull.sinkage], axis=1)


def is_wet(hull: Hull, index: int) -> bool:
    """Whether hull number `index` reaches the water; a heeled ship may fly a hull."""
    shape = hull_shape(hull, index)
    if isinstance(shape, PanelMesh):
        lowest = placed_vertices(hull, shape, *upright_position(hull, index))[:, 2].min()
    else:
        lowest = floating_hull(hull, index).lowest_point
    return bool(lowest < -1e-4 * shape.draught)


def wet_hulls(hull: Hull) -> tuple[int, ...]:
    """Numbers of the hulls that reach the water; refused where none does."""
    wet = tuple(index for index in range(hull.count) if is_wet(hull, index))
    if not wet:
        raise InputError(
            "ship must reach the water, all its hulls are above still water; reduce heel, trim or rise."
        )
    return wet


def wetted_mesh(hull: Hull, shape: PanelMesh, x: float, y: float) -> Panels:
    """Panels of a mesh hull below still water, in ship axes."""
    vertices = placed_vertices(hull, shape, x, y)
    if vertices[:, 2].min() >= 0.0:
        raise InputError(
            f"hull at y = {y:g} m must reach the water, its lowest point is {vertices[:, 2].min():g} m above "
            "still water; reduce heel, trim or rise."
        )
    vertices, faces = below_water(vertices, np.array(shape.faces))
    made = cleaned(vertices, faces, np.zeros(len(faces), bool), mirrored=False)
    if hull.heel or hull.trim or hull.sinkage:  # a mesh that ends at its own waterline floods in another
        check_closed(made.vertices, made.faces, tolerance=1e-4)
    return made
