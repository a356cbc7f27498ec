"""Theories beside each other are what the pipeline gives, and their differences from points are known ones."""

import dataclasses

import numpy as np
import pytest
import xarray as xr

from workbench import pipeline
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.hulls.library import design
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.motions import lead_over_wave
from workbench.running_state import RunningState
from workbench.theory_comparison import compared, measured_series, summary

COARSE = RecommendedSettings(
    strip=StripSettings(stations=21, panels=16, frequencies=20, interaction="off"),
    high_speed=HighSpeedSettings(stations=40, panels=10, interaction="off"),
)
SPEED = 0.5 * np.sqrt(GRAVITY * 3.0)
OMEGA = np.sqrt(2 * np.pi * GRAVITY / (3.0 * np.array([2.5, 2.0, 1.5, 1.2, 1.0, 0.8])))


@pytest.fixture(scope="module")
def ship():
    return design("delft-372")


@pytest.fixture(scope="module")
def both(ship):
    return compared(ship, SPEED, np.pi, omega=OMEGA, settings=COARSE)


def test_amplitudes_and_leads_are_those_of_the_pipeline(ship, both):
    assert both.theory_name.values.tolist() == ["strip theory", "high-speed theory"]
    for name in ("strip", "high-speed"):
        moved = pipeline.response(ship, SPEED, [np.pi], OMEGA, COARSE.of(name)).motions
        one = both.sel(theory=name)
        rao = np.abs(moved.motion_rao.values[:, 0])
        np.testing.assert_allclose(one.motion_ratio.sel(dof="heave"), rao[:, 2])
        np.testing.assert_allclose(one.motion_ratio.sel(dof="pitch"), rao[:, 4] * GRAVITY / OMEGA**2)
        lead = lead_over_wave(moved).values[:, 0, [2, 4]]
        np.testing.assert_allclose(np.exp(1j * one.motion_lead.values), np.exp(1j * lead))
        assert float(one.computing_time) > 0
    np.testing.assert_allclose(both.wavelength_over_length, [2.5, 2.0, 1.5, 1.2, 1.0, 0.8])


def test_long_waves_are_ridden(ship):
    found = compared(ship, 0.0, np.pi, ("strip",), [0.3], settings=COARSE)
    np.testing.assert_allclose(found.motion_ratio.values.ravel(), 1.0, atol=0.02)
    np.testing.assert_allclose(found.motion_lead.values.ravel(), [0.0, -np.pi / 2], atol=0.1)


def test_running_attitude_changes_the_motions(ship, both):
    trimmed = compared(
        ship, SPEED, np.pi, ("strip",), OMEGA, settings=COARSE, running_state=RunningState(running_trim=-0.02)
    )
    assert float(np.abs(trimmed.motion_ratio - both.motion_ratio.sel(theory=["strip"])).max()) > 0.01


def test_theory_that_cannot_be_used_is_left_out_with_its_reason(ship):
    found = compared(ship, 0.0, np.pi, omega=OMEGA[:2], settings=COARSE)
    assert found.theory.values.tolist() == ["strip"]
    assert found.attrs["left_out"].startswith("High-speed theory left out: Froude number must be")
    with pytest.raises(InputError, match="Froude number"):
        compared(ship, 0.0, np.pi, ("high-speed",), OMEGA)
    with pytest.raises(InputError, match="theory to compare must be one of"):
        compared(ship, 0.0, np.pi, ("recommended",), OMEGA)
    with pytest.raises(InputError, match=r"one at least, got none"):
        compared(ship, 0.0, np.pi, (), OMEGA)


def test_ship_that_cannot_float_is_refused(ship):
    heavy = dataclasses.replace(ship, masses=dataclasses.replace(ship.masses, mass=2 * ship.masses.mass))
    with pytest.raises(InputError, match="mass"):
        compared(heavy, SPEED, np.pi, omega=OMEGA)


def test_panel_method_is_taken_between_its_own_frequencies(ship, monkeypatch):
    smooth = {}

    def answer(_design, speed, directions, omega, settings, **others):
        assert omega is None
        nodes = np.linspace(1.0, 6.0, 26)
        rao = np.zeros((26, 1, 6), complex)
        rao[:, 0, 2] = smooth["heave"](nodes)
        rao[:, 0, 4] = nodes**2 / GRAVITY * 1j
        moved = xr.Dataset(
            {
                "motion_rao": (("omega", "wave_direction", "dof"), rao),
                "wave_at_reference": (("omega", "wave_direction"), np.ones((26, 1), complex)),
                "wavenumber": ("omega", nodes**2 / GRAVITY),
            },
            coords={"omega": nodes, "dof": ["surge", "sway", "heave", "roll", "pitch", "yaw"]},
        )
        others["progress"](0.5, "halfway")
        return type("Found", (), {"motions": moved})

    smooth["heave"] = lambda omega: np.exp(1j * omega) / (1 + omega)
    said = []
    monkeypatch.setattr("workbench.theory_comparison.response", answer)
    asked = np.array([2.05, 3.33, 7.0])
    found = compared(
        ship, 0.0, np.pi, ("potential-flow",), asked, progress=lambda part, words: said.append((part, words))
    )
    heave = found.motion_ratio.sel(dof="heave").values[0]
    np.testing.assert_allclose(heave[:2], 1 / (1 + asked[:2]), rtol=1e-4)
    assert np.isnan(heave[2])
    np.testing.assert_allclose(found.motion_lead.sel(dof="heave").values[0, 0], -asked[0], atol=1e-3)
    np.testing.assert_allclose(found.motion_ratio.sel(dof="pitch").values[0, :2], 1.0, rtol=1e-6)
    assert said == [(0.0, "panel method: begins"), (0.5, "panel method: halfway")]


def test_differences_from_points_are_the_known_ones(both):
    one = both.sel(theory="strip")
    ratio, lead = one.motion_ratio.values, one.motion_lead.values
    shifted = measured_series(
        "shifted", one.wavelength_over_length.values, ratio - 0.1, lead - np.radians(20.0), "nowhere"
    )
    found = summary(both, (shifted,))
    peaks = ratio.max(axis=0)
    np.testing.assert_allclose(found.peak_ratio.sel(theory="strip"), peaks)
    at = one.wavelength_over_length.values[ratio.argmax(axis=0)]
    np.testing.assert_allclose(found.peak_wavelength.sel(theory="strip"), at)
    mean = np.abs(np.abs(ratio) - (ratio - 0.1)).mean() / (peaks - 0.1)
    np.testing.assert_allclose(found.mean_difference.sel(theory="strip", series="shifted"), mean, rtol=1e-6)
    away = np.degrees(found.lead_difference.sel(theory="strip", series="shifted").values)
    np.testing.assert_allclose(away, 20.0, atol=1e-6)
    assert "mean_difference" not in summary(both)


def test_measured_waves_are_computed_too(ship):
    series = measured_series("one", [1.234, 0.777], np.ones((2, 2)), np.zeros((2, 2)), "nowhere")
    np.testing.assert_allclose(series.wavelength_over_length, [0.777, 1.234])
    found = compared(ship, SPEED, np.pi, ("strip",), measured=(series,), settings=COARSE)
    for wanted in (0.777, 1.234):
        assert np.abs(found.wavelength_over_length - wanted).min() < 1e-6
    assert float(found.wavelength_over_length.min()) == pytest.approx(0.4)
    assert float(found.wavelength_over_length.max()) == pytest.approx(3.0)
