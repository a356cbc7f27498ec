"""Strip theory: identities of the speed and transom terms, hulls in every arrangement, limits, a second theory."""

from dataclasses import replace

import numpy as np
import pytest

from workbench.conventions import GRAVITY, MODES, encounter_frequency
from workbench.design import Hull
from workbench.designs import named_design
from workbench.errors import InputError
from workbench.geometry.hydrostatics import hydrostatics, stiffness_matrix
from workbench.geometry.panels import lid_panels, panels
from workbench.geometry.sections import sections
from workbench.hydrodynamics import forward_speed
from workbench.hydrodynamics.forward_speed import RadiatingBody
from workbench.hydrodynamics.radiation import RadiationProblem, radiation
from workbench.hydrodynamics.section_waves import Waves, haskind_density, orbital_decay
from workbench.hydrodynamics.sections import radiation_potentials, sectional_matrix, stack, wetted_panels
from workbench.hydrodynamics.strip_forces import weights
from workbench.hydrodynamics.strip_sections import strip_bodies
from workbench.hydrodynamics.strip_settings import StripSettings, validity_warnings
from workbench.hydrodynamics.strip_theory import hydrodynamics
from workbench.motions import motions
from workbench.quantities import warnings_of
from workbench.shapes import Offsets, Wigley

HEAD, BEAM = np.pi, np.pi / 2
WIGLEY = Wigley(length=40.0, beam=4.0, draught=2.0, depth=5.0)
ONE = Hull(shape=WIGLEY)
TWIN = Hull(shape=WIGLEY, count=2, spacing=10.0)
DELFT = named_design("delft-372").hull
ALONE = StripSettings(interaction="off")
COARSE = StripSettings(interaction="off", stations=15, panels=16)
DENSITY = 1000.0


def solved(hull, omega, directions, speed=0.0, settings=COARSE):
    return hydrodynamics(hull, DENSITY, np.atleast_1d(omega), np.atleast_1d(directions), speed, settings)


def matrices(found, row=0, column=0):
    return found.added_mass.values[row, column], found.radiation_damping.values[row, column]


def per_length(section, omega):
    """Added mass and damping of one section."""
    potential = radiation_potentials(section, np.array([omega**2 / GRAVITY]))
    matrix = DENSITY * sectional_matrix(wetted_panels(section), potential)[0, 0]
    return matrix.real, omega * matrix.imag


# --- speed and transom terms: a, b per length at rest give every term of the published table


@pytest.fixture(scope="module")
def last_section():
    """Delft 372 at 2.5 m/s in head waves: at rest, wet, dry, and its last section by itself."""
    speed, omega = 2.5, 4.0
    met = encounter_frequency(omega, speed, HEAD)
    wet = solved(DELFT, omega, HEAD, speed, replace(COARSE, transom="wet"))
    dry = solved(DELFT, omega, HEAD, speed, replace(COARSE, transom="dry"))
    rest = solved(DELFT, met, BEAM)
    port, _ = sections(DELFT, COARSE.stations, COARSE.panels + 1)
    middle = COARSE.panels // 2
    half = np.stack([port.y[0] - port.position[1], port.z[0]], axis=-1)[None, middle:]
    a, b = per_length(stack([half], mirrored=True, half=(True,)), met)
    return speed, met, port.x[0], port.position[1], a, b, matrices(rest), matrices(wet), matrices(dry)


def test_speed_terms_without_transom(last_section):
    speed, met, _, _, _, _, (a0, b0), (a, b), _ = last_section
    heave, pitch = 2, 4
    u = speed / met**2
    expected = {
        "A33": (a[heave, heave], a0[heave, heave]),
        "A35": (a[heave, pitch], a0[heave, pitch] - u * b0[heave, heave]),
        "B35": (b[heave, pitch], b0[heave, pitch] + speed * a0[heave, heave]),
        "A53": (a[pitch, heave], a0[heave, pitch] + u * b0[heave, heave]),
        "B53": (b[pitch, heave], b0[heave, pitch] - speed * a0[heave, heave]),
        "A55": (a[pitch, pitch], a0[pitch, pitch] + speed * u * a0[heave, heave]),
        "B55": (b[pitch, pitch], b0[pitch, pitch] + speed * u * b0[heave, heave]),
    }
    for name, (computed, known) in expected.items():
        assert computed == pytest.approx(known, rel=1e-6), name


