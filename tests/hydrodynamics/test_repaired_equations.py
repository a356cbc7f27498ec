"""Equations that K. Grande's thesis (Curtin, 2002) prints damaged, against their derivation from what they stand on."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY, encounter_frequency, wavenumber
from workbench.design import Hull, MassProperties
from workbench.geometry.hydrostatics import hydrostatics, stiffness_matrix
from workbench.hydrodynamics import high_speed_march, incident_wave
from workbench.hydrodynamics.cross_plane import Water, passage
from workbench.hydrodynamics.high_speed_settings import tau
from workbench.hydrodynamics.marched_contour import Contour
from workbench.hydrodynamics.speed_terms import force_with_speed, with_speed
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.hydrodynamics.strip_theory import hydrodynamics
from workbench.motions import mass_matrix, motions, translation_matrix
from workbench.relative_motion import incident_elevation
from workbench.shapes import Wigley

HEAD, BEAM, BOW = np.pi, np.pi / 2, np.radians(140.0)
SPEED = 6.0
WIGLEY = Wigley(length=40.0, beam=4.0, draught=2.0, depth=5.0)
COARSE = StripSettings(interaction="off", stations=15, panels=16, transom="wet")
SURGE, SWAY, HEAVE, ROLL, PITCH, YAW = range(6)


def solved(hull, omega, direction, speed=0.0):
    return hydrodynamics(hull, 1025.0, np.atleast_1d(omega), np.atleast_1d(direction), speed, COARSE)


@pytest.mark.parametrize("direction", [0.3, BEAM, BOW])
def test_incident_potential_belongs_to_the_wave(direction):
    """A1.56: the elevation -(1/g) d(phi)/dt at z = 0 is that of a crest at the origin, which goes along beta."""
    omega, place = 0.9, np.array([[7.0, -3.0, 0.0], [0.0, 0.0, 0.0]])
    wave = incident_elevation(wavenumber(omega), direction, place[:, 0], place[:, 1])
    ours = incident_wave.incident_potential(place, omega, direction)
    np.testing.assert_allclose(1j * omega / GRAVITY * ours, wave, rtol=1e-12)  # exp(-i omega t)
    waves = high_speed_march.Waves(np.array([omega]), np.array([direction]), np.array([1.0]))
    for (x, y, z), known in zip(place, wave, strict=True):
        march = high_speed_march.incident_potential(np.array([y]), np.array([z]), x, waves)[0, 0]
        assert -1j * omega / GRAVITY * march == pytest.approx(np.conj(known))  # exp(+i omega t)
    assert (
        -1j * omega * GRAVITY / omega / GRAVITY
    ).real == 0  # without its i the force is a quarter period late


@pytest.fixture(scope="module")
def derived():
    """A1.84 and A1.94 by sums over sections, from integrals of n_j phi_k and n_j phi_D; exp(+i omega_e t).

    phi_5 = -x phi_3 + U/(i omega_e) phi_3, phi_6 = x phi_2 - U/(i omega_e) phi_2 (A1.69, A1.70), n_5 = -x n_3,
    n_6 = x n_2, m_5 = n_3, m_6 = -n_2.
    """
    rng = np.random.default_rng(3)
    met, steps, x = 1.7, 0.5, np.linspace(-9.0, 9.0, 37)
    own = rng.normal(size=(37, 3, 3)) + 1j * rng.normal(size=(37, 3, 3))
    own = own + own.transpose(0, 2, 1)
    scattered = rng.normal(size=(37, 3)) + 1j * rng.normal(size=(37, 3))
    ratio = SPEED / (1j * met)

    normal = np.zeros((37, 6, 3))  # n_j of the ship from sway, heave, roll of the section
    normal[:, SWAY, 0] = normal[:, HEAVE, 1] = normal[:, ROLL, 2] = 1.0
    normal[:, PITCH, 1], normal[:, YAW, 0] = -x, x
    along = np.zeros((6, 3))
    along[PITCH, 1], along[YAW, 0] = 1.0, -1.0
    at_rest = normal.astype(complex)
    moving = at_rest.copy()
    moving[:, PITCH, 1] += ratio
    moving[:, YAW, 0] -= ratio

    def force(potential):
        """-i omega_e int n phi + U int m phi - U (n phi) at the last section (x = -9)."""
        turned = -1j * met * normal @ potential + SPEED * along @ potential
        return steps * turned.sum(axis=0) - SPEED * (normal[0] @ potential[0])

    radiation = force(own @ moving.transpose(0, 2, 1))
    diffraction = force(scattered[:, :, None])[:, 0]
    rest = -1j * met * steps * (normal @ own @ at_rest.transpose(0, 2, 1)).sum(axis=0)
    line = -1j * met * normal[0] @ own[0] @ at_rest[0].T
    rest_d = -1j * met * steps * (normal @ scattered[:, :, None]).sum(axis=0)[:, 0]
    line_d = -1j * met * normal[0] @ scattered[0]
    return ratio, radiation, diffraction, rest, line, rest_d, line_d


def test_speed_terms_follow_from_their_derivation(derived):
    """A1.65-A1.88, all 36 of them, with the signs of T_6k and T_j6 that m_6 = -n_2 gives."""
    ratio, radiation, _, rest, line, _, _ = derived
    ours = np.conj(with_speed(np.conj(rest)[None], np.conj(line)[None], np.array([ratio]))[0])
    np.testing.assert_allclose(ours, radiation, rtol=1e-10, atol=1e-9)
    printed_6k = rest[YAW, HEAVE] - ratio * rest[SWAY, HEAVE] + ratio * line[YAW, HEAVE]
    printed_j6 = rest[HEAVE, YAW] + ratio * rest[HEAVE, SWAY] + ratio * line[HEAVE, YAW]
    assert abs(printed_6k - radiation[YAW, HEAVE]) > 0.01 * abs(radiation[YAW, HEAVE])
    assert abs(printed_j6 - radiation[HEAVE, YAW]) > 0.01 * abs(radiation[HEAVE, YAW])


def test_speed_terms_of_the_diffraction_force_follow_from_their_derivation(derived):
    """A1.94, A1.97-A1.99 (and 2.13, 2.15), at the encounter frequency."""
    ratio, _, diffraction, _, _, rest, line = derived
    ours = np.conj(force_with_speed(np.conj(rest)[None], np.conj(line)[None], np.array([ratio]))[0])
    np.testing.assert_allclose(ours, diffraction, rtol=1e-10, atol=1e-9)


def test_speed_does_not_enter_the_froude_krylov_force():
    """A1.93: the wave's own frequency, not that of encounter; A1.63: it lifts the hull in a long crest."""
    still, moving = (solved(Hull(shape=WIGLEY), 0.8, BOW, speed) for speed in (0.0, SPEED))
    np.testing.assert_allclose(moving.froude_krylov_force.values, still.froude_krylov_force.values, rtol=1e-9)
    ratio = encounter_frequency(0.8, SPEED, BOW) / 0.8
    assert ratio > 1.3  # by which the printed form would be too large
    long_wave = solved(Hull(shape=WIGLEY), 0.05, HEAD)
    area = float(hydrostatics(Hull(shape=WIGLEY), 1025.0, 0.0).waterplane_area)
    heave = long_wave.froude_krylov_force.values[0, 0, HEAVE]
    assert heave == pytest.approx(1025.0 * GRAVITY * area, rel=0.01)
    assert long_wave.added_mass.values[0, 0, HEAVE, HEAVE] > 0  # and T = omega_e^2 A - ...


