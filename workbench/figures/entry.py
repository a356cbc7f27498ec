"""Water entry of sections: pressure over the section by theory, and wedges of every deadrise against the exact one."""

from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workbench.errors import checked_choice
from workbench.figures import style
from workbench.impact.entry_case import THEORIES
from workbench.theory_lines import THEORY_LINES

PRESSURE_SIZE, DEADRISE_SIZE = (7.2, 3.6), (9.7, 3.8)
ABOVE_PEAK = 1.25
"""End of the axis of pressure over the largest finite peak: outer pressures are infinite at their edge [-]."""

COEFFICIENTS = {
    "peak_coefficient": "peak pressure over $\\rho V^2/2$ [-]",
    "force_coefficient": "force over $\\rho V^3 t$ [-]",
}


def theory_line(method: str) -> dict:
    """Options of matplotlib for the line of a theory."""
    colour, dash, width = THEORY_LINES[method]
    return {"color": colour, "linestyle": (0, dash) if dash else "-", "linewidth": width}


def entry_pressure_figure(
    found: Mapping[str, xr.Dataset], index: int = -1, *, panel: tuple[float, float] | None = None
) -> Figure:
    """Pressure over the half-breadth at one instant, a line for each theory, its peak as a point.

    Parameters
    ----------
    found : entries by method, of the same case (`workbench.impact.entry_case.compared_entries`).
    index : of the instant.
    panel : inner and outer half-breadth to shade [m].
    """
    at = {method: one.isel(time=index) for method, one in found.items() if "section_pressure" in one}
    if not at:
        return style.message_figure("No theory gives a pressure over this section.", PRESSURE_SIZE)
    with style.drawing():
        figure = style.blank_figure(PRESSURE_SIZE)
        axes = style.single_axes(figure, right=2.3)
        for method, one in at.items():
            line = theory_line(method)
            axes.plot(one.pressure_position, one.section_pressure / 1e3, label=THEORIES[method], **line)
            if np.isfinite(one.peak_pressure):
                edge = _peak_position(one)
                axes.plot(edge, float(one.peak_pressure) / 1e3, "o", color=line["color"], markersize=5)
        peaks = [float(one.peak_pressure) for one in at.values() if np.isfinite(one.peak_pressure)]
        if not peaks:
            peaks = [4 * float(one.section_pressure[0]) for one in at.values()]
        axes.set_ylim(0, ABOVE_PEAK * max(peaks) / 1e3)
        wetted = [
            float(one.wetted_half_breadth) for one in at.values() if np.isfinite(one.wetted_half_breadth)
        ]
        axes.set_xlim(0, 1.3 * max([*wetted, panel[1] / 1.2 if panel else 0.0]))
        if panel is not None:
            axes.axvspan(*panel, color="#f0a30a", alpha=0.13, linewidth=0)
        first = next(iter(at.values()))
        axes.set_xlabel("distance from the centreline y [m]")
        axes.set_ylabel("pressure [kPa]")
        axes.set_title(
            f"{float(first.penetration):.3g} m deep at {float(first.entry_velocity):.3g} m/s", loc="left"
        )
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
        style.grid_behind(axes)
    return figure


def _peak_position(one: xr.Dataset) -> float:
    """Half-breadth of the peak [m]: of the largest pressure, or the edge where that is infinite."""
    pressure = one.section_pressure.values
    largest = int(np.argmax(pressure))
    if pressure[largest] > 1.05 * float(one.peak_pressure):
        return float(one.wetted_half_breadth)
    return float(one.pressure_position[largest])


def deadrise_figure(
    wedges: xr.Dataset, *, relative_to: str | None = None, coefficients: Sequence[str] = tuple(COEFFICIENTS)
) -> Figure:
    """Coefficients of wedges over deadrise, a line for each theory.

    Parameters
    ----------
    wedges : from `workbench.impact.entry_case.wedge_coefficients`.
    relative_to : a theory to divide by, such as the exact wedge "similarity"; None draws the
        coefficients themselves on a logarithmic axis.
    coefficients : of `COEFFICIENTS`, a graph each.
    """
    methods = [str(name) for name in wedges.entry_theory.values]
    if relative_to is not None:
        checked_choice("The theory to divide by", relative_to, methods)
    degrees = np.degrees(wedges.deadrise_angle.values)
    with style.drawing():
        figure = style.blank_figure(DEADRISE_SIZE)
        figure.subplots_adjust(left=0.075, right=0.985, top=0.77, bottom=0.15, wspace=0.2)
        graphs = np.atleast_1d(figure.subplots(1, len(coefficients)))
        for axes, name in zip(graphs, coefficients, strict=True):
            for method in methods:
                values = wedges[name].sel(entry_theory=method).values
                if relative_to is not None:
                    values = values / wedges[name].sel(entry_theory=relative_to).values
                axes.plot(degrees, values, label=THEORIES[method], **theory_line(method))
            _finish(axes, COEFFICIENTS[name], relative_to, degrees)
        handles, labels = graphs[-1].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper center", ncols=min(len(labels), 4), columnspacing=1.4)
        style.grid_behind(graphs)
    return figure


def _finish(axes: Axes, title: str, relative_to: str | None, degrees: np.ndarray) -> None:
    if relative_to is None:
        axes.set_yscale("log")
        axes.set_title(title, loc="left")
    else:
        axes.set_title(f"{title.split(' over ')[0]} over that of the {THEORIES[relative_to]} [-]", loc="left")
        axes.set_ylim(bottom=0)
    axes.set_xlim(degrees.min(), degrees.max())
    axes.set_xlabel("deadrise [deg]")
