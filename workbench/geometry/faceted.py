"""A wetted surface of flat-edged panels: `Panels`, its areas, normals and moments."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np


@dataclass(frozen=True, eq=False)
class Panels:
    """Panels of the wetted surface.

    Parameters
    ----------
    vertices : (nv, 3) [m].
    faces : (nf, 4) indices of vertices, counter-clockwise seen from the water (normals point into
        the water); a triangle repeats an index.
    is_transom : (nf,) whether the panel closes a transom.
    mirrored : whether the faces are the half y > 0 and the other half is their mirror image.
    """

    vertices: np.ndarray
    faces: np.ndarray
    is_transom: np.ndarray
    mirrored: bool

    def __len__(self) -> int:
        """Return the number of faces of the half, or of the whole if it is not mirrored."""
        return len(self.faces)

    @cached_property
    def triangles(self) -> np.ndarray:
        """Corners (2 nf, 3, 3) of the two triangles of every face [m]."""
        corners = self.vertices[self.faces]
        return np.concatenate([corners[:, (0, 1, 2)], corners[:, (0, 2, 3)]])

    @cached_property
    def area_vectors(self) -> np.ndarray:
        """Area vectors (2 nf, 3) of the triangles, outward [m2]."""
        a, b, c = np.moveaxis(self.triangles, 1, 0)
        return np.cross(b - a, c - a) / 2

    @cached_property
    def areas(self) -> np.ndarray:
        """Areas (nf,) [m2]."""
        return np.linalg.norm(self.area_vectors, axis=1).reshape(2, -1).sum(axis=0)

    @cached_property
    def centres(self) -> np.ndarray:
        """Centres (nf, 3) of area [m]."""
        weights = np.linalg.norm(self.area_vectors, axis=1)[:, None] * self.triangles.mean(axis=1)
        return weights.reshape(2, -1, 3).sum(axis=0) / self.areas[:, None]

    @cached_property
    def normals(self) -> np.ndarray:
        """Unit normals (nf, 3), into the water."""
        total = self.area_vectors.reshape(2, -1, 3).sum(axis=0)
        return total / np.linalg.norm(total, axis=1)[:, None]

    @cached_property
    def radius(self) -> np.ndarray:
        """Largest distance (nf,) of a corner from the centre of its panel [m]."""
        return np.linalg.norm(self.vertices[self.faces] - self.centres[:, None], axis=2).max(axis=1)

    @property
    def volume(self) -> float:
        """Volume of the whole ship below still water [m3]."""
        return float((2.0 if self.mirrored else 1.0) * self.moment(lambda x, y, z: -z))

    def moment(self, integrand) -> float:
        """Integral over these faces of integrand(x, y, z) times minus the vertical area, exact to degree two.

        The area is that of the faces projected on the waterplane, positive where the surface looks down.
        """
        corners = self.triangles
        middles = (corners + np.roll(corners, 1, axis=1)) / 2
        values = integrand(*np.moveaxis(middles, -1, 0)).mean(axis=1)
        return float(np.sum(-self.area_vectors[:, 2] * values))

    def mirrored_image(self) -> "Panels":
        """Return the mirror image of these faces in y = 0."""
        return Panels(
            self.vertices * np.array([1.0, -1.0, 1.0]),
            turned_faces(self.faces),
            self.is_transom,
            self.mirrored,
        )

    def whole(self) -> "Panels":
        """Return all faces of the ship, without symmetry."""
        if not self.mirrored:
            return self
        half = Panels(self.vertices, self.faces, self.is_transom, False)
        return joined([half, half.mirrored_image()], mirrored=False)

    def translated(self, x: float = 0.0, y: float = 0.0) -> "Panels":
        """Return the panels moved along x and y [m]."""
        return Panels(self.vertices + np.array([x, y, 0.0]), self.faces, self.is_transom, self.mirrored)


def joined(parts: list[Panels], mirrored: bool) -> Panels:
    """Return the panels of all parts as one."""
    starts = np.cumsum([0, *(len(part.vertices) for part in parts)])
    return Panels(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.faces + start for part, start in zip(parts, starts[:-1], strict=True)]),
        np.concatenate([part.is_transom for part in parts]),
        mirrored,
    )


def cleaned(vertices: np.ndarray, faces: np.ndarray, is_transom: np.ndarray, mirrored: bool) -> Panels:
    """Return Panels without coincident vertices and without faces of no area."""
    size = float(np.ptp(vertices, axis=0).max())
    _, first, merged = np.unique(
        np.round(vertices / (1e-8 * size)).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    made = Panels(vertices[first], merged.reshape(-1)[faces], is_transom, mirrored)
    thin = made.areas <= 1e-9 * size * np.linalg.norm(np.ptp(vertices, axis=0)[1:])
    made = Panels(made.vertices, made.faces[~thin], is_transom[~thin], mirrored)
    used = np.unique(made.faces)
    renumbered = np.searchsorted(used, made.faces)
    return Panels(made.vertices[used], _triangles_last(renumbered), made.is_transom, mirrored)


def _triangles_last(faces: np.ndarray) -> np.ndarray:
    """Return the faces with the repeated corner of every triangle in the last place."""
    faces = faces.copy()
    for k in range(3):
        repeated = faces[:, k] == faces[:, k + 1]
        faces[repeated] = np.roll(faces[repeated], 2 - k, axis=1)
    return faces


def turned_faces(faces: np.ndarray) -> np.ndarray:
    """Return the faces the other way round, with the same diagonal, so that a mirror image is exact."""
    turned = faces[:, [0, 3, 2, 1]]
    triangles = faces[:, 2] == faces[:, 3]
    turned[triangles] = faces[triangles][:, [0, 2, 1, 1]]
    return turned


def grid_faces(rows: int, columns: int, start: int = 0) -> np.ndarray:
    """Faces ((rows-1)(columns-1), 4) of a grid of points: rows along x, columns keel to waterline to port."""
    index = start + np.arange(rows * columns).reshape(rows, columns)
    corners = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    return np.stack([corner.ravel() for corner in corners], axis=1)
