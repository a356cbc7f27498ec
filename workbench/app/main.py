"""The page: links model, desk, form, head and panels, and nothing else."""

import html
import json
import threading
import traceback
from collections.abc import Callable
from typing import Any
from urllib.parse import parse_qsl, urlencode

import ipywidgets as widgets

from workbench import __version__
from workbench.app.deck_pressure_inputs import DECK_PRESSURE_DEFAULTS
from workbench.app.desk import Desk
from workbench.app.form import Form
from workbench.app.head import Head
from workbench.app.inputs import GROUPS, inputs_for
from workbench.app.method_inputs import METHOD_DEFAULTS, PANEL_METHOD_ACTS, panel_method_acts
from workbench.app.model import LOADED, Model
from workbench.app.notes import notes_under
from workbench.app.panels.animation import AnimationPanel
from workbench.app.panels.design import DesignPanel
from workbench.app.panels.files import FilesPanel
from workbench.app.panels.motions import MotionsPanel
from workbench.app.panels.pressure import PressurePanel
from workbench.app.panels.section import SectionPanel
from workbench.app.panels.slamming import SlammingPanel
from workbench.app.panels.theories import TheoriesPanel
from workbench.app.progress_words import is_awaited, may_refine, origin_of, state_of
from workbench.app.running_inputs import RUNNING_DEFAULTS
from workbench.app.section_inputs import unusual_section
from workbench.app.ship_inputs import inputs_of
from workbench.conventions import KNOT
from workbench.hulls import library

PERMALINK = (
    "clearance", "speed_knots", "heading_degrees", "wave_height", "period", "period_kind", "spectrum",
    "spreading",
    "criterion", "threshold_kind", "threshold", "law",
)  # fmt: skip
"""Inputs that the address of the page holds, beside the choices of the method that are not the usual ones."""

LONGEST_IN_ADDRESS = 400
"""Length from which a text is left out of the address [characters]."""

FIRST_TAB = 1
ROOM_ABOVE = 475
"""Height of what stands above the animation, and of the deck in plan below it [px]."""


