"""The Delft 372 in regular waves of the measured height, simulated in time with forces on the hull as it is wet.

What a linear theory leaves out at Fn 0.75 - a flat stern that leaves the water - is in these
runs, at the wave amplitudes of the towing tank. The published offsets end 50 mm above still
water; the sides are continued upright here, so that the water does not close over the hull.
"""

from dataclasses import replace
from functools import cache

import numpy as np

from workbench import pipeline
from workbench.conventions import GRAVITY, MODES
from workbench.design import Design
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.simulation_stage import simulated_regular_wave
from workbench.verification import delft, published

FREEBOARD = 0.25
"""Height to which the sides are continued above the highest published waterline [m]."""
SETTLING, MEASURED = 6, 12
"""Encounter periods left out, and fitted."""


@cache
def high_sided_model() -> Design:
    """The towed model with upright sides above her offsets."""
    ship = delft.model()
    shape = ship.hull.shape
    stations = tuple(
        (x, (*points, (points[-1][0] + FREEBOARD, points[-1][1])) if len(points) > 1 else points)
        for x, points in shape.stations
    )
    return replace(ship, hull=replace(ship.hull, shape=replace(shape, stations=stations)))


@cache
def _harmonics(froude_number: float) -> np.ndarray:
    """First harmonics of all motions over the wave amplitude (waves, 6)."""
    table = published.columns("veer_1998_head_sea_motions", froude_number=froude_number)
    ship = high_sided_model()
    speed = froude_number * np.sqrt(GRAVITY * delft.LENGTH)

    def respond(directions, frequencies):
        return pipeline.response(ship, speed, directions, frequencies, HighSpeedSettings())

    found = []
    waves = zip(
        delft.wave_frequency(table["wavelength_over_length"]), table["wave_amplitude_mm"] / 1000, strict=True
    )
    for omega, amplitude in waves:
        encounter = omega + omega**2 / GRAVITY * speed
        period = 2 * np.pi / encounter
        record = simulated_regular_wave(
            ship, speed, np.pi, float(amplitude), float(omega), respond,
            hours=(SETTLING + MEASURED) * period / 3600, time_step=period / 60,
        )  # fmt: skip
        time = record.time.values
        kept = time >= SETTLING * period
        turned = record.motion.values[kept] * np.exp(1j * encounter * time[kept])[:, None]
        found.append(2 * turned.mean(axis=0) / amplitude)
    return np.array(found)


def towed_in_time(froude_number: float, mode: str) -> delft.Comparison:
    """Heave, or pitch over wave slope, in waves of the measured amplitude."""
    table = published.columns("veer_1998_head_sea_motions", froude_number=froude_number)
    ratios = table["wavelength_over_length"]
    computed = np.abs(_harmonics(froude_number)[:, MODES.index(mode)])
    if mode == "pitch":
        computed = computed * delft.LENGTH * ratios / (2 * np.pi)
    none = np.zeros(0)
    return delft.Comparison(ratios, table[mode], computed, none, none)
