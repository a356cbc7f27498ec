"""Does counting agree: slams counted against the closed form, and their classes of velocity."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from workbench.figures import style


def counts_figure(
    statistics: xr.Dataset, counts: xr.Dataset, *, column: int, hours: float, seed: int
) -> Figure:
    """Counted slams per hour with their 99 % bands, and the closed form, along one line of the deck.

    Parameters
    ----------
    statistics : with ``slams_per_hour`` (x, y); counts : from `workbench.slamming.events.counts`.
    column : index of y; hours, seed : of the realisation.
    """
    exact, counted = statistics.isel(y=column), counts.isel(y=column)
    x, number = exact.x.values, counted.counted_per_hour.values
    low, high = counted.counted_band_low.values, counted.counted_band_high.values
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        axes.errorbar(
            x, number, yerr=[np.maximum(number - low, 0), np.maximum(high - number, 0)], fmt="o",
            markersize=4,
            color=style.WARM, elinewidth=1.1, capsize=2, label="counted, 99 % band",
        )  # fmt: skip
        axes.plot(x, exact.slams_per_hour.values, color=style.ACCENT, label="closed form", zorder=4)
        axes.set_xlabel("$x$, forward of amidships [m]")
        axes.set_ylabel("slams per hour [1/h]")
        axes.set_ylim(0, style.rounded_up(float(max(high.max(), exact.slams_per_hour.max()))))
        axes.set_title(f"along y = {float(exact.y):.2g} m; {hours:g} h, seed {seed}", loc="left")
        axes.legend(loc="upper left")
        style.grid_behind(axes)
    return figure


def velocity_classes_figure(classes: xr.Dataset) -> Figure:
    """Number of slams in classes of entry velocity squared (pressure goes with the square)."""
    limits = np.concatenate([[0.0], classes.class_limit.values])
    number = classes.class_count.values
    if number.sum() == 0:
        return style.message_figure("No slam was counted in this realisation.")
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        middle, width = (limits[1:] + limits[:-1]) / 2, np.diff(limits)
        axes.bar(middle, number, width=0.86 * width, color=style.ACCENT)
        for at, count in zip(middle, number, strict=True):
            axes.text(at, count, f"{int(count)}", ha="center", va="bottom")
        axes.set_xticks(limits, [f"{limit:.3g}" for limit in limits])
        axes.set_xlabel("entry velocity squared [m²/s²]")
        axes.set_ylabel("number of entries [-]")
        axes.yaxis.set_major_locator(MaxNLocator(5, integer=True))
        axes.margins(y=0.12)
        style.grid_behind(axes)
        axes.xaxis.grid(visible=False)
    return figure
