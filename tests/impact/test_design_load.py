"""Design load of a cross structure, and the members that bear it."""

import numpy as np
import pytest

from workbench.design import WetDeck
from workbench.errors import InputError
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.impact import pulse_response, quasi_static
from workbench.impact.design_load import (
    PSI,
    SQUARE_FOOT,
    AreaReduction,
    DesignLine,
    design_load,
    front_bulkhead_pressure,
    station,
    transverse_share,
)
from workbench.impact.quasi_static import Beams, Material
from workbench.quantities import warnings_of

LENGTH = 70.0
DECK = wet_deck_grid(WetDeck(aft=-30.0, fore=30.0, width=10.0, clearance=3.0), 30, 8)
STEEL = Material(young=206e9, poisson=0.3)


def test_stations_run_from_the_fore_to_the_aft_perpendicular():
    assert station(np.array([35.0, 0.0, -35.0]), LENGTH) == pytest.approx([0, 10, 20])


def test_line_of_the_full_scale_ship():
    line = DesignLine()
    assert line.pressure([0, 3, 8.5, 14, 20]) / PSI == pytest.approx([50, 50, 30, 10, 10])
    assert (line.pressure(4.0) - line.pressure(3.0)) / PSI == pytest.approx(-40 / 11)
    raised = line.with_peak(100 * PSI)
    assert raised.pressure([3, 8.5, 20]) / PSI == pytest.approx([100, 60, 20])


def test_parabola_across():
    assert transverse_share([-5.0, 0.0, 2.5, 5.0], 5.0) == pytest.approx([0.7, 1.0, 0.925, 0.7])
    with pytest.raises(InputError, match="inside the half width"):
        transverse_share(6.0, 5.0)


def test_load_over_a_deck():
    found = design_load(DECK, LENGTH, 5.0)
    assert found.design_pressure.dims == ("x", "y")
    # 21 m forward of amidships is station 4, 9 m aft of the fore perpendicular 2.57
    row = int(np.argmin(np.abs(DECK.x.values - 21.0)))
    at = 20 * (0.5 - float(DECK.x[row]) / LENGTH)
    for column in (0, 3):
        y = float(DECK.y[column])
        known = (50 - 40 / 11 * (at - 3)) * (1 - 0.3 * (y / 5) ** 2)
        assert float(found.design_pressure[row, column]) / PSI == pytest.approx(known)
    assert float(found.station[row]) == pytest.approx(at)
    notes = " ".join(warnings_of(found))
    assert "USNS HAYES" in notes
    assert "Forward of station 3" in notes
    assert "No reduction" not in notes


def test_reduction_by_area():
    table = AreaReduction(areas=(1.0, 10.0, 100.0), shares=(1.0, 0.6, 0.2))
    assert table.share([0.1, 1.0, 10.0, np.sqrt(1000), 1e4]) == pytest.approx([1, 1, 0.6, 0.4, 0.2])
    whole = design_load(DECK, LENGTH, 5.0, area=2.0)
    less = design_load(DECK, LENGTH, 5.0, reduction=table, area=10.0)
    assert less.design_pressure.values == pytest.approx(0.6 * whole.design_pressure.values)
    assert any("give a table" in note for note in warnings_of(whole))
    assert less.attrs["area_share"] == pytest.approx(0.6)


@pytest.mark.parametrize(
    ("areas", "shares", "words"),
    [
        ((1.0,), (1.0,), "two rows"), ((2.0, 1.0), (1.0, 0.5), "must increase"),
        ((1.0, 2.0), (1.0, 1.1), "not increase"), ((1.0, 2.0), (0.9, 0.5), "begin with 1"),
        ((0.0, 2.0), (1.0, 0.5), "area of the area reduction"),
        ((1.0, 2.0), (1.0, -0.5), "share of the area reduction"),
    ],
)  # fmt: skip
def test_tables_of_reduction_are_checked(areas, shares, words):
    with pytest.raises(InputError, match=words):
        AreaReduction(areas=areas, shares=shares)


@pytest.mark.parametrize(
    "given",
    [{"aft_pressure": 60 * PSI}, {"forward_station": 15.0}, {"aft_station": 21.0}, {"forward_pressure": 0}],
)
def test_lines_are_checked(given):
    with pytest.raises(InputError):
        DesignLine(**given)


def test_front_bulkhead_takes_twice_the_stagnation_pressure():
    foot = 0.3048
    known = 2.2 * 144 * 4.448222 / foot**2
    assert front_bulkhead_pressure(5 * foot, 7.78 * foot, 1.94 * 515.3788) == pytest.approx(known, rel=2e-3)
    assert pytest.approx(300 * 0.09290304) == 300 * SQUARE_FOOT


def test_clamped_strip_is_a_clamped_beam_of_plate_rigidity():
    found = quasi_static.clamped_strip(1e5, 0.6, 0.01, STEEL)
    rigidity = 206e9 * 0.01**3 / 12 / (1 - 0.09)
    assert found.deflection == pytest.approx(1e5 * 0.6**4 / 384 / rigidity)
    assert found.stress == pytest.approx(1e5 * 0.6**2 / 12 / (0.01**2 / 6))


def test_long_clamped_rectangle_is_the_strip():
    strip = quasi_static.clamped_strip(1e5, 0.6, 0.01, STEEL)
    for long in (0.6 * 4, 0.6 * 6):
        found = quasi_static.clamped_rectangle(1e5, 0.6, long, 0.01, STEEL)
        assert found == pytest.approx(strip, rel=2e-3)
    square = quasi_static.clamped_rectangle(1e5, 0.6, 0.6, 0.01, STEEL)
    assert square.deflection / strip.deflection == pytest.approx(0.00126532 * 384, rel=1e-4)


