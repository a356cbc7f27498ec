"""Two-dimensional sections against series solutions, closed forms, energy, reciprocity and direct diffraction."""

from dataclasses import replace

import numpy as np
import pytest

from workbench.conventions import GRAVITY, wavenumber
from workbench.errors import InputError
from workbench.hydrodynamics.section_contours import (
    checked_contour,
    section_coefficients,
    section_stack,
    section_wave_forces,
)
from workbench.hydrodynamics.section_waves import Waves, arresting_velocity
from workbench.hydrodynamics.sections import (
    far_field_amplitude,
    field_potentials,
    potentials,
    radiation_potentials,
    sectional_matrix,
    wetted_panels,
)
from workbench.verification import published

SWAY, HEAVE, ROLL = range(3)


def circle(panels=60, centre=0.0, radius=1.0):
    angle = np.linspace(-np.pi, 0.0, panels + 1)
    return np.stack([centre + radius * np.cos(angle), radius * np.sin(angle)], axis=-1)


def submerged_circle(depth, panels=60):
    angle = np.linspace(0.0, 2 * np.pi, panels + 1)
    return np.stack([np.cos(angle), np.sin(angle) - depth], axis=-1)


APART = np.array([2.5, 0.0])
HEELED = np.array([[-0.9, 0.0], [-0.5, -0.7], [0.2, -1.2], [0.8, -0.9], [1.3, 0.0]])


def frequency(reduced, length=1.0):
    return np.sqrt(GRAVITY * np.asarray(reduced) / length)


def reduced_coefficients(contours, ka, **more):
    found = section_coefficients(contours, frequency(ka), density=2 / np.pi, **more)
    return found.added_mass, found.damping / frequency(ka)[:, None, None]


def test_half_immersed_circle_is_the_multipole_solution_within_a_per_cent():
    table = published.columns("ursell_1949_half_immersed_cylinder")
    added_mass, damping = reduced_coefficients([circle(100)], table["ka"], panels=100)
    for column, values in (
        ("A33", added_mass[:, HEAVE, HEAVE]),
        ("B33", damping[:, HEAVE, HEAVE]),
        ("A22", added_mass[:, SWAY, SWAY]),
        ("B22", damping[:, SWAY, SWAY]),
    ):
        np.testing.assert_allclose(values, table[column], rtol=0.01, atol=2e-6, err_msg=column)


def test_twin_circles_resonate_as_the_two_centre_multipoles():
    table = published.columns("wang_1971_twin_cylinders")
    for spacing in (1.5, 2.0):
        rows = table["b_over_a"] == spacing
        ka = table["ka"][rows]
        added_mass, damping = reduced_coefficients([circle(60, spacing)], ka, mirrored=True, panels=60)
        # near the piston mode the peak (A33 -6 to 3, B33 to 8) is as sharp as 1 % of ka
        np.testing.assert_allclose(added_mass[:, HEAVE, HEAVE] / 2, table["A33"][rows], rtol=2e-3, atol=3e-3)
        np.testing.assert_allclose(damping[:, HEAVE, HEAVE] / 2, table["B33"][rows], rtol=6e-3, atol=3e-4)


@pytest.mark.parametrize(("spacing", "peak", "largest"), [(1.5, 0.6531, 8.4746), (2.0, 0.4423, 4.3633)])
def test_piston_resonance_between_twin_circles(spacing, peak, largest):
    ka = np.linspace(peak - 0.01, peak + 0.01, 81)
    _, damping = reduced_coefficients([circle(60, spacing)], ka, mirrored=True, panels=60)
    heave = damping[:, HEAVE, HEAVE] / 2
    assert ka[heave.argmax()] == pytest.approx(peak, abs=6e-4)
    assert heave.max() == pytest.approx(largest, rel=2e-3)


@pytest.mark.parametrize(("ka", "mode"), [(1.8254, HEAVE), (3.27, SWAY), (6.34, SWAY)])
def test_irregular_frequencies_are_removed(ka, mode):
    """The interior of a half circle sloshes at these; without the interior rows the solution is visibly wrong."""
    k = np.array([ka])
    fine = section_stack([circle(160)], 160)
    exact = sectional_matrix(wetted_panels(fine), radiation_potentials(fine, k))[0, 0, mode, mode]
    sections = section_stack([circle(32)], 32)
    wetted = wetted_panels(sections)
    with_rows = sectional_matrix(wetted, radiation_potentials(sections, k))[0, 0, mode, mode]
    without = replace(sections, half_beam=0 * sections.half_beam)
    without_rows = sectional_matrix(wetted, radiation_potentials(without, k))[0, 0, mode, mode]
    assert abs(with_rows - exact) < 0.006
    assert abs(without_rows - exact) > 0.05