@pytest.mark.parametrize("direction", [BEAM, BOW])
def test_the_phase_across_goes_with_the_sine_of_the_heading(direction):
    """A1.95, A1.96: forces on two hulls far apart are those on one times 2 cos(k s sin(beta)/2)."""
    omega, spacing = 1.1, 14.0
    one = solved(Hull(shape=WIGLEY), omega, direction)
    two = solved(Hull(shape=WIGLEY, count=2, spacing=spacing), omega, direction)
    shift = 2 * np.cos(wavenumber(omega) * spacing / 2 * np.sin(direction))
    for part in ("froude_krylov_force", "diffraction_force"):
        for mode in (SWAY, HEAVE):
            known = one[part].values[0, 0, mode] * shift
            assert two[part].values[0, 0, mode] == pytest.approx(known, rel=1e-6), (part, mode)


def test_hull_flow_of_the_march_is_the_derivative_past_the_hull():
    """A1.103 in axes x forward: (d/dt - U d/dx) of the displacement, -x pitch and x yaw."""
    contour = quarter()
    met, x, step = np.array([1.3]), 4.0, 1e-4
    found = high_speed_march._motion(contour, (0, 1, 2, 3, 4), x, SPEED, met)[..., 0]
    n2, n3 = contour.normals.real, contour.normals.imag
    lever = {3: (lambda place: -place, n3), 4: (lambda place: place, n2)}
    for mode, (arm, normal) in lever.items():
        slope = (arm(x + step) - arm(x - step)) / (2 * step)
        np.testing.assert_allclose(found[:, mode], (1j * met[0] * arm(x) - SPEED * slope) * normal)
    np.testing.assert_allclose(found[:, 1], 1j * met[0] * n3)


