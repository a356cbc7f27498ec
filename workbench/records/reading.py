"""Measured records: tables of time and channels read from text, made even in time, with their gaps filled or refused.

A record is a Dataset: ``measured`` (time, channel) in the SI unit that
``channel_unit`` names, evenly sampled, without gaps; the step in ``attrs["time_step"]``.
"""

import csv
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline, PchipInterpolator

from workbench import quantities
from workbench.errors import InputError, checked_choice, checked_number
from workbench.records.units import si_unit, split_label

EVENNESS = 0.05
"""Largest departure of a sample from even times that counts as even, as a share of the step."""

_FEWEST_SAMPLES = 8
_MISSING = {"", "nan", "na", "n/a", "null", "none", "-", "--"}


@dataclass(frozen=True, kw_only=True)
class ReadingSettings:
    """What may be mended in a record.

    Parameters
    ----------
    longest_gap : longest stretch between two good samples that is filled by
        interpolation [s]; None fills nothing, and a record with gaps is refused.
    resample : whether samples at uneven times are moved to even ones; else they are refused.
    time_step : of the even samples [s]; None takes the median step. Only with ``resample``.
    """

    longest_gap: float | None = None
    resample: bool = False
    time_step: float | None = None

    def __post_init__(self):
        if self.longest_gap is not None:
            checked_number("longest_gap", self.longest_gap, "s", above=0, at_most=3600)
        if self.time_step is not None:
            checked_number("time_step", self.time_step, "s", above=0, at_most=3600)
            if not self.resample:
                raise InputError("time_step of a record may only be given together with resample.")


def record(
    time, values, channels: Sequence[str], units: Sequence[str], settings: ReadingSettings | None = None,
    *, warnings: Iterable[str] = (),
) -> xr.Dataset:  # fmt: skip
    """Make a record of samples in time, even and without gaps, or refuse them.

    Parameters
    ----------
    time : times of the samples [s], increasing; values : (time, channel), NaN where missing.
    channels, units : name and SI unit of each channel.
    settings : what may be mended.

    Notes
    -----
    Rows that are missing altogether count as gaps. Gaps are filled by a monotone
    cubic, which cannot overshoot; uneven samples are moved by a cubic spline.
    """
    settings = settings or ReadingSettings()
    time, values = np.asarray(time, float), np.asarray(values, float)
    if values.ndim == 1:
        values = values[:, None]
    _check_table(time, values, channels, units)
    step = float(np.median(np.diff(time)))
    even, values = _even(time, values, step, settings, channels)
    step = float(even[1] - even[0])
    filled, notes = _filled(even, values, channels, settings)
    return quantities.dataset(
        {"time": even, "channel": list(channels), "channel_unit": ("channel", list(units))},
        method="measured or simulated record",
        warnings=(*warnings, *notes),
        attrs={"time_step": step},
        measured=(("time", "channel"), filled),
    )


def channel(record_set: xr.Dataset, name: str) -> np.ndarray:
    """Samples of one channel (time), in its SI unit."""
    return record_set.measured.values[:, _place(record_set, name)]


def channel_unit(record_set: xr.Dataset, name: str) -> str:
    """SI unit of one channel."""
    return str(record_set.channel_unit.values[_place(record_set, name)])


def _place(record_set: xr.Dataset, name: str) -> int:
    """Number of a channel by its name."""
    names = [str(one) for one in record_set.channel.values]
    return names.index(checked_choice("channel", name, names))


