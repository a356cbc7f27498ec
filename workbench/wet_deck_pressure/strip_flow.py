"""Flow under the wetted intervals of strips: potential, pressure integrated over panels in closed form.

On an interval x = m + l cos(theta) the closing velocity W = sum w_n sin(n theta)/sin(theta) has on the deck the
potential phi = -l sum (w_n/n) sin(n theta), zero on the level of the water beside it. With the water's own
closing acceleration expanded likewise into q_n, and the ends moving through the water at A and B,

    p/rho = -phi_t = l sum (q_n/n) sin(n theta) + B (S_b/2) cot(theta/2) - A (S_a/2) tan(theta/2),

S_b = sum w_n, S_a = sum (-1)**(n-1) w_n ([Wagner1932]_ for any distribution of velocity). An end
that recedes sheds the water without suction: its singular term is dropped, which leaves the linearised exit of
[Korobkin2013]_, and so does an end at the edge of the deck, where the water separates.

.. [Wagner1932] H. Wagner, "Ueber Stoss- und Gleitvorgaenge an der Oberflaeche von
    Fluessigkeiten", ZAMM 12(4), 193-215, 1932.
.. [vonKarman1929] T. von Karman, "The impact on seaplane floats during landing", NACA TN 321, 1929.
.. [Korobkin2013] A. A. Korobkin, "A linearized model of water exit", Journal of Fluid Mechanics 737,
368-386, 2013.
"""

from typing import NamedTuple

import numpy as np

from workbench.impact.wagner import AIR_CUSHION_ANGLE
from workbench.wet_deck_pressure.squared_velocity import taken_by_squared_velocity
from workbench.wet_deck_pressure.strip_profiles import StripProfiles
from workbench.wet_deck_pressure.wetted_interval import ANGLES, COSINES, POINTS, WettedIntervals

MODES = 10
"""Terms of the expansion along an interval."""

SOUND_SPEED = 1500.0
"""Of water [m/s]: no impact gives more than the pressure of a sound wave, rho c W ([vonKarman1929]_)."""

_ORDER = np.arange(1, MODES + 1)
_EXPANSION = 2 / POINTS * np.sin(ANGLES)[:, None] * np.sin(np.outer(ANGLES, _ORDER))
"""Matrix (POINTS, MODES) from values at the quadrature points to the terms of the expansion."""


class PanelFlow(NamedTuple):
    """Integrals over panels of every row, all per density; (K, panels).

    ``potential_impulse`` -int phi dx [m3/s]; ``pressure`` int p/rho dx [m3/s2] at the instant;
    ``drift`` what the speed of the deck through the water adds to the growth of the impulse [m3/s2];
    ``edges`` what separation at the edges of the deck adds [m3/s2]; ``taken`` what the squared velocity takes
    [m3/s2], nothing unless asked for; ``is_spreading`` (K,): whether no free
    end recedes; ``root_pressure`` (K,) largest pressure at a jet root, p/rho [m2/s2]; ``roots`` number of
    jet roots that advance, ``fast_roots`` of those that meet the deck at less than 3 degrees.
    """

    potential_impulse: np.ndarray
    pressure: np.ndarray
    drift: np.ndarray
    edges: np.ndarray
    taken: np.ndarray
    is_spreading: np.ndarray
    root_pressure: np.ndarray
    roots: int
    fast_roots: int


