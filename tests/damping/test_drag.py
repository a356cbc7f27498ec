"""Drag across the hulls and roll damping of a single hull."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from workbench.conventions import GRAVITY
from workbench.damping.cross_flow import LINEARISED, CrossFlow, cross_flow
from workbench.damping.roll import friction_damping, hull_roll_damping, lift_damping
from workbench.design import Hull, MassProperties
from workbench.errors import InputError
from workbench.geometry.hydrostatics import hydrostatics
from workbench.hydrodynamics.coefficients import coefficient_set
from workbench.motions import motions
from workbench.shapes import RoundBilge, Wigley

MASSES = MassProperties(
    mass=100.0, centre_of_gravity=(0, 0, 0), roll_gyradius=1.0, pitch_gyradius=2.0, yaw_gyradius=2.0
)
RHO = 1025.0
SHAPE = Wigley(length=20.0, beam=2.0, draught=1.0, depth=2.0)


def oscillator(omega=(1.0, 1.4, 2.0), directions=(np.pi,), speed=0.0):
    """A ship of mass 100 kg with added mass 50 kg, damping 10 kg/s and force 40 N/m in each mode."""
    omega, directions = np.array(omega), np.array(directions)
    size = (len(omega), len(directions))
    diagonal = np.broadcast_to(np.eye(6), (*size, 6, 6))
    return coefficient_set(
        omega, directions, speed, RHO, added_mass=50.0 * diagonal, radiation_damping=10.0 * diagonal,
        froude_krylov_force=np.full((*size, 6), 40.0 + 0j), diffraction_force=np.zeros((*size, 6)),
        solver="none",
    )  # fmt: skip


DEEP = CrossFlow(np.array([[0.0, 0.0, -500.0]]), np.array([[0.0, 0.0, 1.0]]), np.array([80.0]))
"""One piece below all waves, for heave."""


def test_linear_share_does_the_work_of_the_square():
    phase = np.linspace(0, 2 * np.pi, 100_001)
    work = np.trapezoid(np.abs(np.cos(phase)) * np.cos(phase) ** 2, phase)
    assert work / np.trapezoid(np.cos(phase) ** 2, phase) == pytest.approx(LINEARISED, rel=1e-8)


def test_linearised_drag_satisfies_its_own_amplitude():
    found = motions(oscillator(), MASSES, 300.0 * np.eye(6), cross_flow=DEEP, wave_amplitude=2.0)
    heave = np.abs(found.motion_rao.values[:, 0, 2])
    omega = found.omega.values
    damping = 10.0 + LINEARISED * 80.0 * omega * heave * 2.0
    expected = 40.0 / np.abs(300.0 - omega**2 * 150.0 - 1j * omega * damping)
    np.testing.assert_allclose(heave, expected, rtol=1e-5)
    assert found.attrs["wave_amplitude"] == 2.0
    assert "linearised for waves of 2 m" in found.attrs["warnings"]


def test_linearised_drag_agrees_with_the_square_in_time():
    """First harmonic of 150 z'' + 10 z' + 80 |z'| z' + 300 z = 40 a cos(1.4 t), near resonance."""
    amplitude, omega = 2.0, 1.4
    solved = solve_ivp(
        lambda t, y: [
            y[1],
            (40 * amplitude * np.cos(omega * t) - (10 + 80 * abs(y[1])) * y[1] - 300 * y[0]) / 150,
        ],
        (0, 40 * 2 * np.pi / omega), [0.0, 0.0], rtol=1e-8, atol=1e-9, dense_output=True,
    )  # fmt: skip
    times = np.linspace(39, 40, 2000, endpoint=False) * 2 * np.pi / omega
    harmonic = 2 * np.mean(solved.sol(times)[0] * np.exp(1j * omega * times)) / amplitude
    found = motions(oscillator(), MASSES, 300.0 * np.eye(6), cross_flow=DEEP, wave_amplitude=amplitude)
    linear = motions(oscillator(), MASSES, 300.0 * np.eye(6))
    heave = found.motion_rao.values[1, 0, 2]
    assert abs(heave) == pytest.approx(abs(harmonic), rel=0.005)
    assert heave == pytest.approx(harmonic, rel=0.02)
    assert abs(heave) < 0.5 * abs(linear.motion_rao.values[1, 0, 2])


