"""Slams in a regular head wave from sinusoidal motions, their timing, and the way from motions per wave amplitude."""

import numpy as np
import pytest
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES
from workbench.design import MassProperties, WetDeck
from workbench.errors import InputError
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.impact import chuang
from workbench.impact.regular_motion import RegularMotion, regular_motion, regular_wave_slams
from workbench.impact.regular_wave import RegularWave
from workbench.impact.slam_timing import natural_periods, slam_timing, synchronous
from workbench.quantities import warnings_of
from workbench.relative_motion import relative_motion

WAVE = RegularWave(amplitude=1.2, period=7.0, speed=8.0)
MOTION = RegularMotion(wave=WAVE, heave_amplitude=1.1, heave_lead=-1.6, pitch_amplitude=0.07, pitch_lead=-2.4)


def gap(motion, time, lever, clearance):
    wave, turn = motion.wave, motion.wave.encounter_frequency * time
    heave = motion.heave_amplitude * np.cos(turn + motion.heave_lead)
    pitch = motion.pitch_amplitude * np.cos(turn + motion.pitch_lead)
    return clearance + heave + lever * pitch - wave.amplitude * np.cos(wave.wavenumber * lever + turn)


def test_state_is_the_derivative_of_the_motions():
    time, lever, step = np.linspace(0, 5, 7), 20.0, 1e-5
    state = MOTION.at(time, lever)

    def rate(function):
        return (function(time + step) - function(time - step)) / (2 * step)

    omega, k = WAVE.encounter_frequency, WAVE.wavenumber
    assert state.heave_velocity == pytest.approx(-rate(lambda t: 1.1 * np.cos(omega * t - 1.6)), abs=1e-6)
    assert state.surface_velocity == pytest.approx(
        -rate(lambda t: 1.2 * np.cos(k * lever + omega * t)), abs=1e-6
    )
    assert state.pitch_velocity == pytest.approx(
        -lever * rate(lambda t: 0.07 * np.cos(omega * t - 2.4)), abs=1e-6
    )
    assert state.pitch == pytest.approx(0.07 * np.cos(omega * time - 2.4))
    assert state.surface_velocity == pytest.approx(-WAVE.closing_speed * np.tan(state.wave_slope))


@pytest.mark.parametrize("lever", [10.0, 16.0, 25.0])
def test_impact_is_the_first_closing_of_the_gap(lever):
    instant = float(MOTION.impact_instant(lever, 0.5))
    period = 2 * np.pi / WAVE.encounter_frequency
    assert 0 <= instant < period
    assert gap(MOTION, instant, lever, 0.5) == pytest.approx(0, abs=1e-9)
    assert gap(MOTION, instant - 1e-4, lever, 0.5) > 0 > gap(MOTION, instant + 1e-4, lever, 0.5)


def test_no_impact_where_the_water_does_not_reach():
    assert np.isnan(MOTION.impact_instant(20.0, 9.0))
    with pytest.raises(InputError, match="clearance must be > 0"):
        MOTION.impact_instant(20.0, 0.0)


def motion_set(direction=np.pi, centre=(2.0, 0.0, 0.5)):
    """Motions per wave amplitude of a crest at the origin, smooth over frequency."""
    omega = np.linspace(0.5, 1.5, 21)
    k = omega**2 / 9.80665
    encounter = omega - k * 8.0 * np.cos(direction)
    rao = np.zeros((21, 1, 6), complex)
    at_centre = np.exp(1j * k * centre[0] * np.cos(direction))
    rao[:, 0, 2] = 0.9 * np.exp(1j * 1.6) * at_centre
    rao[:, 0, 4] = -0.06 * np.exp(1j * 2.4) * at_centre
    dims = ("omega", "wave_direction")
    return quantities.dataset(
        {"omega": omega, "wave_direction": [direction], "dof": list(MODES)},
        attrs={"speed": 8.0, "density": 1025.0, "centre_of_gravity": list(centre)},
        motion_rao=((*dims, "dof"), rao),
        wave_at_reference=(dims, at_centre[:, None]),
        encounter_frequency=(dims, encounter[:, None]),
        wavenumber=("omega", k),
    )


