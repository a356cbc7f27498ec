"""Pressure over the deck in time: impulses, edges, exits, records and their bad cases."""

import dataclasses

import numpy as np
import pytest

from tests.wet_deck_pressure.strips_of_water import RHO, crest, flat_deck, moved
from workbench.conventions import GRAVITY
from workbench.damping.lifting_surfaces import plate_added_mass
from workbench.errors import InputError
from workbench.wet_deck_pressure.deck_motion import DeckMotion, motion_of_amplitudes, motion_of_records
from workbench.wet_deck_pressure.deck_pressure import history, slams_of_record
from workbench.wet_deck_pressure.settings import ATMOSPHERE, DeckPressureSettings
from workbench.wet_deck_pressure.strips import deck_strips

CURVATURE, VELOCITY, CELERITY = 0.02, 3.0, 5.0


def without_weight(found, motion, strips):
    """Force less buoyancy of the deck, the mean over each step's ends [N]."""
    ends = np.concatenate([[found.time.values[0]], found.time.values]) + found.attrs["time_step"] / 2
    ends[0] = found.time.values[0] - found.attrs["time_step"] / 2
    depth = np.maximum(strips.by_strip(motion.at(ends)[0]) - strips.mean, 0)
    weight = RHO * GRAVITY * strips.panel_area * depth.sum(axis=(1, 2))
    return found.deck_force.values - (weight[1:] + weight[:-1]) / 2


def impulse(step, points=(40, 2), settings=None, until=0.3, speed=0.0, celerity=CELERITY):
    wet_deck, grid = flat_deck(points=points)
    motion, strips = moved(
        *crest(CURVATURE, VELOCITY, celerity, speed, start=0.0513), wet_deck, grid, 0.5, speed=speed
    )
    settings = dataclasses.replace(settings or DeckPressureSettings(suction=ATMOSPHERE), time_step=step)
    found = history(motion, strips, RHO, settings, 0.0, 0.0513 + until)
    return float(np.sum(without_weight(found, motion, strips)) * found.attrs["time_step"]), found


@pytest.mark.parametrize("speed", [0.0, 8.0])
def test_impulse_of_a_travelling_crest_for_any_step_and_panel(speed):
    """rho pi/2 l**2 V a strip: within 1 % for steps from 2 to 25 ms and panels from 1.5 to 6 m."""
    expected = RHO * np.pi / 2 * 4 * VELOCITY * 0.3 / CURVATURE * VELOCITY * 4.0
    for step, points in ((0.002, (40, 2)), (0.025, (40, 2)), (0.005, (10, 2)), (0.005, (40, 7))):
        found, _ = impulse(step, points, speed=speed)
        assert found == pytest.approx(expected, rel=0.01)


def test_force_of_a_travelling_crest_at_every_step():
    _, found = impulse(0.005)
    wet_deck, grid = flat_deck()
    motion, strips = moved(*crest(CURVATURE, VELOCITY, CELERITY, start=0.0513), wet_deck, grid, 0.5)
    later = found.time.values > 0.06
    expected = 2 * np.pi * RHO * VELOCITY**2 / CURVATURE * 4.0
    np.testing.assert_allclose(without_weight(found, motion, strips)[later], expected, rtol=0.01)
    centre = found.deck_force_x.values[later]
    assert np.all(np.diff(centre) < 0)  # it runs aft with the crest


def test_a_flat_deck_that_meets_flat_water_gets_the_impulse_of_its_added_mass_at_once():
    wet_deck, grid = flat_deck()
    motion, strips = moved(
        lambda t, x, y: 3.0 * (t - 0.103) + 0 * (x + y),
        lambda t, x, y: 3.0 + 0 * (t + x + y),
        lambda t, x, y: 0 * (t + x + y),
        wet_deck,
        grid,
        0.4,
    )
    for step in (0.002, 0.01):
        found = history(motion, strips, RHO, DeckPressureSettings(time_step=step), 0.0, 0.2)
        force = without_weight(found, motion, strips)
        assert np.sum(force) * found.attrs["time_step"] == pytest.approx(
            RHO * np.pi / 2 * 30**2 * 3.0 * 4.0, rel=1e-6
        )
        assert np.count_nonzero(np.abs(force) > 1e-6 * force.max()) == 1


