"""Responses estimated from records, against the responses that made the records."""

import numpy as np
import pytest
from random_seas import made_record, sines

from workbench.conventions import GRAVITY, encounter_frequency, wavenumber
from workbench.errors import InputError
from workbench.quantities import warnings_of
from workbench.records.responses import estimated_response, phasor
from workbench.records.spectra import SpectrumSettings

SPEED = 10.0
SETTINGS = SpectrumSettings(segment=512)
TIME = np.arange(0, 5400, 0.2)


def heave_rao(encounter):
    """A resonance at 1.5 rad/s, in this package's exp(-i omega_e t)."""
    return 1.0 / (1 - (encounter / 1.5) ** 2 - 0.5j * encounter / 1.5)


def made(speed=SPEED, direction=np.pi, noise=0.0, wave_noise=0.0, low=0.4, high=1.6, slope=1.3):
    sea = sines(count=1500, low=low, high=high, seed=3)
    encounter = encounter_frequency(sea.omega, speed, direction)
    moved = type(sea)(encounter, sea.amplitude, sea.phase)
    rng = np.random.default_rng(5)
    return made_record(
        TIME,
        wave__m=moved.at(TIME) + rng.normal(0, wave_noise or 1e-12, len(TIME)),
        heave__m=moved.at(TIME, heave_rao(encounter)) + rng.normal(0, noise or 1e-12, len(TIME)),
        pitch__rad=moved.at(TIME, slope * 1j * wavenumber(sea.omega)),
    )


def test_known_response_is_found_in_amplitude_phase_and_slope():
    found = estimated_response(made(), "wave", SPEED, np.pi, SETTINGS)
    one = found.isel(record_omega=found.usable.values == 1)
    omega = one.record_omega.values
    known = heave_rao(omega)
    assert len(omega) > 30
    heave = one.sel(channel="heave")
    assert heave.response_amplitude.values == pytest.approx(np.abs(known), rel=0.05)
    assert heave.cross_amplitude.values == pytest.approx(np.abs(known), rel=0.05)
    assert heave.response_lead.values == pytest.approx(-np.angle(known), abs=0.05)
    assert phasor(one, "heave") == pytest.approx(known, abs=0.06 * np.abs(known).max())
    assert heave.coherence.values.min() > 0.98
    pitch = one.sel(channel="pitch")
    assert pitch.response_amplitude.values == pytest.approx(1.3, rel=0.05)
    assert pitch.response_lead.values == pytest.approx(-np.pi / 2, abs=0.05)


def test_encounter_is_turned_back_into_wave_frequency():
    found = estimated_response(made(), "wave", SPEED, np.pi, SETTINGS)
    omega = found.wave_omega.values
    assert encounter_frequency(omega, SPEED, np.pi) == pytest.approx(found.record_omega.values)
    k = omega**2 / GRAVITY
    assert found.wave_slope_spectrum.values == pytest.approx(k**2 * found.wave_record_spectrum.values)


def test_noise_in_the_response_spoils_the_first_estimate_only():
    found = estimated_response(made(noise=0.35), "wave", SPEED, np.pi, SETTINGS)
    one = found.isel(record_omega=found.usable.values == 1).sel(channel="heave")
    known = heave_rao(one.record_omega.values)
    fast = one.record_omega.values > 1.9
    assert np.mean(one.response_amplitude.values[fast] / np.abs(known[fast])) > 2
    cross = one.cross_amplitude.values * np.exp(-1j * one.response_lead.values)
    assert np.mean(cross[fast] / known[fast]) == pytest.approx(1.0, abs=0.12)
    assert one.response_amplitude.values * np.sqrt(one.coherence.values) == pytest.approx(
        one.cross_amplitude.values
    )


def test_noise_in_the_wave_lowers_both():
    found = estimated_response(made(wave_noise=1.2), "wave", SPEED, np.pi, SETTINGS)
    one = found.isel(record_omega=found.usable.values == 1).sel(channel="heave")
    known = np.abs(heave_rao(one.record_omega.values))
    assert np.mean(one.response_amplitude.values / known) < 0.95
    assert np.mean(one.cross_amplitude.values / known) < np.mean(one.response_amplitude.values / known)


def test_stated_error_is_the_scatter(rng):
    errors, stated = [], []
    omega0 = None
    settings = SpectrumSettings(segment=64)
    for _ in range(60):
        wave = rng.normal(size=1280)
        record = made_record(np.arange(1280.0), wave__m=wave, heave__m=0.7 * wave + rng.normal(size=1280))
        one = (
            estimated_response(record, "wave", 0.0, np.pi, settings)
            .sel(channel="heave")
            .isel(record_omega=slice(3, 25))
        )
        errors.append(one.cross_amplitude.values / 0.7 - 1)
        stated.append(one.response_error.values)
        omega0 = one.record_omega.values
    assert len(omega0) == 22
    assert np.sqrt(np.nanmean(np.square(errors))) == pytest.approx(np.nanmean(stated), rel=0.12)


def test_frequencies_without_wave_energy_are_masked():
    found = estimated_response(made(), "wave", SPEED, np.pi, SETTINGS, least_energy=0.2)
    usable = found.usable.values == 1
    energy = found.wave_record_spectrum.values
    assert np.all(energy[usable] >= 0.2 * energy.max())
    assert np.all(np.isnan(found.response_amplitude.values[~usable]))
    assert 0 < usable.sum() < estimated_response(made(), "wave", SPEED, np.pi, SETTINGS).usable.values.sum()


def test_following_seas_give_the_long_waves_and_say_so():
    speed = 4.0
    record = made(speed=speed, direction=0.0, low=0.4, high=0.9)
    found = estimated_response(record, "wave", speed, 0.0, SETTINGS)
    assert "long waves" in warnings_of(found)[0]
    most = GRAVITY / (4 * speed)
    usable = found.usable.values == 1
    assert usable.any()
    assert found.record_omega.values[usable].max() < 0.8 * most
    omega = found.wave_omega.values[usable]
    assert encounter_frequency(omega, speed, 0.0) == pytest.approx(found.record_omega.values[usable])
    heave = found.sel(channel="heave").response_amplitude.values[usable]
    assert heave == pytest.approx(np.abs(heave_rao(found.record_omega.values[usable])), rel=0.1)


def test_refusals():
    record = made()
    with pytest.raises(InputError, match="channel must be one of"):
        estimated_response(record, "sea", SPEED)
    with pytest.raises(InputError, match="wave must be a channel in m, pitch is in rad"):
        estimated_response(record, "pitch", SPEED)
    with pytest.raises(InputError, match="besides the wave"):
        estimated_response(record.sel(channel=["wave"]), "wave", SPEED)
    with pytest.raises(InputError, match="is constant"):
        estimated_response(made_record(TIME, wave__m=0 * TIME, heave__m=TIME), "wave")
