"""Sines fitted to regular records, and waves and exceedances counted in irregular ones."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.records.crossings import exceedance, rayleigh_exceedance, significant, waves, zero_upcrossings
from workbench.records.sine_fit import amplitudes_at, frequency_condition, sine_fit

TIME = np.arange(0, 10, 0.01)


def test_amplitudes_of_the_source_are_found_exactly():
    values = 1.3 * np.sin(7.3 * TIME) - 0.7 * np.cos(7.3 * TIME)
    found = sine_fit(TIME, values, line=False)
    assert (found.sine, found.cosine, found.omega) == pytest.approx((1.3, -0.7, 7.3), abs=1e-9)
    assert found.residual == pytest.approx(0.0, abs=1e-8)
    assert found.unexplained < 1e-18
    assert found.amplitude == pytest.approx(np.hypot(1.3, 0.7))
    assert found.amplitude * np.sin(7.3 * TIME + found.phase) == pytest.approx(values, abs=1e-8)


def test_printed_equations_give_half():
    values = 1.3 * np.sin(7.3 * TIME) - 0.7 * np.cos(7.3 * TIME)
    sine, cosine = np.sin(7.3 * TIME), np.cos(7.3 * TIME)
    alpha, gamma, beta = np.sum(sine**2), np.sum(sine * cosine), np.sum(cosine**2)
    delta, epsilon = np.sum(values * sine), np.sum(values * cosine)
    printed = (epsilon * gamma - 2 * beta * delta) / (gamma**2 - 4 * alpha * beta)
    assert printed == pytest.approx(0.65, abs=0.002)
    assert amplitudes_at(7.3, TIME, values) == pytest.approx((1.3, -0.7), abs=1e-12)


def test_condition_is_the_derivative_of_the_misfit(rng):
    values = np.sin(7.0 * TIME) + rng.normal(0, 0.3, len(TIME))

    def misfit(omega):
        a1, a2 = amplitudes_at(omega, TIME, values)
        return 0.5 * np.sum((values - a1 * np.sin(omega * TIME) - a2 * np.cos(omega * TIME)) ** 2)

    for omega in (6.8, 7.1):
        slope = (misfit(omega + 1e-5) - misfit(omega - 1e-5)) / 2e-5
        assert frequency_condition(omega, TIME, values) == pytest.approx(slope, rel=1e-4)


def test_noise_drift_and_uneven_times_are_borne(rng):
    time = np.sort(rng.uniform(0, 12, 900))
    values = 2.0 * np.sin(5.0 * time + 0.4) + 3.0 + 0.2 * time + rng.normal(0, 0.1, 900)
    found = sine_fit(time, values)
    assert found.omega == pytest.approx(5.0, rel=0.002)
    assert found.amplitude == pytest.approx(2.0, rel=0.02)
    assert found.phase == pytest.approx(0.4, abs=0.05)
    assert not found.warnings


def test_a_known_frequency_is_kept():
    found = sine_fit(TIME, 1.5 * np.sin(2.0 * TIME), omega=2.1)
    assert found.omega == 2.1
    assert found.residual != 0


def test_a_record_that_is_no_sine_is_warned_of():
    values = np.sin(5 * TIME) + 0.6 * np.sin(13 * TIME)
    found = sine_fit(TIME, values)
    assert found.rms_amplitude == pytest.approx(np.sqrt(1 + 0.36), rel=0.02)
    assert "not one sine" in found.warnings[0]


@pytest.mark.parametrize(
    ("values", "said"),
    [
        (np.ones(1000), "constant"),
        (np.sin(0.5 * TIME), "at least 3 periods"),
        (np.full(1000, np.nan), "finite"),
    ],
)
def test_what_cannot_be_fitted_is_refused(values, said):
    with pytest.raises(InputError, match=said):
        sine_fit(TIME, values)


def test_crossings_and_waves():
    values = np.sin(2 * TIME - 0.3) + 0.5
    assert zero_upcrossings(TIME, np.sin(2 * TIME - 0.3)) == pytest.approx(
        (0.3 + 2 * np.pi * np.arange(4)) / 2, abs=1e-4
    )
    whole = np.arange(0, 20 * np.pi, 0.001)
    found = waves(whole, np.sin(2 * whole - 0.3) + 0.5)
    assert found.crest.values == pytest.approx(1.0, abs=1e-3)
    assert found.trough.values == pytest.approx(1.0, abs=1e-3)
    assert found.double_amplitude.values == pytest.approx(2.0, abs=1e-3)
    assert found.wave_period.values == pytest.approx(np.pi, abs=1e-4)
    assert significant(np.sin(2 * whole)) == pytest.approx(np.sqrt(2), rel=1e-4)
    with pytest.raises(InputError, match="at least twice"):
        waves(TIME[:10], values[:10])


def test_narrow_band_exceedance_follows_rayleigh(rng):
    time = np.arange(0, 40000, 0.2)
    omega = rng.uniform(0.95, 1.05, 200)
    phase = rng.uniform(0, 2 * np.pi, 200)
    values = np.zeros(len(time))
    for one, shift in zip(omega, phase, strict=True):
        values += 0.1 * np.cos(one * time + shift)
    found = exceedance(time, values, np.array([0.5, 1.0, 2.0]))
    assert found.exceedance_counted.values == pytest.approx(found.exceedance_rayleigh.values, abs=0.03)
    assert rayleigh_exceedance(2.0, 1.0) == pytest.approx(np.exp(-2))
    with pytest.raises(InputError, match="deviation"):
        rayleigh_exceedance(1.0, 0.0)
