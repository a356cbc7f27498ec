"""The largest pressure to expect, from the slams of a record: a tail fitted to the hardest of them.

.. [Pickands1975] J. Pickands, "Statistical inference using extreme order statistics",
    Annals of Statistics 3(1), 119-131, 1975.
.. [Coles2001] S. Coles, "An introduction to statistical modeling of extreme values", Springer, 2001.
.. [Hosking1987] J. R. M. Hosking and J. R. Wallis, "Parameter and quantile estimation for the
    generalized Pareto distribution", Technometrics 29(3), 339-349, 1987.
"""

import numpy as np
import xarray as xr
from scipy.stats import chi2

from workbench import quantities
from workbench.errors import InputError, checked_choice, checked_number
from workbench.slamming.events import PARTS, grouping_dispersion, parts_of_record
from workbench.slamming.pressure_statistics import BAND
from workbench.slamming.statistics import HOUR

TAILS = ("generalised-pareto", "exponential")
LEAST_COUNT = {"generalised-pareto": 30, "exponential": 10}
"""Fewest slams above the threshold that a tail is fitted to."""
USUAL_SHARE, USUAL_COUNTS = 0.2, (30, 300)
"""Share of the slams that makes the tail, and least and greatest number of them."""
STEEPEST, HEAVIEST = -0.5, 0.5
"""Shapes within which the moments of the fit exist ([Hosking1987]_)."""
_SHAPES = np.linspace(-0.6, 1.2, 91)


def tail_extremes(
    pressures: np.ndarray,
    times: np.ndarray,
    duration: float,
    hours: float,
    *,
    risk: float = 0.01,
    tail: str = "generalised-pareto",
    count: int | None = None,
) -> xr.Dataset:
    """Most probable largest pressure of a number of hours, and the one of a risk, with 99 % confidence bands.

    Parameters
    ----------
    pressures : largest pressure of each slam at one panel [Pa]; times : of the slams [s].
    duration : of the record [s].
    hours : for which the largest is wanted [h]; risk : of being exceeded in that time [-].
    tail : one of `TAILS`; "exponential" is exact for a fixed k in a Gaussian sea.
    count : slams that make the tail; None takes a fifth of them, 30 to 300.

    Returns
    -------
    Dataset of ``most_probable_peak_pressure`` (one slam expected above), ``extreme_pressure`` (risk), the ends of
    their bands, and the fit: ``tail_threshold``, ``tail_count``, ``tail_rate``, ``tail_scale``,
    ``tail_shape``. Not a number, and a warning, where there are too few slams.

    Notes
    -----
    Excesses over a high threshold tend to the generalised Pareto law ([Pickands1975]_), fitted by
    probability-weighted moments ([Hosking1987]_; the exponential by its mean). Bands: profile likelihood of the
    pressure over rate, scale and shape ([Coles2001]_ 4.3), the likelihood taken to the power
    of one over the dispersion of the number of slams, since slams in groups tell less. Costs some 20 ms.
    """
    checked_choice("tail", tail, TAILS)
    hours = checked_number("hours", hours, "h", above=0)
    risk = checked_number("risk", risk, above=0, below=1, cure="0.01 is one in a hundred")
    duration = checked_number("duration of the record", duration, "s", above=0)
    pressures, times = np.asarray(pressures, float), np.asarray(times, float)
    if pressures.shape != times.shape or pressures.ndim != 1:
        raise InputError(
            f"pressures and times of the slams must be as many, got {pressures.size} and {times.size}."
        )
    order = np.argsort(-pressures, kind="stable")
    ranked = pressures[order]
    total = int((ranked > 0).sum())
    if count is None:
        count = int(np.clip(round(USUAL_SHARE * total), *USUAL_COUNTS))
    count = min(
        int(checked_number("number of slams of the tail", count, at_least=2, at_most=2000)), max(total - 1, 0)
    )
    attrs = {"hours": hours, "risk": risk, "tail": tail, "duration": duration}
    if count < LEAST_COUNT[tail]:
        note = (
            f"Too few slams for the {tail.replace('-', ' ')} tail: {total} with a pressure, of which {count} above a "
            f"threshold, {LEAST_COUNT[tail]} needed; simulate longer, or take the closed form."
        )
        return _result(dict.fromkeys(_NAMES, np.nan) | {"tail_count": count}, attrs, (note,))
    threshold = ranked[count]
    excesses = ranked[:count] - threshold
    rate = count / (duration / HOUR)
    shape, scale = (float(one[0]) for one in _fit(excesses[None], tail))
    dispersion = _dispersion(times[order[:count]], duration)
    wanted = {"most_probable": 1 / hours, "extreme": -np.log1p(-risk) / hours}

    values = {
        "tail_threshold": threshold, "tail_count": count, "tail_rate": rate, "tail_scale": scale,
        "tail_shape": shape,
    }  # fmt: skip
    region = _likely(excesses, rate, shape, scale, dispersion, tail)
    for name, per_hour in wanted.items():
        best = threshold + float(_excess_at(rate, per_hour, shape, scale))
        likely = threshold + _excess_at(region[0], per_hour, *region[1:])
        values["most_probable_peak_pressure" if name == "most_probable" else "extreme_pressure"] = best
        values[f"{name}_low"] = min(best, float(likely.min()))
        values[f"{name}_high"] = max(best, float(likely.max()))
    notes = []
    if rate < wanted["most_probable"]:
        notes.append("The largest pressure of so short a time lies below the threshold of the tail.")
    if hours > 100 * duration / HOUR:
        notes.append(
            f"{hours:.4g} h are read from a record of {duration / HOUR:.3g} h: the tail is drawn out far beyond what "
            "was counted."
        )
    return _result(values, attrs, notes)


