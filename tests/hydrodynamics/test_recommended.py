"""Which theory is recommended: table of speed and heading, and what it says."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY
from workbench.hydrodynamics.recommended import RecommendedSettings, reason, recommended

LENGTH = 40.0
LONG = np.array([0.3])
"""A wave so long that no ship here overtakes it."""


def chosen(froude_number, degrees, omega=LONG, quick=False):
    speed = froude_number * np.sqrt(GRAVITY * LENGTH)
    return recommended(LENGTH, speed, np.radians(np.atleast_1d(degrees)), omega, quick)


@pytest.mark.parametrize(
    ("froude_number", "degrees", "method"),
    [
        (0.0, 180, "potential-flow"),
        (0.19, 180, "potential-flow"),
        (0.19, 90, "potential-flow"),
        (0.21, 180, "strip"),
        (0.24, 180, "strip"),
        (0.25, 180, "high-speed"),
        (0.5, 180, "high-speed"),
        (0.9, 120, "high-speed"),
        (0.5, 90, "high-speed"),
        (0.5, 45, "strip"),
        (0.5, 0, "strip"),
    ],
)
def test_table(froude_number, degrees, method):
    assert chosen(froude_number, degrees) == (method,)


def test_tau_of_the_governing_waves_decides():
    """Of waves of one and of two lengths, the one with the smaller tau."""
    froude = 0.3
    wave = np.sqrt(np.pi * GRAVITY / LENGTH)
    speed = froude * np.sqrt(GRAVITY * LENGTH)
    short = np.sqrt(2 * np.pi * GRAVITY / LENGTH)
    for degrees in (60, 70, 80, 85, 100):
        cosine = np.cos(np.radians(degrees))
        tau = min(speed / GRAVITY * (w - w**2 / GRAVITY * speed * cosine) for w in (wave, short))
        assert chosen(froude, degrees) == ("high-speed" if tau > 0.25 else "strip",), degrees


def test_overtaken_waves_go_to_strips_at_any_speed():
    speed = 0.15 * np.sqrt(GRAVITY * LENGTH)
    omega = np.array([0.5, 1.1 * GRAVITY / speed])
    assert recommended(LENGTH, speed, [0.0, np.pi], omega) == ("strip", "potential-flow")
    assert recommended(LENGTH, speed, [0.0], np.array([0.9 * GRAVITY / speed])) == ("potential-flow",)


def test_quick_takes_strips_for_panels_and_nothing_else():
    assert chosen(0.1, [180, 90], quick=True) == ("strip", "strip")
    assert chosen(0.5, [180, 0], quick=True) == ("high-speed", "strip")


def test_choice_is_said():
    speed = 0.5 * np.sqrt(GRAVITY * LENGTH)
    assert reason(LENGTH, speed, ["high-speed"]) == "Recommended at Fn 0.50: high-speed theory."
    words = reason(LENGTH, speed, ["strip", "high-speed", "strip"])
    assert words == "Recommended at Fn 0.50: strip theory and high-speed theory, by heading."
    assert RecommendedSettings().of("strip") == RecommendedSettings().strip
    assert RecommendedSettings().as_dict()["quick"] is False
