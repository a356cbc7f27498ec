"""The inputs of the section that enters the water: controls, and from them a validated entry."""

import re
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from workbench.app.case import Case
from workbench.app.control import Input, number_input, rounded_to
from workbench.app.reading import Problems, as_number, in_words
from workbench.conventions import GRAVITY
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.impact.entry_case import THEORIES, EntryCase, usual_penetration
from workbench.impact.section import Circle, Parabola, Section, TableSection, Wedge
from workbench.scene.section_view import AT_FIRST

SECTION_GROUPS = (("shape", "Section", True), ("entry", "Entry", True), ("panel", "Panel", True))
SECTION_DEFAULTS: dict[str, Any] = {
    "section_kind": "wedge", "section_deadrise": 20.0, "section_radius": 5.0,
    "section_points": "0, 0\n1, 0.1\n2, 0.5\n2.5, 1.2", "section_velocity": 2.0, "section_deceleration": 0.0,
    "section_penetration": 0.5, "section_panel_inner": 0.5, "section_panel_outer": 1.0,
    "section_shown": ",".join(AT_FIRST),
}  # fmt: skip
"""Inputs at first; ``section_shown`` names the theories that are drawn."""

KINDS = {"wedge": "wedge", "parabola": "parabola", "circle": "circle", "points": "points of my own"}
MOST_POINTS, LONGEST_TEXT = 200, 20_000
CREST_SHARE = 9e-4
"""Penetration at first of a flat deck into a crest, over its radius: the deck then meets it at some 3 degrees."""


def kinds_for(design: Design) -> dict[str, str]:
    """Return the kinds of section that are offered, with their words; those of the deck where there is one."""
    deck, found = design.wet_deck, dict(KINDS)
    if deck is None:
        return found
    if deck.vee_depth > 0:
        found["pod"] = "the V of this deck's pod"
    if deck.centre_bow_depth > 0:
        found["bow"] = "the V of this deck's centre bow"
    found["crest"] = "this deck, flat, on a wave crest"
    return found


def section_fields(design: Design) -> tuple[Input, ...]:
    """Return the controls of the section, of the entry, and of the panel."""
    only = {
        name: (("section_kind", kinds),)
        for name, kinds in (
            ("deadrise", ("wedge",)), ("radius", ("parabola", "circle")), ("points", ("points",)),
        )
    }  # fmt: skip
    return (
        Input(name="section_kind", label="Kind", group="shape", kind="choice",
              choices=tuple(kinds_for(design).items())),
        number_input("section_deadrise", "Deadrise [deg]", "shape", 2, 60, step=0.5, phrases=("deadrise",),
                     shown_if=only["deadrise"]),
        number_input("section_radius", "Radius [m]", "shape", 0.5, 20, step=0.1, phrases=("radius",),
                     shown_if=only["radius"]),
        Input(name="section_points", label="y, z [m], a line each", group="shape", kind="text",
              shown_if=only["points"]),
        number_input("section_velocity", "Velocity [m/s]", "entry", 0.5, 10, step=0.1, phrases=("velocity",)),
        number_input("section_deceleration", "Deceleration [m/s²]", "entry", 0, 10, step=0.1,
                     phrases=("deceleration",)),
        number_input("section_penetration", "Shown until deep [m]", "entry", 0.02, 1.5, step=0.01,
                     phrases=("penetration",)),
        number_input("section_panel_inner", "Inner edge [m]", "panel", 0, 5, step=0.05, phrases=("inner edge",)),
        number_input("section_panel_outer", "Outer edge [m]", "panel", 0, 5, step=0.05, phrases=("outer edge",)),
    )  # fmt: skip


class SectionInUse(NamedTuple):
    """A section, a title, and words on where it comes from; empty where the controls say it."""

    section: Section
    title: str = ""
    words: str = ""


def section_of(inputs: Mapping[str, Any], design: Design, case: Case | None) -> SectionInUse:
    """Return the section that the inputs name.

    Parameters
    ----------
    design : as chosen; case : of the page's inputs, or None while they are refused.
    """
    kind = inputs["section_kind"]
    if kind == "wedge":
        limits = {"above": 0.0, "at_most": 85.0}
        angle = checked_number("deadrise", as_number(inputs["section_deadrise"]), "degrees", **limits)
        return SectionInUse(Wedge(float(np.radians(angle))))
    if kind in ("parabola", "circle"):
        radius = checked_number(
            "radius", as_number(inputs["section_radius"]), "m", at_least=0.01, at_most=1e4
        )
        return SectionInUse((Parabola if kind == "parabola" else Circle)(radius))
    if kind == "points":
        return SectionInUse(TableSection(points_of(str(inputs["section_points"]))))
    deck = (case.design if case else design).wet_deck
    if kind == "crest":
        return _crest(case)
    depth, width = (
        (deck.vee_depth, deck.vee_width) if kind == "pod" else (deck.centre_bow_depth, deck.centre_bow_width)
    )
    if depth <= 0:
        raise InputError(f"The {_OWNER[kind]} has no depth in the present design; choose another section.")
    angle = float(np.arctan(2 * depth / width))
    words = (
        f"V of the {_OWNER[kind]}: {depth:.3g} m deep, {width:.3g} m wide, {np.degrees(angle):.3g} degrees. "
        f"The deck is flat from y = {width / 2:.3g} m."
    )
    title = f"V of the {_OWNER[kind]}, {np.degrees(angle):.3g} degrees, enters calm water"
    return SectionInUse(Wedge(angle), title, words)


