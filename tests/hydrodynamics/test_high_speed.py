"""High-speed theory: long cylinders, hulls in every arrangement, speed, waves, limits, and what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from workbench import designs
from workbench.conventions import GRAVITY, encounter_frequency
from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.hydrodynamics import high_speed, strip_theory
from workbench.hydrodynamics.high_speed_hulls import stationed
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings, tau, validity_warnings
from workbench.hydrodynamics.section_contours import section_coefficients, section_wave_forces
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.quantities import warnings_of
from workbench.shapes import Wigley
from workbench.verification import published
from workbench.verification.cylinder_march import amplitudes, extrapolated
from workbench.verification.section_cases import half_circle

SWAY, HEAVE, ROLL = range(3)
HEAD, BEAM = np.pi, np.pi / 2
DELFT = designs.named_design("delft-372").hull
ONE = Hull(shape=Wigley(length=40.0, beam=4.0, draught=2.0, depth=8.0))
TWIN = replace(ONE, count=2, spacing=10.0)
COARSE = HighSpeedSettings(stations=40, panels=12)
ALONE, TOGETHER = replace(COARSE, interaction="off"), replace(COARSE, interaction="on")
DENSITY = 1000.0
NAMES = ("added_mass", "radiation_damping", "froude_krylov_force", "diffraction_force")


def speed_of(hull, froude_number):
    return froude_number * np.sqrt(GRAVITY * hull.length)


def solved(hull, omega, directions, froude_number=0.5, settings=COARSE):
    return high_speed.hydrodynamics(
        hull,
        DENSITY,
        np.atleast_1d(omega),
        np.atleast_1d(directions),
        speed_of(hull, froude_number),
        settings,
    )


def matrix_of(found, row=0, column=0):
    """Added mass and damping together, omega^2 A + i omega B of one wave."""
    met = float(found.encounter_frequency[row, column])
    return (
        met**2 * found.added_mass.values[row, column] + 1j * met * found.radiation_damping.values[row, column]
    )


def assert_same(a, b, tolerance, columns=slice(None)):
    for name in NAMES:
        known = b[name].values[:, columns]
        for mode in range(6):
            scale = np.abs(known).max(axis=(0, 1))
            np.testing.assert_allclose(
                a[name].values[:, columns][..., mode],
                known[..., mode],
                atol=tolerance * scale.max(),
                err_msg=name,
            )


# --- a long cylinder is its section


def test_far_from_its_bow_a_cylinder_moves_the_water_of_the_multipole_solution():
    table = published.columns("ursell_1949_half_immersed_cylinder")
    for ka, tolerance, found in (
        ((1.0, 2.0), 0.025, extrapolated((1.0, 2.0), (HEAD, 2.2, BEAM))),
        ((0.5,), 0.05, amplitudes((0.5,), half_width=60.0)),
    ):
        rows = np.searchsorted(table["ka"], ka)
        scale = np.pi / 2 * np.ones(len(ka))
        per_omega = scale * np.sqrt(GRAVITY * np.array(ka))
        for name, values in (
            ("A33", found.added_mass[:, HEAVE, HEAVE] / scale),
            ("B33", found.damping[:, HEAVE, HEAVE] / per_omega),
            ("A22", found.added_mass[:, SWAY, SWAY] / scale),
            ("B22", found.damping[:, SWAY, SWAY] / per_omega),
        ):
            np.testing.assert_allclose(values, table[name][rows], rtol=tolerance, err_msg=name)
        assert np.abs(found.added_mass[:, HEAVE, SWAY]).max() < 1e-9


def test_far_from_its_bow_a_cylinder_scatters_waves_as_its_section():
    """At the wave's own frequency, which is what a cross-plane at rest sees."""
    ka, directions = (1.0, 2.0), (HEAD, 2.2, BEAM)
    found = extrapolated(ka, directions).diffraction
    for column, direction in enumerate(directions):
        known = section_wave_forces(
            [half_circle()], np.sqrt(GRAVITY * np.array(ka)), direction, density=1.0, panels=100
        ).diffraction
        scale = np.abs(known[:, :2]).max(axis=1)[:, None]
        assert np.abs((found[:, column] - known)[:, :2] / scale).max() < 0.02