@pytest.mark.parametrize("poisson", [0.0, 0.3])
def test_moments_of_the_clamped_square_meet_the_known_ones(poisson):
    """The centre moment of a square is (1 + nu) times the curvature; the table has 0.0231 for 0.3."""
    found = quasi_static.clamped_rectangle_coefficients(1.0, poisson)
    assert found.centre_moment == pytest.approx(0.0229 * (1 + poisson) / 1.3, rel=2e-3)
    assert found.edge_moment == pytest.approx(0.05133, rel=1e-3)


def test_clamped_beam():
    found = quasi_static.clamped_beam(1e5, 0.6, 2.0, 1e-4, 1e-5, 206e9)
    assert found.stress == pytest.approx(1e5 * 0.6 * 4 / 12 / 1e-4)
    assert found.deflection == pytest.approx(1e5 * 0.6 * 16 / 384 / 206e9 / 1e-5)


def test_grillage_with_beams_one_way_is_simple_beams():
    """Where the cross beams are feeble, each girder bears its own strip as a simply supported beam."""
    along, feeble = (
        Beams(spacing=0.6, inertia=1e-5, modulus=1e-4),
        Beams(spacing=0.6, inertia=1e-11, modulus=1e-8),
    )
    found = quasi_static.grillage(1e4, 6.0, 60.0, along, feeble, terms=301)
    load = 1e4 * 0.6
    assert found.deflection == pytest.approx(5 * load * 6**4 / 384 / 206e9 / 1e-5, rel=5e-3)
    assert found.stress_along == pytest.approx(load * 6**2 / 8 / 1e-4, rel=5e-3)


def test_grillage_turned_round_is_the_same():
    one, two = Beams(spacing=0.6, inertia=1e-5, modulus=1e-4), Beams(spacing=1.0, inertia=4e-5, modulus=3e-4)
    found, turned = (
        quasi_static.grillage(1e4, 6.0, 8.0, one, two),
        quasi_static.grillage(1e4, 8.0, 6.0, two, one),
    )
    assert found.deflection == pytest.approx(turned.deflection)
    assert found.stress_along == pytest.approx(turned.stress_across)


def test_series_of_the_grillage_gives_the_simply_supported_plate():
    """With the twisting stiffness of a plate, the square plate of Timoshenko: 0.00406 and 0.0479/1.3."""
    unit = Beams(spacing=1.0, inertia=1.0, modulus=1.0)
    found = quasi_static._orthotropic(1.0, 1.0, 1.0, 1.0, 1.0, 1.0, unit, unit, 99)
    assert found.deflection == pytest.approx(0.00406, abs=5e-6)
    assert 1.3 * found.stress_along == pytest.approx(0.0479, abs=5e-5)


def test_dynamic_factor_against_a_step_by_step_solution():
    for ratio in (0.2, 0.5, 0.81, 1.5, 3.0, 6.0):
        time = np.linspace(0, ratio + 1.5, 60_001)
        step, load = time[1], np.where(time < ratio, np.sin(np.pi * time / ratio), 0.0)
        moved, previous, most = 0.0, 0.0, 0.0
        square = (2 * np.pi * step) ** 2
        for force in load:
            moved, previous = 2 * moved - previous + square * (force - moved), moved
            most = max(most, abs(moved))
        assert pulse_response.dynamic_factor(ratio, 1.0) == pytest.approx(most, rel=2e-3), ratio


def test_dynamic_factor_is_largest_near_four_fifths_and_tends_to_one():
    factors = [pulse_response.dynamic_factor(ratio, 1.0) for ratio in np.linspace(0.3, 4, 75)]
    assert max(factors) == pytest.approx(1.768, abs=1e-3)
    assert pulse_response.dynamic_factor(50.0, 1.0) == pytest.approx(1, abs=0.02)
    assert len(pulse_response.quasi_static_notes(0.010, 0.001)) == 1
    assert "short against" in pulse_response.quasi_static_notes(0.003, 0.002)[1]
    assert "bent for good" in pulse_response.quasi_static_notes(0.010, 0.001, 240e6)[1]
    assert len(pulse_response.quasi_static_notes(0.010, 0.001, 240e6, Material(yield_stress=355e6))) == 1


def test_natural_period_of_a_plate_strip_dry_and_wet():
    dry = pulse_response.strip_natural_period(0.6, 0.01, STEEL, 0.0)
    rigidity = 206e9 * 0.01**3 / 12 / 0.91
    assert dry == pytest.approx(2 * np.pi * 0.36 / 22.3733 * np.sqrt(7850 * 0.01 / rigidity))
    wet = pulse_response.strip_natural_period(0.6, 0.01, STEEL, 1025.0)
    assert (wet / dry) ** 2 - 1 == pytest.approx(0.40760 * 1025 * 0.6 / (7850 * 0.01), rel=1e-3)


@pytest.mark.parametrize(
    "call",
    [
        lambda: quasi_static.clamped_strip(1e5, 0.6, 0.2), lambda: quasi_static.clamped_strip(1e5, 0.0, 0.01),
        lambda: quasi_static.clamped_rectangle(1e5, 0.6, 0.5, 0.01),
        lambda: quasi_static.clamped_beam(1e5, 0.6, 2.0, 0.0, 1e-5),
        lambda: quasi_static.grillage(1e5, 1.0, 9.0, Beams(spacing=1, inertia=1, modulus=1),
                                      Beams(spacing=1, inertia=1, modulus=1)),
        lambda: Material(poisson=0.5), lambda: Beams(spacing=0, inertia=1, modulus=1),
        lambda: pulse_response.dynamic_factor(0.0, 1.0),
    ],
)  # fmt: skip
def test_members_are_checked(call):
    with pytest.raises(InputError):
        call()
