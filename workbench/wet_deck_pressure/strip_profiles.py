"""Water against strips of the deck at many instants: penetration, velocity and acceleration anywhere along them."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline


@dataclass(frozen=True, eq=False)
class StripProfiles:
    """Water and deck along strips at K instants; a row is one strip at one instant.

    Parameters
    ----------
    nodes : evenly spaced places along the strip (n) [m].
    rise, velocity, acceleration : (K, n) of the water against the deck [m], [m/s], [m/s2]; velocity and
        acceleration follow the water particle where the ship moves.
    start, end : of the strip [m].
    table : (S, m) what the deck stands higher than ``rise`` counts from, at evenly spaced places from start
        to end [m].
    strip : (K,) strip of each row.
    edge_speed : speed of the deck along the strip through the water [m/s].
    """

    nodes: np.ndarray
    rise: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    start: float
    end: float
    table: np.ndarray
    strip: np.ndarray
    edge_speed: float = 0.0

    def __post_init__(self):
        object.__setattr__(self, "_has_table", bool(np.any(self.table)))
        slopes = slope_operator(self.nodes).T
        for name in ("rise", "velocity", "acceleration"):
            object.__setattr__(self, f"_{name}_slopes", getattr(self, name) @ slopes)

    def __len__(self) -> int:
        return len(self.strip)

    def rows(self, chosen: np.ndarray) -> "StripProfiles":
        """Return the profiles of some rows."""
        return StripProfiles(
            self.nodes,
            self.rise[chosen],
            self.velocity[chosen],
            self.acceleration[chosen],
            self.start,
            self.end,
            self.table,
            self.strip[chosen],
            self.edge_speed,
        )

    def penetration(self, rows: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Height of the water above the deck [m] and its slope along the strip [-] at places x (rows, q)."""
        rise, slope = self._cubic(self.rise, self._rise_slopes, rows, x)
        if not self._has_table:
            return rise, slope
        deck, deck_slope = self.deck(rows, x)
        return rise - deck, slope - deck_slope

    def closing(self, rows: np.ndarray, x: np.ndarray) -> np.ndarray:
        """Closing velocity of water and deck [m/s] at places x (rows, q)."""
        return self._cubic(self.velocity, self._velocity_slopes, rows, x)[0]

    def closing_rate(self, rows: np.ndarray, x: np.ndarray) -> np.ndarray:
        """Closing acceleration of water and deck [m/s2] at places x (rows, q)."""
        return self._cubic(self.acceleration, self._acceleration_slopes, rows, x)[0]

    def deck(self, rows: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Height [m] and slope [-] of the deck at places x (rows, q)."""
        last = self.table.shape[1] - 1
        step = (self.end - self.start) / last
        place = (x - self.start) / step
        index = np.clip(place.astype(int), 0, last - 1)
        flat = self.strip[rows][:, None] * (last + 1) + index
        table = self.table.ravel()
        low, high = table[flat], table[flat + 1]
        return low + (place - index) * (high - low), (high - low) / step

    def on_grid(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """Places (count,) from start to end and the penetration there (K, count) [m]."""
        places = np.linspace(self.start, self.end, count)
        rise = self.rise @ value_operator(self.nodes, places).T
        share = np.linspace(0, self.table.shape[1] - 1, count)
        index = np.minimum(share.astype(int), self.table.shape[1] - 2)
        part = share - index
        deck = self.table[:, index] * (1 - part) + self.table[:, index + 1] * part
        return places, rise - deck[self.strip]

    def _place(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
        if len(self.nodes) == 1:
            return np.zeros(x.shape, int), np.zeros(x.shape), 1.0
        step = self.nodes[1] - self.nodes[0]
        place = (x - self.nodes[0]) / step
        index = np.clip(place.astype(int), 0, len(self.nodes) - 2)
        return index, place - index, step

    def _cubic(self, values, slopes, rows, x) -> tuple[np.ndarray, np.ndarray]:
        index, t, step = self._place(x)
        count = values.shape[1]
        flat = rows[:, None] * count + index
        values, slopes = values.ravel(), slopes.ravel()
        if count == 1:
            return values[flat], np.zeros(x.shape)
        low, left = np.take(values, flat), np.take(slopes, flat)
        flat += 1
        jump, right = np.take(values, flat), np.take(slopes, flat)
        jump -= low
        left *= step
        right *= step
        cube = left + right - 2 * jump
        square = jump - left - cube
        return low + t * (left + t * (square + t * cube)), (left + t * (2 * square + 3 * t * cube)) / step


def slope_operator(nodes: np.ndarray) -> np.ndarray:
    """Matrix (n, n) from values at nodes to the slopes of their cubic spline there."""
    if len(nodes) == 1:
        return np.zeros((1, 1))
    return CubicSpline(nodes, np.eye(len(nodes)))(nodes, 1)


def value_operator(nodes: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Matrix (places, n) from values at nodes to those of their cubic spline at places."""
    if len(nodes) == 1:
        return np.ones((len(places), 1))
    return CubicSpline(nodes, np.eye(len(nodes)))(places)
