import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact.entry import entry
from workbench.impact.free_surface import free_surface, level_elevation, wagner_elevation
from workbench.impact.generalised_wagner import wedge_flow
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.impact.similarity import similarity_solution

SECTIONS = (
    Wedge(np.radians(20)),
    Parabola(5.0),
    Circle(2.0),
    TableSection(((0.0, 0.0), (0.5, 0.0), (1.0, 0.1), (2.0, 0.5))),
)
WETTED = 1.3


@pytest.mark.parametrize("section", SECTIONS, ids=lambda one: one.kind)
def test_wagners_surface_meets_the_section_at_the_contact_point(section):
    elevation = float(wagner_elevation(section, WETTED, WETTED))
    depth = section.mean_height(WETTED)
    assert elevation == pytest.approx(float(section.height(WETTED)) - depth, rel=1e-12)


@pytest.mark.parametrize("section", SECTIONS, ids=lambda one: one.kind)
def test_wagners_surface_holds_the_water_that_was_displaced(section):
    x = np.linspace(0.0, 14.0, 4001)
    y = WETTED * np.cosh(x)
    risen = np.trapezoid(wagner_elevation(section, WETTED, y) * WETTED * np.sinh(x), x)
    inside = np.linspace(0.0, WETTED, 4001)
    displaced = np.trapezoid(section.mean_height(WETTED) - section.height(inside), inside)
    assert risen == pytest.approx(displaced, rel=1e-4)


@pytest.mark.parametrize("section", SECTIONS, ids=lambda one: one.kind)
def test_wagners_surface_falls_like_the_square_of_the_distance(section):
    near, far = wagner_elevation(section, WETTED, np.array([100.0, 1000.0]))
    assert near / far == pytest.approx(100.0, rel=1e-3)
    assert far > 0


def test_wagners_surface_beside_a_wedge_and_a_parabola_in_closed_form():
    y = WETTED * np.array([1.0, 1.0001, 1.01, 1.5, 10.0])
    beta, radius = np.radians(20), 5.0
    wedge = 2 / np.pi * np.tan(beta) * (y * np.arcsin(WETTED / y) - WETTED)
    assert wagner_elevation(Wedge(beta), WETTED, y) == pytest.approx(wedge, abs=1e-12)
    parabola = y / (2 * radius) * (y - np.sqrt(y**2 - WETTED**2)) - WETTED**2 / (4 * radius)
    assert wagner_elevation(Parabola(radius), WETTED, y) == pytest.approx(parabola, abs=1e-12)


def test_a_wedge_given_as_a_table_has_the_wedges_surface():
    slope = np.tan(np.radians(20))
    table = TableSection(tuple((y, y * slope) for y in (0.0, 0.7, 1.0, 2.0)))
    y = WETTED * np.array([1.0, 1.1, 2.0, 7.0])
    expected = wagner_elevation(SECTIONS[0], WETTED, y)
    assert wagner_elevation(table, WETTED, y) == pytest.approx(expected, abs=1e-13)


def test_wagners_surface_needs_a_wetted_part():
    with pytest.raises(InputError, match="wetted half-breadth must be a finite number > 0 m"):
        wagner_elevation(SECTIONS[0], 0.0, 1.0)


@pytest.mark.parametrize("degrees", [5, 20, 45, 70])
def test_surface_of_the_generalised_model_meets_the_wedge_and_falls_off(degrees):
    beta, depth = np.radians(degrees), 0.4
    edge = wedge_flow(beta).spread * depth
    at_edge, near, far, farther = level_elevation(beta, depth, edge * np.array([1.0, 1.3, 20.0, 200.0]))
    assert at_edge == pytest.approx(edge * np.tan(beta) - depth, rel=1e-8)
    assert 0 < near < at_edge
    assert far / farther == pytest.approx(100.0, rel=0.05)


def test_surface_of_the_generalised_model_tends_to_wagners_at_small_deadrise():
    beta = np.radians(2)
    y = np.pi / 2 / np.tan(beta) * np.array([1.05, 1.5, 4.0])
    expected = wagner_elevation(Wedge(beta), np.pi / 2 / np.tan(beta), y)
    assert level_elevation(beta, 1.0, y) == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize(
    "method", ["von-karman", "wagner", "logvinovich", "generalised-wagner", "similarity"]
)
def test_every_surface_starts_on_the_section_and_reaches_far(method):
    wedge = Wedge(np.radians(25))
    found = entry(wedge, 2.0, method, times=(0.1, 0.2))
    surface = free_surface(wedge, found, 6.0)
    assert surface.position.shape == surface.height.shape == (2, surface.position.shape[1])
    start = wedge.height(surface.position[:, 0]) - found["penetration"].values
    assert surface.height[:, 0] == pytest.approx(start, abs=1e-8)
    assert np.all(surface.position[:, -1] >= 6.0 * (1 - 1e-12))
    assert np.all(np.abs(surface.height[:, -1]) < 0.02)


def test_surface_of_the_exact_wedge_is_that_of_the_solution():
    beta = np.radians(25)
    whole = similarity_solution(beta).surface
    surface = free_surface(Wedge(beta), entry(Wedge(beta), 2.0, "similarity", times=(0.1,)), 1.0)
    here = (surface.position[0] + 1j * surface.height[0]) / 0.2
    near = here[(here.imag < whole[0].imag) & (here.real < 20)]
    order = np.argsort(-whole.imag)
    assert np.interp(-near.imag, -whole[order].imag, whole[order].real) == pytest.approx(near.real, rel=0.01)
    tip = similarity_solution(beta).wall_length * np.sin(beta) - 1
    assert here[0].imag == pytest.approx(tip, rel=1e-6)


def test_theories_without_a_surface_give_none_and_a_given_surface_is_taken():
    circle = Circle(2.0)
    found = entry(circle, 2.0, "generalised-wagner", times=(0.05,))
    assert free_surface(circle, found, 3.0) is None
    assert free_surface(SECTIONS[0], entry(SECTIONS[0], 2.0, "chuang"), 3.0) is None
    given = found.assign(
        surface_position=(("time", "surface_point"), [[1.0, 2.0]]),
        surface_height=(("time", "surface_point"), [[0.3, 0.1]]),
    )
    assert free_surface(circle, given, 3.0).height.tolist() == [[0.3, 0.1]]
    inwards = given.isel(surface_point=slice(None, None, -1))
    assert free_surface(circle, inwards, 3.0).height.tolist() == [[0.3, 0.1]]
