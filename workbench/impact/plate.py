"""Von Karman's and Wagner's outer pressure: that of a flat plate as wide as the wetted part.

.. [vonKarman1929] T. von Karman, "The impact on seaplane floats during landing", NACA TN 321, 1929.
.. [Wagner1932] H. Wagner, "Ueber Stoss- und Gleitvorgaenge an der Oberflaeche von
    Fluessigkeiten", ZAMM 12(4), 193-215, 1932.
"""

from typing import NamedTuple

import numpy as np

from workbench.impact.section import Section, contact_half_breadth, contact_rate


class Instant(NamedTuple):
    """One instant of a water entry, per density: pressures are p/rho [m2/s2].

    ``positions`` [m] go from the centreline to the edge of the pressure, ``pressure``
    [m2/s2] is that of the outer flow, ``cumulative`` [m3/s2] its integral over
    y from 0, ``force`` [m3/s2] the vertical force on both sides.
    """

    half_breadth: float
    rate: float
    positions: np.ndarray
    pressure: np.ndarray
    cumulative: np.ndarray
    force: float
    peak: float
    peak_position: float


EDGE = 16.0
"""Where the stretched coordinate x, y = c tanh(x), ends: 1 - y/c is then 3e-14."""

NODES = 801


def instant(
    section: Section, penetration: float, velocity: float, acceleration: float, pile_up: bool
) -> Instant:
    """Return the instant by Wagner's (``pile_up``) or von Karman's theory.

    Parameters
    ----------
    section : what enters.
    penetration : below calm water [m]; velocity : downwards [m/s]; acceleration : downwards [m/s2].
    pile_up : Wagner's wetted half-breadth; otherwise that of calm water.

    Notes
    -----
    phi = -h' sqrt(c**2 - y**2) on the wetted part, so
    p/rho = h'' sqrt(c**2 - y**2) + h' c c'/sqrt(c**2 - y**2) and the force is
    d/dt(rho pi c**2 h'/2) ([Wagner1932]_, [vonKarman1929]_ with his own c). The peak is that
    of Wagner's spray root, c'**2/2; von Karman's theory has none.
    """
    c = contact_half_breadth(section, penetration, pile_up)
    rate = contact_rate(section, c, velocity, pile_up)
    stretched = np.linspace(0.0, EDGE, NODES)
    y, root = c * np.tanh(stretched), c / np.cosh(stretched)
    angle = 2 * np.arctan(np.tanh(stretched / 2))
    pressure = acceleration * root + velocity * c * rate / root
    cumulative = acceleration / 2 * (y * root + c**2 * angle) + velocity * c * rate * angle
    force = np.pi * (acceleration * c**2 / 2 + velocity * c * rate)
    peak, place = (rate**2 / 2, c) if pile_up else (np.nan, np.nan)
    return Instant(c, rate, y, pressure, cumulative, force, peak, place)
