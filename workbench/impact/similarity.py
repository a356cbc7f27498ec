"""Wedge entering at constant velocity: the exact solution without gravity, similar to itself at all times.

.. [Dobrovolskaya1969] Z. N. Dobrovol'skaya, "On some problems of similarity flow of fluid with
    a free surface", Journal of Fluid Mechanics 36, 805-829, 1969.

The right half of the water is the image of the upper half-plane of t: free surface
t < -1, jet tip -1, wall -1 < t < 0, apex 0, axis of symmetry t > 0. Wagner's function, the
integral of sqrt(W'') over the similarity coordinate zeta = (y + i z)/(V t), maps it on
an isosceles right triangle, so (dW'/dt)(dzeta/dt) = C**2 t**-1 (t + 1)**(-3/2). On the free
surface arc lengths between particles do not change, so with s the arc from the jet tip and chi its
direction s (ds/dr)(dchi/dr) = C**2/((1 + r) r**(3/2)), t = -1 - r; |dzeta/dt| follows from
chi by a principal value. The unknown is X = dchi/d(ln r).
"""

from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from workbench.errors import InputError, checked_number
from workbench.impact.quadrature import principal_value, running_integral

STEP = 0.2
SURFACE = (-64.0, 26.0)
"""Range of ln r: X is below 1e-13 of its largest value outside."""

WALL = (-64.0, 40.0)
"""Range of -ln(1/s - 1), s the distance in t from the jet tip."""

SMALLEST, LARGEST = 1.0, 85.0
"""Range of deadrise that the solution is made for [degrees]."""

ITERATIONS = 60
CONVERGED = 1e-9
LARGEST_CHANGE = 1.0


class SimilaritySolution(NamedTuple):
    """Exact solution at V t = 1, per density and velocity squared.

    ``position`` (n,) distance along the wall from the apex, from the jet tip inwards; ``pressure``
    p/(rho V**2) there; ``wall_coordinate`` (n,) in which both are smooth; ``wall_rate`` d(position)/d(that).
    ``force`` is F/(rho V**3 t) of both sides, ``contact_angle`` between jet and wall [rad],
    ``wall_length`` from apex to jet tip; ``peak`` p_max/(rho V**2), ``peak_position`` its distance
    from the apex; ``surface`` (m,) complex, free surface in y + i z from the jet tip outwards.
    """

    deadrise_angle: float
    wall_coordinate: np.ndarray
    position: np.ndarray
    wall_rate: np.ndarray
    pressure: np.ndarray
    force: float
    contact_angle: float
    wall_length: float
    peak: float
    peak_position: float
    apex_pressure: float
    surface: np.ndarray


class _Grid(NamedTuple):
    """Grid of ln r and of the wall, with the matrices that do not depend on the deadrise."""

    log_r: np.ndarray
    integral: np.ndarray
    total: np.ndarray
    log_size: np.ndarray
    wall: np.ndarray
    log_s: np.ndarray
    log_rest: np.ndarray
    wall_integral: np.ndarray
    wall_kernel: np.ndarray


@cache
def _grid() -> _Grid:
    log_r = np.arange(SURFACE[0], SURFACE[1] + STEP / 2, STEP)
    integral = running_integral(len(log_r), STEP)
    total = np.full(len(log_r), STEP)
    total[0], total[-1] = STEP / 2 + 2, STEP / 2 + 2 / 3
    from_right = integral - total
    from_right[:, 0] += 2
    log_size = principal_value(len(log_r), STEP) @ from_right / np.pi
    wall = np.arange(WALL[0], WALL[1] + STEP / 2, STEP)
    log_s, log_rest = -np.logaddexp(0, -wall), -np.logaddexp(0, wall)
    return _Grid(
        log_r,
        integral,
        total,
        log_size,
        wall,
        log_s,
        log_rest,
        running_integral(len(wall), STEP),
        _exponent(log_r, total, log_s),
    )


def _exponent(log_r: np.ndarray, total: np.ndarray, log_s: np.ndarray) -> np.ndarray:
    """Matrix from X to the exponent of dzeta/dt at t = -1 + s: (1/pi) integral of X ln(1 + r/s)."""
    return np.logaddexp(0, log_r[None, :] - log_s[:, None]) * total / np.pi


