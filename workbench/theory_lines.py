"""Lines of the theories of water entry, the same in figures and in the view: told apart by dash and by colour."""

from typing import NamedTuple


class TheoryLine(NamedTuple):
    """Colour of a line, its dashes (drawn, left out, ...) in widths of the line, and its width."""

    colour: str
    dash: tuple[float, ...]
    width: float = 1.8


THEORY_LINES = {
    "von-karman": TheoryLine("#66737c", (1, 1.6)),
    "wagner": TheoryLine("#0072b2", (5, 2)),
    "logvinovich": TheoryLine("#c4500a", (6, 1.6, 1, 1.6)),
    "generalised-wagner": TheoryLine("#00845f", (2.6, 1.3)),
    "similarity": TheoryLine("#1d2b35", (), 2.0),
    "nonlinear": TheoryLine("#b4508a", (9, 2)),
    "chuang": TheoryLine("#8a6d00", (4, 1.3, 1, 1.3, 1, 1.3)),
}
"""Colours of Okabe and Ito, darkened for thin lines on white; by method of `workbench.impact.entry`."""
