"""Figures of measured records show the numbers they are given."""

import numpy as np
import pytest

from workbench.figures import records as figures
from workbench.figures.style import picture
from workbench.records.crossings import exceedance
from workbench.records.reading import record
from workbench.records.responses import estimated_response
from workbench.records.spectra import SpectrumSettings, record_spectra

TIME = np.arange(0, 600, 0.25)
SETTINGS = SpectrumSettings(segment=256)


@pytest.fixture
def trial(rng):
    wave = np.convolve(rng.normal(size=len(TIME) + 20), np.hanning(21), "valid")
    names, units = ["wave", "pitch", "lift"], ["m", "rad", "m/s2"]
    return record(TIME, np.stack([wave, 0.1 * wave, -wave], axis=1), names, units)


def test_record_and_its_marks(trial):
    axes = figures.record_figure(trial, "lift", start=10, end=20, marks=np.array([5.0, 12.0])).axes[0]
    assert axes.get_ylabel() == "lift [m/s2]"
    assert axes.lines[0].get_xdata()[0] == 10
    assert len(axes.lines) == 2


def test_spectrum_with_its_band(trial):
    found = record_spectra(trial, SETTINGS)
    figure = figures.spectrum_figure(
        found, "wave", highest=4.0, known=(np.array([1.0, 2.0]), np.array([1.0, 2.0]))
    )
    axes = figure.axes[0]
    assert axes.lines[0].get_ydata() == pytest.approx(found.record_spectrum.sel(channel="wave").values)
    assert axes.get_ylabel() == "spectrum of wave [m$^2$ s/rad]"
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["90 % band", "record", "made from"]


def test_response_with_its_error(trial):
    found = estimated_response(trial, "wave", settings=SETTINGS)
    axes = figures.response_figure(found, "pitch", known=(np.array([1.0]), np.array([1.0]))).axes[0]
    assert axes.get_ylabel() == "pitch [rad per wave slope]"
    assert len(axes.lines) >= 3
    assert len(picture(figures.response_figure(found, "lift"))) > 5000


def test_exceedance_with_its_limit(trial):
    found = exceedance(TIME, trial.measured.values[:, 2], np.linspace(0, 10, 20))
    axes = figures.exceedance_figure(found, name="lift", unit="m/s2", limit=3.0).axes[0]
    assert axes.get_yscale() == "log"
    assert axes.get_xlabel() == "crest of lift [m/s2]"
    assert axes.lines[2].get_xdata()[0] == 3.0
