"""How much clearance: slams per hour at the worst point against the clearance of the deck."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from workbench import quantities
from workbench.figures import style

DECADES = 4.0


def clearance_figure(
    curve: xr.Dataset,
    *,
    clearance: float,
    slams_per_hour: float,
    criterion_per_hour: float,
    least_clearance: float,
) -> Figure:
    """Slams per hour against clearance, with criterion, present clearance and the least that meets it.

    Parameters
    ----------
    curve : from `workbench.slamming.criteria.clearance_curve`.
    clearance, slams_per_hour : of the deck as it is.
    criterion_per_hour, least_clearance : of `workbench.pipeline.Slamming`.
    """
    rates = curve.slams_per_hour.values
    highest = style.rounded_up(max(float(rates.max()), 2 * criterion_per_hour))
    lowest = min(criterion_per_hour / 10, highest / 10**DECADES * 100)
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        axes.axhspan(lowest, criterion_per_hour, color="#e7f1e4", zorder=0)
        axes.plot(curve.clearance.values, np.maximum(rates, lowest / 100), color=style.ACCENT)
        axes.axhline(criterion_per_hour, color="#4b6b3c", linestyle="--", linewidth=1.4)
        axes.text(
            1.0, criterion_per_hour, f"criterion {criterion_per_hour:g} /h",
            transform=axes.get_yaxis_transform(),
            ha="right", va="bottom", color="#3a5530", fontsize=10.5,
        )  # fmt: skip
        axes.plot(
            clearance, np.clip(slams_per_hour, lowest, highest), marker="o", markersize=9, linestyle="",
            color=style.WARM,
            label=f"now {style.number_words(clearance)} m: {style.number_words(slams_per_hour)} /h",
            clip_on=False, zorder=5,
        )  # fmt: skip
        if curve.clearance.values[0] <= least_clearance <= curve.clearance.values[-1]:
            axes.plot(
                least_clearance, criterion_per_hour, marker="D", markersize=8, linestyle="", color="#3a5530",
                label=f"least {style.number_words(least_clearance)} m", zorder=5,
            )  # fmt: skip
        axes.set_yscale("log")
        axes.set_ylim(lowest, highest)
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.set_xlim(float(curve.clearance.values[0]), float(curve.clearance.values[-1]))
        axes.set_xlabel(quantities.axis_label(curve.clearance))
        axes.set_ylabel("slams per hour, worst point [1/h]")
        axes.legend(loc="lower left")
        style.grid_behind(axes)
    return figure