def _first_guess(beta: float, grid: _Grid) -> np.ndarray:
    """Return ln X, ln mu and ln K to start from: thin jet root at r = 0.08 tan(beta)**2, Wagner's flow outside."""
    root = min(0.08 * np.tan(beta) ** 2, 1.0)
    log_x = grid.log_r / 2 - np.logaddexp(0, grid.log_r - np.log(root)) - np.logaddexp(0, grid.log_r)
    angle = (0.157 - 0.1 * np.sin(beta) + 0.15 * np.sin(beta) ** 4) * np.sin(beta) ** 2
    log_x += np.log((np.pi - beta - angle) / (grid.total @ np.exp(log_x)))
    return np.concatenate([log_x, [np.log(angle), np.log(0.6 * np.sin(beta) * np.cos(beta) ** 1.2)]])


class _Wall(NamedTuple):
    """Densities over the wall coordinate of dzeta (``length``) and dW' (``speed``), and their totals' weights."""

    length: np.ndarray
    speed: np.ndarray
    length_weights: np.ndarray
    speed_weights: np.ndarray


def _wall(beta: float, x: np.ndarray, angle: float, grid: _Grid) -> _Wall:
    p, q, e = beta / np.pi - 0.5, -beta / np.pi, 0.5 - angle / np.pi
    exponent = grid.wall_kernel @ x
    length = np.exp((1 + p) * grid.log_rest + (1 + q) * grid.log_s + exponent)
    speed = np.exp(-p * grid.log_rest - (0.5 + q) * grid.log_s - exponent)
    length_weights, speed_weights = grid.wall_integral[-1].copy(), grid.wall_integral[-1].copy()
    length_weights[0] += np.pi / angle
    length_weights[-1] += 1 / (1 + p)
    speed_weights[0] += 1 / e
    speed_weights[-1] += -1 / p
    return _Wall(length, speed, length_weights, speed_weights)


def _residual_and_slope(beta: float, unknown: np.ndarray, grid: _Grid) -> tuple[np.ndarray, np.ndarray]:
    """Residual (n + 2,) of free surface, its total turn and the wall; its derivative by ln X, ln mu and ln K."""
    log_x, angle, log_k = unknown[:-2], np.exp(unknown[-2]), unknown[-1]
    n, x = len(log_x), np.exp(log_x)
    outside = np.logaddexp(0, grid.log_r)
    log_step = (1 - beta / np.pi) * grid.log_r + (beta / np.pi - 0.5) * outside + grid.log_size @ x
    step = np.exp(log_step)
    arc = step[0] * np.pi / angle + grid.integral @ step
    wall = _wall(beta, x, angle, grid)
    length, speed = wall.length_weights @ wall.length, wall.speed_weights @ wall.speed
    turn = grid.total @ x - (np.pi - beta - angle)
    residual = np.concatenate(
        [
            np.log(arc) + log_step + log_x - log_k - grid.log_r / 2 + outside,
            [turn, log_k + np.log(speed) - np.log(length)],
        ]
    )
    step_slope = step[:, None] * grid.log_size
    arc_slope = grid.integral @ step_slope + step_slope[0] * np.pi / angle
    slope = np.zeros((n + 2, n + 2))
    slope[:n, :n] = (arc_slope / arc[:, None] + grid.log_size) * x + np.eye(n)
    slope[:n, n], slope[:n, n + 1] = -step[0] * np.pi / angle / arc, -1.0
    slope[n, :n], slope[n, n] = grid.total * x, angle
    slope[n + 1, :n] = (
        -((wall.speed_weights * wall.speed) @ grid.wall_kernel) / speed
        - ((wall.length_weights * wall.length) @ grid.wall_kernel) / length
    ) * x
    slope[n + 1, n] = (
        wall.speed[0] / (0.5 - angle / np.pi) ** 2 * angle / np.pi / speed
        + wall.length[0] * np.pi / angle / length
    )
    slope[n + 1, n + 1] = 1.0
    return residual, slope


def _angle_function(beta: float) -> tuple[np.ndarray, float, float]:
    """Solve for X, K = (C/A)**2 and the contact angle mu by Newton's method."""
    grid = _grid()
    unknown = _first_guess(beta, grid)
    for _ in range(ITERATIONS):
        residual, slope = _residual_and_slope(beta, unknown, grid)
        change = -np.linalg.solve(slope, residual)
        size = float(np.abs(change).max())
        unknown = unknown + change * min(1.0, LARGEST_CHANGE / size)
        unknown[-2] = min(unknown[-2], np.log(np.pi / 5))
        if size < CONVERGED:
            return np.exp(unknown[:-2]), float(np.exp(unknown[-1])), float(np.exp(unknown[-2]))
    raise InputError(
        f"The similarity solution was not found at a deadrise of {np.degrees(beta):g} degrees; "
        "take another angle or the modified Logvinovich model."
    )


