"""Generalised Wagner model of any convex section, by a conformal map found for each wetted half-breadth.

The map is that of the wedge (`workbench.impact.generalised_wagner`) with a deadrise that varies along
the side: a polygon with a vertex between each two nodes (Schwarz-Christoffel), whose
angles follow from the section at the mapped nodes; a few rounds settle it.

.. [Zhao1996] R. Zhao, O. M. Faltinsen and J. V. Aarsnes, "Water entry of arbitrary two-dimensional
    sections with and without flow separation", 21st Symposium on Naval Hydrodynamics, 1996.
"""

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_simpson
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.optimize import brentq

from workbench.errors import InputError
from workbench.impact.logvinovich import largest
from workbench.impact.plate import Instant
from workbench.impact.section import Section, TableSection, contact_half_breadth

SIDE = np.arange(-16.0, 28.05, 0.1)
"""Nodes of the side, ln(w/(1 - w)), from the edge to the lowest point."""

LEVEL = np.arange(-22.0, 22.05, 0.1)
"""Nodes of the level of the edge, ln(psi), w = i psi."""

CELLS = 80
ROUNDS, SETTLED = 60, 1e-11
STEP = 1e-3
ROUNDING = 0.25


class _Map(NamedTuple):
    """Map for one wetted half-breadth c: ``scale`` C, and over the nodes of the side w, y, rise to the edge..."""

    scale: float
    w: np.ndarray
    y: np.ndarray
    drop: np.ndarray
    growth: np.ndarray
    angle: np.ndarray
    log_level: np.ndarray
    reached: np.ndarray


@cache
def _logarithms() -> tuple[np.ndarray, np.ndarray]:
    """ln|w**2 - w_j**2| at the nodes of side and level, for the vertices midway between nodes of the side."""
    vertices = (SIDE[1:] + SIDE[:-1]) / 2
    at_node, at_vertex = np.exp(-SIDE), np.exp(-vertices)
    w, w_vertex = 1 / (1 + at_node), 1 / (1 + at_vertex)
    apart = np.abs(at_vertex[None, :] - at_node[:, None]) * w[:, None] * w_vertex[None, :]
    side = np.log(apart) + np.log(w[:, None] + w_vertex[None, :])
    return side, np.log(np.exp(2 * LEVEL)[:, None] + w_vertex[None, :] ** 2)


class _Side(NamedTuple):
    """Slope and height over y of the side that is mapped, and the half-breadth that is wet at once."""

    slope: Callable
    height: Callable
    flat: float


def _side(section: Section) -> _Side:
    """Return the side of a section; the corners of a table are rounded over a quarter of the shorter piece beside."""
    if not isinstance(section, TableSection):
        return _Side(section.slope, section.height, 0.0)
    y, z = np.array(section.points).T
    slopes, pieces = np.diff(z) / np.diff(y), np.diff(y)
    first, steps, places = slopes[0], np.diff(slopes), y[1:-1]
    half = ROUNDING * np.minimum(pieces[:-1], pieces[1:])

    def from_corner(at):
        return np.asarray(at, float)[..., None] - places + half

    def slope(at):
        return first + np.clip(from_corner(at) / (2 * half), 0, 1) @ steps

    def height(at):
        past = np.clip(from_corner(at), 0, None)
        return first * np.asarray(at) + np.where(past < 2 * half, past**2 / (4 * half), past - half) @ steps

    return _Side(slope, height, float(places[0] - half[0]) if first == 0 else 0.0)


def _map(slope, c: float, angle: np.ndarray) -> _Map:
    """Return the map for the half-breadth c [m], from a first guess of the side's angles."""
    side, level = _logarithms()
    log_w, log_rest = -np.logaddexp(0, -SIDE), -np.logaddexp(0, SIDE)
    w = np.exp(log_w)
    for _ in range(ROUNDS):
        e = angle / np.pi
        turn = e[:-1] - e[1:]
        growth = np.exp((1 - 2 * e[0]) * log_w + (e[-1] - 0.5) * (log_rest + np.log1p(w)) + side @ turn)
        along = growth * np.exp(log_w + log_rest)
        breadth, rise = np.cos(angle) * along, np.sin(angle) * along
        near = breadth[0] / (2 - 2 * e[0])
        spread = near + cumulative_simpson(breadth, x=SIDE, initial=0.0)
        scale = c / (spread[-1] + breadth[-1] / (0.5 + e[-1]))
        y = c - scale * spread
        new = np.arctan(slope(np.clip(y, 0.0, c)))
        change = np.abs(new - angle).max()
        angle = new
        if change < SETTLED:
            break
    drop = scale * (rise[0] / (2 - 2 * e[0]) + cumulative_simpson(rise, x=SIDE, initial=0.0))
    outside = np.exp(
        (1 - 2 * e[0]) * LEVEL + (e[-1] - 0.5) * np.logaddexp(0, 2 * LEVEL) + level @ turn
    ) * np.exp(LEVEL)
    beyond = scale / c * (outside[0] / (2 - 2 * e[0]) + cumulative_simpson(outside, x=LEVEL, initial=0.0))
    psi = np.exp(LEVEL) / (1 + beyond) ** 2
    reached = scale / c * (psi[0] + cumulative_simpson(psi, x=LEVEL, initial=0.0))
    return _Map(scale, w, y, drop, growth, angle, np.log(beyond), reached)