@pytest.mark.parametrize(("half_spacing", "ka"), [(1.5, 2.0), (2.0, 1.0)])
def test_two_long_cylinders_feel_each_other_as_their_sections_do(half_spacing, ka):
    found = extrapolated((ka,), (HEAD, 2.2), half_spacing=half_spacing)
    omega = np.sqrt(GRAVITY * ka)
    table = published.columns("wang_1971_twin_cylinders", b_over_a=half_spacing, ka=ka)
    assert found.added_mass[0, HEAVE, HEAVE] / np.pi == pytest.approx(table["A33"][0], rel=0.03)
    assert found.damping[0, HEAVE, HEAVE] / (np.pi * omega) == pytest.approx(table["B33"][0], rel=0.06)
    section = [half_circle(half_spacing)]
    known = section_coefficients(section, [omega], density=1.0, mirrored=True, panels=100)
    size = known.added_mass[0] - 1j * known.damping[0] / omega
    scale = np.sqrt(np.outer(np.abs(np.diag(size)), np.abs(np.diag(size))))
    difference = found.added_mass[0] - 1j * found.damping[0] / omega - size
    assert np.abs(difference / scale).max() < 0.035
    for column, direction in enumerate((HEAD, 2.2)):
        force = section_wave_forces(section, [omega], direction, density=1.0, mirrored=True, panels=100)
        away = np.abs(found.diffraction[0, column] - force.diffraction[0])
        assert away.max() < 0.035 * np.abs(force.diffraction).max()


# --- arrangements of hulls


@pytest.mark.parametrize("settings", [ALONE, TOGETHER, COARSE], ids=["apart", "together", "auto"])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_halves_of_an_upright_ship_give_what_the_whole_plane_gives(count, settings):
    """A heel of no size forbids the mirror."""
    if count == 1 and settings is not ALONE:
        pytest.skip("one hull has nothing to interact with")
    centre = Wigley(length=44.0, beam=3.0, draught=1.5, depth=8.0) if count == 3 else None
    hull = replace(TWIN, count=count, spacing=0.0 if count == 1 else 14.0, centre_shape=centre)
    omega, directions = [0.9, 1.6], [HEAD, np.radians(130)]
    upright = solved(hull, omega, directions, settings=settings)
    whole = solved(replace(hull, heel=1e-9), omega, directions, settings=settings)
    assert stationed(hull, 40, 12).upright
    assert not stationed(replace(hull, heel=1e-9), 40, 12).upright
    assert_same(upright, whole, 2e-3)


def test_an_upright_ship_has_no_roll_in_head_seas_and_a_heeled_one_has():
    upright, heeled = (
        np.abs(solved(replace(TWIN, heel=np.radians(heel)), 1.2, HEAD).excitation_force.values[0, 0])
        for heel in (0.0, 5.0)
    )
    assert upright[[1, 3, 5]].max() < 1e-9 * upright[2]
    assert heeled[3] > 0.1 * heeled[2]
    couplings = solved(replace(TWIN, heel=np.radians(5.0)), 1.2, HEAD).added_mass.values[0, 0]
    assert abs(couplings[2, 3]) > 0.02 * np.sqrt(couplings[2, 2] * couplings[3, 3])


def test_a_flying_hull_is_left_out():
    shallow = Wigley(length=40.0, beam=2.0, draught=0.5, depth=8.0)
    flying = Hull(shape=shallow, count=2, spacing=12.0, heel=np.radians(12.0), sinkage=-0.2)
    stations = stationed(flying, 40, 12)
    assert len(stations.hulls) == 1
    force = np.abs(solved(flying, 1.2, HEAD).excitation_force.values[0, 0])
    assert force[3] == pytest.approx(abs(stations.hulls[0].y) * force[2], rel=0.1)


