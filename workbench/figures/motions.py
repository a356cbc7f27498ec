"""How the ship answers regular waves: motions per wave amplitude, and their phases."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from workbench.conventions import GRAVITY, MODES, ROTATIONS
from workbench.figures import style

ABSCISSAE = {
    "wave frequency": "wave frequency $\\omega$ [rad/s]",
    "encounter frequency": "encounter frequency $\\omega_e$ [rad/s]",
    "wavelength ratio": "wavelength over ship length $\\lambda/L$ [-]",
}
_SIZE = (9.7, 4.9)
_FAINT, _STILL = 0.01, 1e-6  # phases of motions smaller than this are noise and not drawn


def motions_figure(
    motion_set: xr.Dataset,
    lead: xr.DataArray,
    *,
    wave_direction: float,
    length: float,
    abscissa: str = "wave frequency",
    gap_frequency: float | None = None,
) -> Figure:
    """Heave, roll and pitch: amplitudes above, phase leads below.

    Parameters
    ----------
    motion_set : from `workbench.motions.motions`; lead : from `workbench.motions.lead_over_wave` [rad].
    wave_direction : the nearest computed one is drawn [rad].
    length : of the ship [m]; abscissa : one of `ABSCISSAE`.
    gap_frequency : at which the water between the hulls of a ship at rest resonates [rad/s];
        marked in the picture of heave where it lies within the axis.
    """
    one, phases = _at(motion_set, wave_direction), _at(lead, wave_direction)
    along, order = _abscissa(one, abscissa, length)
    with style.drawing():
        figure = style.blank_figure(_SIZE)
        figure.subplots_adjust(left=0.08, right=0.985, top=0.94, bottom=0.115, wspace=0.27, hspace=0.16)
        rows = figure.subplots(2, 3, sharex=True, gridspec_kw={"height_ratios": (3, 2)})
        for column, mode in enumerate(("heave", "roll", "pitch")):
            _draw_amplitude(rows[0, column], along, one, mode, order, column)
            degrees = np.degrees(phases.sel(dof=mode).values)[order]
            amplitude = np.abs(one.motion_rao.sel(dof=mode).values)[order]
            degrees = np.where(amplitude > _FAINT * max(amplitude.max(), _STILL), degrees, np.nan)
            axes = rows[1, column]
            axes.plot(along, degrees, linestyle="", marker=".", color=style.LINES[column]["color"])
            axes.set_ylim(-190, 190)
            axes.set_yticks([-180, -90, 0, 90, 180])
        rows[1, 0].set_ylabel("lead over wave [deg]")
        figure.supxlabel(ABSCISSAE[abscissa], fontsize=11, y=0.005)
        _finish(rows, abscissa)
        _mark_gap(rows[0, 0], gap_frequency, abscissa, length)
    return figure


def six_motions_figure(
    motion_set: xr.Dataset,
    *,
    wave_direction: float,
    length: float,
    abscissa: str = "wave frequency",
    gap_frequency: float | None = None,
) -> Figure:
    """Amplitudes of all six motions; parameters as for `motions_figure`."""
    one = _at(motion_set, wave_direction)
    along, order = _abscissa(one, abscissa, length)
    with style.drawing():
        figure = style.blank_figure(_SIZE)
        figure.subplots_adjust(left=0.08, right=0.985, top=0.94, bottom=0.115, wspace=0.2, hspace=0.3)
        rows = figure.subplots(2, 3, sharex=True)
        for index, mode in enumerate(MODES):
            _draw_amplitude(rows.flat[index], along, one, mode, order, index % 3)
        figure.supxlabel(ABSCISSAE[abscissa], fontsize=11, y=0.005)
        _finish(rows, abscissa)
        _mark_gap(rows.flat[MODES.index("heave")], gap_frequency, abscissa, length)
    return figure


def _at(table: xr.Dataset | xr.DataArray, wave_direction: float):
    """Return the table at the nearest computed direction."""
    away = np.angle(np.exp(1j * (table.wave_direction.values - wave_direction)))
    return table.isel(wave_direction=int(np.argmin(np.abs(away))))


def _abscissa(one: xr.Dataset, abscissa: str, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the values along the axis, rising, and the order that makes them rise."""
    values = {
        "wave frequency": lambda: one.omega.values,
        "encounter frequency": lambda: np.abs(one.encounter_frequency.values),
        "wavelength ratio": lambda: 2 * np.pi / one.wavenumber.values / length,
    }[abscissa]()
    order = np.argsort(values)
    return values[order], order


def _draw_amplitude(axes, along, one: xr.Dataset, mode: str, order, line: int) -> None:
    """Draw the amplitude of one motion, rotations in degrees per metre."""
    amplitude = np.abs(one.motion_rao.sel(dof=mode).values)[order]
    is_rotation = mode in ROTATIONS
    shown = np.degrees(amplitude) if is_rotation else amplitude
    axes.plot(along, shown, **{**style.LINES[line], "markersize": 3.5})
    axes.set_title(f"{mode} [{'deg/m' if is_rotation else 'm/m'}]", loc="left")
    inside = shown[along <= 6] if along[-1] > 12 else shown
    top = float(np.max(inside)) if inside.size else 1.0
    axes.set_ylim(0, max(1.15 * top, 0.1))
    if top < _STILL:
        axes.text(0.5, 0.5, "none", transform=axes.transAxes, ha="center", color=style.SOFT)


def _mark_gap(axes, gap_frequency: float | None, abscissa: str, length: float) -> None:
    """Draw a thin line where the water between the hulls resonates, if that is within the axis."""
    if gap_frequency is None:
        return
    over_length = 2 * np.pi * GRAVITY / gap_frequency**2 / length
    place = over_length if abscissa == "wavelength ratio" else gap_frequency
    low, high = axes.get_xlim()
    if not low < place < high:
        return
    axes.axvline(place, color=style.WARM, linewidth=0.9, linestyle=(0, (4, 3)))
    near_the_end = place > low + 0.93 * (high - low)
    axes.annotate(
        "gap resonance, estimated", (place, 0.97), xycoords=("data", "axes fraction"), rotation=90, va="top",
        xytext=(-2 if near_the_end else 2, 0), textcoords="offset points",
        ha="right" if near_the_end else "left", color=style.WARM, fontsize=10,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.5},
    )  # fmt: skip


def _finish(rows, abscissa: str) -> None:
    """Set limits and grid."""
    style.grid_behind(rows)
    for axes in rows.ravel():
        if abscissa == "wavelength ratio":
            axes.set_xlim(0, 5)
        else:
            axes.set_xlim(left=0)
