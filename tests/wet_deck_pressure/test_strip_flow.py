"""Forces and pressures of strips against closed forms."""

import numpy as np
import pytest

from tests.wet_deck_pressure.strips_of_water import crest, profiles_of
from workbench.impact.entry import entry
from workbench.impact.section import Wedge
from workbench.wet_deck_pressure.strip_flow import SOUND_SPEED, panel_flow
from workbench.wet_deck_pressure.strip_profiles import StripProfiles
from workbench.wet_deck_pressure.wetted_interval import wetted_intervals

NODES = np.linspace(-29.25, 29.25, 40)
EDGES = np.linspace(-30, 30, 41)
CURVATURE, VELOCITY, CELERITY = 0.02, 3.0, 5.0


def flow_of(profiles, edges=EDGES):
    return panel_flow(profiles, wetted_intervals(profiles), edges)


def of_crest(times, speed=0.0, celerity=CELERITY):
    return profiles_of(*crest(CURVATURE, VELOCITY, celerity, speed), times, NODES, 30.0, speed)


@pytest.mark.parametrize("speed", [0.0, 8.0, -4.0])
def test_force_of_a_travelling_crest_is_that_of_a_parabola(speed):
    """2 pi rho V**2 R while both ends spread, whatever the celerity and the speed of the ship."""
    found = flow_of(of_crest(np.linspace(0.005, 0.3, 20), speed))
    np.testing.assert_allclose(found.pressure.sum(axis=1), 2 * np.pi * VELOCITY**2 / CURVATURE, rtol=1e-9)
    assert found.is_spreading.all()


def test_moment_of_a_travelling_crest():
    """rho d/dt int -phi x dx with phi = -(V - k C xi/2) sqrt(l**2 - xi**2), xi from the crest."""
    t = np.array([0.1, 0.2])
    found = flow_of(of_crest(t), np.linspace(-30, 30, 6001))
    middle = np.linspace(-29.995, 29.995, 6000)
    moment = found.pressure @ middle

    def first_moment(at):
        half = 2 * np.sqrt(VELOCITY * at / CURVATURE)
        return (
            -CELERITY * at * np.pi / 2 * half**2 * VELOCITY - CURVATURE * CELERITY / 2 * np.pi / 8 * half**4
        )

    step = 1e-5
    np.testing.assert_allclose(
        moment, (first_moment(t + step) - first_moment(t - step)) / (2 * step), rtol=1e-5
    )


@pytest.mark.parametrize("speed", [0.0, 8.0])
def test_pressure_is_the_growth_of_the_potential_impulse_past_the_ship(speed):
    step = 1e-4
    found = flow_of(of_crest(0.1 + step * np.array([-1, 0, 1]), speed))
    grown = (
        (found.potential_impulse[2] - found.potential_impulse[0]) / (2 * step)
        + found.drift[1]
        + found.edges[1]
    )
    np.testing.assert_allclose(grown, found.pressure[1], atol=3e-4 * found.pressure.max())


@pytest.mark.parametrize("end", [1, -1])
def test_growth_of_the_potential_impulse_with_water_over_an_end_of_an_advancing_deck(end):
    """The singular term of the end at the edge, which moves with the ship, is off the growth as off the pressure."""
    gradient, speed, step = 0.1, 6.0, 1e-4
    times = 0.31 + step * np.array([-1, 0, 1])
    profiles = profiles_of(
        lambda t, x, y: VELOCITY * t - gradient * (30 - end * x),
        lambda t, x, y: VELOCITY - speed * end * gradient + 0 * x,
        lambda t, x, y: 0 * x,
        times,
        NODES,
        30.0,
        speed,
    )
    found = flow_of(profiles)
    grown = (found.potential_impulse[2] - found.potential_impulse[0]) / (2 * step)
    assert np.abs(found.edges[1]).max() > 0.1
    np.testing.assert_allclose(
        grown + found.drift[1] + found.edges[1], found.pressure[1], atol=1e-3 * np.abs(found.pressure).max()
    )


def test_pressure_of_a_uniform_plate_is_wagners_outer_pressure():
    """rho V c c'/sqrt(c**2 - x**2), integrated over panels as an arc sine."""
    t = np.array([0.15])
    found = flow_of(of_crest(t, celerity=0.0))
    half, grows = 2 * np.sqrt(VELOCITY * t / CURVATURE), np.sqrt(VELOCITY / CURVATURE / t)
    arc = np.arcsin(np.clip(EDGES / half, -1, 1))
    np.testing.assert_allclose(
        found.pressure[0], VELOCITY * half * grows * np.diff(arc), rtol=1e-9, atol=1e-9
    )


def test_impulse_of_a_spreading_plate_is_a_quarter_pi_rho_v_c_squared_a_side():
    t = np.array([0.05, 0.2])
    found = flow_of(of_crest(t, celerity=0.0))
    half = 2 * np.sqrt(VELOCITY * t / CURVATURE)
    for side in (slice(0, 20), slice(20, 40)):
        np.testing.assert_allclose(
            found.potential_impulse[:, side].sum(axis=1), np.pi / 4 * VELOCITY * half**2
        )


