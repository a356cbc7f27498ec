"""Waves under the deck by strips: limits, the convective term, a second theory, headings."""

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from workbench.conventions import GRAVITY, MODES, encounter_frequency
from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.panels import lid_panels, panels
from workbench.hydrodynamics.radiation import RadiationProblem, radiation
from workbench.hydrodynamics.section_waves import Waves, arresting_velocity
from workbench.hydrodynamics.sections import field_potentials, potentials
from workbench.hydrodynamics.strip_sections import strip_bodies
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.hydrodynamics.strip_wave_field import tunnel_grid, wave_field
from workbench.relative_motion import scattered_elevation
from workbench.shapes import Wigley

WIGLEY = Wigley(length=40.0, beam=4.0, draught=2.0, depth=5.0)
TWIN = Hull(shape=WIGLEY, count=2, spacing=10.0)
ALONE = StripSettings(interaction="off", stations=21, panels=16)
TOGETHER = replace(ALONE, interaction="on")
HEAD, BEAM = np.pi, np.pi / 2


@pytest.mark.parametrize("settings", [ALONE, TOGETHER], ids=["alone", "together"])
def test_a_ship_that_follows_a_long_wave_leaves_it_as_it_is(settings):
    """Heave 1, sway and roll of the water: what the hulls scatter at rest they take back by moving."""
    omega = 0.1
    field = wave_field(TWIN, [omega], [BEAM], 0.0, settings, [-8.0, 0.0, 8.0], [-2.0, 0.0, 2.5])
    k = omega**2 / GRAVITY
    motion = np.array([0, 1j, 1, 1j * k, 0, 0])
    moved = np.einsum("jxy,j->xy", field.radiated_elevation.values[0, 0], motion)
    still = field.diffracted_elevation.values[0, 0]
    assert np.abs(still).min() > 1e-3
    assert np.abs(moved + still).max() < 0.03 * np.abs(still).max()


def test_the_convective_term_is_the_slope_of_the_elevation_at_rest():
    speed, x = 4.0, np.linspace(-12.0, 12.0, 7)
    settings = replace(ALONE, stations=21)
    moving = wave_field(TWIN, [1.2], [BEAM], speed, settings, x, [0.0, 1.0])
    rest = wave_field(TWIN, [1.2], [BEAM], 0.0, settings, x, [0.0, 1.0])
    ahead = wave_field(TWIN, [1.2], [BEAM], 0.0, settings, x + 0.5, [0.0, 1.0])
    behind = wave_field(TWIN, [1.2], [BEAM], 0.0, settings, x - 0.5, [0.0, 1.0])
    ratio = speed / (1j * 1.2)

    def heave(field):
        return field.radiated_elevation.values[0, 0, 2]

    def slope(mode):
        return ahead.radiated_elevation.values[0, 0, mode] - behind.radiated_elevation.values[0, 0, mode]

    known = heave(rest) + ratio * slope(2)
    np.testing.assert_allclose(heave(moving), known, atol=0.03 * np.abs(known).max())
    pitch = rest.radiated_elevation.values[0, 0, 4]
    about = pitch + ratio * slope(4)  # convected
    about = about - ratio * (heave(rest) + ratio * slope(2))  # and the m-term of pitch: heave at -U/(i omega)
    found = moving.radiated_elevation.values[0, 0, 4]
    np.testing.assert_allclose(found, about, atol=0.03 * np.abs(about).max())
    yaw = rest.radiated_elevation.values[0, 0, 5] + ratio * rest.radiated_elevation.values[0, 0, 1]
    about = yaw + ratio * (slope(5) + ratio * slope(1))  # the m-term of yaw: sway at U/(i omega)
    found = moving.radiated_elevation.values[0, 0, 5]
    np.testing.assert_allclose(found, about, atol=0.03 * np.abs(about).max())
    rise = ahead.diffracted_elevation.values[0, 0] - behind.diffracted_elevation.values[0, 0]
    scattered = rest.diffracted_elevation.values[0, 0] + ratio * rise
    found = moving.diffracted_elevation.values[0, 0]
    np.testing.assert_allclose(found, scattered, atol=0.03 * np.abs(scattered).max())


