"""Chuang's design procedure for a ship: from its motions to a report."""

import json
import re

import numpy as np
import pytest
from typer.testing import CliRunner

from workbench import cli, pipeline
from workbench.conventions import KNOT
from workbench.cross_structure import cross_structure
from workbench.cross_structure_report import LIMITS, report_text, report_values
from workbench.errors import InputError
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.impact.design_load import AreaReduction
from workbench.impact.slam_table import agreement


@pytest.fixture(scope="module")
def ship(twin):
    return pipeline.response(twin, 6.0, [np.pi], np.linspace(0.4, 2.5, 22), StripSettings())


@pytest.fixture(scope="module")
def found(ship):
    return cross_structure(ship, 4.6, 1.6)


def test_prediction_of_a_ship(found, ship):
    assert found.timing.slams
    pressure = found.slams.peak_pressure.values
    assert found.peak_pressure == pytest.approx(np.nanmax(pressure))
    # the worst point lies forward, and next to the centreline where all across are the same
    assert float(found.slams.x[found.worst["x"]]) > 10
    assert abs(float(found.slams.y[found.worst["y"]])) == pytest.approx(0.3)
    assert set(found.natural_periods) == {"heave", "pitch"}
    assert float(found.load.design_line.max()) == pytest.approx(found.peak_pressure)
    known = 1025 * (6.0 + 9.80665 * 4.6 / 2 / np.pi) ** 2
    assert found.bulkhead_pressure == pytest.approx(known)


def test_relative_motion_is_that_of_the_motions_of_the_ship(found, ship):
    """Closing velocity at the worst point from the workbench's own relative motion at the frequency."""
    relative = pipeline.deck_response(ship, ship.design.wet_deck)
    here = relative.isel(wave_direction=0).sel(
        x=found.slams.x[found.worst["x"]], y=found.slams.y[found.worst["y"]], method="nearest"
    )
    amplitude = np.interp(2 * np.pi / 4.6, here.omega.values, np.abs(here.relative_motion.values))
    assert 0.8 * amplitude == pytest.approx(found.timing.relative_motion_amplitude, rel=0.02)


def test_low_wave_does_not_reach_the_deck(ship):
    low = cross_structure(ship, 4.6, 0.2)
    assert not low.timing.slams
    assert low.load is None
    assert low.peak_pressure == 0
    assert "does not reach the deck" in report_text(low)
    assert report_values(low)["worst_point"]["peak_pressure"] is None


def test_reduction_by_area_lowers_the_load(ship, found):
    table = AreaReduction(areas=(1.0, 100.0), shares=(1.0, 0.3))
    less = cross_structure(ship, 4.6, 1.6, reduction=table, area=100.0)
    share = less.load.design_pressure.values / found.load.design_pressure.values
    assert share == pytest.approx(0.3)


def test_report_states_numbers_and_limits(found):
    text = report_text(found, {"model slams": agreement([1.0, 2.0], [1.0, 1.0])})
    for limit in LIMITS:
        assert limit in text
    for words in (
        "head wave",
        "peak pressure",
        "twice the stagnation pressure",
        "| model slams | 2 | 1.5 | 1.5 | 1 to 2 |",
    ):
        assert words in text
    printed = re.search(r"\| peak pressure \| ([\d.]+) kPa \|", text)
    assert float(printed[1]) == pytest.approx(found.peak_pressure / 1e3, rel=6e-3)
    centre, side = (float(part) for part in re.search(r"\| 2\.\d+ \| ([\d.]+) \| ([\d.]+) \|", text).groups())
    assert side / centre == pytest.approx(0.7, rel=0.01)


def test_limits_are_those_of_the_source():
    words = " ".join(LIMITS)
    for needed in ("Head seas", "Flat bottom", "regular waves", "Local loads", "No percentage", "heading"):
        assert needed in words


def test_a_ship_without_wet_deck_is_refused(ship):
    from dataclasses import replace

    bare = replace(ship, design=replace(ship.design, wet_deck=None))
    with pytest.raises(InputError, match="must have a wet deck"):
        cross_structure(bare, 5.0, 1.0)
    with pytest.raises(InputError, match="wave height must be"):
        cross_structure(ship, 5.0, 0.0)
    with pytest.raises(InputError, match="wave frequency must be"):
        cross_structure(ship, 1.0, 0.05)


def test_command_prints_a_report_or_one_object():
    words = [
        "cross-structure",
        "austal-63",
        "--speed-knots",
        "20",
        "--wave-height",
        "2",
        "--wave-period",
        "7",
    ]
    words += ["--method", "strip"]
    values = json.loads(CliRunner().invoke(cli.application, [*words, "--json"]).stdout)
    assert values["slams"] is True
    assert values["speed"] == pytest.approx(20 * KNOT)
    assert values["worst_point"]["peak_pressure"] == pytest.approx(values["design_peak"], rel=0.01)
    text = CliRunner().invoke(cli.application, words).stdout
    assert text.startswith("# Slamming of the cross structure: austal-63")
