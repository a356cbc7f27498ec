"""Where strips of the deck are wet: Wagner's condition for both ends of every wetted interval.

With h the height of the undisturbed water above the deck (negative where it is below), the
water meets the deck at the ends a, b of an interval with a finite jet root only if

    int_a^b h sqrt((x-a)/(b-x)) dx = 0   and   int_a^b h sqrt((b-x)/(x-a)) dx = 0,

[Wagner1932]_, in the form of the displacement potential. Where the water has reached an end of the strip it
leaves the deck there, and the condition whose weight is singular at that end falls away. With x = m + l
cos(theta) both are sums over Gauss-Chebyshev points.

.. [Wagner1932] H. Wagner, "Ueber Stoss- und Gleitvorgaenge an der Oberflaeche von
    Fluessigkeiten", ZAMM 12(4), 193-215, 1932.
"""

from typing import NamedTuple

import numpy as np

from workbench.wet_deck_pressure.strip_profiles import StripProfiles

POINTS = 32
"""Points of the quadrature over an interval."""

ANGLES = (np.arange(POINTS) + 0.5) * np.pi / POINTS
COSINES = np.cos(ANGLES)

_ITERATIONS = 40
_SETTLED = 1e-7
_SEARCH_PER_NODE = 3
_LEAST_SEARCH = 64
_OPENING = 1.45
"""First guess: Wagner's interval over the one that calm water cuts, between a crest's 1.41 and a wedge's 1.57."""


class WettedIntervals(NamedTuple):
    """Wetted intervals, several a row at the most, ordered by row and place.

    ``row`` of the profiles; ends ``aft``, ``fore`` [m]; ``at_aft``, ``at_fore``: whether they lie at the
    ends of the strip; ``aft_rate``, ``fore_rate``: speeds of the ends through the water [m/s], forward
    positive; ``settled``: whether Newton's method found them (else they are where undisturbed water cuts the
    deck).
    """

    row: np.ndarray
    aft: np.ndarray
    fore: np.ndarray
    at_aft: np.ndarray
    at_fore: np.ndarray
    aft_rate: np.ndarray
    fore_rate: np.ndarray
    settled: np.ndarray


def wetted_intervals(profiles: StripProfiles) -> WettedIntervals:
    """Return the wetted intervals of all rows, with the pile-up of the water.

    Parameters
    ----------
    profiles : water and deck along the strips.

    Notes
    -----
    Starts from where undisturbed water stands above the deck. Intervals that the pile-up lets touch, and
    such as have no solution beside their neighbour, are solved again as one. Costs some 25 microseconds a row.
    """
    row, aft, fore = _cut_by_undisturbed_water(profiles)
    cut = aft, fore
    aft, fore, settled = _solve(profiles, row, *_opened(profiles, aft, fore))
    aft, fore = np.where(settled, aft, cut[0]), np.where(settled, fore, cut[1])
    while True:
        unresolved = ~settled[1:] | ~settled[:-1]
        touching = (row[1:] == row[:-1]) & ((aft[1:] <= fore[:-1]) | unresolved)
        if not touching.any():
            break
        first = np.flatnonzero(np.concatenate([[True], ~touching]))
        is_merged = np.add.reduceat(np.ones(len(row), int), first) > 1
        row, low, high = row[first], np.minimum.reduceat(aft, first), np.maximum.reduceat(fore, first)
        aft, fore, settled = low.copy(), high.copy(), settled[first]
        one = np.flatnonzero(is_merged)
        new_aft, new_fore, good = _solve(profiles, row[one], low[one], high[one])
        aft[one], fore[one] = np.where(good, new_aft, low[one]), np.where(good, new_fore, high[one])
        settled[one] = good
    at_aft, at_fore = aft <= profiles.start, fore >= profiles.end
    rates = _rates(profiles, row, aft, fore, at_aft, at_fore)
    return WettedIntervals(row, aft, fore, at_aft, at_fore, *rates, settled)


