"""Slams in records of an accelerometer: a plain threshold, and a filter matched to the ring-down.

A slam is a short, high peak of acceleration followed by decaying ringing of the
structure ([Couser1996]_ 7.5). The characteristic vibration of the place where the
accelerometer sits can be read from the autocorrelation of the record and looked for
([Grande2002]_ 5.3 names the technique and gives no details; these are ours).

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
.. [Turin1960] G. L. Turin, "An introduction to matched filters", IRE Trans. Inf. Theory 6(3), 1960.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr
from scipy import signal

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.records.filters import high_passed

NORMAL_DEVIATION = 1.4826
"""Standard deviation of a normal variable over its median absolute deviation [-]."""

LEAST_STRENGTH = 6.0
"""Usual threshold of the matched filter, in deviations of its output between slams [-]."""


@dataclass(frozen=True, kw_only=True)
class RingDown:
    """Decaying vibration, exp(-damping_ratio omega t) sin(omega t): frequency [rad/s] and damping ratio [-]."""

    omega: float
    damping_ratio: float

    def __post_init__(self):
        checked_number("omega of the ring-down", self.omega, "rad/s", above=0)
        checked_number("damping_ratio of the ring-down", self.damping_ratio, above=0, below=0.7)

    def signal(self, time) -> np.ndarray:
        """Vibration after a blow at time 0, peak about 1 (time)."""
        time = np.asarray(time, float)
        after = np.maximum(time, 0.0)
        shape = np.exp(-self.damping_ratio * self.omega * after) * np.sin(self.omega * after)
        return np.where(time >= 0, shape, 0.0)

    def template(self, time_step: float) -> np.ndarray:
        """Vibration until it has decayed to 5 %, of unit energy (time)."""
        length = 3.0 / (self.damping_ratio * self.omega)
        shape = self.signal(np.arange(0, max(length, 6 * time_step), time_step))
        return shape / np.linalg.norm(shape)


def slams_above(
    acceleration, time_step: float, threshold: float, quickest: float, dead_time: float = 0.5
) -> xr.Dataset:
    """Slams by a threshold on the fast part of an acceleration (event).

    Parameters
    ----------
    acceleration : (time) [m/s2]; time_step : [s].
    threshold : of the magnitude of the high-passed acceleration [m/s2]; the source states none.
    quickest : cut-off of the high-pass, above the waves and below the ringing [rad/s].
    dead_time : time in which peaks belong to one slam [s].

    Returns
    -------
    Dataset over event: ``event_time`` [s], ``slam_acceleration`` (peak) [m/s2].
    """
    checked_number("threshold", threshold, "m/s2", above=0)
    checked_number("dead_time", dead_time, "s", at_least=0)
    fast = np.abs(high_passed(acceleration, time_step, quickest))
    peaks = _peaks(fast, threshold, dead_time, time_step)
    return _events(
        peaks * time_step, fast[peaks], fast[peaks] / threshold, "threshold", len(fast) * time_step
    )


def ring_down(acceleration, time_step: float, quickest: float) -> RingDown:
    """Frequency and damping of the strongest ringing of a record, from its autocorrelation.

    Parameters
    ----------
    acceleration : (time) [m/s2]; time_step : [s]; quickest : as for `slams_above`.

    Notes
    -----
    The autocorrelation of a ring-down is a cosine that decays like it, whenever the blows
    fall. Frequency: the strongest line of the spectrum of that cosine, refined by the
    fit; damping: the decay of its first eight peaks. The first half period is left
    out, where noise sits.
    """
    fast = high_passed(acceleration, time_step, quickest)
    size = 2 ** int(np.ceil(np.log2(2 * len(fast))))
    correlation = np.fft.irfft(np.abs(np.fft.rfft(fast, size)) ** 2, size)
    reach = min(len(fast) // 2, int(40 * np.pi / (quickest * time_step)))
    correlation = correlation[:reach] / correlation[0]
    tapered = correlation * np.hanning(2 * reach)[reach:]
    lines = np.abs(np.fft.rfft(tapered, 16 * reach))
    omega = 2 * np.pi * np.fft.rfftfreq(16 * reach, time_step)
    allowed = np.where(omega > quickest, lines, 0.0)
    first = float(omega[int(np.argmax(allowed))])
    half = max(int(np.pi / first / time_step), 2)
    peaks, _ = signal.find_peaks(np.abs(correlation), distance=max(int(0.7 * half), 1))
    peaks = peaks[peaks >= half // 2][:8]
    if len(peaks) < 4:
        raise InputError("no ringing is found in the acceleration; give its frequency and damping ratio.")
    height, place = np.abs(correlation[peaks]), peaks * time_step
    decay = -np.polyfit(place, np.log(np.maximum(height, 1e-12)), 1, w=height)[0]
    found = np.pi * (len(peaks) - 1) / (place[-1] - place[0])
    found = float(found) if abs(found / first - 1) < 0.2 else first
    return RingDown(omega=found, damping_ratio=float(np.clip(decay / found, 0.005, 0.5)))


def matched_slams(
    acceleration,
    time_step: float,
    ringing: RingDown,
    quickest: float,
    strength: float = LEAST_STRENGTH,
    dead_time: float = 0.5,
) -> xr.Dataset:
    """Slams by correlation of an acceleration with a ring-down (event).

    Parameters
    ----------
    acceleration : (time) [m/s2]; time_step : [s].
    ringing : what is looked for; from `ring_down` or known.
    quickest, dead_time : as for `slams_above`.
    strength : threshold, in deviations of the filter's output (by its median, so that
        slams do not count as noise).

    Returns
    -------
    Dataset over event: ``event_time`` of the blow, ``slam_acceleration`` (amplitude of the
    ring-down that fits best, signed by its first swing), ``slam_strength`` [deviations].

    Notes
    -----
    In white noise no linear filter finds known signals better ([Turin1960]_): the
    threshold sees the peak alone, the filter the energy of all swings.
    """
    checked_number("strength", strength, above=0)
    checked_number("dead_time", dead_time, "s", at_least=0)
    fast = high_passed(acceleration, time_step, quickest)
    template = ringing.template(time_step)
    if len(template) >= len(fast):
        raise InputError(
            f"record must be longer than the ring-down, {len(template) * time_step:.3g} s, got "
            f"{len(fast) * time_step:.3g} s."
        )
    found = signal.fftconvolve(fast, template[::-1], mode="full")[len(template) - 1 :]
    deviation = NORMAL_DEVIATION * float(np.median(np.abs(found)))
    if deviation <= 0:
        raise InputError("acceleration must not be constant to look for slams in it.")
    peaks = _peaks(np.abs(found), strength * deviation, dead_time, time_step)
    size = np.linalg.norm(ringing.signal(np.arange(len(template)) * time_step))
    amplitude = found[peaks] / size
    return _events(
        peaks * time_step,
        amplitude,
        np.abs(found[peaks]) / deviation,
        "matched filter",
        len(fast) * time_step,
    )


def _peaks(values: np.ndarray, threshold: float, dead_time: float, time_step: float) -> np.ndarray:
    """Indices of the peaks above a threshold that are largest within the dead time."""
    return signal.find_peaks(values, height=threshold, distance=max(round(dead_time / time_step), 1))[0]


def _events(times, acceleration, strength, method: str, duration: float) -> xr.Dataset:
    return quantities.dataset(
        {"event": np.arange(len(times))},
        method=method,
        attrs={"duration": float(duration)},
        event_time=("event", np.asarray(times, float)),
        slam_acceleration=("event", np.asarray(acceleration, float)),
        slam_strength=("event", np.asarray(strength, float)),
    )


def detection(found_times, true_times, tolerance: float) -> tuple[int, int, int]:
    """Slams found, missed and falsely found, each found one paired with the nearest true one in reach.

    Parameters
    ----------
    found_times, true_times : [s]; tolerance : reach [s].
    """
    left = sorted(float(time) for time in np.asarray(found_times, float))
    hits = 0
    for time in np.sort(np.asarray(true_times, float)):
        near = [one for one in left if abs(one - time) <= tolerance]
        if near:
            left.remove(min(near, key=lambda one: abs(one - time)))
            hits += 1
    return hits, len(np.atleast_1d(true_times)) - hits, len(left)
