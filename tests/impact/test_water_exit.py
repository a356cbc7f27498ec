"""A section that turns and rises out of the water again."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact.entry import VelocityHistory, entry
from workbench.impact.section import Parabola, Wedge

TIMES = tuple(np.linspace(0.0, 1.0, 21))
TURNING = VelocityHistory(TIMES, tuple(2.0 - 5.0 * np.array(TIMES)))  # turns at 0.4 s, out at 0.8 s
UP = -5.0


@pytest.mark.parametrize(
    ("method", "pile_up"), [("von-karman", 1.0), ("wagner", np.pi / 2), ("logvinovich", np.pi / 2)]
)
def test_force_on_the_way_out_is_added_mass_times_acceleration(method, pile_up):
    beta = np.radians(15)
    found = entry(Wedge(beta), TURNING, method, 1000.0, [0.5, 0.6, 0.7])
    depth = 2 * found.time.values - 2.5 * found.time.values**2
    np.testing.assert_allclose(found.penetration, depth)
    half = pile_up * depth / np.tan(beta)
    np.testing.assert_allclose(found.wetted_half_breadth, half, rtol=1e-9)
    np.testing.assert_allclose(found.section_force, 1000 * np.pi / 2 * UP * half**2, rtol=1e-9)
    assert np.all(found.wetted_rate < 0)
    assert np.all(found.section_pressure <= 0)
    assert np.all(np.isnan(found.peak_coefficient))
    assert "linearised exit" in found.attrs["warnings"]


def test_pressure_on_the_way_out_is_that_of_an_accelerated_plate():
    found = entry(Parabola(3.0), TURNING, "wagner", 1.0, [0.6], [(0.0, 0.5), (0.5, 10.0)]).isel(time=0)
    half = float(found.wetted_half_breadth)
    y = found.pressure_position.values
    np.testing.assert_allclose(found.section_pressure, UP * np.sqrt(np.maximum(half**2 - y**2, 0)), atol=1e-6)
    whole = 0.5 * float(found.panel_pressure[0]) + 9.5 * float(found.panel_pressure[1])
    assert 2 * whole == pytest.approx(float(found.section_force), rel=1e-6)


def test_force_of_entry_and_exit_meet_where_the_section_turns_without_a_jump_of_wagners():
    before, after = (
        float(entry(Wedge(0.2), TURNING, "wagner", 1.0, [t]).section_force[0]) for t in (0.39999, 0.40001)
    )
    assert before == pytest.approx(after, rel=1e-3)


def test_braking_on_the_way_out_pushes():
    times = np.linspace(0, 1, 41)
    history = VelocityHistory(tuple(times), tuple(2.0 * np.cos(2 * np.pi * times / 1.2)))
    found = entry(Wedge(0.2), history, "wagner", 1.0, [0.35, 0.58])
    assert found.section_force[0] < 0
    slowing = VelocityHistory((0.0, 0.2, 0.4, 0.6, 0.8), (2.0, 0.6, -0.5, -0.3, -0.1))
    braked = entry(Wedge(0.2), slowing, "wagner", 1.0, [0.7])
    assert float(braked.section_acceleration[0]) > 0
    assert float(braked.section_force[0]) > 0
    assert float(braked.peak_pressure[0]) > 0


@pytest.mark.parametrize(
    ("action", "words"),
    [
        (
            lambda: entry(Wedge(0.2), TURNING, "generalised-wagner", 1.0, [0.6]),
            "which the method generalised-wagner does not",
        ),
        (lambda: entry(Wedge(0.2), TURNING, "nonlinear", 1.0, [0.6]), "which the method nonlinear does not"),
        (lambda: entry(Wedge(0.2), TURNING, "wagner", 1.0, [0.6, 0.9]), "has left the water by 0.9 s"),
        (lambda: VelocityHistory((0.0, 1.0), (-1.0, 2.0)), "downward entry velocity"),
        (lambda: VelocityHistory((0.0, 1.0), (1.0, np.inf)), "velocity of the history"),
        (lambda: entry(Wedge(0.2), 0.0, "wagner", 1.0, [0.6]), "is given as a velocity history"),
    ],
)
def test_refusals(action, words):
    with pytest.raises(InputError, match=words):
        action()
