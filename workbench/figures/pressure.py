"""How hard: peak pressures of the slams of a realisation."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from workbench.figures import style

BINS = 24


def pressure_histogram_figure(events: xr.Dataset, *, expected_peak: float, hours: float) -> Figure:
    """Histogram of the peak pressures of all entries, with the most probable largest of the worst point.

    Parameters
    ----------
    events : with ``peak_pressure`` (event) [Pa].
    expected_peak : most probable largest peak pressure [Pa]; hours : in which it is expected [h].
    """
    pressures = events.peak_pressure.values / 1e3
    if pressures.size == 0:
        return style.message_figure("No slam was counted in this realisation.")
    top = style.rounded_up(max(float(pressures.max()), expected_peak / 1e3))
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure, top=0.62, right=0.32)
        axes.hist(
            pressures,
            bins=np.linspace(0, top, BINS + 1),
            color=style.ACCENT,
            edgecolor="white",
            linewidth=0.6,
        )
        axes.axvline(
            pressures.max(),
            color=style.INK,
            linestyle=":",
            linewidth=1.8,
            label=f"largest counted {style.number_words(pressures.max())} kPa",
        )
        if expected_peak > 0:
            axes.axvline(
                expected_peak / 1e3, color=style.WARM, linestyle="--", linewidth=1.8,
                label=f"most probable in {hours:g} h {style.number_words(expected_peak / 1e3)} kPa",
            )  # fmt: skip
        axes.set_yscale("log")
        axes.set_ylim(bottom=0.7)
        axes.set_xlim(0, top)
        axes.set_xlabel("peak pressure of an entry [kPa]")
        axes.set_ylabel("number of entries [-]")
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.1)
        axes.xaxis.set_major_locator(MaxNLocator(5))
        style.grid_behind(axes)
    return figure


def panel_pressure_histogram_figure(slams: xr.Dataset) -> Figure:
    """Histogram of the largest panel pressures of all slams: of the slam's hardest panel, and of every panel met.

    Parameters
    ----------
    slams : with ``slam_pressure`` (slam) and ``slam_panel_pressure`` (slam, x, y) [Pa].
    """
    hardest = slams.slam_pressure.values / 1e3
    if hardest.max(initial=0.0) <= 0:
        return style.message_figure("The deck stays dry in this realisation.")
    every = slams.slam_panel_pressure.values.ravel() / 1e3
    top = style.rounded_up(float(hardest.max()))
    bins = np.linspace(0, top, BINS + 1)
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure, top=0.62, right=0.32)
        axes.hist(
            every[every > 0], bins=bins, color="#a9c5d6", edgecolor="white", linewidth=0.6,
            label="every panel in every slam",
        )  # fmt: skip
        axes.hist(
            hardest[hardest > 0], bins=bins, color=style.ACCENT, edgecolor="white", linewidth=0.6,
            label="hardest panel of each slam",
        )  # fmt: skip
        axes.set_yscale("log")
        axes.set_ylim(bottom=0.7)
        axes.set_xlim(0, top)
        axes.set_xlabel("largest panel pressure of a slam [kPa]")
        axes.set_ylabel("number [-]")
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.1)
        axes.xaxis.set_major_locator(MaxNLocator(5))
        style.grid_behind(axes)
    return figure
