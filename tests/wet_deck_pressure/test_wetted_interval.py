"""Ends of wetted intervals against closed forms of Wagner's condition."""

import numpy as np
import pytest

from tests.wet_deck_pressure.strips_of_water import crest, profiles_of
from workbench.wet_deck_pressure.strip_profiles import StripProfiles
from workbench.wet_deck_pressure.wetted_interval import wetted_intervals

NODES = np.linspace(-29.25, 29.25, 40)


def still(heights, nodes=NODES, ends=(-30.0, 30.0), table=None):
    """Profiles of given penetrations (row, node) [m], at rest."""
    heights = np.atleast_2d(heights).astype(float)
    table = np.zeros((1, 641)) if table is None else np.atleast_2d(table)
    return StripProfiles(
        nodes,
        heights,
        np.ones_like(heights),
        np.zeros_like(heights),
        *ends,
        table,
        np.zeros(len(heights), int),
    )


@pytest.mark.parametrize("speed", [0.0, 8.0, -4.0])
def test_a_crest_of_constant_curvature_opens_as_the_root_of_four_heights_over_curvature(speed):
    curvature, velocity, celerity = 0.02, 3.0, 5.0
    times = np.linspace(0.002, 0.3, 40)
    found = wetted_intervals(
        profiles_of(*crest(curvature, velocity, celerity, speed), times, NODES, 30.0, speed)
    )
    half = 2 * np.sqrt(velocity * times / curvature)
    centre = -(celerity + speed) * times
    np.testing.assert_allclose(found.aft, centre - half, atol=1e-9)
    np.testing.assert_allclose(found.fore, centre + half, atol=1e-9)
    grows = np.sqrt(velocity / curvature / times)
    np.testing.assert_allclose(found.fore_rate, -celerity + grows, rtol=1e-8)
    np.testing.assert_allclose(found.aft_rate, -celerity - grows, rtol=1e-8)
    assert found.settled.all()


@pytest.mark.parametrize("degrees", [4.0, 10.0, 25.0])
def test_a_wedge_is_wet_over_half_pi_of_what_calm_water_cuts(degrees):
    slope = np.tan(np.radians(degrees))
    places = np.linspace(-30, 30, 641)
    depth = np.array([0.05, 0.3, 1.0])
    found = wetted_intervals(still(np.repeat(depth[:, None], 40, axis=1), table=np.abs(places) * slope))
    np.testing.assert_allclose(found.fore, np.pi * depth / (2 * slope), rtol=2e-3)
    np.testing.assert_allclose(found.aft, -found.fore, rtol=1e-6)


def test_a_slope_of_water_that_comes_over_an_end_is_wet_four_thirds_as_far():
    """h = d - g (b - x) with the fore end b: int h sqrt((b - x)/(x - a)) dx = 0 gives L = 4 d/(3 g)."""
    gradient = 0.1
    depth = np.array([0.1, 0.5, 2.0])
    found = wetted_intervals(still(depth[:, None] - gradient * (30 - NODES)))
    assert found.at_fore.all()
    assert not found.at_aft.any()
    np.testing.assert_allclose(30 - found.aft, 4 * depth / (3 * gradient), rtol=1e-4)
    mirrored = wetted_intervals(still(depth[:, None] - gradient * (NODES + 30)))
    np.testing.assert_allclose(mirrored.fore + 30, 4 * depth / (3 * gradient), rtol=1e-4)
    assert mirrored.at_aft.all()


@pytest.mark.parametrize("end", [1, -1])
def test_an_end_at_the_edge_moves_with_the_deck_and_the_other_follows_the_water(end):
    gradient, velocity, speed = 0.1, 3.0, 6.0
    times = np.array([0.2, 0.4])
    rise = velocity * times[:, None] - gradient * (30 - end * NODES)  # at a place of the ship
    closing = np.full_like(rise, velocity) - speed * end * gradient
    profiles = StripProfiles(
        NODES, rise, closing, np.zeros_like(rise), -30.0, 30.0, np.zeros((1, 641)), np.zeros(2, int), speed
    )
    found = wetted_intervals(profiles)
    fixed, free = (found.fore_rate, found.aft_rate) if end > 0 else (found.aft_rate, found.fore_rate)
    np.testing.assert_allclose(fixed, speed)
    past_the_ship = -end * 4 * velocity / (3 * gradient)
    np.testing.assert_allclose(free - speed, past_the_ship, rtol=1e-4)


def test_a_deck_under_water_is_wet_from_end_to_end_and_a_dry_one_nowhere():
    found = wetted_intervals(still([np.full(40, 0.3), np.full(40, -0.3)]))
    np.testing.assert_array_equal(found.row, [0])
    assert (found.aft[0], found.fore[0]) == (-30.0, 30.0)
    assert found.at_aft[0]
    assert found.at_fore[0]


def test_two_crests_far_apart_are_two_intervals_and_near_each_other_one():
    def two(apart):
        return np.maximum(0.2 - 0.02 * (NODES - apart) ** 2 / 2, 0.2 - 0.02 * (NODES + apart) ** 2 / 2)

    apart = wetted_intervals(still(two(16.0)))
    assert len(apart.row) == 2
    np.testing.assert_allclose(apart.fore[1], -apart.aft[0], rtol=1e-6)
    for nearer in (4.6, 5.2, 6.0):
        together = wetted_intervals(still(two(nearer)))
        assert len(together.row) == 1
        np.testing.assert_allclose(together.fore, -together.aft, rtol=1e-6)


def test_ends_meet_both_conditions_by_another_quadrature():
    rng = np.random.default_rng(3)
    k = 2 * np.pi / np.array([55.0, 31.0, 18.0])
    amplitudes, phases = rng.normal(0.6, 0.2, (60, 3)), rng.uniform(0, 2 * np.pi, (60, 3))
    heights = np.einsum("rk,rkn->rn", amplitudes, np.cos(k[:, None] * NODES + phases[..., None])) - 0.9
    profiles = still(heights)
    found = wetted_intervals(profiles)
    assert found.settled.mean() > 0.99
    angle = (np.arange(400) + 0.5) * np.pi / 400
    for row, a, b, free_a, free_b in zip(
        found.row, found.aft, found.fore, ~found.at_aft, ~found.at_fore, strict=True
    ):
        x = (a + b) / 2 + (b - a) / 2 * np.cos(angle)
        height = profiles.penetration(np.array([row]), x[None])[0][0]
        scale = np.abs(height).mean()
        if free_a:
            assert abs(np.mean(height * (1 - np.cos(angle)))) < 2e-3 * scale
        if free_b:
            assert abs(np.mean(height * (1 + np.cos(angle)))) < 2e-3 * scale
