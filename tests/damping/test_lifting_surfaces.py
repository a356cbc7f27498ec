"""Foils and fins: lift slopes, added mass, and forces that know where the water goes."""

import numpy as np
import pytest

from workbench.appendages import Fin, Foil
from workbench.conventions import wavenumber
from workbench.damping.lifting_surfaces import (
    LiftSettings,
    foil_forces,
    lift_slope,
    plate_added_mass,
    submergence_factor,
    surface_lift_slope,
)
from workbench.errors import InputError
from workbench.motions import translation_matrix

RHO, U = 1025.0, 15.0
T_FOIL = Foil(name="T-foil", area=8.0, span=5.0, position=(20.0, 0.0, -3.0), lift_slope=4.0)
RUDDER = Fin(name="rudder", area=2.0, span=2.0, position=(-20.0, 0.0, -2.0), lift_slope=3.0)


def matrices(*surfaces, speed=U, **settings):
    found = foil_forces(surfaces, RHO, speed, [1.0], [np.pi], LiftSettings(**settings))
    return tuple(found[name].values for name in ("added_mass", "damping", "stiffness"))


def test_lift_slopes_have_their_ends():
    assert lift_slope(1e-3, formula="helmbold") == pytest.approx(np.pi / 2 * 1e-3, rel=1e-3)
    assert lift_slope(1e5, formula="helmbold") == pytest.approx(2 * np.pi, rel=1e-4)
    assert lift_slope(2.0, formula="helmbold") == pytest.approx(2.603, abs=1e-3)
    assert lift_slope(2.0) == pytest.approx(1.8 * np.pi * 2 / (np.sqrt(8) + 1.8))
    assert lift_slope(1e6) == pytest.approx(0.9 * 2 * np.pi, rel=1e-4)
    sweep = np.radians(30)
    swept = 1.8 * np.pi * 3 / (np.cos(sweep) * np.sqrt(9 / np.cos(sweep) ** 4 + 4) + 1.8)
    assert lift_slope(3.0, sweep) == pytest.approx(swept)
    for ratio in (1.0, 2.0, 3.0):
        assert lift_slope(ratio) == pytest.approx(lift_slope(ratio, formula="helmbold"), rel=0.07)


def test_hull_mirrors_a_fin_and_not_a_foil():
    foil = Foil(name="a", area=2.0, span=2.0, position=(0, 0, -2.0))
    fin = Fin(name="a", area=2.0, span=2.0, position=(0, 0, -2.0))
    assert (foil.aspect_ratio, fin.aspect_ratio) == (2.0, 4.0)
    assert surface_lift_slope(fin, LiftSettings()) == pytest.approx(lift_slope(4.0))
    assert surface_lift_slope(foil, LiftSettings(lift_slope="helmbold")) == pytest.approx(
        lift_slope(2.0, formula="helmbold")
    )


def test_lift_falls_to_a_half_at_the_surface_at_high_speed():
    assert submergence_factor(0.0) == pytest.approx(0.5)
    assert submergence_factor(1.0) == pytest.approx(17 / 18)
    fast = LiftSettings(free_surface="high-speed")
    shallow = Foil(name="a", area=4.0, span=2.0, position=(0, 0, -1.0))
    assert surface_lift_slope(shallow, fast) == pytest.approx(lift_slope(1.0) * submergence_factor(0.5))
    assert surface_lift_slope(RUDDER, fast) == 3.0


def lattice_added_mass(chord, span, count=12):
    """Added mass of a plate by constant doublets on a lattice, closer at the edges [-] over pi/4 c**2 b."""
    ends, middles = np.arange(count + 1) / count, (np.arange(count) + 0.5) / count
    (t, s), (tc, sc) = (
        [(1 - np.cos(np.pi * at)) / 2 * side for side in (chord, span)] for at in (ends, middles)
    )
    x, y = (part.ravel()[:, None] for part in np.meshgrid(tc, sc, indexing="ij"))
    i, j = (part.ravel() for part in np.meshgrid(range(count), range(count), indexing="ij"))

    def corner(x0, y0):
        return np.hypot(x - x0, y - y0) / ((x - x0) * (y - y0))

    influence = corner(t[i + 1], s[j + 1]) - corner(t[i + 1], s[j]) - corner(t[i], s[j + 1])
    influence = (influence + corner(t[i], s[j])) / (4 * np.pi)
    areas = (t[i + 1] - t[i]) * (s[j + 1] - s[j])
    return abs(np.sum(np.linalg.solve(influence, np.ones(count**2)) * areas)) / (np.pi / 4 * chord**2 * span)


