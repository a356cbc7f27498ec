"""Section: a section that enters the water, from a wedge to the deck's own, by every theory at once."""

from collections.abc import Callable
from html import escape

import ipywidgets as widgets
import xarray as xr

from workbench.app.form import Form
from workbench.app.model import Model
from workbench.app.panels.panel import Panel
from workbench.app.reading import Problems
from workbench.app.section_inputs import SECTION_GROUPS, entry_case, section_fields
from workbench.impact.entry_case import (
    ON_REQUEST,
    THEORIES,
    ComparedEntries,
    EntryCase,
    compared_entries,
    is_quick,
)
from workbench.scene.section_view import SectionView

COMING = "Being computed."
ASK = "Takes up to a minute; press the button beside the picture."
SLOW_METHOD = "nonlinear"


class SectionPanel(Panel):
    """Controls beside the view. Quick theories answer while a slider moves, the others follow, the slowest on request.

    Parameters
    ----------
    solve : asks for an entry by a theory that takes long.
    """

    title = "Section"

    def __init__(
        self, model: Model, post: Callable[[], None], solve: Callable[[EntryCase, str], None]
    ) -> None:
        super().__init__(model, post)
        self.solve = solve
        self.case: EntryCase | None = None
        self._title = ""
        self._known: dict[str, xr.Dataset | str] = {}
        self._shown: tuple = ()

    def build(self) -> list[widgets.Widget]:
        """Make form, button and view."""
        self.form = Form(
            self._form_said,
            groups=[list(group) for group in SECTION_GROUPS],
            fields=self._fields(),
            values=dict(self.model.section_inputs),
        )
        self.button = widgets.Button(
            description="Solve non-linear flow", tooltip="Solve the non-linear flow, up to a minute"
        )
        self.button.add_class("wb-data-button")
        self.button.on_click(lambda _: self._solve())
        self.state = widgets.HTML()
        asked = widgets.VBox([self.button, self.state])
        asked.add_class("wb-card")
        side = widgets.VBox([self.form, asked])
        side.add_class("wb-section-side")
        self.view = SectionView()
        self.view.shown = [one for one in self.model.section_inputs["section_shown"].split(",") if one]
        self.view.observe(self._theories_ticked, names=["shown"])
        self.model.observe(self._inputs_changed, names=["section_inputs", "base"])
        both = widgets.Box([side, self.view])
        both.add_class("wb-section")
        return [both]

    def show(self, is_newest: Callable[[], bool], is_current: bool) -> None:
        """Bring form and view up to date, theory by theory, until something newer is wanted."""
        super().show(is_newest, is_current)
        model = self.model
        try:
            case, in_use = entry_case(model.section_inputs, model.base, model.quiet_case())
        except Problems as error:
            self.form.problems = dict(error.sentences)
            self.view.old = True
            return
        self.form.problems = {}
        self._title = in_use.title
        if case != self.case:
            self.case, self._known = case, {}
        self.form.notes = self._notes(case, in_use.words)
        self._take_solved()
        todo = [name for name in THEORIES if name not in self._known and name not in ON_REQUEST]
        for quick in (True, False):
            for name in [one for one in todo if is_quick(case.section, one) is quick]:
                if not is_newest():
                    return
                found, refused = compared_entries(case, (name,))
                self._known |= found | refused
            self._draw()

    def _take_solved(self) -> None:
        """Take what slow theories have answered for the present case, and say what could be asked for."""
        solved = self.model.solved_entries.get((self.case, SLOW_METHOD))
        if solved is not None:
            self._known[SLOW_METHOD] = solved
        self.state.value = (
            ""
            if isinstance(solved, xr.Dataset)
            else f"<p class='wb-note'>{escape(solved or 'Boundary elements, up to a minute. Stop it at the top.')}</p>"
        )

    def _draw(self) -> None:
        """Show what is known, unless it is shown already."""
        known = tuple(self._known)
        if self._shown == (self.case, known) and not self.view.old:
            return
        waiting = {name: ASK if name in ON_REQUEST else COMING for name in THEORIES if name not in known}
        found = {
            name: self._known[name] for name in THEORIES if isinstance(self._known.get(name), xr.Dataset)
        }
        refused = {name: sentence for name, sentence in self._known.items() if isinstance(sentence, str)}
        self.view.show(self.case, ComparedEntries(found, refused), waiting, self._title)
        self._shown = (self.case, known)

    def _solve(self) -> None:
        if self.case is not None and not self.form.problems:
            self.solve(self.case, SLOW_METHOD)

    def _form_said(self, content: dict) -> None:
        if content.get("type") == "set" and isinstance(content.get("name"), str):
            self.model.change_section(content["name"], content.get("value"))

    def _theories_ticked(self, change) -> None:
        self.model.change_section("section_shown", ",".join(change["new"]))

    def _inputs_changed(self, *_: object) -> None:
        """Let the form show the inputs at once; the view follows."""
        inputs = self.model.section_inputs
        fields = self._fields()
        with self.form.hold_sync():
            if fields != self.form.fields:
                self.form.fields = fields
            self.form.values = dict(inputs)
        shown = [one for one in inputs["section_shown"].split(",") if one]
        if set(shown) != set(self.view.shown):
            self.view.shown = shown

    def _fields(self) -> list[dict]:
        return [one.as_dict() for one in section_fields(self.model.base)]

    def _notes(self, case: EntryCase, words: str) -> dict[str, str]:
        """Return small words under the controls."""
        milliseconds = 1e3 * case.duration
        return {
            "section_kind": words,
            "section_points": "Convex, from the centreline y = 0 outwards, z up.",
            "section_deceleration": "Constant; the exact wedge needs 0.",
            "section_penetration": f"Reached after {milliseconds:.3g} ms.",
            "section_panel_outer": "Half-breadths; the pressure is averaged between them.",
        }
