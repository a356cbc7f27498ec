"""Slams of the cross structure: k against impact angle, recorded against calculated, traces, design load."""

from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator

from workbench.errors import InputError
from workbench.figures import style
from workbench.impact import chuang

PLAIN = ("#0b6393", "#b5482a", "#5b7a1e", "#6b4a8e")
MARKERS = ("o", "s", "^", "D")
BAND = 0.25
"""Band about agreement that is drawn, as a share of the calculated pressure."""

KILO = 1e3


def coefficient_figure(groups: Mapping[str, xr.Dataset], *, largest_angle: float | None = None) -> Figure:
    """Back-calculated k against impact angle, with the prediction line and both small-angle laws.

    Parameters
    ----------
    groups : slams from `workbench.impact.slam_table.predicted_slams` by name, at most four; each with
        ``impact_angle`` and ``recorded_constant`` (event).
    largest_angle : end of the axis [rad]; None takes that of the slams.
    """
    if not 1 <= len(groups) <= len(PLAIN):
        raise InputError(f"groups of slams in one figure must be 1 to {len(PLAIN)}, got {len(groups)}.")
    if largest_angle is None:
        largest_angle = 1.1 * max(float(one.impact_angle.max()) for one in groups.values())
    angles = np.linspace(0, largest_angle, 600)
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        axes.plot(
            np.degrees(angles),
            chuang.impact_coefficient(angles),
            color=style.INK,
            label="prediction, program",
        )
        small = angles[angles <= np.radians(2.2)]
        axes.plot(
            np.degrees(small),
            chuang.impact_coefficient(small, "text"),
            color=style.INK,
            linestyle=":",
            label="eq. (2) below 2.2°",
        )
        for (name, one), colour, marker in zip(groups.items(), PLAIN, MARKERS, strict=False):
            axes.plot(
                np.degrees(one.impact_angle), one.recorded_constant, linestyle="", marker=marker, color=colour,
                markerfacecolor="none", markersize=4.5, label=name,
            )  # fmt: skip
        axes.set_xlim(0, np.degrees(largest_angle))
        axes.set_ylim(bottom=0)
        axes.set_xlabel(r"impact angle $\xi$ [deg]")
        axes.set_ylabel("pressure constant $k$ [-]")
        axes.legend(loc="upper right")
        style.grid_behind(axes)
    return figure


def agreement_figure(groups: Mapping[str, xr.Dataset]) -> Figure:
    """Recorded against calculated peak pressures, with the line of agreement and a band of a quarter.

    Parameters
    ----------
    groups : as for `coefficient_figure`, with ``recorded_pressure`` and ``peak_pressure`` (event) [Pa].
    """
    if not 1 <= len(groups) <= len(PLAIN):
        raise InputError(f"groups of slams in one figure must be 1 to {len(PLAIN)}, got {len(groups)}.")
    most = max(float(max(one.recorded_pressure.max(), one.peak_pressure.max())) for one in groups.values())
    top = style.rounded_up(most / KILO)
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        ends = np.array([0.0, top])
        axes.fill_between(
            ends, (1 - BAND) * ends, (1 + BAND) * ends, color=style.SOFT, alpha=0.15, linewidth=0
        )
        axes.plot(ends, ends, color=style.SOFT, linewidth=1.2, label="agreement, ±25 %")
        for (name, one), colour, marker in zip(groups.items(), PLAIN, MARKERS, strict=False):
            axes.plot(
                one.peak_pressure / KILO, one.recorded_pressure / KILO, linestyle="", marker=marker, color=colour,
                markerfacecolor="none", markersize=4.5, label=name,
            )  # fmt: skip
        axes.set_xlim(0, top)
        axes.set_ylim(0, top)
        axes.set_xlabel("calculated peak pressure [kPa]")
        axes.set_ylabel("recorded [kPa]")
        axes.legend(loc="upper left")
        style.grid_behind(axes)
    return figure


def traces_figure(
    record_set: xr.Dataset,
    gauges: Sequence[str],
    *,
    start: float,
    end: float,
    averages: xr.Dataset | None = None,
) -> Figure:
    """Pressure traces of gauges over a slam, each on a line of its own height, and averages over them.

    Parameters
    ----------
    record_set : with the gauges as channels [Pa]; gauges : names, the first drawn lowest.
    start, end : of the stretch [s].
    averages : from `workbench.records.gauge_averages.area_averages`, drawn below; optional.
    """
    inside = (record_set.time.values >= start) & (record_set.time.values <= end)
    time = KILO * (record_set.time.values[inside] - start)
    rows = [(gauge, record_set.measured.sel(channel=gauge).values[inside], style.ACCENT) for gauge in gauges]
    if averages is not None:
        kept = (averages.time.values >= start) & (averages.time.values <= end)
        rows = [
            *((f"mean {area}", averages.average_pressure.sel(gauge_area=area).values[kept], style.WARM)
              for area in averages.gauge_area.values[::-1]),
            *rows,
        ]  # fmt: skip
    step = 1.15 * max(float(np.ptp(values)) for _, values, _ in rows) / KILO
    with style.drawing():
        figure = style.blank_figure((4.8, 0.9 + 0.42 * len(rows)))
        axes = style.single_axes(figure, left=0.86, right=0.7)
        for number, (_, values, colour) in enumerate(rows):
            axes.axhline(number * step, color=style.SOFT, linewidth=0.5)
            axes.plot(time, values / KILO + number * step, color=colour, linewidth=1.1)
            axes.text(
                1.02, number * step, f"{values.max() / KILO:.3g}", va="center", color=colour,
                transform=axes.get_yaxis_transform(),
            )  # fmt: skip
        axes.set_yticks([number * step for number in range(len(rows))], [name for name, _, _ in rows])
        axes.set_xlim(0, KILO * (end - start))
        axes.set_xlabel(f"time after {start:.4g} s [ms]; at the right the largest [kPa]")
    return figure


def design_load_figure(load: xr.Dataset) -> Figure:
    """Design pressure along the centreline by station, and across.

    Parameters
    ----------
    load : from `workbench.impact.design_load.design_load`.
    """
    with style.drawing():
        figure = style.blank_figure((9.7, 2.8))
        figure.subplots_adjust(left=0.08, right=0.985, top=0.9, bottom=0.2, wspace=0.22)
        along, across = figure.subplots(1, 2, width_ratios=(2, 1))
        along.plot(load.station, load.attrs["area_share"] * load.design_line / KILO, color=style.ACCENT)
        along.invert_xaxis()
        along.xaxis.set_major_locator(MultipleLocator(2))
        along.set_ylim(bottom=0)
        along.set_xlabel("station (0 fore perpendicular)")
        along.set_ylabel("on the centreline [kPa]")
        across.plot(load.y, 100 * load.transverse_share, color=style.WARM)
        across.set_ylim(0, 105)
        across.set_xlabel("$y$, to port [m]")
        across.set_ylabel("share across [%]")
        style.grid_behind([along, across])
    return figure
