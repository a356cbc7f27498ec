from dataclasses import replace

import numpy as np
import pytest

from workbench.conventions import GRAVITY, MODES, wavenumber
from workbench.damping.additions import additions
from workbench.damping.normal_flow import force_set
from workbench.damping.sail_damping import sail_damping
from workbench.design import Foil, MassProperties
from workbench.errors import InputError
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.geometry.panels import lid_panels, panels
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hydrodynamics.forward_speed import RadiatingBody, hydrodynamics
from workbench.hydrodynamics.radiation import RadiationProblem, radiation
from workbench.motions import (
    acceleration,
    interpolated_motions,
    lead_over_wave,
    mass_matrix,
    motions,
    motions_at,
    roll_damping,
    translation_matrix,
    velocity,
)
from workbench.relative_motion import material_velocity, relative_motion
from workbench.sails import TrueWind, tapered_sail_plan

LONG = np.array([0.12, 0.2])
DIRECTIONS = np.radians([180.0, 135.0, 90.0, 0.0])


@pytest.fixture(scope="module")
def solved(twin):
    problem = RadiationProblem(
        panels=panels(twin.hull, 400),
        lid=lid_panels(twin.hull),
        field_x=(-20.0, -10.0, 0.0, 10.0, 20.0),
        field_y=(-2.5, 0.0, 2.5),
    )
    return radiation(problem, [0.12, 0.2, 0.6, 0.9, 1.2], DIRECTIONS)


def moving(twin, solved, omega, directions, speed=0.0, masses=None):
    masses = masses or twin.masses
    found = hydrodynamics([RadiatingBody(solved)], omega, directions, speed, 1025.0)
    return motions(found, masses, stiffness_matrix(twin.hull, masses, 1025.0))


def test_long_waves_carry_the_ship_along(twin, solved):
    """Heave 1, pitch = slope, surge and sway of the particles at the centre of gravity, roll = slope."""
    found = moving(twin, solved, LONG, DIRECTIONS)
    for i, omega in enumerate(LONG):
        k = wavenumber(omega)
        for j, beta in enumerate(DIRECTIONS):
            surge, sway, heave, roll, pitch, yaw = found.motion_rao.values[i, j]
            assert heave == pytest.approx(1.0, abs=0.02)
            assert pitch == pytest.approx(-1j * k * np.cos(beta), abs=0.05 * k)
            assert roll == pytest.approx(1j * k * np.sin(beta), abs=0.05 * k)
            assert surge == pytest.approx(1j * np.cos(beta), abs=0.03)
            assert sway == pytest.approx(1j * np.sin(beta), abs=0.03)
            assert abs(yaw) < k


def test_long_waves_leave_the_deck_dry(twin, solved):
    deck = wet_deck_grid(twin.wet_deck, 6, 3)
    found = moving(twin, solved, LONG, DIRECTIONS)
    scattered = solved.isel(encounter_omega=[0, 1])
    for field in (None, scattered):
        relative = relative_motion(found, deck, field)
        assert float(np.abs(relative.relative_motion[0]).max()) < 0.03
        assert float(np.abs(relative.relative_velocity[0]).max()) < 0.03 * LONG[0]


def test_long_waves_at_speed_too(twin, solved):
    found = moving(twin, solved, LONG[:1], DIRECTIONS[:1], speed=3.0)
    k = wavenumber(LONG[0])
    assert found.motion_rao.values[0, 0, 2] == pytest.approx(1.0, abs=0.03)
    assert found.motion_rao.values[0, 0, 4] == pytest.approx(1j * k, abs=0.1 * k)


def test_lead_is_counted_from_the_wave_at_the_centre_of_gravity(twin, solved):
    found = moving(twin, solved, LONG[:1], DIRECTIONS[:1])
    lead = np.degrees(lead_over_wave(found).values[0, 0])
    # In head seas a crest comes from ahead: the bow is up (pitch negative) a quarter period before it arrives
    # amidships, so pitch (bow down) leads by -90 degrees; surge (towards -x under a crest) likewise.
    assert lead[2] == pytest.approx(0, abs=2)
    assert lead[4] == pytest.approx(-90, abs=3)