class Page:
    """One page with its own model; everything that belongs to one reader hangs on it."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._offers_refinement = self._awaits_refinement = False
        self.model = Model()
        self.head = Head(self._head_said, version=__version__)
        self.form = Form(
            self._form_said,
            groups=[list(group) for group in GROUPS],
            designs=[[name, library.design(name).title] for name in library.names()],
        )
        self.desk = Desk(self.model, self._show)
        post = self.desk.post
        self.panels = [
            MotionsPanel(self.model, post),
            SlammingPanel(self.model, post),
            PressurePanel(self.model, post),
            AnimationPanel(self.model, post),
            TheoriesPanel(self.model, post, self.desk.compare),
            SectionPanel(self.model, post, self.desk.solve_entry),
            DesignPanel(self.model, post),
            FilesPanel(self.model, post, self.head.send_file, self._want_scene),
        ]
        self.tabs = widgets.Tab([panel.widget for panel in self.panels], selected_index=FIRST_TAB)
        for index, panel in enumerate(self.panels):
            self.tabs.set_title(index, panel.title)
        self.tabs.add_class("wb-tabs")
        body = widgets.Box([self.form, self.tabs])
        body.add_class("wb-body")
        self.widget = widgets.VBox([self.head, body])
        self.widget.add_class("wb-page")
        self._link()

    def _link(self) -> None:
        """Let changes of traits reach what shows them."""
        self._describe_fields()
        self._describe_inputs()
        self.model.observe(self._describe_fields, names=["base"])
        self.model.observe(
            self._describe_inputs,
            names=["inputs", "base", "problems", "notice", "design_name", "refined", "section_inputs"],
        )
        self.model.observe(self.desk.post, names=["inputs", "base", "refined", "section_inputs"])
        self.model.observe(self._describe_results, names=["findings", "problems", "refined"])
        self.desk.observe(self._describe_results, names=["is_current", "error"])
        for job in self.desk.jobs:
            job.observe(self._describe_work, names=["state", "progress", "message", "error"])
        self.tabs.observe(self._tab_changed, names=["selected_index"])
        self._tab_changed()

    def _form_said(self, content: dict[str, Any]) -> None:
        kind = content.get("type")
        if kind == "set" and isinstance(content.get("name"), str):
            self.model.change(content["name"], content.get("value"))
        elif kind == "load" and isinstance(content.get("text"), str):
            self.model.load(content["text"])
        elif kind == "undo":
            self.model.restore_design()

    def _head_said(self, content: dict[str, Any]) -> None:
        kind = content.get("type")
        if kind == "stop":
            self.desk.stop()
            self._describe_work()
        elif kind == "resume":
            self.desk.resume()
        elif kind == "refine":
            self.model.refine()
        elif kind == "hello":
            height = content.get("height")
            if isinstance(height, int | float):
                self.panels[3].height = int(min(max(height - ROOM_ABOVE, 420), 900))
            self._open_again(content.get("state"), content.get("query"))

    def _open_again(self, state: object, query: object) -> None:
        """Restore what the browser kept, or what the permalink says; say what could not be used."""
        kept: dict[str, Any] = {}
        try:
            kept = json.loads(state) if isinstance(state, str) and state else {}
        except json.JSONDecodeError:
            kept = {}
        if isinstance(kept, dict) and kept:
            ignored = self.model.restore(kept)
        elif isinstance(query, str) and query:
            pairs = dict(parse_qsl(query[:4000]))
            name = pairs.pop("design", self.model.design_name)
            ignored = self.model.restore({"design": name, "inputs": pairs})
        else:
            return
        if ignored:
            self.model.notice = "Left out: " + " ".join(ignored)

    def _tab_changed(self, *_: object) -> None:
        panel = self.panels[self.tabs.selected_index or 0]
        self.desk.needs_counts, self.desk.needs_scene = panel.needs_counts, panel.needs_scene
        self.desk.needs_pressures = panel.needs_pressures
        self.desk.post()

    def _want_scene(self) -> None:
        self.desk.needs_counts = self.desk.needs_scene = True
        self.desk.post()

    def _show(self, is_newest: Callable[[], bool]) -> None:
        self.panels[self.tabs.selected_index or 0].show(is_newest, self.desk.is_current)

    def _describe_fields(self, *_: object) -> None:
        self.form.fields = [one.as_dict() for one in inputs_for(self.model.base)]

    def _describe_inputs(self, *_: object) -> None:
        model, inputs = self.model, dict(self.model.inputs)
        changed = any(inputs.get(name) != value for name, value in inputs_of(model.base).items())
        designs = [entry for entry in self.form.designs if entry[0] != LOADED]
        if model.design_name == LOADED:
            designs.append([LOADED, f"loaded: {model.base.title or model.base.name}"])
        state = model.state()
        with self._lock, self.form.hold_sync():
            self.form.designs = designs
            self.form.design = model.design_name
            self.form.values = inputs | {PANEL_METHOD_ACTS: self._panel_method_acts(inputs)}
            self.form.problems = dict(model.problems)
            self.form.notes = notes_under(inputs, model.base)
            self.form.changed = changed
        small = {name: inputs[name] for name in PERMALINK if name in inputs and inputs[name] != ""}
        small |= {
            name: inputs[name]
            for name, usual in (METHOD_DEFAULTS | RUNNING_DEFAULTS | DECK_PRESSURE_DEFAULTS).items()
            if name in inputs and inputs[name] != usual
        }
        small |= {
            name: value
            for name, value in unusual_section(model.section_inputs).items()
            if len(str(value)) < LONGEST_IN_ADDRESS
        }
        with self._lock, self.head.hold_sync():
            self.head.permalink = (
                "" if model.design_name == LOADED else urlencode({"design": model.design_name, **small})
            )
            self.head.state = json.dumps(state)
            self.head.remark = model.notice

    def _panel_method_acts(self, inputs: dict[str, Any]) -> str:
        """Return whether the controls of the panel method act, "yes" or "no"."""
        try:
            speed = float(inputs["speed_knots"]) * KNOT
        except (TypeError, ValueError):
            return "no"
        acts = panel_method_acts(str(inputs.get("theory")), self.model.base.hull.length, speed)
        return "yes" if acts else "no"

    def _describe_results(self, *_: object) -> None:
        head, slam = self.head, self.model.findings.slam if self.model.findings else None
        with self._lock, head.hold_sync():
            head.problems = list(self.model.blockers)
            head.error = self.desk.error
            if self.model.findings is not None:
                head.verdict = self.model.verdict()
            wanted = self.model.quiet_case()
            head.origin = origin_of(self.model.findings, wanted) if self.desk.is_current else ""
            self._awaits_refinement = is_awaited(self.model.findings, wanted)
            self._offers_refinement = self.desk.is_current and may_refine(self.model.findings, wanted)
            if not self.desk.is_current:
                head.tone = "old"
            elif slam is None:
                head.tone = "plain"
            else:
                meets = float(slam.statistics.slams_per_hour.max()) <= slam.criterion_per_hour
                head.tone = "good" if meets else "bad"
        self._show_work()

    def _describe_work(self, *_: object) -> None:
        self._show_work()
        if self.desk.hull_job.state == "failed" and self.desk.hull_job.error:
            self.desk.post()

    def _show_work(self) -> None:
        """Let the head say what is being computed."""
        work, head = state_of(self.desk), self.head
        with self._lock, head.hold_sync():
            head.busy, head.progress, head.task = work.busy, work.progress, work.task
            idle = not work.busy and not work.action
            if idle and self._awaits_refinement:
                head.busy, head.task = True, "Refining with the panel method …"
            head.action = "refine" if idle and self._offers_refinement else work.action


def app() -> widgets.Widget:
    """Return the page as one widget; where it cannot be made, a readable account of why."""
    try:
        page = Page()
    except Exception as error:
        account = html.escape("".join(traceback.format_exception(error)))
        return widgets.HTML(
            "<div role='alert' style='max-width:720px;margin:60px auto;font:16px/1.5 system-ui,sans-serif'>"
            "<h1 style='font-size:22px'>The workbench could not start</h1>"
            f"<p>{html.escape(str(error) or type(error).__name__)}</p><p>Reload the page; if this "
            f"stays, send the account "
            "below to whoever runs this workbench.</p>"
            f"<details><summary>Account</summary><pre "
            f"style='white-space:pre-wrap'>{account}</pre></details></div>"
        )
    page.widget.page = page
    page.desk.post()
    return page.widget
