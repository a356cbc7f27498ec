"""From inputs to a validated case, and from a design to inputs; refusals name their control."""

import dataclasses
import math
import tomllib
from typing import Any

from workbench.app.case import LONGEST_COUNT, Case
from workbench.app.control import rounded_to
from workbench.app.deck_pressure_inputs import deck_pressure_settings
from workbench.app.inputs import CONDITION_DEFAULTS, OWN_SEA, inputs_for
from workbench.app.method_inputs import choices_of
from workbench.app.running_inputs import running_state_of
from workbench.app.ship_inputs import changed_part
from workbench.conventions import GRAVITY, KNOT
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.files import design_from_toml
from workbench.impact.pressure import PressureLaw
from workbench.seas import Condition, SeaState, period_ratio
from workbench.time_domain import Realisation

LARGEST_UPLOAD = 5_000_000

_GROUP_OF_PART = {
    "masses": "masses",
    "hull": "hull",
    "wet deck": "deck",
    "sea": "sea",
    "run": "run",
    "slams": "slams",
    "method": "method",
    "running": "running",
    "pressure": "pressure",
}


class Problems(Exception):  # noqa: N818
    """Sentences about inputs that cannot be used, by the name of their control."""

    def __init__(self, sentences: dict[str, str]):
        super().__init__("; ".join(sentences.values()))
        self.sentences = sentences


def usual_inputs(design: Design) -> dict[str, Any]:
    """Return a speed and a sea that suit the size of a design: Fn about 0.3, Hs L/25, waves of 1.5 L."""
    length = design.hull.length
    return CONDITION_DEFAULTS | {
        "speed_knots": rounded_to(0.3 * math.sqrt(GRAVITY * length) / KNOT),
        "wave_height": rounded_to(length / 25),
        "period": rounded_to(math.sqrt(2 * math.pi * 1.5 * length / GRAVITY)),
    }


def case_of(base: Design, inputs: dict[str, Any]) -> Case:
    """Return the case; `Problems` with a sentence for each part that is refused."""
    refused: dict[str, str] = {}
    controls = inputs_for(base)

    def part(name: str, make):
        try:
            return make()
        except InputError as error:
            refused.setdefault(control_named(str(error), base, _GROUP_OF_PART[name]), in_words(str(error)))
            return None

    def number(name: str, factor: float = 1.0) -> float:
        control = next((one for one in controls if one.name == name), None)
        label = control.label.split(" [")[0] if control else name
        return checked_number(label, as_number(inputs.get(name))) * factor

    def changed(group: str, owner: str):
        return part(group, lambda: changed_part(base, owner, number))

    wet_deck = changed("wet deck", "wet_deck") if base.wet_deck else None
    mass, hull = changed("masses", "masses"), changed("hull", "hull")
    condition = part("sea", lambda: _condition(inputs, number))
    slams = part("slams", lambda: _slam_choices(inputs, number))
    choices = condition and part("method", lambda: choices_of(inputs, number, base.hull, condition.speed))
    running = part("running", lambda: running_state_of(inputs, number, base))
    pressure = part("pressure", lambda: deck_pressure_settings(inputs, number))
    design = None
    if not refused:
        design = part(
            "wet deck", lambda: dataclasses.replace(base, hull=hull, wet_deck=wet_deck, masses=mass)
        )
    if refused or design is None:
        raise Problems(refused)
    return Case(
        design=design, condition=condition, settings=choices.first, refinement=choices.refinement,
        within=choices.within, running_state=running, deck_pressure=pressure,
        **slams,
    )  # fmt: skip


def _condition(inputs: dict[str, Any], number) -> Condition:
    """Return the condition."""
    spectrum = inputs.get("spectrum", "bretschneider")
    others: dict[str, Any] = {"spectrum": spectrum}
    if spectrum == "jonswap":
        others["peak_enhancement"] = number("peak_enhancement")
    if inputs.get("spreading"):
        others["spreading_exponent"] = as_number(inputs["spreading"])
    height = number("wave_height")
    if spectrum == "pierson-moskowitz":
        sea = SeaState(significant_wave_height=height, **others)
    else:
        made = {
            "peak": lambda: SeaState(significant_wave_height=height, peak_period=number("period"), **others),
            "mean": lambda: SeaState.from_mean_period(height, number("period"), **others),
            "zero": lambda: SeaState.from_zero_crossing_period(height, number("period"), **others),
        }
        sea = made[inputs.get("period_kind", "peak")]()
    heading = checked_number("heading", number("heading_degrees"), "degrees", at_least=0, at_most=360)
    return Condition(speed=number("speed_knots", KNOT), wave_direction=math.radians(heading), sea_state=sea)