def test_identities_of_the_cross_couplings(last_section):
    speed, met, _, _, _, _, (a0, b0), (a, b), _ = last_section
    assert a[2, 4] - a[4, 2] == pytest.approx(-2 * speed / met**2 * b0[2, 2], rel=1e-6)
    assert b[2, 4] + b[4, 2] == pytest.approx(2 * b0[2, 4], rel=1e-6)
    assert b[2, 4] - b[4, 2] == pytest.approx(2 * speed * a0[2, 2], rel=1e-6)
    # sway and yaw, whose signs the thesis prints the other way (A1.87)
    assert a[1, 5] - a[5, 1] == pytest.approx(2 * speed / met**2 * b0[1, 1], rel=1e-6)
    assert b[1, 5] - b[5, 1] == pytest.approx(-2 * speed * a0[1, 1], rel=1e-6)
    assert a[5, 5] == pytest.approx(a0[5, 5] + (speed / met) ** 2 * a0[1, 1], rel=1e-6)


def test_transom_terms_are_those_of_the_published_table(last_section):
    """[STF1970] with the squares that [Grande2002] 2.15 lost in print; two hulls, each with this section."""
    speed, met, x, _, a, b, _, wet, dry = last_section
    a33, b33 = 2 * a[1, 1], 2 * b[1, 1]
    u, u2 = speed / met**2, speed**2 / met**2
    known_mass = {
        (2, 2): -u * b33,
        (2, 4): u * x * b33 - u2 * a33,
        (4, 2): u * x * b33,
        (4, 4): -u * x**2 * b33 + u2 * x * a33,
    }
    known_damping = {
        (2, 2): speed * a33,
        (2, 4): -speed * x * a33 - u2 * b33,
        (4, 2): -speed * x * a33,
        (4, 4): speed * x**2 * a33 + u2 * x * b33,
    }
    for place, known in known_mass.items():
        assert dry[0][place] - wet[0][place] == pytest.approx(known, rel=1e-5), ("A", place)
    for place, known in known_damping.items():
        assert dry[1][place] - wet[1][place] == pytest.approx(known, rel=1e-5), ("B", place)


def test_transom_terms_of_the_wave_force():
    """[STF1970]: F3 gains U/(i omega_e) of the last section's diffraction force, F5 -x_A of that (conjugated here)."""
    speed, omega, direction = 2.5, 4.0, np.radians(150)
    met = encounter_frequency(omega, speed, direction)
    dry, wet = (
        solved(DELFT, omega, direction, speed, replace(COARSE, transom=choice)).excitation_force.values[0, 0]
        for choice in ("dry", "wet")
    )
    force = 0.0
    for one in sections(DELFT, COARSE.stations, COARSE.panels + 1):
        section = stack([np.stack([one.y[0], one.z[0]], axis=-1)[None]])
        wetted = wetted_panels(section)
        waves = Waves(np.array([omega]), np.array([direction]), np.array([met]))
        elevation = orbital_decay(wetted, one.x[:1], waves)
        potential = radiation_potentials(section, np.array([met**2 / GRAVITY]))
        force += DENSITY * haskind_density(wetted, potential, elevation, waves)[0, 0]
    x = one.x[0]
    end = -speed / (1j * met) * force
    known = np.array([0.0, end[0], end[1], end[2], -x * end[1], x * end[0]])
    np.testing.assert_allclose(dry - wet, known, atol=2e-3 * np.abs(known).max())
    assert np.abs(end[1]) > 0.02 * np.abs(wet[2])


def test_a_print_without_the_square_would_not_pass(last_section):
    speed, met, _, _, _, b, _, wet, dry = last_section
    printed = -speed / met * 2 * b[1, 1]
    assert dry[0][2, 2] - wet[0][2, 2] != pytest.approx(printed, rel=0.3)


HEELED = Hull(shape=DELFT.shape, count=2, spacing=DELFT.spacing, heel=np.radians(4.0))