def quarter(panels=12):
    """A half-immersed circle."""
    angle = np.linspace(-np.pi, 0.0, panels + 1)
    points = np.exp(1j * angle)
    points[[0, -1]] = points[[0, -1]].real
    return Contour(points[:-1], points[1:], ((-1.0, 1.0),), np.zeros(panels, int))


def test_wave_flow_of_the_march_is_the_gradient_of_its_potential_and_turns_with_the_wave_frequency():
    """A1.104 with n_2 sin(beta) and not n_1; A1.100: with exp(i omega_e t) only the phase omega/U x is left."""
    contour, omega, x = quarter(), 1.2, 3.0
    met = encounter_frequency(omega, SPEED, BOW)
    waves = high_speed_march.Waves(np.array([omega]), np.array([BOW]), np.array([met]))
    points, normals, step = contour.centres, contour.normals, 1e-5

    def potential(where):
        return high_speed_march.incident_potential(where.real, where.imag, x, waves)[:, 0]

    slope = (potential(points + step * normals) - potential(points - step * normals)) / (2 * step)
    found = high_speed_march.incident_normal_velocity(points, normals, x, waves)[:, 0]
    np.testing.assert_allclose(found, slope, rtol=1e-6)
    bow = 20.0
    turned = [
        high_speed_march.incident_normal_velocity(points, normals, place, waves)[:, 0]
        * np.exp(1j * met * (bow - place) / SPEED)
        for place in (x, x + 0.7)
    ]
    np.testing.assert_allclose(turned[1] / turned[0], np.exp(-1j * omega / SPEED * 0.7), rtol=1e-9)


def test_water_of_the_march_is_harmonic_in_its_cross_plane():
    """A1.101: second derivatives in y and z, not in x, add up to nought."""
    water = Water(30.0, 0.25, 1)
    values = np.exp(-((water.y / 3.0) ** 2))
    at, step = 1.4 - 0.8j, 1e-3

    def potential(point):
        return (water.continuation(np.array([point]), np.array([1j]))[0] @ values)[0]

    across = potential(at + step) + potential(at - step) - 2 * potential(at)
    down = potential(at + 1j * step) + potential(at - 1j * step) - 2 * potential(at)
    assert abs(across + down) < 1e-4 * abs(across)
    assert abs(across) > 1e-9


