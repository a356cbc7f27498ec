"""One slam in time: which one, and at which averaging time, is the reader's choice."""

from collections.abc import Callable
from copy import copy
from dataclasses import replace

import xarray as xr

from workbench import quantities
from workbench.app.model import DeckSlams
from workbench.app.theory_in_use import relevant
from workbench.scene.deck_view import DeckView

RANKS = 10
"""Slams, hardest first, that can be looked at."""

MOST_KEPT = 24
"""Histories that are kept."""

WAITING = "The slams are being computed: an hour of a rough sea takes some 12 s, and more on a busy machine."
DRY = "The deck stays dry in this realisation: there is no slam to show."

_BY = {"slam_pressure": "pressure", "slam_force": "force"}
_CHOICES = [
    ["rank", "Slam shown", [["1", "the hardest slam"], *[[str(n), f"number {n}"] for n in range(2, RANKS + 1)]]],
    ["by", "Slams ranked by", [["slam_pressure", "by panel pressure"], ["slam_force", "by force"]]],
    ["steps", "Averaging time", [["record", "averaged as in the table"], ["fine", "short steps"]]],
]  # fmt: skip


class SlamView:
    """The view with what it needs of the slams.

    Parameters
    ----------
    post : called after a choice of the reader.
    """

    def __init__(self, post: Callable[[], None]) -> None:
        chosen = {name: options[0][0] for name, _, options in _CHOICES}
        self.view = DeckView(choices=_CHOICES, chosen=chosen, message=WAITING)
        self.view.add_class("wb-wide")
        self.view.observe(lambda _: post(), names=["chosen"])
        self._shown: tuple = ()

    def show(self, found: DeckSlams | None) -> None:
        """Show the chosen slam; None greys what is shown, which belongs to former inputs."""
        if found is None:
            self.view.old = True
            return
        if not found.slams.sizes["slam"]:
            self.view.message, self.view.notes, self.view.old, self._shown = DRY, [], False, ()
            return
        chosen = {name: self._chosen(name, options) for name, _, options in _CHOICES}
        wanted = (found, *chosen.values())
        if wanted == self._shown:
            self.view.old = False
            return
        rank = min(int(chosen["rank"]), found.slams.sizes["slam"])
        number = ranked(found.slams, rank, chosen["by"])
        history = slam_in_time(found, number, chosen["steps"] == "fine")
        start = float(found.slams.slam_start[number])
        words = "Hardest slam" if rank == 1 else f"Slam number {rank}"
        notes = (
            f"Averaged over {1e3 * history.attrs['time_step']:.3g} ms and over panels; the shorter, the higher the "
            "peaks.",
            *self._notes(found, history),
        )
        self.view.show(
            history,
            title=f"{words} by {_BY[chosen['by']]}, {start:.1f} s into the record",
            origin=start,
            notes=notes,
        )
        self._shown = wanted

    @staticmethod
    def _notes(found: DeckSlams, history: xr.Dataset) -> tuple[str, ...]:
        """Return the limits of a history that do not stand under the envelope already."""
        known = quantities.warnings_of(found.slams)
        own = (line for line in quantities.warnings_of(history) if line not in known)
        return (
            "What is said under the largest panel pressure of all slams holds here, too.",
            *relevant(own, found.findings),
        )

    def _chosen(self, name: str, options: list) -> str:
        """Return a choice, or the first where the page sent something else."""
        value = self.view.chosen.get(name)
        return value if value in {one for one, _ in options} else options[0][0]


def ranked(slams: xr.Dataset, rank: int, by: str) -> int:
    """Return the number of the slam of this rank, 1 the hardest."""
    from workbench.pressure_stage import hardest_slams

    return int(hardest_slams(slams, rank, by)[-1])


def slam_in_time(found: DeckSlams, number: int, is_fine: bool) -> xr.Dataset:
    """Return the history of a slam, at the step of the table or at a shorter one."""
    from workbench.pressure_stage import FINE_STEPS, slam_history

    key = (number, is_fine)
    if key not in found.histories:
        realised, step = found.realised, float(found.slams.attrs["time_step"])
        if is_fine:
            step = min(step, realised.step / FINE_STEPS)
        start, duration = (float(found.slams[name][number]) for name in ("slam_start", "slam_duration"))
        own = copy(realised)
        own.settings = replace(realised.settings, time_step=step)
        kept = dict(list(found.histories.items())[-MOST_KEPT + 1 :])
        found.histories.clear()
        found.histories.update(kept | {key: slam_history(own, start, duration)})
    return found.histories[key]
