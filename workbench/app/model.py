"""The state of one page, without widgets: inputs in the user's units, what is wrong with them, results."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import traitlets
import xarray as xr

from workbench.app.case import Case
from workbench.app.deck_pressure_inputs import DECK_PRESSURE_DEFAULTS
from workbench.app.inputs import CONDITION_DEFAULTS, inputs_for
from workbench.app.method_inputs import METHOD_DEFAULTS
from workbench.app.reading import (
    Problems,
    as_typed,
    case_of,
    changed_inputs,
    uploaded_design,
    usual_inputs,
)
from workbench.app.running_inputs import RUNNING_DEFAULTS
from workbench.app.section_inputs import (
    SECTION_DEFAULTS,
    changed_section,
    kinds_for,
    unusual_section,
    usable_section,
)
from workbench.app.ship_inputs import inputs_of
from workbench.design import Design
from workbench.errors import InputError
from workbench.files import design_to_toml
from workbench.hulls import library
from workbench.verdict import verdict

if TYPE_CHECKING:
    from workbench.pipeline import Response, Slamming
    from workbench.pressure_stage import RealisedDeck

FIRST_DESIGN = "austal-63"
LOADED = "loaded"
MOST_REFINED = 8
"""Refined inputs that are remembered."""
ALIKE = 1.5
"""Ratio of lengths up to which another design keeps speed and sea."""


@dataclass(frozen=True, eq=False)
class Findings:
    """Closed-form results of a case."""

    case: Case
    ship: Response
    relative: xr.Dataset | None
    slam: Slamming | None
    curve: xr.Dataset | None


@dataclass(frozen=True, eq=False)
class Counted:
    """Slams counted in a realisation of a case."""

    key: tuple
    findings: Findings
    events: xr.Dataset
    counts: xr.Dataset


@dataclass(frozen=True, eq=False)
class DeckSlams:
    """Pressure over the deck in every slam of a realisation.

    ``is_whole`` is no while only the beginning of the record was computed; ``histories`` are those that were
    looked at.
    """

    key: tuple
    findings: Findings
    realised: RealisedDeck
    slams: xr.Dataset
    is_whole: bool = True
    histories: dict[tuple, xr.Dataset] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Compared:
    """Theories laid over each other, and what they were computed for."""

    key: tuple
    motions: xr.Dataset
    measured: tuple[xr.Dataset, ...]


class Model(traitlets.HasTraits):
    """Everything that one page knows.

    Attributes
    ----------
    design_name : of the library, or 'loaded'; base : the design as chosen or loaded,
    before any change on the page.
    inputs : name to value, in the units of the labels (numbers may still be text while they are typed).
    problems : name of a control to the sentence why it cannot be used; empty when all can.
    notice : a sentence about what was done for the reader.
    refined : inputs for which the reader asked for the panel method, newest last.
    section_inputs : those of the section that enters the water; solved_entries : its entries by theories that
    take long, by case and theory, or a sentence why one is refused.
    findings, counted, deck_slams, scene, compared : the newest results, which may be out of date.
    """

    design_name = traitlets.Unicode(FIRST_DESIGN)
    base = traitlets.Instance(Design, allow_none=True)
    inputs = traitlets.Dict()
    problems = traitlets.Dict()
    notice = traitlets.Unicode("")
    findings = traitlets.Instance(Findings, allow_none=True)
    counted = traitlets.Instance(Counted, allow_none=True)
    deck_slams = traitlets.Instance(DeckSlams, allow_none=True)
    compared = traitlets.Instance(Compared, allow_none=True)
    refined = traitlets.Tuple()
    section_inputs = traitlets.Dict(dict(SECTION_DEFAULTS))
    solved_entries = traitlets.Dict()
    scene = traitlets.Any(None, allow_none=True)
    scene_key = traitlets.Any(None, allow_none=True)

    def __init__(self, design_name: str = FIRST_DESIGN) -> None:
        super().__init__()
        self.choose(design_name)

    def choose(self, name: str) -> None:
        """Take a design of the library, as it stands there."""
        self._take(name, library.design(name))

    def load(self, text: str) -> None:
        """Take a design from the text of a TOML file; a refused one is a problem, and nothing changes."""
        try:
            self._take(LOADED, uploaded_design(text))
        except InputError as error:
            self.problems = {**self.problems, "design": str(error)}

    def _take(self, name: str, design: Design) -> None:
        former = self.base
        inputs = dict(self.inputs)
        notice = ""
        ratio = design.hull.length / former.hull.length if former else 0.0
        if not 1 / ALIKE < ratio < ALIKE:
            lasting = {"criterion", "law", "hours", "seed", *METHOD_DEFAULTS, *DECK_PRESSURE_DEFAULTS}
            inputs = usual_inputs(design) | {key: inputs[key] for key in inputs if key in lasting}
            if former:
                notice = f"Speed and sea were set to suit a ship of {design.hull.length:.3g} m."
        own = {one.name for one in inputs_for(design)}
        kept = {key: value for key, value in (CONDITION_DEFAULTS | inputs).items() if key in own}
        with self.hold_trait_notifications():
            self.base = design
            self.design_name = name
            self.notice = notice
            self.problems = {}
            usual_attitude = {key: value for key, value in RUNNING_DEFAULTS.items() if key in own}
            self.inputs = kept | usual_attitude | inputs_of(design)
            if self.section_inputs["section_kind"] not in kinds_for(design):
                self.section_inputs = {**self.section_inputs, "section_kind": "wedge"}

    def change(self, name: str, value: Any) -> None:
        """Change one input, with what goes with it."""
        if name == "design":
            self.choose(str(value))
            return
        if name not in self.inputs or not isinstance(value, int | float | str):
            return
        self.notice = ""
        self.inputs = changed_inputs(self.inputs, name, as_typed(name, value, self.base))

    def change_section(self, name: str, value: Any) -> None:
        """Change one input of the section that enters the water, with what goes with it."""
        usable, _ = usable_section({name: value}, self.base)
        if usable:
            self.section_inputs = changed_section(
                self.section_inputs, name, usable[name], self.base, self.quiet_case()
            )

    def restore_design(self) -> None:
        """Undo all changes to the design, not to condition and criterion."""
        self.inputs = self.inputs | inputs_of(self.base)

    def case(self) -> Case | None:
        """Return the case of the present inputs, or None after setting ``problems``."""
        try:
            found = self._case()
        except Problems as error:
            self.problems = dict(error.sentences)
            return None
        if self.problems:
            self.problems = {}
        return found

    def quiet_case(self) -> Case | None:
        """Return the case of the present inputs, or None; says nothing of problems."""
        try:
            return self._case()
        except Problems:
            return None

    def _case(self) -> Case:
        found = case_of(self.base, dict(self.inputs))
        is_refined = found.refinement is not None and _refined_key(found) in self.refined
        return dataclasses.replace(found, is_refined=True) if is_refined else found

    def refine(self) -> None:
        """Ask for the panel method for the present inputs, where it is recommended."""
        case = self.case()
        if case is not None and case.refinement is not None and not case.is_refined:
            self.refined = (*self.refined, _refined_key(case))[-MOST_REFINED:]

    def leave_unrefined(self, case: Case) -> None:
        """Take back the request for the panel method."""
        self.refined = tuple(key for key in self.refined if key != _refined_key(case))

    @property
    def blockers(self) -> tuple[str, ...]:
        """Sentences why nothing can be computed from the present inputs."""
        return tuple(dict.fromkeys(self.problems.values()))

    def state(self) -> dict[str, Any]:
        """Return all that is needed to open this page again, as plain values."""
        loaded = design_to_toml(self.base) if self.design_name == LOADED else ""
        state = {"design": self.design_name, "toml": loaded, "inputs": dict(self.inputs)}
        section = unusual_section(self.section_inputs)
        state |= {"section": section} if section else {}
        case = self.quiet_case() if self.refined else None
        return state | ({"refined": True} if case is not None and case.is_refined else {})

    def restore(self, state: dict[str, Any]) -> list[str]:
        """Open a page again; returns sentences about what of the state could not be used."""
        ignored = []
        name, text = state.get("design", self.design_name), state.get("toml", "")
        try:
            if name == LOADED and isinstance(text, str) and text:
                self._take(LOADED, uploaded_design(text))
            elif name != LOADED:
                self._take(str(name), library.design(str(name)))
        except InputError as error:
            ignored.append(str(error))
        known = {one.name: one for one in inputs_for(self.base)}
        given = state.get("inputs", {})
        given = dict(given) if isinstance(given, dict) else {}
        section = state.get("section", {})
        section = dict(section) if isinstance(section, dict) else {}
        section |= {key: given.pop(key) for key in list(given) if key in SECTION_DEFAULTS}
        usable = {}
        for key, value in given.items():
            control = known.get(key)
            allowed = control and (
                control.kind != "choice" or value in {choice for choice, _ in control.choices}
            )
            if not allowed or isinstance(value, bool) or not isinstance(value, int | float | str):
                ignored.append(f"{key} = {value!r} is not an input of this page.")
            else:
                usable[key] = as_typed(key, value, self.base)
        self.inputs = self.inputs | usable
        usable, unusable = usable_section(section, self.base)
        self.section_inputs = self.section_inputs | usable
        ignored += unusable
        self.notice = ""
        if state.get("refined") is True:
            self.refine()
        return ignored

    def verdict(self) -> str:
        """Return the sentence on the present findings."""
        found = self.findings
        if found is None:
            return ""
        if found.slam is None:
            return (
                f"{found.case.design.title or found.case.design.name} has no wet deck; its motions are shown."
            )
        slam = found.slam
        worst = slam.statistics.isel(slam.worst_point)
        return verdict(
            speed_knots=round(slam.condition.speed * 3600 / 1852, 6),
            significant_wave_height=slam.condition.sea_state.significant_wave_height,
            heading_degrees=float(np.degrees(slam.condition.wave_direction)),
            slams_per_hour=float(worst.slams_per_hour),
            distance_from_fore_end=found.case.design.wet_deck.fore - float(worst.x),
            clearance=slam.clearance,
            least_clearance=slam.least_clearance,
            criterion_per_hour=slam.criterion_per_hour,
        )


def _refined_key(case: Case) -> tuple:
    """Return what the results by the panel method depend on."""
    return case.unrefined.response_key, case.refinement