@pytest.mark.parametrize("degrees", [10.0, 20.0])
def test_a_pod_cut_across_is_wagners_wedge(degrees):
    slope = np.tan(np.radians(degrees))
    wet_deck, grid = flat_deck(
        length=4.0, width=10.0, clearance=3.0, points=(4, 40), vee_depth=5 * slope, vee_width=10.0
    )
    motion, strips = moved(
        lambda t, x, y: 2.0 * t - 5 * slope + 0 * (x + y),
        lambda t, x, y: 2.0 + 0 * (t + x + y),
        lambda t, x, y: 0 * (t + x + y),
        wet_deck,
        grid,
        0.3,
    )
    assert strips.direction == "across"
    found = history(motion, strips, RHO, DeckPressureSettings(time_step=0.005), 0.0, 0.2)
    force = without_weight(found, motion, strips) / 4.0
    expected = np.pi**3 / (4 * slope**2) * RHO * 2.0**3 * found.time.values
    np.testing.assert_allclose(force[8:], expected[8:], rtol=0.01)
    assert np.sum(force) * 0.005 == pytest.approx(np.pi**3 / (8 * slope**2) * RHO * 2.0**3 * 0.2**2, rel=0.01)
    np.testing.assert_allclose(
        found.wetted_area.values[8:], 4 * np.pi / slope * 2.0 * found.time.values[8:], rtol=0.01
    )


def test_two_parts_that_close_upon_each_other_give_no_spike():
    """The jump of the impulse at the closing would be a pressure as high as the step is short."""
    wet_deck, grid = flat_deck()
    place, wavelength = 2 * np.pi / 12.0, 12.0

    def rise(t, x, y):
        return (
            2.0 * (t - 0.1) - 0.15 + 0.15 * np.cos(place * (np.abs(x) - wavelength / 2)) - 0.01 * x**2 + 0 * y
        )

    motion, strips = moved(
        rise, lambda t, x, y: 2.0 + 0 * (t + x + y), lambda t, x, y: 0 * (t + x + y), wet_deck, grid, 0.5
    )
    peaks = []
    for step in (0.01, 0.0025, 0.000625):
        found = history(motion, strips, RHO, DeckPressureSettings(time_step=step), 0.05, 0.45)
        peaks.append(float(found.deck_force.max()))
    assert peaks[2] < 1.6 * peaks[1] < 2.6 * peaks[0]


def test_water_over_the_fore_end_pushes_with_the_growth_of_its_length():
    """L = 4 V t/(3 g): F = rho pi/4 V L L' a strip."""
    gradient = 0.1
    wet_deck, grid = flat_deck()
    motion, strips = moved(
        lambda t, x, y: VELOCITY * t - gradient * (30 - x) + 0 * y,
        lambda t, x, y: VELOCITY + 0 * (t + x + y),
        lambda t, x, y: 0 * (t + x + y),
        wet_deck,
        grid,
        0.8,
    )
    found = history(motion, strips, RHO, DeckPressureSettings(time_step=0.005), 0.0, 0.7)
    growth = 4 * VELOCITY / (3 * gradient)
    expected = RHO * np.pi / 4 * VELOCITY * growth**2 * found.time.values * 4.0
    np.testing.assert_allclose(without_weight(found, motion, strips)[20:], expected[20:], rtol=0.01)


def test_deep_water_over_a_still_deck_is_buoyancy_alone():
    wet_deck, grid = flat_deck()
    motion, strips = moved(
        *(lambda t, x, y, v=v: v + 0 * (t + x + y) for v in (0.7, 0.0, 0.0)), wet_deck, grid, 0.5
    )
    found = history(motion, strips, RHO, DeckPressureSettings(), 0.1, 0.3)
    np.testing.assert_allclose(found.deck_pressure, RHO * GRAVITY * 0.7, rtol=1e-9)


def receding(suction):
    wet_deck, grid = flat_deck()
    motion, strips = moved(*crest(CURVATURE, -VELOCITY, 0.0, start=0.3), wet_deck, grid, 0.5)
    return history(motion, strips, RHO, DeckPressureSettings(suction=suction, time_step=0.005), 0.0, 0.45)


def test_water_that_leaves_gives_no_suction_spike():
    for suction in (0.0, ATMOSPHERE):
        found = receding(suction)
        assert float(found.deck_pressure.min()) >= 0
        assert float(found.deck_force[-1]) == 0