def test_hulls_alone_are_the_sum_of_one_hull_and_its_lever():
    one, two = solved(ONE, 1.2, 2.2, settings=ALONE), solved(TWIN, 1.2, 2.2, settings=ALONE)
    a, b = matrix_of(one), matrix_of(two)
    y = TWIN.spacing / 2
    for j, k in ((1, 1), (2, 2), (4, 4), (2, 4), (4, 2), (1, 5), (5, 5), (1, 3), (3, 1)):
        assert b[j, k] == pytest.approx(2 * a[j, k], rel=1e-9), (j, k)
    assert b[3, 3] == pytest.approx(2 * (a[3, 3] + y**2 * a[2, 2]), rel=1e-9)
    phase = np.exp(1j * 1.2**2 / GRAVITY * y * np.sin(2.2))
    single = one.diffraction_force.values[0, 0]
    known = single * (phase + 1 / phase)
    known[3] += y * single[2] * (phase - 1 / phase)
    np.testing.assert_allclose(two.diffraction_force.values[0, 0, 1:], known[1:], rtol=1e-9)


def test_a_trimaran_is_its_outer_and_its_centre_hull():
    centre = Wigley(length=60.0, beam=5.0, draught=3.0, depth=9.0)
    trimaran = Hull(shape=ONE.shape, count=3, spacing=16.0, centre_shape=centre, centre_x=4.0)
    fine = HighSpeedSettings(interaction="off")
    args = 1.1, 2.2, speed_of(ONE, 0.5)

    def found(hull):
        return high_speed.hydrodynamics(hull, DENSITY, [args[0]], [args[1]], args[2], fine)

    whole, outer, middle = found(trimaran), found(replace(TWIN, spacing=16.0)), found(Hull(shape=centre))
    expected = matrix_of(outer)[2, 2] + matrix_of(middle)[2, 2]
    assert matrix_of(whole)[2, 2] == pytest.approx(expected, rel=0.02)
    shifted = np.exp(1j * 1.1**2 / GRAVITY * 4.0 * np.cos(2.2)) * middle.excitation_force.values[0, 0, 2]
    force = outer.excitation_force.values[0, 0, 2] + shifted
    assert whole.excitation_force.values[0, 0, 2] == pytest.approx(force, rel=0.02)
    together = solved(trimaran, 1.1, 2.2, settings=TOGETHER)
    assert np.all(np.isfinite(together.excitation_force.values))
    assert abs(matrix_of(together)[2, 2] / matrix_of(whole)[2, 2] - 1) > 0.02


# --- interaction


def test_hulls_feel_each_other_at_the_spacing_of_the_delft_catamaran_and_not_far_apart():
    omega = 4.6  # tau 0.66 to 2 with U
    near = [matrix_of(solved(DELFT, omega, HEAD, 0.3, each))[2, 2] for each in (ALONE, TOGETHER, COARSE)]
    assert abs(near[1] / near[0] - 1) > 0.1
    assert abs(near[2] / near[0] - 1) > 0.01
    assert abs(near[2] / near[1] - 1) > 0.01
    far = replace(DELFT, spacing=6.0)
    apart, together, auto = (
        matrix_of(solved(far, omega, HEAD, 0.5, each)) for each in (ALONE, TOGETHER, COARSE)
    )
    assert auto[2, 2] == pytest.approx(apart[2, 2], rel=1e-9)
    assert together[2, 2] == pytest.approx(apart[2, 2], rel=0.05)


# --- scale, mirror, speed


def test_results_follow_froude_scaling():
    factor = 20.0
    model, ship = DELFT, DELFT.scaled(factor)
    omega, directions = np.array([3.0, 4.5]), [HEAD, 2.0]
    small = solved(model, omega, directions, 0.45)
    large = solved(ship, omega / np.sqrt(factor), directions, 0.45)
    length = np.array([0, 0, 0, 1, 1, 1])
    powers = 3 + length[:, None] + length
    for name, scale in (
        ("added_mass", factor**powers),
        ("radiation_damping", factor ** (powers - 0.5)),
        ("excitation_force", factor ** (2.0 + length)),
        ("froude_krylov_force", factor ** (2.0 + length)),
    ):
        found = large[name].values / scale
        np.testing.assert_allclose(found, small[name].values, atol=1e-6 * np.abs(small[name].values).max())
    np.testing.assert_allclose(
        large.stiffness_correction.values[0],
        small.stiffness_correction.values[0] * factor ** (powers - 1.0),
        rtol=1e-6,
        atol=1e-6,
    )


