"""How hard and how often: pressures by class, and slams per hour above each pressure."""

from collections.abc import Mapping

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from workbench.figures import style

DECADES = 6.0
"""Powers of ten of slams per hour that are drawn at most."""


def class_pressures_figure(classes: xr.Dataset, *, title: str = "") -> Figure:
    """Slams per hour in each class of velocity squared, over the pressure of the class.

    Parameters
    ----------
    classes : from `workbench.slamming.pressure_classes`, or one condition of a study.
    title : above the figure.
    """
    number, pressure = classes.class_per_hour.values, classes.class_pressure.values / 1e3
    velocity = classes.class_mean_velocity.values
    if not number.sum() > 0:
        return style.message_figure("No slam in this condition.")
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure, top=0.36 if title else 0.28, bottom=0.76)
        places = np.arange(len(number))
        axes.bar(places, number, width=0.8, color=style.ACCENT)
        for at, count in zip(places, number, strict=True):
            axes.text(at, count, f"{style.number_words(count, 2)}", ha="center", va="bottom")
        words = [
            f"{style.number_words(one)}\n{style.number_words(speed, 2)} m/s"
            for one, speed in zip(pressure, velocity, strict=True)
        ]
        axes.set_xticks(places, words)
        axes.set_xlabel("pressure of the class [kPa], mean entry velocity")
        axes.set_ylabel("slams per hour [1/h]")
        axes.yaxis.set_major_locator(MaxNLocator(5))
        axes.margins(y=0.12)
        axes.set_title(title, loc="left")
        style.grid_behind(axes)
        axes.xaxis.grid(visible=False)
    return figure


def exceedance_figure(
    curves: Mapping[str, xr.Dataset], *, hours: float | None = None, title: str = ""
) -> Figure:
    """Slams per hour above each pressure: lines for closed forms, steps with 99 % bands for what was counted.

    Parameters
    ----------
    curves : from `workbench.slamming.pressure_statistics` or `operating_profile`, at one point (``isel`` x and y), by
        name; at most four.
    hours : if given, the number that is expected once in so many hours is marked [h]; title : above the figure.
    """
    drawn = {name: one for name, one in curves.items() if float(one.exceedance_per_hour.max()) > 0}
    if not drawn:
        return style.message_figure("No slam at this place.")
    highest = max(
        float(one["exceedance_high" if "exceedance_high" in one else "exceedance_per_hour"].max())
        for one in drawn.values()
    )
    top = style.rounded_up(highest)
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure, top=0.36 if title else 0.2)
        ends, least = [], []
        for line, (name, one) in zip(style.LINES, drawn.items(), strict=False):
            pressure, number = one.pressure_level.values / 1e3, one.exceedance_per_hour.values
            if "exceedance_high" in one:
                shown = number > 0
                last = min(int(shown.sum()) + 1, len(shown))
                axes.fill_between(
                    pressure[:last], np.maximum(one.exceedance_low.values[:last], 1e-12),
                    one.exceedance_high.values[:last], step="post", color=line["color"], alpha=0.18, linewidth=0,
                )  # fmt: skip
                axes.step(
                    pressure[shown], number[shown], where="post", color=line["color"],
                    label=f"{name}, 99 % band",
                )  # fmt: skip
                ends.append(pressure[last - 1])
                least.append(number[shown].min() / 10)
            else:
                there = number > top / 10**DECADES
                axes.plot(
                    pressure[there],
                    number[there],
                    color=line["color"],
                    linestyle=line["linestyle"],
                    label=name,
                )
                ends.append(pressure[there][-1])
                least.append(number[there].min())
        bottom = max(min(least), top / 10**DECADES)
        if hours is not None and 1 / hours < top:
            bottom = max(min(bottom, 0.3 / hours), top / 10 ** (DECADES + 2))
            axes.axhline(1 / hours, color=style.SOFT, linestyle=":", linewidth=1.4)
            axes.text(
                0.01, 1 / hours, f"once in {hours:g} h", ha="left", va="bottom", color=style.SOFT,
                transform=axes.get_yaxis_transform(), fontsize=10.5,
            )  # fmt: skip
        axes.set_yscale("log")
        axes.set_ylim(bottom, 1.5 * top)
        axes.set_xlim(0, max(ends) * 1.02)
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.xaxis.set_major_locator(MaxNLocator(6))
        axes.set_xlabel("pressure $p$ [kPa]")
        axes.set_ylabel("slams per hour above $p$ [1/h]")
        axes.set_title(title, loc="left")
        axes.legend(loc="upper right")
        style.grid_behind(axes)
    return figure