def test_level_water_that_falls_off_a_flat_deck_lets_go_without_a_pull():
    wet_deck, grid = flat_deck()
    motion, strips = moved(
        lambda t, x, y: 2.0 * (0.203 - t) + 0 * (x + y),
        lambda t, x, y: -2.0 + 0 * (t + x + y),
        lambda t, x, y: 0 * (t + x + y),
        wet_deck,
        grid,
        0.5,
    )
    found = history(motion, strips, RHO, DeckPressureSettings(suction=ATMOSPHERE, time_step=0.005), 0.1, 0.3)
    np.testing.assert_allclose(without_weight(found, motion, strips), 0.0, atol=1.0)


def test_a_deck_that_rises_forward_closes_on_still_water_as_it_advances():
    """W = U g all along; the fore end runs at U: rho pi l U W/2 a strip, l half of 4 d/(3 g)."""
    rise, speed, depth = 1.5, 8.0, 0.3
    gradient = rise / 60.0
    wet_deck, grid = flat_deck(entry_length=60.0, entry_rise=rise)
    motion, strips = moved(
        *(lambda t, x, y, v=v: v + 0 * (t + x + y) for v in (depth, 0, 0)), wet_deck, grid, 0.5, speed=speed
    )
    found = history(motion, strips, RHO, DeckPressureSettings(), 0.2, 0.3)
    half = 2 * depth / (3 * gradient)
    expected = RHO * np.pi * half * speed * speed * gradient / 2 * 4.0
    np.testing.assert_allclose(without_weight(found, motion, strips), expected, rtol=0.02)


def rising(depth, acceleration):
    """Level water over the whole deck, at rest at first."""
    return (
        lambda t, x, y: depth + acceleration * t**2 / 2 + 0 * (x + y),
        lambda t, x, y: acceleration * t + 0 * (x + y),
        lambda t, x, y: acceleration + 0 * (t + x + y),
    )


def test_suction_is_borne_up_to_its_limit():
    wet_deck, grid = flat_deck()
    motion, strips = moved(*rising(0.5, -8.0), wet_deck, grid, 0.5)
    lowest = {
        suction: float(
            history(motion, strips, RHO, DeckPressureSettings(suction=suction), 0.1, 0.3).deck_pressure.min()
        )
        for suction in (0.0, 2e4, ATMOSPHERE)
    }
    assert lowest[0.0] == 0.0
    assert lowest[2e4] == -2e4
    assert lowest[ATMOSPHERE] == -ATMOSPHERE


def test_finite_width_takes_the_added_mass_of_a_plate():
    wet_deck, grid = flat_deck()
    motion, strips = moved(*rising(0.5, 5.0), wet_deck, grid, 0.5)
    forces = [
        history(motion, strips, RHO, DeckPressureSettings(reduction=name), 0.1, 0.3)
        for name in ("none", "pabst")
    ]
    none, pabst = (float(without_weight(found, motion, strips)[0]) for found in forces)
    assert none == pytest.approx(RHO * np.pi / 2 * 30**2 * 4 * 5.0, rel=1e-6)
    assert pabst == pytest.approx(plate_added_mass(60.0, 4.0, RHO) / 2 * 5.0, rel=1e-6)  # water on one side


def spectrum(seed=2, components=40):
    rng = np.random.default_rng(seed)
    omega = np.linspace(0.6, 1.4, components)
    met = omega + 12.0 * omega**2 / GRAVITY
    wet_deck, grid = flat_deck(length=50, clearance=2.0, points=(30, 3))
    k = omega**2 / GRAVITY
    amplitude = 0.22 * np.exp(1j * rng.uniform(0, 2 * np.pi, components))
    phase = np.exp(-1j * k[:, None] * grid.x.values)[..., None] * np.ones(3)
    rise = amplitude[:, None, None] * phase
    return wet_deck, grid, rise, -1j * k[:, None, None] * rise, met


def record(duration=240.0, step=0.05, frame="material", start=0.0):
    wet_deck, grid, rise, slope, met = spectrum()
    motion = motion_of_amplitudes(
        rise, slope, met, grid.x.values, grid.y.values, duration=duration, time_step=step, speed=12.0, frame=frame,
        start=start,
    )  # fmt: skip
    return motion, deck_strips(wet_deck, grid)