def test_drag_is_that_of_the_flow_across_the_hull_at_speed():
    """Residual of the equations of heave and pitch, with the flow across one piece written out."""
    x, z, strength, speed, amplitude = 3.0, -0.5, 80.0, 4.0, 1.5
    piece = CrossFlow(np.array([[x, 0.0, z]]), np.array([[0.0, 0.0, 1.0]]), np.array([strength]))
    beta = np.radians(150.0)
    ship = oscillator([1.0, 1.4], [beta], speed)
    found = motions(ship, MASSES, 300.0 * np.eye(6), cross_flow=piece, wave_amplitude=amplitude)
    for i, omega in enumerate((1.0, 1.4)):
        k = omega**2 / GRAVITY
        met = omega - k * speed * np.cos(beta)
        heave, pitch = found.motion_rao.values[i, 0, [2, 4]]
        water = -1j * omega * np.exp(k * z + 1j * k * x * np.cos(beta))
        across = -1j * met * (heave - x * pitch) + speed * pitch - water
        drag = -8 / (3 * np.pi) * strength * amplitude * np.abs(across) * across
        spring = 300.0 - 10j * met
        assert (spring - met**2 * 150.0) * heave == pytest.approx(40.0 + drag, rel=1e-5)
        assert (spring - met**2 * (50.0 + 400.0)) * pitch == pytest.approx(40.0 - x * drag, rel=1e-5)


def test_drag_settles_with_modes_locked():
    found = motions(
        oscillator(), MASSES, 300.0 * np.eye(6), cross_flow=DEEP, wave_amplitude=2.0, locked=("roll", "pitch", "yaw")
    )  # fmt: skip
    free = motions(oscillator(), MASSES, 300.0 * np.eye(6), cross_flow=DEEP, wave_amplitude=2.0)
    np.testing.assert_allclose(found.motion_rao[..., 2], free.motion_rao[..., 2], rtol=1e-5)
    assert "did not settle" not in found.attrs["warnings"]


def test_small_waves_have_no_drag():
    plain = motions(oscillator(), MASSES, 300.0 * np.eye(6))
    small = motions(oscillator(), MASSES, 300.0 * np.eye(6), cross_flow=DEEP, wave_amplitude=1e-6)
    np.testing.assert_allclose(small.motion_rao, plain.motion_rao, rtol=1e-4)


def test_drag_is_that_of_the_water_against_the_hull():
    """A piece at the surface that goes with the water, in long waves, is not felt."""
    piece = CrossFlow(np.zeros((1, 3)), np.array([[0.0, 0.0, 1.0]]), np.array([80.0]))
    omega = 0.02
    system = 1e6
    ship = oscillator([omega], [np.pi])
    ship["excitation_force"][...] = system
    found = motions(ship, MASSES, system * np.eye(6), cross_flow=piece, wave_amplitude=5.0)
    plain = motions(ship, MASSES, system * np.eye(6))
    np.testing.assert_allclose(found.motion_rao.values[..., 2], plain.motion_rao.values[..., 2], rtol=1e-6)


def test_drag_needs_the_height_of_the_waves():
    with pytest.raises(InputError, match="wave amplitude of the drag must be"):
        motions(oscillator(), MASSES, 300.0 * np.eye(6), cross_flow=DEEP)


def test_pieces_cover_the_waterplane_and_the_centre_plane():
    hull = Hull(shape=SHAPE, count=2, spacing=8.0)
    pieces = cross_flow(hull, RHO, 0.8, 0.5, stations=81)
    flat = pieces.normals[:, 2] == 1.0
    area = float(hydrostatics(hull, RHO).waterplane_area)
    assert pieces.strengths[flat].sum() == pytest.approx(0.5 * RHO * 0.8 * area, rel=2e-3)
    assert pieces.strengths[~flat].sum() == pytest.approx(0.5 * RHO * 0.5 * 2 * 20.0 * 1.0, rel=0.02)
    assert set(np.round(np.abs(pieces.points[:, 1]), 6)) == {4.0}
    assert len(cross_flow(hull, RHO, 0.0).strengths) == 0


