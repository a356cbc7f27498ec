"""Equations 5.1-6.2 of Baggus 2025: which are derivatives of which, which hold in long waves, which is ours."""

import numpy as np
import pytest

from workbench import quantities
from workbench.conventions import MODES
from workbench.relative_motion import relative_motion
from workbench.verification import baggus_relative_motion as source

OMEGAS = (6.5, 9.5, 10.1)
POINTS = (1, 7, 13, 23)


def parts(number, omega):
    return source.table_point(number), source.Wave(0.03, omega), source.table_response(omega)


@pytest.mark.parametrize("reading", source.READINGS)
@pytest.mark.parametrize("omega", OMEGAS)
def test_repaired_velocity_is_the_derivative_and_the_printed_one_is_not(reading, omega):
    point, wave, response = parts(13, omega)
    time, step = np.linspace(0, 1, 101), 1e-5
    ahead, behind = (
        source.relative_distance(point, wave, response, reading, time + sign * step) for sign in (1, -1)
    )
    slope = (ahead - behind) / (2 * step)
    repaired = source.relative_velocity(point, wave, response, reading, time)
    printed = source.relative_velocity(point, wave, response, reading, time, form="printed")
    np.testing.assert_allclose(repaired, slope, atol=1e-8)
    assert np.abs(printed - slope).max() == pytest.approx(2 * 0.03 * omega, rel=0.01)


def test_equation_5_1_is_the_printed_one():
    """Written out as printed, with x_COG for x_O."""
    point, wave, response = parts(23, 9.5)
    time = np.linspace(0, 1, 50)
    k, turn = 9.5**2 / 9.81, 9.5 * time
    printed = (
        0.03 * 0.257 * np.sin(-2.541 - turn)
        + np.tan(np.radians(30 * 0.118)) * -0.377 * np.sin(2.004 - turn)
        - 0.03 * np.sin(k * -0.377 - turn)
        + 0.071
        - 0.0583
    )
    np.testing.assert_allclose(
        source.relative_distance(point, wave, response, "printed", time), printed, atol=1e-12
    )
    mixed = printed + 0.03 * np.sin(k * -0.377 - turn) - 0.03 * np.sin(k * 0.167 - turn)
    np.testing.assert_allclose(
        source.relative_distance(point, wave, response, "mixed", time), mixed, atol=1e-12
    )


@pytest.mark.parametrize("omega", OMEGAS)
@pytest.mark.parametrize("number", POINTS)
def test_head_sea_reading_is_the_relative_motion_of_the_package(omega, number):
    """The same responses given to `workbench.relative_motion`: distance, velocity and angle at every instant."""
    point, wave, response = parts(number, omega)
    rao = np.zeros((1, 1, 6), complex)
    rao[0, 0, 2] = response.heave * np.exp(1j * response.heave_phase)
    rao[0, 0, 4] = response.pitch * np.exp(1j * response.pitch_phase)
    motions = quantities.dataset(
        {"omega": [omega], "wave_direction": [np.pi], "dof": list(MODES)},
        method="table 3.1",
        attrs={"speed": 0.0, "density": 1000.0, "centre_of_gravity": [0.0, 0.0, 0.08]},
        motion_rao=(("omega", "wave_direction", "dof"), rao),
        encounter_frequency=(("omega", "wave_direction"), [[omega]]),
        wavenumber=("omega", [wave.wavenumber]),
    )
    deck = quantities.dataset({"x": [point.x], "y": [point.y]})
    ours = relative_motion(motions, deck).isel(omega=0, wave_direction=0, x=0, y=0)
    time = np.linspace(0, 1, 40)
    turned = np.exp(-1j * omega * time)
    rise, rate = (
        0.03 * np.imag(complex(ours[name]) * turned) for name in ("relative_motion", "relative_velocity")
    )
    theirs = source.distance_amplitude(point, wave, response, "head sea", tangent=False)
    np.testing.assert_allclose(point.gap - rise, point.gap + np.imag(theirs * turned), atol=1e-12)
    np.testing.assert_allclose(-rate, np.imag(-1j * omega * theirs * turned), atol=1e-12)
    # the printed tangent of the pitch amplitude changes 0.1 mm at most
    printed = source.relative_distance(point, wave, response, "head sea", time)
    np.testing.assert_allclose(point.gap - rise, printed, atol=2e-4)
    angle = 0.03 * np.imag(complex(ours.relative_slope) * turned)
    steep = 0.03 * wave.wavenumber  # the printed form takes the arc tangent of the wave's slope
    theirs_angle = source.relative_angle(point, wave, response, "head sea", time)
    np.testing.assert_allclose(-angle, theirs_angle, atol=steep**3 / 3)


