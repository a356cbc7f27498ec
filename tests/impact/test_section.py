import numpy as np
import pytest
from scipy.integrate import quad

from workbench.errors import InputError
from workbench.impact.section import (
    Circle,
    Parabola,
    TableSection,
    Wedge,
    contact_half_breadth,
    contact_rate,
)

SECTIONS = (
    Wedge(np.radians(20)),
    Parabola(2.0),
    Circle(1.5),
    TableSection(((0.0, 0.2), (0.3, 0.2), (0.8, 0.3), (1.4, 0.7))),
)


@pytest.mark.parametrize("section", SECTIONS, ids=lambda section: section.kind)
@pytest.mark.parametrize("c", [0.5, 1.2])
def test_means_are_wagners_integrals(section, c):
    """Mean of f(c sin theta), and its derivative, by quadrature."""

    def mean(of):
        marks = [np.arcsin(y / c) for y in (0.3, 0.8) if y < c]
        return quad(of, 0, np.pi / 2, points=marks or None)[0] * 2 / np.pi

    assert section.mean_height(c) == pytest.approx(
        mean(lambda a: float(section.height(c * np.sin(a)))), rel=1e-9
    )
    found = mean(lambda a: float(section.slope(c * np.sin(a))) * np.sin(a))
    assert section.mean_slope(c) == pytest.approx(found, rel=1e-7)


def test_wetted_half_breadths_in_closed_form():
    """Wagner: pi h/(2 tan beta) and 2 sqrt(R h); calm water: h/tan beta and sqrt(2 R h)."""
    wedge, parabola = Wedge(np.radians(20)), Parabola(2.0)
    tangent = np.tan(np.radians(20))
    assert contact_half_breadth(wedge, 0.3, True) == pytest.approx(np.pi * 0.3 / (2 * tangent), rel=1e-12)
    assert contact_half_breadth(wedge, 0.3, False) == pytest.approx(0.3 / tangent, rel=1e-12)
    assert contact_half_breadth(parabola, 0.3, True) == pytest.approx(2 * np.sqrt(0.6), rel=1e-12)
    assert contact_half_breadth(parabola, 0.3, False) == pytest.approx(np.sqrt(1.2), rel=1e-12)
    assert contact_rate(parabola, 2 * np.sqrt(0.6), 1.5, True) == pytest.approx(
        1.5 * np.sqrt(2.0 / 0.3), rel=1e-12
    )


def test_a_flat_bottom_is_wet_at_once():
    flat = TableSection(((0.0, 0.0), (0.5, 0.0), (1.0, 0.5)))
    assert contact_half_breadth(flat, 1e-8, True) == pytest.approx(0.5, abs=1e-4)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        (((0, 0),), "at least two points"),
        (((0.1, 0), (1, 1)), "centreline"),
        (((0, 0), (1, 1), (2, 1.5)), "concave at y = 1"),
        (((0, 1), (1, 0), (2, 1)), "concave at y = 0"),
        (((0, 0), (1, 1), (1, 2)), "overhangs"),
        (((0, 0), (1, 1), (0.9, 2)), "overhangs"),
        (((0, 0), (1, 0)), "flat to its end"),
        (((0, 0), (1, np.nan)), "z of the section"),
    ],
)
def test_what_the_theories_do_not_hold_for_is_refused(points, words):
    with pytest.raises(InputError, match=words):
        TableSection(points)


@pytest.mark.parametrize("make", [Wedge, Parabola, Circle])
@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, None, "x"])
def test_bad_sizes_are_refused(make, value):
    with pytest.raises(InputError):
        make(value)


def test_water_over_the_end_is_refused():
    with pytest.raises(InputError, match="reaches the end of the section"):
        contact_half_breadth(Circle(1.0), 0.9, True)
    with pytest.raises(InputError, match=r"below 0\.7 m"):
        contact_half_breadth(TableSection(((0, 0), (1, 0.7))), 0.8, False)
