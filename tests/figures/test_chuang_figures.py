"""Figures of slams of the cross structure show the numbers they are given."""

import numpy as np
import pytest

from workbench.design import WetDeck
from workbench.errors import InputError
from workbench.figures import chuang as figures
from workbench.figures.style import picture
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.impact import chuang
from workbench.impact.design_load import design_load
from workbench.records.gauge_averages import area_averages
from workbench.records.reading import record
from workbench.verification.chuang_tables import model_slams, ship_mean_slams, ship_slams

RIGID, ELASTIC = model_slams(model="rigid"), model_slams(model="elastic")


def test_k_against_impact_angle():
    axes = figures.coefficient_figure({"rigid": RIGID, "elastic": ELASTIC}).axes[0]
    program, text, rigid, elastic = axes.lines
    assert program.get_ydata() == pytest.approx(chuang.impact_coefficient(np.radians(program.get_xdata())))
    assert text.get_ydata()[0] == pytest.approx(0.32)
    assert text.get_xdata()[-1] <= 2.2
    assert len(rigid.get_xdata()) == 41
    assert elastic.get_ydata() == pytest.approx(ELASTIC.recorded_constant.values)
    assert elastic.get_xdata() == pytest.approx(np.degrees(ELASTIC.impact_angle.values))
    assert axes.get_xlim()[1] == pytest.approx(1.1 * 21.66)


def test_k_of_the_ship():
    means = ship_mean_slams()
    figure = figures.coefficient_figure(
        {"mean": means, "I": ship_slams(case="I")}, largest_angle=np.radians(10)
    )
    shown = figure.axes[0].lines[2]
    assert shown.get_ydata() == pytest.approx(means.recorded_constant.values)
    assert len(shown.get_xdata()) == 12
    assert figure.axes[0].get_xlim() == pytest.approx((0, 10))
    assert picture(figure)[:4] == b"\x89PNG"


def test_recorded_against_calculated():
    axes = figures.agreement_figure({"rigid": RIGID}).axes[0]
    line, marks = axes.lines
    assert line.get_xdata() == pytest.approx(line.get_ydata())
    assert marks.get_xdata() == pytest.approx(RIGID.peak_pressure.values / 1e3)
    assert marks.get_ydata() == pytest.approx(RIGID.recorded_pressure.values / 1e3)


def test_too_many_groups_are_refused():
    for draw in (figures.coefficient_figure, figures.agreement_figure):
        with pytest.raises(InputError, match="1 to 4"):
            draw({str(number): RIGID for number in range(5)})


def test_traces_stand_above_one_another():
    time = np.arange(0, 1, 0.01)
    values = np.stack([np.sin(10 * time), np.cos(10 * time)], axis=1) * 2e3
    slam = record(time, values, ["P1", "P8"], ["Pa", "Pa"])
    axes = figures.traces_figure(slam, ["P1", "P8"], start=0.2, end=0.8, averages=area_averages(slam)).axes[0]
    assert [text.get_text() for text in axes.get_yticklabels()] == ["mean III", "P1", "P8"]
    step = axes.get_yticks()[1]
    drawn = [line for line in axes.lines if len(line.get_xdata()) > 2]
    assert drawn[2].get_ydata() - 2 * step == pytest.approx(values[20:81, 1] / 1e3)
    assert axes.get_xlim() == pytest.approx((0, 600))


def test_design_load_along_and_across():
    deck = wet_deck_grid(WetDeck(aft=-30.0, fore=30.0, width=10.0, clearance=3.0), 30, 8)
    load = design_load(deck, 70.0, 5.0)
    along, across = figures.design_load_figure(load).axes
    assert along.lines[0].get_ydata() == pytest.approx(load.design_line.values / 1e3)
    assert along.get_xlim()[0] > along.get_xlim()[1]
    assert across.lines[0].get_ydata() == pytest.approx(100 * load.transverse_share.values)
