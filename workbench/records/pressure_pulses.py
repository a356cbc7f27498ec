"""Pulses of pressure gauges in slams: the peak gauge, and which slams are too damped or irregular to compare.

The source analysed only slams "of a typical pulse shape" and gives no measure of it;
the criterion here is ours: a pulse that rises slowly is damped, one with another peak of
its own size is irregular.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, pp. 13, 15, 43.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np
import xarray as xr
from scipy.signal import find_peaks, peak_prominences

from workbench import quantities
from workbench.errors import checked_number
from workbench.records.gauge_averages import gauge_samples
from workbench.records.slam_reduction import impact_instants

FEWEST_IN_RISE = 3
"""Samples that the rise of a pulse must hold for its peak to be trusted."""


@dataclass(frozen=True, kw_only=True)
class PulseSettings:
    """What counts as a slam, and as a typical pulse.

    Parameters
    ----------
    least_pressure : of the largest gauge for a slam [Pa].
    window : time before and after the peak that belongs to the slam [s].
    longest_rise : from a tenth of the peak to the peak [s]; a slower rise is damped.
    largest_second_peak : prominence of another peak over the first [-]; above, the pulse is irregular.

    Notes
    -----
    The usual values are for a model like that of [Chuang1975]_, whose pulses last "a few
    milliseconds"; `scaled` brings them to a ship.
    """

    least_pressure: float
    window: float = 0.1
    longest_rise: float = 0.01
    largest_second_peak: float = 0.5

    def __post_init__(self):
        checked_number("least_pressure", self.least_pressure, "Pa", above=0)
        checked_number("window", self.window, "s", above=0)
        checked_number("longest_rise", self.longest_rise, "s", above=0, below=self.window)
        checked_number("largest_second_peak", self.largest_second_peak, above=0, at_most=1)

    def scaled(self, ratio: float) -> "PulseSettings":
        """Settings for a ship ``ratio`` times as long, by Froude's law."""
        checked_number("scale ratio", ratio, above=0)
        return dataclasses.replace(
            self,
            least_pressure=self.least_pressure * ratio,
            window=self.window * np.sqrt(ratio),
            longest_rise=self.longest_rise * np.sqrt(ratio),
        )


def pressure_pulses(record_set: xr.Dataset, settings: PulseSettings) -> xr.Dataset:
    """Slams of a record by its gauges (event, gauge).

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`, with channels P1, P2 ... in Pa.

    Returns
    -------
    Dataset: ``gauge_peak`` [Pa] and ``gauge_peak_time`` (event, gauge), which are not simultaneous;
    over event, of the gauge with the largest pressure: ``peak_gauge``, ``peak_pressure``,
    ``event_time``, ``rise_time``, ``pulse_duration`` (above half the peak), ``second_peak_share``
    and ``is_excluded``, 1 for damped or irregular slams.
    """
    gauges = gauge_samples(record_set)
    time = record_set.time.values
    values = np.stack(list(gauges.values()), axis=1)
    instants = impact_instants(time, values.max(axis=1), settings.least_pressure, 2 * settings.window)
    step = float(record_set.attrs["time_step"])
    peaks = np.empty((len(instants), len(gauges)))
    times, shapes = np.empty_like(peaks), np.empty((len(instants), 4))
    for number, instant in enumerate(instants):
        inside = np.abs(time - instant) <= settings.window + 1e-9 * step
        part, when = values[inside], time[inside]
        places = np.argmax(part, axis=0)
        peaks[number] = part[places, np.arange(len(gauges))]
        times[number] = when[places]
        highest = int(np.argmax(peaks[number]))
        shapes[number] = (highest, *_shape(when, part[:, highest], int(places[highest])))
    rise, duration, second = shapes[:, 1], shapes[:, 2], shapes[:, 3]
    excluded = (rise > settings.longest_rise) | (second > settings.largest_second_peak)
    names = np.array(list(gauges))
    rows = np.arange(len(instants))
    chosen = shapes[:, 0].astype(int)
    notes = list(quantities.warnings_of(record_set))
    if len(rise) and float(rise.min()) < FEWEST_IN_RISE * step:
        notes.append(
            f"Some pulses rise in {1e3 * rise.min():.2g} ms, within {FEWEST_IN_RISE} samples of {1e3 * step:.2g} ms: "
            "their peaks are cut off; sample faster."
        )
    return quantities.dataset(
        {"event": rows, "gauge": names},
        method="pulses of pressure gauges",
        warnings=notes,
        attrs={f"settings_{name}": value for name, value in dataclasses.asdict(settings).items()},
        gauge_peak=(("event", "gauge"), peaks),
        gauge_peak_time=(("event", "gauge"), times),
        event_time=("event", times[rows, chosen]),
        peak_gauge=("event", names[chosen]),
        peak_pressure=("event", peaks[rows, chosen]),
        rise_time=("event", rise),
        pulse_duration=("event", duration),
        second_peak_share=("event", second),
        is_excluded=("event", excluded.astype(int)),
    )


def _shape(time: np.ndarray, pressure: np.ndarray, place: int) -> tuple[float, float, float]:
    """Rise [s], duration above half [s] and share of the second peak [-] of a pulse with its peak at a place."""
    peak = pressure[place]
    rise = time[place] - _crossing(time, pressure, place, 0.1 * peak, -1)
    duration = _crossing(time, pressure, place, 0.5 * peak, 1) - _crossing(
        time, pressure, place, 0.5 * peak, -1
    )
    others = [one for one in find_peaks(pressure)[0] if one != place]
    prominence = peak_prominences(pressure, others)[0] if others else np.zeros(1)
    return float(rise), float(duration), float(prominence.max() / peak)


def _crossing(time: np.ndarray, pressure: np.ndarray, place: int, level: float, way: int) -> float:
    """Time at which the pressure falls below a level, from a place backward (-1) or forward (1); else the end."""
    below = np.flatnonzero(pressure[place::way] < level)
    if not len(below):
        return float(time[0] if way < 0 else time[-1])
    outside = place + way * int(below[0])
    inside = outside - way
    share = (pressure[inside] - level) / (pressure[inside] - pressure[outside])
    return float(time[inside] + share * (time[outside] - time[inside]))


def event_record(record_set: xr.Dataset, instant: float, window: float) -> xr.Dataset:
    """Part of a record within a window of an instant [s]."""
    inside = np.abs(record_set.time.values - instant) <= window
    return record_set.isel(time=np.flatnonzero(inside))
