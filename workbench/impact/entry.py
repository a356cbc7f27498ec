"""One interface to the theories of water entry: section, velocity and theory in, forces and pressures out."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from scipy.interpolate import CubicHermiteSpline, CubicSpline

from workbench import quantities
from workbench.conventions import SEAWATER_DENSITY
from workbench.errors import InputError, checked_choice, checked_number
from workbench.impact import (
    chuang,
    generalised_section,
    generalised_wagner,
    logvinovich,
    nonlinear_entry,
    plate,
    similarity,
)
from workbench.impact.entry_range import check_range, validity
from workbench.impact.nonlinear import SURFACE_POINTS
from workbench.impact.nonlinear_surface import EDGE
from workbench.impact.plate import Instant
from workbench.impact.quadrature import running_integral
from workbench.impact.section import Section, Wedge

METHODS = (
    "von-karman",
    "wagner",
    "generalised-wagner",
    "logvinovich",
    "similarity",
    "nonlinear",
    "chuang",
)
POINTS = 201
"""Number of pressure points per instant in a result."""


@dataclass(frozen=True)
class VelocityHistory:
    """Downward velocity of a section against time, from first contact at time 0.

    Parameters
    ----------
    times : from 0, growing [s]; velocities : downwards, above 0 [m/s]. Between them a
        cubic spline, so that there is an acceleration.
    """

    times: tuple[float, ...]
    velocities: tuple[float, ...]

    def __post_init__(self):
        if len(self.times) != len(self.velocities) or len(self.times) < 2:
            raise InputError(
                f"The velocity history needs as many velocities as times, at least 2, got {len(self.velocities)} and "
                f"{len(self.times)}."
            )
        if self.times[0] != 0 or np.any(np.diff(self.times) <= 0):
            raise InputError("The times of the velocity history must grow from 0, the first contact.")
        for velocity in self.velocities:
            _checked_velocity(velocity)

    def motion(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return penetration [m], velocity [m/s] and acceleration [m/s2] at times [s]."""
        if times[-1] > self.times[-1]:
            raise InputError(
                f"Time {times[-1]:g} s lies after the end of the velocity history, {self.times[-1]:g} s."
            )
        spline = CubicSpline(self.times, self.velocities)
        return spline.antiderivative()(times), spline(times), spline.derivative()(times)


def entry(
    section: Section,
    velocity: float | VelocityHistory,
    method: str = "logvinovich",
    density: float = SEAWATER_DENSITY,
    times: Sequence[float] = (1.0,),
    panels: Sequence[tuple[float, float]] = (),
) -> xr.Dataset:
    """Return force and pressure of a section that enters calm water.

    Parameters
    ----------
    section : `Wedge`, `Parabola`, `Circle` or `TableSection`; symmetric and convex.
    velocity : downwards, constant [m/s], or a history.
    method : one of `METHODS`.
    density : of the water [kg/m3].
    times : after first contact, above 0, growing [s].
    panels : pairs of half-breadths (inner, outer) [m] to average the pressure over.

    Returns
    -------
    Over ``time``: ``penetration``, ``entry_velocity``, ``section_acceleration``,
    ``wetted_half_breadth``, ``wetted_rate``, ``section_force`` (both sides), ``peak_pressure``,
    ``peak_coefficient`` k = p_max/(rho V**2/2), ``peak_height``; over ``point`` too
    ``pressure_position`` and ``section_pressure``; over ``panel`` too ``panel_pressure``. The exact
    wedge adds ``jet_height``; the exact wedge and the non-linear method add, over ``surface_point``,
    ``surface_position`` and ``surface_height``, the free surface from the jet outwards; Chuang's k
    has no force and no distribution.

    Notes
    -----
    Gravity and air are left out. The wetted half-breadth of the exact wedge is that of the
    peak pressure while the peak is at the spray root, and that of the jet tip
    where the largest pressure is at the apex; that of the non-linear method is where the
    free surface is at right angles to the section, and its jet is cut off further out. It takes
    1 to 10 s for a wedge at constant velocity, up to half a minute otherwise.
    """
    checked_choice("method", method, METHODS)
    checked_number("density", density, "kg/m3", above=0)
    times = _checked_times(times)
    panels = [_checked_panel(panel) for panel in panels]
    penetration, speed, acceleration = _motion(velocity, times)
    constant = not isinstance(velocity, VelocityHistory)
    check_range(section, method, constant)
    surfaces = None
    if method == "nonlinear":
        instants, surfaces = nonlinear_entry.instants(section, _motion_at(velocity), times, constant)
    elif method == "chuang":
        instants = [_chuang(section, v) for v in speed]
    elif method == "generalised-wagner" and not isinstance(section, Wedge):
        instants = generalised_section.instants(section, penetration, speed, acceleration)
    else:
        instants = [
            _instant(section, method, *motion)
            for motion in zip(penetration, speed, acceleration, strict=True)
        ]
    if method == "similarity":
        surfaces = penetration[:, None] * _similar_surface(section.deadrise_angle)
    return _dataset(
        section, method, density, times, (penetration, speed, acceleration), panels, instants, surfaces
    )


