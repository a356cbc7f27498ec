"""Grids of the non-linear water entry: body, cut through the jet, free surface; in coordinates fixed to the body."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from workbench.errors import InputError
from workbench.impact.section import Circle, Section, TableSection, Wedge

FINE, GROWTH = 0.25, 0.13
"""Element at the spray root over the thickness of Wagner's jet, and growth of the elements per distance from it."""

JET = 3.0
"""Length of jet that is kept outside the spray root, over the thickness of Wagner's jet."""

THICKEST = 0.08
"""Largest thickness of the jet that the elements follow, over the half-breadth."""

PARALLEL = np.radians(20.0)
"""Largest angle between free surface and body where the jet may be cut."""

NEAREST_EDGE, EDGE = 12.0, 16.0
"""The free surface is carried on to the second multiple of the half-breadth once its edge falls below the first."""

APEX, LARGEST = 0.012, 0.1
"""Element at the lowest point, and largest on the body, over the half-breadth."""

BISECTIONS, SAMPLES, MOST = 44, 600, 2000


class Grading(NamedTuple):
    """Sizes of elements at the spray root and the lowest point, largest on the body, length of jet that is kept [m]."""

    root: float
    apex: float
    largest: float
    jet: float


def grading(section: Section, breadth: float) -> Grading:
    """Return the sizes of elements for a spray root at a half-breadth [m].

    Wagner's jet is tan(beta)**2/(2 pi) as thick as the half-breadth; beta is that of the wedge whose
    spray root is as fast.
    """
    slope = np.pi / 2 * section.mean_slope(breadth)
    thickness = breadth * slope**2 / (2 * np.pi * np.hypot(1, slope))
    root = FINE * min(thickness, THICKEST * breadth)
    return Grading(root, max(APEX * breadth, root), LARGEST * breadth, JET * thickness)


def marched(length: float, size) -> np.ndarray:
    """Return points from 0 to the length [m] whose distances follow ``size(place)`` [m]."""
    found = [0.0]
    while found[-1] < length and len(found) < MOST:
        at = found[-1]
        found.append(at + size(min(at + size(at) / 2, length)))
    if len(found) > 2 and found[-1] - length > (found[-1] - found[-2]) / 2:
        found.pop()
    return np.array(found) * (length / found[-1])


def nearest(section: Section, points: np.ndarray) -> np.ndarray:
    """Half-breadth of the point of a section nearest to each point outside it [m].

    Parameters
    ----------
    points : complex, y + i z from the lowest point [m].
    """
    y, z = points.real, points.imag
    if isinstance(section, Wedge):
        angle = section.deadrise_angle
        return np.maximum(np.cos(angle) * (y * np.cos(angle) + z * np.sin(angle)), 0.0)
    if isinstance(section, Circle):
        return section.radius * y / np.abs(points - 1j * section.radius)
    if isinstance(section, TableSection):
        corners = on_section(section, np.array([at for at, _ in section.points]))
        steps = np.diff(corners)
        share = ((points[:, None] - corners[:-1]) / steps).real
        feet = corners[:-1] + np.clip(share, 0.0, 1.0) * steps
        closest = np.argmin(np.abs(points[:, None] - feet), axis=1)
        return feet.real[np.arange(len(y)), closest]
    low, high = np.zeros(len(y)), y.copy()
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        past = middle - y + (section.height(middle) - z) * section.slope(middle) > 0
        low, high = np.where(past, low, middle), np.where(past, middle, high)
    return (low + high) / 2


def on_section(section: Section, breadth):
    """Point y + i z of the section at a half-breadth [m]."""
    return breadth + 1j * section.height(breadth)


def along_section(section: Section, breadth):
    """Unit tangent of the section outwards at a half-breadth, complex."""
    tangent = 1 + 1j * section.slope(breadth)
    return tangent / np.abs(tangent)


def corners_within(section: Section, breadth: float) -> list[float]:
    """Half-breadths of the corners of a table inside a half-breadth [m]."""
    return [y for y, _ in section.points[1:-1] if y < breadth] if isinstance(section, TableSection) else []


def body_nodes(section: Section, breadth: float, sizes: Grading) -> np.ndarray:
    """Return the nodes of the wetted side from the lowest point to a half-breadth [m]; a node at every corner."""
    corners = [0.0, *corners_within(section, breadth - sizes.root / 2)]
    fine = np.unique(np.concatenate([breadth * np.linspace(0, 1, SAMPLES), corners]))
    arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(on_section(section, fine))))])
    ends = np.interp([*corners, breadth], fine, arc)
    total = float(ends[-1])
    places = []
    for inner, outer in pairwise(ends):

        def size(at, outer=float(outer)):
            behind = total - outer + at
            return min(
                sizes.root + GROWTH * max(behind - 4 * sizes.root, 0.0),
                sizes.apex + GROWTH * max(total - behind, 0.0),
                sizes.largest,
            )

        places.append(outer - marched(outer - inner, size)[:0:-1])
    y = np.interp(np.concatenate([*places, [total]]), arc, fine)
    y[0] = 0.0
    return on_section(section, y)


