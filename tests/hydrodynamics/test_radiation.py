"""Potentials at rest and coefficients at speed, against reciprocity, energy, closed forms and a second way."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY, MODES, wavenumber
from workbench.design import Hull
from workbench.geometry.faceted import Panels
from workbench.geometry.panels import hull_panels, lid_panels, panels, tunnel_lid
from workbench.hydrodynamics.forward_speed import (
    RadiatingBody,
    at_encounter_frequency,
    hydrodynamics,
)
from workbench.hydrodynamics.radiation import RadiationProblem, frequency_solution, mode_normals, radiation
from workbench.shapes import Wigley

TWIN = Hull(shape=Wigley(length=40.0, beam=4.0, draught=2.0, depth=4.0), count=2, spacing=10.0)
HEAD = np.pi


@pytest.fixture(scope="module")
def solved():
    problem = RadiationProblem(panels=panels(TWIN, 400), lid=lid_panels(TWIN))
    return radiation(problem, [0.6, 0.9, 1.2])


def at(solved, omega, directions, speed=0.0):
    return hydrodynamics([RadiatingBody(solved)], omega, directions, speed, 1025.0)


def test_added_mass_and_damping_are_symmetric_at_rest(solved):
    found = at(solved, [0.6, 0.9, 1.2], [HEAD])
    omega = found.omega.values[:, None, None]
    force = omega**2 * found.added_mass.values[:, 0] + 1j * omega * found.radiation_damping.values[:, 0]
    scale = np.sqrt(np.abs(np.einsum("fii->fi", force)))
    scaled = force / (scale[:, :, None] * scale[:, None, :])
    np.testing.assert_allclose(scaled, np.swapaxes(scaled, 1, 2), atol=0.012)
    assert np.abs(scaled[:, 1, 3]).min() > 0.1  # couplings that are there are compared, not zeros


def test_damping_is_the_energy_of_the_radiated_waves(solved):
    """B_jj = k omega / (4 pi rho g**2) int |F_j(beta)|**2 d beta: what is radiated is what is felt (deep water)."""
    omega = np.array([0.6, 0.9, 1.2])
    directions = np.linspace(0, 2 * np.pi, 72, endpoint=False)
    found = at(solved, omega, directions)
    forces = np.abs(found.excitation_force.values) ** 2
    k = wavenumber(omega)[:, None]
    radiated = k * omega[:, None] / (4 * np.pi * 1025.0 * GRAVITY**2) * forces.mean(axis=1) * 2 * np.pi
    own = np.einsum("fii->fi", found.radiation_damping.values[:, 0])
    for mode in (1, 2, 3, 4):
        np.testing.assert_allclose(radiated[:, mode], own[:, mode], rtol=0.03, err_msg=MODES[mode])


def test_haskind_forces_are_those_of_the_diffraction_problem(solved):
    problem = RadiationProblem(panels=panels(TWIN, 400), lid=lid_panels(TWIN))
    direction = np.radians(135)
    potential = frequency_solution(problem, 0.9, [(0.9, direction)])["diffraction"][0]
    wetted = problem.panels
    mirror = np.array([1.0, -1.0, 1.0])
    modes = np.concatenate(
        [mode_normals(wetted.centres * side, wetted.normals * side) for side in (np.ones(3), mirror)], axis=1
    )
    direct = -1j * 1025.0 * 0.9 * modes @ (potential * np.tile(wetted.areas, 2))
    by_haskind = at(solved, [0.9], [direction]).diffraction_force.values[0, 0]
    for mode in (1, 2, 3, 4):
        assert by_haskind[mode] == pytest.approx(direct[mode], rel=0.02)


def hemisphere(steps: int) -> Panels:
    """Half (y > 0) of a half-immersed sphere of radius 1, its panels blown up to the true volume."""
    polar, azimuth = np.linspace(0, np.pi / 2, steps + 1)[:, None], np.linspace(0, np.pi, 2 * steps + 1)
    parts = (
        np.sin(polar) * np.cos(azimuth),
        np.sin(polar) * np.sin(azimuth),
        -np.cos(polar) * np.ones_like(azimuth),
    )
    grid = np.stack(parts, axis=-1)
    number = np.arange(grid.shape[0] * grid.shape[1]).reshape(grid.shape[:2])
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(
        -1, 4
    )
    ball = Panels(grid.reshape(-1, 3), faces, np.zeros(len(faces), bool), True)
    scale = (2 * np.pi / 3 / abs(ball.volume)) ** (1 / 3)
    return Panels(ball.vertices * scale, faces if ball.volume > 0 else faces[:, ::-1], ball.is_transom, True)


def test_hemisphere_in_heave_is_hulmes():
    """Hulme 1982: added mass and damping of a half-immersed sphere in heave, over rho V and rho V omega.

    Flat panels of constant strength err like 1/n (3 % at 500 panels): two grids and their limit.
    """
    ka = np.array([0.2, 0.6, 1.0, 2.0])
    omega = np.sqrt(GRAVITY * ka)
    displaced = 1025.0 * 2 * np.pi / 3
    coarse, fine = (
        at(radiation(RadiationProblem(panels=hemisphere(steps)), omega), omega, [0.0]) for steps in (8, 16)
    )
    added = (2 * fine.added_mass - coarse.added_mass).values[:, 0, 2, 2] / displaced
    damping = (2 * fine.radiation_damping - coarse.radiation_damping).values[:, 0, 2, 2] / displaced / omega
    np.testing.assert_allclose(added, [0.7938277, 0.5381009, 0.4284323, 0.3883768], rtol=0.01)
    np.testing.assert_allclose(damping, [0.2793005, 0.3271199, 0.2483980, 0.1030600], rtol=0.025)


def test_speed_terms_keep_timman_newman_symmetry(solved):
    """For a fore-aft symmetric hull at speed, A35 = -A53 and B35 = -B53."""
    found = at(solved, [0.6, 0.9], [np.pi / 2], speed=5.0)
    for matrix in (found.added_mass.values[:, 0], found.radiation_damping.values[:, 0]):
        np.testing.assert_allclose(matrix[:, 2, 4], -matrix[:, 4, 2], rtol=0.02)
        assert np.all(np.abs(matrix[:, 2, 4]) > 0)


def test_speed_terms_are_those_of_strip_theory(solved):
    """A35 - A53 = -2 U B33/omega_e**2, B35 = U A33, B55 + = U**2 B33/omega_e**2 (STF 1970; Grande 2002 2.14)."""
    speed, omega = 5.0, np.array([0.9])
    moving, resting = at(solved, omega, [np.pi / 2], speed), at(solved, omega, [np.pi / 2])
    added, damping = resting.added_mass.values[0, 0], resting.radiation_damping.values[0, 0]
    now_added, now_damping = moving.added_mass.values[0, 0], moving.radiation_damping.values[0, 0]
    difference = now_added[2, 4] - now_added[4, 2] - (added[2, 4] - added[4, 2])
    assert difference == pytest.approx(-2 * speed * damping[2, 2] / 0.81, rel=1e-6)
    assert now_damping[2, 4] - damping[2, 4] == pytest.approx(speed * added[2, 2], rel=1e-6)
    assert now_damping[4, 4] - damping[4, 4] == pytest.approx(speed**2 * damping[2, 2] / 0.81, rel=1e-3)
    assert now_added[2, 2] == pytest.approx(added[2, 2], rel=1e-9)


def test_separate_hulls_add_up_with_their_lever_arms_and_phases():
    """A44 = 2 (A44' + y**2 A33'), A66 = 2 (A66' + y**2 A11'), forces with each hull's phase (Grande 2.27-2.28)."""
    omega, beta, y = np.array([0.9]), np.radians(120), 5.0
    alone = radiation(RadiationProblem(panels=hull_panels(TWIN, 0, 200)), omega)
    one = hydrodynamics([RadiatingBody(alone)], omega, [beta], 0, 1025.0)
    pair = hydrodynamics(
        [RadiatingBody(alone, 0.0, y), RadiatingBody(alone, 0.0, -y)], omega, [beta], 0, 1025.0
    )
    single, added = one.added_mass.values[0, 0], pair.added_mass.values[0, 0]
    assert added[2, 2] == pytest.approx(2 * single[2, 2])
    assert added[3, 3] == pytest.approx(2 * (single[3, 3] + y**2 * single[2, 2]))
    assert added[5, 5] == pytest.approx(2 * (single[5, 5] + y**2 * single[0, 0]))
    assert added[2, 4] == pytest.approx(2 * single[2, 4])
    assert added[2, 3] == pytest.approx(0, abs=1e-6 * added[2, 2])
    shift = wavenumber(0.9) * y * np.sin(beta)
    force, pair_force = one.excitation_force.values[0, 0], pair.excitation_force.values[0, 0]
    assert pair_force[2] == pytest.approx(2 * np.cos(shift) * force[2])
    assert pair_force[3] == pytest.approx(2 * np.cos(shift) * force[3] + 2j * y * np.sin(shift) * force[2])


