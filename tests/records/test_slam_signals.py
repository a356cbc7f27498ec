"""Slams planted in acceleration records, and found again."""

import numpy as np
import pytest
from random_seas import sines

from workbench.errors import InputError
from workbench.records.slam_signals import (
    RingDown,
    detection,
    matched_slams,
    ring_down,
    slams_above,
)

STEP = 0.01
TIME = np.arange(0, 600, STEP)
RINGING = RingDown(omega=2 * np.pi * 9.0, damping_ratio=0.04)
QUICKEST = 2 * np.pi * 3.0
BLOWS = np.arange(10.0, 590.0, 10.0) + np.random.default_rng(3).uniform(0, 5, 58)


def made(amplitude=1.0, noise=0.4, seed=1, blows=BLOWS):
    waves = sines(height=2.0, peak_period=5.0, low=0.8, high=3.5)
    record = waves.at(TIME, -(waves.omega**2)) + np.random.default_rng(seed).normal(0, noise, len(TIME))
    for blow in blows:
        start = int(blow / STEP)
        after = TIME[start : start + 400] - blow
        record[start : start + 400] += amplitude * RINGING.signal(after)
    return record


def test_clear_slams_are_found_by_a_threshold():
    found = slams_above(made(amplitude=5.0, noise=0.1), STEP, 2.0, QUICKEST)
    assert detection(found.event_time.values, BLOWS, 0.2) == (len(BLOWS), 0, 0)
    assert found.slam_acceleration.values == pytest.approx(5.0, rel=0.2)


def test_filter_finds_slams_that_a_threshold_cannot():
    record = made(amplitude=1.0, noise=0.4)
    matched = matched_slams(record, STEP, RINGING, QUICKEST)
    hits, _, false = detection(matched.event_time.values, BLOWS, 0.15)
    assert hits >= 0.97 * len(BLOWS)
    assert false <= 1
    assert np.median(np.abs(matched.slam_acceleration.values)) == pytest.approx(1.0, rel=0.15)
    best = max(
        hits - false
        for hits, _, false in (
            detection(slams_above(record, STEP, level, QUICKEST).event_time.values, BLOWS, 0.15)
            for level in np.arange(0.6, 2.0, 0.1)
        )
    )
    assert best < 0.7 * (hits - false)


def test_threshold_of_the_filter_is_in_deviations_of_its_noise():
    quiet = made(blows=())
    assert matched_slams(quiet, STEP, RINGING, QUICKEST).sizes["event"] == 0
    assert matched_slams(quiet, STEP, RINGING, QUICKEST, strength=2.0).sizes["event"] > 100


def test_ringing_is_read_from_the_autocorrelation():
    found = ring_down(made(amplitude=2.0, noise=0.2), STEP, QUICKEST)
    assert found.omega == pytest.approx(RINGING.omega, rel=0.02)
    assert found.damping_ratio == pytest.approx(RINGING.damping_ratio, rel=0.4)
    matched = matched_slams(made(amplitude=1.0), STEP, found, QUICKEST)
    assert detection(matched.event_time.values, BLOWS, 0.2)[0] >= 0.95 * len(BLOWS)


def test_downward_first_swings_are_signed():
    matched = matched_slams(made(amplitude=-3.0, noise=0.1), STEP, RINGING, QUICKEST)
    assert detection(matched.event_time.values, BLOWS, 0.1)[0] == len(BLOWS)
    assert np.median(matched.slam_acceleration.values) == pytest.approx(-3.0, rel=0.15)


def test_pairs_are_one_to_one():
    assert detection([1.0, 1.1, 5.0], [1.05, 9.0], 0.2) == (1, 1, 2)
    assert detection([], [1.0], 0.2) == (0, 1, 0)


def test_refusals():
    with pytest.raises(InputError, match="damping_ratio"):
        RingDown(omega=50.0, damping_ratio=0.0)
    with pytest.raises(InputError, match="longer than the ring-down"):
        matched_slams(np.sin(TIME[:20]), STEP, RINGING, QUICKEST)
    with pytest.raises(InputError, match="too coarse"):
        matched_slams(np.sin(TIME), STEP, RingDown(omega=400.0, damping_ratio=0.1), QUICKEST)
    with pytest.raises(InputError, match="constant"):
        matched_slams(np.zeros(2000), STEP, RINGING, QUICKEST)
    with pytest.raises(InputError, match="threshold"):
        slams_above(np.ones(100), STEP, 0.0, QUICKEST)
