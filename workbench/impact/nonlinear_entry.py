"""Instants of the non-linear water entry at given times: a wedge at constant velocity once for all, others stepped."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from scipy.optimize import brentq

from workbench.errors import InputError
from workbench.impact import nonlinear_start
from workbench.impact.nonlinear import COURANT, MOST_STEPS, March
from workbench.impact.nonlinear_surface import grading
from workbench.impact.plate import Instant
from workbench.impact.section import Section, Wedge, contact_half_breadth

ESTIMATED = 60
SETTLING_STEPS, SETTLING_GROWTH = 160, 2.5
"""A wedge at constant velocity is stepped so often, or until it has gone deeper by this factor."""


def instants(
    section: Section, motion: Callable, times: np.ndarray, constant: bool
) -> tuple[list[Instant], np.ndarray]:
    """Return the instants, and the free surfaces y + i z above calm water from the cut outwards, (time, point) [m].

    Parameters
    ----------
    section : what enters.
    motion : gives penetration [m], velocity [m/s] and acceleration [m/s2] at a time [s].
    times : growing, above 0 [s].
    constant : the velocity does not change.

    Notes
    -----
    About 10 ms a step on one core. A wedge takes 160 steps at constant velocity at any time; otherwise the
    number grows as 1/tan(beta)**2, for a wedge of 10 degrees 1800 per factor e of penetration.
    """
    if constant and isinstance(section, Wedge):
        pairs = []
        for time in times:
            depth, velocity, _ = motion(float(time))
            found, surface = settled_wedge(section.deadrise_angle)
            pairs.append((_scaled(found, depth, velocity), depth * surface))
    else:
        march = begun(section, motion, float(times[0]))
        _check_steps(section, motion(march.time)[0], motion(float(times[-1]))[0])
        pairs = []
        for time in times:
            march.to(float(time))
            pairs.append((march.instant(), march.free_surface()))
    return [found for found, _ in pairs], np.array([surface for _, surface in pairs])


def expected_steps(section: Section, first: float, last: float) -> float:
    """Number of steps from one penetration to another [m], by Wagner's theory.

    A step is as long as the water of the jet, twice as fast as the spray root, takes for one element.
    """
    ends = [contact_half_breadth(section, depth, pile_up=True) for depth in (first, last)]
    breadth = np.geomspace(*ends, ESTIMATED)
    element = np.array([grading(section, float(c)).root for c in breadth])
    return float(np.trapezoid(2 / (COURANT * element), breadth))


def _check_steps(section: Section, first: float, last: float) -> None:
    reach = section.mean_height(section.reach) if np.isfinite(section.reach) else np.inf
    expected = expected_steps(section, first, min(last, 0.999 * reach))
    if expected > MOST_STEPS:
        raise InputError(
            f"The {section.kind} is so flat that the non-linear method needs about {expected:.0f} steps, more than "
            f"{MOST_STEPS}; take generalised-wagner, or instants nearer to each other."
        )


def begun(section: Section, motion: Callable, first: float) -> March:
    """Return the entry at its start, early enough for a first instant at a time [s]."""
    depth = nonlinear_start.starting_penetration(section, motion(first)[0])
    start = float(brentq(lambda time: motion(time)[0] - depth, 0.0, first, xtol=1e-14 * first))
    velocity = motion(start)[1]
    return March(section, motion, start, nonlinear_start.started(section, depth, velocity))


@lru_cache(maxsize=32)
def settled_wedge(deadrise_angle: float) -> tuple[Instant, np.ndarray]:
    """Return a wedge [rad] at constant velocity and its free surface, for penetration 1 m and 1 m/s."""
    wedge = Wedge(deadrise_angle)
    march = March(wedge, lambda time: (time, 1.0, 0.0), 1.0, nonlinear_start.started(wedge, 1.0, 1.0))
    while march.steps < SETTLING_STEPS and march.time < SETTLING_GROWTH:
        march.step(SETTLING_GROWTH)
    found = _scaled(march.instant(), 1 / march.time, 1.0)
    return found._replace(rate=found.half_breadth), march.free_surface() / march.time


def _scaled(found: Instant, length: float, velocity: float) -> Instant:
    """Return the instant of a similar flow of other size and velocity."""
    head = velocity**2
    return Instant(
        length * found.half_breadth,
        velocity * found.rate,
        length * found.positions,
        head * found.pressure,
        length * head * found.cumulative,
        length * head * found.force,
        head * found.peak,
        length * found.peak_position,
    )