def test_twin_together_and_apart_share_the_incident_force():
    omega, directions = [0.9], [np.radians(120)]
    together = at(radiation(RadiationProblem(panels=panels(TWIN, 400)), omega), omega, directions)
    alone = radiation(RadiationProblem(panels=hull_panels(TWIN, 0, 200)), omega)
    apart = hydrodynamics(
        [RadiatingBody(alone, 0.0, 5.0), RadiatingBody(alone, 0.0, -5.0)], omega, directions, 0, 1025.0
    )
    for mode in (2, 3, 4):
        expected = together.froude_krylov_force.values[0, 0, mode]
        assert apart.froude_krylov_force.values[0, 0, mode] == pytest.approx(expected, rel=0.02)
    assert together.added_mass.values[0, 0, 2, 2] != pytest.approx(
        apart.added_mass.values[0, 0, 2, 2], rel=0.02
    )


def test_lid_removes_an_irregular_frequency():
    """A box of 20 x 6 x 3 m has an interior sloshing mode; without a lid its coefficients spike there."""
    from workbench.shapes import HeavyLiftBox

    box = Hull(
        shape=HeavyLiftBox(
            length=20, beam=6, draught=3, depth=6, bilge_radius=0.5, bow_length=1, stern_length=1
        )
    )
    wetted = panels(box, 500)
    interior = np.sqrt(
        GRAVITY * np.hypot(np.pi / 20, np.pi / 6) / np.tanh(np.hypot(np.pi / 20, np.pi / 6) * 3)
    )
    omega = np.linspace(0.97, 1.03, 7) * interior
    damping = [
        at(
            radiation(RadiationProblem(panels=wetted, lid=lid), omega), omega, [HEAD]
        ).radiation_damping.values[:, 0, 2, 2]
        for lid in (None, lid_panels(box))
    ]
    roughness = [np.max(np.abs(np.diff(values, 2))) / np.mean(np.abs(values)) for values in damping]
    assert roughness[1] < 0.2 * roughness[0]


