import numpy as np
import pytest

from workbench import pipeline
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.seas import Condition, SeaState
from workbench.time_domain import (
    Realisation,
    components_from,
    elevation_amplitudes,
    record_blocks,
    records,
    relative_amplitudes,
    time_histories,
    wave_components,
)

SEA = SeaState(significant_wave_height=2.0, peak_period=7.0)
HEAD = Condition(speed=0.0, wave_direction=np.pi, sea_state=SEA)


@pytest.fixture(scope="module")
def ship(twin):
    from workbench.hydrodynamics.settings import PotentialFlowSettings

    directions = [np.pi, np.radians(135)]
    return pipeline.response(
        twin, 0.0, directions, np.linspace(0.25, 2.05, 24), PotentialFlowSettings(panels=300)
    )


def test_blocks_are_the_sum_of_components(rng):
    amplitudes = rng.normal(size=(7, 3)) + 1j * rng.normal(size=(7, 3))
    frequency = rng.uniform(-1, 2, 7)
    whole = records(amplitudes, frequency, np.arange(101) * 0.1)
    seen = np.zeros((3, 101))
    for start, block in record_blocks(amplitudes, frequency, 10.0, 0.1, block=32, overlap=3):
        np.testing.assert_allclose(block, whole[:, start : start + block.shape[1]], atol=2e-5)
        seen[:, start : start + block.shape[1]] += 1
    assert seen.min() == 1
    by_hand = sum(
        abs(a) * np.cos(np.angle(a) - w * 3.7) for a, w in zip(amplitudes[:, 0], frequency, strict=True)
    )
    assert records(amplitudes[:, :1], frequency, np.array([3.7]))[0, 0] == pytest.approx(by_hand)


def test_realisation_has_the_energy_of_the_sea_and_its_own_seed():
    first = wave_components(HEAD, Realisation(seed=1), 0.25, 3.0)
    again = wave_components(HEAD, Realisation(seed=1), 0.25, 3.0)
    other = wave_components(HEAD, Realisation(seed=2), 0.25, 3.0)
    assert 4 * np.sqrt(np.sum(first.component_amplitude.values**2) / 2) == pytest.approx(2.0, rel=0.03)
    np.testing.assert_array_equal(first.component_phase, again.component_phase)
    assert not np.allclose(first.component_phase, other.component_phase)
    steps = np.diff(first.component_omega.values)
    assert steps.min() > 0
    assert steps.std() > 0.2 * steps.mean()  # uneven, so nothing repeats


def test_record_does_not_repeat():
    components = wave_components(HEAD, Realisation(seed=3), 0.25, 3.0)
    wave = elevation_amplitudes(components, np.array(0.0), np.array(0.0))[:, None]
    series = records(wave, components.component_frequency.values, np.arange(0, 7200, 0.5))[0]
    first = series[: len(series) // 2] - series.mean()
    correlation = [np.corrcoef(first, series[k : k + len(first)])[0, 1] for k in range(200, len(first), 20)]
    assert np.max(np.abs(correlation)) < 0.5


def test_rayleigh_amplitudes_vary_about_the_spectrum():
    fixed = wave_components(HEAD, Realisation(seed=4, components=2000), 0.25, 3.0)
    drawn = wave_components(HEAD, Realisation(seed=4, components=2000, amplitudes="rayleigh"), 0.25, 3.0)
    ratio = (drawn.component_amplitude / fixed.component_amplitude).values ** 2
    assert ratio.mean() == pytest.approx(1.0, abs=0.1)
    assert ratio.std() == pytest.approx(1.0, abs=0.2)  # the square of a Rayleigh variable is exponential


def test_spread_sea_comes_from_about_its_direction():
    sea = SeaState(significant_wave_height=2.0, peak_period=7.0, spreading_exponent=2)
    condition = Condition(speed=5.0, wave_direction=np.pi, sea_state=sea)
    found = wave_components(condition, Realisation(seed=5, components=2000), 0.25, 3.0)
    away = found.component_direction.values - np.pi
    assert np.all(np.abs(away) <= np.pi / 2)
    fine = np.linspace(-np.pi / 2, np.pi / 2, 20_001)
    expected = np.trapezoid(fine**2 * np.cos(fine) ** 2, fine) / np.trapezoid(np.cos(fine) ** 2, fine)
    assert np.mean(away**2) == pytest.approx(expected, rel=0.03)
    np.testing.assert_allclose(
        found.component_frequency,
        found.component_omega - found.component_omega**2 / GRAVITY * 5.0 * np.cos(found.component_direction),
    )


def test_one_and_two_waves_are_given_by_hand():
    pair = components_from([0.8, 1.1], [0.5, 0.25], 0.0, np.pi, 3.0)
    at_origin = records(
        elevation_amplitudes(pair, np.array(0.0), np.array(0.0))[:, None],
        pair.component_frequency.values,
        np.array([0.0]),
    )
    assert at_origin[0, 0] == pytest.approx(0.75)
    with pytest.raises(InputError, match="omega"):
        components_from([0.0], [1.0], 0.0, np.pi, 0.0)


def test_relative_record_has_the_variance_of_the_closed_form(ship, twin):
    relative = pipeline.deck_response(ship, twin.wet_deck, (6, 3))
    slam = pipeline.slamming(ship, relative, twin.wet_deck, HEAD)
    components = wave_components(HEAD, Realisation(seed=6), 0.25, 2.05)
    rise, slope = relative_amplitudes(components, ship.motions, relative)
    for amplitudes, deviation in (
        (rise, slam.moments.relative_motion_std),
        (slope, slam.moments.relative_slope_std),
    ):
        own = np.sqrt(np.sum(np.abs(amplitudes) ** 2, axis=0) / 2)
        np.testing.assert_allclose(own, deviation, rtol=0.06)


def test_relative_record_between_the_nodes_is_that_of_a_wave_there(ship, twin):
    """A regular wave between two computed frequencies: record against the response computed at that frequency."""
    omega = 0.93
    exact = pipeline.response(twin, 0.0, [np.pi], [omega], ship.settings)
    deck = pipeline.deck_response(exact, twin.wet_deck, (6, 3))
    relative = pipeline.deck_response(ship, twin.wet_deck, (6, 3))
    rise, slope = relative_amplitudes(
        components_from([omega], [1.0], 0.0, np.pi, 0.0), ship.motions, relative
    )
    np.testing.assert_allclose(rise[0], deck.relative_motion.values[0, 0], atol=0.05)
    np.testing.assert_allclose(slope[0], deck.relative_slope.values[0, 0], atol=0.006)


def test_histories_hold_six_motions_and_the_wave(ship):
    components = wave_components(HEAD, Realisation(seed=7), 0.25, 2.05)
    found = time_histories(components, ship.motions, 1200.0, 0.1)
    assert dict(found.sizes) == {"time": 12001, "dof": 6}
    expected = np.sqrt(np.sum(components.component_amplitude.values**2) / 2)
    assert float(found.elevation.std()) == pytest.approx(expected, rel=0.1)
    assert float(found.motion.sel(dof="heave").std()) > 0.2 * expected
    assert found.motion.attrs["units"] == "m, rad"


@pytest.mark.parametrize(
    "given",
    [
        {"seed": -1},
        {"seed": 1.5},
        {"hours": 0},
        {"components": 1},
        {"amplitudes": "gaussian"},
        {"time_step": 0},
    ],
)
def test_bad_realisations_are_refused(given):
    with pytest.raises(InputError):
        Realisation(**given)
