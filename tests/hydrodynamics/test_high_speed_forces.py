"""Forces from sectional potentials: Ogilvie-Tuck sums by hand, transoms, lost stiffness, reach of the waves."""

from dataclasses import replace

import numpy as np
import pytest

from workbench import designs
from workbench.conventions import GRAVITY
from workbench.design import Hull
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.geometry.sections import sections
from workbench.hydrodynamics.high_speed_forces import ends, forces, lost_stiffness, reached
from workbench.hydrodynamics.high_speed_hulls import hull_alone, stationed
from workbench.hydrodynamics.high_speed_march import HEAVE, PITCH, SWAY, YAW, Waves, sectional
from workbench.hydrodynamics.near_transom import relaxation_length
from workbench.shapes import Wigley

DELFT = designs.named_design("delft-372").hull
DEMIHULL = Hull(shape=DELFT.shape)
SPEED, DENSITY = 2.5, 1000.0
MET = np.array([6.0, 9.0])
WAVES = Waves(np.array([4.0, 5.0]), np.array([np.pi, 2.2]), MET)


@pytest.fixture(scope="module")
def marched():
    stations = stationed(DEMIHULL, 200, 16)
    potentials = sectional(
        hull_alone(stations, 0), stations, SPEED, MET, WAVES, DEMIHULL.length, 0.021, np.zeros(0)
    )
    return stations, potentials


def summed(marched, released):
    stations, potentials = marched
    end = ends(stations, stations.hulls[0], SPEED, released)
    return forces(potentials, stations, [end], SPEED, DENSITY, MET, WAVES)


def test_pitch_is_heave_at_a_distance_and_the_stream(marched):
    """The body condition of pitch is (-i omega x + U) n3, and the march is linear: the turned hull by quadrature."""
    stations, _ = marched
    problem = hull_alone(stations, 0)
    shifted = replace(stations, x=stations.x + 1.0, bow=stations.bow + 1.0)
    here, there = (
        sectional(problem, where, SPEED, MET, WAVES, 3.0, 0.021, np.zeros(0)).radiation
        for where in (stations, shifted)
    )
    np.testing.assert_allclose(there[:, :, :, PITCH], here[:, :, :, PITCH] - here[:, :, :, HEAVE], atol=1e-9)
    np.testing.assert_allclose(there[:, :, :, YAW], here[:, :, :, YAW] + here[:, :, :, SWAY], atol=1e-9)
    at_bow = here[0, 0, 1, PITCH] / here[0, 0, 1, HEAVE]
    known = -stations.x[0] + SPEED / (1j * MET)
    np.testing.assert_allclose(at_bow, known, rtol=1e-9)
    np.testing.assert_allclose((here[0, 0, 0, YAW] / here[0, 0, 0, SWAY]), -known, rtol=1e-9)


def test_forces_are_the_sums_of_ogilvie_and_tuck(marched):
    stations, potentials = marched
    radiation, diffraction = summed(marched, released=False)
    x = np.concatenate([[stations.bow], stations.x])
    aft = stations.hulls[0].aft
    for found, columns in (
        (radiation[:, :, 1:].transpose(1, 2, 0), potentials.radiation[:, 0]),
        (diffraction.T, potentials.diffraction[:, 0]),
    ):
        values = np.concatenate([0 * columns[:1], columns])
        middle, width = (values[1:] + values[:-1]) / 2, (x[:-1] - x[1:])
        lever = ((x[1:] + x[:-1]) / 2)[:, None]

        def integral(factor, middle=middle, width=width):
            flat = (width[:, None] * factor * middle.reshape(len(width), -1)).sum(axis=0)
            return flat.reshape(middle.shape[1:])

        whole, turned, last = integral(1.0), integral(lever), columns[-1]
        rate = 1j * MET
        for row, mode in ((1, 0), (2, 1), (3, 2)):
            known = DENSITY * (rate * whole[mode] + SPEED * last[mode])
            np.testing.assert_allclose(found[row], known, rtol=1e-9, atol=1e-9)
        for row, mode, sign in ((4, 1, -1.0), (5, 0, 1.0)):
            known = sign * DENSITY * (rate * turned[mode] + SPEED * aft * last[mode] + SPEED * whole[mode])
            np.testing.assert_allclose(found[row], known, rtol=1e-9, atol=1e-9)
    assert (
        np.abs(SPEED * potentials.radiation[-1, 0, 1, HEAVE]).min()
        > 0.02 * np.abs(radiation[:, 2, 2] / DENSITY).min()
    )


