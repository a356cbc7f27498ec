"""The figures of the ship that the page shows: their controls, and the way to them and back."""

import dataclasses
import math
from collections.abc import Callable
from typing import Any

from workbench.app.control import Input, number_input, rounded_to
from workbench.arrangement import LARGEST_HEEL, LARGEST_TRIM
from workbench.design import Design
from workbench.errors import checked_number

_DEGREE = math.pi / 180

FIGURES = {
    "clearance": ("wet_deck", "clearance", 1.0),
    "deck_aft": ("wet_deck", "aft", 1.0),
    "deck_fore": ("wet_deck", "fore", 1.0),
    "deck_width": ("wet_deck", "width", 1.0),
    "entry_length": ("wet_deck", "entry_length", 1.0),
    "entry_rise": ("wet_deck", "entry_rise", 1.0),
    "camber": ("wet_deck", "camber", 1.0),
    "vee_depth": ("wet_deck", "vee_depth", 1.0),
    "vee_width": ("wet_deck", "vee_width", 1.0),
    "corner_radius": ("wet_deck", "corner_radius", 1.0),
    "centre_bow_length": ("wet_deck", "centre_bow_length", 1.0),
    "centre_bow_depth": ("wet_deck", "centre_bow_depth", 1.0),
    "centre_bow_width": ("wet_deck", "centre_bow_width", 1.0),
    "deck_trim_degrees": ("wet_deck", "trim", _DEGREE),
    "spacing": ("hull", "spacing", 1.0),
    "sinkage": ("hull", "sinkage", 1.0),
    "trim_degrees": ("hull", "trim", _DEGREE),
    "heel_degrees": ("hull", "heel", _DEGREE),
    "mass": ("masses", "mass", 1e3),
    "roll_gyradius": ("masses", "roll_gyradius", 1.0),
    "pitch_gyradius": ("masses", "pitch_gyradius", 1.0),
    "yaw_gyradius": ("masses", "yaw_gyradius", 1.0),
    "roll_damping_ratio": ("masses", "roll_damping_ratio", 1.0),
}
"""Name of the control to part, field and SI value of the control's unit."""

_LIMITS = {
    "deck_trim_degrees": LARGEST_TRIM,
    "trim_degrees": LARGEST_TRIM,
    "heel_degrees": LARGEST_HEEL,
}
"""Largest angles [rad], so that a refusal is in degrees."""


def figures_of(design: Design, part: str = "") -> dict[str, tuple[str, str, float]]:
    """Return the entries of `FIGURES` that a design has, of one part or of all."""
    left_out = set()
    if design.wet_deck is None:
        left_out |= {name for name, (owner, _, _) in FIGURES.items() if owner == "wet_deck"}
    if design.hull.count == 1:
        left_out.add("spacing")
    return {name: entry for name, entry in FIGURES.items() if name not in left_out and part in ("", entry[0])}


def inputs_of(design: Design) -> dict[str, Any]:
    """Return the inputs that describe a design, in the units of the page."""
    x, _, z = design.masses.centre_of_gravity
    values = {
        name: rounded_to(getattr(getattr(design, part), field) / factor, 6)
        for name, (part, field, factor) in figures_of(design).items()
    }
    return values | {
        "centre_height": rounded_to(z + design.hull.shape.draught, 6),
        "centre_x": rounded_to(x, 6),
    }


def changed_part(design: Design, part: str, number: Callable[[str], float]) -> Any:
    """Return hull, wet deck or masses with the figures of the page; what looks the same stays exactly.

    Parameters
    ----------
    part : "hull", "wet_deck" or "masses"; number : gives the number typed into a control.
    """
    owner = getattr(design, part)
    values: dict[str, Any] = {}
    for name, (_, field, factor) in figures_of(design, part).items():
        typed = number(name)
        if name in _LIMITS:
            limit = _LIMITS[name] / _DEGREE
            words = f"{part.replace('_', ' ')} {field}"
            typed = checked_number(words, typed, "degrees", at_least=-limit, at_most=limit)
        values[field] = _own_if_alike(getattr(owner, field), typed * factor, 1e-12)
    if part == "masses":
        x, y, z = owner.centre_of_gravity
        height = number("centre_height") - design.hull.shape.draught
        values["centre_of_gravity"] = (
            _own_if_alike(x, number("centre_x"), 1e-9), y, _own_if_alike(z, height, 1e-9),
        )  # fmt: skip
    return dataclasses.replace(owner, **values)