@pytest.fixture(scope="module")
def heeled_sections():
    """The same by hand for the heeled twin in the heave-only formulation: a and b of every section, y of hulls."""
    speed, omega = 2.5, 4.0
    met = encounter_frequency(omega, speed, np.radians(150))
    settings = replace(COARSE, formulation="heave-only")
    by_speed = {
        transom: matrices(solved(HEELED, omega, np.radians(150), speed, replace(settings, transom=transom)))
        for transom in ("wet", "dry")
    }
    table = []
    for one in sections(HEELED, COARSE.stations, COARSE.panels + 1):
        rows = []
        for x, y, z in zip(one.x, one.y, one.z, strict=True):
            contour = np.stack([y - one.position[1], z], axis=-1)[None]
            wet = np.ptp(z) > 1e-6
            a, b = per_length(stack([contour]), met) if wet else np.zeros((2, 3, 3))
            rows.append((x, a[1, 1], b[1, 1]))
        table.append((one.position[1], np.array(rows)))
    return speed, met, table, by_speed


def test_a_heeled_twin_is_the_sum_of_the_heave_of_its_hulls(heeled_sections):
    """[Grande2002] 2.21-2.32 with the speed terms 2.14 and 2.19 and the transom terms 2.15, 2.20, squares put back."""
    speed, met, table, by_speed = heeled_sections
    lever = {2: lambda x, y: 1.0, 3: lambda x, y: y, 4: lambda x, y: -x}
    u, u2 = speed / met**2, speed**2 / met**2
    zero, end = {}, {}
    for j in (2, 3, 4):
        for k in (2, 3, 4):
            sums, last = np.zeros(2), np.zeros(2)
            for y, rows in table:
                x = rows[:, 0]
                both = lever[j](x, y) * lever[k](x, y) * rows[:, 1:].T
                sums += np.trapezoid(both, x, axis=1)
                last += both[:, 0]
            zero[j, k], end[j, k] = sums, last
    a0, b0 = ({key: pair[n] for key, pair in zero.items()} for n in (0, 1))
    at, bt = ({key: pair[n] for key, pair in end.items()} for n in (0, 1))
    speed_a = {
        (2, 4): -u * b0[2, 2],
        (4, 2): u * b0[2, 2],
        (4, 4): u2 * a0[2, 2],
        (3, 4): -u * b0[3, 2],
        (4, 3): u * b0[2, 3],
    }
    speed_b = {
        (2, 4): speed * a0[2, 2],
        (4, 2): -speed * a0[2, 2],
        (4, 4): u2 * b0[2, 2],
        (3, 4): speed * a0[3, 2],
        (4, 3): -speed * a0[2, 3],
    }
    transom_a = {(j, k): -u * bt[j, k] - (u2 * at[j, 2] if k == 4 else 0.0) for j, k in zero}
    transom_b = {(j, k): speed * at[j, k] - (u2 * bt[j, 2] if k == 4 else 0.0) for j, k in zero}
    for j, k in zero:
        scale = np.sqrt(zero[j, j][0] * zero[k, k][0])
        wet, dry = by_speed["wet"], by_speed["dry"]
        known = a0[j, k] + speed_a.get((j, k), 0.0), b0[j, k] + speed_b.get((j, k), 0.0)
        assert wet[0][j, k] == pytest.approx(known[0], abs=1e-5 * scale), ("A", j, k)
        assert wet[1][j, k] == pytest.approx(known[1], abs=1e-5 * scale * met), ("B", j, k)
        assert dry[0][j, k] - wet[0][j, k] == pytest.approx(transom_a[j, k], abs=1e-5 * scale), ("AT", j, k)
        assert dry[1][j, k] - wet[1][j, k] == pytest.approx(transom_b[j, k], abs=1e-5 * scale * met), (
            "BT",
            j,
            k,
        )
    assert abs(by_speed["dry"][0][2, 3]) > 0.01 * np.sqrt(a0[2, 2] * a0[3, 3])  # heel couples heave and roll


# --- arrangements


def test_an_upright_twin_couples_no_heave_with_roll_and_keeps_level_in_head_seas():
    found = solved(TWIN, [1.0, 1.6], [HEAD], 5.0)
    scale = np.sqrt(found.added_mass.values[:, 0, 2, 2] * found.added_mass.values[:, 0, 3, 3])
    for j, k in ((2, 3), (3, 2), (3, 4), (4, 3)):
        assert np.abs(found.added_mass.values[:, 0, j, k] / scale).max() < 1e-9
    force = found.excitation_force.values[:, 0]
    assert np.abs(force[:, [1, 3, 5]]).max() < 1e-9 * np.abs(force).max()