@lru_cache(maxsize=64)
def similarity_solution(deadrise_angle: float) -> SimilaritySolution:
    """Return the exact solution of a wedge ([Dobrovolskaya1969]_).

    Parameters
    ----------
    deadrise_angle : [rad], 1 to 85 degrees.

    Notes
    -----
    Newton's method on 450 values of ln X; the scale of length follows from the velocity of
    the apex, gained along the axis from infinity. Pressure by Euler's equation along the wall
    from the jet tip.
    """
    checked_number(
        "deadrise of the similarity solution",
        np.degrees(deadrise_angle),
        "degrees",
        at_least=SMALLEST - 1e-9,
        at_most=LARGEST + 1e-9,
        cure="take another theory",
    )
    beta, grid = float(deadrise_angle), _grid()
    x, k, angle = _angle_function(beta)
    scale = _scale(beta, x, k)
    wall = _wall(beta, x, angle, grid)
    length, speed = scale * wall.length, scale * k * wall.speed
    e, b, p = 0.5 - angle / np.pi, angle / np.pi, beta / np.pi - 0.5
    from_tip = length[0] / b + grid.wall_integral @ length
    wall_length = float(from_tip[-1] + length[-1] / (1 + p))
    lead = from_tip - (speed[0] / e + grid.wall_integral @ speed)
    pressure = (
        length[0] * speed[0] / b / (b + e) - speed[0] ** 2 / e / (2 * e) + grid.wall_integral @ (lead * speed)
    )
    apex = float(pressure[-1] + speed[-1] ** 2 / p**2 / 2)
    position = wall_length - from_tip
    force = 2 * np.cos(beta) * (grid.wall_integral[-1] @ (pressure * length) + apex * length[-1] / (1 + p))
    peak, place = _peak(grid.wall, lead, pressure, position)
    if apex >= peak:
        peak, place = apex, 0.0
    return SimilaritySolution(
        beta,
        grid.wall,
        position,
        length,
        pressure,
        float(force),
        angle,
        wall_length,
        peak,
        place,
        apex,
        _free_surface(beta, x, angle, scale, wall_length),
    )


def _scale(beta: float, x: np.ndarray, k: float) -> float:
    """Size A of dzeta/dt: along the axis the velocity grows from zero at infinity to V at the apex."""
    grid = _grid()
    p, q = beta / np.pi - 0.5, -beta / np.pi
    axis = np.arange(-40.0, 40.0 + STEP / 2, STEP)
    log_s = np.logaddexp(0, axis)
    exponent = _exponent(grid.log_r, grid.total, log_s) @ x
    speed = np.exp(-p * axis - (1.5 + q) * log_s - exponent)
    gained = running_integral(len(axis), STEP)[-1] @ speed - speed[0] / p + speed[-1]
    return float(1 / (k * gained))


def _peak(coordinate, lead, pressure, position) -> tuple[float, float]:
    """Return the largest local maximum along the wall, where the lead of particles changes sign."""
    falls = np.flatnonzero((lead[:-1] > 0) & (lead[1:] <= 0))
    if falls.size == 0:
        return -np.inf, 0.0
    spline = CubicSpline(coordinate, lead)
    places = [brentq(spline, coordinate[i], coordinate[i + 1]) for i in falls]
    # the fourth-order error of a spline is small beside a flat maximum
    values = CubicSpline(coordinate, pressure)(places)
    best = int(values.argmax())
    return float(values[best]), float(CubicSpline(coordinate, position)(places[best]))


def _free_surface(beta, x, angle, scale, wall_length) -> np.ndarray:
    """Free surface in y + i z from the jet tip outwards."""
    grid = _grid()
    direction = beta + angle + grid.integral @ x + 2 * x[0]
    log_step = (
        (1 - beta / np.pi) * grid.log_r
        + (beta / np.pi - 0.5) * np.logaddexp(0, grid.log_r)
        + grid.log_size @ x
    )
    step = scale * np.exp(log_step)
    tip = -1j + wall_length * np.exp(1j * beta)
    before = step[0] * np.pi / angle * np.exp(1j * direction[0])
    return tip - before - grid.integral @ (step * np.exp(1j * direction))