def read_record(path: Path, settings: ReadingSettings | None = None) -> xr.Dataset:
    """Read a record from a text table.

    Parameters
    ----------
    path : lines that begin with # are remarks; the first other line names the
        columns, each with its unit in brackets, such as ``time [s], bow wave [m],
        pitch [deg], a (g)``; the first column is time. Separated by comma,
        semicolon (then with decimal comma or point), tab or blanks.
    settings : what may be mended.

    Raises
    ------
    InputError, one sentence that names the line or the time, where the file cannot be used.
    """
    path = Path(path)
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is not text in UTF-8"
        raise InputError(
            f"record must be a readable text file, got {path}: {reason}; check the path."
        ) from None
    kept = [(number, line) for number, line in enumerate(lines, start=1) if _is_content(line)]
    if len(kept) <= _FEWEST_SAMPLES:
        raise InputError(
            f"record must hold a line of names and at least {_FEWEST_SAMPLES} samples, {path.name} has "
            f"{len(kept)} lines."
        )
    separator = _separator(kept[0][1])
    labels = [split_label(cell) for cell in _cells(kept[0][1], separator)]
    if len(labels) < 2:
        raise InputError(
            f"record must have a column of time and at least one channel, {path.name} has {len(labels)}."
        )
    if _number(labels[0][0], separator) is not None:
        raise InputError(
            f"first line of {path.name} must name the columns, got {kept[0][1].strip()!r}; add a line of names."
        )
    table = np.empty((len(kept) - 1, len(labels)))
    for row, (number, line) in enumerate(kept[1:]):
        cells = _cells(line, separator)
        if len(cells) != len(labels):
            raise InputError(
                f"line {number} of {path.name} must have {len(labels)} values, got {len(cells)}; "
                "complete it or remove it."
            )
        for column, cell in enumerate(cells):
            value = _number(cell, separator)
            if value is None:
                raise InputError(
                    f"line {number} of {path.name} must hold numbers, got {cell!r} for {labels[column][0]}."
                )
            table[row, column] = value
    names = [name for name, _ in labels[1:]]
    scales = [si_unit(unit, name) for name, unit in labels]
    table *= np.array([scale for _, scale in scales])
    if scales[0][0] not in ("s", "?"):
        raise InputError(f"first column of {path.name} must be time, got {labels[0][0]} in {scales[0][0]}.")
    bare = [name for name, unit in labels if not unit]
    notes = [f"Taken to be in SI units, for they name none: {', '.join(bare)}."] if bare else []
    return record(
        table[:, 0], table[:, 1:], names, [unit for unit, _ in scales[1:]], settings, warnings=notes
    )


def _is_content(line: str) -> bool:
    return bool(line.strip()) and not line.lstrip().startswith("#")


def _separator(line: str) -> str | None:
    """Separator of the columns, by the line of names; None for blanks."""
    return next((mark for mark in (";", "\t", ",") if mark in line), None)


def _cells(line: str, separator: str | None) -> list[str]:
    if separator is None:
        return re.split(r"\s+(?![\s\[(])", line.strip())
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator))]


def _number(cell: str, separator: str | None) -> float | None:
    """Number of a cell, NaN where it is empty; None if it is something else."""
    if cell.strip().lower() in _MISSING:
        return float("nan")
    try:
        number = float(cell.replace(",", ".") if separator == ";" else cell)
    except ValueError:
        return None
    return number if np.isfinite(number) else float("nan")


def _check_table(time: np.ndarray, values: np.ndarray, channels: Sequence[str], units: Sequence[str]) -> None:
    if time.ndim != 1 or values.shape != (len(time), len(channels)) or len(units) != len(channels):
        raise InputError(
            "record must have one value for each time and channel, and one unit for each channel."
        )
    if len(set(channels)) != len(channels) or not all(channels):
        raise InputError(f"channels of a record must have names of their own, got {', '.join(channels)}.")
    if len(time) < _FEWEST_SAMPLES:
        raise InputError(f"record must have at least {_FEWEST_SAMPLES} samples, got {len(time)}.")
    if not np.all(np.isfinite(time)):
        row = int(np.flatnonzero(~np.isfinite(time))[0])
        raise InputError(
            f"time of a record must be given for all samples, it is missing at sample {row + 1}."
        )
    if np.any(np.diff(time) <= 0):
        row = int(np.flatnonzero(np.diff(time) <= 0)[0])
        raise InputError(
            f"time of a record must increase, after {time[row]:g} s comes {time[row + 1]:g} s; "
            "sort it or remove doubles."
        )