def test_damping_lid_lowers_the_wave_between_the_hulls():
    wetted = panels(TWIN, 400)
    field = {"field_x": (-5.0, 0.0, 5.0), "field_y": (-1.0, 0.0, 1.0)}
    omega = np.linspace(1.4, 2.2, 9)
    peak, lost = [], []
    for damping in (0.0, 0.05, 0.2):
        problem = RadiationProblem(
            panels=wetted, tunnel_lid=tunnel_lid(TWIN) if damping else None, tunnel_damping=damping, **field
        )
        solved = radiation(problem, omega)
        peak.append(float(np.abs(solved.radiated_elevation.values[:-1, 2]).max()))
        lost.append(at(solved, omega, [HEAD]).radiation_damping.values[:, 0, 2, 2])
    assert peak[0] > peak[1] > peak[2]
    assert np.all(lost[2] > 0)


def test_mirrored_and_whole_panels_give_the_same():
    half = panels(TWIN, 400)
    omega, directions = [0.9], [np.radians(120)]
    field = {"field_x": (-6.0, 6.0), "field_y": (-2.0, 2.0)}
    by_half = radiation(RadiationProblem(panels=half, **field), omega, directions)
    by_whole = radiation(RadiationProblem(panels=half.whole(), **field), omega, directions)
    first, second = at(by_half, omega, directions), at(by_whole, omega, directions)
    diagonal = np.sqrt(np.abs(np.diag(second.added_mass.values[0, 0])))
    scale = np.outer(diagonal, diagonal)
    np.testing.assert_allclose(
        first.added_mass.values[0, 0] / scale, second.added_mass.values[0, 0] / scale, atol=1e-3
    )
    force = np.abs(second.excitation_force.values[0, 0])
    np.testing.assert_allclose(
        first.excitation_force.values[0, 0], second.excitation_force.values[0, 0], atol=5e-4 * force.max()
    )
    assert force.min() > 0
    for name in ("diffracted_elevation", "radiated_elevation"):
        np.testing.assert_allclose(by_half[name].values, by_whole[name].values, atol=5e-3)


def test_frequencies_between_and_beyond_the_nodes():
    nodes = np.array([0.5, 1.0, 1.5, 2.0, np.inf])
    values = np.array([1.0, 2.0, 3.0, 4.0, 10.0])[:, None] + 0j
    wanted = np.array([0.1, 0.5, 1.25, 2.0, 4.0])
    found = at_encounter_frequency(nodes, values, wanted)[:, 0].real
    np.testing.assert_allclose(found, [1.0, 1.0, 2.5, 4.0, 8.5])


