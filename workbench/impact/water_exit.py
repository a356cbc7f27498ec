"""Water exit: a section that rises again out of the water.

.. [Korobkin2013] A. A. Korobkin, "A linearized model of water exit", Journal of Fluid Mechanics 737, 368-386, 2013.
.. [vonKarman1929] T. von Karman, "The impact on seaplane floats during landing", NACA TN 321, 1929.
"""

import numpy as np

from workbench.impact.plate import EDGE, NODES, Instant
from workbench.impact.section import Section, contact_half_breadth, contact_rate


def instant(
    section: Section, penetration: float, velocity: float, acceleration: float, pile_up: bool
) -> Instant:
    """Return the instant of a section that rises, per density.

    Parameters
    ----------
    section : what leaves the water.
    penetration : of its lowest point below calm water [m], above 0.
    velocity, acceleration : downwards [m/s], [m/s2]; the velocity is not above 0.
    pile_up : whether the wetted half-breadth is Wagner's; otherwise that of calm water.

    Notes
    -----
    Linearised exit: the flow's rate of change vanishes on the level of the water and the section drags the
    water under it, so p/rho = h'' sqrt(c**2 - y**2) and the force is pi/2 rho h'' c**2, the added mass of
    the present width times the acceleration ([Korobkin2013]_ with the width of [vonKarman1929]_ or Wagner
    in place of his own). An edge that recedes gives no pressure: upward acceleration pulls, downward pushes.
    """
    c = contact_half_breadth(section, penetration, pile_up)
    stretched = np.linspace(0.0, EDGE, NODES)
    y, root = c * np.tanh(stretched), c / np.cosh(stretched)
    angle = 2 * np.arctan(np.tanh(stretched / 2))
    cumulative = acceleration / 2 * (y * root + c**2 * angle)
    rate = contact_rate(section, c, velocity, pile_up)
    force = np.pi / 2 * acceleration * c**2
    return Instant(c, rate, y, acceleration * root, cumulative, force, max(acceleration * c, 0.0), 0.0)
