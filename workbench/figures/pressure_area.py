"""How large: the pressure averaged over areas from one panel to the whole deck."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from workbench.figures import style

_FEWEST = 5
"""Slams from which a median and a 90 % quantile are drawn."""

_LOWEST = 1e-3
"""Share of the largest pressure below which none is drawn [-]."""


def pressure_area_figure(slams: xr.Dataset) -> Figure:
    """Largest average pressure over any block of panels against its area, both logarithmic.

    Parameters
    ----------
    slams : of `workbench.pressure_stage.slam_pressures`: ``block_area`` [m2], ``block_pressure`` (block) and
        ``slam_block_pressure`` (slam, block) [Pa]. The record's largest is drawn and, with enough slams, what
        half and a tenth of them exceed.
    """
    area, largest = slams.block_area.values, slams.block_pressure.values / 1e3
    if slams.sizes["slam"] == 0 or largest.max(initial=0.0) <= 0:
        return style.message_figure("The deck stays dry in this realisation.")
    lines = [("largest of the record", largest)]
    if slams.sizes["slam"] >= _FEWEST:
        of_slams = slams.slam_block_pressure.values / 1e3
        lines += [
            (words, np.quantile(of_slams, share, axis=0))
            for words, share in (("10 % of slams above", 0.9), ("half of the slams above", 0.5))
        ]
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure, left=0.86)
        for (words, values), looks in zip(lines, style.LINES, strict=False):
            shown = values > _LOWEST * largest.max()
            axes.plot(area[shown], values[shown], label=words, **looks)
        axes.set_xscale("log")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(FuncFormatter(lambda value, _: style.number_words(value)))
            axis.set_minor_formatter(NullFormatter())
            axis.set_major_locator(LogLocator(subs=(1.0, 3.0) if axis is axes.yaxis else (1.0,)))
        axes.set_xlabel("area averaged over [m²]")
        axes.set_ylabel("average pressure [kPa]")
        axes.legend(loc="upper right", borderaxespad=0.2)
        axes.set_ylim(top=4 * largest.max())
        style.grid_behind(axes)
    return figure