@pytest.mark.parametrize(("a1", "a3"), [(0.0, 0.0), (0.2, -0.1), (-0.3, 0.05), (0.4, -0.05)])
def test_lewis_forms_at_infinite_frequency(a1, a3):
    angle = np.linspace(-np.pi / 2, np.pi / 2, 401)
    y = (1 + a1) * np.sin(angle) - a3 * np.sin(3 * angle)
    z = -((1 - a1) * np.cos(angle) + a3 * np.cos(3 * angle))
    z[[0, -1]] = 0.0
    found = section_coefficients([np.stack([y, z], axis=-1)], np.inf, density=1.0, panels=100)
    half_beam = 1 + a1 + a3
    known = np.pi / 2 * ((1 + a1) ** 2 + 3 * a3**2) / half_beam**2 * half_beam**2
    assert found.added_mass[0, HEAVE, HEAVE] == pytest.approx(known, rel=0.003)
    assert found.damping[0, HEAVE, HEAVE] == 0.0


def test_limits_of_frequency():
    found = section_coefficients([circle(100)], [0.0, np.inf], density=2 / np.pi, panels=100)
    assert found.added_mass[0, SWAY, SWAY] == pytest.approx(1.0, rel=0.003)
    assert np.isinf(found.added_mass[0, HEAVE, HEAVE])
    assert found.added_mass[1, SWAY, SWAY] == pytest.approx(4 / np.pi**2, rel=0.003)
    assert found.added_mass[1, HEAVE, HEAVE] == pytest.approx(1.0, rel=0.003)
    assert not np.any(found.damping)


def test_mirrored_twin_is_the_twin_in_full():
    ka = np.array([0.1, 0.5, 1.3])
    mirrored = reduced_coefficients([HEELED + APART], ka, mirrored=True)
    image = (HEELED + APART)[::-1] * [-1, 1]
    full = reduced_coefficients([image, HEELED + APART], ka)
    np.testing.assert_allclose(mirrored[0], full[0], atol=2e-3 * np.abs(full[0]).max())
    np.testing.assert_allclose(mirrored[1], full[1], atol=2e-3 * np.abs(full[1]).max())


@pytest.mark.parametrize(
    "contours",
    [[HEELED], [HEELED, circle(20, 3.5)], [submerged_circle(1.4)]],
    ids=["heeled", "two", "submerged"],
)
def test_coefficients_are_reciprocal_and_damping_is_radiated_energy(contours):
    k = np.array([0.2, 0.7, 1.5])
    sections = section_stack(contours, 60)
    wetted = wetted_panels(sections)
    potential = radiation_potentials(sections, k)
    matrix = sectional_matrix(wetted, potential)[:, 0]
    scale = np.sqrt(np.abs(np.einsum("fii->fi", matrix)))
    scaled = matrix / (scale[:, :, None] * scale[:, None, :])
    np.testing.assert_allclose(scaled, np.swapaxes(scaled, 1, 2), atol=5e-3)
    amplitude = far_field_amplitude(wetted, potential, k)[:, :, 0]
    radiated = np.einsum("sfj,sfk->fjk", amplitude, np.conj(amplitude)).real / 2
    np.testing.assert_allclose(
        radiated, matrix.imag, atol=8e-3 * np.abs(matrix.imag).max(axis=(1, 2), keepdims=True).max()
    )


@pytest.mark.parametrize("direction", [np.pi, np.radians(120), np.pi / 2, -0.7])
def test_haskind_forces_are_those_of_the_diffraction_problem(direction):
    """Also where the section meets the waves at another frequency than their own."""
    omega, encounter = frequency([0.3, 1.0]), frequency([0.5, 1.6])
    sections = section_stack([HEELED, circle(20, 3.5)], 60)
    wetted = wetted_panels(sections)
    waves = Waves(omega, np.full(2, direction), encounter)
    diffracted = potentials(sections, wavenumber(encounter), *arresting_velocity(sections, waves))
    modes = wetted.modes()[0] * wetted.length
    direct = -1j * encounter[:, None] * (diffracted[:, 0, 0] @ modes.T)
    found = section_wave_forces(
        [HEELED, circle(20, 3.5)], omega, direction, encounter=encounter, density=1.0
    ).diffraction
    np.testing.assert_allclose(found, direct, atol=6e-3 * np.abs(direct).max())


