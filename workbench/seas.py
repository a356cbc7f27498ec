"""Seas: spectra, spreading, presets, and the conditions in which a ship meets them.

.. [Bretschneider1959] C. L. Bretschneider, "Wave variability and wave spectra for
    wind-generated gravity waves", Beach Erosion Board Tech. Memo. 118, 1959.
.. [Lloyd1989] A. R. J. M. Lloyd, "Seakeeping: ship behaviour in rough weather", 1989.
.. [Hasselmann1973] K. Hasselmann et al., "Measurements of wind-wave growth and swell
    decay during JONSWAP", Dt. Hydrogr. Z. A8(12), 1973.
.. [PiersonMoskowitz1964] W. J. Pierson and L. Moskowitz, "A proposed spectral form for
    fully developed wind seas", J. Geophys. Res. 69(24), 5181-5190, 1964.
.. [WMO306] World Meteorological Organization, Manual on Codes, No. 306, table 3700, and the
    Beaufort scale with probable wave heights in the open sea.
.. [Bales1983] S. L. Bales, "Designing ships to the natural environment", Naval Engineers
    Journal 95(2), 31-40, 1983 (North Atlantic, most probable modal periods).
"""

from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.integrate import quad

from workbench.conventions import GRAVITY, KNOT
from workbench.errors import InputError, checked_choice, checked_number

SPECTRA = ("bretschneider", "jonswap", "pierson-moskowitz", "user")
_FINEST_STEEPNESS = 1 / 7  # a regular wave breaks there; a sea far below it


@dataclass(frozen=True, kw_only=True)
class SeaState:
    """A sea: its spectrum by significant height and peak period, and its spreading.

    Parameters
    ----------
    significant_wave_height : Hs = 4 sqrt(m0) [m], > 0.
    peak_period : of the spectrum over wave frequency [s], > 0. Ignored by (and may be
        left out for) "pierson-moskowitz", which is fully developed for its height, and "user".
    spectrum : one of `SPECTRA`; "bretschneider" is also called ITTC or ISSC two-parameter.
    peak_enhancement : gamma of "jonswap" [-], 1 to 10.
    spreading_exponent : n of cos**n spreading over +-90 degrees; None for long-crested seas.
    table : for "user": pairs (omega [rad/s], ordinate [m2 s/rad]), increasing;
        scaled to ``significant_wave_height``.
    """

    significant_wave_height: float
    peak_period: float | None = None
    spectrum: str = "bretschneider"
    peak_enhancement: float = 3.3
    spreading_exponent: float | None = None
    table: tuple[tuple[float, float], ...] = ()

    def __post_init__(self):
        checked_choice("spectrum", self.spectrum, SPECTRA)
        checked_number(
            "significant_wave_height",
            self.significant_wave_height,
            "m",
            above=0,
            at_most=30,
            cure="give the significant height of the sea",
        )
        if self.spectrum == "pierson-moskowitz":
            developed = (
                2 * np.pi / ((16 * 0.0081 / 5) ** 0.25 * np.sqrt(GRAVITY / self.significant_wave_height))
            )
            if self.peak_period is not None and abs(self.peak_period / developed - 1) > 0.05:
                raise InputError(
                    f"peak_period of a Pierson-Moskowitz sea follows from its height: {developed:.2f} s for "
                    f"{self.significant_wave_height:g} m, got {self.peak_period:g} s; leave it out, or take the "
                    "bretschneider spectrum."
                )
            object.__setattr__(self, "peak_period", float(developed))
        elif self.spectrum == "user":
            self._check_table()
        else:
            checked_number(
                "peak_period",
                self.peak_period,
                "s",
                above=0,
                at_most=40,
                cure="give the peak period of the sea",
            )
            steepness = 2 * np.pi * self.significant_wave_height / (GRAVITY * self.peak_period**2)
            if steepness > _FINEST_STEEPNESS:
                least = np.sqrt(2 * np.pi * self.significant_wave_height / (GRAVITY * _FINEST_STEEPNESS))
                raise InputError(
                    f"peak_period must be > {least:.2f} s for a significant_wave_height of "
                    f"{self.significant_wave_height:g} m, got {self.peak_period:g} s; "
                    "steeper waves break: lengthen the period or lower the sea."
                )
        checked_number("peak_enhancement", self.peak_enhancement, at_least=1, at_most=10)
        if self.spreading_exponent is not None:
            checked_number("spreading_exponent", self.spreading_exponent, at_least=1, at_most=100)

    def _check_table(self):
        points = np.asarray(self.table, dtype=float)
        if points.ndim != 2 or points.shape[1] != 2 or len(points) < 3:
            raise InputError(
                f"table must hold at least 3 pairs (omega, ordinate) for a user spectrum, got {len(self.table)}."
            )
        if not np.all(np.isfinite(points)) or np.any(np.diff(points[:, 0]) <= 0) or points[0, 0] <= 0:
            raise InputError(
                "table must have increasing omega > 0 rad/s and finite ordinates; sort it by frequency."
            )
        if np.any(points[:, 1] < 0) or not np.any(points[:, 1] > 0):
            raise InputError(
                "table must have ordinates >= 0 m2 s/rad, not all 0; check the spectrum's units."
            )
        object.__setattr__(self, "table", tuple((float(a), float(b)) for a, b in points))
        peak = points[np.argmax(points[:, 1]), 0]
        object.__setattr__(self, "peak_period", float(2 * np.pi / peak))

    @classmethod
    def from_mean_period(cls, significant_wave_height: float, mean_period: float, **others) -> "SeaState":
        """Make a sea by its mean period T01 = 2 pi m0/m1 [s] (Bretschneider: Tp = 1.296 T01 [Lloyd1989]_)."""
        checked_number("mean_period", mean_period, "s", above=0, at_most=40)
        ratio = period_ratio(1, others.get("spectrum", "bretschneider"), others.get("peak_enhancement", 3.3))
        return cls(significant_wave_height=significant_wave_height, peak_period=mean_period / ratio, **others)

    @classmethod
    def from_zero_crossing_period(
        cls, significant_wave_height: float, zero_crossing_period: float, **others
    ) -> "SeaState":
        """Make a sea by its zero-crossing period T02 = 2 pi sqrt(m0/m2) [s] (Bretschneider: Tp = 1.408 T02)."""
        checked_number("zero_crossing_period", zero_crossing_period, "s", above=0, at_most=40)
        ratio = period_ratio(2, others.get("spectrum", "bretschneider"), others.get("peak_enhancement", 3.3))
        return cls(
            significant_wave_height=significant_wave_height,
            peak_period=zero_crossing_period / ratio,
            **others,
        )


