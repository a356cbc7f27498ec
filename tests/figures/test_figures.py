"""Figures show the numbers they are given, with units, in type that can be read."""

import numpy as np
import pytest
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES
from workbench.figures import clearance, counts, deck_plan, hull_lines, motions, pressure, style
from workbench.geometry.sections import sections, surface
from workbench.geometry.wet_deck import wet_deck_grid

LEAST_POINTS = 10.0


@pytest.fixture
def deck(twin):
    return wet_deck_grid(twin.wet_deck, 12, 4)


@pytest.fixture
def rate(deck):
    values = np.outer(np.linspace(0, 40, 12), np.ones(4))
    return xr.DataArray(
        values,
        coords={"x": deck.x, "y": deck.y},
        dims=("x", "y"),
        attrs=quantities.attributes("slams_per_hour"),
    )


@pytest.fixture
def motion_set():
    omega, directions = np.linspace(0.3, 2.0, 9), np.array([np.pi / 2, np.pi])
    rao = np.zeros((9, 2, 6), complex)
    rao[:, 1, 2], rao[:, 1, 4] = np.linspace(1, 0, 9), 0.05j * np.linspace(1, 0, 9)
    rao[:, 0, 3] = 0.1
    return quantities.dataset(
        {"omega": omega, "wave_direction": directions, "dof": list(MODES)},
        motion_rao=(("omega", "wave_direction", "dof"), rao),
        encounter_frequency=(("omega", "wave_direction"), np.stack([omega, 1.5 * omega], axis=1)),
        wavenumber=("omega", omega**2 / 9.80665),
    )


def words(figure):
    """All text of a figure that is drawn, with its size in points."""
    figure.canvas.draw()
    return {
        text.get_text(): text.get_fontsize()
        for text in figure.findobj(lambda one: hasattr(one, "get_fontsize") and hasattr(one, "get_text"))
        if text.get_visible() and text.get_text()
    }


def check_type(figure):
    sizes = words(figure)
    assert sizes
    assert min(sizes.values()) >= LEAST_POINTS
    assert style.picture(figure).startswith(b"\x89PNG")
    assert b"<svg" in style.picture(figure, "svg")[:800]
    return " | ".join(sizes)


def test_deck_plan_marks_the_worst_point_and_the_criterion(deck, rate):
    figure = deck_plan.deck_plan_figure(
        rate,
        deck,
        mark=(float(deck.x[-1]), 0.0),
        mark_label="worst: 40 /h",
        line_at=20.0,
        line_label="criterion 20 /h",
    )
    text = check_type(figure)
    assert "Slams per hour [1/h]" in text
    assert "worst: 40 /h" in text
    assert "criterion 20 /h" in text
    axes = figure.axes[0]
    marks = [line.get_xydata().tolist() for line in axes.lines if line.get_marker() == "o"]
    assert [[float(deck.x[-1]), 0.0]] in marks
    assert axes.get_xlim() == pytest.approx((-15.0, 15.0))
    assert axes.get_ylim() == pytest.approx((-3.0, 3.0))


def test_deck_plan_shows_pressure_in_kilopascal(deck, rate):
    found = (2000 * rate).assign_attrs(quantities.attributes("peak_pressure"))
    figure = deck_plan.deck_plan_figure(found, deck)
    assert "[kPa]" in check_type(figure)
    assert figure.axes[0].collections[0].get_clim()[1] <= 100


def test_deck_that_does_not_slam_says_so(deck, rate):
    assert "no slam" in check_type(deck_plan.deck_plan_figure(0 * rate, deck, nothing="no slam here"))


def test_clearance_figure_marks_now_and_least():
    heights = np.linspace(0.5, 5, 40)
    curve = quantities.dataset({"clearance": heights}, slams_per_hour=("clearance", 300 * np.exp(-heights)))
    figure = clearance.clearance_figure(
        curve, clearance=2.0, slams_per_hour=40.6, criterion_per_hour=20, least_clearance=2.71
    )
    text = check_type(figure)
    assert "now 2 m: 40.6 /h" in text
    assert "least 2.71 m" in text
    assert "[m]" in text
    assert "[1/h]" in text
    line = next(line for line in figure.axes[0].lines if len(line.get_xdata()) == 40)
    np.testing.assert_allclose(line.get_ydata(), 300 * np.exp(-heights))