def _checked_velocity(velocity) -> float:
    return checked_number(
        "downward entry velocity", velocity, "m/s", above=0, cure="water exit is not in these theories"
    )


def _checked_times(times) -> np.ndarray:
    found = np.atleast_1d(np.asarray(times, float))
    for time in found:
        checked_number("time after first contact", time, "s", above=0)
    if np.any(np.diff(found) <= 0):
        raise InputError("The times after first contact must grow.")
    return found


def _checked_panel(panel) -> tuple[float, float]:
    inner, outer = panel
    checked_number("inner edge of the panel", inner, "m", at_least=0)
    checked_number("outer edge of the panel", outer, "m", above=inner)
    return float(inner), float(outer)


def _motion(velocity, times: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    if not isinstance(velocity, VelocityHistory):
        constant = _checked_velocity(velocity)
        return constant * times, np.full(len(times), constant), np.zeros(len(times))
    penetration, speed, acceleration = velocity.motion(times)
    _checked_velocity(float(speed.min()))
    return penetration, speed, acceleration


def _motion_at(velocity: float | VelocityHistory) -> Callable[[float], tuple[float, float, float]]:
    """Penetration [m], velocity [m/s] and acceleration [m/s2] as a function of one time [s]."""
    if not isinstance(velocity, VelocityHistory):
        return lambda time: (velocity * time, velocity, 0.0)
    spline = CubicSpline(velocity.times, velocity.velocities)
    penetration, acceleration = spline.antiderivative(), spline.derivative()
    return lambda time: (float(penetration(time)), float(spline(time)), float(acceleration(time)))


def _similar_surface(deadrise_angle: float) -> np.ndarray:
    """Free surface of the exact wedge from the jet tip outwards, y + i z over the penetration, as many points."""
    found = similarity.similarity_solution(deadrise_angle)
    surface = found.surface[np.abs(found.surface) < EDGE * found.wall_length]
    tip = found.wall_length * np.exp(1j * deadrise_angle) - 1j
    surface = np.concatenate([[tip], surface])
    arc = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(surface)))])
    # as many points per distance as the turn of the surface and the distance itself ask for
    turn = np.abs(np.gradient(np.unwrap(np.angle(np.gradient(surface)))))
    share = np.cumsum(turn + np.abs(np.gradient(np.log(arc + found.wall_length / 10))))
    at = np.interp(np.linspace(share[0], share[-1], SURFACE_POINTS), share, np.arange(len(surface)))
    return np.interp(at, np.arange(len(surface)), surface)


def _instant(section: Section, method: str, penetration, velocity, acceleration) -> Instant:
    if method in ("von-karman", "wagner"):
        return plate.instant(section, penetration, velocity, acceleration, pile_up=method == "wagner")
    if method == "logvinovich":
        return logvinovich.instant(section, penetration, velocity, acceleration)
    if method == "generalised-wagner":
        return generalised_wagner.instant(section.deadrise_angle, penetration, velocity, acceleration)
    return similarity_instant(section.deadrise_angle, penetration, velocity)


