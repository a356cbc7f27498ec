import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact.entry import VelocityHistory
from workbench.impact.entry_case import (
    THEORIES,
    EntryCase,
    compared_entries,
    is_quick,
    usual_penetration,
    wedge_coefficients,
)
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.impact.similarity import similarity_solution

WEDGE = Wedge(np.radians(20))
TABLE = TableSection(((0.0, 0.0), (1.0, 0.1), (2.0, 0.5)))


def test_braked_section_reaches_the_penetration_at_the_end():
    case = EntryCase(section=Parabola(5.0), velocity=3.0, penetration=0.25, deceleration=6.0)
    assert isinstance(case.motion, VelocityHistory)
    found = case.by("wagner", 7)
    assert found.time.values == pytest.approx(case.duration * np.arange(1, 8) / 7)
    assert float(found.penetration[-1]) == pytest.approx(0.25, rel=1e-12)
    assert float(found.entry_velocity[-1]) == pytest.approx(np.sqrt(9 - 2 * 6 * 0.25), rel=1e-12)
    assert found.section_acceleration.values == pytest.approx(-6.0)


def test_constant_velocity_is_a_number():
    case = EntryCase(section=WEDGE, velocity=2.0, penetration=0.5)
    assert case.motion == 2.0
    assert case.duration == pytest.approx(0.25)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"velocity": 0}, "velocity must be a finite number > 0"),
        ({"penetration": 0}, "penetration must be a finite number > 0"),
        ({"deceleration": 5.0}, "< 4 m/s2.*stops before the penetration"),
        ({"deceleration": -1.0}, "deceleration must be"),
        ({"panel": (-0.1, 0.2)}, "inner edge of the panel"),
        ({"panel": (0.5, 0.5)}, "outer edge of the panel must be a finite number > 0.5"),
        ({"section": TABLE, "penetration": 0.4}, "passed the end of the section"),
    ],
)
def test_refusals_are_sentences(changes, words):
    with pytest.raises(InputError, match=words):
        EntryCase(**{"section": WEDGE, "velocity": 2.0, "penetration": 0.5, **changes})


def test_every_theory_answers_or_says_why():
    case = EntryCase(section=Circle(2.0), velocity=2.0, penetration=0.1, panel=(0.1, 0.3))
    methods = tuple(name for name in THEORIES if name != "nonlinear")
    found, refused = compared_entries(case, methods, 3)
    assert set(found) == {"von-karman", "wagner", "logvinovich", "generalised-wagner"}
    assert set(refused) == {"similarity", "chuang"}
    assert all("wedges only" in sentence for sentence in refused.values())
    assert all(one.sizes == {"time": 3, "point": 201, "panel": 1} for one in found.values())


def test_quick_theories():
    assert is_quick(WEDGE, "generalised-wagner")
    assert not is_quick(TABLE, "generalised-wagner")
    assert is_quick(TABLE, "similarity")
    assert not any(is_quick(WEDGE, name) for name in ("similarity", "nonlinear"))


def test_usual_penetration_is_within_every_section():
    for section in (WEDGE, Parabola(5.0), Circle(0.3), TABLE):
        depth = usual_penetration(section)
        assert EntryCase(section=section, velocity=1.0, penetration=depth).duration > 0


def test_coefficients_of_wedges():
    angles = np.radians([20.0, 75.0])
    wedges = wedge_coefficients(angles, ("similarity", "wagner", "logvinovich", "chuang"))
    exact = similarity_solution(angles[0])
    one = wedges.sel(entry_theory="similarity").isel(deadrise_angle=0)
    assert float(one.peak_coefficient) == pytest.approx(2 * exact.peak, rel=1e-9)
    assert float(one.force_coefficient) == pytest.approx(exact.force, rel=1e-9)
    assert float(one.peak_height_ratio) == pytest.approx(
        exact.peak_position * np.sin(angles[0]) - 1, rel=1e-6
    )
    wagner = wedges.sel(entry_theory="wagner")
    assert wagner.peak_coefficient.values == pytest.approx((np.pi / 2 / np.tan(angles)) ** 2)
    assert wagner.wetted_rate_ratio.values == pytest.approx(np.pi / 2 / np.tan(angles))
    assert wagner.force_coefficient.values == pytest.approx(np.pi**3 / 4 / np.tan(angles) ** 2)
    assert np.isnan(wedges.peak_coefficient.sel(entry_theory="logvinovich")[1])
    assert np.all(np.isnan(wedges.force_coefficient.sel(entry_theory="chuang")))