def test_phase_does_not_depend_on_where_the_origin_is(twin, solved):
    """A ship moved 5 m forward in its axes moves alike, and its lead over the wave at its centre of gravity stays."""
    omega, directions = np.array([0.9]), DIRECTIONS[1:2]
    found = hydrodynamics([RadiatingBody(solved)], omega, directions, 0.0, 1025.0)
    moved = hydrodynamics([RadiatingBody(solved, 5.0)], omega, directions, 0.0, 1025.0)
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)
    shift = translation_matrix((5.0, 0, 0))
    further = MassProperties(**{**twin.masses.as_dict(), "centre_of_gravity": (5.0, 0.0, 1.0)})
    here = motions(found, twin.masses, stiffness)
    there = motions(moved, further, shift.T @ stiffness @ shift)
    np.testing.assert_allclose(np.abs(there.motion_rao), np.abs(here.motion_rao), rtol=1e-6)
    np.testing.assert_allclose(lead_over_wave(there), lead_over_wave(here), atol=1e-6)


def test_motion_at_a_point_has_its_lever_arms(twin, solved):
    found = moving(twin, solved, [0.9], DIRECTIONS[1:2])
    surge, sway, heave, roll, pitch, yaw = found.motion_rao.values[0, 0]
    lever = np.array([7.0, -2.0, 3.0])
    at_point = motions_at(found, lever + np.array([0, 0, 1.0])).values[0, 0]
    turning = np.cross([roll, pitch, yaw], lever)
    np.testing.assert_allclose(at_point[:3], np.array([surge, sway, heave]) + turning)
    np.testing.assert_allclose(at_point[3:], [roll, pitch, yaw])
    assert at_point[2] == pytest.approx(heave - 7 * pitch - 2 * roll)


def test_velocity_and_acceleration_are_time_derivatives(twin, solved):
    found = moving(twin, solved, [0.9], DIRECTIONS[:1], speed=3.0)
    met = float(found.encounter_frequency[0, 0])
    times = np.linspace(0, 8, 4001)
    phasors = [found.motion_rao, velocity(found.motion_rao, found.encounter_frequency)]
    phasors.append(acceleration(found.motion_rao, found.encounter_frequency))
    place, speed, change = ((part.values[0, 0, 2] * np.exp(-1j * met * times)).real for part in phasors)
    np.testing.assert_allclose(np.gradient(place, times)[1:-1], speed[1:-1], atol=1e-5)
    np.testing.assert_allclose(np.gradient(speed, times)[1:-1], change[1:-1], atol=1e-5)


def test_material_velocity_differs_by_the_drift_over_the_slope(twin, solved):
    """(d/dt - U d/dx): ship-surface velocity minus particle velocity (Grande 2002, 4.18)."""
    found = moving(twin, solved, [0.9], DIRECTIONS[:1], speed=3.0)
    deck = wet_deck_grid(twin.wet_deck, 200, 1)
    plain = relative_motion(found, deck)
    rise = plain.relative_motion.values[0, 0, :, 0]
    along = np.gradient(rise, deck.x.values)
    met = float(found.encounter_frequency[0, 0])
    expected = -1j * met * rise - 3.0 * along
    np.testing.assert_allclose(material_velocity(plain).values[0, 0, 2:-2, 0], expected[2:-2], atol=1e-3)
    np.testing.assert_allclose(plain.relative_slope.values[0, 0, 2:-2, 0], along[2:-2], atol=1e-4)


def test_mass_matrix_is_the_repaired_one(twin):
    mass = mass_matrix(twin.masses)
    m, z = twin.masses.mass, 1.0
    assert mass[3, 3] == pytest.approx(m * (4.5**2 + z**2))
    assert mass[4, 4] == pytest.approx(m * (10.0**2 + z**2))
    assert mass[0, 4] == pytest.approx(m * z)
    assert mass[1, 3] == pytest.approx(-m * z)
    assert mass[2, 4] == 0
    np.testing.assert_allclose(mass, mass.T)