def _slam_choices(inputs: dict[str, Any], number) -> dict[str, Any]:
    """Return threshold, law, hours, criterion and seed."""
    kind = inputs.get("threshold_kind", "none")
    threshold: str | float = {"none": 0.0, "ochi": "ochi"}.get(kind, 0.0)
    if kind == "value":
        threshold = checked_number("threshold velocity", number("threshold"), "m/s", at_least=0, at_most=50)
    name = inputs.get("law", "chuang")
    law = PressureLaw(name=name, coefficient=number("coefficient") if name == "panel" else None)
    criterion = checked_number("criterion", number("criterion"), "slams per hour", above=0, at_most=3600)
    hours = checked_number("hours", number("hours"), "h", above=0, at_most=1e5)
    realisation = Realisation(seed=number("seed"), hours=min(hours, LONGEST_COUNT))
    return {
        "threshold": threshold, "law": law, "hours": hours, "criterion_per_hour": criterion,
        "seed": int(realisation.seed),
    }  # fmt: skip


def changed_inputs(inputs: dict[str, Any], name: str, value: Any) -> dict[str, Any]:
    """Return the inputs after one was changed, with what goes with it (a preset sets the sea, and so on)."""
    from workbench.seas import sea_presets

    new = inputs | {name: value}
    if name == "preset" and value != OWN_SEA:
        preset = next((one for one in sea_presets() if one.name == value), None)
        if preset is not None:
            new |= {
                "wave_height": preset.significant_wave_height, "period": preset.peak_period,
                "period_kind": "peak",
                "spectrum": "bretschneider",
            }  # fmt: skip
    elif name in ("wave_height", "period", "spectrum", "period_kind"):
        new["preset"] = OWN_SEA
    if name == "period_kind":
        new["period"] = _converted_period(inputs, str(value))
    return new


def _converted_period(inputs: dict[str, Any], kind: str) -> Any:
    """Return the period of the same sea, of another kind."""
    orders = {"mean": 1, "zero": 2}
    shape = inputs.get("spectrum", "bretschneider"), as_number(inputs.get("peak_enhancement", 3.3))

    def ratio(which):
        return period_ratio(orders[which], *shape) if which in orders else 1.0

    try:
        return rounded_to(float(inputs["period"]) / ratio(inputs.get("period_kind", "peak")) * ratio(kind), 4)
    except (TypeError, ValueError):
        return inputs.get("period")


def uploaded_design(text: str) -> Design:
    """Return the design of an uploaded file; text only, and never one that names other files."""
    if len(text) > LARGEST_UPLOAD:
        raise InputError(
            f"design file must be smaller than {LARGEST_UPLOAD / 1e6:g} MB, got {len(text) / 1e6:.1f} MB."
        )
    try:
        hull = tomllib.loads(text).get("hull", {})
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InputError(f"design file must be valid TOML, it is not ({error}); repair that line.") from None
    shapes = [hull.get(name) for name in ("shape", "centre_shape")] if isinstance(hull, dict) else []
    if any(isinstance(shape, dict) and "file" in shape for shape in shapes):
        raise InputError(
            "design file must hold its stations or faces itself when it is loaded here, this one names "
            "another file; "
            "save it whole with the command line first."
        )
    return design_from_toml(text + "\n")


def as_number(value: Any) -> Any:
    """Return text that is a number as a number, for `checked_number` to judge."""
    if isinstance(value, str):
        try:
            return float(value.replace(",", "."))
        except ValueError:
            return value or "nothing"
    return value


def as_typed(name: str, value: Any, base: Design) -> Any:
    """Return text that was typed into a number box as the number it is, other text as it stands."""
    is_number = any(one.name == name and one.kind == "number" for one in inputs_for(base))
    typed = as_number(value) if is_number else value
    return typed if isinstance(typed, str) or math.isfinite(typed) else str(value)


def in_words(sentence: str) -> str:
    """Return a sentence with names as words and a capital letter."""
    plain = sentence.replace("_", " ")
    return plain[:1].upper() + plain[1:]


def control_named(sentence: str, base: Design, group: str) -> str:
    """Return the name of the control that a sentence is about: the one it names first, and at most length."""
    lowered = sentence.lower()
    controls = inputs_for(base)
    found = [
        (lowered.find(phrase.lower()), -len(phrase), control.group != group, control.name)
        for control in controls
        for phrase in (*control.phrases, control.label.split(" [")[0])
        if phrase.lower() in lowered
    ]
    if found:
        return min(found)[3]
    own = [control.name for control in controls if control.group == group]
    return own[0] if own else "design"