class Surface(NamedTuple):
    """Free surface from the cut through the jet outwards.

    ``points`` y + i z from the lowest point [m], ``potential`` [m2/s]; ``root`` half-breadth of the
    spray root, where the surface is at right angles to the section [m]; ``lost`` area cut off with the jet [m2].
    """

    points: np.ndarray
    potential: np.ndarray
    root: float
    lost: float = 0.0


class Slopes(NamedTuple):
    """Along a free surface: unit tangent outwards (complex) and derivative of the potential [m/s]."""

    tangent: np.ndarray
    along: np.ndarray


def spline(surface: Surface) -> tuple[CubicSpline, np.ndarray]:
    """Return the spline of (y, z, potential) over the length of the chords, and that length at the points."""
    arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(surface.points)))])
    return CubicSpline(
        arc, np.column_stack([surface.points.real, surface.points.imag, surface.potential])
    ), arc


def slopes(surface: Surface) -> Slopes:
    """Return tangent and derivative of the potential at the points of a surface."""
    curve, arc = spline(surface)
    by_chord = curve(arc, 1)
    tangent = by_chord[:, 0] + 1j * by_chord[:, 1]
    length = np.abs(tangent)
    return Slopes(tangent / length, by_chord[:, 2] / length)


def regridded(surface: Surface, section: Section, level: float) -> Surface:
    """Return a surface with its jet cut, its points graded and its edge carried on.

    Parameters
    ----------
    surface : as it was moved; section : what enters; level : height of calm water above the lowest point [m].
    """
    curve, arc = spline(surface)
    near = arc[surface.points.real < 3 * surface.points[0].real]
    fine = np.sort(np.concatenate([near, (near[1:] + near[:-1]) / 2]))
    values, by_chord = curve(fine), curve(fine, 1)
    points = values[:, 0] + 1j * values[:, 1]
    foot = nearest(section, points)
    thickness = np.abs(points - on_section(section, foot))
    inwards = -(by_chord[:, 0] + 1j * by_chord[:, 1])
    angle = np.abs(np.angle(inwards / along_section(section, foot)))
    in_jet = np.flatnonzero(angle < np.pi / 2)
    if in_jet.size == 0 or not np.all(np.isfinite(points)):
        raise InputError(
            f"The spray root was lost at a penetration of {level:g} m; take the generalised Wagner model."
        )
    root = int(in_jet[-1])
    pair = slice(root, root + 2)
    breadth_at_root = float(np.interp(np.pi / 2, angle[pair], foot[pair]))
    sizes = grading(section, breadth_at_root)
    outside = fine[root] - fine
    thin = ((outside > sizes.jet) & (angle < PARALLEL)) | (
        (outside > 3 * sizes.root) & (thickness < 0.8 * sizes.root)
    )
    cuts = np.flatnonzero(thin[: root + 1])
    cut = int(cuts[-1]) if cuts.size else 0
    jet = fine[root] - fine[cut]
    places = fine[cut] + marched(
        arc[-1] - fine[cut], lambda at: sizes.root + GROWTH * max(at - jet - 3 * sizes.root, 0.0)
    )
    places[-1] = arc[-1]
    new = curve(places)
    moved, potential = new[:, 0] + 1j * new[:, 1], new[:, 2]
    breadth, edge = moved[0].real, moved[-1].real
    if edge < NEAREST_EDGE * breadth:
        # beyond its edge the surface is that of a dipole, which rises as 1/y**2
        last = places[-1] - places[-2]
        more = edge + marched(EDGE * breadth - edge, lambda at: last + GROWTH * at)[1:]
        rise = moved[-1].imag - level
        moved = np.concatenate([moved, more + 1j * (level + rise * (edge / more) ** 2)])
        potential = np.concatenate([potential, potential[-1] * (edge / more) ** 4])
    removed = np.concatenate([points[: cut + 1], on_section(section, foot[[cut, 0]])])
    area = abs(np.sum(removed * np.conj(np.roll(removed, 1))).imag) / 2 if cut else 0.0
    return Surface(moved, potential, breadth_at_root, surface.lost + float(area))
