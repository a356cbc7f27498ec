"""Sections that enter the water: wedge, parabola, circle, or a table of points; convex and symmetric."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from workbench.errors import InputError, checked_number


@dataclass(frozen=True)
class Wedge:
    """A wedge with straight sides.

    Parameters
    ----------
    deadrise_angle : between side and calm water [rad], 0 < beta < pi/2.
    """

    deadrise_angle: float

    def __post_init__(self):
        angle = checked_number("deadrise angle of the wedge", self.deadrise_angle, "rad")
        cure = "a flat bottom is given as a table of points" if angle == 0 else ""
        checked_number("deadrise", np.degrees(angle), "degrees", above=0, below=90, cure=cure)

    kind = "wedge"
    reach = np.inf

    def height(self, y):
        """Height of the side above the lowest point [m] at the half-breadth y [m]."""
        return np.abs(y) * np.tan(self.deadrise_angle)

    def slope(self, y):
        """Slope of the side [-] at the half-breadth y >= 0 [m]."""
        return np.full_like(np.asarray(y, float), np.tan(self.deadrise_angle))

    def mean_height(self, c: float) -> float:
        """Mean of the height at y = c sin(theta) over 0 < theta < pi/2 [m]."""
        return 2 / np.pi * c * np.tan(self.deadrise_angle)

    def mean_slope(self, c: float) -> float:
        """Derivative of `mean_height` [-]."""
        return 2 / np.pi * np.tan(self.deadrise_angle)


@dataclass(frozen=True)
class Parabola:
    """A section y**2/(2 R) with the radius of curvature R [m] at its lowest point."""

    radius: float

    def __post_init__(self):
        checked_number("radius", self.radius, "m", above=0)

    kind = "parabola"
    reach = np.inf

    def height(self, y):
        """Height above the lowest point [m] at the half-breadth y [m]."""
        return np.square(y) / (2 * self.radius)

    def slope(self, y):
        """Slope [-] at the half-breadth y >= 0 [m]."""
        return np.asarray(y, float) / self.radius

    def mean_height(self, c: float) -> float:
        """Mean of the height at y = c sin(theta) over 0 < theta < pi/2 [m]."""
        return c**2 / (4 * self.radius)

    def mean_slope(self, c: float) -> float:
        """Derivative of `mean_height` [-]."""
        return c / (2 * self.radius)


@dataclass(frozen=True)
class Circle:
    """The lower half of a circle of radius R [m]."""

    radius: float

    def __post_init__(self):
        checked_number("radius", self.radius, "m", above=0)

    kind = "circle"

    @property
    def reach(self) -> float:
        """Largest half-breadth that a theory is asked for [m]; beyond it the side is all but vertical."""
        return 0.98 * self.radius

    def height(self, y):
        """Height above the lowest point [m] at the half-breadth y [m]."""
        return self.radius - np.sqrt(self.radius**2 - np.square(y))

    def slope(self, y):
        """Slope [-] at the half-breadth y >= 0 [m]."""
        y = np.asarray(y, float)
        return y / np.sqrt(self.radius**2 - y**2)

    def mean_height(self, c: float) -> float:
        """Mean of the height at y = c sin(theta) over 0 < theta < pi/2 [m]."""
        return self.radius * (1 - 2 / np.pi * ellipe((c / self.radius) ** 2))

    def mean_slope(self, c: float) -> float:
        """Derivative of `mean_height` [-]."""
        if c == 0:
            return 0.0
        m = (c / self.radius) ** 2
        return 2 / np.pi * self.radius / c * (ellipk(m) - ellipe(m))


@dataclass(frozen=True)
class TableSection:
    """A section of straight pieces between points of its half from the centreline outwards.

    Parameters
    ----------
    points : (y, z) from the centreline (y = 0) outwards [m]; z up from any datum. A
        horizontal first piece is a flat bottom.

    Notes
    -----
    The half must be convex (its slope does not decrease outwards), which is what the
    theories of one pair of contact points hold for, and must not overhang.
    """

    points: tuple[tuple[float, float], ...]

    kind = "table"

    def __post_init__(self):
        if len(self.points) < 2:
            raise InputError("The section needs at least two points, from the centreline outwards.")
        for y, z in self.points:
            checked_number("y of the section", y, "m", at_least=0)
            checked_number("z of the section", z, "m")
        if self.points[0][0] != 0:
            raise InputError(
                f"The first point of the section must lie on the centreline, y = 0, got y = {self.points[0][0]:g} m."
            )
        y, z = np.array(self.points).T
        if np.any(np.diff(y) <= 0):
            place = y[:-1][np.diff(y) <= 0][0]
            raise InputError(
                f"The section overhangs or is vertical at y = {place:g} m; y must grow from point to point."
            )
        slopes = np.diff(z) / np.diff(y)
        if slopes[0] < 0 or np.any(np.diff(slopes) < -1e-9 * (1 + np.abs(slopes[1:]))):
            fall = 0 if slopes[0] < 0 else int(np.argmin(np.diff(slopes))) + 1
            raise InputError(
                f"The section is concave at y = {y[fall]:g} m, where its slope falls outwards; these theories hold "
                "for convex sections only."
            )
        if slopes[-1] <= 0:
            raise InputError("The section is flat to its end; it needs a side that rises.")

    @property
    def reach(self) -> float:
        """Half-breadth of the last point [m]."""
        return self.points[-1][0]

    @property
    def _kinks(self) -> tuple[np.ndarray, np.ndarray]:
        y, z = np.array(self.points).T
        return y[:-1], np.diff(np.diff(z) / np.diff(y), prepend=0.0)

    def height(self, y):
        """Height above the lowest point [m] at the half-breadth y [m]."""
        given_y, given_z = np.array(self.points).T
        return np.interp(np.abs(y), given_y, given_z - given_z[0])

    def slope(self, y):
        """Slope [-] at the half-breadth y >= 0 [m]."""
        places, steps = self._kinks
        return (np.asarray(y, float)[..., None] >= places) @ steps

    def mean_height(self, c: float) -> float:
        """Mean of the height at y = c sin(theta) over 0 < theta < pi/2 [m], piece by piece in closed form."""
        places, steps = self._kinks
        wet = places < c
        b, s = places[wet], steps[wet]
        return float(2 / np.pi * np.sum(s * (np.sqrt(c**2 - b**2) - b * np.arccos(b / c)))) if c else 0.0

    def mean_slope(self, c: float) -> float:
        """Derivative of `mean_height` [-]."""
        places, steps = self._kinks
        wet = places < c
        return float(2 / np.pi * np.sum(steps[wet] * np.sqrt(c**2 - places[wet] ** 2)) / c) if c else 0.0


Section = Wedge | Parabola | Circle | TableSection


def contact_half_breadth(section: Section, penetration: float, pile_up: bool) -> float:
    """Half-breadth of the wetted part [m].

    Parameters
    ----------
    section : the section.
    penetration : of its lowest point below calm water [m].
    pile_up : by Wagner's condition, mean of f(c sin theta) = h; otherwise where calm water
        cuts the section, f(c) = h.
    """
    height = section.mean_height if pile_up else lambda c: float(section.height(c))
    if penetration <= 0:
        return 0.0
    top = section.reach
    if np.isinf(top):
        top = 1.0
        while height(top) < penetration:
            top *= 4.0
    elif height(top) < penetration:
        raise InputError(
            f"The water reaches the end of the section, half-breadth {top:g} m, before the penetration of "
            f"{penetration:g} m; give a smaller one (below {height(top):.4g} m) or a wider section."
        )
    return float(brentq(lambda c: height(c) - penetration, 0.0, top, xtol=1e-14 * top, rtol=1e-14))


def contact_rate(section: Section, half_breadth: float, velocity: float, pile_up: bool) -> float:
    """Speed of the contact points outwards [m/s] at the half-breadth [m] and velocity [m/s]."""
    slope = section.mean_slope(half_breadth) if pile_up else float(section.slope(half_breadth))
    return velocity / slope if slope > 0 else np.inf