def test_a_heeled_twin_rolls_in_head_seas():
    upright, heeled = (
        np.abs(solved(replace(TWIN, heel=np.radians(heel)), 1.2, HEAD).excitation_force.values[0, 0])
        for heel in (0.0, 5.0)
    )
    assert upright[3] < 1e-9 * upright[2]
    assert heeled[3] > 0.1 * heeled[2]
    little = np.abs(solved(replace(TWIN, heel=1e-5), 1.2, HEAD).excitation_force.values[0, 0])
    np.testing.assert_allclose(little[[2, 4]], upright[[2, 4]], rtol=1e-3)


def test_roll_of_a_twin_is_heave_at_a_distance_and_its_own_roll():
    single, twin = solved(ONE, [1.2], [HEAD]), solved(TWIN, [1.2], [HEAD])
    y = TWIN.spacing / 2
    for name in ("added_mass", "radiation_damping"):
        one, two = single[name].values[0, 0], twin[name].values[0, 0]
        np.testing.assert_allclose(two[2, 2], 2 * one[2, 2], rtol=1e-9)
        np.testing.assert_allclose(two[3, 3], 2 * (y**2 * one[2, 2] + one[3, 3]), rtol=1e-9)
        np.testing.assert_allclose(two[4, 4], 2 * one[4, 4], rtol=1e-9)
        np.testing.assert_allclose(two[1, 3], 2 * one[1, 3], rtol=1e-9)
    thin = solved(TWIN, [1.2], [HEAD], settings=replace(COARSE, formulation="heave-only"))
    assert thin.added_mass.values[0, 0, 3, 3] == pytest.approx(y**2 * twin.added_mass.values[0, 0, 2, 2])
    assert not thin.added_mass.values[0, 0, 1].any()


def test_a_trimaran_is_its_three_hulls():
    centre = Wigley(length=60.0, beam=5.0, draught=3.0, depth=6.0)
    trimaran = Hull(shape=WIGLEY, count=3, spacing=16.0, centre_shape=centre, centre_x=4.0)
    outer = solved(replace(TWIN, spacing=16.0), 1.1, 2.0)
    middle = solved(Hull(shape=centre), 1.1, 2.0)
    whole = solved(trimaran, 1.1, 2.0)
    heave = outer.added_mass.values[0, 0, 2, 2] + middle.added_mass.values[0, 0, 2, 2]
    assert whole.added_mass.values[0, 0, 2, 2] == pytest.approx(heave, rel=1e-9)
    shifted = np.exp(1j * 1.1**2 / GRAVITY * 4.0 * np.cos(2.0)) * middle.excitation_force.values[0, 0]
    force = outer.excitation_force.values[0, 0] + shifted
    assert whole.excitation_force.values[0, 0, 2] == pytest.approx(force[2], rel=1e-6)


def test_hulls_far_apart_do_not_feel_each_other_and_near_ones_do():
    together = StripSettings(interaction="on", stations=9, panels=16)
    apart = StripSettings(interaction="off", stations=9, panels=16)
    near = [solved(TWIN, 2.0, HEAD, settings=s).added_mass.values[0, 0, 2, 2] for s in (together, apart)]
    assert abs(near[0] / near[1] - 1) > 0.05
    high = Hull(shape=WIGLEY, count=2, spacing=60.0)
    far = [solved(high, 8.0, HEAD, settings=s).added_mass.values[0, 0, 2, 2] for s in (together, apart)]
    assert far[0] == pytest.approx(far[1], rel=0.01)


def test_three_hulls_together_are_the_same_by_symmetry_and_in_full():
    """A heel of no size forbids the mirror; the sections are then solved all round."""
    centre = Wigley(length=36.0, beam=3.0, draught=1.5, depth=5.0)
    trimaran = Hull(shape=WIGLEY, count=3, spacing=16.0, centre_shape=centre, centre_x=2.0)
    settings = StripSettings(interaction="on", stations=7, panels=16)
    mirrored, full = (solved(replace(trimaran, heel=heel), 1.4, 2.2, 0.0, settings) for heel in (0.0, 1e-7))
    assert strip_bodies(trimaran, 7, 16, True)[0].groups[-1].sections.mirrored
    for name in ("added_mass", "radiation_damping", "excitation_force"):
        scale = np.abs(full[name].values).max()
        np.testing.assert_allclose(mirrored[name].values, full[name].values, atol=1e-4 * scale)


