"""Rule pressures: the printed example, factors by hand, ranges that are told, and the deck of a design."""

import dataclasses

import numpy as np
import pytest

from workbench.conventions import GRAVITY, KNOT
from workbench.errors import InputError
from workbench.geometry.wet_deck import wet_deck_height
from workbench.hulls.library import design
from workbench.impact.rule_formulas import (
    RECALLED,
    SEEN,
    RuleInput,
    abs_area_factor,
    gl_area_factor,
    gl_impact_velocity,
    gl_pressure,
    rule_rows,
)
from workbench.impact.rule_pressure import rule_pressures
from workbench.seas import Condition, SeaState

EXAMPLE = RuleInput(
    length=50.0, speed=35 * KNOT, displacement=200e3, draught=1.8, significant_wave_height=4.2, air_gap=2.0,
    panel_area=0.6, spacing=0.4, vertical_acceleration=1.5 * GRAVITY,
)  # fmt: skip
PRINTED = dataclasses.replace(EXAMPLE, significant_wave_height=4.0)


def row(given, key, station=0.9):
    return {one.key: one for one in rule_rows(given, station)}[key]


def test_printed_example_of_gl():
    """L 50 m, 35 kn, Hs 4 m, gap 2 m, x/L 0.9, K2 = K3 = 1: V_REL 3.26274, 196.988 kPa."""
    assert gl_impact_velocity(4.0, 50.0) == pytest.approx(3.26274, abs=5e-6)
    assert gl_pressure(PRINTED, 0.9, 1.0, 1.0) / 1e3 == pytest.approx(196.988, abs=5e-4)


def test_gl_by_hand():
    """K2 for u = 100 s/S_r, S_r = 0.7 (100 t)/1.8 m; K3 from 20 degrees against 10; K_WD 0.4 amidships."""
    u = 100 * 0.6 / (0.7 * 100 / 1.8)
    k2 = 0.455 - 0.35 * (u**0.75 - 1.7) / (u**0.75 + 1.7)
    assert gl_area_factor(PRINTED) == pytest.approx(max(k2, 0.5))
    assert gl_area_factor(dataclasses.replace(PRINTED, panel_area=0.05)) == pytest.approx(
        0.455 - 0.35 * ((u / 12) ** 0.75 - 1.7) / ((u / 12) ** 0.75 + 1.7)
    )
    assert gl_area_factor(dataclasses.replace(PRINTED, panel_area=9.0)) == 0.5
    assert gl_area_factor(dataclasses.replace(PRINTED, panel_area=9.0, stiffener=True)) == 0.45
    sloped = dataclasses.replace(PRINTED, deadrise=np.radians(20.0))
    base = row(PRINTED, "gl-hsc").pressure
    assert row(sloped, "gl-hsc").pressure / base == pytest.approx(50 / 60)
    assert row(PRINTED, "gl-hsc", 0.5).pressure / base == pytest.approx(0.4)
    assert row(PRINTED, "gl-hsc", 0.75).pressure / base == pytest.approx(0.7)


def test_two_transcriptions_agree_below_61_m():
    """GL with K2 K3 = F_D and ABS, whose significant height is at least L/12 = 4.1667 m, so at 4.2 m."""
    for station in (0.1, 0.5, 0.76, 1.0):
        expected = gl_pressure(EXAMPLE, station, abs_area_factor(EXAMPLE), 1.0)
        assert row(EXAMPLE, "abs-hsc", station).pressure == pytest.approx(expected, rel=1e-12)
    least = row(PRINTED, "abs-hsc")
    assert any("L/12, here 4.17 m instead of 4 m" in note for note in least.warnings)


def test_area_factor_of_abs():
    """Table at its nodes; reference areas of ABS and GL are the same to 1 %; plates count 2.5 s**2 at most."""
    reference = 6.95e-6 * 200e3 / 1.8
    assert reference * 100 == pytest.approx(2 * 0.7 * 100 / 1.8, rel=0.01)
    for ratio, factor in ((0.001, 1.0), (0.01, 0.76), (0.05, 0.47), (0.5, 0.4), (0.03, (0.76 + 0.47) / 2)):
        given = dataclasses.replace(EXAMPLE, panel_area=ratio * reference, spacing=5.0)
        assert abs_area_factor(given) == pytest.approx(factor)
    narrow = dataclasses.replace(EXAMPLE, panel_area=0.6, spacing=0.1)
    small = dataclasses.replace(EXAMPLE, panel_area=0.025, spacing=5.0)
    assert abs_area_factor(narrow) == pytest.approx(abs_area_factor(small))
    assert abs_area_factor(dataclasses.replace(narrow, stiffener=True)) < abs_area_factor(narrow)


