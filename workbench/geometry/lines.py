"""Lines of any hull shape, and where each hull of the ship lies."""

import math
from dataclasses import dataclass
from functools import lru_cache, singledispatch

import numpy as np
from scipy.optimize import brentq

from workbench.design import Hull
from workbench.errors import InputError
from workbench.hulls.families.fine_form import fine_form_lines
from workbench.hulls.families.heavy_lift_box import heavy_lift_box_lines
from workbench.hulls.families.offsets import offsets_lines
from workbench.hulls.families.wigley import wigley_lines
from workbench.hulls.lines import Lines, evenly_spaced, wetted_part
from workbench.shapes import HeavyLiftBox, HullShape, Offsets, RoundBilge, SemiSwath, SlenderRacing, Wigley

PORT, STARBOARD, CENTRE = 0, 1, 2
"""Number of each hull in `hull_positions`; a single hull is number 0."""


@lru_cache(maxsize=64)
def lines(shape: HullShape) -> Lines:
    """Half surface of a hull shape about its own centre plane, keel to deck edge."""
    return _lines(shape)


@singledispatch
def _lines(shape: HullShape) -> Lines:
    raise InputError(
        f"lines need a hull with stations, got a {shape.kind}; use offsets or a parametric family."
    )


@_lines.register
def _(shape: Wigley) -> Lines:
    return wigley_lines(shape.length, shape.beam, shape.draught, shape.depth)


@_lines.register(RoundBilge)
@_lines.register(SemiSwath)
@_lines.register(SlenderRacing)
def _(shape) -> Lines:
    return fine_form_lines(shape.form, shape.length, shape.beam, shape.draught)


@_lines.register
def _(shape: HeavyLiftBox) -> Lines:
    return heavy_lift_box_lines(
        shape.length,
        shape.beam,
        shape.draught,
        shape.depth,
        shape.bilge_radius,
        shape.bow_length,
        shape.stern_length,
    )


@_lines.register
def _(shape: Offsets) -> Lines:
    return offsets_lines(shape.stations, shape.draught)


def hull_positions(hull: Hull) -> tuple[tuple[float, float], ...]:
    """Position (x, y) [m] of each hull's own axes: one hull; port, starboard; port, starboard, centre.

    Heel brings the centre planes of the outer hulls together by cos(heel).
    """
    y = hull.spacing / 2 * math.cos(hull.heel)
    outer = ((0.0, y), (0.0, -y))
    return {1: ((0.0, 0.0),), 2: outer, 3: (*outer, (hull.centre_x, 0.0))}[hull.count]


def hull_shape(hull: Hull, index: int) -> HullShape:
    """Shape of hull number `index`, in the order of `hull_positions`."""
    if not 0 <= index < hull.count:
        raise InputError(f"hull number must be 0 to {hull.count - 1}, got {index}; count from 0.")
    return hull.centre_shape if index == CENTRE and hull.centre_shape is not None else hull.shape


def is_symmetric(hull: Hull) -> bool:
    """Whether the wetted ship is its own mirror image in y = 0."""
    return hull.heel == 0.0


@dataclass(frozen=True, eq=False)
class FloatingHull:
    """One hull in the attitude of the ship; contours in ship axes.

    Heel is a rotation about x. Trim is a shear, z - x tan(trim), good to 0.5 %
    of a length up to 6 degrees: stations stay where they are.
    """

    lines: Lines
    x: float
    y: float
    heel: float
    trim: float
    sinkage: float

    def contours(self, x, whole: bool) -> np.ndarray:
        """Contours (len(x), points, 2) of (y, z) [m] at ship stations x [m].

        The whole contour runs from the starboard deck edge under the keel to
        the port one, in ship axes; the half contour from the keel to the port
        deck edge, y from the hull's own centre plane (upright hulls only).
        """
        x = np.asarray(x, float)
        y, z = self.lines.contours(x - self.x)
        if whole:
            y = np.concatenate([-y[:, :0:-1], y], axis=1) + self.y
            z = np.concatenate([z[:, :0:-1], z], axis=1)
        cosine, sine = math.cos(self.heel), math.sin(self.heel)
        y, z = y * cosine - z * sine, y * sine + z * cosine
        return np.stack([y, z - (x * math.tan(self.trim))[:, None] - self.sinkage], axis=-1)

    @property
    def lowest_point(self) -> float:
        """Height of the lowest point above still water [m]."""
        return float(self.contours(self.lines.x + self.x, whole=self.heel != 0.0)[..., 1].min())

    def wetted_ends(self) -> tuple[float, float]:
        """Ends (aft, fore) [m] of the wetted length: where the keel meets the water, or the hull ends."""
        first, last = self.lines.x[0] + self.x, self.lines.x[-1] + self.x
        x = np.unique(np.concatenate([np.linspace(first, last, 201), self.lines.x + self.x]))

        def lowest(at):
            return self.contours(np.atleast_1d(at), whole=self.heel != 0.0)[..., 1].min(axis=1)

        depth = lowest(x)
        deepest = int(np.argmin(depth))
        size = last - first
        if depth[deepest] >= -1e-6 * size:
            raise InputError(
                f"hull at y = {self.y:g} m must reach the water, its lowest point is {depth[deepest]:g} m "
                "above still water; reduce heel, trim or rise."
            )
        ends = []
        for step, end in ((-1, first), (1, last)):
            dry = np.flatnonzero(depth[deepest::step] >= 0.0)
            if not dry.size:
                ends.append(float(end))
                continue
            k = deepest + step * int(dry[0])
            ends.append(float(brentq(lambda at: float(lowest(at)[0]), x[k - step], x[k], xtol=1e-9 * size)))
        return ends[0], ends[1]

    def wetted_grid(self, x, points: int, whole: bool) -> np.ndarray:
        """Grid (len(x), points, 3) over the wetted surface [m]: evenly spaced along each wetted contour."""
        x = np.asarray(x, float)
        grid = np.empty((len(x), points, 3))
        for k, contour in enumerate(self.contours(x, whole)):
            wetted = wetted_part(contour)
            if wetted is None:  # an end of the waterline: the contour has shrunk to its lowest point
                wetted = np.array([[contour[np.argmin(contour[:, 1]), 0], 0.0]] * 2)
            if wetted[-1, 1] < 0.0 or (whole and wetted[0, 1] < 0.0):
                raise InputError(
                    f"deck edge of the hull must stay above water, it is immersed at x = {x[k]:g} m; "
                    "reduce heel, trim or sinkage, or give the hull more depth."
                )
            grid[k, :, 0] = x[k]
            grid[k, :, 1:] = evenly_spaced(wetted, points)
            grid[k, -1, 2] = 0.0
        return grid


def floating_hull(hull: Hull, index: int) -> FloatingHull:
    """Hull number `index` of the ship in the attitude in which it floats."""
    x, y = upright_position(hull, index)
    return FloatingHull(lines(hull_shape(hull, index)), x, y, hull.heel, hull.trim, hull.sinkage)


def upright_position(hull: Hull, index: int) -> tuple[float, float]:
    """Position (x, y) [m] of the axes of hull number `index` in the ship before it heels."""
    x = hull_positions(hull)[index][0]
    return x, 0.0 if hull.count == 1 else (hull.spacing / 2, -hull.spacing / 2, 0.0)[index]


def station_positions(aft: float, fore: float, count: int) -> np.ndarray:
    """Stations x (count,) from aft to fore [m], closer at the ends: half even, half cosine spacing."""
    even = np.linspace(0.0, 1.0, count)
    return aft + (fore - aft) * (0.5 * even + 0.25 * (1 - np.cos(np.pi * even)))
