"""Water of a cross-plane: panel integrals, harmonic continuation, free waves, absorption, impulsive start, symmetry."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from workbench.conventions import GRAVITY
from workbench.hydrodynamics import cross_plane
from workbench.hydrodynamics.cross_plane import Water, passage
from workbench.hydrodynamics.marched_contour import panel_integrals, section_weights
from workbench.verification.cylinder_march import arc, contour_of

OFF_THE_GRID = 1 / 10.5
"""Spacing of the water that puts no point on the waterline of a circle of radius 1 m."""


def pushed(mode=1, steps=1):
    """Normal velocity of a unit push in sway (0), heave (1) or roll (2) over the first steps."""

    def velocity(number, contour):
        return (section_weights(contour)[mode] / contour.lengths)[:, None] * (number < steps)

    return velocity


# --- sources


START, END = np.array([0.3 - 0.4j, -1.0 - 0.2j]), np.array([0.9 - 0.1j, -0.8 - 1.3j])
POINTS = np.array([0.1 - 0.9j, 1.5 + 0.0j, -0.85 - 0.5j, 2.0 - 3.0j])


def test_panel_integrals_are_those_of_quadrature():
    potential, velocity = panel_integrals(POINTS, START, END)
    for row, point in enumerate(POINTS):
        for column, (start, end) in enumerate(zip(START, END, strict=True)):
            length = abs(end - start)

            def to_point(s, start=start, end=end, point=point, length=length):
                return point - (start + s / length * (end - start))

            known = quad(lambda s: np.log(abs(to_point(s))), 0, length)[0]
            across = quad(lambda s: (1 / to_point(s)).real, 0, length)[0]
            up = -quad(lambda s: (1 / to_point(s)).imag, 0, length)[0]
            assert potential[row, column] == pytest.approx(known, abs=1e-9)
            assert velocity[row, column] == pytest.approx(across - 1j * up, abs=1e-9)


def test_panels_in_one_line_do_not_see_each_other():
    """Flat sides, at any slope: the normal velocity on one panel from the next is nothing."""
    for slope in np.linspace(-3.0, 3.0, 200):
        nodes = 0.37 + np.exp(1j * slope) * np.linspace(0.3, 2.1, 7)
        along = np.exp(1j * slope)
        _, velocity = panel_integrals((nodes[1:] + nodes[:-1]) / 2, nodes[:-1], nodes[1:])
        across = (velocity * -1j * along).real
        np.fill_diagonal(across, 0.0)
        np.testing.assert_allclose(across, 0.0, atol=1e-9)


def test_velocity_is_the_gradient_of_the_potential():
    step = 1e-6
    _, velocity = panel_integrals(POINTS, START, END)
    for direction, component in ((1.0, velocity.real), (1j, -velocity.imag)):
        ahead, behind = (panel_integrals(POINTS + side * step * direction, START, END)[0] for side in (1, -1))
        np.testing.assert_allclose((ahead - behind) / (2 * step), component, atol=1e-8)


def test_potential_of_a_panel_at_its_own_centre():
    potential, _ = panel_integrals((START + END) / 2, START, END)
    length = np.abs(END - START)
    np.testing.assert_allclose(np.diag(potential), length * (np.log(length / 2) - 1), rtol=1e-12)


def test_a_panel_lets_out_two_pi_of_water_half_on_each_side():
    contour = contour_of(arc(panels=8))
    points, normals = contour.centres, contour.normals
    just_off = points + 1e-9 * normals
    _, own = contour.influence(points, 0, on_panels=True)
    _, velocity = panel_integrals(just_off, contour.starts, contour.ends)
    _, images = panel_integrals(just_off, contour.ends.conj(), contour.starts.conj())
    np.testing.assert_allclose(
        (own * normals[:, None]).real, ((velocity - images) * normals[:, None]).real, atol=1e-6
    )


def test_normals_point_into_the_water():
    contour = contour_of(arc(panels=40))
    np.testing.assert_allclose(contour.normals, contour.centres / np.abs(contour.centres), atol=1e-9)
    assert section_weights(contour)[1].sum() == pytest.approx(-2.0)


def test_sources_vanish_on_the_water_and_have_the_parity_of_the_motion():
    y = np.array([-3.5, -0.3, 0.2, 0.8, 4.0])
    for parity in (0, 1, -1):
        on_water, velocity = contour_of(arc(2.0, panels=12)).influence(y + 0j, parity, on_panels=False)
        np.testing.assert_allclose(on_water, 0.0, atol=1e-12)
        np.testing.assert_allclose(velocity.real, 0.0, atol=1e-12)  # the water moves up and down only
    near, mirrored = (
        np.array([0.6 - 0.7j, 3.1 - 0.2j, 1.5 - 2j]),
        np.array([-0.6 - 0.7j, -3.1 - 0.2j, -1.5 - 2j]),
    )
    for parity in (1, -1):
        here, there = (
            contour_of(arc(2.0, panels=12)).influence(points, parity, on_panels=False)[0]
            for points in (near, mirrored)
        )
        np.testing.assert_allclose(there, parity * here, rtol=1e-9)


# --- water


@pytest.mark.parametrize("parity", [1, -1, 0])
def test_continuation_of_a_wave_is_exact(parity):
    water = Water(7.0, 0.2, parity)
    points = np.array([0.3 - 0.5j, 2.1 - 1.7j, 6.0 - 0.05j, 1.0 - 4.0j])
    normals = np.exp(1j * np.array([0.4, -1.1, 2.5, 3.0]))
    potential, normal_velocity = water.continuation(points, normals)
    assert water.y[0] == (0.0 if parity else -7.0)
    shapes = {1: [0], -1: [1], 0: [0, 1]}[parity]
    for number in (1, 5, 20):
        k = np.pi / 7.0 * number
        for sine in shapes:
            wave = np.sin if sine else np.cos
            values = wave(k * water.y)
            slope = np.cos(k * points.real) if sine else -np.sin(k * points.real)
            decay = np.exp(k * points.imag)
            np.testing.assert_allclose(potential @ values, decay * wave(k * points.real), atol=1e-12)
            known = k * decay * (normals.real * slope + normals.imag * wave(k * points.real))
            np.testing.assert_allclose(normal_velocity @ values, known, atol=1e-11)
            np.testing.assert_allclose(water.vertical_velocity @ values, k * values, atol=1e-10)


def test_mean_level_has_no_vertical_velocity():
    for parity in (1, 0):
        water = Water(5.0, 0.25, parity)
        np.testing.assert_allclose(water.vertical_velocity @ np.ones(len(water.y)), 0.0, atol=1e-10)


@pytest.mark.parametrize(("parity", "mode"), [(1, 1), (-1, 0), (0, 1)])
def test_free_waves_keep_their_dispersion(parity, mode):
    """After one push the hull is gone, and every wave oscillates with omega^2 = g k (as leapfrog steps see it)."""
    water = Water(60.0, 0.2, parity)
    dt, steps = 0.02, 240
    contours = [contour_of(arc())] if parity == 0 else [contour_of(arc(panels=12, half=True))]
    found = passage([*contours, *[None] * steps], dt, water, pushed(mode), 1, field_y=water.y).elevation
    field = found[..., 0].real
    for number in (20, 40, 70):
        k = np.pi / 60.0 * number
        shape = np.sin(k * water.y) if parity < 0 else np.cos(k * water.y)
        if parity > 0:
            shape[[0, -1]] /= 2
        amplitude = (field @ shape)[1:]
        turn = np.sum(amplitude[1:-1] * (amplitude[2:] + amplitude[:-2])) / np.sum(amplitude[1:-1] ** 2)
        omega = 2 / dt * np.sin(np.arccos(turn / 2) / 2)
        assert omega == pytest.approx(np.sqrt(GRAVITY * k), rel=3e-3)


def burst(half_width, points, ka=1.0, dt=0.06):
    """Elevation at points [m] during and after twelve seconds of heave at one frequency, growing and fading."""
    omega = np.sqrt(GRAVITY * ka)

    def heaving(number, contour):
        window = np.sin(np.pi * min(number * dt / 12.0, 1.0)) ** 2
        return pushed()(0, contour) * window * np.cos(omega * number * dt)

    water = Water(half_width, OFF_THE_GRID, 1)
    contours = [contour_of(arc(half=True))] * 600
    return passage(contours, dt, water, heaving, 1, field_y=points).elevation[..., 0].real


NEAR = np.linspace(1.5, 12.0, 40)


@pytest.fixture(scope="module")
def in_wide_water():
    return burst(80.0, NEAR)


def test_waves_leave_over_the_beach_without_coming_back(in_wide_water):
    """A wave of 6 m over a beach of 6 m."""
    came_back = burst(20.0, NEAR) - in_wide_water
    assert np.abs(in_wide_water[-150:]).max() < 0.02 * np.abs(in_wide_water).max()
    assert np.sum(came_back**2) < 0.02 * np.sum(in_wide_water**2)


def test_without_a_beach_they_would_come_back(in_wide_water, monkeypatch):
    monkeypatch.setattr(Water, "absorption", lambda self, time_step: np.ones((len(self.y), 1)))
    came_back = burst(20.0, NEAR) - in_wide_water
    assert np.sum(came_back**2) > 0.3 * np.sum(in_wide_water**2)


def test_mirror_of_the_beach_is_on_both_sides():
    whole, half = Water(15.0, 0.1, 0), Water(15.0, 0.1, 1)
    fading = whole.absorption(0.1)[:, 0]
    np.testing.assert_allclose(fading[1:], fading[:0:-1])
    np.testing.assert_allclose(fading[len(fading) // 2 :], half.absorption(0.1)[:-1, 0])
    share = 1 - cross_plane.BEACH_SHARE
    assert np.all(fading[np.abs(whole.y) < share * 15.0 - 0.1] == 1.0)


# --- a hull in the water


@pytest.mark.parametrize(
    ("mode", "known"), [(1, np.pi / 2), (0, np.pi / 2 * 4 / np.pi**2)], ids=["heave", "sway"]
)
def test_impulsive_start_has_the_added_mass_of_infinite_frequency(mode, known):
    """Half circle of radius a: rho pi a^2/2 in heave, 4/pi^2 of that in sway."""
    parity = 1 if mode == 1 else -1
    for water, contour in (
        (Water(10.0, 0.11, parity), contour_of(arc(panels=60, half=True))),
        (Water(10.0, 0.11, 0), contour_of(arc(panels=120))),
    ):
        start = passage([contour], 0.01, water, pushed(mode), 1).section_potential[0, 0, :, 0]
        assert -start[mode].real == pytest.approx(known, rel=0.01)
        assert abs(start[1 - mode]) < 1e-9


def test_march_of_halves_is_that_of_the_whole_plane():
    """Heave in the even march and sway and roll in the odd one, a hull alone and a twin."""
    dt, steps = 0.05, 60
    field_y = np.array([-4.1, -1.7, 0.4, 3.3])
    for halves, whole in (
        ([arc(panels=12, half=True)], [arc(panels=24)]),
        ([arc(2.5, panels=16)], [arc(-2.5, panels=16), arc(2.5, panels=16)]),
        ([arc(2.5, panels=16), arc(panels=8, half=True)], [arc(-2.5, panels=16), arc(panels=16), arc(2.5, panels=16)]),
    ):  # fmt: skip
        for mode, parity in ((1, 1), (0, -1), (2, -1))[: 2 if len(whole) == 1 else 3]:
            half = passage(
                [contour_of(*halves)] * steps, dt, Water(15.0, OFF_THE_GRID, parity), pushed(mode, 40), 1,
                families=len(halves), field_y=field_y,
            )  # fmt: skip
            full = passage(
                [contour_of(*whole)] * steps, dt, Water(15.0, OFF_THE_GRID, 0), pushed(mode, 40), 1,
                families=len(whole), field_y=field_y,
            )  # fmt: skip
            together = full.section_potential.sum(axis=1)
            scale = np.abs(together).max()
            np.testing.assert_allclose(half.section_potential.sum(axis=1), together, atol=1e-5 * scale)
            np.testing.assert_allclose(
                half.elevation, full.elevation, atol=1e-5 * np.abs(full.elevation).max()
            )


def test_families_share_the_force():
    """Unequal hulls: the potentials of the families add up to that of one family of all panels."""
    contour = contour_of(arc(-3.0), 0.6 * arc(4.0))
    water = Water(15.0, OFF_THE_GRID, 0)
    apart = passage([contour] * 20, 0.05, water, pushed(), 1, families=2).section_potential
    one = replace(contour, family=np.zeros_like(contour.family))
    joint = passage([one] * 20, 0.05, water, pushed(), 1).section_potential
    np.testing.assert_allclose(apart.sum(axis=1), joint[:, 0], rtol=1e-12)
    assert abs(apart[-1, 0, 1, 0]) > 1.2 * abs(apart[-1, 1, 1, 0]) > 0.0


def test_dry_stations_leave_the_water_alone():
    contour = contour_of(arc(panels=12, half=True))
    water = Water(12.0, OFF_THE_GRID, 1)
    found = passage([None, None, contour], 0.05, water, lambda n, c: pushed()(0, c), 1, field_y=[3.0])
    at_once = passage([contour], 0.05, water, pushed(), 1)
    np.testing.assert_array_equal(found.section_potential[:2], 0.0)
    np.testing.assert_array_equal(found.elevation[:2], 0.0)
    np.testing.assert_allclose(found.section_potential[2], at_once.section_potential[0])


def test_columns_do_not_mix():
    contour = contour_of(arc(panels=12, half=True))
    water = Water(12.0, OFF_THE_GRID, 1)

    def two(number, section):
        one = pushed(1, 50)(number, section)
        return np.concatenate([one, 2j * one * np.cos(number)], axis=1)

    both = passage([contour] * 30, 0.05, water, two, 2).section_potential
    first = passage([contour] * 30, 0.05, water, lambda n, c: two(n, c)[:, :1], 1).section_potential
    second = passage([contour] * 30, 0.05, water, lambda n, c: two(n, c)[:, 1:], 1).section_potential
    np.testing.assert_allclose(both, np.concatenate([first, second], axis=-1), rtol=1e-10, atol=1e-12)


def test_water_begins_to_rise_in_step():
    """A steady push in still water: elevations go as the time, which the staggered steps begin by half a step."""
    water = Water(12.0, OFF_THE_GRID, 1)
    contour = contour_of(arc(panels=12, half=True))
    rise = passage([contour] * 3, 1e-4, water, pushed(1, 9), 1, field_y=[2.0]).elevation[:, 0, 0].real
    assert rise[2] / rise[1] == pytest.approx(2.0, rel=1e-3)
