"""Retardation functions: a kernel that is known is found again; nothing that is fitted feeds energy in unseen."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.simulation import retardation
from workbench.simulation.retardation import (
    RadiationOperator,
    fitted_operator,
    passive_operator,
    radiation_forces,
    stable_operator,
    unstable_motions,
)

LENGTH, STEP = 40.0, 0.05
RATE, TURN = 0.5, 0.9  # of the known kernel exp(-a t) cos(b t)
OMEGA = np.linspace(0.05, 8.0, 120)


def known_transform(omega):
    """Transform of exp(-a t) cos(b t) with exp(i omega t)."""
    poles = RATE - 1j * omega
    return poles / (poles**2 + TURN**2)


def known_force(added=2.0, damping=0.0, stiffness=0.0, size=1.5):
    force = OMEGA**2 * added + 1j * OMEGA * (damping + size * known_transform(OMEGA)) - stiffness
    return force[:, None, None]


def test_known_kernel_at_rest_is_found():
    found = fitted_operator(OMEGA, known_force(), LENGTH, STEP, at_rest=True)
    times = np.arange(len(found.kernel)) * STEP
    kernel = 1.5 * np.exp(-RATE * times) * np.cos(TURN * times)
    assert found.added_mass[0, 0] == pytest.approx(2.0, rel=0.01)
    assert found.damping[0, 0] == found.stiffness[0, 0] == 0
    later = times > 0.3
    np.testing.assert_allclose(found.kernel[later, 0, 0], kernel[later], atol=0.05)


def test_constants_of_a_ship_at_speed_are_found():
    force = known_force(damping=-0.7, stiffness=0.4)
    found = fitted_operator(OMEGA, force, LENGTH, STEP, at_rest=False)
    np.testing.assert_allclose(found.response(OMEGA), force, atol=0.01 * np.abs(force).max())
    assert found.stiffness[0, 0] == pytest.approx(0.4, abs=0.05)


def test_operator_reproduces_the_coefficients_of_a_ship(any_ship):
    omega, force = radiation_forces(any_ship.hydrodynamics)
    length = any_ship.design.hull.length
    found = fitted_operator(omega, force, length, 0.011, at_rest=False)
    kept = omega * np.sqrt(length / GRAVITY) < 6
    for mode in (2, 3, 4):
        own, known = found.response(omega[kept])[:, mode, mode], force[kept, mode, mode]
        assert np.abs(own - known).max() < 0.05 * np.abs(known).max()


def test_response_is_that_of_the_convolution():
    kernel = np.zeros((4, 1, 1))
    kernel[1] = 3.0
    operator = RadiationOperator(
        np.full((1, 1), 5.0), np.full((1, 1), 2.0), np.full((1, 1), 7.0), kernel, 0.1
    )
    omega = 1.3
    # x = exp(-i omega t): velocity -i omega x, delayed by one step of 0.1 s under a weight of 0.3
    expected = omega**2 * 5 + 1j * omega * (2 + 0.3 * np.exp(0.1j * omega)) - 7
    assert operator.response([omega])[0, 0, 0] == pytest.approx(expected)


def test_ringing_coefficients_get_a_passive_operator():
    """A resonance much sharper than the memory, as of the water between hulls at rest."""
    sharp = 40 * OMEGA / (1.6**2 - OMEGA**2 - 0.004j * OMEGA) * -1j * 0.02
    force = known_force() + (1j * OMEGA * sharp)[:, None, None]
    mass, stiffness = np.full((1, 1), 3.0), np.full((1, 1), 9.0)
    found = passive_operator(OMEGA, force, LENGTH, STEP, True)
    dense = np.linspace(0.05, 12, 400)
    assert (found.response(dense).imag[:, 0, 0] > -1e-3 * np.abs(force).max()).all()
    assert unstable_motions(found, mass, stiffness) == 0
    chosen = stable_operator(OMEGA, force, LENGTH, STEP, True, mass, stiffness)
    assert unstable_motions(chosen, mass, stiffness) == 0


def test_passive_operator_takes_no_energy_from_negative_damping():
    mass, stiffness, force = np.full((1, 1), 1.0), np.full((1, 1), 48.0), known_force(damping=-0.25)
    assert unstable_motions(fitted_operator(OMEGA, force, LENGTH, STEP, True), mass, stiffness) > 0
    assert unstable_motions(passive_operator(OMEGA, force, LENGTH, STEP, True), mass, stiffness) == 0


def test_growing_motions_are_counted():
    mass, stiffness = np.diag([1.0, 2.0]), np.diag([4.0, 3.0])
    kernel = np.zeros((10, 2, 2))
    for damping, growing in (((0.1, 0.2), 0), ((0.1, -0.2), 2), ((-0.1, -0.2), 4)):
        operator = RadiationOperator(np.zeros((2, 2)), np.diag(damping), np.zeros((2, 2)), kernel, STEP)
        assert unstable_motions(operator, mass, stiffness) == growing


def test_coefficients_that_feed_energy_in_are_refused(monkeypatch):
    monkeypatch.setattr(retardation, "passive_operator", fitted_operator)
    force = known_force(size=-3.0)
    with pytest.raises(InputError, match="must die out"):
        stable_operator(OMEGA, force, LENGTH, STEP, True, np.full((1, 1), 1.0), np.full((1, 1), 5.0))