def test_a_flying_hull_carries_nothing():
    """With the outer hulls above water a trimaran is its centre hull."""
    shallow = Wigley(length=40.0, beam=2.0, draught=0.5, depth=5.0)
    flying = Hull(shape=shallow, count=2, spacing=12.0, heel=np.radians(12.0), sinkage=-0.2)
    found = solved(flying, 1.2, HEAD)
    force = np.abs(found.excitation_force.values[0, 0])
    low = next(one for one in sections(flying) if one.x.size)
    assert force[3] == pytest.approx(abs(low.position[1]) * force[2], rel=0.1)
    assert len(strip_bodies(flying, 15, 16, False)) == 1


def submarine_strut():
    """A bulb under a strut that has no thickness over its after half."""

    def station(x, strut):
        bulb = [(0.0, 0.0), (0.6, 0.3), (0.8, 0.8), (0.6, 1.3), (strut, 1.6), (strut, 3.0), (strut, 4.0)]
        return (x, tuple((z, y) for y, z in bulb))

    return Offsets(
        stations=tuple(station(x, 0.3 * (x > 0)) for x in (-10.0, -5.0, -0.5, 0.5, 5.0, 10.0)),
        draught=3.0,
        length=20.0,
    )


def test_a_bulb_without_strut_is_a_closed_section_under_water():
    settings = StripSettings(interaction="off", stations=9, panels=32)
    found = solved(Hull(shape=submarine_strut()), [1.0], [HEAD], 0.0, settings)
    assert np.all(np.isfinite(found.added_mass.values))
    assert np.all(np.isfinite(found.excitation_force.values))
    group = strip_bodies(Hull(shape=submarine_strut()), 9, 32, False)[0].groups[0]
    top = group.sections.segments.z[0].max()
    assert -1.5 < top < -1.2
    heave = np.einsum("p,p->", group.panels.normal_z[0], group.panels.length[0])
    assert heave == pytest.approx(0.0, abs=1e-9)


def test_a_transom_at_the_surface_has_no_end_terms():
    settings = replace(COARSE, transom="dry")
    dry = solved(ONE, 1.0, HEAD, 6.0, settings)
    wet = solved(ONE, 1.0, HEAD, 6.0, replace(COARSE, transom="wet"))
    heave = dry.radiation_damping.values[0, 0, 2, 2] / wet.radiation_damping.values[0, 0, 2, 2]
    assert heave == pytest.approx(1.0, abs=1e-3)


def test_transoms_of_two_hulls_solved_together_are_those_of_each():
    """In waves so short that the added mass of a hull hardly feels the other."""
    far = Hull(shape=DELFT.shape, count=2, spacing=6.0)
    ends = []
    for interaction in ("on", "off"):
        settings = StripSettings(stations=15, panels=32, interaction=interaction)
        wet, dry = (
            solved(far, 25.0, BEAM, 2.5, replace(settings, transom=choice)).radiation_damping.values
            for choice in ("wet", "dry")
        )
        ends.append((dry - wet)[0, 0, 2:5:2, 2:5:2])
    np.testing.assert_allclose(ends[0], ends[1], rtol=0.04)


def test_each_hull_of_a_joint_body_has_its_own_transom_and_ends_there():
    """The centre hull lies ahead of the outer ones: its forces begin at its own transom, not a station before."""
    trimaran = Hull(shape=DELFT.shape, count=3, spacing=2.0, centre_x=0.5)
    (body,) = strip_bodies(trimaran, 41, 32, True)
    draught = sections(DELFT)[0].draughts[0]
    found = []
    for transom in body.transoms:
        group = body.groups[transom.group]
        assert transom.draught == pytest.approx(draught, rel=1e-6)
        y = group.panels.y[transom.row, transom.columns]
        station = group.stations[transom.row]
        found.append((body.x[station], y.mean()))
        assert station == 0 or body.x[station] - body.x[station - 1] < 1e-4
    aft = sections(DELFT)[0].x[0]
    np.testing.assert_allclose(found, [(aft, 1.0), (aft, -1.0), (aft + 0.5, 0.0)], atol=1e-9)
    apart = sum(volume(one) for one in strip_bodies(trimaran, 41, 32, False))
    assert volume(body) == pytest.approx(apart, rel=2e-3)
    assert apart == pytest.approx(float(hydrostatics(trimaran, 1.0).displacement), rel=0.006)


