"""One verification case: a number that is known, the same number computed, and how far apart they may be."""

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from workbench.errors import InputError, checked_choice, checked_number

KINDS = ("closed form", "published", "second code", "second method", "trend")
VERDICTS = ("agrees", "known miss", "fails")


@dataclass(frozen=True, kw_only=True, eq=False)
class Case:
    """A number that is known, and the way to compute it here.

    Parameters
    ----------
    id : of letters, digits and hyphens; names the case in tables, tests and evidence.
    title : what is compared, in one line.
    kind : one of `KINDS`, best evidence first.
    source : citation of the known number.
    published : the known number, in ``unit``.
    computed : makes the same number from the package.
    tolerance : largest difference that counts as agreement, in ``unit``.
    unit : of the two numbers.
    note : what a reader should know about the comparison.
    miss : for a case that is known not to agree, the reason; empty otherwise.
    miss_figure : the computed number that the reason is about; the case fails if
        the computed number leaves it by more than ``miss_band``.
    miss_band : in ``unit``.
    slow : takes more than some seconds, and is left out unless asked for.
    """

    id: str
    title: str
    kind: str
    source: str
    published: float
    computed: Callable[[], float]
    tolerance: float
    unit: str = "-"
    note: str = ""
    miss: str = ""
    miss_figure: float | None = None
    miss_band: float = 0.0
    slow: bool = False

    def __post_init__(self):
        checked_choice(f"kind of case {self.id}", self.kind, KINDS)
        checked_number(f"published number of case {self.id}", self.published)
        checked_number(f"tolerance of case {self.id}", self.tolerance, at_least=0)
        if self.miss:
            checked_number(f"figure of the known miss {self.id}", self.miss_figure)
            checked_number(f"band of the known miss {self.id}", self.miss_band, above=0)


@dataclass(frozen=True, kw_only=True, eq=False)
class Outcome:
    """A case that was run: the computed number, the verdict, the time it took [s], and why it was refused."""

    case: Case
    computed: float
    verdict: str
    seconds: float
    refusal: str = ""

    @property
    def difference(self) -> float:
        """Computed less published number."""
        return self.computed - self.case.published

    def as_dict(self) -> dict:
        """Return the outcome as plain values; a computed number that is not finite becomes None."""
        finite = bool(np.isfinite(self.computed))
        return {
            "id": self.case.id,
            "title": self.case.title,
            "kind": self.case.kind,
            "source": self.case.source,
            "unit": self.case.unit,
            "published": self.case.published,
            "computed": self.computed if finite else None,
            "difference": self.difference if finite else None,
            "tolerance": self.case.tolerance,
            "verdict": self.verdict,
            "note": self.case.note,
            "miss": self.case.miss,
            "refusal": self.refusal,
            "seconds": round(self.seconds, 3),
        }


def outcome(case: Case) -> Outcome:
    """Run a case.

    The verdict is "agrees" within the tolerance, "known miss" outside it where the
    case says so and the figure is the one it names, and "fails" otherwise, also
    where the package refuses to compute.
    """
    start = time.perf_counter()
    refusal = ""
    try:
        computed = float(case.computed())
    except InputError as error:
        computed, refusal = float("nan"), str(error)
    seconds = time.perf_counter() - start
    verdict = "fails"
    if abs(computed - case.published) <= case.tolerance:
        verdict = "agrees"
    elif case.miss and abs(computed - case.miss_figure) <= case.miss_band:
        verdict = "known miss"
    return Outcome(case=case, computed=computed, verdict=verdict, seconds=seconds, refusal=refusal)


def relative_difference(computed, known, scale=None) -> float:
    """Largest difference over the largest (or the given) size of the known values [-]."""
    known = np.asarray(known)
    scale = np.abs(known).max() if scale is None else scale
    return float(np.abs(np.asarray(computed) - known).max() / scale)
