"""Encounter of waves: there and back, and spectra with their energy."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY, encounter_frequency
from workbench.encounter import (
    blended_response,
    encounter_bins,
    encounter_jacobian,
    highest_overtaking,
    to_encounter,
    to_wave,
    wave_frequencies,
    wave_frequency,
    wavelength_ratio,
)
from workbench.errors import InputError
from workbench.seas import SeaState, wave_spectrum

OMEGA = np.linspace(0.2, 4.0, 2001)
SEA = wave_spectrum(SeaState(significant_wave_height=2.0, peak_period=8.0), OMEGA)


@pytest.mark.parametrize("direction", [np.pi, 2.4, np.pi / 2])
@pytest.mark.parametrize("speed", [0.0, 1e-9, 5.0, 25.0])
def test_there_and_back_in_head_and_beam_seas(speed, direction):
    met = encounter_frequency(OMEGA, speed, direction)
    assert wave_frequency(met, speed, direction) == pytest.approx(OMEGA, rel=1e-9)
    assert np.all(np.isnan(wave_frequencies(met, speed, direction)[1:]))


@pytest.mark.parametrize("direction", [0.0, 1.0])
def test_three_waves_share_an_encounter_in_following_seas(direction):
    speed = 10.0
    most = highest_overtaking(speed, direction)
    met = np.array([0.1, 0.5, 0.99]) * most
    branches = wave_frequencies(met, speed, direction)
    for branch, sign in zip(branches, (1, 1, -1), strict=True):
        assert encounter_frequency(branch, speed, direction) == pytest.approx(sign * met, rel=1e-9)
    assert np.all(np.diff(branches, axis=0) > 0)
    beyond = wave_frequencies(1.5 * most, speed, direction)
    assert np.all(np.isnan(beyond[:2]))
    assert encounter_frequency(beyond[2], speed, direction) == pytest.approx(-1.5 * most)
    assert encounter_jacobian(2 * most, speed, direction) == pytest.approx(0.0, abs=1e-12)


def test_wavelengths_of_the_towing_tank():
    found = wavelength_ratio(np.array([6.0, 12.0, 16.0]), 0.8, 1.6)
    assert found == pytest.approx([4.192, 1.714, 1.203], abs=0.001)


@pytest.mark.parametrize(("speed", "direction"), [(20.96, np.pi), (5.0, 2.0), (8.0, np.pi / 2), (1.0, 0.0)])
def test_spectra_keep_their_energy_both_ways(speed, direction):
    met, moved = to_encounter(OMEGA, SEA, speed, direction)
    slope = encounter_jacobian(OMEGA, speed, direction)
    assert np.trapezoid(moved * slope, OMEGA) == pytest.approx(np.trapezoid(SEA, OMEGA), rel=1e-12)
    assert np.trapezoid(moved, met) == pytest.approx(np.trapezoid(SEA, OMEGA), rel=1e-4)
    omega, back = to_wave(met, moved, speed, direction)
    assert omega == pytest.approx(OMEGA, rel=1e-9)
    assert back == pytest.approx(SEA, rel=1e-9)


def test_encounter_spectrum_of_the_source():
    """Irish Sea at 20.96 m/s: 0.9159 m2 s at 0.8221 rad/s becomes 0.20288 at 2.2667 rad/s."""
    omega = np.array([0.8, 0.8221, 0.85])
    met, moved = to_encounter(omega, np.full(3, 0.9159), 20.96, np.pi)
    assert met[1] == pytest.approx(2.2667, abs=1e-3)
    assert moved[1] == pytest.approx(0.20288, abs=1e-4)


def test_point_by_point_is_refused_where_waves_overlap():
    with pytest.raises(InputError, match=r"omega must be < 0\.4903 rad/s"):
        to_encounter(OMEGA, SEA, 10.0, 0.0)
    with pytest.raises(InputError, match=r"encounter_omega must be < 0\.2452"):
        to_wave(OMEGA, SEA, 10.0, 0.0)


@pytest.mark.parametrize(
    ("speed", "direction"), [(10.0, np.pi), (10.0, 0.0), (6.0, 0.8), (0.0, 0.0), (9.0, np.pi / 2)]
)
def test_bins_keep_the_energy_whatever_overlaps(speed, direction):
    edges = np.linspace(0, 25, 400)
    found = encounter_bins(OMEGA, SEA, edges, speed, direction, "sum")
    assert np.sum(found * np.diff(edges)) == pytest.approx(np.trapezoid(SEA, OMEGA), rel=1e-9)
    assert np.all(found >= 0)


def test_bins_are_the_averages_of_the_ordinates_in_head_seas():
    met, moved = to_encounter(OMEGA, SEA, 10.0, np.pi)
    edges = np.linspace(0.3, 8, 300)
    middle = (edges[1:] + edges[:-1]) / 2
    found = encounter_bins(OMEGA, SEA, edges, 10.0, np.pi)
    assert found == pytest.approx(np.interp(middle, met, moved), abs=0.01 * moved.max())


def test_bins_agree_with_a_count_of_components_in_following_seas():
    """The energy of 400 000 thin components, sorted by the encounter frequency of each."""
    fine = np.linspace(0.2, 4.0, 400_001)
    energy = np.interp(fine, OMEGA, SEA) * (fine[1] - fine[0])
    edges = np.linspace(0, 6, 61)
    met = np.abs(encounter_frequency(fine, 7.0, 0.4))
    counted = np.histogram(met, edges, weights=energy)[0] / np.diff(edges)
    assert encounter_bins(OMEGA, SEA, edges, 7.0, 0.4, "sum") == pytest.approx(
        counted, abs=2e-3 * counted.max()
    )


def test_bins_refuse_overlap_unless_asked():
    with pytest.raises(InputError, match="ask for the sum"):
        encounter_bins(OMEGA, SEA, np.linspace(0, 5, 50), 10.0, 0.0)
    with pytest.raises(InputError, match="increasing encounter"):
        encounter_bins(OMEGA, SEA, [1.0, 0.5], 10.0, np.pi)


def test_blend_of_two_headings():
    met = np.array([0.5, 1.2, 1.85, 2.5, 3.0])
    found = blended_response(np.full(5, 1.0), np.full(5, 3.0), met, 1.2, 2.5)
    assert found == pytest.approx([1, 1, 2, 3, 3])
    with pytest.raises(InputError, match="upper"):
        blended_response(1.0, 2.0, met, 2.5, 1.2)


@pytest.mark.parametrize(
    ("omega", "spectrum"),
    [([1.0], [1.0]), ([2.0, 1.0], [1.0, 1.0]), ([1.0, 2.0], [1.0, -1.0]), ([1.0, 2.0], [1.0])],
)
def test_tables_that_are_no_spectra_are_refused(omega, spectrum):
    with pytest.raises(InputError):
        to_encounter(omega, spectrum, 1.0, np.pi)


def test_negative_encounters_are_refused():
    with pytest.raises(InputError, match="magnitude"):
        wave_frequency(-1.0, 5.0, np.pi)


def test_gravity_is_the_standard_one():
    assert highest_overtaking(10.0, 0.0) == pytest.approx(GRAVITY / 40)
    assert highest_overtaking(10.0, np.pi) == np.inf
