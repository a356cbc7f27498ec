"""Slams read from a record of known motions."""

import json

import numpy as np
import pytest
from model_slams import CLEARANCE, LEVER, MOTION, PERIOD, PROBE, WAVE, instants, slam_record
from typer.testing import CliRunner

from workbench import cli
from workbench.errors import InputError
from workbench.impact.slam_table import predicted_slams
from workbench.records.slam_reduction import (
    ReductionSettings,
    SlamChannels,
    impact_instants,
    line_at,
    reduced_slams,
)

CHANNELS = SlamChannels(pressure="P1", pitch_factor=-np.pi / 180)
SETTINGS = ReductionSettings(
    lever=LEVER, probe_distance=PROBE, closing_speed=WAVE.closing_speed, window=0.01, least_pressure=5e3
)


def test_reduction_finds_the_state_at_impact():
    found = reduced_slams(slam_record(), SETTINGS, CHANNELS)
    at = instants(3)
    assert found.event_time.values == pytest.approx(at, abs=5e-4)
    state = MOTION.at(found.event_time.values, LEVER)
    assert found.recorded_pressure.values == pytest.approx(20e3, rel=0.1)
    assert found.attitude.values == pytest.approx(state.pitch, abs=1e-4)
    assert found.heave_velocity.values == pytest.approx(state.heave_velocity, rel=1e-3)
    assert found.pitch_velocity.values == pytest.approx(state.pitch_velocity, rel=1e-3, abs=1e-3)
    assert found.surface_velocity.values == pytest.approx(state.surface_velocity, rel=2e-3)
    assert found.wave_slope.values == pytest.approx(state.wave_slope, rel=2e-3)
    assert found.attrs["wave_shift"] == pytest.approx(PROBE / WAVE.closing_speed)


def test_shift_of_the_wave_matters():
    """The same record read as if the probe stood at the gauge has another slope."""
    at_gauge = ReductionSettings(
        lever=LEVER, probe_distance=0.0, closing_speed=WAVE.closing_speed, window=0.01, least_pressure=5e3
    )
    shifted = reduced_slams(slam_record(), SETTINGS, CHANNELS)
    unshifted = reduced_slams(slam_record(), at_gauge, CHANNELS)
    assert np.abs(shifted.wave_slope - unshifted.wave_slope).min() > 0.02


def test_from_a_record_to_k():
    """The pressure that Method I predicts, put into the record, comes back as k of the prediction."""
    state = MOTION.at(MOTION.impact_instant(LEVER, CLEARANCE), LEVER)
    first = predicted_slams(reduced_slams(slam_record(), SETTINGS, CHANNELS), 1000.0)
    again = slam_record(pressure=float(first.peak_pressure[0]))
    found = predicted_slams(reduced_slams(again, SETTINGS, CHANNELS), 1000.0)
    assert found.recorded_constant.values == pytest.approx(found.pressure_constant.values, rel=0.03)
    assert found.impact_angle.values == pytest.approx(abs(float(state.pitch - state.wave_slope)), abs=5e-3)


def test_slams_near_the_ends_are_left_out():
    cut = slam_record()
    late = cut.isel(time=slice(int((instants(3)[0] - 0.1) / 0.0005), None))
    found = reduced_slams(late, SETTINGS, CHANNELS)
    assert found.sizes["event"] == 2
    assert "1 slams too near the ends" in found.attrs["warnings"]


def test_no_slam_is_an_empty_table():
    high = ReductionSettings(
        lever=1.0, probe_distance=0.5, closing_speed=3.0, window=0.01, least_pressure=1e9
    )
    assert reduced_slams(slam_record(), high, CHANNELS).sizes["event"] == 0


def test_impact_instants_one_a_slam():
    time = np.arange(0, 2, 0.001)
    pressure = np.exp(-(((time - 0.5) / 0.01) ** 2)) + 0.5 * np.exp(-(((time - 0.6) / 0.01) ** 2))
    assert impact_instants(time, pressure, 0.2, 0.3) == pytest.approx([0.5])
    assert impact_instants(time, pressure, 0.2, 0.01) == pytest.approx([0.5, 0.6])
    assert len(impact_instants(time, pressure, 2.0, 0.3)) == 0


def test_line_through_a_stretch():
    time = np.arange(0, 1, 0.01)
    assert line_at(time, 3 - 2 * time, 0.5, 0.05) == pytest.approx((2.0, -2.0))
    for instant, window in ((0.01, 0.05), (0.5, 0.005)):
        with pytest.raises(InputError, match="three samples or more"):
            line_at(time, time, instant, window)


@pytest.mark.parametrize(
    "given", [{"closing_speed": 0}, {"window": 0}, {"least_pressure": 0}, {"probe_distance": -1}]
)
def test_settings_are_checked(given):
    values = {"lever": 1, "probe_distance": 1, "closing_speed": 3, "window": 0.1, "least_pressure": 10}
    with pytest.raises(InputError):
        ReductionSettings(**{**values, **given})
    with pytest.raises(InputError, match="must not be 0"):
        SlamChannels(wave_factor=0.0)


def test_encounters_are_those_of_the_wave():
    assert np.diff(instants(3)) == pytest.approx(PERIOD)


def test_command_reads_a_file(tmp_path):
    """The same k by way of a CSV file with the units of the laboratory."""
    trial, path = slam_record(), tmp_path / "run.csv"
    values = np.column_stack([trial.time.values, trial.measured.values[:, :4]])
    values[:, 4] /= 1e3
    np.savetxt(
        path,
        values,
        delimiter=",",
        comments="",
        fmt="%.7f",
        header="time [s],pitch [deg],heave [m],wave [m],P1 [kPa]",
    )
    words = [
        "slam-record",
        path,
        "--pressure",
        "P1",
        "--bow-down",
        "--lever",
        LEVER,
        "--probe-distance",
        PROBE,
    ]
    words += [
        "--wave-period",
        1.71,
        "--speed-knots",
        1 * 3600 / 1852,
        "--least-pressure",
        5,
        "--density",
        1000,
    ]
    values = json.loads(CliRunner().invoke(cli.application, [*map(str, words), "--json"]).stdout)
    known = predicted_slams(reduced_slams(trial, SETTINGS, CHANNELS), 1000.0)
    assert values["slams"] == 3
    assert values["columns"]["k recorded [1]"] == pytest.approx(known.recorded_constant.values, rel=1e-3)
    assert values["columns"]["impact angle [deg]"] == pytest.approx(np.degrees(known.impact_angle), rel=1e-3)
    assert values["columns"]["recorded [kPa]"] == pytest.approx(known.recorded_pressure.values / 1e3)
    text = CliRunner().invoke(cli.application, list(map(str, words))).stdout
    assert len(text.splitlines()) == 4
    none = CliRunner().invoke(cli.application, [*map(str, words), "--least-pressure", "1000"]).stdout
    assert none.strip() == "No slam was found."
