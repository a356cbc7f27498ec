"""Free surface beside a section that enters the water, by each theory that gives one.

.. [Wagner1932] H. Wagner, "Ueber Stoss- und Gleitvorgaenge an der Oberflaeche von
    Fluessigkeiten", ZAMM 12(4), 193-215, 1932.
.. [Zhao1996] R. Zhao, O. M. Faltinsen and J. V. Aarsnes, "Water entry of arbitrary two-dimensional
    sections with and without flow separation", 21st Symposium on Naval Hydrodynamics, 1996.
"""

from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from workbench.errors import checked_number
from workbench.impact.generalised_wagner import wedge_flow
from workbench.impact.section import Section, TableSection, Wedge

POINTS = 121
"""Number of points of a free surface."""

NODES = 48
"""Gauss points over the wetted part of a smooth section."""


class FreeSurface(NamedTuple):
    """Points of the free surface from the section outwards, over (time, surface point), z above calm water [m]."""

    position: np.ndarray
    height: np.ndarray


def wagner_elevation(section: Section, half_breadth: float, y) -> np.ndarray:
    """Elevation of the water beside a section by Wagner's theory [m] ([Wagner1932]_).

    Parameters
    ----------
    section : convex.
    half_breadth : wetted half-breadth c with pile-up, above 0 [m].
    y : half-breadths from c outwards [m].

    Notes
    -----
    The water at y > c has risen with V (y/sqrt(y**2 - c**2) - 1) since first contact, so
    eta = integral of y/sqrt(y**2 - x**2) dh/dx over 0 < x < c, less h. With the h(x) of Wagner's condition

        eta = (2/pi) integral of f'(b) atan(y sqrt(c**2 - b**2)/(b sqrt(y**2 - c**2))) db over 0 < b < c, less h;

    for the wedge (2/pi) y tan(beta) asin(c/y) - h. It meets the section at c, holds the water
    that the section has displaced, and falls like 1/y**2. Straight pieces are in closed form.
    """
    c = checked_number("wetted half-breadth", half_breadth, "m", above=0)
    y = np.maximum(np.asarray(y, float), c)
    if isinstance(section, Wedge | TableSection):
        risen = _beside_straight_pieces(section, c, y)
    else:
        risen = _beside_smooth(section, c, y)
    return 2 / np.pi * risen - section.mean_height(c)


def _beside_straight_pieces(section: Wedge | TableSection, c: float, y: np.ndarray) -> np.ndarray:
    """Sum over the bends at b of the change of slope times y phi - b A, tan A = (y/b) tan(phi)."""
    if isinstance(section, Wedge):
        places, steps = np.zeros(1), np.array([np.tan(section.deadrise_angle)])
    else:
        given_y, given_z = np.array(section.points).T
        places, steps = given_y[:-1], np.diff(np.diff(given_z) / np.diff(given_y), prepend=0.0)
    wet = places < c
    b, steps = places[wet], steps[wet]
    out = y[..., None]
    inside, outside = np.sqrt(c**2 - b**2), np.sqrt(out**2 - c**2)
    phi = np.arctan2(inside, outside)
    return (out * phi - b * np.arctan2(out * inside, b * outside)) @ steps


def _beside_smooth(section: Section, c: float, y: np.ndarray) -> np.ndarray:
    """Gauss's rule over b = c sin(theta), nodes close together at the edge, where the angle turns fast."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    from_edge = (1 - nodes) / 2
    rest = np.pi / 2 * from_edge**4
    share = weights / 2 * 2 * np.pi * from_edge**3
    b, breadth = c * np.cos(rest), c * np.sin(rest)
    out = y[..., None]
    angle = np.arctan2(out * breadth, b * np.sqrt(out**2 - c**2))
    return angle @ (section.slope(b) * breadth * share)


def level_elevation(deadrise_angle: float, penetration: float, y) -> np.ndarray:
    """Elevation of the water beside a wedge by the generalised Wagner model [m] ([Zhao1996]_).

    Parameters
    ----------
    deadrise_angle : [rad]; penetration : below calm water, above 0 [m].
    y : half-breadths from the edge of the wetted part outwards [m].

    Notes
    -----
    Water at y rises past the section with the velocity on the level of the edge, V_rel(y/c):
    eta + h = y V t/c times the integral of V_rel/V over ds/s**2 from y/c to infinity.
    """
    flow = wedge_flow(deadrise_angle)
    y = np.asarray(y, float)
    nearest, farthest = np.exp(flow.log_level[[0, -1]])
    beyond = np.clip(y / (flow.spread * penetration) - 1, nearest, farthest)
    risen = CubicSpline(flow.log_level, flow.risen)(np.log(beyond))
    return np.where(beyond < farthest, y / flow.spread * risen - penetration, 0.0)


def free_surface(section: Section, found: xr.Dataset, reach: float) -> FreeSurface | None:
    """Free surface of an entry up to the half-breadth ``reach`` [m] at least; None where the theory gives none.

    Parameters
    ----------
    section : what enters.
    found : from `workbench.impact.entry.entry`; a surface that it holds itself is taken from there.

    Notes
    -----
    Von Karman's water stays calm. The modified Logvinovich model has Wagner's surface; the
    generalised Wagner model has one here for the wedge.
    """
    if "surface_position" in found:
        given = FreeSurface(found["surface_position"].values, found["surface_height"].values)
        inwards = given.position[-1, 0] > given.position[-1, -1]
        return FreeSurface(*(values[:, ::-1] for values in given)) if inwards else given
    method = found.attrs["method"]
    breadth, depth = found["wetted_half_breadth"].values, found["penetration"].values
    if method == "chuang" or (method == "generalised-wagner" and not isinstance(section, Wedge)):
        return None
    stretched = np.linspace(0.0, 1.0, POINTS) * np.arccosh(np.maximum(reach / breadth, 1.5))[:, None]
    position = breadth[:, None] * np.cosh(stretched)
    if method == "von-karman":
        return FreeSurface(position, np.zeros(position.shape))
    if method == "generalised-wagner":
        rows = [level_elevation(section.deadrise_angle, h, y) for h, y in zip(depth, position, strict=True)]
    else:
        rows = [wagner_elevation(section, c, y) for c, y in zip(breadth, position, strict=True)]
    return FreeSurface(position, np.array(rows))