def test_roll_damping_of_a_ratio_halves_resonance_as_an_oscillator(twin, solved):
    """At roll resonance in beam seas, damping is the radiated plus 2 ratio sqrt(I C)."""
    damped = MassProperties(**{**twin.masses.as_dict(), "roll_damping_ratio": 0.1})
    stiffness = stiffness_matrix(twin.hull, damped, 1025.0)
    added = np.zeros((6, 6))
    found = roll_damping(damped, stiffness, added)
    about_centre = np.linalg.inv(translation_matrix(damped.centre_of_gravity))
    inertia, restoring = damped.mass * 4.5**2, stiffness[3, 3]
    assert (about_centre.T @ found @ about_centre)[3, 3] == pytest.approx(
        0.2 * np.sqrt(inertia * restoring), rel=1e-6
    )
    free, held = (moving(twin, solved, [0.6, 0.9, 1.2], [np.pi / 2], masses=m) for m in (twin.masses, damped))
    assert float(np.abs(held.motion_rao.sel(dof="roll")).max()) < float(
        np.abs(free.motion_rao.sel(dof="roll")).max()
    )


def test_interpolation_keeps_the_table_and_the_fast_phase(twin, solved):
    found = moving(twin, solved, [0.6, 0.9, 1.2], DIRECTIONS[:1])
    at_nodes = interpolated_motions(found, np.array([0.6, 1.2]))
    np.testing.assert_allclose(at_nodes[:, 0], found.motion_rao.values[[0, 2], 0])


def test_natural_frequency_of_heave_is_where_the_response_turns(twin, solved):
    """Phase of heave against its exciting force passes -90 degrees at sqrt(C/(m+A)) for a symmetric hull."""
    found = hydrodynamics([RadiatingBody(solved)], [0.9], [np.pi], 0.0, 1025.0)
    added = float(found.added_mass.values[0, 0, 2, 2])
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)[2, 2]
    natural = np.sqrt(stiffness / (twin.masses.mass + added))
    assert 0.5 * np.sqrt(GRAVITY / 2.0) < natural < np.sqrt(GRAVITY / 1.0)


def coefficients(solved, speed=0.0, omega=(0.6, 0.9, 1.2), directions=DIRECTIONS[1:3]):
    return hydrodynamics([RadiatingBody(solved)], np.array(omega), directions, speed, 1025.0)


AWRY = {"centre_of_gravity": (1.0, 0.5, 2.0)}


def test_locked_modes_are_still_at_the_centre_of_gravity(twin, solved):
    """Exactly zero there, and the others move as by the equations without their rows and columns."""
    masses = MassProperties(**{**twin.masses.as_dict(), **AWRY})
    stiffness = stiffness_matrix(twin.hull, masses, 1025.0)
    found = motions(coefficients(solved), masses, stiffness, locked=("heave", "roll", "surge"))
    rao = found.motion_rao.values
    assert not rao[..., [0, 2, 3]].any()
    to_origin = np.linalg.inv(translation_matrix(masses.centre_of_gravity))
    given = coefficients(solved)
    for i, j in np.ndindex(3, 2):
        met = float(given.encounter_frequency[i, j])
        damping = given.radiation_damping.values[i, j] + roll_damping(
            masses, stiffness, given.added_mass.values[i, j]
        )
        system = -(met**2) * (mass_matrix(masses) + given.added_mass.values[i, j]) - 1j * met * damping
        about_centre = to_origin.T @ (system + stiffness) @ to_origin
        force = to_origin.T @ given.excitation_force.values[i, j]
        free = [1, 4, 5]
        expected = np.linalg.solve(about_centre[np.ix_(free, free)], force[free])
        np.testing.assert_allclose(rao[i, j, free], expected, rtol=1e-9)
    assert found.attrs["locked"] == "surge, heave, roll"
    assert "Surge and heave and roll held at zero" in found.attrs["warnings"]


@pytest.mark.parametrize(
    ("locked", "sentence"),
    [
        (("rol",), "locked mode must be one of"),
        ("roll", "locked must be a list"),
        (MODES, "leave one mode free"),
    ],
)
def test_modes_that_cannot_be_locked_are_refused(twin, solved, locked, sentence):
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)
    with pytest.raises(InputError, match=sentence):
        motions(coefficients(solved), twin.masses, stiffness, locked=locked)