_OWNER = {"pod": "pod", "bow": "centre bow"}


def _crest(case: Case | None) -> SectionInUse:
    """Flat deck on the crest of a regular wave: their distance is that of a parabola from calm water."""
    if case is None:
        raise InputError(
            "The wave follows from the sea of the page, which is refused; mend that input first."
        )
    sea = case.condition.sea_state
    omega = 2 * np.pi / sea.peak_period
    radius = float(2 * GRAVITY**2 / (omega**4 * sea.significant_wave_height))
    words = (
        f"Crest of a regular wave {sea.significant_wave_height:.3g} m high with a period of "
        f"{sea.peak_period:.3g} s, which curves with {radius:.4g} m. y runs along the waves."
    )
    return SectionInUse(Parabola(radius), f"Flat deck on a wave crest of {radius:.4g} m radius", words)


def points_of(text: str) -> tuple[tuple[float, float], ...]:
    """Return the points of pasted or loaded text: y and z [m] on a line each; words above them are left out."""
    if len(text) > LONGEST_TEXT:
        raise InputError(f"The points must fit in {LONGEST_TEXT // 1000} kB of text; give fewer of them.")
    found: list[tuple[float, float]] = []
    for number, line in enumerate(text.splitlines(), 1):
        parts = [part for part in re.split(r"[;,\s]+", line.split("#")[0]) if part]
        if not parts:
            continue
        try:
            y, z = (float(part) for part in parts)
        except ValueError:
            if not found and not any(part[0].isdigit() for part in parts):
                continue
            raise InputError(
                f"Line {number} of the points must hold two numbers, y and z [m], got {line.strip()[:40]!r}."
            ) from None
        found.append((y, z))
    if len(found) > MOST_POINTS:
        raise InputError(f"The section may have {MOST_POINTS} points, got {len(found)}; leave some out.")
    return tuple(found)


def entry_case(
    inputs: Mapping[str, Any], design: Design, case: Case | None
) -> tuple[EntryCase, SectionInUse]:
    """Return the entry and its section with words; `Problems` with a sentence at a control."""
    shape = {"wedge": "section_deadrise", "parabola": "section_radius", "circle": "section_radius",
             "points": "section_points"}  # fmt: skip
    try:
        in_use = section_of(inputs, design, case)
    except InputError as error:
        control = shape.get(inputs["section_kind"], "section_kind")
        raise Problems({control: in_words(str(error))}) from None
    fields = section_fields(design)
    try:
        numbers = {
            one.name: checked_number(one.label.split(" [")[0], as_number(inputs[one.name]))
            for one in fields
            if one.kind == "number"
        }
        found = EntryCase(
            section=in_use.section,
            velocity=numbers["section_velocity"],
            penetration=numbers["section_penetration"],
            deceleration=numbers["section_deceleration"],
            density=design.density,
            panel=(numbers["section_panel_inner"], numbers["section_panel_outer"]),
        )
    except InputError as error:
        raise Problems({_control_named(str(error), fields): in_words(str(error))}) from None
    return found, in_use


def _control_named(sentence: str, fields: tuple[Input, ...]) -> str:
    """Return the name of the control that a sentence names first."""
    lowered = sentence.lower()
    places = [
        (lowered.find(phrase.lower()), one.name)
        for one in fields
        for phrase in (*one.phrases, one.label.split(" [")[0])
        if phrase.lower() in lowered
    ]
    return min(places)[1] if places else "section_penetration"


def changed_section(inputs: Mapping[str, Any], name: str, value: Any, design: Design, case: Case | None):
    """Return the inputs after one was changed; another section comes with a penetration that suits it."""
    new = dict(inputs) | {name: value}
    if name in ("section_kind", "section_radius"):
        try:
            section = section_of(new, design, case).section
        except InputError:
            return new
        depth = usual_penetration(section)
        if new["section_kind"] == "crest":
            depth = CREST_SHARE * section.radius
        new["section_penetration"] = rounded_to(depth)
    return new


def usable_section(given: Mapping[str, Any], design: Design) -> tuple[dict[str, Any], list[str]]:
    """Return what of stored inputs can be used, and sentences on the rest."""
    usable: dict[str, Any] = {}
    ignored = []
    kinds = kinds_for(design)
    for name, value in given.items():
        is_plain = isinstance(value, int | float | str) and not isinstance(value, bool)
        allowed = name in SECTION_DEFAULTS and is_plain
        if name == "section_kind":
            allowed = allowed and value in kinds
        if name == "section_shown":
            allowed = allowed and all(one in THEORIES for one in str(value).split(",") if one)
        if allowed:
            is_text = isinstance(SECTION_DEFAULTS[name], str)
            usable[name] = str(value) if is_text else as_number(value)
        else:
            ignored.append(f"{name} = {value!r} is not an input of this page.")
    return usable, ignored


def unusual_section(inputs: Mapping[str, Any]) -> dict[str, Any]:
    """Return the inputs that are not those at first."""
    return {name: value for name, value in inputs.items() if value != SECTION_DEFAULTS[name]}
