"""Non-linear water entry of a symmetric section by boundary elements, stepped in time.

Potential flow without gravity, exact conditions on the free surface, in coordinates fixed to the body
(velocity U = -i V): points of the free surface move with the water, dphi/dt = |grad phi|**2/2. The jet is cut
across where it runs along the body; the cut carries the potential of the free
surface, less the part that follows from the velocity of the body.

The pressure follows from a second solution: P = p/rho + w**2/2, w the speed relative to the body, is
harmonic but for a constant, equals w**2/2 on the free surface, and its normal derivative on the body is
that of -U', U' the acceleration; no second derivatives are needed.

.. [Zhao1993] R. Zhao, O. M. Faltinsen, "Water entry of two-dimensional bodies", Journal of
    Fluid Mechanics 246, 593-612, 1993.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, eq. 6.1-6.7.
"""

from collections import deque
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator, make_interp_spline

from workbench.errors import InputError
from workbench.impact.boundary_elements import Boundary
from workbench.impact.logvinovich import largest
from workbench.impact.nonlinear_surface import (
    Slopes,
    Surface,
    body_nodes,
    corners_within,
    grading,
    nearest,
    regridded,
    slopes,
    spline,
)
from workbench.impact.plate import Instant
from workbench.impact.section import Section

COURANT = 0.9
"""Largest way of a point per step over the distance to its neighbour."""

LARGEST_STEP = 0.02
"""Largest growth of the penetration per step."""

MOST_STEPS = 3200
"""Half a minute on one core; a wedge of 8 degrees is then 1.6 % off, one of 6 degrees 5 % after 4000 steps."""

TOO_FAST = 4.0
"""Speed that the flow cannot have, over that of Wagner's jet."""

JET_POINTS, JET_FITTED = 4, 8
"""Points at the cut whose velocity is that of a parabola through so many."""

REMEMBERED = 40
"""Steps over which the speed of the spray root is taken."""

REFINED = 8
"""Pressure points per element."""

SURFACE_POINTS = 161


def _end_fit() -> np.ndarray:
    powers = np.vander(np.arange(JET_FITTED) / JET_FITTED, 3)
    return (powers @ np.linalg.pinv(powers))[:JET_POINTS]


END_FIT = _end_fit()


class Flow(NamedTuple):
    """Solved flow: boundary, potential at its nodes, normal velocity of cut and free surface, velocity of the last."""

    boundary: Boundary
    potential: np.ndarray
    flux: np.ndarray
    velocity: np.ndarray
    slopes: Slopes


def flow(section: Section, surface: Surface, velocity: float) -> Flow:
    """Solve for the flow at a velocity downwards [m/s]."""
    tip = surface.points[0]
    breadth = float(nearest(section, surface.points[:1])[0])
    if breadth >= section.reach * (1 - 1e-9):
        raise InputError(
            f"The jet reaches the end of the section, half-breadth {section.reach:g} m; give a smaller penetration or "
            "a wider section."
        )
    sizes = grading(section, surface.root)
    body = body_nodes(section, breadth, sizes)
    across = tip - body[-1]
    cut = int(np.clip(round(abs(across) / sizes.root), 2, 6))
    share = np.arange(cut) / cut
    from_body = -velocity * across.imag  # U times the width of the jet
    potential = np.concatenate([surface.potential[0] - from_body * (1 - share), surface.potential])
    nodes = np.concatenate([body[:-1], body[-1] + across * share, surface.points])
    boundary = Boundary(nodes, len(body) - 1, cut)
    along = slopes(surface)
    flux = -velocity * boundary.normal[: boundary.body].imag
    potential, flux = boundary.solve(potential, flux, float(along.along[0]))
    found = along.tangent * (along.along + 1j * flux[cut:])
    # the end of the jet runs out; left alone, its points part from each other in a zigzag
    found[:JET_POINTS] = END_FIT @ found[:JET_FITTED]
    return Flow(boundary, potential, flux, found, along)


