"""The choice of theory and the choices within it that the page offers."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from workbench.app.control import Input, number_input
from workbench.conventions import GRAVITY, froude_number
from workbench.design import Design, Hull
from workbench.errors import InputError, checked_number
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import (
    IN_A_SENTENCE,
    METHODS,
    THEORY_NAMES,
    RecommendedSettings,
    TheorySettings,
    recommended,
)
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings

METHOD_DEFAULTS: dict[str, Any] = {
    "theory": "recommended", "interaction": "auto", "wave_field": "auto", "tunnel_damping": 0.0,
    "panels": 1000,
}  # fmt: skip
FEWEST_PANELS, MOST_PANELS = 200, 4000
SHORTEST_WAVE = 1 / 8
"""Shortest of the usual waves, in ship lengths [-]."""
PANEL_METHOD_ACTS = "panel_method_acts"
"""Name of the value, "yes" or "no", that says whether the controls of the panel method act."""

_ONLY_WHERE_IT_ACTS = ((PANEL_METHOD_ACTS, ("yes",)),)


def method_inputs(design: Design) -> list[Input]:
    """Return the controls of the method; those between hulls only where there are several."""
    theory = Input(
        name="theory", label="Theory", group="method", kind="choice",
        choices=(
            ("recommended", "recommended at this speed"),
            *((name, THEORY_NAMES[name]) for name in METHODS if name in THEORY_NAMES),
        ),
        phrases=("froude number", "theory"),
    )  # fmt: skip
    together = [
        Input(
            name="interaction", label="Hull interaction", group="method", kind="choice",
            choices=(("auto", "automatic"), ("on", "solved together"), ("off", "each hull alone")),
        ),
        Input(
            name="wave_field", label="Water under the deck", group="method", kind="choice",
            choices=(("auto", "automatic, by the speed"), ("incident", "incident wave only")),
            phrases=("wave field", "wave_field"), shown_if=_ONLY_WHERE_IT_ACTS,
        ),
        number_input(
            "tunnel_damping", "Damping between the hulls [-]", "method", 0, 0.2, step=0.005,
            phrases=("tunnel_damping", "tunnel damping"), shown_if=_ONLY_WHERE_IT_ACTS,
        ),
    ]  # fmt: skip
    panels = number_input(
        "panels", "Panels of the ship [-]", "method", FEWEST_PANELS, MOST_PANELS, step=50,
        phrases=("panels",), shown_if=_ONLY_WHERE_IT_ACTS,
    )  # fmt: skip
    if design.hull.count == 1:
        return [theory, panels]
    offered = (one for one in together if one.name != "wave_field" or design.wet_deck is not None)
    return [theory, *offered, panels]


def panel_method_acts(theory: str, length: float, speed: float) -> bool:
    """Whether the panel method is chosen, or recommended at this speed [m/s]."""
    if theory == "recommended":
        return "potential-flow" in recommended_theories(length, speed, (np.pi,))
    return theory == "potential-flow"


def recommended_theories(
    length: float, speed: float, wave_directions: tuple[float, ...], quick: bool = False
) -> tuple[str, ...]:
    """Return the recommended theories of headings [rad], each once."""
    highest = np.sqrt(2 * np.pi * GRAVITY / (SHORTEST_WAVE * length))
    chosen = recommended(length, speed, wave_directions, np.array([highest]), quick)
    return tuple(dict.fromkeys(chosen))


class Choices(NamedTuple):
    """Choices of the method.

    Parameters
    ----------
    first : settings to begin with; refinement : those that refine by the panel method, where it is
        recommended, else None; within : the choices within every theory.
    """

    first: TheorySettings
    refinement: RecommendedSettings | None
    within: RecommendedSettings


def choices_of(
    inputs: Mapping[str, Any], number: Callable[[str], float], hull: Hull, speed: float
) -> Choices:
    """Return the choices of the method.

    What the page does not offer for a design, or hides as it does not act, has its usual value.

    Parameters
    ----------
    number : gives the number typed into a control; speed : [m/s].
    """
    theory = str(inputs.get("theory", "recommended"))
    interaction = inputs.get("interaction", "auto")
    by_panels = PotentialFlowSettings(interaction=interaction)
    acts = panel_method_acts(theory, hull.length, speed)
    if acts:
        by_panels = _panel_settings(inputs, number, interaction)
    strip, high_speed = StripSettings(interaction=interaction), HighSpeedSettings(interaction=interaction)
    within = RecommendedSettings(strip=strip, high_speed=high_speed, potential_flow=by_panels)
    if theory != "recommended":
        return Choices(within.of(theory), None, within)
    quick = RecommendedSettings(quick=True, strip=strip, high_speed=high_speed)
    return Choices(quick, within if acts else None, within)


def _panel_settings(
    inputs: Mapping[str, Any], number: Callable[[str], float], interaction: str
) -> PotentialFlowSettings:
    """Return the choices within the panel method."""
    usual = METHOD_DEFAULTS
    panels = number("panels") if "panels" in inputs else usual["panels"]
    checked_number("panels", panels, at_least=FEWEST_PANELS, at_most=MOST_PANELS)
    if panels != int(panels):
        raise InputError(f"panels must be a whole number, got {panels:g}; round it.")
    damping = number("tunnel_damping") if "tunnel_damping" in inputs else usual["tunnel_damping"]
    return PotentialFlowSettings(
        panels=int(panels),
        interaction=interaction,
        tunnel_damping=damping,
        wave_field=inputs.get("wave_field", usual["wave_field"]),
    )


def theory_words(theories: tuple[str, ...]) -> str:
    """Return what a picture was computed by, with the article of a sentence."""
    return " and ".join(IN_A_SENTENCE[name] for name in theories)


def method_notes(inputs: Mapping[str, Any], design: Design, speed: float, direction: float) -> dict[str, str]:
    """Small words under the controls: what the automatic choices come to at this speed [m/s] and heading [rad]."""
    hull, theory = design.hull, str(inputs.get("theory", "recommended"))
    froude = froude_number(speed, hull.length)
    notes = {"panels": "Twice as many take some four times as long."}
    if theory == "recommended":
        chosen = recommended_theories(hull.length, speed, (direction,))
        notes["theory"] = f"At this speed and heading (Fn {froude:.2f}): {theory_words(chosen)}" + (
            "; strip theory first, refined when asked." if "potential-flow" in chosen else "."
        )
    else:
        chosen = (theory,)
        notes["theory"] = {
            "strip": "Quick; a rough guide above Fn 0.35.",
            "high-speed": "For Fn above 0.25 and waves that the ship does not overtake.",
            "potential-flow": "Up to a minute for a new hull; a rough guide above Fn 0.2.",
        }[theory]
    if hull.count == 1:
        return notes
    if inputs.get("interaction", "auto") == "auto":
        notes["interaction"] = _interaction_words(chosen, hull, speed)
    by_panels = PotentialFlowSettings(
        interaction=inputs.get("interaction", "auto"), wave_field=inputs.get("wave_field", "auto")
    )
    together = by_panels.interacts(hull.count, speed, hull.length)
    if by_panels.wave_field == "auto":
        total = speed == 0 and together
        notes["wave_field"] = (
            "With the ship's own waves, at rest." if total else "Incident wave only, at speed."
        )
    notes["tunnel_damping"] = (
        "0.02 to 0.05 tames the resonance of the water between the hulls." if together
        else "Acts only where the hulls are solved together."
    )  # fmt: skip
    return notes


def _interaction_words(theories: tuple[str, ...], hull: Hull, speed: float) -> str:
    """Return what automatic interaction comes to, by the first theory."""
    if theories[0] == "high-speed":
        return "Each hull alone up to where the waves of the other reach it, together behind."
    chosen = StripSettings() if theories[0] == "strip" else PotentialFlowSettings()
    if chosen.interacts(hull.count, speed, hull.length):
        return "Solved together at this speed (below Fn 0.2)."
    return "Each hull alone at this speed (from Fn 0.2)."