def test_free_water_of_the_march_obeys_its_surface_condition():
    """A1.58 and A1.102: U^2 phi_xx + g phi_z = 0, that is d2Z/dt2 = -g k Z of each wave across, hull gone."""
    water, step = Water(60.0, 0.25, 1), 0.02
    contours = [quarter()] + [None] * 120
    found = passage(
        contours, step, water, lambda number, contour: contour.normals.imag[:, None] + 0j, 1, 1, water.y
    )
    elevation = found.elevation[5:, :, 0].real
    for number in (12, 30, 50):
        k = np.pi / 60.0 * number
        part = np.trapezoid(elevation * np.cos(k * water.y), water.y, axis=1)
        second = (part[2:] - 2 * part[1:-1] + part[:-2]) / step**2
        fitted = -np.sum(second * part[1:-1]) / np.sum(part[1:-1] ** 2)
        assert fitted == pytest.approx(GRAVITY * k, rel=0.01)


def test_tau_goes_with_the_frequency_of_encounter():
    found = tau(np.array([0.7]), np.array([HEAD]), SPEED).item()
    assert found == pytest.approx(SPEED * (0.7 + 0.49 * SPEED / GRAVITY) / GRAVITY)
    assert found > 1.4 * SPEED * 0.7 / GRAVITY  # what is printed


def test_mass_matrix_is_that_of_the_kinetic_energy_of_point_masses():
    """2.2: gyradii squared, and no z_G between heave and pitch; x_G and z_G where they belong."""
    x, y, z = centre = np.array([1.5, 0.4, 2.0])
    gyradii = np.array([3.0, 9.0, 9.2])
    masses = MassProperties(
        mass=900.0, centre_of_gravity=tuple(centre), roll_gyradius=gyradii[0], pitch_gyradius=gyradii[1],
        yaw_gyradius=gyradii[2],
    )  # fmt: skip
    squares = np.sum(gyradii**2) / 2 - gyradii**2
    points = [centre + sign * np.sqrt(3 * square) * axis
              for square, axis in zip(squares, np.eye(3), strict=True) for sign in (1, -1)]  # fmt: skip
    motion = np.array([0.3, -0.2, 0.5, 0.02, -0.05, 0.03])
    energy = sum(900.0 / 6 * np.sum((translation_matrix(point) @ motion)[:3] ** 2) / 2 for point in points)
    assert motion @ mass_matrix(masses) @ motion / 2 == pytest.approx(energy, rel=1e-12)
    matrix = mass_matrix(masses)
    assert matrix[HEAVE, PITCH] == pytest.approx(-900.0 * x)
    assert matrix[SURGE, PITCH] == pytest.approx(900.0 * z)
    assert matrix[HEAVE, ROLL] == pytest.approx(900.0 * y)


def test_equation_of_motion_is_at_the_frequency_of_encounter():
    """2.1: what is left of it is nothing at omega_e, and much at omega."""
    omega, mass = 0.9, 1025.0 * 4 / 9 * 40 * 4 * 2
    masses = MassProperties(
        mass=mass,
        centre_of_gravity=(0.0, 0.0, 0.5),
        roll_gyradius=1.4,
        pitch_gyradius=10.0,
        yaw_gyradius=10.0,
    )
    hull = Hull(shape=WIGLEY)
    found = solved(hull, omega, HEAD, SPEED)
    stiffness = stiffness_matrix(hull, masses, 1025.0)
    moved = motions(found, masses, stiffness)
    origin = np.linalg.inv(translation_matrix(masses.centre_of_gravity)) @ moved.motion_rao.values[0, 0]
    a, b = found.added_mass.values[0, 0], found.radiation_damping.values[0, 0]
    force = found.excitation_force.values[0, 0]

    def left(frequency):
        system = -(frequency**2) * (mass_matrix(masses) + a) - 1j * frequency * b + np.asarray(stiffness)
        return abs((system @ origin - force)[HEAVE]) / abs(force[HEAVE])

    assert left(encounter_frequency(omega, SPEED, HEAD)) < 1e-9
    assert left(omega) > 0.1