@pytest.mark.parametrize(("reading", "left"), [("printed", 0.0), ("head sea", 0.0), ("mixed", 0.544)])
def test_long_waves_leave_the_gap_but_not_in_the_mixed_reading(reading, left):
    """Heave 1, pitch k leading by a quarter: what is left is k times the shift of the origin."""
    wave = source.Wave(0.03, 0.05)
    response = source.Response(1.0, 0.0, wave.wavenumber, np.pi / 2)
    point = source.Point(-0.377, 0.0, 0.098)
    amplitude = source.distance_amplitude(point, wave, response, reading)
    assert abs(amplitude) / (0.03 * wave.wavenumber) == pytest.approx(left, abs=1e-3)


def test_disturbed_wave_of_the_head_sea_is_left_by_the_printed_pitch_term():
    """Capytaine's wave, exp(-i k x), needs pitch term -x: with +x long waves leave 2 k x."""
    wave = source.Wave(0.03, 0.05)
    response = source.Response(1.0, 0.0, wave.wavenumber, np.pi / 2)
    point, time = source.Point(-0.377, 0.0, 0.098), np.linspace(0, 130, 400)
    elevation = np.exp(-1j * wave.wavenumber * point.x)
    for reading, left in (("head sea", 0.0), ("printed", 2 * 0.377)):
        found = source.disturbed_distance(point, [wave], [response], [elevation], reading, time) - point.gap
        assert np.abs(found).max() / (0.03 * wave.wavenumber) == pytest.approx(left, abs=2e-3)


def test_two_waves_are_the_sum_and_their_velocity_the_derivative():
    waves = [source.Wave(0.0175, 9.5), source.Wave(0.0175, 5.0)]
    responses = [source.table_response(9.5), source.table_response(5.0)]
    elevations = [1.3 * np.exp(0.4j), 0.9 * np.exp(-1.1j)]
    point, time, step = source.table_point(13), np.linspace(0, 3, 200), 1e-5
    given = (point, waves, responses, elevations, "printed")
    alone = [
        source.disturbed_distance(point, [w], [r], [e], "printed", time) - point.gap
        for w, r, e in zip(waves, responses, elevations, strict=True)
    ]
    both = source.disturbed_distance(*given, time)
    np.testing.assert_allclose(both, sum(alone) + point.gap)
    slope = (
        source.disturbed_distance(*given, time + step) - source.disturbed_distance(*given, time - step)
    ) / (2 * step)
    np.testing.assert_allclose(source.disturbed_velocity(*given, time), slope, atol=1e-8)
    printed = source.disturbed_distance(*given, time, form="printed")
    motion = both + sum(
        np.imag(0.0175 * e * np.exp(-1j * w.omega * time)) for w, e in zip(waves, elevations, strict=True)
    )
    as_printed = motion - sum(  # phase k x_O, and one frequency for both
        0.0175 * abs(e) * np.sin(w.omega**2 / 9.81 * 0.167 - 9.5 * time)
        for w, e in zip(waves, elevations, strict=True)
    )
    np.testing.assert_allclose(printed, as_printed, atol=1e-12)
    assert np.abs(printed - both).max() > 0.02


def test_undisturbed_elevation_in_the_disturbed_equation_is_the_undisturbed_equation():
    point, wave, response = parts(1, 6.5)
    time = np.linspace(0, 1, 30)
    elevation = np.exp(-1j * wave.wavenumber * point.x)
    np.testing.assert_allclose(
        source.disturbed_distance(point, [wave], [response], [elevation], "head sea", time),
        source.relative_distance(point, wave, response, "head sea", time),
    )