def test_an_accelerated_plate_under_water_has_the_added_mass_of_a_strip():
    acceleration = 4.0
    profiles = profiles_of(
        lambda t, x, y: 1.0 + 0 * x,
        lambda t, x, y: 0.5 + 0 * x,
        lambda t, x, y: acceleration + 0 * x,
        [0.0],
        NODES,
        30.0,
    )
    found = flow_of(profiles)
    np.testing.assert_allclose(found.pressure.sum(), np.pi / 2 * 30**2 * acceleration, rtol=1e-6)
    np.testing.assert_allclose(found.potential_impulse.sum(), np.pi / 2 * 30**2 * 0.5, rtol=1e-6)
    x = (EDGES[1:] + EDGES[:-1]) / 2
    np.testing.assert_allclose(
        found.pressure[0, 10:30] / 1.5, acceleration * np.sqrt(900 - x[10:30] ** 2), rtol=1e-3
    )


def test_a_receding_end_sheds_the_water_without_suction():
    """Water that falls away at a steady velocity leaves no pressure, where the full theory would have a spike."""
    falls = profiles_of(*crest(CURVATURE, -VELOCITY, 0.0, start=0.5), [0.1, 0.3, 0.4], NODES, 30.0)
    found = flow_of(falls)
    np.testing.assert_allclose(found.pressure, 0.0, atol=1e-9)
    assert not found.is_spreading.any()
    assert np.abs(found.potential_impulse).max() > 1


def test_a_crest_that_outruns_its_spreading_has_one_end_that_recedes():
    curvature, celerity, times = 0.05, 20.0, np.array([0.05, 0.3])
    profiles = profiles_of(*crest(curvature, VELOCITY, celerity), times, NODES, 30.0)
    intervals, found = wetted_intervals(profiles), flow_of(profiles)
    assert list(found.is_spreading) == [True, False]
    half = 2 * np.sqrt(VELOCITY * times[1] / curvature)
    grows = half / (2 * times[1])
    np.testing.assert_allclose(intervals.fore_rate[1], grows - celerity, rtol=1e-8)
    tilt = curvature * celerity * half / 2  # w_2 = -tilt: the aft end, at cos = -1, closes faster
    accelerated = -np.pi / 2 * half**2 * curvature * celerity**2
    expected = accelerated + np.pi * half * (celerity + grows) * (VELOCITY + tilt) / 2
    np.testing.assert_allclose(found.pressure[1].sum(), expected, rtol=1e-9)


def test_root_pressure_is_half_rho_of_the_roots_speed_squared_and_not_beyond_that_of_sound():
    t = np.array([1e-5, 0.1])
    found = flow_of(of_crest(t, celerity=0.0))
    assert found.root_pressure[0] == pytest.approx(SOUND_SPEED * VELOCITY)
    assert found.root_pressure[1] == pytest.approx(VELOCITY / CURVATURE / 0.1 / 2)
    assert (found.roots, found.fast_roots) == (4, 2)
    limit = np.pi / 2 * VELOCITY / np.tan(np.radians(3.0))  # of a wedge of 3 degrees
    near = VELOCITY / CURVATURE / (limit * np.array([1.05, 0.95])) ** 2
    assert flow_of(of_crest(near, celerity=0.0)).fast_roots == 2


def test_the_force_does_not_depend_on_the_panels():
    profiles = of_crest(np.array([0.1, 0.25]))
    totals = [flow_of(profiles, np.linspace(-30, 30, n + 1)).pressure.sum(axis=1) for n in (1, 7, 60, 400)]
    np.testing.assert_allclose(totals, np.broadcast_to(totals[0], (4, 2)), rtol=1e-12)


def test_squared_velocity_leaves_the_modified_logvinovich_force_of_a_flat_wedge():
    """Cp = (pi/tan b) q - q**2, q = 1/sqrt(1 - s**2), to its zero: the slope's own squares are left out."""
    beta, velocity, depth = np.radians(10.0), 2.0, 0.4
    nodes = np.linspace(-4.95, 4.95, 40)
    table = np.abs(np.linspace(-5, 5, 641)) * np.tan(beta)
    profiles = StripProfiles(
        nodes,
        np.full((1, 40), depth),
        np.full((1, 40), velocity),
        np.zeros((1, 40)),
        -5.0,
        5.0,
        table[None],
        np.zeros(1, int),
    )
    edges = np.linspace(-5, 5, 201)
    found = panel_flow(profiles, wetted_intervals(profiles), edges, squared_velocity=True)
    pile = np.pi / np.tan(beta)
    s = np.sqrt(1 - 1 / pile**2)
    expected = pile / 2 * (pile * np.arcsin(s) - np.arctanh(s)) * velocity**2 * depth
    force = (found.pressure - found.taken).sum()
    assert force == pytest.approx(expected, rel=2e-3)
    half = np.pi * depth / (2 * np.tan(beta))
    x = (edges[1:] + edges[:-1]) / 2
    inside = np.abs(x) < 0.9 * half
    q = 1 / np.sqrt(1 - (x[inside] / half) ** 2)
    local = ((found.pressure - found.taken)[0] / np.diff(edges))[inside]
    np.testing.assert_allclose(local, velocity**2 / 2 * (pile * q - q**2), rtol=5e-3)
    whole = entry(Wedge(beta), velocity, "logvinovich", 1.0, [depth / velocity])
    assert force == pytest.approx(float(whole.section_force[0]), rel=0.01)