def test_pieces_reach_to_the_transom():
    shape = RoundBilge(
        length=40.0, beam=4.0, draught=2.0, depth=4.0, block_coefficient=0.5, lcb=-0.078, transom_ratio=0.9,
        deadrise_angle=0.2, entrance_angle=0.2,
    )  # fmt: skip
    pieces = cross_flow(Hull(shape=shape), RHO, 1.0, stations=21)
    area = float(hydrostatics(Hull(shape=shape), RHO).waterplane_area)
    assert pieces.strengths.sum() == pytest.approx(0.5 * RHO * area, rel=3e-3)


def test_a_flying_hull_has_no_drag():
    tall = Wigley(length=20.0, beam=2.0, draught=1.0, depth=6.0)
    upright = Hull(shape=tall, count=2, spacing=8.0)
    flying = replace(upright, heel=np.radians(20.0))
    assert (cross_flow(upright, RHO, 0.8).points[:, 1] > 0).any()
    assert (cross_flow(flying, RHO, 0.8).points[:, 1] < 0).all()


def test_pieces_resist_heave_pitch_and_roll_of_hulls_apart():
    pieces = cross_flow(Hull(shape=SHAPE, count=2, spacing=8.0), RHO, 1.0)
    drag = np.einsum("n,nj,nk->jk", pieces.strengths, pieces.velocity_rows, pieces.velocity_rows)
    assert drag[3, 3] == pytest.approx(16.0 * drag[2, 2])
    assert drag[4, 4] > 0
    assert drag[0, 0] == drag[1, 1] == 0


def test_friction_and_lift_of_roll_give_the_numbers_of_their_formulas():
    """L 100, B 15, T 5 m, C_B 0.6, midship 0.94, centre of gravity 1 m above water, 0.6 rad/s, 10 m/s."""
    surface = 100 * (1.7 * 5 + 0.6 * 15)
    radius = ((0.887 + 0.145 * 0.6) * surface / 100 + 2) / np.pi
    at_rest = 0.787 * 1000 * surface * radius**2 * np.sqrt(0.6e-6)
    assert friction_damping(100, 15, 5, 0.6, -1, 0.6, 0, 1000, 1e-6) == pytest.approx(at_rest)
    assert friction_damping(100, 15, 5, 0.6, -1, 0.6, 10, 1000, 1e-6) == pytest.approx(
        at_rest * (1 + 41 / 60)
    )
    slope = 2 * np.pi * 0.05 + 0.1 * (4.1 * 0.15 - 0.045)
    lever = 1 + 1.4 / 2.5 + 0.7 / (1.5 * 2.5)
    expected = 0.5 * 1000 * 10 * 500 * slope * 1.5 * 2.5 * lever
    assert lift_damping(100, 15, 5, 0.94, -1, 10, 1000) == pytest.approx(expected)
    assert (
        lift_damping(100, 15, 5, 0.90, -1, 10, 1000) < expected < lift_damping(100, 15, 5, 0.98, -1, 10, 1000)
    )


def test_roll_of_a_single_hull_is_damped_and_hulls_side_by_side_are_refused():
    found = hull_roll_damping(Hull(shape=SHAPE), MASSES, RHO, 5.0, [0.5, 1.0], [np.pi, np.pi / 2])
    values = found.damping.values
    assert (values[..., 3, 3] > lift_damping(20, 2, 1, 0.67, 0.0, 5.0, RHO)).all()
    assert np.count_nonzero(values) == 4
    above, below = (
        hull_roll_damping(
            Hull(shape=SHAPE), replace(MASSES, centre_of_gravity=(0.0, 0.0, z)), RHO, 5.0, [0.5], [3.1]
        )
        for z in (0.5, -0.5)
    )
    assert (above.damping.values[..., 3, 3] > 2 * below.damping.values[..., 3, 3]).all()
    with pytest.raises(InputError, match="need a single hull, got 2"):
        hull_roll_damping(Hull(shape=SHAPE, count=2, spacing=8.0), MASSES, RHO, 5.0, [0.5], [np.pi])
