"""Motions of several ships, or of one ship under several choices, in one picture."""

from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from workbench.conventions import MODES, ROTATIONS
from workbench.errors import InputError, checked_choice
from workbench.figures import style

MOST_SHIPS = len(style.LINES)


def motions_comparison_figure(
    motion_sets: Mapping[str, xr.Dataset],
    *,
    wave_direction: float,
    modes: Sequence[str] = ("heave", "roll", "pitch"),
) -> Figure:
    """Amplitudes of motions over the encounter frequency, a line for each ship.

    Parameters
    ----------
    motion_sets : from `workbench.motions.motions` or `workbench.sailing.sailing_motions`, by name; at most four.
    wave_direction : the nearest computed one of each is drawn [rad].
    modes : side by side; rotations are in degrees per metre of wave amplitude.
    """
    if not 1 <= len(motion_sets) <= MOST_SHIPS:
        raise InputError(
            f"ships in one picture must be 1 to {MOST_SHIPS}, got {len(motion_sets)}; draw several pictures."
        )
    for mode in modes:
        checked_choice("mode of the picture", mode, MODES)
    with style.drawing():
        figure = style.blank_figure((3.23 * max(len(modes), 1), 3.6))
        figure.subplots_adjust(left=0.07, right=0.985, top=0.82, bottom=0.17, wspace=0.22)
        row = np.atleast_1d(figure.subplots(1, len(modes)))
        for axes, mode in zip(row, modes, strict=True):
            for line, one in zip(style.LINES, motion_sets.values(), strict=False):
                away = np.angle(np.exp(1j * (one.wave_direction.values - wave_direction)))
                chosen = one.isel(wave_direction=int(np.argmin(np.abs(away))))
                along = np.abs(chosen.encounter_frequency.values)
                order = np.argsort(along)
                shown = np.abs(chosen.motion_rao.sel(dof=mode).values)
                shown = np.degrees(shown) if mode in ROTATIONS else shown
                axes.plot(along[order], shown[order], **{**line, "markersize": 3})
            axes.set_title(f"{mode} [{'deg/m' if mode in ROTATIONS else 'm/m'}]", loc="left")
            axes.set_xlim(left=0)
            axes.set_ylim(bottom=0)
        style.grid_behind(row)
        figure.supxlabel("encounter frequency $\\omega_e$ [rad/s]", fontsize=11, y=0.01)
        figure.legend(row[0].get_lines(), list(motion_sets), loc="upper center", ncols=len(motion_sets))
    return figure
