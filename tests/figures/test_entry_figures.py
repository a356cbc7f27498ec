"""Water entry: lines are the numbers given, and no theory is drawn that gives none."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.figures import style
from workbench.figures.entry import deadrise_figure, entry_pressure_figure
from workbench.impact.entry_case import EntryCase, compared_entries, wedge_coefficients
from workbench.impact.section import Wedge

METHODS = ("wagner", "von-karman", "generalised-wagner", "chuang")


@pytest.fixture(scope="module")
def found():
    case = EntryCase(section=Wedge(np.radians(20)), velocity=2.0, penetration=0.5)
    return compared_entries(case, METHODS, 2).found


def test_pressure_by_theory_with_finite_peaks_in_view(found):
    figure = entry_pressure_figure(found, panel=(0.5, 1.0))
    axes = figure.axes[0]
    labelled = [line for line in axes.lines if not line.get_label().startswith("_")]
    assert [line.get_label() for line in labelled] == ["Wagner", "von Karman", "generalised Wagner"]
    assert labelled[0].get_ydata()[0] == pytest.approx(float(found["wagner"].section_pressure[-1, 0]) / 1e3)
    top = axes.get_ylim()[1]
    for method in ("wagner", "generalised-wagner"):
        assert float(found[method].peak_pressure[-1]) / 1e3 < top
    points = [line for line in axes.lines if line.get_marker() == "o"]
    assert points[0].get_xdata()[0] == pytest.approx(float(found["wagner"].wetted_half_breadth[-1]))
    assert "[m]" in axes.get_xlabel()
    assert "[kPa]" in axes.get_ylabel()
    assert style.picture(figure).startswith(b"\x89PNG")


def test_von_karman_alone_has_no_peak_to_scale_by(found):
    axes = entry_pressure_figure({"von-karman": found["von-karman"]}).axes[0]
    assert axes.get_ylim()[1] == pytest.approx(5 * float(found["von-karman"].section_pressure[-1, 0]) / 1e3)


def test_without_a_distribution_there_is_a_sentence(found):
    figure = entry_pressure_figure({"chuang": found["chuang"]})
    assert "No theory gives a pressure" in figure.texts[0].get_text()


def test_wedges_over_deadrise_and_over_another_theory():
    wedges = wedge_coefficients(np.radians([10, 20, 30]), METHODS)
    plain = deadrise_figure(wedges)
    assert [axes.get_yscale() for axes in plain.axes] == ["log", "log"]
    force = plain.axes[1].lines[0]
    assert force.get_ydata() == pytest.approx(wedges.force_coefficient.sel(entry_theory="wagner").values)
    ratio = deadrise_figure(wedges, relative_to="wagner")
    assert ratio.axes[1].lines[0].get_ydata() == pytest.approx(1.0)
    assert ratio.axes[1].lines[1].get_ydata() == pytest.approx(4 / np.pi**2)
    assert "Wagner" in ratio.axes[0].get_title(loc="left")
    with pytest.raises(InputError, match="The theory to divide by"):
        deadrise_figure(wedges, relative_to="similarity")