@pytest.mark.parametrize("ratio", [1.0, 2.0, 4.0, 8.0])
def test_added_mass_of_a_plate_is_that_of_a_doublet_lattice(ratio):
    share = plate_added_mass(1.0, ratio, RHO) / (RHO * np.pi / 4 * ratio)
    assert share == pytest.approx(lattice_added_mass(1.0, ratio), rel=0.04)
    assert plate_added_mass(ratio, 1.0, RHO) == plate_added_mass(1.0, ratio, RHO)


def test_a_flat_foil_damps_heave_and_pitch_and_weakens_pitch_when_forward():
    added, damping, stiffness = matrices(T_FOIL)
    lift = 0.5 * RHO * U * 8.0 * 4.0
    mass = plate_added_mass(1.6, 5.0, RHO)
    x = 20.0
    block = np.ix_([2, 4], [2, 4])
    np.testing.assert_allclose(added[block], mass * np.array([[1, -x], [-x, x * x]]))
    np.testing.assert_allclose(
        damping[block], lift * np.array([[1, -x], [-x, x * x]]) + mass * U * np.array([[0, 1], [0, -x]])
    )
    np.testing.assert_allclose(stiffness[block], lift * U * np.array([[0, 1], [0, -x]]))
    for matrix in (added, damping, stiffness):
        np.testing.assert_allclose(matrix[:2], 0.0, atol=1e-9 * np.abs(matrix).max())
    aft = Foil(name="aft", area=8.0, span=5.0, position=(-20.0, 0.0, -3.0))
    assert stiffness[4, 4] < 0 < matrices(aft)[2][4, 4]


def test_lift_is_spread_elliptically_for_roll():
    """Of a flat foil on the centreline: L b**2 / 16 and its added mass likewise."""
    added, damping, _ = matrices(T_FOIL)
    assert damping[3, 3] == pytest.approx(0.5 * RHO * U * 8 * 4 * 25 / 16)
    assert added[3, 3] == pytest.approx(plate_added_mass(1.6, 5.0, RHO) * 25 / 16)


def test_an_upright_fin_damps_sway_yaw_and_roll_and_steadies_yaw_when_aft():
    added, damping, stiffness = matrices(RUDDER)
    lift = 0.5 * RHO * U * 2.0 * 3.0
    mass = plate_added_mass(1.0, 4.0, RHO) / 2
    assert damping[1, 1] == pytest.approx(lift)
    assert damping[1, 5] - damping[5, 1] == pytest.approx(-mass * U)
    assert damping[3, 3] == pytest.approx(lift * (4.0 + 4.0 / 16))
    assert damping[1, 3] == pytest.approx(2.0 * lift)
    assert stiffness[5, 5] == pytest.approx(20 * lift * U)
    assert stiffness[1, 5] == pytest.approx(-lift * U)
    assert added[1, 1] == pytest.approx(mass)
    np.testing.assert_allclose(damping[2], 0.0, atol=1e-9 * lift)


def test_a_pair_keeps_the_symmetry_of_the_ship():
    canted = Fin(name="fins", area=3.0, span=2.0, position=(5.0, 4.0, -2.0), cant=0.6, pair=True)
    even, odd = [0, 2, 4], [1, 3, 5]
    for matrix in matrices(canted):
        scale = np.abs(matrix).max()
        np.testing.assert_allclose(matrix[np.ix_(even, odd)], 0.0, atol=1e-9 * scale)
        np.testing.assert_allclose(matrix[np.ix_(odd, even)], 0.0, atol=1e-9 * scale)
    alone = Fin(name="fins", area=3.0, span=2.0, position=(5.0, 4.0, -2.0), cant=0.6)
    np.testing.assert_allclose(matrices(canted)[1][2, 2], 2 * matrices(alone)[1][2, 2])
    assert matrices(alone)[1][2, 3] != 0


def test_matrices_move_with_the_foil():
    there = Foil(name="a", area=8.0, span=5.0, position=(23.0, 1.0, -5.0), lift_slope=4.0)
    move = translation_matrix((3.0, 1.0, -2.0))
    for here, moved in zip(matrices(T_FOIL), matrices(there), strict=True):
        np.testing.assert_allclose(move.T @ here @ move, moved, rtol=1e-9, atol=1e-6 * np.abs(moved).max())


