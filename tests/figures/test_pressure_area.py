"""Pressure against area, and the panel pressures of all slams."""

import numpy as np
import pytest
from test_figures import check_type, words

from workbench import quantities
from workbench.figures.pressure import panel_pressure_histogram_figure
from workbench.figures.pressure_area import pressure_area_figure


def slams(count=20):
    rng = np.random.default_rng(2)
    panel = rng.exponential(2e5, (count, 6, 3)) * (rng.random((count, 6, 3)) > 0.5)
    blocks = panel.max(axis=(1, 2))[:, None] * np.array([1.0, 0.7, 0.3, 0.1])
    return quantities.dataset(
        {"slam": np.arange(count), "x": np.arange(6.0), "y": np.arange(3.0), "block": np.arange(4)},
        slam_panel_pressure=(("slam", "x", "y"), panel),
        slam_pressure=("slam", panel.max(axis=(1, 2))),
        slam_block_pressure=(("slam", "block"), blocks),
        block_area=("block", [2.0, 4.0, 16.0, 36.0]),
        block_pressure=("block", blocks.max(axis=0, initial=0.0)),
    )


def test_pressure_falls_with_area_in_kilopascal():
    given = slams()
    figure = pressure_area_figure(given)
    (axes,) = figure.axes
    lines = {line.get_label(): line for line in axes.get_lines()}
    assert list(lines) == ["largest of the record", "10 % of slams above", "half of the slams above"]
    np.testing.assert_allclose(lines["largest of the record"].get_ydata(), given.block_pressure / 1e3)
    np.testing.assert_allclose(lines["largest of the record"].get_xdata(), given.block_area)
    exceeding = (given.slam_block_pressure.values / 1e3 > lines["10 % of slams above"].get_ydata()).mean(
        axis=0
    )
    np.testing.assert_allclose(exceeding, 0.1)
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    assert {"area averaged over [m²]", "average pressure [kPa]"} <= set(words(figure))
    check_type(figure)


def test_few_slams_have_no_quantiles_and_a_dry_deck_says_so():
    assert len(pressure_area_figure(slams(4)).axes[0].get_lines()) == 1
    for draw in (pressure_area_figure, panel_pressure_histogram_figure):
        assert "The deck stays dry in this realisation." in words(draw(slams(0)))


def test_histogram_counts_every_slam_and_every_panel_that_was_met():
    given = slams()
    figure = panel_pressure_histogram_figure(given)
    panels, hardest = (sum(bar.get_height() for bar in bars) for bars in figure.axes[0].containers)
    assert hardest == given.sizes["slam"]
    assert panels == pytest.approx(int((given.slam_panel_pressure > 0).sum()))
    assert "largest panel pressure of a slam [kPa]" in words(figure)
    check_type(figure)