def test_counts_figure_draws_bands_and_closed_form(deck, rate):
    dims = ("x", "y")
    counted = quantities.dataset(
        {"x": deck.x, "y": deck.y}, counted_per_hour=(dims, rate.values + 1),
        counted_band_low=(dims, rate.values - 3), counted_band_high=(dims, rate.values + 7),
    )  # fmt: skip
    exact = quantities.dataset({"x": deck.x, "y": deck.y}, slams_per_hour=(dims, rate.values))
    figure = counts.counts_figure(exact, counted, column=1, hours=2, seed=7)
    assert "2 h, seed 7" in check_type(figure)
    bars = figure.axes[0].collections[0].get_segments()
    assert bars[5][:, 1] == pytest.approx([rate.values[5, 1] - 3, rate.values[5, 1] + 7])


def test_classes_and_histogram():
    classes = quantities.dataset(
        {"velocity_class": np.arange(1, 4)}, class_limit=("velocity_class", [2.0, 4.0, 6.0]),
        class_count=("velocity_class", [30, 9, 1]),
    )  # fmt: skip
    figure = counts.velocity_classes_figure(classes)
    assert "30" in check_type(figure)
    assert [bar.get_height() for bar in figure.axes[0].patches] == [30, 9, 1]
    events = quantities.dataset({}, peak_pressure=("event", np.array([1e3, 5e4, 2e5])))
    text = check_type(pressure.pressure_histogram_figure(events, expected_peak=1.5e5, hours=1))
    assert "largest counted 200 kPa" in text
    assert "most probable in 1 h 150 kPa" in text
    none = events.isel(event=slice(0, 0))
    assert "No slam" in check_type(pressure.pressure_histogram_figure(none, expected_peak=0, hours=1))


@pytest.mark.parametrize("abscissa", list(motions.ABSCISSAE))
def test_motions_in_degrees_over_each_axis(motion_set, abscissa):
    lead = motion_set.motion_rao.real
    common = {"wave_direction": np.pi, "length": 40.0, "abscissa": abscissa}
    for figure in (
        motions.motions_figure(motion_set, lead, **common),
        motions.six_motions_figure(motion_set, **common),
    ):
        text = check_type(figure)
        assert "heave [m/m]" in text
        assert "pitch [deg/m]" in text
        assert motions.ABSCISSAE[abscissa] in text
    pitch = motions.motions_figure(motion_set, lead, **common).axes[2].lines[0]
    assert pitch.get_ydata().max() == pytest.approx(np.degrees(0.05))
    x = pitch.get_xdata()
    assert np.all(np.diff(x) > 0)
    first = {"wave frequency": 0.3, "encounter frequency": 0.45}
    assert x[0] == pytest.approx(first.get(abscissa, 2 * np.pi * 9.80665 / 2.0**2 / 40.0))


@pytest.mark.parametrize("abscissa", list(motions.ABSCISSAE))
@pytest.mark.parametrize(("drawn", "heave"), [("motions_figure", 0), ("six_motions_figure", 2)])
def test_gap_resonance_is_marked_where_it_is_within_the_axis(motion_set, abscissa, drawn, heave):
    given = (motion_set, motion_set.motion_rao.real)[: 2 if drawn == "motions_figure" else 1]
    common = {"wave_direction": np.pi, "length": 40.0, "abscissa": abscissa}

    def marked(frequency):
        figure = getattr(motions, drawn)(*given, **common, gap_frequency=frequency)
        check_type(figure)
        lines = [line for line in figure.axes[heave].lines if line.get_color() == style.WARM]
        return [line.get_xdata()[0] for line in lines]

    place = 2 * np.pi * 9.80665 / 1.4**2 / 40.0 if abscissa == "wavelength ratio" else 1.4
    assert marked(1.4) == pytest.approx([place])
    assert marked(0.05 if abscissa == "wavelength ratio" else 9.0) == []
    assert marked(None) == []


def test_hull_lines(twin, deck):
    check_type(hull_lines.body_plan_figure(sections(twin.hull, 21, 21)[0]))
    figure = hull_lines.arrangement_figure(*surface(twin.hull, 21, 11), deck, twin.masses.centre_of_gravity)
    assert "wet deck" in check_type(figure)
    for axes in figure.axes:
        box = axes.get_window_extent()
        metres = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
        assert box.width / metres[0] == pytest.approx(box.height / metres[1], rel=1e-3)


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (8541.3, "8540"),
        (0.4051, "0.405"),
        (12.34, "12.3"),
        (2.0, "2"),
        (0, "0"),
        (1.17e4, "11700"),
        (3e-7, "3e-07"),
    ],
)
def test_numbers_are_read_without_exponents(value, shown):
    assert style.number_words(value) == shown


@pytest.mark.parametrize(("value", "top"), [(394, 400), (0.0012, 0.0015), (7, 8), (0, 1), (1e4, 1e4)])
def test_limits_are_round(value, top):
    assert style.rounded_up(value) == pytest.approx(top)