def test_motion_of_amplitudes_follows_the_water_particle():
    """Past the ship the wave runs at c + U; against the particle it moves with its own frequency."""
    motion, _ = record(20.0)
    gap, _ = record(20.0, frame="time-derivative")
    _, _, rise, slope, met = spectrum()
    omega = met - 12.0 * np.abs(slope[:, 0, 0] / rise[:, 0, 0])
    phase = np.exp(-1j * met * 7.3)[:, None, None]
    times = np.array([7.3])
    for found, rate in ((motion, omega), (gap, met)):
        r, w, a = found.at(times)
        factor = -1j * rate[:, None, None]
        np.testing.assert_allclose(r[0], (rise * phase).sum(axis=0).real, atol=2e-4)
        np.testing.assert_allclose(w[0], (factor * rise * phase).sum(axis=0).real, atol=2e-3)
        np.testing.assert_allclose(a[0], (factor**2 * rise * phase).sum(axis=0).real, atol=1e-2)


def test_a_record_later_in_time_continues_the_same_sea():
    late, _ = record(10.0, start=20.0)
    whole, _ = record(31.0)
    times = np.array([22.03, 27.7])
    for a, b in zip(late.at(times), whole.at(times), strict=True):
        np.testing.assert_allclose(a, b, atol=5e-4)


def test_motion_of_sampled_records_is_that_of_their_spectrum():
    motion, _ = record(40.0)
    sampled = motion_of_records(motion.rise, motion.x, motion.y, motion.time_step, speed=12.0)
    np.testing.assert_allclose(
        sampled.velocity[5:-5, 2:-2], motion.velocity[5:-5, 2:-2], atol=0.01 * np.abs(motion.velocity).max()
    )
    np.testing.assert_allclose(
        sampled.acceleration[5:-5, 2:-2],
        motion.acceleration[5:-5, 2:-2],
        atol=0.03 * np.abs(motion.acceleration).max(),
    )


@pytest.fixture(scope="module")
def slams():
    motion, strips = record()
    return motion, strips, slams_of_record(motion, strips, RHO, DeckPressureSettings(), gap=1.0)


def test_slams_of_a_record_are_the_histories_of_their_stretches(slams):
    motion, strips, found = slams
    assert found.sizes["slam"] > 8
    index = int(np.argmax(found.slam_force.values))
    start, length = float(found.slam_start[index]), float(found.slam_duration[index])
    one = history(motion, strips, RHO, DeckPressureSettings(), start, start + length)
    assert float(found.slam_force[index]) == pytest.approx(float(one.deck_force.max()), rel=1e-6)
    np.testing.assert_allclose(
        found.slam_panel_pressure[index], one.deck_pressure.max("time"), rtol=1e-5, atol=1
    )
    lifted = float(np.maximum(one.deck_force, 0).sum()) * one.attrs["time_step"]
    assert float(found.slam_impulse[index]) == pytest.approx(lifted, rel=1e-6)
    at = int(np.argmax(one.deck_force.values))
    assert float(found.slam_force_x[index]) == pytest.approx(float(one.deck_force_x[at]))


def test_envelope_force_and_blocks_belong_to_the_slams(slams):
    motion, _, found = slams
    np.testing.assert_array_equal(found.pressure_envelope, found.slam_panel_pressure.max("slam"))
    total = float(np.sum(found.deck_force) * motion.time_step)
    assert total == pytest.approx(float(found.slam_impulse.sum()), rel=1e-6)
    assert np.all(np.diff(found.block_pressure) <= 1e-6)  # a larger block has no larger average
    assert float(found.block_pressure[0]) == pytest.approx(float(found.slam_pressure.max()), rel=1e-6)
    whole = float(found.slam_force.max()) / float(found.block_area[-1])
    assert float(found.block_pressure[-1]) == pytest.approx(whole, rel=1e-6)
    assert float(found.block_area[-1]) == pytest.approx(50 * 4.0)


def test_impulses_of_a_record_do_not_depend_on_the_step(slams):
    motion, strips, found = slams
    finer = slams_of_record(motion, strips, RHO, DeckPressureSettings(time_step=0.0025), gap=1.0)
    assert float(finer.slam_impulse.sum()) == pytest.approx(float(found.slam_impulse.sum()), rel=0.01)


def test_a_slam_at_the_edge_of_the_record_is_marked():
    wet_deck, grid = flat_deck()
    motion, strips = moved(*crest(CURVATURE, VELOCITY, CELERITY, start=0.3), wet_deck, grid, 0.5)
    cut = slams_of_record(motion, strips, RHO, DeckPressureSettings(), gap=0.1)
    assert list(cut.slam_is_whole.values) == [0]
    falling, strips = moved(*crest(CURVATURE, -VELOCITY, CELERITY, start=0.3), wet_deck, grid, 0.5)
    assert list(
        slams_of_record(falling, strips, RHO, DeckPressureSettings(), gap=0.1).slam_is_whole.values
    ) == [0]