def volume(body):
    """Volume under water of a body of strips."""
    areas = ((group, group.panels.z * group.panels.normal_z * group.panels.length) for group in body.groups)
    return sum(np.sum(weights(body.x)[group.stations] * area.sum(axis=-1)) for group, area in areas)


def test_hulls_together_are_solved_at_every_frequency_met():
    """Their resonances are sharper than a curve through a few frequencies."""
    omega, directions = np.linspace(1.0, 3.0, 5), [HEAD, 2.4]
    settings = StripSettings(interaction="on", stations=5, panels=8, frequencies=8)
    found = solved(TWIN, omega, directions, 3.0, settings)
    for row in range(5):
        for column in range(2):
            one = solved(TWIN, omega[row], directions[column], 3.0, settings)
            np.testing.assert_allclose(
                found.added_mass.values[row, column], one.added_mass.values[0, 0], rtol=1e-6, atol=1e-3
            )


def test_the_stem_of_a_hull_has_the_sway_of_a_plate():
    """Half of pi rho T^2, the added mass of a plate 2 T high in unbounded water, at low frequency."""
    (body,) = strip_bodies(ONE, 9, 32, False)
    (group,) = body.groups
    assert len(group.stations) == 9
    potential = radiation_potentials(group.sections, np.array([1e-5]))
    sway = sectional_matrix(group.panels, potential)[0, :, 0, 0].real
    assert sway[0] == pytest.approx(np.pi / 2 * WIGLEY.draught**2, rel=0.08)
    assert sway[-1] == pytest.approx(sway[0], rel=1e-6)


def test_the_transom_runs_dry_by_its_own_froude_number():
    draught = max(one.draughts[0] for one in sections(DELFT))
    limit = 2.5 * np.sqrt(GRAVITY * draught)
    for speed, other in ((0.95 * limit, "wet"), (1.05 * limit, "dry")):
        chosen = solved(DELFT, 4.0, HEAD, speed).radiation_damping.values
        same = solved(DELFT, 4.0, HEAD, speed, replace(COARSE, transom=other)).radiation_damping.values
        np.testing.assert_array_equal(chosen, same)


# --- waves


def test_froude_krylov_forces_are_those_of_the_panels():
    hull = Hull(shape=WIGLEY, count=2, spacing=10.0)
    omega, directions = np.array([0.6, 1.2]), np.radians([180.0, 130.0, 60.0])
    problem = RadiationProblem(panels=panels(hull, 1200), lid=lid_panels(hull))
    known = forward_speed.hydrodynamics(
        [RadiatingBody(radiation(problem, [0.9]))], omega, directions, 0.0, DENSITY
    ).froude_krylov_force.values
    found = solved(hull, omega, directions, settings=ALONE).froude_krylov_force.values
    for mode, name in enumerate(MODES):
        scale = np.abs(known[..., mode]).max()
        np.testing.assert_allclose(found[..., mode], known[..., mode], atol=0.006 * scale, err_msg=name)


def test_headings_to_port_and_starboard_mirror_each_other():
    found = solved(TWIN, [1.0], [2.2, -2.2], 4.0).excitation_force.values[0]
    np.testing.assert_allclose(found[1], found[0] * [1, -1, 1, -1, 1, -1], atol=1e-9 * np.abs(found).max())


def test_waves_overtaken_by_the_ship_join_those_that_overtake_it():
    """Radiation and excitation are continuous where the encounter frequency goes through zero."""
    speed = 12.0
    crossing = GRAVITY / speed
    omega = crossing * np.array([0.97, 1.03])
    found = solved(ONE, omega, [0.0], speed)
    met = found.encounter_frequency.values[:, 0]
    assert met[0] > 0 > met[1]
    force = np.abs(found.excitation_force.values[:, 0, 2])
    assert force[1] == pytest.approx(force[0], rel=0.1)
    assert found.added_mass.values[1, 0, 2, 2] == pytest.approx(found.added_mass.values[0, 0, 2, 2], rel=0.1)
    assert any("overtakes" in line for line in warnings_of(found))
    far = solved(ONE, [1.4 * crossing], [0.0], speed)
    twin = solved(ONE, [abs(far.encounter_frequency.values[0, 0])], [BEAM], 0.0)
    np.testing.assert_allclose(
        far.added_mass.values[0, 0, 2, 2], twin.added_mass.values[0, 0, 2, 2], rtol=1e-9
    )
    np.testing.assert_allclose(
        far.radiation_damping.values[0, 0, 2, 2], twin.radiation_damping.values[0, 0, 2, 2], rtol=1e-9
    )