def test_waves_from_the_other_side_push_the_other_way():
    found = solved(TWIN, [0.8, 1.5], np.radians([130.0, -130.0, 230.0]))
    for name in ("froude_krylov_force", "diffraction_force", "excitation_force"):
        port, starboard, again = np.moveaxis(found[name].values, 1, 0)
        np.testing.assert_allclose(port[:, [0, 2, 4]], starboard[:, [0, 2, 4]], rtol=1e-9)
        np.testing.assert_allclose(port[:, [1, 3, 5]], -starboard[:, [1, 3, 5]], rtol=1e-9)
        np.testing.assert_allclose(again, starboard, rtol=1e-9)
        assert np.abs(port[:, [1, 3, 5]]).min() > 0
    # and as the whole plane, which knows no mirror, has them
    whole = solved(replace(TWIN, heel=1e-9), [0.8, 1.5], np.radians([130.0, -130.0, 230.0]))
    assert_same(found, whole, 2e-3)


def test_only_surge_of_the_undisturbed_wave_is_there():
    found = solved(TWIN, 1.0, [HEAD, 2.0])
    for name in ("added_mass", "radiation_damping"):
        assert not found[name].values[..., 0, :].any()
        assert not found[name].values[..., :, 0].any()
    assert not found.diffraction_force.values[..., 0].any()
    assert np.abs(found.froude_krylov_force.values[..., 0]).min() > 0


def test_froude_krylov_forces_are_those_of_strip_theory():
    """Another integration of the same pressure; no dry transom."""
    for hull in (replace(TWIN, heel=np.radians(4.0)), TWIN):
        fine = HighSpeedSettings(panels=24, transom="none")
        found = solved(hull, [0.8, 1.3], np.radians([180.0, 120.0]), 0.4, fine).froude_krylov_force.values
        known = strip_theory.hydrodynamics(
            hull, DENSITY, [0.8, 1.3], np.radians([180.0, 120.0]), speed_of(hull, 0.4), StripSettings()
        ).froude_krylov_force.values
        for mode in range(6):
            scale = np.abs(known[..., mode]).max() + 1e-4 * np.abs(known).max()
            np.testing.assert_allclose(
                found[..., mode], known[..., mode], atol=0.025 * scale, err_msg=str(mode)
            )


# --- another theory


def test_slender_hull_in_short_encounters_is_strip_theory():
    """What both must share: waves short beside the ship and slow ships; 5 % in heave, 8 % in the couplings."""
    slender = Hull(shape=Wigley(length=40.0, beam=2.0, draught=1.2, depth=5.0))
    omega = np.array([8.0, 10.0])
    speed = speed_of(slender, 0.3)
    march = high_speed.hydrodynamics(
        slender, DENSITY, omega, [BEAM], speed, HighSpeedSettings(stations=200, panels=32)
    )
    strips = strip_theory.hydrodynamics(slender, DENSITY, omega, [BEAM], speed, StripSettings())
    for row in range(2):
        a, b = matrix_of(march, row), matrix_of(strips, row)
        for j, k, tolerance in ((2, 2, 0.05), (4, 4, 0.06), (1, 1, 0.1), (5, 5, 0.1)):
            assert abs(a[j, k] / b[j, k] - 1) < tolerance, (j, k)
        scale = np.sqrt(np.abs(b[2, 2] * b[4, 4]))
        assert np.abs(a - b)[[2, 4], [4, 2]].max() < 0.08 * scale


# --- numbers of the march


def test_every_frequency_or_a_curve_through_enough():
    omega = np.linspace(0.5, 1.8, 40)
    steady = HighSpeedSettings(stations=150, panels=12)
    many = solved(ONE, omega, np.radians([180.0, 150.0]), 0.45, steady)
    for row in (0, 13, 39):
        one = solved(ONE, omega[row], [HEAD], 0.45, steady)
        scale = np.abs(matrix_of(one)).max()
        np.testing.assert_allclose(matrix_of(many, row), matrix_of(one), atol=0.01 * scale)