class March:
    """A water entry, stepped in time.

    Parameters
    ----------
    section : what enters.
    motion : gives penetration [m], velocity [m/s] and acceleration [m/s2] at a time [s].
    time : of the start [s]; surface : then.
    """

    def __init__(self, section: Section, motion: Callable, time: float, surface: Surface):
        self.section, self.motion, self.time, self.surface = section, motion, time, surface
        self.steps = 0
        self._roots: deque = deque(maxlen=REMEMBERED)

    def to(self, time: float) -> None:
        """Step to a time [s]."""
        while self.time < time * (1 - 1e-12):
            self.step(time)

    def step(self, latest: float) -> float:
        """Take one step, by the midpoint rule, not beyond a time [s]; return it [s]."""
        depth, velocity, _ = self.motion(self.time)
        now = flow(self.section, self.surface, velocity)
        step = min(self._step(now, velocity), LARGEST_STEP * depth / velocity, latest - self.time)
        middle = self.motion(self.time + step / 2)[1]
        halfway = flow(self.section, self.moved(now, velocity, step / 2), middle)
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise InputError(
                f"The non-linear method needs more than {MOST_STEPS} steps; ask for instants nearer to each other, or "
                "take generalised-wagner."
            )
        moved = self.moved(halfway, middle, step)
        self.time += step
        depth = self.motion(self.time)[0]
        self.surface = regridded(moved, self.section, depth)
        self._roots.append((depth, self.surface.root))
        return step

    def _step(self, now: Flow, velocity: float) -> float:
        relative = np.abs(now.velocity + 1j * velocity)
        slope = float(self.section.slope(self.surface.root))
        if not relative.max() < TOO_FAST * velocity * (2 + np.pi / slope):
            raise InputError(
                f"The non-linear method did not hold at a penetration of {self.motion(self.time)[0]:g} m; take "
                "generalised-wagner."
            )
        apart = np.abs(np.diff(self.surface.points))
        return COURANT * float(np.min(apart / np.maximum(relative[1:], relative[:-1])))

    def moved(self, found: Flow, velocity: float, step: float) -> Surface:
        """Return the free surface moved for a step [s] with the velocities of a flow."""
        return self.surface._replace(
            points=self.surface.points + step * (found.velocity + 1j * velocity),
            potential=self.surface.potential + step * np.abs(found.velocity) ** 2 / 2,
        )

    def instant(self) -> Instant:
        """Return force and pressure now."""
        _, velocity, acceleration = self.motion(self.time)
        body, pressure = self.pressure(velocity, acceleration)
        arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(body)))])
        peak, place = largest(arc, pressure)
        count = len(arc)
        fine = np.interp(np.arange((count - 1) * REFINED + 1) / REFINED, np.arange(count), arc)
        y = np.interp(fine, arc, body.real)
        values = PchipInterpolator(arc, pressure)(fine)
        total = PchipInterpolator(y, values).antiderivative()(y)
        rate = velocity * self._root_rate()
        place = float(np.interp(place, arc, body.real))
        return Instant(
            self.surface.root, rate, y, values, total, 2 * float(total[-1]), max(peak, pressure.max()), place
        )

    def _root_rate(self) -> float:
        """Derivative of the half-breadth of the spray root by penetration, from the last steps [-]."""
        if len(self._roots) < JET_FITTED:
            return float("nan")
        depth, root = np.array(self._roots).T
        scale = depth[-1] - depth[0]
        return float(np.polyfit((depth - depth[-1]) / scale, root, 2)[1] / scale)

    def pressure(self, velocity: float, acceleration: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the nodes of the body, complex [m], and p/rho there [m2/s2]."""
        now = flow(self.section, self.surface, velocity)
        boundary = now.boundary
        first, cut = boundary.body, boundary.cut
        across = boundary.nodes[first + cut] - boundary.nodes[first]
        across /= abs(across)
        in_cut = across * (-velocity * across.imag + 1j * now.flux[:cut])
        moving = np.concatenate([in_cut, now.velocity]) + 1j * velocity
        head = (np.abs(moving) ** 2 - velocity**2) / 2
        arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(self.surface.points)))])
        flux = acceleration * boundary.normal[:first].imag
        solved, _ = boundary.solve(head, flux, float(CubicSpline(arc, head[cut:])(0.0, 1)))
        body = boundary.nodes[: first + 1]
        relative = now.potential[: first + 1] + velocity * body.imag
        return body, solved[: first + 1] + velocity**2 / 2 - self._speed(body, relative) ** 2 / 2

    def _speed(self, body: np.ndarray, relative: np.ndarray) -> np.ndarray:
        """Speed along the body relative to it [m/s], piece by piece between its corners."""
        arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(body)))])
        corners = np.flatnonzero(np.isin(body.real, corners_within(self.section, body[-1].real)))
        speed = np.empty(len(body))
        for first, last in pairwise([0, *corners, len(body) - 1]):
            piece = slice(first, last + 1)
            order = min(last - first, 3)
            speed[piece] = make_interp_spline(arc[piece], relative[piece], order)(arc[piece], 1)
        speed[0] = 0.0
        return speed

    def free_surface(self) -> np.ndarray:
        """Return the free surface from the cut outwards, y + i z above calm water, (`SURFACE_POINTS`,) [m]."""
        curve, arc = spline(self.surface)
        count = len(arc)
        y, z, _ = curve(np.interp(np.linspace(0, count - 1, SURFACE_POINTS), np.arange(count), arc)).T
        return y + 1j * (z - self.motion(self.time)[0])
