"""Modified Logvinovich model: Wagner's wetted part, Bernoulli's equation in full on the body.

.. [Korobkin2004] A. A. Korobkin, "Analytical models of water impact", European Journal of
    Applied Mathematics 15, 821-838, 2004.
"""

import numpy as np
from scipy.integrate import cumulative_simpson
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from workbench.impact.plate import EDGE, NODES, Instant
from workbench.impact.section import Section, contact_half_breadth, contact_rate


def instant(section: Section, penetration: float, velocity: float, acceleration: float) -> Instant:
    """Return the instant by the modified Logvinovich model ([Korobkin2004]_).

    Parameters
    ----------
    section : what enters.
    penetration : below calm water [m]; velocity : downwards [m/s]; acceleration : downwards [m/s2].

    Notes
    -----
    On the body phi = -h' sqrt(c**2 - y**2) - h' (f - h), and

        p/rho = h'' (sqrt(c**2 - y**2) + f - h) + h' c c'/sqrt(c**2 - y**2)
                - h'**2/2 (1 + y**2/((c**2 - y**2)(1 + f_y**2))).

    The pressure is integrated to its outermost zero. In y = c tanh(x) the integrand is smooth.
    """
    c = contact_half_breadth(section, penetration, pile_up=True)
    rate = contact_rate(section, c, velocity, pile_up=True)

    def pressure(stretched):
        y = c * np.tanh(stretched)
        rise, slope = section.height(y), section.slope(y)
        return (
            acceleration * (c / np.cosh(stretched) + rise - penetration)
            + velocity * rate * np.cosh(stretched)
            - velocity**2 / 2 * (1 + np.sinh(stretched) ** 2 / (1 + slope**2))
        )

    coarse = np.linspace(0.0, EDGE, NODES)
    above = np.flatnonzero(pressure(coarse) > 0)
    if above.size == 0:
        nothing = np.zeros(2)
        return Instant(c, rate, np.array([0.0, c]), nothing, nothing, 0.0, 0.0, 0.0)
    last = int(above[-1])
    end = EDGE if last == NODES - 1 else brentq(pressure, coarse[last], coarse[last + 1], xtol=1e-14)
    stretched = np.linspace(0.0, end, NODES)
    y, values = c * np.tanh(stretched), pressure(stretched)
    integral = cumulative_simpson(values * c / np.cosh(stretched) ** 2, x=stretched, initial=0.0)
    peak, place = largest(stretched, values)
    return Instant(c, rate, y, values, integral, 2 * float(integral[-1]), peak, c * float(np.tanh(place)))


def largest(x: np.ndarray, values: np.ndarray) -> tuple[float, float]:
    """Return the maximum of smooth values and its place, by a spline through the neighbours of the largest."""
    i = int(values.argmax())
    near = slice(max(i - 4, 0), i + 5)
    if i in (0, len(x) - 1) or len(x[near]) < 5:
        return float(values[i]), float(x[i])
    spline = CubicSpline(x[near], values[near])
    places = np.append(spline.derivative().roots(extrapolate=False), x[i])
    best = int(spline(places).argmax())
    return float(spline(places[best])), float(places[best])