def panel_flow(
    profiles: StripProfiles,
    intervals: WettedIntervals,
    panel_edges: np.ndarray,
    squared_velocity: bool = False,
) -> PanelFlow:
    """Integrate potential and pressure over panels.

    Parameters
    ----------
    profiles : water and deck; intervals : their wetted intervals.
    panel_edges : (panels + 1) places along the strip, growing [m].
    squared_velocity : whether to find what Bernoulli's squared velocity takes from the pressure.

    Notes
    -----
    No point is sampled: the pressure at a jet root is infinite, its integral is not. Costs some 30
    microseconds an interval for 40 panels.
    """
    row = intervals.row
    middle, half = (intervals.aft + intervals.fore) / 2, (intervals.fore - intervals.aft) / 2
    x = middle[:, None] + half[:, None] * COSINES
    velocity = profiles.closing(row, x) @ _EXPANSION
    rate = profiles.closing_rate(row, x) @ _EXPANSION
    at_fore_end, at_aft_end = velocity.sum(axis=1), velocity @ (-1.0) ** (_ORDER - 1)

    cosine = np.clip((panel_edges - middle[:, None]) / half[:, None], -1.0, 1.0)
    angle, sine = np.arccos(cosine), np.sqrt(1 - cosine**2)
    weights = half[:, None, None] ** 2 * np.stack([velocity, rate], axis=1) / _ORDER
    (impulse, of_rate), potential = _sine_integrals(
        angle, sine, cosine, weights, half[:, None] * velocity / _ORDER
    )
    toward_fore = half[:, None] * (np.pi - angle - sine)
    toward_aft = half[:, None] * (np.pi - angle + sine)

    u = profiles.edge_speed
    spreads_fore = np.where(intervals.at_fore, 0.0, np.maximum(intervals.fore_rate, 0.0))
    spreads_aft = np.where(intervals.at_aft, 0.0, np.maximum(-intervals.aft_rate, 0.0))
    fore_term, aft_term = (at_fore_end / 2)[:, None] * toward_fore, (at_aft_end / 2)[:, None] * toward_aft
    pressure = of_rate + spreads_fore[:, None] * fore_term + spreads_aft[:, None] * aft_term
    edges = u * (
        np.where(intervals.at_aft[:, None], aft_term, 0.0)
        - np.where(intervals.at_fore[:, None], fore_term, 0.0)
    )

    count = len(profiles)
    taken = np.zeros_like(pressure)
    if squared_velocity:
        taken = taken_by_squared_velocity(velocity, rate, half, spreads_aft, spreads_fore, angle)
    gathered = [
        _per_row(np.diff(part, axis=1), row, count)
        for part in (impulse, pressure, -u * potential, edges, taken)
    ]
    recedes = ((intervals.fore_rate < 0) & ~intervals.at_fore) | (
        (intervals.aft_rate > 0) & ~intervals.at_aft
    )
    return PanelFlow(
        *gathered,
        np.bincount(row, recedes, count) == 0,
        *_roots(profiles, intervals, np.stack([spreads_aft, spreads_fore], axis=1)),
    )


def _roots(
    profiles: StripProfiles, intervals: WettedIntervals, speed: np.ndarray
) -> tuple[np.ndarray, int, int]:
    """Largest pressure at the jet roots of each row, p/rho = c**2/2 of their speeds (interval, end), and counts."""
    closing = profiles.closing(intervals.row, np.stack([intervals.aft, intervals.fore], axis=1))
    closing = np.maximum(closing, 0.0)
    pressure = np.zeros(len(profiles))
    np.maximum.at(pressure, intervals.row, np.minimum(speed**2 / 2, SOUND_SPEED * closing).max(axis=1))
    moving = (speed > 0) & (closing > 0)
    return (
        pressure,
        int(moving.sum()),
        int((moving & (speed * np.tan(AIR_CUSHION_ANGLE) > np.pi / 2 * closing)).sum()),
    )


def _sine_integrals(angle, sine, cosine, weights, potential_weights):
    """Sums over n of weights times int_angle^pi sin(n t) sin(t) dt, and of potential weights times sin(n angle).

    Chebyshev's recurrence runs through the orders; with c_n = sin(n angle) the integral is
    (c_(n+1)/(n+1) - c_(n-1)/(n-1))/2.
    """
    before, here = np.zeros_like(sine), sine
    total = np.zeros((weights.shape[1], *angle.shape))
    potential = np.zeros_like(angle)
    for n in range(1, MODES + 1):
        after = 2 * cosine * here - before
        if n == 1:
            integral = (np.pi - angle + sine * cosine) / 2
        else:
            integral = (after / (n + 1) - before / (n - 1)) / 2
        for part, weight in zip(total, np.moveaxis(weights, 1, 0), strict=True):
            part += weight[:, n - 1, None] * integral
        potential += potential_weights[:, n - 1, None] * here
        before, here = here, after
    return total, potential


def _per_row(values: np.ndarray, row: np.ndarray, count: int) -> np.ndarray:
    """Sum the values of the intervals of each row (count, panels)."""
    found = np.zeros((count, values.shape[1]))
    if row.size == 0:
        return found
    first = np.flatnonzero(np.concatenate([[True], row[1:] != row[:-1]]))
    found[row[first]] = np.add.reduceat(values, first, axis=0)
    return found
