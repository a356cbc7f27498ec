"""Start of the non-linear water entry at a small depth: the exact wedge, laid along the section.

The wedge is the one whose spray root moves as fast as the section's by Wagner's theory, at the same
half-breadth; there both flows are Wagner's inner flow. A wedge starts from its own exact solution.
"""

import numpy as np
from scipy.optimize import brentq

from workbench.errors import InputError
from workbench.impact.nonlinear_surface import (
    EDGE,
    JET,
    Surface,
    along_section,
    grading,
    nearest,
    on_section,
    regridded,
)
from workbench.impact.section import Circle, Parabola, Section, TableSection, Wedge, contact_half_breadth
from workbench.impact.similarity import similarity_solution

FLATTEST_START, STEEPEST_START = np.radians(8.0), np.radians(12.0)
"""Deadrise of the equivalent wedge between which a rounded section is started [rad]."""

EARLIER = 3.0
"""First instant over the depth of the start, at least."""

ROOM = 0.5
"""Share of the first piece of a table that the start may wet."""

SHARPEST = 1e-6
"""Distance between points of the exact surface that is resolved, over V t."""


ROOT = 4.0
"""Distance from the body within which the surface is laid along it, over the thickness of the jet."""

TIP_POINTS = 12
"""Points of the straight end of the jet."""

ANGLES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def equivalent_deadrise(section: Section, breadth: float) -> float:
    """Deadrise of the wedge whose spray root is as fast at that half-breadth: tan = (pi/2) V/c' [rad]."""
    return float(np.arctan(np.pi / 2 * section.mean_slope(breadth)))


def first_penetration(section: Section) -> float:
    """Smallest penetration of which the method can give an instant [m]; 0 for a section with a keel."""
    return EARLIER / 2 * _depth_of(section, FLATTEST_START) if _rounded(section) else 0.0


def _rounded(section: Section) -> bool:
    return isinstance(section, Parabola | Circle)


def _depth_of(section: Section, angle: float) -> float:
    """Penetration at which a rounded section has an equivalent wedge of that deadrise, by Wagner's theory [m]."""
    top = section.reach if np.isfinite(section.reach) else 10 * section.radius
    breadth = brentq(lambda c: equivalent_deadrise(section, c) - angle, 1e-9 * top, top)
    return float(section.mean_height(breadth))


def starting_penetration(section: Section, first: float) -> float:
    """Penetration to start from so that the first instant at a given one is free of the start [m]."""
    if isinstance(section, Wedge):
        return first / EARLIER
    if isinstance(section, TableSection):
        if section.slope(0.0) == 0:
            raise InputError(
                "The section has a flat bottom, from which the non-linear method cannot start; take "
                "generalised-wagner or give the bottom some deadrise."
            )
        solution = similarity_solution(equivalent_deadrise(section, section.points[1][0] * 1e-6))
        wet = np.cos(solution.deadrise_angle) * max(solution.peak_position * 1.1, solution.wall_length * 0.75)
        return min(first / EARLIER, ROOM * section.points[1][0] / wet)
    least = first_penetration(section)
    if first < least:
        raise InputError(
            f"The non-linear method cannot give a {section.kind} at a penetration of {first:g} m, where it is too "
            f"flat; take generalised-wagner there, or begin at {least:.4g} m."
        )
    return min(first / (EARLIER / 2), _depth_of(section, STEEPEST_START))


def _wagner_level(section: Section, y: np.ndarray, breadth: float) -> np.ndarray:
    """Level of the water at y >= c above the lowest point of the section by Wagner's theory [m].

    It is the integral of y/sqrt(y**2 - c**2) dh/dc over c, with c = y sin(theta).
    """
    ends = np.arcsin(np.minimum(breadth / y, 1.0))
    angle = ends[:, None] * (1 + ANGLES) / 2
    rate = np.array([[section.mean_slope(float(c)) for c in row] for row in y[:, None] * np.sin(angle)])
    return y * ends / 2 * (rate @ WEIGHTS)


def started(section: Section, penetration: float, velocity: float, deadrise: float | None = None) -> Surface:
    """Return the free surface at the start.

    Parameters
    ----------
    section : what enters; penetration : of its lowest point [m]; velocity : downwards [m/s].
    deadrise : of the wedge whose solution is taken [rad]; left out, the equivalent one.
    """
    breadth = contact_half_breadth(section, penetration, pile_up=True)
    angle = equivalent_deadrise(section, breadth) if deadrise is None else deadrise
    depth = 2 / np.pi * breadth * np.tan(angle)
    solution = similarity_solution(angle)
    tip = -1j + solution.wall_length * np.exp(1j * angle)
    straight = tip + (solution.surface[0] - tip) * np.linspace(0, 1, TIP_POINTS, endpoint=False)
    surface = np.concatenate([straight, solution.surface])
    kept = np.concatenate([[True], np.abs(np.diff(surface)) > SHARPEST])
    kept &= np.abs(surface) < EDGE * solution.wall_length
    arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(surface)))])
    # similar flow: phi/(V**2 t) = (|zeta|**2 - s**2)/2, s the arc from the jet tip
    potential = (depth * velocity * (np.abs(surface) ** 2 - arc**2) / 2)[kept]
    level = depth * surface[kept]
    points = level + 1j * depth
    wedge = Wedge(angle)
    foot = nearest(wedge, points)
    apart = np.abs(points - on_section(wedge, foot))
    on_body = np.minimum(foot, section.reach)
    laid = on_section(section, on_body) - 1j * apart * along_section(section, on_body)
    outside = np.maximum(level.real, breadth)
    shift = _wagner_level(section, outside, breadth) - penetration
    shift -= _wagner_level(wedge, outside, breadth) - depth
    free = level + 1j * (shift + penetration)
    weight = np.exp(-((apart / (ROOT * grading(section, breadth).jet / JET)) ** 2))
    made = Surface(weight * laid + (1 - weight) * free, potential, breadth)
    return regridded(made, section, penetration)
