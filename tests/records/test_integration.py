"""Filters, double integration, and the true wave from meters on the ship and under water."""

import numpy as np
import pytest
from random_seas import made_record, sines

from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.records.filters import decimated, high_passed, low_passed
from workbench.records.integration import (
    HIGH_PASS,
    acceleration_of,
    displacement,
    displacement_by_steps,
    velocity,
)
from workbench.records.reading import channel
from workbench.records.waves import (
    elevation_from_pressure,
    elevation_spectrum_from_pressure,
    finite_depth_wavenumber,
    noise_cutoff,
    pressure_gain,
    true_wave,
)

STEP = 0.05
TIME = np.arange(0, 600, STEP)
MOTION = sines(height=2.0, peak_period=5.5, low=0.9, high=3.5)
INSIDE = slice(round(15 / STEP), -round(15 / STEP))


def error(found, known):
    return np.std((found - known)[INSIDE]) / np.std(known[INSIDE])


def acceleration():
    return MOTION.at(TIME, -(MOTION.omega**2))


def test_double_integration_returns_the_displacement():
    found = displacement(acceleration(), STEP)
    assert error(found, MOTION.at(TIME)) < 0.005
    both = displacement(np.stack([acceleration(), 2 * acceleration()], axis=1), STEP)
    assert both[:, 1] == pytest.approx(2 * found)


def test_frequency_domain_agrees_with_the_time_domain():
    assert error(displacement_by_steps(acceleration(), STEP, 0.4), displacement(acceleration(), STEP)) < 0.02


def test_gravity_and_drift_of_the_meter_do_no_harm():
    clean = displacement(acceleration(), STEP)
    spoilt = displacement(acceleration() + GRAVITY + 1e-3 * TIME, STEP)
    assert error(spoilt, clean) < 0.005


def test_noise_of_the_meter_grows_below_the_cutoff(rng):
    noisy = acceleration() + rng.normal(0, 0.05, len(TIME))
    assert error(displacement(noisy, STEP), MOTION.at(TIME)) < 0.03
    assert error(displacement(noisy, STEP, 0.03), MOTION.at(TIME)) > 0.3


def test_the_cutoff_is_where_it_says():
    for omega, kept in ((0.49 * HIGH_PASS, 0.0), (1.01 * HIGH_PASS, 1.0), (3.0, 1.0)):
        found = displacement(-(omega**2) * np.cos(omega * TIME), STEP)
        assert np.std(found[2000:-2000]) == pytest.approx(kept / np.sqrt(2), abs=0.02)


def test_ends_are_whole_within_a_period_of_the_cutoff():
    found, known = displacement(acceleration(), STEP), MOTION.at(TIME)
    away = round(2 * np.pi / HIGH_PASS / STEP)
    assert np.abs(found - known)[away:-away].max() < 0.05 * np.std(known)
    assert np.abs(found - known).max() < 2.0 * np.std(known)


def test_velocity_and_differentiation():
    assert error(velocity(acceleration(), STEP), MOTION.at(TIME, -1j * MOTION.omega)) < 0.005
    assert error(acceleration_of(MOTION.at(TIME), STEP), acceleration()) < 0.005


def test_integration_refuses():
    with pytest.raises(InputError, match=r"at least 20 s long"):
        displacement(np.ones(100), STEP)
    with pytest.raises(InputError, match="cutoff"):
        displacement(np.ones(1000), STEP, 1000.0)


def test_filters_pass_what_they_should_without_shift():
    slow, fast = np.sin(0.1 * TIME), np.sin(4.0 * TIME)
    assert high_passed(slow + fast, STEP, 1.0)[INSIDE] == pytest.approx(fast[INSIDE], abs=0.01)
    assert low_passed(slow + fast, STEP, 1.0)[INSIDE] == pytest.approx(slow[INSIDE], abs=0.01)
    halved = high_passed(np.sin(1.0 * TIME), STEP, 1.0)[INSIDE]
    assert np.std(halved) * np.sqrt(2) == pytest.approx(0.5, abs=0.01)


@pytest.mark.parametrize("rate", [4.0, 7.0])
def test_decimation_keeps_waves_and_stops_aliases(rate):
    alias = np.sin(2 * np.pi * (rate + 0.4) * TIME)
    record = made_record(TIME, wave__m=MOTION.at(TIME), other__m=alias)
    found = decimated(record, rate)
    assert found.attrs["time_step"] == pytest.approx(1 / rate)
    assert np.diff(found.time.values) == pytest.approx(1 / rate)
    own = sines(height=2.0, peak_period=5.5, low=0.9, high=3.5).at(found.time.values)
    assert channel(found, "wave")[60:-60] == pytest.approx(own[60:-60], abs=0.01)
    assert np.abs(channel(found, "other")[60:-60]).max() < 0.02


