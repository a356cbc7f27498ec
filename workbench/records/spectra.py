"""Spectra of records by Welch's method, with their confidence bands; runs that are short, averaged.

All spectra are one-sided over circular frequency [.. s/rad], so that their
integral is the variance.

.. [Welch1967] P. D. Welch, "The use of fast Fourier transform for the estimation of power
    spectra", IEEE Trans. Audio Electroacoust. AU-15, 70-73, 1967.
.. [BendatPiersol2010] J. S. Bendat and A. G. Piersol, "Random data", 4th ed., 2010, 11.5.
.. [Lloyd1989] A. R. J. M. Lloyd, "Seakeeping: ship behaviour in rough weather", 1989.
.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, appendix G.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 3.2 and 3.4.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from scipy import signal, stats

from workbench import quantities
from workbench.errors import InputError, checked_choice, checked_number

WINDOWS = ("hann", "cosine-taper")
DETRENDS = ("none", "constant", "linear")
SCALINGS = ("window", "record")

FEWEST_MEAN_PERIODS = 100
"""Mean periods a record should hold for statistics ([Lloyd1989]_)."""

_TAPERED_SHARE = 0.1


@dataclass(frozen=True, kw_only=True)
class SpectrumSettings:
    """How spectra are estimated.

    Parameters
    ----------
    segment : samples of a segment, >= 16. [Grande2002]_ takes 512 at 7 Hz and 256 at 4 Hz.
    overlap : of the segments, as a share, 0 to 0.9.
    window : "hann", or "cosine-taper" over 10 % of the segment at each end.
    detrend : what is taken off each segment: "none", its mean ("constant"), or its line ("linear").
    scaling : "window" divides by the power of the window (unbiased for stationary records);
        "record" scales to the variance of the record.
    confidence : of the band, 0.5 to 0.999.
    """

    segment: int = 512
    overlap: float = 0.5
    window: str = "hann"
    detrend: str = "constant"
    scaling: str = "window"
    confidence: float = 0.9

    def __post_init__(self):
        checked_number("segment", self.segment, "samples", at_least=16, at_most=2**22)
        if int(self.segment) != self.segment:
            raise InputError(f"segment must be a whole number of samples, got {self.segment!r}.")
        checked_number("overlap", self.overlap, at_least=0, at_most=0.9)
        checked_choice("window", self.window, WINDOWS)
        checked_choice("detrend", self.detrend, DETRENDS)
        checked_choice("scaling", self.scaling, SCALINGS)
        checked_number("confidence", self.confidence, at_least=0.5, at_most=0.999)

    @property
    def window_values(self) -> np.ndarray:
        """Window of a segment (segment)."""
        if self.window == "hann":
            return signal.windows.hann(int(self.segment), sym=False)
        return signal.windows.tukey(int(self.segment), 2 * _TAPERED_SHARE, sym=False)

    @property
    def overlapping(self) -> int:
        """Samples that neighbouring segments share."""
        return int(self.overlap * self.segment)

    def welch_arguments(self, time_step: float) -> dict:
        """Arguments of `scipy.signal.welch` and `scipy.signal.csd`."""
        return {
            "fs": 2 * np.pi / time_step,
            "window": self.window_values,
            "noverlap": self.overlapping,
            "detrend": False if self.detrend == "none" else self.detrend,
            "scaling": "density",
        }


def segment_for(resolution: float, time_step: float) -> int:
    """Samples of a segment that gives frequencies a resolution apart [rad/s], rounded up to a power of two."""
    checked_number("resolution", resolution, "rad/s", above=0)
    return int(2 ** np.ceil(np.log2(2 * np.pi / (resolution * time_step) * (1 - 1e-9))))


def segments_in(samples: int, settings: SpectrumSettings, time_step: float) -> int:
    """Number of segments in a record, or a refusal that says how long it must be."""
    if samples < settings.segment:
        needed = settings.segment * time_step
        raise InputError(
            f"record must be at least {needed:.4g} s long for frequencies {2 * np.pi / needed:.3g} rad/s apart "
            f"(segments of {settings.segment} samples), got {samples * time_step:.4g} s; take shorter segments."
        )
    return 1 + (samples - int(settings.segment)) // (int(settings.segment) - settings.overlapping)


def degrees_of_freedom(segments: int, settings: SpectrumSettings) -> float:
    """Equivalent degrees of freedom of a spectrum averaged over overlapping segments [-] ([Welch1967]_)."""
    window, step = settings.window_values, int(settings.segment) - settings.overlapping
    power = np.sum(window**2)
    spread = 1.0
    for lag in range(1, segments):
        shift = lag * step
        if shift >= len(window):
            break
        shared = np.sum(window[shift:] * window[:-shift]) / power
        spread += 2 * (1 - lag / segments) * shared**2
    return 2 * segments / spread


def record_spectra(record_set: xr.Dataset, settings: SpectrumSettings | None = None) -> xr.Dataset:
    """Spectra of all channels of a record, with confidence bands.

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`.

    Returns
    -------
    Dataset over (record_omega, channel): ``record_spectrum``, ``spectrum_low``,
    ``spectrum_high`` (chi-square band of ``settings.confidence``), and over channel
    ``record_mean``, ``record_std``, ``mean_period`` (T01), ``zero_crossing_period`` (T02).

    Notes
    -----
    Warns of channels with fewer than 100 mean periods ([Lloyd1989]_). Ordinates at zero
    and at the highest frequency have half the degrees of freedom; the band does not know.
    """
    settings = settings or SpectrumSettings()
    step = float(record_set.attrs["time_step"])
    values = record_set.measured.values
    segments = segments_in(len(values), settings, step)
    omega, found = signal.welch(values, axis=0, **settings.welch_arguments(step))
    if settings.scaling == "record":
        variance = np.mean(values**2, axis=0) if settings.detrend == "none" else np.var(values, axis=0)
        area = np.trapezoid(found, omega, axis=0)
        found = found * np.where(area > 0, variance / np.where(area > 0, area, 1.0), 1.0)
    freedom = degrees_of_freedom(segments, settings)
    tail = (1 - settings.confidence) / 2
    low, high = (freedom / stats.chi2.ppf(level, freedom) for level in (1 - tail, tail))
    periods = spectral_periods(omega, found)
    dims = ("record_omega", "channel")
    return quantities.dataset(
        {"record_omega": omega, "channel": record_set.channel, "channel_unit": record_set.channel_unit},
        method="Welch spectra",
        warnings=(
            *quantities.warnings_of(record_set),
            *length_notes(record_set, periods[0]),
            *_few_segments(segments),
        ),
        attrs={
            "segments": segments,
            "degrees_of_freedom": freedom,
            "confidence": settings.confidence,
            "time_step": step,
        },
        record_spectrum=(dims, found),
        spectrum_low=(dims, found * low),
        spectrum_high=(dims, found * high),
        record_mean=("channel", values.mean(axis=0)),
        record_std=("channel", values.std(axis=0)),
        mean_period=("channel", periods[0]),
        zero_crossing_period=("channel", periods[1]),
    )


def spectral_periods(omega: np.ndarray, spectrum: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mean period 2 pi m0/m1 and zero-crossing period 2 pi sqrt(m0/m2) of spectra (omega, ...) [s]."""
    weight = omega.reshape(-1, *[1] * (spectrum.ndim - 1))
    m0, m1, m2 = (np.trapezoid(weight**order * spectrum, omega, axis=0) for order in (0, 1, 2))
    with np.errstate(divide="ignore", invalid="ignore"):
        return 2 * np.pi * m0 / m1, 2 * np.pi * np.sqrt(m0 / m2)


def length_notes(record_set: xr.Dataset, mean_period: np.ndarray) -> list[str]:
    """Sentences about channels whose record is shorter than 100 mean periods."""
    duration = record_set.sizes["time"] * float(record_set.attrs["time_step"])
    notes = []
    for name, period in zip(record_set.channel.values, mean_period, strict=True):
        if np.isfinite(period) and duration < FEWEST_MEAN_PERIODS * period:
            notes.append(
                f"Channel {name} holds {duration / period:.0f} mean periods of {period:.2g} s; statistics want "
                f"{FEWEST_MEAN_PERIODS}, that is {FEWEST_MEAN_PERIODS * period:.0f} s (Lloyd 1989)."
            )
    return notes


def _few_segments(segments: int) -> list[str]:
    if segments >= 8:
        return []
    return [f"Spectra are averaged over {segments} segments only and scatter widely; see their bands."]


def slope_spectrum(omega, elevation_spectrum, wavenumber) -> np.ndarray:
    """Spectrum of the wave slope, k^2 S [rad2 s/rad] ([Grande2002]_ 3.2).

    Parameters
    ----------
    omega : frequencies of the ordinates, wave or encounter [rad/s]; wavenumber : there [rad/m].
    """
    omega, k = np.broadcast_arrays(np.asarray(omega, float), np.asarray(wavenumber, float))
    return k**2 * np.asarray(elevation_spectrum, float)


def run_spectrum(values, time_step: float, samples: int | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Spectrum of one short run as a whole ([Couser1996]_ G.2.1).

    Parameters
    ----------
    values : (time); time_step : [s].
    samples : of the transform, padded with zeros; None takes the next power of two.

    Returns
    -------
    Frequencies [rad/s] and ordinates.

    Notes
    -----
    Least-squares line off, Hann window, transform, then scaled so that the integral
    is the variance of the record about its line.
    """
    flat = signal.detrend(np.asarray(values, float), type="linear")
    size = int(samples or 2 ** int(np.ceil(np.log2(len(flat)))))
    if size < len(flat):
        raise InputError(
            f"samples of the transform must be at least those of the run, {len(flat)}, got {size}."
        )
    transform = np.fft.rfft(flat * signal.windows.hann(len(flat), sym=False), size)
    omega = 2 * np.pi * np.fft.rfftfreq(size, time_step)
    power = np.abs(transform) ** 2
    area = np.trapezoid(power, omega)
    return omega, power * (np.var(flat) / area if area > 0 else 0.0)


def averaged_runs(runs: Sequence, time_step: float) -> tuple[np.ndarray, np.ndarray]:
    """Average of the spectra of several short runs of the same condition, by `run_spectrum`.

    Parameters
    ----------
    runs : records (time), of any lengths, with one time step [s].
    """
    if not runs:
        raise InputError("runs must hold at least one record.")
    size = int(2 ** np.ceil(np.log2(max(len(run) for run in runs))))
    found = [run_spectrum(run, time_step, size) for run in runs]
    return found[0][0], np.mean([ordinates for _, ordinates in found], axis=0)