@dataclass(frozen=True, kw_only=True)
class Condition:
    """A speed, a direction of the waves and a sea.

    Parameters
    ----------
    speed : [m/s], 0 to 60.
    wave_direction : where the waves go, from ahead [rad], 0 to 2 pi; pi is head seas.
    sea_state : the sea.
    """

    speed: float
    wave_direction: float
    sea_state: SeaState

    def __post_init__(self):
        checked_number("speed", self.speed, "m/s", at_least=0, at_most=60)
        checked_number("wave_direction", self.wave_direction, "rad", at_least=0, at_most=2 * np.pi)


def _shape(frequency_ratio, peak_enhancement: float):
    """Spectral shape over omega/omega_p, not normalised (gamma = 1: Bretschneider)."""
    ratio = np.asarray(frequency_ratio, float)
    width = np.where(ratio <= 1, 0.07, 0.09)
    exponent = np.exp(-((ratio - 1) ** 2) / (2 * width**2))
    with np.errstate(divide="ignore", over="ignore", under="ignore"):
        body = np.where(ratio > 0.1, ratio, np.inf) ** -5.0 * np.exp(-1.25 * np.maximum(ratio, 0.1) ** -4.0)
    return body * peak_enhancement**exponent


@cache
def _shape_moment(order: int, peak_enhancement: float) -> float:
    """Moment of the shape over omega/omega_p, from zero to infinity."""
    return quad(
        lambda ratio: ratio**order * float(_shape(ratio, peak_enhancement)),
        0.1,
        np.inf,
        limit=400,
        epsabs=0,
        epsrel=1e-9,
    )[0]


def period_ratio(order: int, spectrum: str = "bretschneider", peak_enhancement: float = 3.3) -> float:
    """Period over peak period [-]: T01/Tp (order 1), T02/Tp (order 2), or T-10/Tp (order -1).

    Bretschneider: 0.7718, 0.7104, 0.8572.
    """
    gamma = peak_enhancement if spectrum == "jonswap" else 1.0
    m0 = _shape_moment(0, gamma)
    if order == -1:
        return _shape_moment(-1, gamma) / m0
    return (m0 / _shape_moment(order, gamma)) ** (1 / order)


