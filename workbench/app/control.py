"""One control of the page: a number with a slider, or a choice."""

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Input:
    """One control of the page.

    Parameters
    ----------
    name : of the input; label : its words, with the unit.
    group : the heading under which it stands.
    kind : "number", "choice" or "text" (some lines, typed, pasted or loaded from a file).
    low, high, step : of the slider beside a number; None leaves the slider out.
    choices : pairs (value, words) of a choice.
    phrases : words by which a refused input names this control.
    shown_if : pairs (name of another input, allowed values); all must hold.
    """

    name: str
    label: str
    group: str
    kind: str = "number"
    low: float | None = None
    high: float | None = None
    step: float | None = None
    choices: tuple[tuple[str, str], ...] = ()
    phrases: tuple[str, ...] = ()
    shown_if: tuple[tuple[str, tuple[str, ...]], ...] = field(default=())

    def as_dict(self) -> dict[str, Any]:
        """Return what the page needs to draw the control."""
        return {
            "name": self.name, "label": self.label, "group": self.group, "kind": self.kind, "low": self.low,
            "high": self.high, "step": self.step, "choices": [list(pair) for pair in self.choices],
            "shown_if": [[name, list(values)] for name, values in self.shown_if],
        }  # fmt: skip


def rounded_to(value: float, digits: int = 2) -> float:
    """Value rounded to a number of significant digits."""
    return float(f"{value:.{digits}g}")


def slider_step(span: float) -> float:
    """Step of a slider: 1, 2 or 5 times a power of ten, some 100 to 250 to the span."""
    wanted = max(span, 1e-9) / 200
    power = 10.0 ** (len(f"{wanted:.0f}") - 1) if wanted >= 1 else 10.0 ** -_leading_zeros(wanted)
    for factor in (1, 2, 5, 10):
        if factor * power >= wanted:
            return rounded_to(factor * power, 1)
    return rounded_to(10 * power, 1)


def _leading_zeros(value: float) -> int:
    """Number of the first decimal of a value below 1 that is not 0."""
    return int(f"{value:e}".split("e-")[1]) if "e-" in f"{value:e}" else 0


def number_input(name: str, label: str, group: str, low: float, high: float, **others) -> Input:
    """Return a number with a slider from about ``low`` to ``high``."""
    step = others.pop("step", None) or slider_step(high - low)
    return Input(
        name=name, label=label, group=group, low=rounded_to(round(low / step) * step, 10),
        high=rounded_to(round(high / step) * step, 10), step=step, **others,
    )  # fmt: skip