def test_submerged_circle_reflects_no_waves():
    """Known since Dean (1948): incident waves of any length pass with a change of phase alone."""
    k = np.array([0.4, 0.9])
    sections = section_stack([submerged_circle(1.5)], 80)
    waves = Waves(np.sqrt(GRAVITY * k), np.full(2, np.pi / 2), np.sqrt(GRAVITY * k))
    velocity = arresting_velocity(sections, waves)
    diffracted = potentials(sections, k, *velocity)
    far = np.array([[-40.0, 40.0]]), np.array([[0.0, 0.0]])
    elevation = (
        1j
        * waves.omega[:, None]
        / GRAVITY
        * field_potentials(sections, k, *velocity, diffracted, *far)[:, 0, :, 0]
    )
    incident = np.exp(1j * k[:, None] * far[0])
    assert np.abs(elevation[:, 0]).max() < 2e-3
    np.testing.assert_allclose(np.abs(incident + elevation)[:, 1], 1.0, atol=2e-3)
    assert np.abs(elevation[:, 1]).min() > 0.1


def test_deeply_submerged_circle_carries_its_own_mass():
    found = section_coefficients([submerged_circle(30.0)], frequency(2.0), density=1 / np.pi)
    np.testing.assert_allclose(found.added_mass[0, :2, :2], np.eye(2), atol=0.004)


def test_field_at_the_side_of_a_body_is_its_own_potential():
    sections = section_stack([circle(80)], 80)
    k = np.array([0.8])
    modes = np.stack([*sections.normals, np.zeros_like(sections.lengths)], axis=-1)
    solved = potentials(sections, k, modes, 0 * modes)
    out = 1.08 * np.array([np.cos(-0.7), np.sin(-0.7)])
    near = field_potentials(sections, k, modes, 0 * modes, solved, out[None, :1], out[None, 1:])[0, 0, 0]
    middles = np.array([part[0] for part in sections.middles])
    nearest = int(np.argmin(np.hypot(*(middles - out[:, None]))))
    slope = modes[0, nearest]
    np.testing.assert_allclose(near, solved[0, 0, :, nearest] + 0.08 * slope, atol=0.015)


def test_a_circle_does_not_move_water_by_turning_about_its_centre():
    found = section_coefficients([circle(60, 2.0)], frequency([0.5]), density=1.0, centre=(2.0, 0.0))
    assert np.abs(found.added_mass[0, ROLL]).max() < 1e-3
    off = section_coefficients([circle(60, 2.0)], frequency([0.5]), density=1.0).added_mass[0]
    assert off[ROLL, ROLL] == pytest.approx(4.0 * off[HEAVE, HEAVE], rel=0.01)


def test_froude_krylov_force_of_a_long_wave_is_the_change_of_buoyancy():
    found = section_wave_forces([HEELED], frequency([1e-5]), np.pi / 2, density=1000.0).froude_krylov[0]
    assert found[HEAVE] == pytest.approx(1000.0 * GRAVITY * 2.2, rel=1e-3)
    area = section_area(HEELED)
    assert found[SWAY] == pytest.approx(-1j * 1e-5 * 1000.0 * GRAVITY * area, rel=0.01)


def section_area(contour):
    y, z = contour.T
    return 0.5 * np.sum(y * np.roll(z, -1) - np.roll(y, -1) * z)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ([[-1, 0], [0.5, -1], [-0.5, -1], [1, 0]], "cross itself"),
        ([[-1, 0], [0, -1], [1, 0]], "at least 4 points"),
        ([[-1, 0], [-1, -1], [1, -1], [1, 0.5]], "under water"),
        ([[-1, 0], [-1, -1], [1, -1], [1, -0.2]], "begin and end at the waterline"),
        ([[-1, 0], [-1, -1], [1, -1], [1, np.nan]], "finite numbers"),
        ("keel", "list of points"),
        ([[0, 0]] * 5, "breadth or a depth"),
    ],
)
def test_bad_sections_are_refused_in_a_sentence(points, words):
    with pytest.raises(InputError, match=words):
        checked_contour(points)


def test_sections_may_run_either_way_round():
    np.testing.assert_array_equal(checked_contour(HEELED[::-1]), HEELED)
    turned = checked_contour(submerged_circle(2.0)[::-1])
    np.testing.assert_allclose(turned, submerged_circle(2.0))


def test_overlapping_hulls_are_refused():
    with pytest.raises(InputError, match="side by side"):
        section_stack([circle(10), circle(10, 0.5)])
    with pytest.raises(InputError, match="y > 0"):
        section_stack([circle(10)], mirrored=True)