def test_motions_per_wave_amplitude_become_amplitudes_and_leads():
    found = regular_motion(motion_set(), 0.93, 1.2)
    assert found.wave.speed == 8.0
    assert found.wave.period == pytest.approx(2 * np.pi / 0.93)
    assert found.heave_amplitude == pytest.approx(0.9 * 1.2, rel=1e-6)
    assert found.heave_lead == pytest.approx(-1.6, abs=1e-6)
    assert found.pitch_amplitude == pytest.approx(0.06 * 1.2, rel=1e-6)
    assert found.pitch_lead == pytest.approx(-2.4, abs=1e-6)


def test_relative_motion_is_that_of_the_workbench():
    """The rise of the water towards points of a deck, by two independent ways through the package."""
    motions = motion_set()
    deck = wet_deck_grid(WetDeck(aft=-15.0, fore=25.0, width=8.0, clearance=2.0), 8, 2)
    known = relative_motion(motions, deck).relative_motion.isel(wave_direction=0, y=0)
    for index in (3, 10, 18):
        found = regular_motion(motions, float(motions.omega[index]), 1.0)
        ours = found.relative_motion(deck.x.values - 2.0)
        assert np.abs(ours) == pytest.approx(np.abs(known.isel(omega=index).values), rel=1e-9)
        turned = np.conj(known.isel(omega=index).values) * motions.wave_at_reference.values[index, 0]
        assert np.angle(ours / turned) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize(
    ("given", "words"), [({"omega": 3.0}, "wave frequency must be"), ({"direction": 2.5}, "head seas")]
)
def test_other_waves_are_refused(given, words):
    with pytest.raises(InputError, match=words):
        regular_motion(motion_set(given.get("direction", np.pi)), given.get("omega", 0.9), 1.0)


def test_prediction_over_a_deck_is_method_one_at_its_points():
    deck = wet_deck_grid(WetDeck(aft=-15.0, fore=25.0, width=8.0, clearance=0.6), 12, 4)
    found = regular_wave_slams(MOTION, deck, 1.0, 1025.0)
    point = {"x": 10, "y": 1}
    lever = float(deck.x[10]) - 1.0
    state = MOTION.at(MOTION.impact_instant(lever, 0.6), lever)
    known = chuang.method_one(*state, 1025.0)
    assert float(found.peak_pressure.isel(point)) == pytest.approx(float(known.total_pressure))
    assert float(found.attitude.isel(point)) == pytest.approx(float(state.pitch))
    assert (
        np.ptp(found.peak_pressure.values, axis=1)[np.isfinite(found.peak_pressure.values[:, 0])].max() == 0
    )
    assert np.isnan(found.peak_pressure.values).any()
    assert "milliseconds" in found.attrs["warnings"]
    assert "slopes across" not in found.attrs["warnings"]


def test_rake_and_slope_across_of_a_deck_are_noticed():
    raked = WetDeck(aft=-5.0, fore=25.0, width=8.0, clearance=0.6, trim=-0.05)
    deck = wet_deck_grid(raked, 12, 4)
    found = regular_wave_slams(MOTION, deck, 1.0, 1025.0)
    point = {"x": 11, "y": 0}
    lever = float(deck.x[11]) - 1.0
    state = MOTION.at(MOTION.impact_instant(lever, float(deck.height[11, 0])), lever)
    assert float(found.attitude.isel(point)) == pytest.approx(float(state.pitch) + 0.05)
    cambered = wet_deck_grid(WetDeck(aft=-5.0, fore=25.0, width=8.0, clearance=0.6, camber=0.5), 4, 4)
    assert "slopes across" in regular_wave_slams(MOTION, cambered, 1.0, 1025.0).attrs["warnings"]


def test_velocity_away_from_the_water_makes_no_pressure():
    deck = wet_deck_grid(WetDeck(aft=10.0, fore=25.0, width=8.0, clearance=0.6), 3, 1)
    deck["slope_x"] = xr.full_like(deck.slope_x, 50.0)
    pitching = RegularMotion(
        wave=WAVE, heave_amplitude=2.5, heave_lead=-1.6, pitch_amplitude=0.2, pitch_lead=0.6
    )
    found = regular_wave_slams(pitching, deck, 1.0, 1025.0)
    away = found.normal_velocity.values < 0
    assert away.any()
    assert np.all(found.peak_pressure.values[away] == 0)


