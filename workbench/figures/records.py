"""What a measured record says: the record itself, its spectrum with its band, and the response found from it."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from workbench.figures import style

_SI_WORDS = {"?": "", "1": ""}


def record_figure(
    record_set: xr.Dataset, channel: str, *, start: float, end: float, marks: np.ndarray | None = None
) -> Figure:
    """A stretch of one channel over time.

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`; channel : its name.
    start, end : of the stretch [s]; marks : times to mark, such as of slams [s].
    """
    one = record_set.measured.sel(channel=channel)
    inside = (one.time.values >= start) & (one.time.values <= end)
    unit = str(record_set.channel_unit.sel(channel=channel).item())
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        axes.plot(one.time.values[inside], one.values[inside], color=style.ACCENT, linewidth=1.0)
        marked = np.asarray([] if marks is None else marks, float)
        for place in marked[(marked >= start) & (marked <= end)]:
            axes.axvline(place, color=style.WARM, linewidth=1.2, linestyle="--", zorder=0)
        axes.set_xlim(start, end)
        axes.set_xlabel("time $t$ [s]")
        axes.set_ylabel(_with_unit(channel, unit))
        style.grid_behind(axes)
    return figure


def spectrum_figure(
    spectra: xr.Dataset, channel: str, *, highest: float, known: tuple[np.ndarray, np.ndarray] | None = None
) -> Figure:
    """Spectrum of one channel with its confidence band.

    Parameters
    ----------
    spectra : from `workbench.records.spectra.record_spectra`; channel : its name.
    highest : frequency at which the axis ends [rad/s].
    known : frequencies and ordinates of the spectrum that was to be found, where it is known.
    """
    one = spectra.sel(channel=channel)
    omega, unit = one.record_omega.values, str(one.channel_unit.item())
    percent = 100 * spectra.attrs["confidence"]
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        axes.fill_between(
            omega, one.spectrum_low, one.spectrum_high, color=style.ACCENT, alpha=0.2, linewidth=0,
            label=f"{percent:.0f} % band",
        )  # fmt: skip
        axes.plot(omega, one.record_spectrum, color=style.ACCENT, label="record")
        if known is not None:
            axes.plot(*known, color=style.WARM, linestyle="--", label="made from")
        axes.set_xlim(0, highest)
        axes.set_ylim(bottom=0)
        axes.set_xlabel("frequency of the record $\\omega_e$ [rad/s]")
        squared = f"({unit})$^2$" if "/" in unit else f"{unit}$^2$"
        axes.set_ylabel(f"spectrum of {channel} [{squared} s/rad]")
        axes.legend(loc="upper right")
        style.grid_behind(axes)
    return figure


def response_figure(
    response: xr.Dataset, channel: str, *, known: tuple[np.ndarray, np.ndarray] | None = None
) -> Figure:
    """Response of one channel found from spectra, in two estimates, with its standard error.

    Parameters
    ----------
    response : from `workbench.records.responses.estimated_response`; channel : its name.
    known : encounter frequencies and amplitudes that were to be found, where they are known.
    """
    one = response.sel(channel=channel)
    unit = str(one.channel_unit.item())
    per = "wave slope" if unit.startswith("rad") else "m"
    omega = one.record_omega.values
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        axes.errorbar(
            omega, one.cross_amplitude, yerr=one.response_error * one.cross_amplitude, fmt="o", markersize=4,
            color=style.ACCENT, elinewidth=1.0, label="cross-spectrum, standard error",
        )  # fmt: skip
        axes.plot(
            omega,
            one.response_amplitude,
            color=style.SOFT,
            marker=".",
            linestyle="",
            label="root of the ratio of spectra",
        )
        if known is not None:
            axes.plot(*known, color=style.WARM, label="made from", zorder=4)
        usable = omega[response.usable.values == 1]
        if len(usable):
            axes.set_xlim(0.9 * usable.min(), 1.05 * usable.max())
        axes.set_ylim(bottom=0)
        axes.set_xlabel("encounter frequency $\\omega_e$ [rad/s]")
        axes.set_ylabel(f"{channel} [{unit} per {per}]")
        axes.legend(loc="upper right")
        style.grid_behind(axes)
    return figure


def exceedance_figure(found: xr.Dataset, *, name: str, unit: str, limit: float | None = None) -> Figure:
    """Share of the crests above levels, counted and by Rayleigh's law.

    Parameters
    ----------
    found : from `workbench.records.crossings.exceedance`; name, unit : of the levels.
    limit : level to mark.
    """
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        seen = found.exceedance_counted.values > 0
        axes.plot(
            found.level.values[seen], found.exceedance_counted.values[seen], color=style.WARM, marker="o",
            markersize=4, linestyle="", label=f"counted, {found.attrs['waves']} waves",
        )  # fmt: skip
        axes.plot(found.level, found.exceedance_rayleigh, color=style.ACCENT, label="Rayleigh")
        if limit is not None:
            axes.axvline(
                limit, color="#4b6b3c", linestyle="--", linewidth=1.4, label=f"limit {limit:.3g} {unit}"
            )
        axes.set_yscale("log")
        axes.set_ylim(0.3 / found.attrs["waves"], 1.2)
        axes.set_xlim(left=0)
        axes.set_xlabel(_with_unit(f"crest of {name}", unit))
        axes.set_ylabel("share of crests above [-]")
        axes.legend(loc="lower left")
        style.grid_behind(axes)
    return figure


def _with_unit(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if _SI_WORDS.get(unit, unit) else name
