"""Theories of the motions laid over each other, with what was measured."""

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from workbench.figures import style

SIZE = (9.7, 5.4)
MEASURED = (
    {"color": style.INK, "marker": "o", "markerfacecolor": style.INK},
    {"color": style.INK, "marker": "s", "markerfacecolor": "white"},
    {"color": style.INK, "marker": "^", "markerfacecolor": "white"},
)
"""Points of measured series, told apart by shape and filling."""
TITLES = {"heave": "heave over wave amplitude [-]", "pitch": "pitch over wave slope [-]"}
FAINT = 0.02
"""Phases of motions below this share of their peak are noise and not drawn [-]."""


def theories_figure(motions: xr.Dataset, measured: Sequence[xr.Dataset] = ()) -> Figure:
    """Amplitudes of heave and pitch above, their phases below, over wavelength: a line for each theory.

    Parameters
    ----------
    motions : from `workbench.theory_comparison.compared`.
    measured : Datasets of `workbench.theory_comparison.measured_series`, drawn as points.
    """
    with style.drawing():
        figure = style.blank_figure(SIZE)
        figure.subplots_adjust(left=0.083, right=0.985, top=0.86, bottom=0.1, wspace=0.16, hspace=0.12)
        rows = figure.subplots(2, 2, sharex=True, gridspec_kw={"height_ratios": (3, 2)})
        for column, mode in enumerate(motions.dof.values):
            _draw_lines(rows[:, column], motions.sel(dof=mode))
            for points, series in zip(MEASURED, measured, strict=False):
                _draw_points(rows[:, column], series.sel(dof=mode), points)
            rows[0, column].set_title(TITLES[str(mode)], loc="left")
            rows[0, column].set_ylim(bottom=0)
            rows[1, column].set_ylim(-190, 190)
            rows[1, column].set_yticks([-180, -90, 0, 90, 180])
        rows[1, 0].set_ylabel("lead over wave [deg]")
        along = motions.wavelength_over_length.values
        rows[1, 0].set_xlim(min(along), max(along))
        figure.supxlabel("wavelength over ship length $\\lambda/L$ [-]", fontsize=11, y=0.005)
        style.grid_behind(rows)
        handles, labels = rows[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper center", ncols=len(labels), columnspacing=1.6)
    return figure


def _draw_lines(column, one: xr.Dataset) -> None:
    """Draw amplitude and phase of one motion by every theory."""
    along = one.wavelength_over_length.values
    for index, line in zip(range(one.sizes["theory"]), style.LINES, strict=False):
        theory = one.isel(theory=index)
        ratio, degrees = theory.motion_ratio.values, np.degrees(theory.motion_lead.values)
        plain = {**line, "marker": ""}
        column[0].plot(along, ratio, label=str(theory.theory_name.values), **plain)
        degrees = np.where(ratio > FAINT * np.nanmax(ratio), degrees, np.nan)
        column[1].plot(along, _without_jumps(degrees), **plain)


def _draw_points(column, series: xr.Dataset, points: dict) -> None:
    """Draw one measured motion."""
    at = series.wavelength_over_length.values
    dots = {**points, "linestyle": "", "markersize": 5.5}
    degrees = np.degrees(np.angle(np.exp(1j * series.motion_lead.values)))
    column[0].plot(at, series.motion_ratio.values, label=series.attrs["name"], **dots)
    column[1].plot(at, degrees, **dots)


def _without_jumps(degrees: np.ndarray) -> np.ndarray:
    """Return phases with a gap where they pass from 180 to -180 degrees."""
    jumps = np.abs(np.diff(degrees, append=degrees[-1:])) > 180
    return np.where(jumps, np.nan, degrees)
