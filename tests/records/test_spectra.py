"""Spectra of records: variance kept, bands that hold the truth, refusal of what is too short."""

import numpy as np
import pytest
from random_seas import made_record, sines
from scipy import signal

from workbench.errors import InputError
from workbench.quantities import warnings_of
from workbench.records.spectra import (
    SpectrumSettings,
    averaged_runs,
    degrees_of_freedom,
    record_spectra,
    run_spectrum,
    segment_for,
    segments_in,
    slope_spectrum,
)
from workbench.seas import SeaState, wave_spectrum


@pytest.mark.parametrize("window", ["hann", "cosine-taper"])
@pytest.mark.parametrize("detrend", ["none", "constant", "linear"])
def test_variance_is_kept(sea, time, window, detrend):
    settings = SpectrumSettings(segment=512, window=window, detrend=detrend)
    found = record_spectra(made_record(time, wave__m=sea.at(time)), settings)
    area = np.trapezoid(found.record_spectrum.values[:, 0], found.record_omega.values)
    assert area == pytest.approx(float(found.record_std[0]) ** 2, rel=0.03)


def test_scaling_to_the_record_keeps_the_variance_exactly(sea, time):
    found = record_spectra(made_record(time, wave__m=sea.at(time)), SpectrumSettings(scaling="record"))
    area = np.trapezoid(found.record_spectrum.values[:, 0], found.record_omega.values)
    assert area == pytest.approx(float(found.record_std[0]) ** 2, rel=1e-12)


def test_a_mean_and_a_line_are_taken_off(sea, time):
    plain = record_spectra(made_record(time, wave__m=sea.at(time)))
    lifted = record_spectra(made_record(time, wave__m=sea.at(time) + 7.0))
    tilted = record_spectra(
        made_record(time, wave__m=sea.at(time) + 0.01 * time), SpectrumSettings(detrend="linear")
    )
    kept = record_spectra(made_record(time, wave__m=sea.at(time) + 7.0), SpectrumSettings(detrend="none"))
    assert lifted.record_spectrum.values == pytest.approx(plain.record_spectrum.values, abs=1e-9)
    level = plain.record_spectrum.values.max()
    assert tilted.record_spectrum.values == pytest.approx(plain.record_spectrum.values, abs=0.02 * level)
    assert kept.record_spectrum.values[0, 0] > 100 * level


def test_spectrum_is_that_of_the_sea():
    time = np.arange(0, 4 * 3600, 0.25)
    sea = sines(count=1500, seed=7)
    found = record_spectra(made_record(time, wave__m=sea.at(time)), SpectrumSettings(segment=512))
    omega = found.record_omega.values
    inside = (omega > 0.5) & (omega < 2.0)
    known = wave_spectrum(SeaState(significant_wave_height=2.0, peak_period=8.0), omega[inside])
    assert found.record_spectrum.values[inside, 0] == pytest.approx(known, rel=0.35)
    held = (found.spectrum_low.values[inside, 0] < known) & (known < found.spectrum_high.values[inside, 0])
    assert np.mean(held) > 0.75


@pytest.mark.parametrize("window", ["hann", "cosine-taper"])
def test_band_holds_a_known_spectrum_as_often_as_it_says(rng, window):
    settings = SpectrumSettings(segment=64, window=window, confidence=0.9)
    step, held, ratios = 0.5, [], []
    for _ in range(300):
        found = record_spectra(made_record(step * np.arange(640), wave__m=rng.normal(size=640)), settings)
        known = step / np.pi
        low, high = found.spectrum_low.values[4:-4, 0], found.spectrum_high.values[4:-4, 0]
        held.append(np.mean((low < known) & (known < high)))
        ratios.append(found.record_spectrum.values[4:-4, 0] / known)
    assert np.mean(held) == pytest.approx(0.9, abs=0.015)
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.02)
    assert 2 / np.var(ratios) == pytest.approx(found.attrs["degrees_of_freedom"], rel=0.07)


def test_freedom_of_separate_segments_is_two_each():
    assert degrees_of_freedom(10, SpectrumSettings(overlap=0.0)) == 20
    assert degrees_of_freedom(1, SpectrumSettings()) == 2
    half = degrees_of_freedom(1000, SpectrumSettings())
    assert half / 1000 == pytest.approx(
        2 / (1 + 2 / 36), rel=1e-3
    )  # [Welch1967]: 1/6 of a Hann window shared


def test_too_short_records_are_refused_with_the_length_they_need():
    record = made_record(np.arange(100) * 0.1, wave__m=np.sin(np.arange(100)))
    with pytest.raises(InputError, match=r"at least 51\.2 s long for frequencies 0\.123 rad/s apart"):
        record_spectra(record)


def test_short_records_are_warned_of(sea):
    time = np.arange(0, 300, 0.25)
    notes = warnings_of(
        record_spectra(made_record(time, wave__m=sea.at(time)), SpectrumSettings(segment=512))
    )
    assert any("mean periods" in note and "Lloyd" in note for note in notes)
    assert any("segments only" in note for note in notes)
    long = np.arange(0, 3600, 0.25)
    assert not warnings_of(record_spectra(made_record(long, wave__m=sea.at(long))))


def test_segments():
    settings = SpectrumSettings(segment=512)
    assert segments_in(512, settings, 1.0) == 1
    assert segments_in(1024, settings, 1.0) == 3
    step = 0.25
    size = segment_for(0.05, step)
    assert size & (size - 1) == 0
    assert 2 * np.pi / (size * step) <= 0.05
    assert 2 * np.pi / (size / 2 * step) > 0.05


def test_slope_spectrum():
    omega = np.array([0.5, 1.0])
    assert slope_spectrum(omega, [2.0, 3.0], omega**2 / 9.80665) == pytest.approx(
        np.array([2.0 * 0.0625, 3.0]) / 9.80665**2
    )


def test_one_run_keeps_its_variance_whatever_the_padding(sea):
    time = np.arange(0, 60, 0.05)
    values = sea.at(time) + 3.0 - 0.02 * time
    for size in (None, 8192):
        omega, found = run_spectrum(values, 0.05, size)
        assert np.trapezoid(found, omega) == pytest.approx(np.var(signal.detrend(values)), rel=1e-12)
    with pytest.raises(InputError, match="at least those of the run"):
        run_spectrum(values, 0.05, 16)


def test_runs_are_averaged(sea):
    time = np.arange(0, 30, 0.05)
    runs = [sea.at(time + 100 * number) for number in range(40)]
    omega, found = averaged_runs([*runs[:-1], runs[-1][:500]], 0.05)
    single = [run_spectrum(run, 0.05, 1024)[1] for run in (*runs[:-1], runs[-1][:500])]
    assert found == pytest.approx(np.mean(single, axis=0))
    assert 4 * np.sqrt(np.trapezoid(found, omega)) == pytest.approx(2.0, rel=0.1)
    with pytest.raises(InputError, match="at least one"):
        averaged_runs([], 0.05)


@pytest.mark.parametrize("wrong", [{"segment": 8}, {"segment": 99.5}, {"overlap": 1.0}, {"window": "box"}])
def test_settings_refuse(wrong):
    with pytest.raises(InputError):
        SpectrumSettings(**wrong)
