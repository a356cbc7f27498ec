"""Scatter diagrams: how often seas of each height and period occur.

.. [IACS34] International Association of Classification Societies, Recommendation No. 34, "Standard
    wave data", revision 1, 2001 (North Atlantic).
"""

import csv
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

import numpy as np

from workbench.errors import InputError, checked_choice, checked_number
from workbench.seas import SeaState

PERIODS = ("peak", "mean", "zero-crossing")
"""Kinds of period: of the peak, T01, T02."""
DIAGRAMS = {"north-atlantic": ("iacs_rec34_rev1.csv", "zero-crossing")}
"""Diagrams that come with the package: file and kind of period."""


@dataclass(frozen=True, kw_only=True)
class ScatterDiagram:
    """A scatter diagram of seas.

    Parameters
    ----------
    name, source : in words.
    heights : significant heights of the rows, growing [m].
    periods : of the columns, growing [s]; period_kind : one of `PERIODS`.
    occurrences : rows of numbers >= 0, not all 0; any scale.
    """

    name: str
    heights: tuple[float, ...]
    periods: tuple[float, ...]
    occurrences: tuple[tuple[float, ...], ...]
    period_kind: str = "zero-crossing"
    source: str = ""

    def __post_init__(self):
        checked_choice("kind of period of the scatter diagram", self.period_kind, PERIODS)
        for words, values, unit in (("heights", self.heights, "m"), ("periods", self.periods, "s")):
            for value in values:
                checked_number(f"{words} of the scatter diagram", value, unit, above=0, at_most=40)
            if not len(values) or np.any(np.diff(values) <= 0):
                raise InputError(f"{words} of the scatter diagram must grow; sort them.")
        if len(self.occurrences) != len(self.heights) or any(
            len(row) != len(self.periods) for row in self.occurrences
        ):
            raise InputError(
                f"scatter diagram must have {len(self.heights)} rows of {len(self.periods)} numbers; fill the empty "
                "cells with 0."
            )
        for row in self.occurrences:
            for value in row:
                checked_number("occurrences in the scatter diagram", value, at_least=0)
        if not sum(map(sum, self.occurrences)) > 0:
            raise InputError("scatter diagram must have an occurrence above 0, got none.")

    @property
    def shares(self) -> np.ndarray:
        """Share of the time of each sea (height, period); the sum is 1."""
        numbers = np.asarray(self.occurrences, float)
        return numbers / numbers.sum()

    @property
    def mean_height(self) -> float:
        """Mean significant height [m]."""
        return float(self.shares.sum(axis=1) @ np.asarray(self.heights))

    def seas(self, **others) -> tuple[tuple[float, SeaState], ...]:
        """Share and sea of every cell that occurs; ``others`` as for `SeaState`, such as ``spectrum``."""
        found = []
        for height, row in zip(self.heights, self.shares, strict=True):
            for period, share in zip(self.periods, row, strict=True):
                if share > 0:
                    found.append((float(share), sea_by_period(height, period, self.period_kind, **others)))
        return tuple(found)


def sea_by_period(height: float, period: float, kind: str, **others) -> SeaState:
    """Sea of a significant height [m] and a period [s] of one of the `PERIODS`; ``others`` as for `SeaState`."""
    checked_choice("kind of period", kind, PERIODS)
    if kind == "mean":
        return SeaState.from_mean_period(height, period, **others)
    if kind == "zero-crossing":
        return SeaState.from_zero_crossing_period(height, period, **others)
    return SeaState(significant_wave_height=height, peak_period=period, **others)


def scatter_of_text(
    text: str, *, name: str, period_kind: str = "zero-crossing", source: str = ""
) -> ScatterDiagram:
    """Scatter diagram from CSV text: periods in the head row, a height in front of each row, # for remarks."""
    rows = list(csv.reader(line for line in text.splitlines() if line.strip() and not line.startswith("#")))
    try:
        periods = tuple(float(cell) for cell in rows[0][1:])
        numbers = tuple(tuple(float(cell or 0) for cell in row) for row in rows[1:])
    except (ValueError, IndexError, csv.Error) as error:
        raise InputError(
            f"scatter diagram must be numbers with periods in its head and heights in front, got: {error}."
        ) from None
    return ScatterDiagram(
        name=name,
        heights=tuple(row[0] for row in numbers),
        periods=periods,
        occurrences=tuple(row[1:] for row in numbers),
        period_kind=period_kind,
        source=source,
    )


@cache
def scatter_diagram(name: str) -> ScatterDiagram:
    """Scatter diagram that comes with the package, by its name: "north-atlantic" ([IACS34]_)."""
    checked_choice("scatter diagram", name, DIAGRAMS)
    file, kind = DIAGRAMS[name]
    text = files("workbench").joinpath("data", "seas", file).read_text(encoding="utf-8")
    return scatter_of_text(text, name=name, period_kind=kind, source=text.splitlines()[0][1:].strip())
