"""Displacement from acceleration: integrated twice, in the frequency domain or step by step.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 3.2.
"""

import numpy as np
from scipy.integrate import cumulative_simpson
from scipy.signal import detrend

from workbench.errors import InputError, checked_number
from workbench.records.filters import high_passed

HIGH_PASS = 2 * np.pi * 0.1
"""Usual cut-off, 0.1 Hz, chosen by trials with measured and simulated records ([Grande2002]_) [rad/s]."""

_SOFT_SHARE = 0.5


def displacement(acceleration, time_step: float, cutoff: float = HIGH_PASS) -> np.ndarray:
    """Displacement from acceleration in the frequency domain, (time, ...) [m].

    Parameters
    ----------
    acceleration : (time, ...) [m/s2], positive like the displacement; a mean (such as
        that of gravity) and a line are taken off. time_step : [s].
    cutoff : nothing slower than half of it is kept, all faster than it is [rad/s].

    Notes
    -----
    Transform, division by -omega^2, transform back. The record is continued beyond its
    ends by two periods of the cut-off, mirrored with its sign turned and faded out; of the
    continuations tried that one errs least: in random seas above 1.4 times the cut-off
    by 4 % of the deviation over all, by 0.3 % from one and a half periods of the cut-off
    off the ends. Below the
    cut-off it says nothing: errors of the accelerometer grow as 1/omega^2 there.
    """
    return rates(acceleration, time_step, cutoff, -2)


def velocity(acceleration, time_step: float, cutoff: float = HIGH_PASS) -> np.ndarray:
    """Velocity from acceleration in the frequency domain, (time, ...) [m/s]; see `displacement`."""
    return rates(acceleration, time_step, cutoff, -1)


def acceleration_of(record_of_displacement, time_step: float, cutoff: float = HIGH_PASS) -> np.ndarray:
    """Acceleration from displacement in the frequency domain, (time, ...) [m/s2]; a check on redundant channels."""
    return rates(record_of_displacement, time_step, cutoff, 2)


def rates(values, time_step: float, cutoff: float, order: int) -> np.ndarray:
    """Derivative of a record of an order, in the frequency domain and high-passed, (time, ...).

    Parameters
    ----------
    values : (time, ...); time_step : [s]; cutoff : as for `displacement`.
    order : of the derivative; -2 integrates twice, 0 only high-passes.
    """
    values = np.asarray(values, float)
    checked_number("time_step", time_step, "s", above=0)
    checked_number("cutoff", cutoff, "rad/s", above=0, below=np.pi / time_step)
    period = 2 * np.pi / cutoff
    if len(values) * time_step < 2 * period:
        raise InputError(
            f"record must be at least {2 * period:.4g} s long, two periods of the cut-off, to be integrated; "
            f"got {len(values) * time_step:.4g} s."
        )
    flat = detrend(values, axis=0, type="linear")
    margin = min(int(np.ceil(2 * period / time_step)), len(flat) - 1)
    fade = (0.5 - 0.5 * np.cos(np.pi * np.arange(1, margin + 1) / (margin + 1))).reshape(
        -1, *[1] * (flat.ndim - 1)
    )
    before = -flat[margin:0:-1] * fade
    after = -flat[-2 : -margin - 2 : -1] * fade[::-1]
    longer = np.concatenate([before, flat, after])
    omega = 2 * np.pi * np.fft.rfftfreq(len(longer), time_step)
    share = np.clip((omega / cutoff - _SOFT_SHARE) / (1 - _SOFT_SHARE), 0.0, 1.0)
    kept = 0.5 - 0.5 * np.cos(np.pi * share)
    factor = kept * (1j * np.where(omega > 0, omega, 1.0)) ** order
    transform = np.fft.rfft(longer, axis=0) * factor.reshape(-1, *[1] * (flat.ndim - 1))
    return np.fft.irfft(transform, len(longer), axis=0)[margin : margin + len(flat)]


def displacement_by_steps(acceleration, time_step: float, cutoff: float = HIGH_PASS) -> np.ndarray:
    """Displacement from acceleration in the time domain, (time, ...) [m].

    Simpson's rule twice, each time followed by a high-pass filter against drift: the
    second method that `displacement` is held against.
    """
    rate = np.asarray(acceleration, float)
    rate = detrend(rate, axis=0, type="linear")
    for _ in range(2):
        rate = cumulative_simpson(rate, dx=time_step, axis=0, initial=0.0)
        rate = high_passed(detrend(rate, axis=0, type="linear"), time_step, cutoff)
    return rate