def test_fast_entries_are_warned_of():
    quick = RegularMotion(
        wave=RegularWave(amplitude=4.0, period=7.0, speed=10.0),
        heave_amplitude=4.0, heave_lead=-2.5, pitch_amplitude=0.15, pitch_lead=-2.8,
    )  # fmt: skip
    deck = wet_deck_grid(WetDeck(aft=10.0, fore=25.0, width=8.0, clearance=0.6), 3, 1)
    assert any("faster than" in note for note in warnings_of(regular_wave_slams(quick, deck, 0.0, 1025.0)))


def usual_slam():
    """Bow fully down while heave velocity is largest downward, just as the water arrives."""
    turn = WAVE.encounter_frequency * 1.0
    return RegularMotion(
        wave=WAVE,
        heave_amplitude=1.2,
        heave_lead=np.pi / 2 - turn,
        pitch_amplitude=0.1,
        pitch_lead=np.pi - turn,
    )


def test_usual_slam_is_recognised():
    lever, motion = 20.0, usual_slam()
    clearance = float(1.2 * np.cos(WAVE.wavenumber * lever + WAVE.encounter_frequency) + lever * 0.1)
    assert clearance > 0
    found = slam_timing(motion, lever, clearance)
    assert found.slams
    assert found.bow_down_share == pytest.approx(1, abs=1e-6)
    assert found.heave_velocity_share == pytest.approx(1, abs=1e-6)
    assert found.is_typical
    assert any("usual slam" in note for note in found.notes)


@pytest.mark.parametrize(
    ("lead", "out"), [(0.3, False), (1.3, False), (1.7, True), (-2.5, True), (3.1, True)]
)
def test_phase_rule(lead, out):
    """Heave alone that leads the wave at the bow by an angle."""
    lever = 20.0
    motion = RegularMotion(
        wave=WAVE,
        heave_amplitude=1.0,
        heave_lead=lead + WAVE.wavenumber * lever,
        pitch_amplitude=0.0,
        pitch_lead=0.0,
    )
    found = slam_timing(motion, lever, 1.5)
    assert found.bow_phase == pytest.approx(lead)
    assert found.is_out_of_phase is out
    known = np.sqrt(1.2**2 + 1.0 - 2 * 1.2 * np.cos(lead))
    assert found.relative_motion_amplitude == pytest.approx(known)
    assert found.slams is bool(known > 1.5)
    # the rule of the source: slams although the wave is lower than the clearance
    assert not (found.slams and not found.is_out_of_phase)


def test_synchronism():
    period = 2 * np.pi / WAVE.encounter_frequency
    assert synchronous(period, {"heave": 1.1 * period, "pitch": 1.3 * period}) == ("heave",)
    found = slam_timing(MOTION, 20.0, 1.0, {"pitch": period})
    assert found.synchronous == ("pitch",)
    assert "natural period of pitch" in found.notes[-1]
    with pytest.raises(InputError, match="natural period of roll"):
        synchronous(period, {"roll": 0.0})


def test_natural_periods_of_a_ship_with_constant_added_mass():
    masses = MassProperties(
        mass=1e5, centre_of_gravity=(0.0, 0.0, 1.0), roll_gyradius=4.0, pitch_gyradius=8.0, yaw_gyradius=8.0
    )
    added = np.zeros((400, 1, 6, 6))
    added[..., 2, 2], added[..., 4, 4] = 1.5e5, 5e6
    hydrodynamics = xr.Dataset(
        {
            "added_mass": (("omega", "wave_direction", "a", "b"), added),
            "encounter_frequency": (("omega", "wave_direction"), np.linspace(0.2, 4, 400)[:, None]),
        },
        {"wave_direction": [np.pi]},
    )
    stiffness = np.diag([0, 0, 1e6, 0, 5e7, 0.0])
    found = natural_periods(hydrodynamics, masses, stiffness)
    assert found["heave"] == pytest.approx(2 * np.pi * np.sqrt(2.5e5 / 1e6), rel=1e-4)
    assert found["pitch"] == pytest.approx(2 * np.pi * np.sqrt((1e5 * 64 + 5e6) / 5e7), rel=1e-4)
    with pytest.raises(InputError, match="natural frequency"):
        natural_periods(hydrodynamics.isel(omega=slice(0, 20)), masses, stiffness)
