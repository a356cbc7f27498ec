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
from scipy.optimize import least_squares

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.records.filters import high_passed

FINENESS = 32
"""Samples in a period of the ringing; a coarser record is refined, for blows fall between its samples."""

LEAST_SHARE = 0.25
"""Share of a slam that a weaker one within its ringing must have to count as another [-]."""

NORMAL_DEVIATION = 1.4826
"""Standard deviation of a normal variable over its median absolute deviation [-]."""

LEAST_STRENGTH = 5.0
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
        """Vibration until it has decayed to 1 %, of unit energy (time)."""
        length = 4.6 / (self.damping_ratio * self.omega)
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
    fall. It is found by the strongest line of its spectrum and fitted over the lags of
    half a period to four and a half; the first half period is left out, where noise sits.
    """
    fast = high_passed(acceleration, time_step, quickest)
    size = 2 ** int(np.ceil(np.log2(2 * len(fast))))
    power = np.abs(np.fft.rfft(fast, size)) ** 2
    correlation = np.fft.irfft(power, size)
    reach = min(len(fast) // 2, int(40 * np.pi / (quickest * time_step)))
    lag = time_step * np.arange(reach)
    correlation = correlation[:reach] / correlation[0]
    lines = np.abs(np.fft.rfft(correlation * np.hanning(2 * reach)[reach:], 16 * reach))
    omega = 2 * np.pi * np.fft.rfftfreq(16 * reach, time_step)
    first = float(omega[int(np.argmax(np.where(omega > quickest, lines, 0.0)))])
    used = (lag >= np.pi / first) & (lag <= 9 * np.pi / first)
    if used.sum() < 12:
        raise InputError("acceleration must be sampled faster, or longer, to find the ringing in it.")

    def misfit(parameters):
        ratio, frequency = parameters
        decay = np.exp(-ratio * frequency * first * lag[used])
        shapes = np.stack(
            [decay * np.cos(frequency * first * lag[used]), decay * np.sin(frequency * first * lag[used])]
        )
        weights = np.linalg.lstsq(shapes.T, correlation[used], rcond=None)[0]
        return weights @ shapes - correlation[used]

    found = least_squares(misfit, (0.05, 1.0), bounds=((0.002, 0.8), (0.5, 1.2)))
    ratio, frequency = found.x
    left = float(np.sum(found.fun**2) / np.sum(correlation[used] ** 2))
    if left > 0.5:
        raise InputError("no ringing is found in the acceleration; give its frequency and damping ratio.")
    return RingDown(omega=float(frequency * first), damping_ratio=float(ratio))


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
    threshold sees the peak alone, the filter the energy of all swings. The strongest slam
    is taken out with the side lobes of its own ringing before the next is looked for.
    """
    checked_number("strength", strength, above=0)
    checked_number(
        "omega of the ring-down",
        ringing.omega,
        "rad/s",
        below=np.pi / time_step,
        cure="the record is too coarse for it",
    )
    checked_number("dead_time", dead_time, "s", at_least=0)
    fast = high_passed(acceleration, time_step, quickest)
    finer = max(1, min(int(np.ceil(FINENESS * ringing.omega * time_step / (2 * np.pi))), 16))
    fast = signal.resample_poly(fast, finer, 1) if finer > 1 else fast
    time_step = time_step / finer
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
    peaks, heights = _pursued(found, template, strength * deviation, round(dead_time / time_step))
    size = np.linalg.norm(ringing.signal(np.arange(len(template)) * time_step))
    return _events(
        peaks * time_step,
        heights / size,
        np.abs(heights) / deviation,
        "matched filter",
        len(fast) * time_step,
    )


def _pursued(
    output: np.ndarray, template: np.ndarray, threshold: float, dead: int
) -> tuple[np.ndarray, np.ndarray]:
    """Peaks of a filter's output, strongest first, each taken out with its side lobes; in order of time."""
    lobes = np.correlate(template, template, mode="full")
    reach = len(template) - 1
    left = np.concatenate([np.zeros(reach), output, np.zeros(reach)])
    least = np.full(len(output), threshold)
    found: list[tuple[int, float]] = []
    while True:
        over = np.abs(left[reach : reach + len(output)]) - least
        place = int(np.argmax(over))
        if over[place] <= 0:
            break
        height = float(left[place + reach])
        left[place : place + 2 * reach + 1] -= height * lobes
        near = slice(max(place - dead, 0), place + dead + 1)
        ringing = slice(max(place - reach, 0), place + reach + 1)
        least[ringing] = np.maximum(least[ringing], LEAST_SHARE * abs(height))
        least[near] = np.inf
        found.append((place, height))
    found.sort()
    return np.array([place for place, _ in found], int), np.array([height for _, height in found])


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
