"""Conservation of volume and momentum in the non-linear water entry, for its verification cases."""

import numpy as np

from workbench.impact.nonlinear import March, flow
from workbench.impact.nonlinear_surface import nearest, on_section


def displaced_area(march: March) -> tuple[float, float]:
    """Return raised water with the jet that was cut off, and body below calm water, right half [m2].

    Beyond the edge the surface rises as 1/y**2.
    """
    depth = march.motion(march.time)[0]
    points = march.surface.points
    body = on_section(march.section, np.linspace(0, nearest(march.section, points[:1])[0], 2000))
    chain = np.concatenate([body, points])
    height = chain.imag - depth
    net = np.sum(np.diff(chain.real) * (height[1:] + height[:-1])) / 2
    below = np.linspace(0, _calm(march, depth), 4000)
    immersed = np.trapezoid(depth - march.section.height(below), below)
    tail = height[-1] * points[-1].real
    return float(net + immersed + tail + march.surface.lost), float(immersed)


def _calm(march: March, depth: float) -> float:
    y = np.linspace(0, march.surface.points[0].real, 200001)
    return float(np.interp(depth, march.section.height(y), y))


def volume_error(march: March, until: float) -> float:
    """Step to a time [s]: change of raised water over that of the immersed body, less 1 [-]."""
    raised, immersed = displaced_area(march)
    march.to(until)
    raised_after, immersed_after = displaced_area(march)
    return (raised_after - raised) / (immersed_after - immersed) - 1


def momentum_ratio(march: March, steps: int) -> float:
    """Force by momentum over force by pressure, over a number of steps [-].

    In each step the boundary is material: -d/dt of the integral of phi dy over body, cut and free surface
    is the force. The momentum that is cut off with the jet never enters.
    """
    gained = impulse = 0.0
    for _ in range(steps):
        before, time = march.surface, march.time
        velocity = march.motion(time)[1]
        force = march.instant().force / 2
        now = flow(march.section, before, velocity)
        step = march.step(np.inf)
        middle = march.motion(time + step / 2)[1]
        after, march.surface = march.surface, before
        halfway = march.moved(now, velocity, step / 2)
        march.surface = before
        moved = march.moved(flow(march.section, halfway, middle), middle, step)
        later = flow(march.section, moved, march.motion(march.time)[1])
        gained += _momentum(now) - _momentum(later)
        march.surface = after
        impulse += step * (force + march.instant().force / 2) / 2
    return gained / impulse


def _momentum(found) -> float:
    y = found.boundary.nodes.real
    return float(np.sum(np.diff(y) * (found.potential[1:] + found.potential[:-1])) / 2)