def test_contacts_are_one_slam_where_the_deck_is_dry_no_longer_than_the_gap():
    wet_deck, grid = flat_deck()
    level = (
        lambda t, x, y: 0.2 * np.sin(2 * np.pi * t / 1.2) + 0 * (x + y),
        lambda t, x, y: 0.2 * 2 * np.pi / 1.2 * np.cos(2 * np.pi * t / 1.2) + 0 * (x + y),
        lambda t, x, y: -0.2 * (2 * np.pi / 1.2) ** 2 * np.sin(2 * np.pi * t / 1.2) + 0 * (x + y),
    )
    motion, strips = moved(*level, wet_deck, grid, 3.5)  # dry for 0.6 s between contacts
    for gap, count in ((0.5, 3), (0.7, 1)):
        assert slams_of_record(motion, strips, RHO, DeckPressureSettings(), gap=gap).sizes["slam"] == count


def test_a_dry_record_has_no_slams():
    wet_deck, grid = flat_deck()
    motion, strips = moved(
        *(lambda t, x, y, v=v: v + 0 * (t + x + y) for v in (-0.5, 0.0, 0.0)), wet_deck, grid, 0.5
    )
    found = slams_of_record(motion, strips, RHO, DeckPressureSettings(), gap=0.1)
    assert found.sizes["slam"] == 0
    assert float(found.pressure_envelope.max()) == 0
    assert float(np.abs(found.deck_force).max()) == 0


@pytest.mark.parametrize(
    ("action", "words"),
    [
        (lambda: DeckPressureSettings(direction="sideways"), "direction of the strips must be one of"),
        (lambda: DeckPressureSettings(frame="ship"), "frame of the closing velocity"),
        (lambda: DeckPressureSettings(suction=2e5), "suction must be a finite number >= 0 and <= 101325 Pa"),
        (lambda: DeckPressureSettings(time_step=0.0), "time step of the pressures"),
        (lambda: DeckPressureSettings(reduction="meyerhoff"), "reduction for the width"),
        (lambda: motion_of_records(np.zeros((5, 2, 2)), np.zeros(2), np.zeros(2), 0.1), "at least 8 times"),
        (
            lambda: motion_of_records(np.full((9, 2, 1), np.nan), np.array([0.0, 1.0]), np.zeros(1), 0.1),
            "gaps or values that are no numbers",
        ),
    ],
)
def test_refusals_are_one_sentence(action, words):
    with pytest.raises(InputError, match=words):
        action()


def test_a_history_must_lie_within_the_record():
    motion, strips = record(5.0)
    with pytest.raises(InputError, match="end of the pressure history"):
        history(motion, strips, RHO, DeckPressureSettings(), 1.0, 9.0)


def test_steps_of_a_record_are_not_longer_than_its_own():
    motion, strips = record(5.0)
    with pytest.raises(InputError, match=r"time step of the pressures must be .* <= 0.05 s, got 0.2 s"):
        slams_of_record(motion, strips, RHO, DeckPressureSettings(time_step=0.2), gap=1.0)


def test_squared_velocity_takes_from_the_pressure_and_never_below_nothing():
    wet_deck, grid = flat_deck()
    motion, strips = moved(*crest(CURVATURE, VELOCITY, CELERITY, start=0.05), wet_deck, grid, 0.5)
    plain, less = (
        history(motion, strips, RHO, DeckPressureSettings(pressure=name), 0.0, 0.3)
        for name in ("wagner", "logvinovich")
    )
    assert np.all(less.deck_pressure.values <= plain.deck_pressure.values + 1e-6)
    assert float(less.deck_pressure.min()) >= 0
    ratio = float(less.deck_force.sum() / plain.deck_force.sum())
    assert 0.7 < ratio < 0.99


def test_a_deck_of_one_panel_works():
    wet_deck, grid = flat_deck(points=(1, 1))
    fields = np.zeros((20, 1, 1)) + np.linspace(1.5, 2.5, 20)[:, None, None]
    motion = DeckMotion(
        grid.x.values, grid.y.values, 0.05, fields, np.ones_like(fields), np.zeros_like(fields)
    )
    found = slams_of_record(motion, deck_strips(wet_deck, grid), RHO, DeckPressureSettings(), gap=0.1)
    assert found.sizes["slam"] == 1
    assert float(found.slam_impulse[0]) > RHO * np.pi / 2 * 900 * 4.0 * 0.99