def test_sections_solved_at_few_frequencies_serve_all_others():
    omega, directions = np.linspace(2.0, 11.0, 12), np.radians([180.0, 150.0, 110.0, 40.0])
    speed = 1.0
    few = solved(DELFT, omega, directions, speed, replace(COARSE, frequencies=40))
    many = solved(DELFT, omega, directions, speed, replace(COARSE, frequencies=200))
    for name in ("added_mass", "radiation_damping", "excitation_force"):
        scale = np.abs(many[name].values).max(axis=(0, 1))
        away = np.abs(few[name].values - many[name].values) / np.maximum(scale, 1e-12 * scale.max())
        assert away.max() < 2e-3, name


def test_long_waves_carry_the_ship():
    displacement = float(hydrostatics(TWIN, DENSITY).displacement)
    masses = replace(
        named_design("delft-372").masses,
        mass=displacement,
        centre_of_gravity=(0.0, 0.0, 1.0),
        roll_gyradius=5.0,
        pitch_gyradius=10.0,
        yaw_gyradius=10.0,
    )
    omega = np.array([0.05, 0.1])
    stiffness = stiffness_matrix(TWIN, masses, DENSITY)
    found = motions(solved(TWIN, omega, [HEAD, 2.2], 3.0, ALONE), masses, stiffness)
    rao, slope = found.motion_rao.values, found.wavenumber.values[:, None]
    np.testing.assert_allclose(np.abs(rao[..., 2]), 1.0, atol=0.01)
    direction = found.wave_direction.values
    np.testing.assert_allclose(rao[..., 4] / (-1j * slope * np.cos(direction)), 1.0, atol=0.02)
    np.testing.assert_allclose(rao[:, 1, 3] / (1j * slope[:, 0] * np.sin(2.2)), 1.0, atol=0.02)


def test_slender_hull_at_rest_against_the_panel_method():
    """Short waves on a hull of L/B = 20, where strips are the limit of slender-body theory."""
    hull = Hull(shape=Wigley(length=40.0, beam=2.0, draught=1.0, depth=3.0))
    omega = np.array([2.4, 3.0])
    problem = RadiationProblem(panels=panels(hull, 900), lid=lid_panels(hull))
    known = forward_speed.hydrodynamics(
        [RadiatingBody(radiation(problem, omega))], omega, [HEAD, BEAM], 0.0, DENSITY
    )
    found = solved(hull, omega, [HEAD, BEAM], settings=ALONE)
    for mode, tolerance in ((2, 0.05), (4, 0.09)):
        near, far = (
            omega**2 * one.added_mass.values[:, 0, mode, mode]
            + 1j * omega * one.radiation_damping.values[:, 0, mode, mode]
            for one in (found, known)
        )
        assert np.abs(near / far - 1).max() < tolerance
    beam = found.excitation_force.values[:, 1, 2] / known.excitation_force.values[:, 1, 2]
    assert np.abs(beam - 1).max() < 0.06


# --- settings


def test_settings_and_what_they_warn_of():
    assert StripSettings().interacts(2, 0.0, 40.0)
    assert not StripSettings().interacts(2, 8.0, 40.0)
    assert not StripSettings(interaction="on").interacts(1, 0.0, 40.0)
    text = " ".join(validity_warnings(StripSettings(), 2, 9.0, 40.0))
    assert "Fn 0.45" in text
    assert "solved alone" in text
    assert "heave-only" not in text
    assert "too sharp" in " ".join(validity_warnings(StripSettings(), 2, 0.0, 40.0))


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"panels": 9}, "even"),
        ({"stations": 3}, "stations"),
        ({"frequencies": 9.5}, "whole number"),
        ({"transom": "damp"}, "transom"),
        ({"formulation": "heave-only", "interaction": "on"}, "interaction"),
    ],
)
def test_bad_settings_are_refused(more, words):
    with pytest.raises(InputError, match=words):
        StripSettings(**more)


def test_bad_waves_are_refused():
    with pytest.raises(InputError, match="omega"):
        solved(ONE, 0.0, HEAD)
    with pytest.raises(InputError, match="speed"):
        solved(ONE, 1.0, HEAD, -1.0)