def test_decimation_only_thins_out():
    record = made_record(TIME, wave__m=MOTION.at(TIME))
    assert decimated(record, 20.0).sizes["time"] == len(TIME)
    with pytest.raises(InputError, match="thinned"):
        decimated(record, 50.0)


def test_true_wave_from_a_meter_on_the_ship():
    heave = 0.8 * np.exp(0.9j)
    wave, rise = MOTION.at(TIME), MOTION.at(TIME, 1 - heave)
    accelerometer = MOTION.at(TIME, -(MOTION.omega**2) * heave)
    assert error(true_wave(4.0 - rise, accelerometer, STEP, "gap"), wave) < 0.005
    assert error(true_wave(rise + 1.0, accelerometer, STEP, "rise"), wave) < 0.005
    assert error(true_wave(rise, accelerometer, STEP, "gap"), wave) > 0.5
    with pytest.raises(InputError, match="sense"):
        true_wave(rise, accelerometer, STEP, "down")
    with pytest.raises(InputError, match="as many samples"):
        true_wave(rise[1:], accelerometer, STEP, "rise")


def test_dispersion_in_water_of_any_depth():
    omega = np.concatenate([[0.0], np.geomspace(1e-4, 50, 200)])
    for depth in (0.1, 18.0, 4000.0):
        k = finite_depth_wavenumber(omega, depth)
        assert GRAVITY * k * np.tanh(k * depth) == pytest.approx(omega**2, rel=1e-10)
    assert finite_depth_wavenumber(0.001, 18.0) == pytest.approx(0.001 / np.sqrt(GRAVITY * 18), rel=1e-6)
    assert finite_depth_wavenumber(5.0, 100.0) == pytest.approx(25 / GRAVITY, rel=1e-12)


def test_pressure_gain_has_its_limits():
    assert pressure_gain(1e-4, 18.0, 13.0) == pytest.approx(1.0, abs=1e-6)
    assert pressure_gain(2.0, 500.0, 10.0) == pytest.approx(np.exp(-4.0 / GRAVITY * 10), rel=1e-9)
    omega, depth, sensor = 0.8, 18.0, 13.0
    k = finite_depth_wavenumber(omega, depth)
    assert pressure_gain(omega, depth, sensor) == pytest.approx(
        np.cosh(k * (depth - sensor)) / np.cosh(k * depth), rel=1e-12
    )


def test_noise_cutoff_is_where_the_gain_is_reached():
    limit = noise_cutoff(18.0, 13.0)
    assert pressure_gain(limit, 18.0, 13.0) == pytest.approx(0.2, rel=1e-9)
    assert limit == pytest.approx(1.18, abs=0.02)
    assert noise_cutoff(18.0, 0.0) == np.inf


def test_elevation_from_a_submerged_recorder(rng):
    depth, sensor, density = 18.0, 13.0, 1025.0
    sea = sines(height=2.0, peak_period=9.0, low=0.4, high=1.1)
    time = np.arange(0, 1200, 0.25)
    gain = pressure_gain(sea.omega, depth, sensor)
    pressure = density * GRAVITY * (sensor + sea.at(time, gain)) + rng.normal(0, 100.0, len(time))
    found = elevation_from_pressure(pressure, 0.25, depth, sensor, density)
    inside = slice(200, -200)
    assert np.std((found - sea.at(time))[inside]) < 0.06 * np.std(sea.at(time))
    uncorrected = (pressure - pressure.mean()) / (density * GRAVITY)
    assert np.std(uncorrected) < 0.6 * np.std(sea.at(time))
    noisier = elevation_from_pressure(pressure, 0.25, depth, sensor, density, largest_gain=1e4)
    assert np.std((noisier - sea.at(time))[inside]) > 0.5 * np.std(sea.at(time))


def test_spectrum_from_a_submerged_recorder():
    omega = np.linspace(0.1, 2.0, 50)
    known = np.exp(-((omega - 0.7) ** 2) / 0.02)
    of_pressure = known * (1025 * GRAVITY * pressure_gain(omega, 18.0, 13.0)) ** 2
    found = elevation_spectrum_from_pressure(omega, of_pressure, 18.0, 13.0, 1025.0)
    inside = omega <= noise_cutoff(18.0, 13.0)
    assert found[inside] == pytest.approx(known[inside], rel=1e-10)
    assert np.all(np.isnan(found[~inside]))