def test_additions_enter_as_their_names_say(twin, solved):
    """As a change of the coefficients does, whether they depend on the waves or not."""
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)
    given = coefficients(solved)
    size = given.added_mass.shape
    random = np.random.default_rng(7)
    scale = np.abs(given.added_mass.values).max()
    added, springs = scale * random.normal(size=(6, 6)), scale * random.normal(size=(6, 6))
    damping = scale * random.normal(size=size)
    force = scale * random.normal(size=size[:3]).astype(complex)
    waves = given.omega, given.wave_direction
    parts = (
        force_set(*waves, method="a", warnings=["A sentence."], added_mass=added, stiffness=springs),
        force_set(*waves, method="b", damping=damping / 2, excitation_force=force),
        force_set(*waves, method="c", damping=damping / 2),
    )
    found = motions(given, twin.masses, stiffness, additions=parts)
    changed = given.copy(deep=True)
    changed["radiation_damping"] += damping
    changed["excitation_force"] += force
    met = given.encounter_frequency.values[..., None, None]
    # a constant stiffness less omega_e**2 A, given as damping of the same force
    changed["radiation_damping"] = (
        changed.radiation_damping.dims,
        changed.radiation_damping.values + 1j * (springs - met**2 * added) / met,
    )
    expected = motions(changed, twin.masses, stiffness)
    np.testing.assert_allclose(found.motion_rao, expected.motion_rao, rtol=1e-8)
    assert "A sentence." in found.attrs["warnings"]


def test_additions_for_other_waves_are_refused(twin, solved):
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)
    other = force_set([0.5], DIRECTIONS[1:3], method="sails", damping=np.zeros((1, 2, 6, 6)))
    with pytest.raises(InputError, match="damping of sails must be for the waves"):
        motions(coefficients(solved), twin.masses, stiffness, additions=(other,))


def test_sails_and_foils_of_a_design_are_gathered_and_damp(twin, solved):
    given = coefficients(solved, speed=3.0)
    plan = tapered_sail_plan(12.0, 2.0, 3.0, 40.0, 1.2)
    foil = Foil(name="T-foil", area=6.0, span=4.0, position=(15.0, 0.0, -3.0))
    design = replace(twin, sail_plan=plan, appendages=(foil,))
    wind = TrueWind(speed=8.0, direction=np.radians(135.0))
    parts = additions(design, given, wind=wind)
    assert [one.attrs["method"] for one in parts] == ["lifting surfaces", "sails"]
    assert additions(twin, given) == ()
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)
    bare = motions(given, twin.masses, stiffness)
    sails = (sail_damping(plan, wind, 3.0, given.omega, given.wave_direction),)
    sailing = motions(given, twin.masses, stiffness, additions=sails)
    beam = {"wave_direction": 1, "dof": 3}
    assert float(np.abs(sailing.motion_rao.isel(beam)).max()) < float(
        np.abs(bare.motion_rao.isel(beam)).max()
    )
    foiled = motions(given, twin.masses, stiffness, additions=parts[:1])
    pitch = {"wave_direction": 0, "dof": 4}
    assert float(np.abs(foiled.motion_rao.isel(pitch)).max()) < float(
        np.abs(bare.motion_rao.isel(pitch)).max()
    )


@pytest.mark.parametrize(
    ("sign", "words"), [(1.0, ""), (-0.01, "A: in 6 of 6 waves the damping puts energy in")]
)
def test_damping_that_feeds_the_motion_is_told(twin, solved, sign, words):
    stiffness = stiffness_matrix(twin.hull, twin.masses, 1025.0)
    given = coefficients(solved)
    part = force_set(given.omega, given.wave_direction, method="a", damping=sign * 1e5 * np.eye(6))
    said = motions(given, twin.masses, stiffness, additions=(part,)).attrs["warnings"]
    assert words in said
    assert ("puts energy" in said) == bool(words)