@pytest.mark.parametrize("beta", np.radians([180.0, 135.0, 60.0, 0.0]))
def test_a_ship_that_goes_with_the_water_feels_nothing(beta):
    """In long waves, at speed: force of the waves and of the motions cancel to the order of k."""
    surfaces = (
        Foil(name="flat", area=1.0, span=0.5, position=(8.0, 0.0, -0.2)),
        Fin(name="upright", area=0.1, span=0.2, position=(-6.0, 0.0, -0.1)),
    )
    for surface in surfaces:
        left = []
        for omega in (0.1, 0.05):
            k, c, s = wavenumber(omega), np.cos(beta), np.sin(beta)
            found = foil_forces([surface], RHO, 3.0, [omega], [beta])
            met = omega - k * 3.0 * c
            motion = np.array([1j * c, 1j * s, 1.0, 0.0, -1j * k * c, -k * c * s])
            impedance = (
                -(met**2) * found.added_mass.values - 1j * met * found.damping.values + found.stiffness.values
            )
            force = found.excitation_force.values[0, 0]
            scale = np.abs(force[[1, 2]]).max()
            left.append(np.abs((force - impedance @ motion)[[1, 2]]).max() / max(scale, 1e-9))
        assert left[0] < 12 * wavenumber(0.1)
        assert left[1] < 0.3 * left[0] + 1e-9


def test_wave_force_is_lift_of_the_orbital_velocity():
    small = Foil(name="a", area=2.0, span=1e-3, position=(4.0, 0.0, -3.0), lift_slope=2.0)
    found = foil_forces([small], RHO, 10.0, [0.8], [np.pi])
    k = wavenumber(0.8)
    rise = -1j * 0.8 * np.exp(-3 * k - 4j * k)
    met = 0.8 + k * 10
    mass = plate_added_mass(2000.0, 1e-3, RHO)
    expected = (0.5 * RHO * 10 * 2 * 2 - 1j * met * mass) * rise
    assert found.excitation_force.values[0, 0, 2] == pytest.approx(expected, rel=1e-9)
    assert found.excitation_force.values[0, 0, 4] == pytest.approx(-4 * expected, rel=1e-9)


def test_at_rest_only_added_mass_is_left():
    added, damping, stiffness = matrices(T_FOIL, speed=0.0)
    assert added.any()
    assert not damping.any()
    assert not stiffness.any()


def test_limits_are_said():
    wide = Foil(name="wide", area=20.0, span=5.0, position=(0, 0, -3.0))
    found = foil_forces([wide], RHO, 3.0, [3.0], [np.pi], LiftSettings(free_surface="high-speed"))
    assert "reduced frequency goes to" in found.attrs["warnings"]
    assert "Froude number on the depth" in found.attrs["warnings"]
    assert foil_forces([T_FOIL], RHO, U, [1.0], [np.pi]).attrs["warnings"] == ""


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"name": " "}, "name of an appendage must be text"),
        ({"area": 0.0}, "area of fin must be"),
        ({"span": "2"}, "span of fin must be a number"),
        ({"position": (0.0, 0.0)}, "position of fin must be three numbers"),
        ({"position": "xyz"}, "position of fin must be three numbers"),
        ({"position": (0.0, 0.0, 1.0)}, "highest point of fin must be under water"),
        ({"position": (0.0, 0.0, -0.9)}, "highest point of fin must be under water"),
        ({"pair": True}, "must not be 0 m for a pair"),
        ({"pair": 1}, "pair of fin must be true or false"),
        ({"cant": 2.0}, "cant of fin must be"),
        ({"lift_slope": -1.0}, "lift slope of fin must be"),
    ],
)
def test_surfaces_that_cannot_be_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        Fin(**{"name": "fin", "area": 2.0, "span": 2.0, "position": (0.0, 0.0, -2.0), **changes})
    assert "\n" not in str(caught.value)


def test_choices_are_checked():
    with pytest.raises(InputError, match="lift_slope must be one of"):
        LiftSettings(lift_slope="thin")
    with pytest.raises(InputError, match="free_surface must be one of"):
        LiftSettings(free_surface="flat")
