"""Shapes that are given point by point: a table of offsets, a mesh of panels."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from workbench.errors import InputError, checked_number
from workbench.hull_shape import DRAUGHT_RANGE, LENGTH_RANGE, HullShape, set_number
from workbench.hulls.families.offset_table import checked_stations
from workbench.hulls.surface_mesh import checked_mesh


@dataclass(frozen=True, kw_only=True)
class Offsets(HullShape):
    """A hull from its table of offsets.

    Parameters
    ----------
    stations : tuple of (x, ((z, half_breadth), ...)): x from midships, forward; z above the keel
        datum; half-breadths about the hull's own centre plane [m].
    draught : height of the waterline above the keel datum [m].
    length : length of the waterline (between perpendiculars) [m].
    """

    kind: ClassVar[str] = "offsets"
    stations: tuple
    draught: float
    length: float

    def __post_init__(self) -> None:
        set_number(self, "length", "hull length", "m", at_least=LENGTH_RANGE[0], at_most=LENGTH_RANGE[1])
        set_number(self, "draught", "hull draught", "m", at_least=DRAUGHT_RANGE[0], at_most=DRAUGHT_RANGE[1])
        object.__setattr__(self, "stations", checked_stations(self.stations, self.draught, self.length))

    @property
    def beam(self) -> float:  # type: ignore[override]
        """Largest breadth at or below the waterline [m]."""
        widest = 0.0
        for _, points in self.stations:
            z, y = np.array(points).T
            at_waterline = np.interp(self.draught, z, y) if z[0] <= self.draught else 0.0
            widest = max(widest, at_waterline, *y[z <= self.draught], 0.0)
        return 2.0 * float(widest)

    @property
    def depth(self) -> float:  # type: ignore[override]
        """Height of the highest tabulated point above the keel datum [m]."""
        return max(z for _, points in self.stations for z, _ in points)

    def scaled(self, factor: float) -> "Offsets":
        """Return the geometrically similar shape, `factor` times as long."""
        factor = checked_number("scale factor", factor, above=0.0)
        stations = tuple(
            (x * factor, tuple((z * factor, y * factor) for z, y in points)) for x, points in self.stations
        )
        return Offsets(stations=stations, draught=self.draught * factor, length=self.length * factor)


@dataclass(frozen=True, kw_only=True)
class PanelMesh(HullShape):
    """A hull as a mesh of panels with normals into the water, the whole of one hull.

    Parameters
    ----------
    vertices : tuple of (x, y, z) about the hull's own centre plane, z = 0 at its waterline [m].
    faces : tuple of three or four vertex numbers from 0, counter-clockwise seen from the water.
    length : of the waterline [m].
    draught : design draught [m]; where not given, the depth of the lowest vertex.

    Notes
    -----
    The mesh may be open at and above the waterline. Triangles are kept as four
    numbers with the last repeated.
    """

    kind: ClassVar[str] = "mesh"
    vertices: tuple
    faces: tuple
    length: float
    draught: float | None = None

    def __post_init__(self) -> None:
        set_number(self, "length", "hull length", "m", at_least=LENGTH_RANGE[0], at_most=LENGTH_RANGE[1])
        vertices, faces = checked_mesh(self.vertices, self.faces)
        object.__setattr__(self, "vertices", vertices)
        object.__setattr__(self, "faces", faces)
        if self.draught is None:
            object.__setattr__(self, "draught", -min(z for _, _, z in vertices))
        set_number(self, "draught", "hull draught", "m", at_least=DRAUGHT_RANGE[0], at_most=DRAUGHT_RANGE[1])
        extent = max(x for x, _, _ in vertices) - min(x for x, _, _ in vertices)
        if not 0.8 * self.length <= extent <= 1.5 * self.length:
            raise InputError(
                f"panel mesh must be 0.8 to 1.5 times as long as the hull length ({self.length:g} m), "
                f"got {extent:g} m; check the unit of the mesh and the length."
            )

    @property
    def beam(self) -> float:  # type: ignore[override]
        """Largest breadth at or below the waterline [m]."""
        wet = {index for face in self.faces for index in face if min(self.vertices[k][2] for k in face) < 0.0}
        return 2.0 * max(abs(self.vertices[k][1]) for k in wet)

    @property
    def depth(self) -> float:  # type: ignore[override]
        """Height of the highest vertex above the keel [m]."""
        return max(z for _, _, z in self.vertices) + self.draught

    def scaled(self, factor: float) -> "PanelMesh":
        """Return the geometrically similar shape, `factor` times as long."""
        factor = checked_number("scale factor", factor, above=0.0)
        vertices = tuple((x * factor, y * factor, z * factor) for x, y, z in self.vertices)
        return PanelMesh(
            vertices=vertices, faces=self.faces, length=self.length * factor, draught=self.draught * factor
        )