def _risen(found: _Map, ratio: np.ndarray) -> np.ndarray:
    """Integral of V_rel/V over ds/s**2 from 1 to the ratio s = y/c."""
    with np.errstate(divide="ignore"):
        return np.interp(np.log(ratio - 1), found.log_level, found.reached, left=0.0)


def _wetting(side: _Side, end: float) -> tuple[np.ndarray, np.ndarray]:
    """Penetration at the edges of equal cells of wetted half-breadth up to ``end`` [m].

    Water on the level of the edge rises past the section with V_rel(y/c, c); it meets the side
    at y = c: f(y) = integral of V_rel/V (dh/dc) dc, solved cell by cell for dh/dc.
    """
    edges = np.linspace(side.flat, end, CELLS + 1)
    angle = np.zeros(len(SIDE))
    penetration = np.zeros(CELLS + 1)
    risen = np.zeros(CELLS + 1)
    height = side.height(edges)
    for cell in range(CELLS):
        middle = (edges[cell] + edges[cell + 1]) / 2
        found = _map(side.slope, middle, angle)
        angle = found.angle
        later = edges[cell + 1 :]
        whole = found.reached[-1] if edges[cell] == 0 else _risen(found, later / max(edges[cell], 1e-300))
        share = later * (whole - _risen(found, later / edges[cell + 1]))
        rate = (height[cell + 1] - risen[cell + 1]) / share[0]
        risen[cell + 1 :] += rate * share
        penetration[cell + 1] = penetration[cell] + rate * (edges[cell + 1] - edges[cell])
    return edges, penetration


def instants(
    section: Section, penetration: np.ndarray, velocity: np.ndarray, acceleration: np.ndarray
) -> list[Instant]:
    """Return the instants of a convex section by the generalised Wagner model ([Zhao1996]_).

    Parameters
    ----------
    section : symmetric and convex.
    penetration : growing, above 0 [m]; velocity : downwards [m/s]; acceleration : [m/s2].

    Notes
    -----
    phi = -h' (C w - (f(c) - f)) on the side; Bernoulli's equation at a fixed point of the body
    with the derivative by c taken between two maps. The negative part at the edge is left out.
    """
    side = _side(section)
    deepest = float(penetration[-1])
    end = section.reach
    if section.mean_height(end) > deepest if np.isfinite(end) else True:
        end = contact_half_breadth(section, deepest, pile_up=True)
    edges, depths = _wetting(side, end)
    if depths[-1] < deepest:
        raise InputError(
            f"The water reaches the end of the section before the penetration of {deepest:g} m; give a smaller one "
            f"(below {depths[-1]:.4g} m) or a wider section."
        )
    depth = PchipInterpolator(edges, depths)
    rate = CubicSpline((edges[1:] + edges[:-1]) / 2, np.diff(depths) / np.diff(edges))
    found = []
    for h, v, a in zip(penetration, velocity, acceleration, strict=True):
        c = float(brentq(lambda at, h=h: depth(at) - h, edges[0], edges[-1], xtol=1e-14 * end))
        found.append(_instant(side.slope, c, v / float(rate(c)), v, a))
    return found


def _instant(slope, c: float, rate: float, velocity: float, acceleration: float) -> Instant:
    here = _map(slope, c, np.zeros(len(SIDE)))
    less, more = (_map(slope, c * (1 + shift), here.angle) for shift in (-STEP, STEP))

    def potential(found: _Map) -> np.ndarray:
        return -(found.scale * found.w - found.drop)

    speed, shift = 1 / here.growth, more.y - less.y
    speed[-1], shift[-1] = 0.0, 0.0  # the last node stands for the stagnation point on the centreline
    along = (speed - np.sin(here.angle)) / np.cos(here.angle)
    by_breadth = (potential(more) - potential(less) - along * shift) / (2 * STEP * c)
    values = -acceleration * potential(here) - velocity * rate * by_breadth + velocity**2 / 2 * (1 - speed**2)
    peak, place = largest(SIDE, values)
    positive = np.maximum(values, 0.0)[::-1]
    y = np.clip(here.y[::-1], 0.0, None)
    y[0] = 0.0
    share = cumulative_simpson(np.maximum(values, 0.0) * _breadth(here), x=SIDE, initial=0.0)
    total = float(share[-1])
    last = int(np.flatnonzero(positive > 0)[-1]) + 2 if np.any(positive > 0) else len(y)
    return Instant(
        c,
        rate,
        y[:last],
        positive[:last],
        (total - share[::-1])[:last],
        2 * total,
        peak,
        float(np.interp(place, SIDE, here.y)),
    )


def _breadth(found: _Map) -> np.ndarray:
    log_w, log_rest = -np.logaddexp(0, -SIDE), -np.logaddexp(0, SIDE)
    return found.scale * np.cos(found.angle) * found.growth * np.exp(log_w + log_rest)