def _own_if_alike(own: float, value: float, tolerance: float) -> float:
    """Return the design's own number where the page shows the same."""
    return own if math.isclose(value, own, rel_tol=1e-5, abs_tol=tolerance) else value


def clearance_input(design: Design) -> Input:
    """Return the control of the wet-deck clearance."""
    height = design.wet_deck.clearance
    return number_input(
        "clearance", "Wet-deck clearance [m]", "design", 0.2 * height, 2.5 * height,
        phrases=("wet-deck clearance", "lowest point of the wet deck"),
    )  # fmt: skip


def ship_inputs(design: Design) -> list[Input]:
    """Return the controls of wet deck (but for its clearance), hulls and masses; sliders follow the size."""
    return [*_deck_inputs(design), *_hull_inputs(design), *_mass_inputs(design)]


def _deck_inputs(design: Design) -> list[Input]:
    if design.wet_deck is None:
        return []
    length, deck = design.hull.length, design.wet_deck
    span, height = deck.fore - deck.aft, deck.clearance
    rows = (
        ("deck_aft", "Aft end, x [m]", -0.6 * length, 0.4 * length, "aft end"),
        ("deck_fore", "Fore end, x [m]", -0.4 * length, 0.6 * length, "fore end"),
        ("deck_width", "Width [m]", 0.2 * deck.width, 1.5 * deck.width, "width of the wet deck"),
        ("entry_length", "Raked entry: length [m]", 0, span, "entry length"),
        ("entry_rise", "Raked entry: rise [m]", 0, 2 * height, "entry rise"),
        ("camber", "Camber [m]", 0, height, "camber"),
        ("vee_depth", "V of the pod: depth [m]", 0, height, "vee depth"),
        ("vee_width", "V of the pod: width [m]", 0, deck.width, "vee width"),
        ("corner_radius", "Corner radius [m]", 0, min(deck.width / 2, height), "corner radius"),
        ("centre_bow_length", "Centre bow: length [m]", 0, span, "centre bow length"),
        ("centre_bow_depth", "Centre bow: depth [m]", 0, height, "centre bow depth"),
        ("centre_bow_width", "Centre bow: width [m]", 0, deck.width, "centre bow width"),
        ("deck_trim_degrees", "Trim, bow down [deg]", -3, 3, "wet deck trim"),
    )
    return [
        number_input(name, label, "deck", low, high, phrases=(phrase, phrase.replace(" ", "_")))
        for name, label, low, high, phrase in rows
    ]


def _hull_inputs(design: Design) -> list[Input]:
    hull = design.hull
    draught = hull.shape.draught
    deepest = min(0.3 * draught, 0.8 * (hull.shape.depth - draught)) or 0.3 * draught
    found = [
        number_input("sinkage", "Sinkage [m]", "hull", -0.3 * draught, deepest, phrases=("sinkage",)),
        number_input("trim_degrees", "Trim, bow down [deg]", "hull", -3, 3, phrases=("hull trim",)),
        number_input("heel_degrees", "Heel, starboard down [deg]", "hull", -10, 10, phrases=("heel",)),
    ]
    if hull.count == 1:
        return found
    spacing = number_input(
        "spacing", "Spacing of the hulls' centre planes [m]", "hull", 1.05 * hull.shape.beam,
        2 * hull.spacing, phrases=("spacing",),
    )  # fmt: skip
    return [spacing, *found]


def _mass_inputs(design: Design) -> list[Input]:
    length, masses = design.hull.length, design.masses
    tonnes = masses.mass / 1e3
    return [
        number_input("mass", "Mass [t]", "masses", 0.8 * tonnes, 1.2 * tonnes, phrases=("mass",)),
        number_input(
            "centre_height", "Centre of gravity above keel KG [m]", "masses", 0,
            4 * design.hull.shape.draught, phrases=("height of the centre", "z of the centre"),
        ),
        number_input(
            "centre_x", "Centre of gravity forward of amidships [m]", "masses", -0.15 * length, 0.15 * length,
            phrases=("x of the centre", "centre of gravity x"),
        ),
        *(
            number_input(
                f"{mode}_gyradius", f"{mode.capitalize()} gyradius [m]", "masses",
                0.3 * getattr(masses, f"{mode}_gyradius"), 2 * getattr(masses, f"{mode}_gyradius"),
                phrases=(f"{mode} gyradius",),
            )
            for mode in ("roll", "pitch", "yaw")
        ),
        number_input("roll_damping_ratio", "Roll damping ratio [-]", "masses", 0, 0.3, phrases=("roll damping",)),
    ]  # fmt: skip
