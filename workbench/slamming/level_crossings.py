"""Crossings of a level, and peaks above it, in records of many points sampled at even steps.

Each takes one block of samples with a margin of one sample before and two after: blocks that overlap by
three samples (as `workbench.time_domain.record_blocks` makes them) leave nothing out and find nothing twice.
"""

from typing import NamedTuple

import numpy as np


class Crossings(NamedTuple):
    """Crossings (k): ``point``, ``sample`` before it, ``share`` of the step to it [-], ``rate`` per step."""

    point: np.ndarray
    sample: np.ndarray
    share: np.ndarray
    rate: np.ndarray


class Peaks(NamedTuple):
    """Peaks (k): ``point``, ``sample`` nearest to it, ``share`` of the step past that [-], ``height``."""

    point: np.ndarray
    sample: np.ndarray
    share: np.ndarray
    height: np.ndarray


def crossings(rise: np.ndarray, level: np.ndarray, upwards: bool = True) -> Crossings:
    """Crossings of a level between the second and the last sample but one.

    Parameters
    ----------
    rise : (point, sample) record; level : (point, 1), in the same unit.
    upwards : from below to at or above the level; False takes those from there to below it.
    """
    above = rise >= level.astype(rise.dtype)
    before, after = above[:, 1:-2], above[:, 2:-1]
    point, sample = np.nonzero(~before & after if upwards else before & ~after)
    sample = sample + 1
    four = np.stack([rise[point, sample + step] for step in (-1, 0, 1, 2)]).astype(float)
    share, rate = cubic_zero(four - level.ravel()[point])
    return Crossings(point, sample, share, rate)


def cubic_zero(samples: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Zero of the cubic through samples at -1, 0, 1, 2 between 0 and 1, and its slope there (per step)."""
    before, first, second, after = samples
    cubic = (after - before) / 6 + (first - second) / 2
    square = (before + second) / 2 - first
    linear = second - before / 3 - first / 2 - after / 6
    share = first / np.where(first == second, -1.0, first - second)
    for _ in range(4):
        value = first + share * (linear + share * (square + share * cubic))
        slope = linear + share * (2 * square + 3 * share * cubic)
        share = np.clip(share - value / np.where(np.abs(slope) < 1e-12, np.inf, slope), 0.0, 1.0)
    return share, linear + share * (2 * square + 3 * share * cubic)


def peaks(rise: np.ndarray, level: np.ndarray) -> Peaks:
    """Local maxima above a level, from the second to the last sample but two, by the parabola through three.

    Parameters
    ----------
    rise : (point, sample) record; level : (point, 1), in the same unit.

    Notes
    -----
    The error of a wave sampled in steps dt is of the order of (omega dt)**4 of its amplitude.
    """
    before, middle, after = rise[:, :-3], rise[:, 1:-2], rise[:, 2:-1]
    point, sample = np.nonzero((middle > before) & (middle >= after) & (middle >= level))
    sample = sample + 1
    three = np.stack([rise[point, sample + step] for step in (-1, 0, 1)]).astype(float)
    three -= level.ravel()[point]
    curvature = three[0] - 2 * three[1] + three[2]
    share = (three[0] - three[2]) / 2 / np.where(curvature == 0, np.inf, curvature)
    return Peaks(point, sample, share, three[1] + (three[2] - three[0]) / 4 * share)
