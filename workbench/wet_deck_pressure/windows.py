"""When the deck is in the water: stretches of a record, and the slams that they make up."""

from typing import NamedTuple

import numpy as np

from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.strips import DeckStrips


class WetStretches(NamedTuple):
    """Stretches of a record in which the deck touches undisturbed water somewhere.

    ``first``, ``last`` samples, both dry unless they are the ends of the record; ``slam`` number of the slam
    that each stretch belongs to; ``is_whole`` (slam,): whether it begins and ends within the record.
    """

    first: np.ndarray
    last: np.ndarray
    slam: np.ndarray
    is_whole: np.ndarray


def wet_stretches(
    motion: DeckMotion, strips: DeckStrips, gap: float, marking: np.ndarray | None = None
) -> WetStretches:
    """Find the wet stretches of a record.

    Parameters
    ----------
    motion : water against the deck; strips : of the deck.
    gap : dry time [s] up to which two stretches are one slam.
    marking : (x, y) whether a panel that gets wet marks a slam; None lets all do so. Panels low beside the
        hulls are in the water so often that no slam would ever end by them.
    """
    height = strips.on_grid(strips.lowest).astype(np.float32)
    if marking is not None:
        height = np.where(marking, height, np.float32(np.inf))
    wet = (motion.rise > height).any(axis=(1, 2))
    change = np.diff(np.concatenate([[0], wet.astype(np.int8), [0]]))
    starts, ends = np.flatnonzero(change == 1), np.flatnonzero(change == -1)
    first, last = np.maximum(starts - 1, 0), np.minimum(ends, len(wet) - 1)
    if first.size == 0:
        return WetStretches(first, last, first, np.zeros(0, bool))
    apart = (starts[1:] - ends[:-1]) * motion.time_step > gap
    slam = np.concatenate([[0], np.cumsum(apart)])
    cut = np.zeros(slam[-1] + 1, bool)
    cut[slam[starts == 0]] = True
    cut[slam[ends == len(wet)]] = True
    return WetStretches(first, last, slam, ~cut)
