"""The view of a section that enters the water, in a notebook or a Voila page: pressure, water and histories by theory.

It plays and answers the pointer in the browser; only the time, the state of playing and the theories shown pass
between page and kernel.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path

import anywidget
import traitlets

from workbench.errors import checked_choice
from workbench.impact.entry_case import (
    ON_REQUEST,
    THEORIES,
    ComparedEntries,
    EntryCase,
    compared_entries,
)
from workbench.scene.section_scene import section_scene

STATIC = Path(__file__).parent / "static"
AT_FIRST = ("von-karman", "wagner", "logvinovich", "generalised-wagner", "similarity", "nonlinear")
"""Theories shown at first, where they take the case."""


class SectionView(anywidget.AnyWidget):
    """A section entering the water, by theory.

    Attributes
    ----------
    time : instant shown after first contact [s]; may be set.
    playing : whether the film runs; may be set.
    shown : names of the theories that are drawn; may be set.
    old : whether the drawing belongs to former inputs.
    """

    _esm = STATIC / "section_view.js"
    _css = STATIC / "section_view.css"

    scene = traitlets.Dict().tag(sync=True)
    curves = traitlets.Bytes(b"").tag(sync=True)
    revision = traitlets.Int(0).tag(sync=True)
    time = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    shown = traitlets.List(traitlets.Unicode(), list(AT_FIRST)).tag(sync=True)
    old = traitlets.Bool(False).tag(sync=True)

    @traitlets.validate("shown")
    def _known(self, proposal) -> list[str]:
        return [checked_choice("The theory shown", name, THEORIES) for name in proposal["value"]]

    def show(
        self,
        case: EntryCase,
        compared: ComparedEntries,
        waiting: Mapping[str, str] | None = None,
        title: str = "",
    ) -> None:
        """Show another entry in place; the share of the film that is past is kept, at first it is the end."""
        facts, block = section_scene(case, compared, waiting, title)
        former = self.scene.get("times")
        share = self.time / former[-1] if former else 1.0
        with self.hold_sync():
            self.scene, self.curves = facts, block
            self.time = min(max(share, 0.0), 1.0) * facts["times"][-1]
            self.old = False
            self.revision += 1


def section_view(
    case: EntryCase, methods: Sequence[str] = tuple(name for name in THEORIES if name not in ON_REQUEST)
) -> SectionView:
    """Return the view of an entry by these theories, the quick ones if none are named.

    Theories that refuse the case are listed with the sentence why.
    """
    view = SectionView()
    view.shown = [name for name in methods if name in AT_FIRST]
    view.show(case, compared_entries(case, methods))
    return view
