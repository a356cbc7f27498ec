"""Added mass, damping and wave forces of a single two-dimensional section, or of several side by side.

For one section at a time, given as points and checked; ships go through `strip_theory`.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from workbench.conventions import wavenumber
from workbench.errors import InputError, checked_number
from workbench.hulls.lines import evenly_spaced
from workbench.hydrodynamics.section_waves import Waves, froude_krylov_density, haskind_density, orbital_decay
from workbench.hydrodynamics.sections import (
    SectionStack,
    radiation_potentials,
    sectional_matrix,
    stack,
    wetted_panels,
)

LOWEST_REDUCED = 1e-7
"""Wavenumber times breadth that stands for omega = 0."""


class SectionCoefficients(NamedTuple):
    """Added mass and damping per length over (omega, 3, 3): sway, heave, roll [kg/m ..., kg/(m s) ...]."""

    added_mass: np.ndarray
    damping: np.ndarray


class SectionForces(NamedTuple):
    """Froude-Krylov and diffraction force per length and wave amplitude (omega, 3) [N/m2, N/m2, N/m]."""

    froude_krylov: np.ndarray
    diffraction: np.ndarray


def checked_contour(points, name: str = "section") -> np.ndarray:
    """Contour (n, 2) of (y, z) [m] from starboard round the keel to port, or an `InputError`.

    Parameters
    ----------
    points : either way round; open with both ends at the surface z = 0, or closed under water
        (the first point repeated at the end).
    """
    try:
        contour = np.asarray(points, float)
    except (TypeError, ValueError):
        contour = np.empty(0)
    if contour.ndim != 2 or contour.shape[1] != 2 or not np.all(np.isfinite(contour)):
        raise InputError(f"{name} must be a list of points (y, z) in metres, all finite numbers.")
    if len(contour) < 4:
        raise InputError(f"{name} must have at least 4 points, got {len(contour)}; give more points.")
    size = float(np.ptp(contour, axis=0).max())
    if size == 0.0:
        raise InputError(f"{name} must have a breadth or a depth, got one point {len(contour)} times.")
    highest = contour[:, 1].max()
    if highest > 1e-6 * size:
        raise InputError(
            f"{name} must lie under water, z <= 0, got a point at z = {highest:g} m; cut it at the waterline."
        )
    if _crosses_itself(contour):
        raise InputError(f"{name} must not cross itself; give its points in order along the contour.")
    closed = np.allclose(contour[0], contour[-1], atol=1e-9 * size)
    if closed and contour[:, 1].max() > -1e-6 * size:
        raise InputError(f"{name} must be open at the surface, or wholly under water when closed.")
    if not closed and contour[[0, -1], 1].min() < -1e-6 * size:
        raise InputError(
            f"{name} must begin and end at the waterline z = 0, or return to its first point under water."
        )
    y, z = contour.T
    if closed:
        turning = np.sum(y[:-1] * z[1:] - y[1:] * z[:-1])
        return contour if turning > 0 else contour[::-1]
    contour = np.minimum(contour, [np.inf, 0.0])
    contour[[0, -1], 1] = 0.0
    return contour if y[-1] >= y[0] else contour[::-1]


def _crosses_itself(contour: np.ndarray) -> bool:
    """Whether two sides of a polyline that are not neighbours cross."""
    start, step = contour[:-1], np.diff(contour, axis=0)

    def cross(a, b):
        return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]

    offset = start[None] - start[:, None]
    slant = cross(step[:, None], step[None])
    with np.errstate(divide="ignore", invalid="ignore"):
        along, across = cross(offset, step[None]) / slant, cross(offset, step[:, None]) / slant
    far = np.abs(np.subtract.outer(np.arange(len(step)), np.arange(len(step)))) > 1
    inside = (along > 1e-9) & (along < 1 - 1e-9) & (across > 1e-9) & (across < 1 - 1e-9)
    return bool(np.any(far & inside & (slant != 0)))


def section_stack(contours: Sequence, panels: int = 60, mirrored: bool = False) -> SectionStack:
    """One section of one or several contours, checked and panelled evenly along them.

    Parameters
    ----------
    contours : for each hull its points (y, z) [m]; with ``mirrored`` only those of the hulls at y > 0.
    """
    panels = int(checked_number("number of panels of a section", panels, at_least=4, at_most=500))
    checked = [checked_contour(points, f"section {n}") for n, points in enumerate(contours, start=1)]
    if mirrored and min(contour[:, 0].min() for contour in checked) <= 0:
        raise InputError("mirrored sections must lie at y > 0; give the hull on the port side only.")
    if any(_overlap(a, b) for n, a in enumerate(checked) for b in checked[:n]):
        raise InputError("sections of different hulls must lie side by side, some overlap; move them apart.")
    return stack([evenly_spaced(contour, panels + 1)[None] for contour in checked], mirrored)


def _overlap(one: np.ndarray, other: np.ndarray) -> bool:
    low, high = np.maximum(one.min(axis=0), other.min(axis=0)), np.minimum(one.max(axis=0), other.max(axis=0))
    return bool(np.all(low < high))


def _about(centre: tuple[float, float]) -> np.ndarray:
    """Motions of the origin from motions of a point (y, z): columns sway, heave, roll there."""
    matrix = np.eye(3)
    matrix[0, 2], matrix[1, 2] = centre[1], -centre[0]
    return matrix


def section_coefficients(
    contours: Sequence,
    omega,
    *,
    density: float = 1025.0,
    panels: int = 60,
    mirrored: bool = False,
    centre: tuple[float, float] = (0.0, 0.0),
) -> SectionCoefficients:
    """Added mass and damping per length of a section, about a point.

    Parameters
    ----------
    contours : points (y, z) of each hull [m], as for `section_stack`.
    omega : frequencies [rad/s], 0 and infinity included.
    density : [kg/m3]; panels : on each contour; centre : (y, z) of the axis of roll [m].

    Notes
    -----
    At omega = 0 the added mass of motions that change the displaced area is infinite.
    Half-immersed circle with 100 panels: within 1 % of [Ursell1949]_ for ka 0.01 to 10.

    .. [Ursell1949] F. Ursell, "On the heaving motion of a circular cylinder on the surface of
        a fluid", Q. J. Mech. Appl. Math. 2, 218-231, 1949.
    """
    omega = np.atleast_1d(np.asarray(omega, float))
    if np.any(np.isnan(omega)) or np.any(omega < 0):
        raise InputError("omega of a section must be >= 0 rad/s; infinity is allowed.")
    checked_number("density", density, "kg/m3", above=0)
    sections = section_stack(contours, panels, mirrored)
    size = float(np.ptp(sections.segments.y)) + float(np.ptp(sections.segments.z))
    with np.errstate(over="ignore"):
        k = np.maximum(wavenumber(omega), LOWEST_REDUCED / size)
    wetted = wetted_panels(sections)
    lever = _about(centre)
    matrix = lever.T @ sectional_matrix(wetted, radiation_potentials(sections, k))[:, 0] @ lever
    added_mass = density * matrix.real
    moving = np.where(np.isfinite(omega), omega, 0.0)
    flux = (wetted.modes()[0] * wetted.length).sum(axis=-1) @ lever
    displacing = np.abs(flux) > 1e-6 * size
    added_mass[np.ix_(omega == 0, displacing, displacing)] = np.inf
    return SectionCoefficients(added_mass, density * moving[:, None, None] * matrix.imag)


def section_wave_forces(
    contours: Sequence,
    omega,
    wave_direction: float,
    *,
    encounter=None,
    density: float = 1025.0,
    panels: int = 60,
    mirrored: bool = False,
) -> SectionForces:
    """Wave forces per length about the origin, for a wave with its crest at the section's x and y = 0.

    Parameters
    ----------
    omega : wave frequencies [rad/s]; wave_direction : [rad].
    encounter : frequencies at which the section meets them [rad/s], > 0; None takes ``omega``.
    """
    omega = np.atleast_1d(np.asarray(omega, float))
    encounter = omega if encounter is None else np.atleast_1d(np.asarray(encounter, float))
    if encounter.shape != omega.shape or not np.all(np.isfinite(omega) & (omega > 0) & (encounter > 0)):
        raise InputError("omega and encounter frequencies of a section must be > 0 rad/s, and as many.")
    sections = section_stack(contours, panels, mirrored)
    wetted = wetted_panels(sections)
    waves = Waves(omega, np.full_like(omega, wave_direction), encounter)
    elevation = orbital_decay(wetted, np.zeros(1), waves)
    potential = radiation_potentials(sections, wavenumber(encounter))
    return SectionForces(
        density * froude_krylov_density(wetted, elevation)[:, 0],
        density * haskind_density(wetted, potential, elevation, waves)[:, 0],
    )
