"""From records of a slam to the inputs of Chuang's Method I.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, appendix B.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr
from scipy.signal import find_peaks

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.impact import chuang
from workbench.impact.regular_wave import surface_slope
from workbench.records.reading import channel

CHANNELS = ("pressure", "pitch", "heave", "wave")


@dataclass(frozen=True, kw_only=True)
class SlamChannels:
    """Names of the channels that a slam is read from, and their calibration factors.

    Parameters
    ----------
    pressure : of the gauge at the impact point; after its factor [Pa].
    pitch : bow up positive after its factor [rad]; heave : of the centre of gravity, upward
        positive [m]; wave : elevation at the probe, upward positive [m].
    pressure_factor, pitch_factor, heave_factor, wave_factor : from the record's unit and
        sign to these, such as -1 for a pitch that is positive bow down.
    """

    pressure: str = "pressure"
    pitch: str = "pitch"
    heave: str = "heave"
    wave: str = "wave"
    pressure_factor: float = 1.0
    pitch_factor: float = 1.0
    heave_factor: float = 1.0
    wave_factor: float = 1.0

    def __post_init__(self):
        for name in CHANNELS:
            if checked_number(f"calibration factor of {name}", getattr(self, f"{name}_factor")) == 0:
                raise InputError(f"calibration factor of {name} must not be 0.")

    def samples(self, record_set: xr.Dataset, name: str) -> np.ndarray:
        """Calibrated samples of a channel (time)."""
        return getattr(self, f"{name}_factor") * channel(record_set, getattr(self, name))


@dataclass(frozen=True, kw_only=True)
class ReductionSettings:
    """How a slam is read.

    Parameters
    ----------
    lever : of the gauge forward of the centre of gravity [m].
    probe_distance : of the wave probe ahead of the gauge [m].
    closing_speed : ship speed and celerity together, V(H) [m/s].
    window : half the stretch over which a line is laid for a slope [s].
    least_pressure : peaks from here up are slams [Pa].
    dead_time : within which peaks belong to one slam [s].
    """

    lever: float
    probe_distance: float
    closing_speed: float
    window: float
    least_pressure: float
    dead_time: float = 0.5

    def __post_init__(self):
        checked_number("lever", self.lever, "m")
        checked_number("probe_distance", self.probe_distance, "m", at_least=0)
        checked_number("closing_speed", self.closing_speed, "m/s", above=0)
        checked_number("window", self.window, "s", above=0)
        checked_number("least_pressure", self.least_pressure, "Pa", above=0)
        checked_number("dead_time", self.dead_time, "s", at_least=0)

    @property
    def wave_shift(self) -> float:
        """Time by which the wave passes the probe before it meets the gauge, s/V(H) [s]."""
        return self.probe_distance / self.closing_speed


def impact_instants(time, pressure, least_pressure: float, dead_time: float) -> np.ndarray:
    """Times of the peaks of a pressure trace, one a slam [s].

    Parameters
    ----------
    time : [s]; pressure : (time) [Pa]; least_pressure : [Pa]; dead_time : [s].
    """
    time, pressure = np.asarray(time, float), np.asarray(pressure, float)
    step = time[1] - time[0]
    distance = max(1, round(dead_time / step))
    padded = np.concatenate([[-np.inf], pressure, [-np.inf]])
    peaks, _ = find_peaks(padded, height=least_pressure, distance=distance)
    return time[peaks - 1]


def line_at(time, values, instant: float, window: float) -> tuple[float, float]:
    """Value and slope at an instant of a record, by a line through the samples within a window of it.

    Parameters
    ----------
    time : [s]; values : (time); instant, window : [s].
    """
    time, values = np.asarray(time, float), np.asarray(values, float)
    step = time[1] - time[0]
    inside = np.abs(time - instant) <= window + 1e-9 * step
    ends = time[0] - 1e-9 * step <= instant - window and instant + window <= time[-1] + 1e-9 * step
    if not ends or inside.sum() < 3:
        raise InputError(
            f"record must hold {window:.4g} s on both sides of {instant:.6g} s, three samples or more, for a slope; it "
            f"goes from {time[0]:.6g} to {time[-1]:.6g} s by {step:.4g} s."
        )
    slope, value = np.polyfit(time[inside] - instant, values[inside], 1)
    return float(value), float(slope)


def reduced_slams(
    record_set: xr.Dataset, settings: ReductionSettings, channels: SlamChannels | None = None
) -> xr.Dataset:
    """Slams of a record with the inputs of Method I at their instants (event) ([Chuang1975]_ appendix B).

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`.

    Returns
    -------
    Dataset over event: ``event_time`` of the peak of the pressure trace, ``recorded_pressure`` there,
    ``pitch_velocity`` (rate of pitch times lever), ``heave_velocity``, ``attitude`` (pitch),
    ``wave_slope`` and ``surface_velocity``; for `workbench.impact.slam_table.predicted_slams`.

    Notes
    -----
    The wave is read s/V(H) before the impact, when the part that the gauge meets passed
    the probe; the source calls this wave its largest uncertainty. Its slope is the arc
    tangent of (dW/dt)/V(H), which the source takes as the angle.
    """
    channels = channels or SlamChannels()
    time = record_set.time.values
    pressure, pitch, heave, wave = (channels.samples(record_set, name) for name in CHANNELS)
    instants = impact_instants(time, pressure, settings.least_pressure, settings.dead_time)
    early = instants - settings.wave_shift - settings.window < time[0]
    late = instants + settings.window > time[-1]
    notes = list(quantities.warnings_of(record_set))
    if np.any(early | late):
        notes.append(f"{int(np.sum(early | late))} slams too near the ends of the record were left out.")
    instants = instants[~(early | late)]
    rows = np.array(
        [
            [
                np.interp(instant, time, pressure),
                *line_at(time, pitch, instant, settings.window),
                line_at(time, heave, instant, settings.window)[1],
                line_at(time, wave, instant - settings.wave_shift, settings.window)[1],
            ]
            for instant in instants
        ]
    ).reshape(-1, 5)
    peak, attitude, pitch_rate, heave_rate, wave_rate = rows.T
    return quantities.dataset(
        {"event": np.arange(len(instants))},
        method="slopes of records at the peak of a pressure trace",
        warnings=notes,
        attrs={"wave_shift": settings.wave_shift, "lever": settings.lever},
        event_time=("event", instants),
        recorded_pressure=("event", peak),
        attitude=("event", attitude),
        pitch_velocity=("event", chuang.pitch_velocity(pitch_rate, settings.lever)),
        heave_velocity=("event", -heave_rate),
        wave_slope=("event", surface_slope(-wave_rate, settings.closing_speed)),
        surface_velocity=("event", -wave_rate),
    )