def test_a_released_transom_carries_nothing_at_its_edge(marched):
    """rho int c (i omega S - U dS/dx) dx with c = tanh, by quadrature; no end term."""
    stations, potentials = marched
    radiation, _ = summed(marched, released=True)
    beam = stations.hulls[0].beams.max()
    length = relaxation_length(beam, SPEED)
    x = np.concatenate([[stations.bow], stations.x])
    values = np.concatenate([np.zeros((1, 2)), potentials.radiation[:, 0, 1, HEAVE]])
    fine = np.linspace(stations.hulls[0].aft, stations.bow, 40001)
    smooth = np.stack([np.interp(fine, x[::-1], column[::-1]) for column in values.T], axis=1)
    factor = np.tanh((fine - stations.hulls[0].aft) / length)[:, None]
    density = 1j * MET * smooth - SPEED * np.gradient(smooth, fine, axis=0)
    heave = DENSITY * np.trapezoid(factor * density, fine, axis=0)
    pitch = -DENSITY * np.trapezoid(fine[:, None] * factor * density, fine, axis=0)
    np.testing.assert_allclose(radiation[:, 2, 2], heave, rtol=3e-3)
    np.testing.assert_allclose(radiation[:, 4, 2], pitch, rtol=0.01)
    plain, _ = summed(marched, released=False)
    assert np.abs(plain[:, 2, 2] / radiation[:, 2, 2] - 1).min() > 0.02


def test_lost_stiffness_is_the_water_plane_that_is_let_go():
    for hull in (DELFT, DEMIHULL):
        stations = stationed(hull, 400, 12)
        each = [ends(stations, stations.hulls[numbers[0]], SPEED, True) for numbers in stations.families]
        found = lost_stiffness(stations, each, DENSITY)
        one = sections(hull, 161, 13)[0]
        fine = np.linspace(one.x[0], one.x[-1], 20001)
        beams = np.interp(fine, one.x, one.beams)
        gone = (1 - np.tanh((fine - fine[0]) / relaxation_length(beams.max(), SPEED))) * DENSITY * GRAVITY
        y, count = hull.spacing / 2, hull.count
        assert found[2, 2] == pytest.approx(-count * np.trapezoid(gone * beams, fine), rel=5e-3)
        assert found[2, 4] == pytest.approx(count * np.trapezoid(gone * beams * fine, fine), rel=5e-3)
        assert found[4, 4] == pytest.approx(-count * np.trapezoid(gone * beams * fine**2, fine), rel=5e-3)
        roll = np.trapezoid(gone * (beams**3 / 12 + beams * y**2), fine)
        assert found[3, 3] == pytest.approx(-count * roll, rel=5e-3)
        np.testing.assert_allclose(found, found.T)
        assert abs(found[2, 3]) < 1e-9 * abs(found[2, 2])
    masses = designs.named_design("delft-372").masses
    whole = stiffness_matrix(DELFT, masses, DENSITY)
    assert 0.005 < -2 * found[2, 2] / whole[2, 2] < 0.3


def test_slow_or_pointed_sterns_stay_wet():
    stations = stationed(DEMIHULL, 100, 12)
    hull = stations.hulls[0]
    limit = 2.5 * np.sqrt(GRAVITY * hull.last_draught)
    assert ends(stations, hull, 0.99 * limit, True).end_share == 0.0
    assert not ends(stations, hull, 0.99 * limit, True).weights.slope.any()
    assert ends(stations, hull, 1.01 * limit, False).end_share == 1.0
    assert ends(stations, hull, 1.01 * limit, True).weights.slope.any()
    pointed = stationed(Hull(shape=Wigley(length=3.0, beam=0.3, draught=0.15, depth=0.4)), 100, 12)
    found = ends(pointed, pointed.hulls[0], 5.0, True)
    assert found.end_share == 0.0
    assert not found.weights.slope.any()


def test_waves_of_the_other_hull_arrive_two_tau_spacings_behind_the_bow():
    stations = stationed(DELFT, 300, 8)
    met = np.array([1.5, 2.0, 30.0])
    share = reached(stations, 0, met, SPEED)
    for column, omega in enumerate(met):
        arrival = stations.bow - 2 * SPEED * omega / GRAVITY * DELFT.spacing
        expected = np.clip((arrival - stations.x) / stations.spacing + 0.5, 0, 1)
        np.testing.assert_allclose(share[:, column], expected, atol=1e-9)
    assert 0 < share[:, 0].mean() < 1
    assert not share[:, 2].any()