def _even(
    time: np.ndarray, values: np.ndarray, step: float, settings: ReadingSettings, channels: Sequence[str]
) -> tuple[np.ndarray, np.ndarray]:
    """Return even times and the values there, NaN where rows are missing."""
    intervals = np.diff(time) / step
    whole = np.maximum(np.round(intervals), 1)
    place = np.concatenate([[0], np.cumsum(whole)]).astype(int)
    fitted, start = np.polyfit(place, time, 1)
    away = np.abs(time - start - fitted * place) / step
    if np.all(away <= EVENNESS) and settings.time_step is None:
        step = (time[-1] - time[0]) / place[-1]
        placed = np.full((place[-1] + 1, values.shape[1]), np.nan)
        placed[place] = values
        return time[0] + step * np.arange(place[-1] + 1), placed
    if not settings.resample:
        worst = int(np.argmax(np.abs(intervals - whole)))
        raise InputError(
            f"samples of a record must be evenly spaced to {100 * EVENNESS:g} % of {step:.4g} s, "
            f"after {time[worst]:.6g} s the step is {intervals[worst] * step:.4g} s; ask for resampling."
        )
    chosen = settings.time_step or step
    even = time[0] + chosen * np.arange(int(np.floor((time[-1] - time[0]) / chosen * (1 + 1e-12))) + 1)
    if len(even) < _FEWEST_SAMPLES:
        raise InputError(
            f"time_step must leave at least {_FEWEST_SAMPLES} samples, {chosen:g} s leaves {len(even)}."
        )
    moved = np.full((len(even), values.shape[1]), np.nan)
    for column, samples in enumerate(values.T):
        good = np.isfinite(samples)
        if good.sum() < _FEWEST_SAMPLES:
            raise InputError(f"channel {channels[column]} must hold at least {_FEWEST_SAMPLES} samples.")
        own = time[good]
        after = np.clip(np.searchsorted(own, even), 1, len(own) - 1)
        inside = (even >= own[0]) & (even <= own[-1])
        near = own[after] - own[after - 1] <= 2.5 * step
        kept = inside & near
        moved[kept, column] = CubicSpline(own, samples[good])(even[kept])
    return even, moved


def _filled(
    time: np.ndarray, values: np.ndarray, channels: Sequence[str], settings: ReadingSettings
) -> tuple[np.ndarray, list[str]]:
    """Return values without gaps, and sentences about what was filled."""
    filled, notes = values.copy(), []
    for column, name in enumerate(channels):
        good = np.isfinite(values[:, column])
        if np.all(good):
            continue
        missing = int(np.sum(~good))
        start, end = _longest_gap(good)
        length = time[min(end, len(time) - 1)] - time[max(start - 1, 0)]
        at_end = not (good[0] and good[-1])
        where = f"the longest gap of {length:.4g} s at {time[start]:.6g} s"
        described = f"channel {name} has {missing} missing samples, {where}"
        if settings.longest_gap is None:
            raise InputError(
                f"record must have no gaps, but {described}; state the longest gap that may be filled."
            )
        if at_end:
            raise InputError(f"record must begin and end with good samples, but {described}; cut it.")
        if length > settings.longest_gap * (1 + 1e-9):
            raise InputError(
                f"gaps of a record may be at most {settings.longest_gap:g} s, but {described}; cut the record there."
            )
        filled[~good, column] = PchipInterpolator(time[good], values[good, column])(time[~good])
        notes.append(
            f"Channel {name}: {missing} of {len(time)} samples ({100 * missing / len(time):.2g} %) were filled by "
            f"interpolation, the longest gap is {length:.3g} s."
        )
    return filled, notes


def _longest_gap(good: np.ndarray) -> tuple[int, int]:
    """First missing sample of the longest gap, and the good one after it."""
    change = np.diff(np.concatenate([[True], good, [True]]).astype(int))
    starts, ends = np.flatnonzero(change == -1), np.flatnonzero(change == 1)
    longest = int(np.argmax(ends - starts))
    return int(starts[longest]), int(ends[longest])
