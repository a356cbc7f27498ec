"""Theories laid over each other: lines and points are the numbers given."""

import numpy as np
import pytest

from workbench import quantities
from workbench.figures import style
from workbench.figures.theories import theories_figure
from workbench.theory_comparison import measured_series

RATIOS = np.linspace(3.0, 0.5, 11)


@pytest.fixture
def motions():
    ratio = (
        np.linspace(1.0, 2.0, 3)[:, None, None] * np.linspace(1.0, 0.0, 11)[:, None] * np.array([1.0, 0.5])
    )
    lead = np.broadcast_to(np.linspace(-3.0, 3.0, 11)[:, None], (11, 2)) * np.ones((3, 1, 1))
    lead[:, 5:, 1] -= 2 * np.pi
    lead = np.angle(np.exp(1j * lead))
    return quantities.dataset(
        {
            "theory": ["strip", "high-speed", "potential-flow"],
            "omega": np.linspace(1, 2, 11),
            "dof": ["heave", "pitch"],
        },
        motion_ratio=(("theory", "omega", "dof"), ratio),
        motion_lead=(("theory", "omega", "dof"), lead),
        wavelength_over_length=("omega", RATIOS),
        theory_name=("theory", ["strip theory", "high-speed theory", "panel method"]),
    )


@pytest.fixture
def measured():
    points = np.array([[1.0, 0.4], [1.5, 0.6]])
    return tuple(
        measured_series(name, [1.0, 2.0], points, np.radians(points * 100) + turn, "a report")
        for name, turn in (("tank", 0.0), ("basin", 2 * np.pi))
    )


def test_lines_and_points_are_the_numbers_given(motions, measured):
    figure = theories_figure(motions, measured)
    heave, pitch, heave_lead, _ = figure.axes
    for axes, mode in ((heave, "heave"), (pitch, "pitch")):
        lines = axes.get_lines()
        assert len(lines) == 5
        for index in range(3):
            np.testing.assert_allclose(lines[index].get_xdata(), RATIOS)
            np.testing.assert_allclose(lines[index].get_ydata(), motions.motion_ratio.sel(dof=mode)[index])
        np.testing.assert_allclose(lines[3].get_ydata(), measured[0].motion_ratio.sel(dof=mode))
    np.testing.assert_allclose(heave_lead.get_lines()[4].get_ydata(), [100.0, 150.0])
    words = [text.get_text() for text in figure.legends[0].get_texts()]
    assert words == ["strip theory", "high-speed theory", "panel method", "tank", "basin"]
    assert heave.get_title(loc="left") == "heave over wave amplitude [-]"
    assert pitch.get_title(loc="left") == "pitch over wave slope [-]"
    assert "[deg]" in heave_lead.get_ylabel()
    assert len(style.picture(figure)) > 10_000


def test_phases_are_not_drawn_across_the_jump_nor_where_nothing_moves(motions):
    figure = theories_figure(motions)
    for axes in figure.axes[2:]:
        for line in axes.get_lines():
            degrees = np.asarray(line.get_ydata())
            assert np.isnan(degrees[-1])
            steps = np.diff(degrees)
            assert np.nanmax(np.abs(steps[np.isfinite(steps)])) < 180


def test_lines_are_told_apart_without_colour(motions, measured):
    lines = theories_figure(motions, measured).axes[0].get_lines()
    looks = {(line.get_linestyle(), line.get_marker(), line.get_markerfacecolor()) for line in lines}
    assert len({look[:2] for look in looks}) == 5


def test_legend_stays_within_the_figure(motions, measured):
    figure = theories_figure(motions, measured)
    figure.canvas.draw()
    box = figure.legends[0].get_window_extent()
    assert box.x0 >= 0
    assert box.x1 <= figure.bbox.width
    assert box.y0 >= figure.axes[0].get_window_extent().y1