def test_long_craft_of_abs_by_hand():
    given = dataclasses.replace(EXAMPLE, length=72.0, significant_wave_height=6.5)
    found = row(given, "abs-hsc")
    velocity = 5 * np.sqrt(6.5 / 72) + 1
    expected = 55 * abs_area_factor(given) * 35**0.1 * velocity * (1 - 0.35 * 2 / 6.5)
    assert found.pressure / 1e3 == pytest.approx(expected)
    assert found.applicability == "lengths of 61 m and more"
    assert row(EXAMPLE, "abs-hsc").applicability == "lengths below 61 m"


def test_recalled_formulas_by_hand():
    dnv, lr = row(EXAMPLE, "dnv-hslc"), row(EXAMPLE, "lr-ssc")
    limit = 0.22 * 50 * (0.3 - 0.04)
    assert dnv.pressure / 1e3 == pytest.approx(2.6 * (200 / 0.6) ** 0.3 * 1.5 * GRAVITY * (1 - 2 / limit))
    assert lr.pressure / 1e3 == pytest.approx((8 * 4.2 / np.sqrt(50) + 2) * 35 / 3 * (1 - 2 / 4.2))
    half = dataclasses.replace(EXAMPLE, distribution=0.5)
    assert row(half, "dnv-hslc").pressure == pytest.approx(dnv.pressure / 2)
    assert row(half, "lr-ssc").pressure == pytest.approx(lr.pressure / 2)
    assert (dnv.standing, lr.standing) == (RECALLED, RECALLED)
    assert {row(EXAMPLE, key).standing for key in ("gl-hsc", "abs-hsc")} == {SEEN}
    assert any("1/3 or 1/6" in note for note in lr.warnings)


def test_a_high_deck_has_no_pressure_and_slow_ships_are_told():
    high = dataclasses.replace(EXAMPLE, air_gap=15.0)
    assert [one.pressure for one in rule_rows(high, 0.9)] == [0.0] * 4
    slow = rule_rows(dataclasses.replace(EXAMPLE, speed=5 * KNOT), 0.9)
    assert all(any("high-speed craft, of 17.3 knots" in note for note in one.warnings) for one in slow)
    calm = dataclasses.replace(EXAMPLE, vertical_acceleration=0.5 * GRAVITY, speed=30 * KNOT)
    assert any("forward of 0.8 L" in note for note in row(calm, "gl-hsc", 0.6).warnings)
    assert not any("forward of" in note for note in row(calm, "gl-hsc", 0.9).warnings)
    fast = dataclasses.replace(EXAMPLE, vertical_acceleration=0.5 * GRAVITY, speed=34 * KNOT)
    assert any("forward of 0.7 L" in note for note in row(fast, "gl-hsc", 0.6).warnings)
    assert not any("forward of" in note for note in row(EXAMPLE, "gl-hsc", 0.2).warnings)


def test_along_the_deck_of_a_design():
    ship = design("austal-63")
    sea = SeaState(significant_wave_height=4.0, peak_period=9.0)
    condition = Condition(speed=35 * KNOT, wave_direction=np.pi, sea_state=sea)
    found = rule_pressures(ship, condition, panel_area=0.7, spacing=0.4)
    assert dict(found.sizes) == {"rule": 4, "x": 41}
    assert found.rule_pressure.attrs["units"] == "Pa"
    place = 25
    x = float(found.x[place])
    given = RuleInput(
        length=76.0, speed=35 * KNOT, displacement=ship.masses.mass, draught=3.1, significant_wave_height=4.0,
        air_gap=float(wet_deck_height(ship.wet_deck, x, 0.0)), panel_area=0.7, spacing=0.4,
    )  # fmt: skip
    expected = [one.pressure for one in rule_rows(given, x / 76.0 + 0.5)]
    np.testing.assert_allclose(found.rule_pressure[:, place], expected)
    assert "1 g is taken" in found.attrs["warnings"]
    assert "recalled" in str(found.rule_standing.sel(rule="dnv-hslc").values)
    given = rule_pressures(ship, condition, vertical_acceleration=5.0, x=[20.0])
    assert "1 g is taken" not in given.attrs["warnings"]
    assert given.sizes["x"] == 1


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"length": 0.0}, "length of the rule must be"),
        ({"speed": -1.0}, "speed of the rule"),
        ({"air_gap": np.nan}, "air_gap of the rule"),
        ({"stiffener": "yes"}, "stiffener must be true or false"),
        ({"deadrise": 2.0}, "deadrise of the rule"),
    ],
)
def test_what_no_rule_can_take_is_refused(changes, words):
    with pytest.raises(InputError, match=words):
        dataclasses.replace(EXAMPLE, **changes)


def test_decks_and_stations_that_are_not_there_are_refused():
    sea = SeaState(significant_wave_height=4.0, peak_period=9.0)
    condition = Condition(speed=10.0, wave_direction=np.pi, sea_state=sea)
    with pytest.raises(InputError, match="cofea has none"):
        rule_pressures(design("cofea"), condition)
    with pytest.raises(InputError, match="y of the line"):
        rule_pressures(design("austal-63"), condition, y=20.0)
    with pytest.raises(InputError, match="station x/L"):
        rule_rows(EXAMPLE, 3.0)
