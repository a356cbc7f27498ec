"""Motions of sailing multihulls: upright, heeled, on one hull, with sails."""

from dataclasses import replace

import numpy as np
import pytest

from workbench.damping.sail_damping import SailDampingSettings
from workbench.errors import InputError
from workbench.geometry.hydrostatics import hydrostatics, stiffness_matrix
from workbench.hulls import library
from workbench.hydrodynamics import strip_theory
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.motions import motions
from workbench.sailing import flies, peak, sailing_design, sailing_motions
from workbench.sails import TrueWind

SHIP = library.design("crowther-318")
COARSE = StripSettings(formulation="heave-only", stations=15, panels=16, frequencies=10)
OMEGA = np.linspace(0.8, 3.2, 9)
BOW = [np.radians(135.0)]


def moved(heel=0.0, directions=BOW, **choices):
    return sailing_motions(SHIP, 5.0, OMEGA, directions, heel=np.radians(heel), settings=COARSE, **choices)


def test_upright_without_sails_it_is_the_ship_of_strip_theory():
    found = moved()
    upright = sailing_design(SHIP, 0.0)
    waves = strip_theory.hydrodynamics(upright.hull, SHIP.density, OMEGA, BOW, 5.0, COARSE)
    stiffness = stiffness_matrix(upright.hull, SHIP.masses, SHIP.density)
    expected = motions(waves, SHIP.masses, stiffness, locked=("surge", "sway", "yaw"))
    np.testing.assert_array_equal(found.motion_rao, expected.motion_rao)
    assert found.attrs["locked"] == "surge, sway, yaw"


def test_port_heel_in_waves_from_port_is_starboard_heel_in_waves_from_starboard():
    one, other = moved(2.0), moved(-2.0, [-BOW[0]])
    np.testing.assert_allclose(np.abs(one.motion_rao), np.abs(other.motion_rao), rtol=1e-3, atol=1e-9)


def test_roll_is_locked_on_one_hull_only():
    assert not flies(sailing_design(SHIP, np.radians(2.0)))
    assert flies(sailing_design(SHIP, np.radians(5.0)))
    assert peak(moved(2.0), "roll") > 0
    flying = moved(5.0)
    assert peak(flying, "roll") == 0
    assert "roll" in flying.attrs["locked"]


def test_heeled_ship_floats_at_its_displacement():
    afloat = sailing_design(SHIP, np.radians(2.0)).hull
    assert float(hydrostatics(afloat, SHIP.density).displacement) == pytest.approx(SHIP.masses.mass, rel=2e-3)
    other = moved(2.0)
    as_upright = replace(SHIP.hull, heel=np.radians(2.0))
    assert abs(afloat.sinkage - as_upright.sinkage) > 0.005
    waves = strip_theory.hydrodynamics(afloat, SHIP.density, OMEGA, BOW, 5.0, COARSE)
    stiffness = stiffness_matrix(afloat, SHIP.masses, SHIP.density)
    expected = motions(waves, SHIP.masses, stiffness, locked=("surge", "sway", "yaw"))
    np.testing.assert_array_equal(other.motion_rao, expected.motion_rao)


def test_only_a_heeled_ship_rolls_in_head_waves():
    head = [np.pi]
    assert peak(moved(0.0, head), "roll") < 1e-9
    assert peak(moved(2.0, head), "roll") > 1e-3


def test_wind_brings_the_damping_of_the_sails_by_choice():
    wind = TrueWind(speed=8.0)
    calm, windy = moved(5.0), moved(5.0, wind=wind)
    assert peak(windy, "pitch") < peak(calm, "pitch")
    signed = moved(5.0, wind=wind, sails=SailDampingSettings(sign="derivative"))
    assert peak(signed, "pitch") > peak(calm, "pitch")
    assert "feeds pitch" in signed.attrs["warnings"]


def test_what_is_no_sailing_ship_is_refused():
    with pytest.raises(InputError, match="has no sail plan"):
        sailing_motions(
            library.design("delft-372"), 1.0, [4.0], BOW, wind=TrueWind(speed=3.0), settings=COARSE
        )
    with pytest.raises(InputError, match="design must be a Design"):
        sailing_motions("crowther-318", 1.0, [4.0], BOW)