def similarity_instant(deadrise_angle: float, penetration: float, velocity: float) -> Instant:
    """Return the exact wedge [rad] at a penetration [m] and constant velocity [m/s], on a fine grid."""
    found = similarity.similarity_solution(deadrise_angle)
    breadth = np.cos(deadrise_angle) * penetration
    step = similarity.STEP
    share = running_integral(len(found.position), step) @ (found.pressure * found.wall_rate)
    fine = np.linspace(found.wall_coordinate[0], found.wall_coordinate[-1], 10 * len(found.position))
    position, pressure, integral = (
        CubicSpline(found.wall_coordinate, values)(fine)[::-1]
        for values in (found.position, found.pressure, share)
    )
    apart = position > 1e-12 * found.wall_length  # nearer the apex, differences are rounding
    position, pressure, integral = position[apart], pressure[apart], integral[apart]
    half_force = found.force * penetration * velocity**2 / 2
    at_root = found.peak_position > 0
    return Instant(
        breadth * (found.peak_position if at_root else found.wall_length),
        np.cos(deadrise_angle) * velocity * (found.peak_position if at_root else found.wall_length),
        np.concatenate([[0.0], breadth * position, [breadth * found.wall_length]]),
        np.concatenate([[found.apex_pressure], pressure, [0.0]]) * velocity**2,
        np.concatenate([[0.0], half_force - breadth * velocity**2 * integral, [half_force]]),
        2 * half_force,
        found.peak * velocity**2,
        breadth * found.peak_position,
    )


def _chuang(section: Wedge, velocity: float) -> Instant:
    """Chuang's k for the vertical drop of a wedge on calm water: the velocity is normal to the water."""
    peak = float(chuang.impact_pressure(velocity, section.deadrise_angle, 1.0))
    nothing = np.empty(0)
    return Instant(np.nan, np.nan, nothing, nothing, nothing, np.nan, peak, np.nan)


def _dataset(
    section, method, density, times, motion, panels, instants: list[Instant], surfaces
) -> xr.Dataset:
    penetration, speed, acceleration = motion
    peak = np.array([found.peak for found in instants])
    place = np.array([found.peak_position for found in instants])
    breadth = np.array([found.half_breadth for found in instants])
    height = np.full(len(times), np.nan)
    there = np.isfinite(place)
    height[there] = section.height(place[there]) - penetration[there]
    variables = {
        "penetration": ("time", penetration),
        "entry_velocity": ("time", speed),
        "section_acceleration": ("time", acceleration),
        "wetted_half_breadth": ("time", breadth),
        "wetted_rate": ("time", [found.rate for found in instants]),
        "section_force": ("time", [density * found.force for found in instants]),
        "peak_pressure": ("time", density * peak),
        "peak_coefficient": ("time", peak / (speed**2 / 2)),
        "peak_height": ("time", height),
    }
    coords: dict = {"time": times}
    if method != "chuang":
        rows = [np.round(np.linspace(0, len(found.positions) - 1, POINTS)).astype(int) for found in instants]
        pairs = list(zip(instants, rows, strict=True))
        variables["pressure_position"] = (("time", "point"), [found.positions[row] for found, row in pairs])
        variables["section_pressure"] = (
            ("time", "point"),
            [density * found.pressure[row] for found, row in pairs],
        )
        coords["point"] = np.arange(POINTS)
        if panels:
            averages = [[density * panel_average(found, *panel) for panel in panels] for found in instants]
            variables["panel_pressure"] = (("time", "panel"), averages)
            variables["panel_inner"] = ("panel", [inner for inner, _ in panels])
            variables["panel_outer"] = ("panel", [outer for _, outer in panels])
            coords["panel"] = np.arange(len(panels))
    if surfaces is not None:
        variables["surface_position"] = (("time", "surface_point"), surfaces.real)
        variables["surface_height"] = (("time", "surface_point"), surfaces.imag)
        coords["surface_point"] = np.arange(surfaces.shape[1])
    if method == "similarity":
        found = similarity.similarity_solution(section.deadrise_angle)
        variables["jet_height"] = (
            "time",
            penetration * (found.wall_length * np.sin(section.deadrise_angle) - 1),
        )
    return quantities.dataset(
        coords, method=method, warnings=validity(section, method, breadth, place), **variables
    )


def panel_average(found: Instant, inner: float, outer: float) -> float:
    """Average of p/rho [m2/s2] over the half-breadths from ``inner`` to ``outer`` [m]; dry water counts as zero."""
    places, first = np.unique(found.positions, return_index=True)
    running = CubicHermiteSpline(places, found.cumulative[first], found.pressure[first])
    ends = running(np.minimum([inner, outer], places[-1]))
    return float((ends[1] - ends[0]) / (outer - inner))
