"""Filters without phase shift: high-pass, and decimation with its anti-alias filter."""

import numpy as np
import xarray as xr
from scipy import signal
from scipy.interpolate import CubicSpline

from workbench import quantities
from workbench.errors import InputError, checked_number

ORDER = 4
"""Order of the Butterworth filters; run to and fro, which squares their response and cancels their phase."""

PASSED_SHARE = 0.8
"""Cut-off of the anti-alias filter as a share of the new highest frequency."""


def high_passed(values, time_step: float, cutoff: float) -> np.ndarray:
    """Record without what is slower than a cut-off, (time, ...).

    Parameters
    ----------
    values : (time, ...); time_step : [s]; cutoff : [rad/s], where the amplitude is halved.
    """
    return _filtered(values, time_step, cutoff, "highpass")


def low_passed(values, time_step: float, cutoff: float) -> np.ndarray:
    """Record without what is faster than a cut-off, (time, ...); see `high_passed`."""
    return _filtered(values, time_step, cutoff, "lowpass")


def _filtered(values, time_step: float, cutoff: float, kind: str) -> np.ndarray:
    values = np.asarray(values, float)
    nyquist = np.pi / time_step
    checked_number(f"cut-off of the {kind} filter", cutoff, "rad/s", above=0, below=nyquist)
    sections = signal.butter(ORDER, cutoff / nyquist, kind, output="sos")
    margin = int(min(len(values) - 1, np.ceil(6 * np.pi / (cutoff * time_step))))
    if margin < 6:
        raise InputError(f"record must hold at least 7 samples to be filtered, got {len(values)}.")
    return signal.sosfiltfilt(sections, values, axis=0, padlen=margin)


def decimated(record_set: xr.Dataset, rate: float) -> xr.Dataset:
    """Record at a lower sampling rate, after an anti-alias filter.

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`; rate : new samples per second [Hz].

    Notes
    -----
    Low-passed at 0.8 of the new highest frequency (half amplitude there, 1 % lost at
    0.6 of it). Rates that do not divide the old one are met by a cubic spline.
    """
    step = float(record_set.attrs["time_step"])
    checked_number(
        "sampling rate",
        rate,
        "Hz",
        above=0,
        at_most=(1 + 1e-6) / step,
        cure="a record can only be thinned out",
    )
    every = 1 / (rate * step)
    if every < 1 + 1e-6:
        return record_set
    smooth = low_passed(record_set.measured.values, step, PASSED_SHARE * np.pi * rate)
    time = record_set.time.values
    if abs(every - round(every)) < 1e-6:
        chosen = slice(None, None, round(every))
        thinned, new_time = smooth[chosen], time[chosen]
    else:
        new_time = time[0] + np.arange(int((time[-1] - time[0]) * rate * (1 + 1e-12)) + 1) / rate
        thinned = CubicSpline(time, smooth)(new_time)
    return with_samples(record_set, new_time, thinned, 1 / rate)


def with_samples(
    record_set: xr.Dataset, time: np.ndarray, values: np.ndarray, time_step: float
) -> xr.Dataset:
    """Record of the same channels with other samples (time, channel)."""
    return quantities.dataset(
        {"time": time, "channel": record_set.channel, "channel_unit": record_set.channel_unit},
        method=record_set.attrs["method"],
        warnings=quantities.warnings_of(record_set),
        attrs={"time_step": float(time_step)},
        measured=(("time", "channel"), values),
    )