def test_speed_terms_of_diffraction_are_those_of_strip_theory(solved):
    """F5 += U/(i w) F3, F6 -= U/(i w) F2 of the diffraction force (STF 1970; Grande 2002, A1.98-A1.99, conjugated)."""
    speed, omega = 5.0, np.array([0.9])
    moving, resting = (
        at(solved, omega, [np.pi / 2], value).diffraction_force.values[0, 0] for value in (speed, 0.0)
    )
    ratio = speed / (1j * 0.9)
    assert moving[4] - resting[4] == pytest.approx(ratio * resting[2], rel=1e-9)
    assert moving[5] - resting[5] == pytest.approx(-ratio * resting[1], rel=1e-9)
    np.testing.assert_allclose(moving[:4], resting[:4])


def test_dry_transom_adds_the_end_terms_of_strip_theory(monkeypatch):
    """B33 += U a33, B35 += -U x a33 - U**2/w**2 b33, F3 -= U/(i w) d3 at the transom (STF 1970; Grande 2002, 2.15)."""
    from workbench.hydrodynamics import forward_speed
    from workbench.shapes import RoundBilge

    hull = Hull(
        shape=RoundBilge(
            length=40.0,
            beam=4.0,
            draught=2.0,
            depth=4.0,
            block_coefficient=0.48,
            lcb=-0.05,
            transom_ratio=0.5,
            deadrise_angle=np.radians(10),
            entrance_angle=np.radians(12),
        )
    )
    omega, directions, speed = np.array([1.1]), [np.pi / 2], 9.0
    solved = radiation(RadiationProblem(panels=panels(hull, 400), lid=lid_panels(hull)), omega)
    body = RadiatingBody(solved)
    assert forward_speed.transom_is_dry(body, 12.0)
    assert not forward_speed.transom_is_dry(body, 2.0)
    found = {}
    for name, limit in (("wet", 1e9), ("dry", 0.0)):
        monkeypatch.setattr(forward_speed, "VENTILATION_FROUDE_NUMBER", limit)
        found[name] = hydrodynamics([body], omega, directions, speed, 1025.0)
    gained = (found["dry"].added_mass - found["wet"].added_mass).values[0, 0]
    damped = (found["dry"].radiation_damping - found["wet"].radiation_damping).values[0, 0]
    x, n = solved.panel_centre.values, solved.panel_normal.values
    last = (x[:, 0] < -19.3) & (solved.panel_is_transom.values == 0)
    girth = solved.panel_area.values * np.hypot(n[:, 1], n[:, 2]) / (2 * (x[last, 0].mean() + 20.0))
    modes = mode_normals(x, n)
    potential = solved.radiation_potential.values[0]
    section = -2 * 1025.0 * np.einsum("jp,kp,p->jk", modes[:, last], potential[:, last], girth[last])
    a, b, w, u = section.real, 1.1 * section.imag, 1.1, speed
    assert girth[last].sum() == pytest.approx(2.16, abs=0.1)  # half the girth of the transom's edge
    assert damped[2, 2] == pytest.approx(u * a[2, 2], rel=1e-3)
    assert gained[2, 2] == pytest.approx(-u / w**2 * b[2, 2], rel=1e-3)
    assert damped[4, 2] == pytest.approx(u * a[4, 2], rel=1e-3)
    assert damped[2, 4] == pytest.approx(u * a[2, 4] - u**2 / w**2 * b[2, 2], rel=1e-3)
    assert gained[2, 4] == pytest.approx(-u / w**2 * b[2, 4] - u**2 / w**2 * a[2, 2], rel=1e-3)
    assert gained[4, 2] == pytest.approx(-u / w**2 * b[4, 2], rel=1e-3)
    # Half the ideal added mass of a wide flat section, give or take: a33 of a last section of this breadth.
    breadth = 2 * np.abs(x[last, 1]).max()
    assert 0.3 < a[2, 2] / (1025.0 * np.pi * breadth**2 / 8) < 2.0
    # Long beam waves pass the section as a heave of minus the particle velocity: d3 = -(w**2 a + i w b)/... of heave.
    force = (found["dry"].diffraction_force - found["wet"].diffraction_force).values[0, 0]
    assert force[2] == pytest.approx(u / (1j * w) * (w**2 * a[2, 2] + 1j * w * b[2, 2]), rel=0.35)