def panel_slams(record: xr.Dataset, x: float, y: float) -> tuple[np.ndarray, np.ndarray]:
    """Pressures [Pa] and times [s] of the slams of one panel of a record, that nearest to x, y [m].

    Parameters
    ----------
    record : slams with ``slam_panel_pressure``, or entries, as for `pressure_statistics.counted_exceedance`.
    """
    if "slam_panel_pressure" in record:
        panel = record.slam_panel_pressure.sel(x=x, y=y, method="nearest").values
        return panel[panel > 0], record.slam_start.values[panel > 0]
    if not record.sizes["event"]:
        return np.zeros(0), np.zeros(0)
    away = np.hypot(record.event_x.values - x, record.event_y.values - y)
    there = away <= away.min() + 1e-9
    return record.peak_pressure.values[there], record.event_time.values[there]


def deck_slams(record: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Largest pressure [Pa] on the whole deck in each slam of a record with ``slam_panel_pressure``, and times [s]."""
    largest = record.slam_panel_pressure.max(("x", "y")).values
    return largest[largest > 0], record.slam_start.values[largest > 0]


_NAMES = (
    "most_probable_peak_pressure", "most_probable_low", "most_probable_high",
    "extreme_pressure", "extreme_low", "extreme_high",
    "tail_threshold", "tail_count", "tail_rate", "tail_scale", "tail_shape",
)  # fmt: skip


def _result(values: dict, attrs: dict, notes=()) -> xr.Dataset:
    return quantities.dataset(
        method=f"{attrs['tail'].replace('-', ' ')} tail of counted slams",
        warnings=notes,
        attrs=attrs,
        **{name: ((), values[name]) for name in _NAMES},
    )


def _dispersion(times: np.ndarray, duration: float) -> float:
    return grouping_dispersion(np.bincount(parts_of_record(times, duration), minlength=PARTS)[:, None])


def _fit(excesses: np.ndarray, tail: str) -> tuple[np.ndarray, np.ndarray]:
    """Return shape and scale of tails to samples of falling excesses (sample, slam)."""
    mean = excesses.mean(axis=1)
    if tail == "exponential":
        return np.zeros_like(mean), mean
    number = excesses.shape[1]
    weighted = (excesses * (np.arange(number) + 0.35) / number).mean(axis=1)
    ratio = mean / np.maximum(mean - 2 * weighted, 1e-300 * np.ones_like(mean))
    shape = np.clip(2 - ratio, STEEPEST, HEAVIEST)
    return shape, mean * (1 - shape)


def _likely(
    excesses: np.ndarray, rate: float, shape: float, scale: float, dispersion: float, tail: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return rates, shapes and scales whose likelihood is within the 99 % band of one quantity about the best."""
    number = len(excesses)
    reach = 4 * np.sqrt(dispersion / number)
    rates = rate * np.exp(np.linspace(-reach, reach, 15))
    scales = scale * np.exp(np.linspace(-2 * reach, 2 * reach, 121))
    shapes = _SHAPES if tail == "generalised-pareto" else np.zeros(1)
    small = np.where(np.abs(shapes) < 1e-9, 1e-9, shapes)
    ratios = excesses / scales[:, None]
    with np.errstate(invalid="ignore", divide="ignore"):
        stretched = np.stack([np.log1p(one * ratios).sum(axis=-1) for one in small])
    of_tail = -number * np.log(scales) - (1 + 1 / small[:, None]) * stretched
    of_tail = np.where(np.isfinite(of_tail), of_tail, -np.inf)
    of_rate = number * (np.log(rates / rate) - rates / rate)
    whole = (of_tail[None] + of_rate[:, None, None]) / dispersion
    chosen = np.nonzero(whole >= whole.max() - chi2.ppf(BAND, 1) / 2)
    return rates[chosen[0]], shapes[chosen[1]], scales[chosen[2]]


def _excess_at(rate, per_hour: float, shape, scale):
    """Excess that is exceeded so many times per hour; below the threshold the exponential law."""
    shape = np.where(np.abs(shape) < 1e-9, 1e-9, shape)
    ratio = np.log(rate / per_hour)
    return scale * np.where(ratio > 0, np.expm1(shape * ratio) / shape, ratio)