def wave_spectrum(sea_state: SeaState, omega) -> np.ndarray:
    """One-sided spectrum over wave frequency [m2 s/rad].

    Parameters
    ----------
    sea_state : the sea.
    omega : wave frequencies [rad/s], any shape.

    Notes
    -----
    Bretschneider: S = 5/16 Hs**2 wp**4 w**-5 exp(-1.25 (wp/w)**4) [Bretschneider1959]_.
    JONSWAP: the same with gamma**exp(-(w/wp - 1)**2/(2 s**2)), s = 0.07 below and 0.09
    above the peak [Hasselmann1973]_, normalised exactly to Hs. Pierson-Moskowitz:
    alpha = 0.0081, hence wp = 0.401 sqrt(g/Hs) [PiersonMoskowitz1964]_.
    """
    omega = np.asarray(omega, float)
    variance = sea_state.significant_wave_height**2 / 16
    if sea_state.spectrum == "user":
        frequencies, ordinates = np.array(sea_state.table).T
        area = np.trapezoid(ordinates, frequencies)
        return np.interp(omega, frequencies, ordinates, left=0.0, right=0.0) * variance / area
    gamma = sea_state.peak_enhancement if sea_state.spectrum == "jonswap" else 1.0
    peak = 2 * np.pi / sea_state.peak_period
    return variance * _shape(omega / peak, gamma) / (_shape_moment(0, gamma) * peak)


def spreading_weights(wave_directions, wave_direction: float, spreading_exponent: float | None) -> np.ndarray:
    """Share of the energy that each of the given directions carries [-]; they sum to 1.

    Parameters
    ----------
    wave_directions : evenly spaced directions [rad].
    wave_direction : main direction [rad].
    spreading_exponent : n of cos**n about it, zero beyond 90 degrees; None puts all
        energy on the nearest direction.
    """
    directions = np.asarray(wave_directions, float)
    away = np.angle(np.exp(1j * (directions - wave_direction)))
    if spreading_exponent is None:
        weights = np.zeros(directions.shape)
        weights[np.argmin(np.abs(away))] = 1.0
        return weights
    weights = np.where(np.abs(away) < np.pi / 2, np.cos(away), 0.0) ** spreading_exponent
    if not np.any(weights > 0):
        raise InputError("wave_directions must hold a direction within 90 degrees of the main one.")
    return weights / weights.sum()


@dataclass(frozen=True)
class SeaPreset:
    """A named sea, with the wind that goes with it."""

    name: str
    significant_wave_height: float
    peak_period: float
    wind_speed: float
    source: str

    @property
    def sea_state(self) -> SeaState:
        """The preset as a Bretschneider sea."""
        return SeaState(significant_wave_height=self.significant_wave_height, peak_period=self.peak_period)


def sea_presets() -> tuple[SeaPreset, ...]:
    """Return sea states 2 to 8 of the open North Atlantic and Beaufort forces 2 to 11.

    Sea states: mean Hs, most probable modal period and mean wind of [Bales1983]_.
    Beaufort: probable wave height in the open sea and mean wind of [WMO306]_; the
    period is that of the fully developed sea of that height.
    """
    sea_states = ((2, 0.3, 6.3, 8.5), (3, 0.88, 7.5, 13.5), (4, 1.88, 8.8, 19), (5, 3.25, 9.7, 24.5))
    sea_states += ((6, 5.0, 12.4, 37.5), (7, 7.5, 15.0, 51.5), (8, 11.5, 16.4, 59.5))
    beaufort = ((2, 0.2, 5), (3, 0.6, 8.5), (4, 1.0, 13.5), (5, 2.0, 19), (6, 3.0, 24.5))
    beaufort += ((7, 4.0, 30.5), (8, 5.5, 37), (9, 7.0, 44), (10, 9.0, 51.5), (11, 11.5, 59.5))
    presets = [
        SeaPreset(f"Sea state {number}", height, period, wind * KNOT, "Bales 1983")
        for number, height, period, wind in sea_states
    ]
    for number, height, wind in beaufort:
        developed = SeaState(significant_wave_height=height, spectrum="pierson-moskowitz")
        presets.append(
            SeaPreset(
                f"Beaufort {number}", height, round(developed.peak_period, 1), wind * KNOT, "WMO No. 306"
            )
        )
    return tuple(presets)