@pytest.mark.parametrize(("speed", "omega", "direction"), [(4.0, 1.2, 2.3), (14.0, 1.3, 0.6)])
def test_diffraction_amidships_is_driven_at_the_frequency_of_the_wave(speed, omega, direction):
    """Amidships of a hull alike fore and aft, d/dx is i k cos beta, and omega_e + U k cos beta is omega.

    Where the ship overtakes the waves the potential is minus the conjugate of that of the
    wave from the other side.
    """
    one = Hull(shape=WIGLEY)
    found = wave_field(one, [omega], [direction], speed, ALONE, [0.0], [5.0]).diffracted_elevation.values[
        0, 0
    ]
    met = encounter_frequency(omega, speed, direction)
    (body,) = strip_bodies(one, 21, 16, False)
    (group,) = body.groups
    middle = int(np.flatnonzero(np.abs(body.x) < 1e-9)[0])
    side = direction if met > 0 else -direction
    waves = Waves(np.array([omega]), np.array([side]), np.abs(np.array([met])))
    velocity = arresting_velocity(group.sections, waves)
    k = met**2 / GRAVITY * np.ones(1)
    solved = potentials(group.sections, k, *velocity)
    y = np.full((len(body.x), 1), 5.0)
    potential = field_potentials(group.sections, k, *velocity, solved, y, 0 * y)[0, middle, 0, 0]
    known = 1j * omega / GRAVITY * (potential if met > 0 else -np.conj(potential))
    assert found[0, 0] == pytest.approx(known, rel=0.01)


def test_waves_between_the_hulls_are_those_of_the_panel_method():
    """Beam waves at rest, amidships of a long twin, where the sections rule."""
    hull = replace(TWIN, shape=Wigley(length=60.0, beam=4.0, draught=2.0, depth=5.0))
    omega = [0.8, 1.0]
    x, y = (-6.0, 0.0, 6.0), (-1.5, 0.0, 1.5)
    problem = RadiationProblem(panels=panels(hull, 700), lid=lid_panels(hull), field_x=x, field_y=y)
    known = radiation(problem, omega, [BEAM])
    found = wave_field(hull, omega, [BEAM], 0.0, TOGETHER, x, y)
    for mode in (1, 2, 3):
        near = found.radiated_elevation.values[:, 0, mode]
        far = known.radiated_elevation.values[:2, mode]
        assert np.abs(near - far).max() < 0.25 * np.abs(far).max(), MODES[mode]
    near, far = found.diffracted_elevation.values[:, 0], known.diffracted_elevation.values[:2, 0]
    assert np.abs(near - far).max() < 0.25 * np.abs(far).max()


def test_headings_to_port_and_starboard_mirror_each_other():
    found = wave_field(TWIN, [1.1], [2.0, -2.0], 3.0, TOGETHER, [-5.0, 5.0], [-2.0, 1.0, 2.0])
    other = wave_field(TWIN, [1.1], [2.0], 3.0, TOGETHER, [-5.0, 5.0], [2.0, -1.0, -2.0])
    np.testing.assert_allclose(
        found.diffracted_elevation.values[0, 1], other.diffracted_elevation.values[0, 0], atol=1e-9
    )
    np.testing.assert_allclose(
        found.radiated_elevation.values[0, 0], found.radiated_elevation.values[0, 1], atol=1e-9
    )


def test_points_over_a_hull_are_taken_beside_it_and_none_before_the_bow():
    found = wave_field(TWIN, [1.0], [BEAM], 0.0, TOGETHER, [0.0, 25.0], [3.0 - 1e-6, 3.5, 2.96, 6.8])
    heave = found.radiated_elevation.values[0, 0, 2]
    assert heave[0, 1] == pytest.approx(heave[0, 0], rel=0.05)
    assert not heave[1].any()
    assert np.all(np.isfinite(heave))


def test_waves_overtaken_by_the_ship_scatter_as_high_as_those_that_just_are_not():
    """Their phase jumps, for the waves of the slowly moving hulls run out on either side of zero."""
    speed, crossing = 12.0, GRAVITY / 12.0
    omega = crossing * np.array([0.98, 1.02])
    found = wave_field(TWIN, omega, [0.0], speed, ALONE, [-4.0, 4.0], [0.0])
    one, other = np.abs(found.diffracted_elevation.values[:, 0])
    np.testing.assert_allclose(other, one, rtol=0.1)


def test_scattered_elevation_takes_fields_at_speed_and_at_rest():
    field = wave_field(TWIN, [1.0, 1.3], [HEAD, 2.0], 3.0, ALONE, [-5.0, 5.0], [-2.0, 2.0])
    motion = np.arange(24.0).reshape(2, 2, 6) + 1j
    points = np.array([[-5.0, 5.0]]), np.array([[-2.0, 2.0]])
    at_speed = scattered_elevation(field, motion, *points)
    for column in (0, 1):
        rest = xr.Dataset(
            {
                "radiated_elevation": field.radiated_elevation.isel(wave_direction=column, drop=True),
                "diffracted_elevation": field.diffracted_elevation.isel(wave_direction=[column]),
            }
        )
        alone = scattered_elevation(rest, motion[:, [column]], *points)
        np.testing.assert_allclose(at_speed[:, [column]], alone)


def test_the_tunnel_is_between_the_hulls():
    x, y = tunnel_grid(TWIN)
    assert (x[0], x[-1]) == (-20.0, 20.0)
    np.testing.assert_allclose([y[0], y[-1]], [-3.0, 3.0])
    with pytest.raises(InputError, match="hull count"):
        tunnel_grid(Hull(shape=WIGLEY))
