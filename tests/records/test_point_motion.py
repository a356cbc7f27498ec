"""Motion of points by the direct method, against the linear closed form and exact kinematics."""

import numpy as np
import pytest

from workbench import quantities
from workbench.conventions import MODES, from_aft_axes, wave_direction_from_head_zero
from workbench.errors import InputError
from workbench.records.point_motion import (
    point_displacement,
    point_motion,
    point_velocity,
    rate_of,
    water_entries,
)
from workbench.relative_motion import material_velocity, relative_motion
from workbench.slamming.statistics import HOUR
from workbench.time_domain import complex_amplitudes, components_from, record_blocks, records

SPEED, DIRECTION, CENTRE = 8.0, np.radians(150.0), (1.5, 0.0, 2.0)
POINTS = np.array([[30.0, 0.0, 2.5], [10.0, -4.0, 2.0], [-20.0, 4.0, 2.0]])
TIME = np.arange(0, 60, 0.01)


def components(amplitude=1e-3, omega=(0.6, 0.9, 1.2)):
    omega = np.array(omega)
    return components_from(
        omega, np.full(len(omega), amplitude), 0.7 * np.arange(len(omega)), DIRECTION, SPEED
    )


def response(omega):
    """Six motions per wave amplitude, (omega, 6), as any ship might have them."""
    k = omega**2 / 9.80665
    zero = 0 * omega
    return np.stack([zero, zero, 0.9 * np.exp(0.3j * omega), 0.5j * k, -0.8j * k, zero], axis=1)


def history(waves, time=TIME):
    amplitudes = complex_amplitudes(waves)[:, None] * response(waves.component_omega.values)
    series = records(amplitudes, waves.component_frequency.values, time).T
    return quantities.dataset({"time": time, "dof": list(MODES)}, motion=(("time", "dof"), series))


def closed_form(waves):
    """Clearance left and closing velocity of the linear theory, (point, time)."""
    omega = waves.component_omega.values
    motion_set = quantities.dataset(
        {"omega": omega, "wave_direction": [DIRECTION], "dof": list(MODES)},
        attrs={"centre_of_gravity": CENTRE, "speed": SPEED, "density": 1025.0},
        motion_rao=(("omega", "wave_direction", "dof"), response(omega)[:, None]),
        wavenumber=("omega", omega**2 / 9.80665),
        encounter_frequency=(("omega", "wave_direction"), waves.component_frequency.values[:, None]),
    )
    rise, speed = [], []
    for x, y, _ in POINTS:
        deck = quantities.dataset({"x": [x], "y": [y]})
        found = relative_motion(motion_set, deck)
        rise.append(found.relative_motion.values[:, 0, 0, 0])
        speed.append(material_velocity(found).values[:, 0, 0, 0])
    amplitudes = complex_amplitudes(waves)[:, None]
    frequency = waves.component_frequency.values
    return [records(amplitudes * np.stack(part, axis=1), frequency, TIME) for part in (rise, speed)]


def test_small_motions_equal_the_linear_closed_form():
    waves = components()
    found = point_motion(history(waves), waves, POINTS, CENTRE)
    rise, speed = closed_form(waves)
    assert found.clearance_left.values - POINTS[:, 2] == pytest.approx(-rise.T, abs=1e-8)
    assert found.closing_velocity.values == pytest.approx(speed.T, abs=2e-6)
    printed = point_motion(history(waves), waves, POINTS, CENTRE, form="printed")
    assert printed.closing_velocity.values == pytest.approx(speed.T, abs=2e-6)


def test_exact_form_is_the_derivative_and_printed_form_is_not():
    motion = np.zeros((len(TIME), 6))
    motion[:, 4] = 0.5 * np.sin(2.0 * TIME)
    moved = point_displacement(motion, [30.0], [0.0])
    derivative = rate_of(moved, 0.01)
    exact = point_velocity(motion, 0.01, [30.0], [0.0])
    printed = point_velocity(motion, 0.01, [30.0], [0.0], "printed")
    assert exact == pytest.approx(derivative, abs=0.003 * np.abs(derivative).max())
    assert np.abs(printed - derivative).max() > 0.1 * np.abs(derivative).max()
    with pytest.raises(InputError, match="form"):
        point_velocity(motion, 0.01, [30.0], [0.0], "other")


def test_material_velocity_is_the_derivative_following_the_water():
    """4.18 holds (d/dt - U d/dx) of the clearance at points of a rigid, level strip of deck."""
    waves = components(amplitude=0.2)
    around = np.array([[9.99, -4.0, 2.0], [10.0, -4.0, 2.0], [10.01, -4.0, 2.0]])
    found = point_motion(history(waves), waves, around, CENTRE)
    left = found.clearance_left.values
    along = (left[:, 2] - left[:, 0]) / 0.02
    known = rate_of(left[:, 1], 0.01) - SPEED * along
    assert -found.closing_velocity.values[5:-5, 1] == pytest.approx(known[5:-5], abs=2e-3)


