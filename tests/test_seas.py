import numpy as np
import pytest

from workbench.conventions import GRAVITY, encounter_frequency, from_aft_axes, wave_direction_from_head_zero
from workbench.errors import InputError
from workbench.seas import Condition, SeaState, period_ratio, sea_presets, spreading_weights, wave_spectrum


def moments(sea, *orders):
    omega = np.linspace(0.02, 60.0, 400_000) / sea.peak_period
    spectrum = wave_spectrum(sea, omega)
    return [np.trapezoid(omega**order * spectrum, omega) for order in orders]


@pytest.mark.parametrize(
    "others",
    [
        {"peak_period": 8.0},
        {"peak_period": 8.0, "spectrum": "jonswap", "peak_enhancement": 7.0},
        {"spectrum": "pierson-moskowitz"},
        {"spectrum": "user", "table": ((0.4, 0.0), (0.7, 3.0), (1.1, 1.0), (2.0, 0.0))},
    ],
)
def test_significant_height_is_four_root_m0(others):
    sea = SeaState(significant_wave_height=2.5, **others)
    assert 4 * np.sqrt(moments(sea, 0)[0]) == pytest.approx(2.5, rel=1e-3)


@pytest.mark.parametrize(
    ("order", "spectrum", "gamma", "expected"),
    [
        (-1, "bretschneider", 1.0, 0.857222537),
        (1, "bretschneider", 1.0, 0.771771437),
        (2, "bretschneider", 1.0, 0.710370681),
        (1, "jonswap", 3.3, 0.834328),
        (2, "jonswap", 3.3, 0.777399),
        (-1, "jonswap", 7.0, 0.931234),
        (2, "jonswap", 7.0, 0.828498),
    ],
)
def test_period_ratios_are_the_closed_form_and_tabled_ones(order, spectrum, gamma, expected):
    # Bretschneider: Gamma(5/4) 1.25**-0.25, (1.25 pi)**-0.25; JONSWAP: independent quadrature
    assert period_ratio(order, spectrum, gamma) == pytest.approx(expected, abs=1e-6)


def test_mean_period_of_the_source_gives_its_peak_period():
    # Lloyd 1989, used by Grande 2002: Tp = 1.296 Tmean
    assert SeaState.from_mean_period(3.0, 8.0).peak_period == pytest.approx(8 * 1.296, rel=1e-3)
    assert SeaState.from_zero_crossing_period(3.0, 8.0).peak_period == pytest.approx(8 * 1.4077, rel=1e-3)


def test_peak_is_at_the_peak_period():
    sea = SeaState(significant_wave_height=2.0, peak_period=9.0, spectrum="jonswap")
    omega = np.linspace(0.3, 2, 20_001)
    assert omega[np.argmax(wave_spectrum(sea, omega))] == pytest.approx(2 * np.pi / 9, rel=1e-3)


def test_fully_developed_sea_has_the_phillips_tail():
    sea = SeaState(significant_wave_height=3.0, spectrum="pierson-moskowitz")
    omega = 40 / sea.peak_period * 2 * np.pi
    assert wave_spectrum(sea, omega) * omega**5 == pytest.approx(0.0081 * GRAVITY**2, rel=1e-5)


def test_spreading_carries_all_the_energy_about_its_direction():
    directions = np.radians(np.arange(0, 360, 15))
    weights = spreading_weights(directions, np.pi, 2)
    assert weights.sum() == pytest.approx(1)
    assert np.sum(weights * np.sin(directions)) == pytest.approx(0, abs=1e-12)
    fine = np.linspace(-np.pi / 2, np.pi / 2, 100_001)
    mean_cosine = np.trapezoid(np.cos(fine) ** 3, fine) / np.trapezoid(np.cos(fine) ** 2, fine)
    assert -np.sum(weights * np.cos(directions)) == pytest.approx(mean_cosine, rel=1e-3)
    assert spreading_weights(directions, np.pi, None)[12] == 1


def test_encounter_frequency_of_the_source():
    # Grande 2002: head sea, 20 knots of 0.5144 m/s, T = 8 s: 1.432 rad/s; 30 kn: 1.756
    omega = 2 * np.pi / 8
    assert encounter_frequency(omega, 20 * 0.5144, np.pi) == pytest.approx(1.432, abs=1e-3)
    assert encounter_frequency(omega, 30 * 0.5144, np.pi) == pytest.approx(1.756, abs=2e-3)
    assert encounter_frequency(omega, 20.0, np.pi / 2) == pytest.approx(omega)
    assert encounter_frequency(1.0, 15.0, 0.0) < 0


def test_aft_axes_turn_all_but_heave_and_yaw():
    motions = np.arange(1.0, 7.0)
    np.testing.assert_array_equal(from_aft_axes(motions), [-1, -2, 3, -4, -5, 6])
    np.testing.assert_array_equal(from_aft_axes(from_aft_axes(motions)), motions)
    assert wave_direction_from_head_zero(0.0) == np.pi


def test_presets_are_seas_that_rise():
    heights = [preset.sea_state.significant_wave_height for preset in sea_presets() if "Sea" in preset.name]
    assert heights == sorted(heights)
    assert len(sea_presets()) == 17


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"significant_wave_height": 0.0, "peak_period": 8.0}, "significant_wave_height"),
        ({"significant_wave_height": -1.0, "peak_period": 8.0}, "got -1 m"),
        ({"significant_wave_height": float("nan"), "peak_period": 8.0}, "finite"),
        ({"significant_wave_height": "high", "peak_period": 8.0}, "number"),
        ({"significant_wave_height": 2.0, "peak_period": 0.0}, "peak_period"),
        ({"significant_wave_height": 2.0, "peak_period": None}, "peak_period"),
        ({"significant_wave_height": 10.0, "peak_period": 4.0}, "steeper waves break"),
        ({"significant_wave_height": 2.0, "peak_period": 8.0, "spectrum": "pm"}, "one of"),
        ({"significant_wave_height": 2.0, "peak_period": 8.0, "peak_enhancement": 0.2}, "peak_enhancement"),
        ({"significant_wave_height": 2.0, "spectrum": "user"}, "at least 3 pairs"),
        (
            {"significant_wave_height": 2.0, "spectrum": "user", "table": ((2, 1), (1, 1), (3, 1))},
            "increasing",
        ),
        (
            {"significant_wave_height": 3.0, "spectrum": "pierson-moskowitz", "peak_period": 15.0},
            "follows from",
        ),
    ],
)
def test_bad_seas_are_refused_in_a_sentence(given, words):
    with pytest.raises(InputError, match=words):
        SeaState(**given)


@pytest.mark.parametrize(("speed", "direction"), [(-1.0, 3.0), (100.0, 3.0), (5.0, 7.0), (5.0, float("nan"))])
def test_bad_conditions_are_refused(speed, direction):
    sea = SeaState(significant_wave_height=2.0, peak_period=8.0)
    with pytest.raises(InputError):
        Condition(speed=speed, wave_direction=direction, sea_state=sea)
