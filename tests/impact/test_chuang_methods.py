"""Chuang's Methods I and II, his wave, his program and the inclined surface."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact import chuang, program_cat
from workbench.impact.chuang_orbital import closing_difference, method_two, orbit
from workbench.impact.froude import ASR_21, FroudeScale
from workbench.impact.regular_wave import RegularWave, celerity, surface_slope, surface_velocity
from workbench.impact.stavovy_chuang import PREDICTED, STANDING, surface_impact, surface_normal
from workbench.quantities import warnings_of

FOOT, KNOT, PSI, SLUG = 0.3048, 1852 / 3600, 6894.757, 515.3788
MODEL = RegularWave(amplitude=0.3 * FOOT, period=1.71, speed=1.98 * KNOT)


def test_trim_takes_part_in_the_attitude():
    """A deck that rises forward by 3 degrees on a ship 8 degrees bow down is a deck 5 degrees bow down."""
    trimmed = chuang.method_one(1.8, -0.5, 0.6, np.radians(-8), 0.02, 1000.0, trim=np.radians(3))
    level = chuang.method_one(1.8, -0.5, 0.6, np.radians(-5), 0.02, 1000.0)
    assert np.array(trimmed) == pytest.approx(np.array(level))
    assert trimmed.impact_angle == pytest.approx(np.radians(5) + 0.02)


def test_without_wave_slope_and_pitching_the_vertical_velocity_comes_back():
    found = chuang.method_one(2.0, -0.5, 0.0, np.radians([-12.0, 0.0, 7.0]), 0.0, 1000.0)
    assert found.normal_velocity == pytest.approx(2.5)


def test_pitch_velocity_is_downward_for_a_falling_bow():
    assert chuang.pitch_velocity(-0.2, 4.0) == pytest.approx(0.8)
    assert chuang.pitch_velocity(-0.2, -4.0) == pytest.approx(-0.8)


def test_wave_of_the_worked_example():
    assert MODEL.wavelength / FOOT == pytest.approx(14.973, abs=2e-3)
    assert MODEL.celerity / FOOT == pytest.approx(8.7563, abs=1e-3)
    assert MODEL.orbital_velocity / FOOT == pytest.approx(1.1023, abs=2e-4)
    assert np.degrees(MODEL.largest_slope) == pytest.approx(7.2128, abs=1e-3)
    assert MODEL.encounter_frequency == pytest.approx(MODEL.wavenumber * (MODEL.celerity + 1.98 * KNOT))
    velocity = surface_velocity(MODEL.largest_slope, MODEL.closing_speed)
    assert velocity / FOOT == pytest.approx(-1.5311, abs=1e-3)
    assert surface_slope(velocity, MODEL.closing_speed) == pytest.approx(MODEL.largest_slope)
    assert celerity(1.4) / FOOT == pytest.approx(7.169, abs=1e-3)


def test_method_one_in_the_state_of_the_worked_example():
    slope = MODEL.largest_slope
    water = surface_velocity(slope, MODEL.closing_speed)
    found = chuang.method_one(1.8 * FOOT, water, FOOT, np.radians(-8), slope, 1.94 * SLUG)
    assert found.normal_velocity / FOOT == pytest.approx(4.2300, abs=5e-4)
    assert found.tangential_velocity / FOOT == pytest.approx(-1.1280, abs=5e-4)
    assert found.total_pressure / PSI == pytest.approx(2.808, abs=2e-3)


def test_method_two_in_the_worked_example():
    """Equations 8 and 9 by hand, bow 8 degrees down where the slope is largest."""
    found = method_two(MODEL, 0.0, 1.8 * FOOT, FOOT, np.radians(-8), 1.94 * SLUG)
    assert np.degrees(found.impact_angle) == pytest.approx(15.2128, abs=1e-3)
    assert found.normal_velocity / FOOT == pytest.approx(3.3739, abs=1e-4)
    assert found.tangential_velocity / FOOT == pytest.approx(-0.7465, abs=1e-4)
    assert found.impact_pressure / PSI == pytest.approx(1.781, abs=1e-3)
    assert found.planing_pressure / PSI == pytest.approx(0.0038, abs=1e-4)


def test_orbit_is_the_motion_of_the_particles_resolved_on_their_surface():
    phase, step = np.linspace(0, 2 * np.pi, 13), 1e-6
    water = orbit(MODEL, phase)
    # y is aft, so the slope towards the bow is minus the derivative by y
    height = -MODEL.amplitude * np.sin(np.stack([phase - step, phase + step]))
    slope = -(height[1] - height[0]) / (2 * step) * MODEL.wavenumber
    assert water.slope == pytest.approx(slope, abs=1e-8)
    up, forward = MODEL.orbital_velocity * np.cos(phase), MODEL.orbital_velocity * np.sin(phase)
    assert water.normal_velocity == pytest.approx(up * np.cos(slope) - forward * np.sin(slope), abs=1e-8)
    assert water.tangential_velocity == pytest.approx(up * np.sin(slope) + forward * np.cos(slope), abs=1e-8)


def test_method_two_of_a_ship_at_rest_on_calm_water_is_method_one():
    flat = RegularWave(amplitude=1e-12, period=2.0)
    second = method_two(flat, 0.3, 1.5, 0.4, np.radians(-6), 1000.0, trim=0.01)
    first = chuang.method_one(1.5, 0.0, 0.4, np.radians(-6), 0.0, 1000.0, trim=0.01)
    assert np.array(second) == pytest.approx(np.array(first), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("phase", [0.0, 0.7, 2.0, 4.0])
def test_methods_differ_by_the_speed_times_the_angle(phase):
    """To first order, whatever the phase; the remainder is of second order in the angles."""
    remainders = []
    for size in (1.0, 0.1):
        wave = RegularWave(amplitude=0.01 * size, period=2.0, speed=2.0)
        pitch, slope = -0.05 * size, float(orbit(wave, phase).slope)
        water = surface_velocity(slope, wave.closing_speed)
        first = chuang.method_one(0.3, water, 0.1, pitch, slope, 1000.0).normal_velocity
        second = method_two(wave, phase, 0.3, 0.1, pitch, 1000.0).normal_velocity
        remainders.append(abs(first - second - closing_difference(2.0, slope, pitch)))
    assert remainders[0] < 1e-2
    assert remainders[1] < 1e-4


def test_method_two_advances_a_bow_down_ship_away_from_the_wave():
    slow, fast = (RegularWave(amplitude=0.05, period=2.0, speed=speed) for speed in (0.0, 1.0))
    down = [method_two(wave, 0.0, 1.0, 0.2, -0.1, 1000.0).normal_velocity for wave in (slow, fast)]
    assert down[1] - down[0] == pytest.approx(np.sin(-0.1), rel=0.02)


@pytest.mark.parametrize(
    "given", [{"amplitude": 0}, {"period": -1}, {"speed": -1}, {"amplitude": 0.4, "period": 1.0}]
)
def test_waves_are_checked(given):
    with pytest.raises(InputError):
        RegularWave(**{"amplitude": 0.1, "period": 2.0, **given})


def test_program_prints_run_9_in_its_formats():
    line = program_cat.cat(1.73, 0.0, 1.97, -9.45, 0.0, 3.41)
    assert line.text() == "  3.727 -0.604  9.4500.126\n0.17518  4.724  3.410"
    assert line.vt < 0 < line.x


def test_program_with_a_k_of_two_digits_before_the_point():
    assert program_cat.fortran(-0.1234, 5, 3) == "-.123"
    assert program_cat.fortran(123.4, 5, 3) == "*****"
    with pytest.raises(InputError, match="cancel"):
        program_cat.cat(0.0, 0.0, 0.0, -5.0, 1.0, 2.0)


@pytest.mark.parametrize("angle", [0.0, 1.0, 2.3, 8.0, 12.0, 19.0, 25.0, 40.0])
def test_program_has_the_k_of_the_package(angle):
    line = program_cat.cat(1.0, 0.0, 0.5, 0.0, angle, 2.0)
    assert line.k == pytest.approx(float(chuang.impact_coefficient(np.radians(angle))), rel=2e-6)


def test_inclined_surface_without_deadrise_is_chuangs_flat_bottom():
    pitch, slope = np.radians([-12.0, -5.0, 3.0]), np.radians([6.0, -2.0, 0.0])
    found = surface_impact(2.0, 1025.0, pitch=pitch, wave_slope=slope, pitch_velocity=0.4)
    flat = chuang.method_one(2.0, 0.0, 0.4, pitch, slope, 1025.0)
    assert found.impact_angle.values == pytest.approx(np.abs(pitch - slope))
    for name, known in zip(PREDICTED, flat, strict=True):
        assert found[name].values == pytest.approx(np.abs(known)), name
    assert warnings_of(found) == (STANDING,)


def test_buttock_counts_as_trim_and_roll_as_its_square():
    raked = surface_impact(2.0, 1025.0, buttock=0.1, pitch=-0.15, wave_slope=0.02)
    level = surface_impact(2.0, 1025.0, pitch=-0.05, wave_slope=0.02)
    assert float(raked.peak_pressure) == pytest.approx(float(level.peak_pressure))
    rolled = surface_impact(2.0, 1025.0, pitch=-0.06, roll=0.08, wave_slope=0.02)
    assert float(rolled.impact_angle) == pytest.approx(np.hypot(0.08, 0.08), rel=2e-3)


def test_deadrise_is_the_impact_angle_of_a_wedge_dropped_on_calm_water():
    found = surface_impact(3.0, 1000.0, deadrise=np.radians(25))
    assert np.degrees(float(found.impact_angle)) == pytest.approx(25)
    assert float(found.normal_velocity) == pytest.approx(3.0)
    known = chuang.impact_pressure(3.0, np.radians(25), 1000.0)
    assert float(found.impact_pressure) == pytest.approx(float(known))


def test_surface_normal_turns_with_its_angles():
    assert surface_normal() == pytest.approx([0, 0, 1])
    assert surface_normal(pitch=0.2) == pytest.approx([-np.sin(0.2), 0, np.cos(0.2)])
    assert surface_normal(roll=0.2) == pytest.approx(surface_normal(deadrise=0.2))
    assert surface_normal(roll=0.2)[1] < 0
    with pytest.raises(InputError, match="face downward"):
        surface_impact(1.0, 1000.0, deadrise=np.radians(85))


def test_froude_scale():
    scale = FroudeScale(ratio=25.0, density_ratio=1.025)
    assert scale.length(2.0) == 50
    assert scale.speed(2.0) == scale.time(2.0) == 10
    assert scale.pressure(2.0) == pytest.approx(51.25)
    assert scale.force(1.0) == pytest.approx(1.025 * 25**3)
    assert scale.acceleration(3.0) == 3
    for name in ("length", "speed", "time", "pressure", "force"):
        assert getattr(scale.inverse, name)(getattr(scale, name)(7.0)) == pytest.approx(7.0)
    # a pressure is that of the scaled velocity
    assert scale.pressure(1000 * 2.0**2) == pytest.approx(1025 * scale.speed(2.0) ** 2)
    assert ASR_21.length(10.91) == pytest.approx(232.2, abs=0.1)
    with pytest.raises(InputError):
        FroudeScale(ratio=0)