def test_differences_are_of_second_order():
    for values, exact in ((TIME**2, 2 * TIME), (np.sin(TIME), np.cos(TIME))):
        assert rate_of(values, 0.01) == pytest.approx(exact, abs=5e-5)
    coarse = rate_of(np.sin(TIME[::2]), 0.02)[0] - 1
    fine = rate_of(np.sin(TIME), 0.01)[0] - 1
    assert coarse / fine == pytest.approx(4.0, rel=0.05)
    with pytest.raises(InputError, match="at least 4"):
        rate_of([1.0, 2.0], 0.1)


def test_axes_of_the_source_give_the_same():
    """The source counts x aft, y to starboard, pitch bow up, heading 0 for head seas."""
    motion = np.random.default_rng(2).normal(0, 0.1, (50, 6))
    ours = point_displacement(motion, 12.0, 3.0)
    theirs = point_displacement(from_aft_axes(motion), -12.0, -3.0)
    assert ours == pytest.approx(theirs)
    beta = wave_direction_from_head_zero(DIRECTION)
    x, y = 12.0, 3.0
    assert x * np.cos(DIRECTION) + y * np.sin(DIRECTION) == pytest.approx(
        -x * np.cos(beta) - -y * np.sin(beta)
    )


def test_steady_elevation_closes_the_gap():
    waves = components()
    plain = point_motion(history(waves), waves, POINTS, CENTRE)
    lifted = point_motion(history(waves), waves, POINTS, CENTRE, steady_elevation=[0.1, 0.2, 0.3])
    assert plain.clearance_left.values - lifted.clearance_left.values == pytest.approx(
        np.broadcast_to([0.1, 0.2, 0.3], (len(TIME), 3))
    )


def test_entries_of_a_regular_wave():
    time = np.arange(0, 100, 0.01)
    left = 0.5 + np.cos(2.0 * time)
    at_points = quantities.dataset(
        {"time": time, "vertex": [0]},
        attrs={"time_step": 0.01},
        clearance_left=(("time", "vertex"), left[:, None]),
        closing_velocity=(("time", "vertex"), (2 * np.sin(2.0 * time))[:, None]),
    )
    found = water_entries(at_points)
    known = (np.arccos(-0.5) + 2 * np.pi * np.arange(32)) / 2
    assert found.event_time.values == pytest.approx(known[known < time[-1]], abs=1e-4)
    assert found.entry_velocity.values == pytest.approx(2 * np.sin(np.arccos(-0.5)), abs=1e-3)
    assert water_entries(at_points, threshold=1.8).sizes["event"] == 0


def test_entries_of_a_random_sea_are_as_many_as_rice_has_it():
    rng = np.random.default_rng(4)
    omega = rng.uniform(0.5, 1.5, 200)
    waves = components_from(omega, 0.1, rng.uniform(0, 2 * np.pi, 200), np.pi, 0.0)
    time = np.arange(0, 3 * HOUR, 0.1)
    blocks = [part for _, part in record_blocks(complex_amplitudes(waves)[:, None], omega, time[-1], 0.1)]
    rise = np.concatenate(blocks, axis=1)[0, : len(time)].astype(float)
    deviation, rate = np.sqrt(200 * 0.005), np.sqrt(np.mean(omega**2))
    at_points = quantities.dataset(
        {"time": time, "vertex": [0]},
        attrs={"time_step": 0.1},
        clearance_left=(("time", "vertex"), (1.5 - rise)[:, None]),
        closing_velocity=(("time", "vertex"), rate_of(rise, 0.1)[:, None]),
    )
    found = water_entries(at_points)
    expected = len(time) * 0.1 * rate / (2 * np.pi) * np.exp(-(1.5**2) / (2 * deviation**2))
    assert found.sizes["event"] == pytest.approx(expected, abs=3 * np.sqrt(expected))
    assert found.entry_velocity.values.mean() == pytest.approx(
        np.sqrt(np.pi / 2) * rate * deviation, rel=0.06
    )


def test_refusals():
    waves = components()
    uneven = history(waves, np.sort(np.random.default_rng(1).uniform(0, 10, 50)))
    with pytest.raises(InputError, match="evenly sampled"):
        point_motion(uneven, waves, POINTS, CENTRE)
    with pytest.raises(InputError, match="x, y and z"):
        point_motion(history(waves), waves, POINTS[:, :2], CENTRE)
