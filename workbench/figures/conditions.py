"""In which conditions does she slam: slams per hour and mean entry velocity over heading, speed or period."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from workbench.conventions import KNOT
from workbench.errors import InputError, checked_choice
from workbench.figures import style

WORDS = {
    "wave_direction": "heading, 180 is head seas [deg]",
    "forward_speed": "speed [kn]",
    "period": "{kind} period [s]",
}
LINE_WORDS = {"period": "{kind} period", "forward_speed": "speed"}
MOST_LINES = 7
_COLOURS = ("#0b6393", "#b5482a", "#5b7a1e", "#6b4a8e", "#8a6d1a", "#2c7d7a", "#a03a68")
_MARKERS = ("o", "s", "^", "D", "v", "P", "X")


def usual_abscissa(found: xr.Dataset) -> str:
    """What a study is drawn over: heading where it has several, else speed, else period."""
    for name in ("wave_direction", "forward_speed"):
        if found.sizes[name] > 1:
            return name
    return "period"


def conditions_figure(
    found: xr.Dataset, *, place: str, significant_wave_height: float, over: str | None = None
) -> Figure:
    """Slams per hour above, mean entry velocity below, a column for each speed, a line for each period.

    Parameters
    ----------
    found : from `workbench.condition_runs.slamming_of_conditions`; where it is counted, what was counted is drawn
        as points with its 99 % band beside the closed form.
    place : name of the place on the deck; significant_wave_height : one of the study [m].
    over : "wave_direction", "forward_speed" or "period"; None takes `usual_abscissa`. Over the speed the columns are
        headings, over the period they are headings and the lines are speeds.

    Notes
    -----
    Only conditions with at least one slam in the time of the study are drawn.
    """
    over = over or usual_abscissa(found)
    checked_choice("abscissa", over, tuple(WORDS))
    column, line = {
        "wave_direction": ("forward_speed", "period"),
        "forward_speed": ("wave_direction", "period"),
        "period": ("wave_direction", "forward_speed"),
    }[over]
    if found.sizes[line] > MOST_LINES:
        raise InputError(f"lines in one picture must be {MOST_LINES} at most, got {found.sizes[line]}.")
    chosen = found.sel(place=place, significant_wave_height=significant_wave_height, method=None)
    if not bool((chosen.is_slamming > 0).any()):
        return style.message_figure(
            f"{place}, Hs {significant_wave_height:g} m: less than one slam in {found.attrs['hours']:g} h everywhere."
        )
    columns = found.sizes[column]
    kind = found.attrs["period_kind"]
    words = WORDS[over].format(kind=kind)
    with style.drawing():
        width = max(4.8, min(0.9 + 2.95 * columns, 12.6))
        slamming = [
            number
            for number in range(found.sizes[line])
            if bool((chosen.isel({line: number}).is_slamming > 0).any())
        ]
        in_a_row = max(1, int((width - 0.6) / 1.05))
        head = 0.62 + 0.26 * (1 + (len(slamming) - 1) // in_a_row)
        height = 4.7 + head
        figure = style.blank_figure((width, height))
        figure.subplots_adjust(
            left=0.78 / width, right=1 - 0.18 / width, top=1 - head / height, bottom=0.56 / height,
            wspace=0.1, hspace=0.14,
        )  # fmt: skip
        rows = figure.subplots(2, columns, sharex=True, sharey="row", squeeze=False)
        for index in range(columns):
            of_column = chosen.isel({column: index})
            for number in slamming:
                _draw(rows[:, index], of_column.isel({line: number}), over, number, line)
            rows[0, index].set_title(_value_words(column, found[column].values[index]), loc="left")
        rows[0, 0].set_ylabel("slams per hour [1/h]")
        rows[1, 0].set_ylabel("mean entry velocity [m/s]")
        for axes in rows[:, 0]:
            axes.set_ylim(bottom=0)
            axes.yaxis.set_major_locator(MaxNLocator(5))
        _ends(rows[0, 0], found[over].values, over)
        style.grid_behind(rows)
        figure.supxlabel(words, fontsize=11, y=0.005)
        handles, labels = rows[0, 0].get_legend_handles_labels()
        title = f"{place}, $H_s$ {significant_wave_height:g} m; by {LINE_WORDS[line].format(kind=kind)}"
        figure.text(0.78 / width, 1 - 0.2 / height, title, fontsize=11, va="center")
        figure.legend(
            handles, labels, loc="upper left", ncols=min(len(labels), in_a_row), columnspacing=1.2,
            bbox_to_anchor=(0.66 / width, 1 - 0.3 / height), handlelength=1.8,
        )  # fmt: skip
    return figure


def _draw(column, one: xr.Dataset, over: str, number: int, line: str) -> None:
    """Draw one line of slams and velocities, and what was counted."""
    along = _shown(over, one[over].values)
    there = one.is_slamming.values > 0
    style_of = {"color": _COLOURS[number], "marker": _MARKERS[number]}
    label = _value_words(line, one[line].values)
    counted = "counted_per_hour" in one
    for axes, name in zip(column, ("slams_per_hour", "mean_entry_velocity"), strict=True):
        values = np.where(there, one[name].values, np.nan)
        plain = {"marker": ""} if counted else {}
        axes.plot(along, values, **{**style_of, **plain}, label=None if counted else label, markersize=5)
    if not counted or not there.any():
        if counted:
            column[0].plot([], [], **style_of, label=label)
        return
    number_counted = one.counted_per_hour.values
    reach = [
        np.maximum(number_counted - one.counted_band_low.values, 0.0)[there],
        np.maximum(one.counted_band_high.values - number_counted, 0.0)[there],
    ]
    column[0].errorbar(
        along[there], number_counted[there], yerr=reach, linestyle="", markersize=4.5, elinewidth=1.0,
        capsize=2, label=label, **style_of,
    )  # fmt: skip
    column[1].plot(
        along[there], one.counted_mean_velocity.values[there], linestyle="", markersize=4.5, **style_of
    )


def _shown(name: str, values) -> np.ndarray:
    values = np.asarray(values, float)
    if name == "wave_direction":
        return np.degrees(values)
    return values / KNOT if name == "forward_speed" else values


def _value_words(name: str, value) -> str:
    shown = style.number_words(float(_shown(name, value)))
    return {"wave_direction": f"heading {shown}°", "forward_speed": f"{shown} kn", "period": f"{shown} s"}[
        name
    ]


def _ends(axes, values, over: str) -> None:
    """Head seas on the left; ticks at the headings themselves."""
    shown = _shown(over, values)
    if over == "wave_direction":
        axes.set_xticks(np.round(shown, 3))
        if len(shown) > 1:
            axes.set_xlim(shown.max() + 4, shown.min() - 4)
    else:
        axes.xaxis.set_major_locator(MaxNLocator(6))
