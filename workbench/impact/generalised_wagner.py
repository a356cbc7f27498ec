"""Generalised Wagner model of a wedge: body condition on the true side, water at rest on the level of its edge.

.. [Zhao1996] R. Zhao, O. M. Faltinsen and J. V. Aarsnes, "Water entry of arbitrary two-dimensional
    sections with and without flow separation", 21st Symposium on Naval Hydrodynamics, 1996.
.. [Mei1999] X. Mei, Y. Liu and D. K. P. Yue, "On the water impact of general two-dimensional
    sections", Applied Ocean Research 21, 1-15, 1999.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_simpson
from scipy.special import beta as beta_function

from workbench.impact.logvinovich import largest
from workbench.impact.plate import Instant

SHARE_NODES = 4001


class WedgeFlow(NamedTuple):
    """Flow about the wetted wedge of unit half-breadth at unit velocity.

    ``spread`` is c/(V t). Over the side, from the contact point to the apex:
    ``stretched`` coordinate, ``position`` s = y/c, ``slope_factor`` ds/d(stretched), potential
    ``potential`` Theta(s), its ``derivative``, and the ``speed`` along the side. Over the level of the edge,
    outwards: ``log_level`` ln(s - 1) and ``risen``, the integral of V_rel/V over ds/s**2 from s to infinity.
    """

    spread: float
    stretched: np.ndarray
    position: np.ndarray
    slope_factor: np.ndarray
    potential: np.ndarray
    derivative: np.ndarray
    speed: np.ndarray
    log_level: np.ndarray
    risen: np.ndarray


@lru_cache(maxsize=64)
def wedge_flow(deadrise_angle: float) -> WedgeFlow:
    """Return the flow about a wedge [rad] whose edges lie on the level where the potential vanishes.

    Notes
    -----
    The half-plane of w maps on the water beside wedge and mirror image by
    dz/dw = C w**(1 - 2 beta/pi) (w**2 - 1)**(beta/pi - 1/2) ([Mei1999]_). The side, from
    w = 0 (edge) to 1 (apex), has the length c/cos(beta), hence
    C/c = 2/(cos(beta) B(1 - beta/pi, beta/pi + 1/2)). The edge is where the water, rising past the
    body with its velocity on that level, meets the side ([Zhao1996]_):
    c tan(beta)/(V t) = integral of V_rel/V over ds/s**2 from 1 to infinity.
    """
    e = deadrise_angle / np.pi
    scale = 2 / (np.cos(deadrise_angle) * beta_function(1 - e, e + 0.5))
    u = np.linspace(-45.0, 45.0, SHARE_NODES)
    outside = np.exp(u)
    growth = outside ** (1 - 2 * e) * (1 + outside**2) ** (e - 0.5)
    near = growth[0] * outside[0] / (2 - 2 * e)
    beyond = scale * (near + cumulative_simpson(growth * outside, x=u, initial=0.0))
    share = outside / (1 + beyond) ** 2
    spread = scale * np.trapezoid(share, u) / np.tan(deadrise_angle)
    risen = scale * cumulative_simpson(share[::-1], x=u, initial=0.0)[::-1]

    v = np.linspace(-60.0, 40.0 / (e + 0.5), SHARE_NODES)
    log_w, log_rest = -np.logaddexp(0, -v), -np.logaddexp(0, v)
    w = np.exp(log_w)
    growth = np.exp((1 - 2 * e) * log_w + (e - 0.5) * (log_rest + np.log1p(w)))
    inside = scale * growth * np.exp(log_w + log_rest)
    along = cumulative_simpson(inside, x=v, initial=0.0)
    position = 1 - np.cos(deadrise_angle) * along
    potential = -(scale * w - np.sin(deadrise_angle) * along)
    derivative = (1 / growth - np.sin(deadrise_angle)) / np.cos(deadrise_angle)
    speed = 1 / growth
    position[-1], speed[-1] = 0.0, 0.0
    return WedgeFlow(
        float(spread),
        v,
        position,
        np.cos(deadrise_angle) * inside,
        potential,
        derivative,
        speed,
        np.log(beyond),
        risen,
    )


def instant(deadrise_angle: float, penetration: float, velocity: float, acceleration: float) -> Instant:
    """Return the instant of a wedge by the generalised Wagner model.

    Parameters
    ----------
    deadrise_angle : [rad].
    penetration : below calm water [m]; velocity : downwards [m/s]; acceleration : downwards [m/s2].

    Notes
    -----
    phi = h' c Theta(y/c) on the side and
    p/rho = -h'' c Theta - h' c' (Theta - s Theta') + (h'**2 - u**2)/2 with the
    velocity u along the side, seen from the body. The negative part at the edge is left out.
    """
    flow = wedge_flow(deadrise_angle)
    c, rate = flow.spread * penetration, flow.spread * velocity
    values = (
        -acceleration * c * flow.potential
        - velocity * rate * (flow.potential - flow.position * flow.derivative)
        + velocity**2 * (1 - flow.speed**2) / 2
    )
    inward = np.flatnonzero(values > 0)
    start = int(inward[0]) if inward.size else len(values) - 1
    peak, place = largest(flow.stretched, values)
    share = np.maximum(values, 0.0) * flow.slope_factor * c
    integral = cumulative_simpson(share, x=flow.stretched, initial=0.0)
    total = float(integral[-1])
    positions = c * np.clip(flow.position[::-1], 0.0, None)
    cut = len(values) - start
    return Instant(
        c,
        rate,
        positions[:cut],
        np.maximum(values, 0.0)[::-1][:cut],
        (total - integral[::-1])[:cut],
        2 * total,
        peak,
        c * float(np.interp(place, flow.stretched, flow.position)),
    )
