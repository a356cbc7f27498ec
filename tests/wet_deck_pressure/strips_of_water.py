"""Water whose rise against a flat deck is known in closed form."""

import numpy as np

from workbench.design import WetDeck
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.strip_profiles import StripProfiles
from workbench.wet_deck_pressure.strips import deck_strips

RHO = 1000.0


def flat_deck(length=60.0, width=4.0, clearance=2.0, points=(40, 2), **others):
    wet_deck = WetDeck(aft=-length / 2, fore=length / 2, width=width, clearance=clearance, **others)
    return wet_deck, wet_deck_grid(wet_deck, *points)


def moved(
    rise, velocity, acceleration, wet_deck, grid, duration, time_step=0.02, speed=0.0, direction="auto"
):
    """Deck motion and strips of rise, velocity and acceleration as functions of (t, x, y), above the clearance."""
    times = (np.arange(round(duration / time_step) + 1) * time_step)[:, None, None]
    x, y = grid.x.values[None, :, None], grid.y.values[None, None, :]

    def sampled(function):
        return np.broadcast_to(np.asarray(function(times, x, y), float), (len(times), x.size, y.size)).copy()

    motion = DeckMotion(
        grid.x.values,
        grid.y.values,
        time_step,
        sampled(rise) + wet_deck.clearance,
        sampled(velocity),
        sampled(acceleration),
        speed,
    )
    return motion, deck_strips(wet_deck, grid, direction)


def crest(curvature, velocity, celerity, speed=0.0, start=0.0):
    """Rise, D rise and D D rise of a crest of constant curvature that rises and runs aft, met at a speed."""
    met = celerity + speed  # of the crest past the deck

    def rise(t, x, y):
        return velocity * (t - start) - curvature * (x + met * (t - start)) ** 2 / 2 + 0 * y

    def closing(t, x, y):
        return velocity - curvature * celerity * (x + met * (t - start)) + 0 * y

    def rate(t, x, y):
        return -curvature * celerity**2 + 0 * (t + x + y)

    return rise, closing, rate


def profiles_of(rise, velocity, acceleration, times, nodes, half_length, speed=0.0):
    times, x = np.asarray(times)[:, None], nodes[None, :]
    shape = (len(times), len(nodes))
    fields = [
        np.broadcast_to(function(times, x, 0.0), shape).copy() for function in (rise, velocity, acceleration)
    ]
    table = np.zeros((1, 16 * len(nodes) + 1))
    return StripProfiles(nodes, *fields, -half_length, half_length, table, np.zeros(len(times), int), speed)
