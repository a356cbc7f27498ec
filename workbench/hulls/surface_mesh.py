"""Meshes of triangles and quadrilaterals as hulls: cutting at the water, and what they must be."""

import numpy as np

from workbench.errors import InputError

LARGEST_MESH = 200_000


def below_water(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Part of a mesh below z = 0: vertices (n, 3), faces (m, 4), in the same sense of rotation.

    Faces across the water surface are cut; a triangle repeats its last index.
    """
    height = vertices[faces][..., 2]
    tolerance = 1e-9 * float(np.ptp(vertices, axis=0).max())
    wet = (height <= tolerance).all(axis=1)
    crossing = ~wet & (height < -tolerance).any(axis=1)
    points, made = [vertices], [faces[wet & (height < -tolerance).any(axis=1)]]
    total = len(vertices)
    for face in faces[crossing]:
        polygon = _cut(vertices[_distinct(face)])
        if len(polygon) < 3:
            continue
        points.append(polygon)
        fan = [(total, total + k, total + k + 1, total + k + 1) for k in range(1, len(polygon) - 1)]
        if len(polygon) == 4:
            fan = [(total, total + 1, total + 2, total + 3)]
        made.append(np.array(fan))
        total += len(polygon)
    return np.concatenate(points), np.concatenate(made)


def _distinct(face: np.ndarray) -> list[int]:
    """Return the corners of a face without repetitions."""
    return list(dict.fromkeys(int(index) for index in face))


def _cut(polygon: np.ndarray) -> np.ndarray:
    """Return the part of a polygon (n, 3) with z <= 0."""
    kept = []
    for this, following in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        if this[2] <= 0.0:
            kept.append(this)
        if (this[2] < 0.0 < following[2]) or (following[2] < 0.0 < this[2]):
            wet, dry = (this, following) if this[2] < 0.0 else (following, this)
            share = wet[2] / (wet[2] - dry[2])  # from the wet end always: neighbours cut at the same point
            kept.append(np.array([*(wet[:2] + share * (dry[:2] - wet[:2])), 0.0]))
    return np.array(kept)


def checked_mesh(vertices: object, faces: object) -> tuple[tuple, tuple]:
    """Return vertices and faces as tuples, or raise `InputError` saying what is wrong with the mesh.

    Faces have three or four corners; four are returned, a triangle repeating
    its last. Coincident vertices are merged. The part under water must be
    closed, have volume, and look outwards.
    """
    points, corners = _as_arrays(vertices, faces)
    points, corners = _merged(points, corners)
    if not (points[corners][..., 2] < 0.0).any():
        lowest = points[:, 2].min()
        raise InputError(
            f"panel mesh must reach below still water at z = 0, its lowest point is z = {lowest:g} m; "
            "move it down so that z = 0 is its waterline."
        )
    doubled = np.array([len(_distinct(face)) < 3 for face in corners])
    area = np.linalg.norm(_area_vectors(points, corners), axis=1)
    size = float(np.ptp(points, axis=0).max())
    bad = np.flatnonzero(doubled | (area <= 1e-12 * size**2))
    if bad.size:
        raise InputError(
            f"panel mesh must have no panels without area, got {bad.size} (the first is number {bad[0]}); "
            "remove them, for instance by merging close vertices."
        )
    wet_points, wet_faces = _merged(*below_water(points, corners))
    check_closed(wet_points, wet_faces)
    normal = _area_vectors(wet_points, wet_faces)
    volume = float(np.sum(normal[:, 2] * wet_points[wet_faces][..., 2].mean(axis=1)))
    if volume <= 0.0:
        raise InputError(
            f"normals of the panel mesh must point into the water, got a volume of {volume:g} m3; "
            "reverse the order of the corners of every panel."
        )
    return tuple(map(tuple, points.tolist())), tuple(map(tuple, corners.tolist()))


def _as_arrays(vertices: object, faces: object) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices (n, 3) float and faces (m, 4) int."""
    try:
        points = np.array(vertices, float)
    except (TypeError, ValueError):
        points = np.empty(0)
    if points.ndim != 2 or points.shape[1] != 3 or not len(points):
        raise InputError(
            "vertices of the panel mesh must be rows of three numbers x, y, z; give at least three."
        )
    if not np.isfinite(points).all():
        raise InputError(
            "vertices of the panel mesh must be finite numbers, got NaN or infinity; repair the file."
        )
    try:
        rows = [tuple(int(index) for index in face) for face in faces]  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        rows = []
    if not rows or any(len(row) not in (3, 4) for row in rows):
        raise InputError(
            "faces of the panel mesh must be rows of three or four vertex numbers; give at least one."
        )
    if len(rows) > LARGEST_MESH:
        raise InputError(
            f"panel mesh must have at most {LARGEST_MESH} panels, got {len(rows)}; thin it out first."
        )
    corners = np.array([(*row, row[-1])[:4] for row in rows])
    if corners.min() < 0 or corners.max() >= len(points):
        raise InputError(
            f"vertex numbers of the panel mesh must be 0 to {len(points) - 1}, got {corners.min()} to "
            f"{corners.max()}; vertices are counted from 0."
        )
    return points, corners


def _merged(points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the mesh with coincident vertices merged and unused ones left out."""
    size = float(np.ptp(points, axis=0).max()) or 1.0
    keys = np.round(points / (1e-7 * size)).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    faces = inverse.reshape(-1)[faces]
    used = np.unique(faces)
    return points[first][used], np.searchsorted(used, faces)


def _area_vectors(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the area vectors (m, 3)."""
    a, b, c, d = np.moveaxis(points[faces], 1, 0)
    return np.cross(c - a, d - b) / 2


def check_closed(points: np.ndarray, faces: np.ndarray, tolerance: float = 1e-5) -> None:
    """Raise `InputError` if a wetted surface has open edges below the water, or faces that disagree.

    Edges that lie no deeper than `tolerance` times the size of the mesh are let pass.
    """
    pairs = np.concatenate(
        [np.stack([faces[:, k], np.roll(faces, -1, axis=1)[:, k]], axis=1) for k in range(4)]
    )
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    edges, inverse, count = np.unique(np.sort(pairs, axis=1), axis=0, return_inverse=True, return_counts=True)
    size = float(np.ptp(points, axis=0).max())
    under = (points[edges][..., 2] < -tolerance * size).any(axis=1)
    holes = np.flatnonzero((count == 1) & under)
    if holes.size:
        x, y, z = points[edges[holes[0]]].mean(axis=0)
        raise InputError(
            f"panel mesh must be closed below the waterline, got {holes.size} open edges, one near "
            f"({x:.3g}, {y:.3g}, {z:.3g}) m; close the holes and join the panels at their corners "
            "(give the whole hull, not its half)."
        )
    direction = np.where(pairs[:, 0] < pairs[:, 1], 1, -1)
    balance = np.bincount(inverse.reshape(-1), weights=direction, minlength=len(edges))
    if ((count == 2) & (balance != 0.0) & under).any():
        raise InputError(
            "panels of the mesh must all be ordered the same way round, some neighbours are opposed; "
            "make the normals consistent, pointing into the water."
        )
