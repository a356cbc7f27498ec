"""The ship's own steady wave: a wavemaker in closed form, and what it must do on ships."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from workbench import designs
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.hydrodynamics.cross_plane import Water, passage
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.marched_contour import Contour
from workbench.hydrodynamics.own_wave import own_wave

FAST = 0.75 * np.sqrt(GRAVITY * 3.0)


@pytest.fixture(scope="module")
def model():
    return designs.named_design("delft-372")


def found(design, speed=FAST, x=(-1.0, 0.0, 1.0), y=(0.0,), **choices):
    return own_wave(
        design.hull, design.masses, design.density, speed, x, y, HighSpeedSettings(stations=60, **choices)
    )


def wavemaker(y: float, time: float, draught: float) -> float:
    """Elevation per wall velocity [s] beside a thin strut that widens at a steady rate from rest, deep water."""

    def integrand(root):  # k = root**2 tames the oscillation
        k = root**2
        wave = np.sin(np.sqrt(GRAVITY) * root * time) / (np.sqrt(GRAVITY) * root)
        return -np.expm1(-k * draught) / k * wave * np.cos(k * y) * 2 * root

    return 2 / np.pi * quad(integrand, 1e-9, 30.0, limit=2000)[0]


def test_a_widening_strut_makes_the_wave_of_a_wavemaker():
    draught, half = 1.0, 0.01
    down = np.linspace(-draught, 0, 41)
    wall = half + 1j * down
    line = np.concatenate([[0 - 1j * draught], wall])
    contour = Contour(line[:-1], line[1:], ((-half, half),), np.zeros(len(line) - 1, int))

    def widening(number, section):
        return np.where(section.normals.real > 0.5, 1.0, 0.0)[:, None]

    step, count = 0.01, 120
    water = Water(16.0, 0.02, 1)
    beside = np.array([0.5, 1.0, 2.0])
    march = passage([contour] * count, step, water, widening, 1, 1, beside)
    for number in (60, 119):
        expected = [wavemaker(y, number * step, draught) for y in beside]
        np.testing.assert_allclose(march.elevation[number, :, 0].real, expected, rtol=0.01, atol=0.0095)


def test_measured_attitude_of_the_delft_model_is_met_at_high_speed(model):
    running = found(model)
    assert np.degrees(float(running.running_trim)) == pytest.approx(-1.35, abs=0.1)
    assert float(running.running_sinkage) == pytest.approx(-0.00257, abs=0.003)
    assert running.attrs["warnings"] == ""


def test_low_speed_is_warned_of_and_rest_refused(model):
    assert "waves that run with the ship" in found(model, 0.3 * FAST / 0.75).attrs["warnings"]
    with pytest.raises(InputError, match=r"Froude number must be >= 0\.1"):
        found(model, 0.1)


def test_own_wave_is_even_and_scales_with_the_ship(model):
    y = (-0.2, 0.0, 0.2)
    small = found(model, y=y)
    np.testing.assert_allclose(small.steady_elevation[:, 0], small.steady_elevation[:, 2], atol=1e-12)
    large = model.scaled(20)
    big = found(large, FAST * np.sqrt(20), (-20.0, 0.0, 20.0), (-4.0, 0.0, 4.0))
    np.testing.assert_allclose(big.steady_elevation, 20 * small.steady_elevation, rtol=1e-6, atol=1e-9)
    assert float(big.running_trim) == pytest.approx(float(small.running_trim), rel=1e-6)


def test_hulls_far_apart_do_not_lift_each_other(model):
    wide = replace(model, hull=replace(model.hull, spacing=5.0))
    alone, together = found(wide, interaction="off"), found(wide)
    assert float(together.running_trim) == pytest.approx(float(alone.running_trim), rel=0.02)
    near = found(model)
    assert abs(float(near.running_trim) / float(found(model, interaction="off").running_trim) - 1) > 0.05


def test_water_rises_at_the_bow_and_falls_at_the_stern(model):
    rise = found(model, y=(0.21,)).steady_elevation[:, 0]
    assert float(rise.sel(x=1.0)) > 0 > float(rise.sel(x=-1.0))


def test_unequal_immersion_is_taken_hull_by_hull(model):
    heeled = replace(model, hull=replace(model.hull, heel=np.radians(2.0)))
    rise = found(heeled, y=(-0.6, 0.6)).steady_elevation
    assert not np.allclose(rise[:, 0], rise[:, 1], rtol=0.05)
