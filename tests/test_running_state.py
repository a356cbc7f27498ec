"""Running attitude: the hull moves about the centre of gravity by what was stated."""

from dataclasses import replace

import numpy as np
import pytest

from workbench import designs, pipeline
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.geometry.lines import floating_hull
from workbench.hydrodynamics.high_speed import hydrodynamics
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.running_state import RunningState

SHIP = designs.named_design("delft-372")
CENTRE = -0.1
COARSE = HighSpeedSettings(stations=40, panels=12)
STATE = RunningState(running_trim=np.radians(-1.2), running_sinkage=-0.012)


def keel_height(hull, x):
    return float(floating_hull(hull, 0).contours(np.array([x]), whole=False)[0, :, 1].min())


@pytest.mark.parametrize("trim_at_rest", [0.0, 0.01])
def test_hull_turns_about_the_centre_of_gravity_and_sinks_there(trim_at_rest):
    hull = replace(SHIP.hull, trim=trim_at_rest, sinkage=0.004)
    running = STATE.running_hull(hull, CENTRE)
    assert keel_height(running, CENTRE) - keel_height(hull, CENTRE) == pytest.approx(0.012, abs=1e-9)
    away = CENTRE + 0.6
    rise = keel_height(running, away) - keel_height(hull, away)
    tilt = np.tan(trim_at_rest + STATE.running_trim) - np.tan(trim_at_rest)
    assert rise - 0.012 == pytest.approx(-0.6 * tilt, abs=1e-9)
    assert rise > 0.012  # bow up is negative trim
    assert running.trim == pytest.approx(trim_at_rest + STATE.running_trim)


def test_without_an_attitude_nothing_changes():
    assert RunningState().running_hull(SHIP.hull, CENTRE) is SHIP.hull


def test_response_is_that_of_the_hull_in_its_attitude():
    speed = 0.6 * np.sqrt(GRAVITY * SHIP.hull.length)
    omega = [3.0, 4.5]
    found = pipeline.response(SHIP, speed, [np.pi], omega, COARSE, running_state=STATE)
    centre = SHIP.masses.centre_of_gravity[0]
    designed = replace(
        SHIP.hull,
        trim=STATE.running_trim,
        sinkage=STATE.running_sinkage - centre * np.tan(STATE.running_trim),
    )
    known = hydrodynamics(designed, SHIP.density, omega, [np.pi], speed, COARSE)
    for name in ("added_mass", "excitation_force"):
        np.testing.assert_allclose(found.hydrodynamics[name].values, known[name].values, rtol=1e-9)
    level = pipeline.response(SHIP, speed, [np.pi], omega, COARSE)
    pitch = [np.abs(one.motions.motion_rao.values[:, 0, 4]) for one in (found, level)]
    assert np.abs(pitch[0] / pitch[1] - 1).max() > 0.02
    assert found.running_state == STATE


@pytest.mark.parametrize("given", [{"running_trim": 0.3}, {"running_sinkage": np.nan}])
def test_impossible_attitudes_are_refused(given):
    with pytest.raises(InputError, match="running"):
        RunningState(**given)
