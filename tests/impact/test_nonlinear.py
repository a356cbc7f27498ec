"""Non-linear water entry: exact wedge, balances, other starts, other sections, and what is refused."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact import nonlinear_start
from workbench.impact.entry import VelocityHistory, _motion_at, entry
from workbench.impact.entry_range import validity
from workbench.impact.nonlinear import March
from workbench.impact.nonlinear_entry import begun, expected_steps
from workbench.impact.nonlinear_surface import body_nodes, grading, nearest, on_section, regridded
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.quantities import warnings_of
from workbench.verification import nonlinear_balance, nonlinear_cases

TIMES = (0.0, 0.1, 0.2, 0.3, 0.4)


def found(section, method="nonlinear", velocity=1.0, times=(1.0,)):
    return entry(section, velocity, method, 1000.0, times)


def wedge_table(degrees, *breadths):
    return TableSection(tuple((y, y * np.tan(np.radians(degrees))) for y in (0.0, *breadths)))


@pytest.mark.parametrize("degrees", [15, 33, 48, 65])
def test_wedge_at_constant_velocity(degrees):
    """Angles between those of the verification cases, at another depth and velocity."""
    here, exact = (found(Wedge(np.radians(degrees)), m, 3.0, [0.2, 0.7]) for m in ("nonlinear", "similarity"))
    for name in ("section_force", "peak_pressure"):
        assert here[name].to_numpy() == pytest.approx(exact[name].to_numpy(), rel=0.01)
    assert here["wetted_rate"].to_numpy() == pytest.approx(
        here["wetted_half_breadth"] / here["time"], rel=1e-12
    )
    y, pressure = (here[name].to_numpy()[1] for name in ("pressure_position", "section_pressure"))
    assert 2 * np.trapezoid(pressure, y) == pytest.approx(float(here["section_force"][1]), rel=5e-3)
    known = np.interp(y, exact["pressure_position"][1], exact["section_pressure"][1])
    assert np.abs(pressure - known).max() < 0.06 * known.max()


def test_average_over_the_whole_is_the_force():
    averages = entry(Wedge(np.radians(48)), 3.0, "nonlinear", 1000.0, [0.2, 0.7], [(0, 5)])
    force = averages["section_force"].to_numpy()
    assert 10 * averages["panel_pressure"][:, 0].to_numpy() == pytest.approx(force, rel=1e-3)


def test_free_surface_is_carried_on_as_that_of_a_dipole():
    wedge = Wedge(np.radians(48))
    start = nonlinear_start.started(wedge, 1.0, 1.0)
    near = start.points.real < 9 * start.points[0].real
    short = start._replace(points=start.points[near], potential=start.potential[near])
    carried = regridded(short, wedge, 1.0)
    assert carried.points[-1].real == pytest.approx(16 * start.points[0].real, rel=1e-3)
    beyond = carried.points[carried.points.real >= short.points[-1].real * (1 - 1e-9)]
    moment = (beyond.imag - 1) * beyond.real**2
    assert moment == pytest.approx(moment[0], rel=1e-6)
    exact = np.interp(beyond.real, start.points.real, start.points.imag - 1)
    assert beyond.imag - 1 == pytest.approx(exact, rel=0.05)


@pytest.mark.parametrize("degrees", [20, 50])
def test_free_surface_is_that_of_the_exact_wedge(degrees):
    here, exact = (
        found(Wedge(np.radians(degrees)), method, 2.0, [0.5]).isel(time=0)
        for method in ("nonlinear", "similarity")
    )
    points, known = (
        one["surface_position"].to_numpy() + 1j * one["surface_height"].to_numpy() for one in (here, exact)
    )
    fine = np.interp(np.linspace(0, len(known) - 1, 20000), np.arange(len(known)), known)
    apart = np.abs(points[:, None] - fine[None, :]).min(axis=1)
    near = points.real < 3 * points[0].real
    assert apart[near].max() < 0.01 * float(here["wetted_half_breadth"])
    assert float(exact["surface_height"][0]) == pytest.approx(float(exact["jet_height"]), rel=1e-9)
    assert abs(points[-1].imag) < 0.01
    assert points[-1].real > 10 * float(here["wetted_half_breadth"])


def test_another_start_is_forgotten():
    """Begun with the flow of a wedge of 40 degrees: 3 % off at first, then that of 45 degrees."""
    first, later = (nonlinear_cases.other_start_force(45, 40, growth) for growth in (1.0001, 2.5))
    assert abs(first - 1) > 0.025
    assert later == pytest.approx(1, abs=0.01)


@pytest.mark.parametrize("change", [-2.0, 20.0])
def test_pressure_is_the_rate_of_momentum_when_the_velocity_changes(change):
    velocity = VelocityHistory(TIMES, tuple(2 + change * time for time in TIMES))
    march = begun(Wedge(np.radians(40)), _motion_at(velocity), 0.2)
    march.to(0.1)
    assert nonlinear_balance.momentum_ratio(march, 8) == pytest.approx(1, abs=3e-3)


def test_water_is_neither_lost_nor_gained():
    wedge = Wedge(np.radians(40))
    march = March(wedge, lambda time: (time, 1.0, 0.0), 1.0, nonlinear_start.started(wedge, 1.0, 1.0))
    raised, immersed = nonlinear_balance.displaced_area(march)
    assert raised == pytest.approx(immersed, rel=3e-3)
    assert nonlinear_balance.volume_error(march, 1.5) == pytest.approx(0, abs=4e-3)


def test_velocity_history_that_is_constant():
    """Stepped from a third of the depth, it is the settled wedge; several instants in one run."""
    wedge = Wedge(np.radians(45))
    stepped = found(wedge, velocity=VelocityHistory((0.0, 1.0, 2.0), (2.0, 2.0, 2.0)), times=[0.3, 0.5])
    settled = found(wedge, velocity=2.0, times=[0.3, 0.5])
    for name in ("section_force", "peak_pressure", "wetted_half_breadth", "wetted_rate"):
        assert stepped[name].to_numpy() == pytest.approx(settled[name].to_numpy(), rel=5e-3)


def test_slowing_wedge_against_the_generalised_wagner_model():
    velocity = VelocityHistory(TIMES, (2.0, 1.8, 1.6, 1.4, 1.2))
    here, other = (
        found(Wedge(np.radians(25)), m, velocity, [0.1]) for m in ("nonlinear", "generalised-wagner")
    )
    assert float(here["section_force"][0]) == pytest.approx(float(other["section_force"][0]), rel=0.03)


def test_wedge_as_a_table():
    """A corner that does not turn changes nothing."""
    here = found(wedge_table(40, 1.0, 3.0), times=[1.0])
    known = found(Wedge(np.radians(40)))
    for name in ("section_force", "peak_pressure", "wetted_half_breadth"):
        assert float(here[name][0]) == pytest.approx(float(known[name][0]), rel=0.01)
    assert "jet is kept" in warnings_of(here)[-1]


def test_sharp_corners_are_warned_of():
    section = TableSection(((0.0, 0.0), (1.0, 0.4), (2.0, 1.4)))
    wet, dry = (np.array([breadth]) for breadth in (1.2, 0.8))
    turn = "turns by 23.2 degrees"
    assert turn in " ".join(validity(section, "nonlinear", wet, wet))
    assert turn not in " ".join(validity(section, "nonlinear", dry, dry))
    assert turn not in " ".join(validity(section, "wagner", wet, wet))


def test_parabola_against_wagner_and_generalised_wagner():
    here, wagner, other = (
        found(Parabola(2.0), method, 3.0, [0.05 / 3]).isel(time=0)
        for method in ("nonlinear", "wagner", "generalised-wagner")
    )
    assert float(here["section_force"]) == pytest.approx(float(other["section_force"]), rel=0.03)
    assert float(here["section_force"]) < 0.85 * float(wagner["section_force"])
    assert float(here["wetted_half_breadth"]) == pytest.approx(float(wagner["wetted_half_breadth"]), rel=0.01)
    assert float(here["wetted_rate"]) == pytest.approx(float(other["wetted_rate"]), rel=0.03)


@pytest.mark.parametrize("section", [Wedge(0.5), Parabola(2.0), Circle(2.0), wedge_table(20, 0.4, 3.0)])
def test_nearest_point_and_nodes_of_the_body(section):
    breadth = np.array([0.2, 0.7, 1.3])
    tangent = 1 + 1j * section.slope(breadth)
    points = on_section(section, breadth) - 0.3j * tangent / np.abs(tangent)
    assert nearest(section, points) == pytest.approx(breadth, rel=1e-9)
    nodes = body_nodes(section, 1.0, grading(section, 0.9))
    assert nodes[[0, -1]] == pytest.approx([0, 1 + 1j * section.height(1.0)])
    assert np.all(np.diff(nodes.real) > 0)
    assert not isinstance(section, TableSection) or np.isclose(nodes.real, 0.4).any()


@pytest.mark.parametrize(
    ("section", "time", "words"),
    [
        (Wedge(np.radians(3)), 1.0, ">= 4 and <= 80"),
        (Wedge(np.radians(84)), 1.0, ">= 4 and <= 80"),
        (TableSection(((0.0, 0.0), (1.0, 0.0), (2.0, 0.5))), 0.1, "flat bottom"),
        (Parabola(1.0), 0.001, "begin at"),
        (wedge_table(50, 1.0), 1.0, "end of the section"),
    ],
)
def test_refusals(section, time, words):
    with pytest.raises(InputError, match=words):
        found(section, times=[time])


def test_too_many_steps_are_refused_at_once():
    """A flat wedge at varying velocity; the estimate is that of a steeper one within a third."""
    velocity = VelocityHistory(TIMES, (2.0, 1.8, 1.6, 1.4, 1.2))
    with pytest.raises(InputError, match="needs about"):
        found(Wedge(np.radians(4)), velocity=velocity, times=[0.3])
    wedge = Wedge(np.radians(40))
    march = March(wedge, lambda time: (time, 1.0, 0.0), 1.0, nonlinear_start.started(wedge, 1.0, 1.0))
    march.to(1.8)
    assert expected_steps(wedge, 1.0, 1.8) == pytest.approx(march.steps, rel=1 / 3)
