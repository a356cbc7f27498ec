"""Records of a model that slams in a regular wave, made from known motions."""

import numpy as np
import xarray as xr

from workbench.impact.regular_motion import RegularMotion
from workbench.impact.regular_wave import RegularWave
from workbench.records.reading import record

WAVE = RegularWave(amplitude=0.09, period=1.71, speed=1.0)
MOTION = RegularMotion(
    wave=WAVE, heave_amplitude=0.08, heave_lead=-1.6, pitch_amplitude=0.12, pitch_lead=-2.6
)
LEVER, CLEARANCE, PROBE = 1.3, 0.12, 0.9
"""Gauge forward of the centre of gravity, clearance of the deck and probe ahead of the gauge [m]."""

PERIOD = 2 * np.pi / WAVE.encounter_frequency
SHAPE = {"P1": 1.0, "P2": 0.6, "P3": 0.2, "P6": 0.4, "P7": 0.5, "P8": 0.8}
DELAY = {"P1": 0.0, "P2": 0.002, "P3": 0.004, "P6": 0.003, "P7": 0.003, "P8": 0.001}
"""Peaks of the gauges over the highest one, and how much later they come [s]."""


def pulse(time, instant: float, rise: float = 0.002, decay: float = 0.012):
    """Pressure that rises by a line and falls by an exponential, peak 1."""
    after = np.asarray(time, float) - instant
    return np.where(after < 0, np.clip(1 + after / rise, 0, 1), np.exp(-np.maximum(after, 0) / decay))


def instants(count: int) -> np.ndarray:
    """Times of the first impacts of the gauge, one an encounter."""
    return float(MOTION.impact_instant(LEVER, CLEARANCE)) + PERIOD * np.arange(1, count + 1)


def slam_record(pressure: float = 20e3, count: int = 3, step: float = 0.0005) -> xr.Dataset:
    """Record with pitch (bow down positive, in degrees), heave, wave at the probe and the gauges (time, channel)."""
    time = np.arange(0, (count + 2) * PERIOD, step)
    turn = WAVE.encounter_frequency * time
    channels = {
        "pitch": -np.degrees(0.12 * np.cos(turn - 2.6)),
        "heave": 0.08 * np.cos(turn - 1.6),
        "wave": 0.09 * np.cos(WAVE.wavenumber * (LEVER + PROBE) + turn),
    }
    for gauge, share in SHAPE.items():
        channels[gauge] = share * pressure * sum(pulse(time, at + DELAY[gauge]) for at in instants(count))
    units = ["?", "m", "m", *["Pa"] * len(SHAPE)]
    return record(time, np.stack(list(channels.values()), axis=1), list(channels), units)