def _cut_by_undisturbed_water(profiles: StripProfiles) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rows and ends of the intervals in which undisturbed water stands above the deck."""
    count = max(_LEAST_SEARCH, _SEARCH_PER_NODE * len(profiles.nodes)) + 1
    places, height = profiles.on_grid(count)
    wet = np.zeros((len(profiles), count + 2), np.int8)
    wet[:, 1:-1] = height > 0
    change = np.diff(wet, axis=1)
    row, first = np.nonzero(change == 1)
    last = np.nonzero(change == -1)[1] - 1

    def end(inside: np.ndarray, outside: np.ndarray) -> np.ndarray:
        there = np.clip(outside, 0, count - 1)
        high, low = height[row, inside], height[row, there]
        share = np.where(there == outside, high / np.where(high > low, high - low, 1.0), 0.0)
        return places[inside] + share * (places[there] - places[inside])

    return row, end(first, first - 1), end(last, last + 1)


def _opened(profiles: StripProfiles, aft: np.ndarray, fore: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """First guess of the ends."""
    middle, half = (aft + fore) / 2, (fore - aft) / 2
    half = np.maximum(_OPENING * half, 1e-6 * (profiles.end - profiles.start))
    return np.maximum(middle - half, profiles.start), np.minimum(middle + half, profiles.end)


def _sums(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Means of values (k, POINTS) times 1 - cos and 1 + cos: the conditions at the aft and at the fore end."""
    mean, tilted = values.mean(axis=1), values @ COSINES / POINTS
    return mean - tilted, mean + tilted


def _places(aft: np.ndarray, fore: np.ndarray) -> np.ndarray:
    return (aft + fore)[:, None] / 2 + (fore - aft)[:, None] / 2 * COSINES


def _jacobian(slope: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Derivatives of the aft condition by the aft end, of either by the other end, of the fore one by the fore end."""
    mean, once, twice = slope.mean(axis=1), slope @ COSINES / POINTS, slope @ COSINES**2 / POINTS
    return (mean - 2 * once + twice) / 2, (mean - twice) / 2, (mean + 2 * once + twice) / 2


def _change(conditions, jacobian, at_aft, at_fore) -> tuple[np.ndarray, np.ndarray]:
    """Changes of the ends that make the conditions vanish, ends that stand fixed left alone."""
    (c_aft, c_fore), (aa, af, ff) = conditions, jacobian
    determinant = aa * ff - af**2
    with np.errstate(divide="ignore", invalid="ignore"):
        both = (af * c_fore - ff * c_aft) / determinant, (af * c_aft - aa * c_fore) / determinant
        alone = -c_aft / aa, -c_fore / ff
    aft = np.where(at_aft, 0.0, np.where(at_fore, alone[0], both[0]))
    fore = np.where(at_fore, 0.0, np.where(at_aft, alone[1], both[1]))
    return np.nan_to_num(aft), np.nan_to_num(fore)


def _solve(profiles: StripProfiles, row, aft, fore) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Newton's method with an active set: an end that leaves the strip stands at its edge while water presses on."""
    aft, fore = aft.copy(), fore.copy()
    settled = np.zeros(len(row), bool)
    going = np.arange(len(row))
    tiny = 1e-6 * (profiles.end - profiles.start)
    for _ in range(_ITERATIONS):
        if going.size == 0:
            break
        a, b = aft[going], fore[going]
        height, slope = profiles.penetration(row[going], _places(a, b))
        conditions = _sums(height)
        at_aft = (a <= profiles.start) & (conditions[0] > 0)
        at_fore = (b >= profiles.end) & (conditions[1] > 0)
        step_aft, step_fore = _change(conditions, _jacobian(slope), at_aft, at_fore)
        most = 0.35 * (b - a)
        step_aft, step_fore = np.clip(step_aft, -most, most), np.clip(step_fore, -most, most)
        new_a = np.clip(a + step_aft, profiles.start, profiles.end - tiny)
        new_b = np.clip(b + step_fore, new_a + tiny, profiles.end)
        aft[going], fore[going] = new_a, new_b
        moved = np.maximum(np.abs(new_a - a), np.abs(new_b - b))
        done = moved <= _SETTLED * np.maximum(b - a, tiny)
        settled[going[done]] = True
        going = going[~done]
    return aft, fore, settled


def _rates(profiles, row, aft, fore, at_aft, at_fore) -> tuple[np.ndarray, np.ndarray]:
    """Speeds of the ends through the water: the conditions followed in time with the water's closing velocity."""
    x = _places(aft, fore)
    slope = profiles.penetration(row, x)[1]
    c_aft, c_fore = _sums(profiles.closing(row, x))
    aa, af, ff = _jacobian(slope)
    u = profiles.edge_speed
    c_aft = c_aft + np.where(at_fore, af * u, 0.0)
    c_fore = c_fore + np.where(at_aft, af * u, 0.0)
    rate_aft, rate_fore = _change((c_aft, c_fore), (aa, af, ff), at_aft, at_fore)
    return np.where(at_aft, u, rate_aft), np.where(at_fore, u, rate_fore)
