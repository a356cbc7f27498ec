"""Figures of conditions and of pressure statistics draw the numbers that they are given."""

import numpy as np
import pytest
import xarray as xr

from workbench.errors import InputError
from workbench.figures import style
from workbench.figures.conditions import conditions_figure, usual_abscissa
from workbench.figures.pressure_statistics import class_pressures_figure, exceedance_figure

DIMS = ("place", "forward_speed", "wave_direction", "significant_wave_height", "period")
LEVELS = np.linspace(0.0, 1e5, 41)


def study(headings=(np.pi, 2.5, 2.0), speeds=(10.0, 15.0), periods=(8.0, 10.0), counted=False):
    shape = (1, len(speeds), len(headings), 2, len(periods))
    slams = np.arange(np.prod(shape), dtype=float).reshape(shape)
    slams[..., 0, :] = 0.0
    variables = {
        "slams_per_hour": slams,
        "mean_entry_velocity": 1 + slams / 100,
        "is_slamming": (slams > 2) * 1.0,
    }
    if counted:
        variables |= {
            "counted_per_hour": slams + 1, "counted_band_low": slams - 1, "counted_band_high": slams + 3,
            "counted_mean_velocity": 1.1 + slams / 100,
        }  # fmt: skip
    return xr.Dataset(
        {name: (DIMS, values) for name, values in variables.items()},
        coords={"place": ["wet deck"], "forward_speed": list(speeds), "wave_direction": list(headings),
                "significant_wave_height": [1.0, 3.0], "period": list(periods)},
        attrs={"hours": 1.0, "period_kind": "mean"},
    )  # fmt: skip


def texts(figure):
    figure.canvas.draw()
    found = figure.findobj(lambda one: hasattr(one, "get_fontsize") and hasattr(one, "get_text"))
    shown = [one for one in found if one.get_visible() and one.get_text()]
    assert min(one.get_fontsize() for one in shown) >= 10.0
    return " ".join(one.get_text() for one in shown)


def test_slams_over_heading_only_where_there_are_some():
    given = study()
    figure = conditions_figure(given, place="wet deck", significant_wave_height=3.0)
    first = figure.axes[0].get_lines()[0]
    one = given.isel(place=0, forward_speed=0, significant_wave_height=1, period=0)
    np.testing.assert_allclose(first.get_xdata(), np.degrees(one.wave_direction))
    there = one.is_slamming.values > 0
    assert not there.all()
    np.testing.assert_allclose(first.get_ydata()[there], one.slams_per_hour.values[there])
    assert np.isnan(first.get_ydata()[~there]).all()
    below = figure.axes[2].get_lines()[0]
    np.testing.assert_allclose(below.get_ydata()[there], one.mean_entry_velocity.values[there])
    words = texts(figure)
    assert "19.4 kn" in words
    assert "; by mean period" in words
    start, end = figure.axes[0].get_xlim()
    assert start > end  # head seas on the left
    assert style.picture(figure).startswith(b"\x89PNG")


def test_counted_slams_are_points_with_bands():
    given = study(counted=True)
    figure = conditions_figure(given, place="wet deck", significant_wave_height=3.0)
    bars = figure.axes[1].containers[0]
    one = given.isel(place=0, forward_speed=1, significant_wave_height=1, period=0)
    np.testing.assert_allclose(bars.lines[0].get_ydata(), one.counted_per_hour)
    assert "19.4 kn" in texts(figure)


@pytest.mark.parametrize(
    ("sizes", "over", "label"),
    [
        ({"headings": (2.3,)}, "forward_speed", "speed [kn]"),
        ({"headings": (2.3,), "speeds": (5.0,)}, "period", "mean period [s]"),
    ],
)
def test_what_varies_is_the_abscissa(sizes, over, label):
    given = study(**sizes)
    assert usual_abscissa(given) == over
    assert label in texts(conditions_figure(given, place="wet deck", significant_wave_height=3.0))


def test_calm_is_said_and_too_many_lines_are_refused():
    figure = conditions_figure(study(), place="wet deck", significant_wave_height=1.0)
    assert "less than one slam" in texts(figure)
    with pytest.raises(InputError, match="lines in one picture must be 7"):
        conditions_figure(study(periods=tuple(range(5, 14))), place="wet deck", significant_wave_height=3.0)
    with pytest.raises(InputError, match="abscissa must be one of"):
        conditions_figure(study(), place="wet deck", significant_wave_height=3.0, over="mass")


def test_pressures_of_the_classes_are_the_bars():
    classes = xr.Dataset(
        {"class_per_hour": ("velocity_class", [30.0, 8.0, 0.0]),
         "class_pressure": ("velocity_class", [5e4, 1.5e5, 2.5e5]),
         "class_mean_velocity": ("velocity_class", [1.0, 1.7, 2.2])}
    )  # fmt: skip
    figure = class_pressures_figure(classes, title="20 kn")
    assert [bar.get_height() for bar in figure.axes[0].patches] == [30.0, 8.0, 0.0]
    words = texts(figure)
    for expected in ("150\n1.7 m/s", "20 kn", "pressure of the class [kPa]"):
        assert expected in words
    figure.canvas.draw()
    label = figure.axes[0].xaxis.label.get_window_extent()
    assert label.y0 >= 0
    assert "No slam" in texts(class_pressures_figure(classes * 0))


def curve(number, half=0.0):
    values = {"exceedance_per_hour": ("pressure_level", number)}
    if half:
        values["exceedance_low"] = ("pressure_level", np.maximum(number - half, 0.0))
        values["exceedance_high"] = ("pressure_level", number + half)
    return xr.Dataset(values, coords={"pressure_level": LEVELS})


def test_exceedance_lines_and_bands():
    exact = 100 * np.exp(-LEVELS / 1e4)
    counted = np.round(exact)
    figure = exceedance_figure(
        {"closed form": curve(exact), "counted": curve(counted, 2.0)}, hours=50.0, title="panel"
    )
    line, step = figure.axes[0].get_lines()[:2]
    np.testing.assert_allclose(line.get_ydata(), exact[exact > 1e-4])
    np.testing.assert_allclose(line.get_xdata(), LEVELS[exact > 1e-4] / 1e3)
    np.testing.assert_allclose(step.get_ydata(), counted[counted > 0])
    words = texts(figure)
    for expected in ("once in 50 h", "counted, 99 % band", "slams per hour above $p$ [1/h]", "panel"):
        assert expected in words
    low, high = figure.axes[0].get_ylim()
    assert low < 1 / 50 < 100 < high
    assert "No slam" in texts(exceedance_figure({"dry": curve(0 * exact)}))
