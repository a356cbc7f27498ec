"""Fit of a sine to a regular record: amplitude, phase and frequency by least squares.

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, appendix G.

The printed normal equations G.3-G.8 carry factors of 2 that do not belong there and
give half the true amplitude; these are derived anew from G.1 and G.2.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, minimize_scalar
from scipy.signal import detrend

from workbench.errors import InputError, checked_number
from workbench.records.crossings import zero_upcrossings

_DEADBAND = 0.4

FEWEST_PERIODS = 3.0
"""Periods that a record must hold to be fitted with a frequency of its own."""

RMS_AGREEMENT = 0.05
"""Largest relative difference of fitted amplitude and sqrt(2) times the deviation that is passed over."""


@dataclass(frozen=True, kw_only=True)
class SineFit:
    """A fitted sine, A1 sin(omega t) + A2 cos(omega t) + mean + trend t.

    ``amplitude`` = sqrt(A1^2 + A2^2); ``phase`` = atan2(A2, A1) [rad], of amplitude
    sin(omega t + phase); ``omega`` [rad/s]; ``residual`` r(omega) of the condition for the
    frequency; ``rms_amplitude`` sqrt(2) times the standard deviation about the line;
    ``unexplained`` share of the variance that is no sine; ``periods`` in the record.
    """

    sine: float
    cosine: float
    omega: float
    residual: float
    rms_amplitude: float
    unexplained: float
    periods: float

    @property
    def amplitude(self) -> float:
        """Amplitude of the sine."""
        return float(np.hypot(self.sine, self.cosine))

    @property
    def phase(self) -> float:
        """Phase of amplitude sin(omega t + phase) [rad]."""
        return float(np.arctan2(self.cosine, self.sine))

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentence if amplitude and deviation do not belong together."""
        if abs(self.rms_amplitude / self.amplitude - 1) <= RMS_AGREEMENT if self.amplitude else False:
            return ()
        return (
            f"Fitted amplitude {self.amplitude:.4g} and sqrt(2) RMS {self.rms_amplitude:.4g} differ by more than "
            f"{100 * RMS_AGREEMENT:.0f} %: the record is not one sine.",
        )


def sine_fit(time, values, omega: float | None = None, *, line: bool = True) -> SineFit:
    """Fit a sine to a regular record.

    Parameters
    ----------
    time : [s], any spacing, increasing; values : (time).
    omega : frequency if it is known and shall be kept [rad/s]; None starts from the
        zero-crossings and iterates until r(omega) vanishes.
    line : whether a least-squares line is taken off first.

    Notes
    -----
    The line is taken off before the fit ([Couser1996]_ G.2.2), which costs a little of a
    sine that does not fill whole periods: 0.5 % of the amplitude for ten periods.
    """
    time, values = np.asarray(time, float), np.asarray(values, float)
    if time.ndim != 1 or time.shape != values.shape or len(time) < 8:
        raise InputError("a sine is fitted to 8 or more samples with one time each.")
    if not np.all(np.isfinite(time)) or not np.all(np.isfinite(values)) or np.any(np.diff(time) <= 0):
        raise InputError("a sine is fitted to finite samples at increasing times; fill or cut gaps first.")
    flat = detrend(values, type="linear") if line and _is_even(time) else values
    if line and not _is_even(time):
        flat = values - np.polyval(np.polyfit(time, values, 1), time)
    if np.ptp(flat) <= 1e-12 * np.abs(values).max():
        raise InputError("a sine is fitted to a record that changes; this one is constant.")
    middle = (time[0] + time[-1]) / 2
    centred, length = time - middle, time[-1] - time[0]
    if omega is None:
        omega = _frequency(centred, flat, length)
    else:
        checked_number("omega", omega, "rad/s", above=0)
    a1, a2 = amplitudes_at(omega, centred, flat)
    left = flat - a1 * np.sin(omega * centred) - a2 * np.cos(omega * centred)
    turned = (a1 + 1j * a2) * np.exp(-1j * omega * middle)
    return SineFit(
        sine=float(turned.real),
        cosine=float(turned.imag),
        omega=float(omega),
        residual=float(frequency_condition(omega, centred, flat)),
        rms_amplitude=float(np.sqrt(2 * np.mean(flat**2))),
        unexplained=float(np.mean(left**2) / np.mean(flat**2)),
        periods=float(omega * length / (2 * np.pi)),
    )


def amplitudes_at(omega: float, time: np.ndarray, values: np.ndarray) -> tuple[float, float]:
    """Amplitudes A1, A2 of sine and cosine of a frequency by the normal equations."""
    sine, cosine = np.sin(omega * time), np.cos(omega * time)
    alpha, beta, gamma = sine @ sine, cosine @ cosine, sine @ cosine
    delta, epsilon = values @ sine, values @ cosine
    determinant = alpha * beta - gamma**2
    return (delta * beta - epsilon * gamma) / determinant, (epsilon * alpha - delta * gamma) / determinant


def frequency_condition(omega: float, time: np.ndarray, values: np.ndarray) -> float:
    """Derivative of half the squared misfit by the frequency, which vanishes at the best one.

    zeta (A1^2 - A2^2) + eta A1 A2 - iota A1 + theta A2, with zeta = sum t sin cos,
    eta = sum t (cos^2 - sin^2), theta = sum t y sin, iota = sum t y cos.
    """
    a1, a2 = amplitudes_at(omega, time, values)
    sine, cosine = np.sin(omega * time), np.cos(omega * time)
    zeta, eta = np.sum(time * sine * cosine), np.sum(time * (cosine**2 - sine**2))
    theta, iota = np.sum(time * values * sine), np.sum(time * values * cosine)
    return float(zeta * (a1**2 - a2**2) + a1 * a2 * eta - a1 * iota + a2 * theta)


def _is_even(time: np.ndarray) -> bool:
    step = np.diff(time)
    return bool(np.ptp(step) < 1e-6 * step.mean())


def _misfit(omega: float, time: np.ndarray, values: np.ndarray) -> float:
    a1, a2 = amplitudes_at(omega, time, values)
    return float(np.sum((values - a1 * np.sin(omega * time) - a2 * np.cos(omega * time)) ** 2))


def _frequency(time: np.ndarray, values: np.ndarray, length: float) -> float:
    """Frequency at which `frequency_condition` vanishes, near that of the zero-crossings."""
    crossings = zero_upcrossings(time, values, _DEADBAND * float(np.std(values)))
    if len(crossings) < 2:
        raise InputError(
            f"record must hold at least {FEWEST_PERIODS:g} periods to find the frequency of its sine; "
            "give the frequency."
        )
    first = 2 * np.pi * (len(crossings) - 1) / (crossings[-1] - crossings[0])
    if first * length / (2 * np.pi) < FEWEST_PERIODS:
        raise InputError(
            f"record must hold at least {FEWEST_PERIODS:g} periods to find the frequency of its sine, it holds "
            f"{first * length / (2 * np.pi):.2g}; give the frequency."
        )
    lobe = 2 * np.pi / length
    nearby = np.linspace(max(first - lobe, 0.2 * first), first + lobe, 41)
    best = int(np.argmin([_misfit(one, time, values) for one in nearby]))
    low, high = nearby[max(best - 1, 0)], nearby[min(best + 1, len(nearby) - 1)]
    ends = [frequency_condition(one, time, values) for one in (low, high)]
    if ends[0] * ends[1] < 0:
        return float(brentq(frequency_condition, low, high, args=(time, values), xtol=1e-14, rtol=1e-14))
    found = minimize_scalar(_misfit, bounds=(low, high), args=(time, values), method="bounded")
    return float(found.x)
