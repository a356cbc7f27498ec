"""Panel meshes from files: STL, OBJ and what else meshio reads, and the GDF files of WAMIT.

[WAMIT] WAMIT User Manual, chapter 6: a Geometric Data File holds a title, ULEN and GRAV, the
    symmetries ISX and ISY, the number of panels, and four corners x, y, z of each panel,
    counter-clockwise seen from the water. ULEN only makes WAMIT's output dimensionless.
"""

from pathlib import Path

import numpy as np

from workbench.errors import InputError, checked_number
from workbench.shapes import PanelMesh

LARGEST_FILE = 50e6
"""Size of a mesh file above which it is not read [bytes]."""


def mesh_from_file(
    path: str | Path,
    *,
    length: float,
    draught: float | None = None,
    unit: float = 1.0,
    waterline: float = 0.0,
    midships: float = 0.0,
) -> PanelMesh:
    """Hull from a file of panels.

    Parameters
    ----------
    path : STL, OBJ, PLY, VTK ... or GDF file; the whole of one hull about its own centre plane.
    length, draught : of the hull [m].
    unit : length of one unit of the file [m].
    waterline, midships : z of the waterline and x of midships in the file, in its units.
    """
    path = Path(path)
    unit = checked_number("unit of the mesh", unit, "m", above=0.0)
    shift = np.array(
        [
            checked_number("x of midships in the mesh", midships),
            0.0,
            checked_number("z of the waterline in the mesh", waterline),
        ]
    )
    if not path.is_file():
        raise InputError(f"mesh file must exist, got {path}; check its name and folder.")
    if path.stat().st_size > LARGEST_FILE:
        raise InputError(
            f"mesh file must be smaller than {LARGEST_FILE / 1e6:g} MB, {path.name} has "
            f"{path.stat().st_size / 1e6:.0f} MB; thin the mesh out."
        )
    vertices, faces = (_read_gdf if path.suffix.lower() == ".gdf" else _read_with_meshio)(path)
    vertices = (np.asarray(vertices, float) - shift) * unit
    return PanelMesh(vertices=vertices.tolist(), faces=faces, length=length, draught=draught)


def _read_with_meshio(path: Path) -> tuple[np.ndarray, list]:
    """Return vertices and faces of a file that meshio knows."""
    import meshio  # here, because it takes a third of a second and few designs need it

    try:
        with np.errstate(all="ignore"):  # it takes the text of an ASCII STL for a number of triangles first
            mesh = meshio.read(path)
    except (Exception, SystemExit) as error:  # its readers raise whatever the bytes lead to
        raise InputError(
            f"mesh file must be a readable STL, OBJ, PLY, VTK or GDF file, {path.name} is not ({error}); "
            "write it anew."
        ) from None
    faces = [
        row
        for block in mesh.cells
        if block.type in ("triangle", "quad")
        for row in np.asarray(block.data).tolist()
    ]
    if mesh.points.ndim != 2 or mesh.points.shape[1] < 3:
        raise InputError(f"mesh file must have points x, y, z, {path.name} has others; write it anew.")
    if not faces:
        raise InputError(
            f"mesh file must hold triangles or quadrilaterals, {path.name} has none; export panels."
        )
    return mesh.points[:, :3], faces


def _read_gdf(path: Path) -> tuple[np.ndarray, list]:
    """Return vertices and faces of a low-order GDF file [WAMIT]_, with its mirror images."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    try:
        numbers = [float(word) for line in lines[1:] for word in line.split("!")[0].split()[:12]]
        _, _, mirror_x, mirror_y, count = numbers[:5]
        corners = np.array(numbers[5 : 5 + 12 * int(count)]).reshape(int(count), 4, 3)
    except (ValueError, IndexError):
        raise InputError(
            f"GDF file must hold a title, ULEN GRAV, ISX ISY, the number of panels and 12 numbers a panel, "
            f"{path.name} does not; write it anew as a low-order GDF file."
        ) from None
    for axis, mirrored in ((0, mirror_x), (1, mirror_y)):
        if mirrored:
            image = corners[:, ::-1].copy()
            image[..., axis] *= -1.0
            corners = np.concatenate([corners, image])
    return corners.reshape(-1, 3), np.arange(len(corners) * 4).reshape(-1, 4).tolist()
