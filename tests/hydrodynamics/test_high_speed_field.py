"""Waves between the hulls by the high-speed theory, and their way into relative motion."""

from dataclasses import replace

import numpy as np
import pytest

from workbench import designs, pipeline
from workbench.conventions import GRAVITY
from workbench.hydrodynamics import high_speed
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings

SPEED = 0.6 * np.sqrt(GRAVITY * 3.0)
OMEGA = np.array([1.0, 3.0, 4.0])


@pytest.fixture(scope="module")
def model():
    return designs.named_design("delft-372")


def solved(design, directions=(np.pi,), **choices):
    settings = HighSpeedSettings(wave_field="total", panels=16, **choices)
    return high_speed.solution(design.hull, design.density, OMEGA, directions, SPEED, settings)


def test_waves_of_the_other_side_are_the_mirror_image(model):
    _, field = solved(model, np.radians([150.0, 210.0]))
    port, starboard = (field.diffracted_elevation.values[:, side] for side in (0, 1))
    np.testing.assert_allclose(port, starboard[..., ::-1], atol=1e-12)
    assert not np.allclose(port, port[..., ::-1], rtol=0.05)
    heave = field.radiated_elevation.sel(radiating_dof="heave").values
    sway = field.radiated_elevation.sel(radiating_dof="sway").values
    np.testing.assert_allclose(heave, heave[..., ::-1], atol=1e-9)
    np.testing.assert_allclose(sway, -sway[..., ::-1], atol=1e-9)
    assert np.abs(field.radiated_elevation.sel(radiating_dof="surge")).max() == 0


def test_roll_is_the_heave_of_each_hull_times_its_arm_where_hulls_are_alone(model):
    """A far centreline sees hulls heaving in opposite sense: nothing; together they add up."""
    _, field = solved(model, interaction="off")
    middle = len(field.field_y) // 2
    roll = field.radiated_elevation.sel(radiating_dof="roll").values[..., middle]
    assert np.abs(roll).max() < 1e-9
    heave = field.radiated_elevation.sel(radiating_dof="heave").values[..., middle]
    assert np.abs(heave).max() > 0.1


def test_each_hull_alone_is_left_as_it_is_by_a_wider_spacing(model):
    """At the same distance from one hull, the waves of hulls far apart are those of that hull alone."""
    wide = replace(model, hull=replace(model.hull, spacing=5.9))
    _, near = solved(model, interaction="off")
    _, far = solved(wide, interaction="off")
    at = float(near.field_y[-1])  # beside the port hull
    beside = far.field_y.values - (5.9 - 0.7) / 2
    assert beside[-1] == pytest.approx(at)
    own = far.radiated_elevation.sel(radiating_dof="heave").values[1, 0, :, -1]
    both = near.radiated_elevation.sel(radiating_dof="heave").values[1, 0, :, -1]
    forward = near.field_x.values > 0.5  # the other hull's waves are not there yet
    assert np.abs(own - both)[forward].max() < 0.25 * np.abs(own).max()
    assert np.abs(own).max() > 0.3


def test_scattered_waves_vanish_in_long_waves(model):
    """A ship that follows a long wave disturbs it little; a ship held in it would."""
    settings = HighSpeedSettings(wave_field="total")
    ship = pipeline.response(model, SPEED, [np.pi], OMEGA, settings)
    deck = replace(designs.named_design("austal-63").wet_deck.scaled(3 / 76), clearance=0.2)
    with_waves = pipeline.deck_response(ship, deck)
    without = pipeline.deck_response(replace(ship, wave_field=None), deck)
    scattered = np.abs((with_waves.relative_motion - without.relative_motion).values)
    assert with_waves.attrs["waves"] == "incident, diffracted and radiated"
    assert scattered[0].max() < 0.15
    assert scattered[1:].max() > 0.5


def test_option_is_off_unless_asked_for(model):
    found = high_speed.solution(model.hull, model.density, OMEGA, [np.pi], SPEED)
    assert found[1] is None
    assert any("incident wave" in one for one in found[0].attrs["warnings"].splitlines())
