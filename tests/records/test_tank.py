"""Limits of a towing tank."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.records.tank import (
    Tank,
    encounters,
    following_limits,
    least_froude_head,
    longest_wave,
    printed_following,
    tank_report,
)


@pytest.mark.parametrize(
    ("length", "hertz", "froude"),
    [
        (1.6, 0.6, 0.214),
        (1.6, 1.0, 0.128),
        (1.6, 2.0, 0.064),
        (2.1, 0.6, 0.232),
        (2.1, 1.0, 0.139),
        (2.1, 2.0, 0.070),
    ],
)
def test_head_sea_limit(length, hertz, froude):
    assert least_froude_head(2 * np.pi * hertz, length, 3.7) == pytest.approx(froude, abs=0.001)


def clear(omega, speed, length, breadth, sign):
    """Whether the model advances its length while a radiated wave runs to the wall and back."""
    encounter = abs(omega - sign * omega**2 * speed / GRAVITY)
    return bool(speed * encounter >= GRAVITY * length / breadth)


@pytest.mark.parametrize("omega", [2.0, 5.0])
def test_limits_are_where_the_wave_just_misses(omega):
    length, breadth = 0.6, 3.7
    unit = np.sqrt(GRAVITY * length)
    head = least_froude_head(omega, length, breadth) * unit
    assert not clear(omega, 0.999 * head, length, breadth, -1)
    assert clear(omega, 1.001 * head, length, breadth, -1)
    limits = following_limits(omega, length, breadth)
    low, high = (one * unit for one in limits.band)
    over = limits.overtaking * unit
    for speed, free in (
        (0.999 * low, False), (1.001 * low, True), (0.999 * high, True), (1.001 * high, False),
        (0.999 * over, False), (1.001 * over, True),
    ):  # fmt: skip
        assert clear(omega, speed, length, breadth, 1) is free
    assert printed_following(omega, length, breadth) == pytest.approx(high / unit)


def test_long_models_have_no_band_in_following_seas():
    assert following_limits(3.0, 1.6, 3.7).band is None
    with pytest.raises(InputError, match="quarter of the breadth"):
        printed_following(3.0, 1.6, 3.7)


def test_encounters_and_depth():
    assert encounters(4.0, 1.0, 15.24) == pytest.approx((4 + 16 / GRAVITY) * 15.24 / (2 * np.pi))
    assert longest_wave(1.8) == pytest.approx(2.34)


def test_report():
    found = tank_report(2 * np.pi * 0.6, 0.2, 1.6)
    assert found["least_froude_number"] == pytest.approx(0.214, abs=0.001)
    assert not found["clear_of_walls"]
    assert not found["clear_of_bottom"]
    assert found["wavelength"] == pytest.approx(4.34, abs=0.01)
    fast = tank_report(2 * np.pi * 1.5, 0.8, 1.6)
    assert fast["clear_of_walls"]
    assert fast["clear_of_bottom"]
    assert fast["enough_regular"] == (fast["encounters"] >= 12)
    assert fast["runs_for_statistics"] * fast["encounters"] >= 100
    with pytest.raises(InputError, match="breadth"):
        Tank(breadth=0.0)