@pytest.mark.parametrize("change", [{"stations": 200}, {"panels": 40}])
def test_stations_and_panels_suffice(change):
    """Heave and pitch peaks of the Delft 372 move by less than 2 %."""
    from workbench import pipeline

    ship = designs.named_design("delft-372")
    omega = np.linspace(2.6, 5.2, 14)
    peaks = []
    for settings in (HighSpeedSettings(), HighSpeedSettings(**change)):
        motions = pipeline.response(ship, speed_of(DELFT, 0.45), [HEAD], omega, settings).motions
        heave, pitch = (np.abs(motions.motion_rao.values[:, 0, mode]) for mode in (2, 4))
        peaks.append([heave.max(), (pitch / motions.wavenumber.values).max()])
    np.testing.assert_allclose(peaks[0], peaks[1], rtol=0.02)


# --- limits


def test_low_speeds_and_overtaken_waves_are_refused():
    with pytest.raises(InputError, match=r"Froude number must be >= 0\.1"):
        solved(TWIN, 1.0, HEAD, 0.09)
    assert np.isfinite(solved(TWIN, 1.0, HEAD, 0.101).added_mass).all()
    with pytest.raises(InputError, match="overtak"):
        solved(TWIN, [0.8, 1.6], [0.0], 0.5)
    with pytest.raises(InputError, match="speed"):
        high_speed.hydrodynamics(TWIN, DENSITY, [1.0], [HEAD], 61.0)


@pytest.mark.parametrize(
    "given",
    [{"stations": 39}, {"panels": 81}, {"interaction": "some"}, {"transom": "wet"}, {"wave_field": "all"}],
)
def test_bad_settings_are_refused(given):
    with pytest.raises(InputError):
        HighSpeedSettings(**given)


def test_limits_are_said_in_words():
    found = solved(TWIN, [0.3, 1.0], [HEAD], 0.2, ALONE)
    words = " ".join(warnings_of(found))
    assert "Fn 0.20 is below 0.25" in words
    lowest = tau(np.array([0.3]), np.array([HEAD]), speed_of(TWIN, 0.2)).item()
    met = encounter_frequency(0.3, speed_of(TWIN, 0.2), HEAD)
    assert lowest == pytest.approx(speed_of(TWIN, 0.2) * met / GRAVITY)
    assert found.attrs["lowest_tau"] == pytest.approx(lowest)
    assert f"falls to {lowest:.2f}, below 0.25" in words
    assert "Each hull is solved alone" in words
    quiet = validity_warnings(COARSE, 1, speed_of(TWIN, 0.5), TWIN.length, 0.6)
    assert quiet == ()
    assert (
        "given first"
        in high_speed.hydrodynamics(TWIN, DENSITY, [1.0], [HEAD], 10.0, COARSE, warnings=("given first",))
        .attrs["warnings"]
        .split("\n")[0]
    )


@pytest.mark.parametrize("name", designs.names())
def test_every_ship_of_the_library_runs(name):
    ship = designs.named_design(name)
    length = ship.hull.length
    omega = np.sqrt(2 * np.pi * GRAVITY / (np.array([2.0, 1.0]) * length))
    found = high_speed.hydrodynamics(ship.hull, ship.density, omega, [HEAD], speed_of(ship.hull, 0.5), COARSE)
    for variable in (*NAMES, "stiffness_correction"):
        assert np.all(np.isfinite(found[variable].values)), variable
    assert np.all(found.radiation_damping.values[:, 0, 2, 2] > 0)
    left = stiffness_matrix(ship.hull, ship.masses, ship.density) + found.stiffness_correction.values[0]
    assert left[2, 2] > 0
    assert np.abs(found.excitation_force.values[:, 0, 2]).min() > 0


def test_a_hull_that_ends_at_the_surface_or_in_a_raked_stem_runs():
    box = designs.named_design("heavy-lift-198").hull
    for hull in (
        replace(ONE, trim=np.radians(-2.0)),  # the bow leaves the water
        replace(TWIN, trim=np.radians(2.0)),
        replace(box, trim=np.radians(1.0)),
        designs.named_design("austal-63").hull,
    ):
        found = solved(hull, np.sqrt(2 * np.pi * GRAVITY / hull.length), HEAD)
        assert np.all(np.isfinite(found.added_mass.values))
        assert float(found.radiation_damping[0, 0, 2, 2]) > 0
