"""The choices of the potential-flow method that the page offers."""

from collections.abc import Callable, Mapping
from typing import Any

from workbench.app.control import Input, number_input
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.hydrodynamics.settings import PotentialFlowSettings

METHOD_DEFAULTS: dict[str, Any] = {
    "interaction": "auto", "wave_field": "auto", "tunnel_damping": 0.0, "panels": 1000,
}  # fmt: skip
FEWEST_PANELS, MOST_PANELS = 200, 4000


def method_inputs(design: Design) -> list[Input]:
    """Return the controls of the method; those between hulls only where there are several."""
    together = [
        Input(
            name="interaction", label="Hull interaction", group="method", kind="choice",
            choices=(
                ("auto", "automatic, by the speed"), ("on", "solved together"), ("off", "each hull alone"),
            ),
        ),
        Input(
            name="wave_field", label="Water under the deck", group="method", kind="choice",
            choices=(("auto", "automatic, by the speed"), ("incident", "incident wave only")),
            phrases=("wave field", "wave_field"),
        ),
        number_input(
            "tunnel_damping", "Damping between the hulls [-]", "method", 0, 0.2, step=0.005,
            phrases=("tunnel_damping", "tunnel damping"),
        ),
    ]  # fmt: skip
    panels = number_input(
        "panels", "Panels of the ship [-]", "method", FEWEST_PANELS, MOST_PANELS, step=50,
        phrases=("panels",),
    )  # fmt: skip
    if design.hull.count == 1:
        return [panels]
    return [*(one for one in together if one.name != "wave_field" or design.wet_deck is not None), panels]


def settings_of(inputs: Mapping[str, Any], number: Callable[[str], float]) -> PotentialFlowSettings:
    """Return the settings; what the page does not offer for a design has its usual value.

    Parameters
    ----------
    number : gives the number typed into a control.
    """
    usual = METHOD_DEFAULTS
    panels = number("panels") if "panels" in inputs else usual["panels"]
    checked_number("panels", panels, at_least=FEWEST_PANELS, at_most=MOST_PANELS)
    if panels != int(panels):
        raise InputError(f"panels must be a whole number, got {panels:g}; round it.")
    damping = number("tunnel_damping") if "tunnel_damping" in inputs else usual["tunnel_damping"]
    return PotentialFlowSettings(
        panels=int(panels),
        interaction=inputs.get("interaction", usual["interaction"]),
        tunnel_damping=damping,
        wave_field=inputs.get("wave_field", usual["wave_field"]),
    )


def method_notes(settings: PotentialFlowSettings, design: Design, speed: float) -> dict[str, str]:
    """Small words under the controls: what the automatic choices come to at this speed [m/s]."""
    hull = design.hull
    notes = {"panels": "Twice as many take some four times as long."}
    if hull.count == 1:
        return notes
    together = settings.interacts(hull.count, speed, hull.length)
    if settings.interaction == "auto":
        notes["interaction"] = (
            "Solved together at this speed (below Fn 0.2)." if together
            else "Each hull alone at this speed (from Fn 0.2)."
        )  # fmt: skip
    if settings.wave_field == "auto":
        total = speed == 0 and together
        notes["wave_field"] = (
            "With the ship's own waves, at rest." if total else "Incident wave only, at speed."
        )
    notes["tunnel_damping"] = (
        "0.02 to 0.05 tames the resonance of the water between the hulls." if together
        else "Acts only where the hulls are solved together."
    )  # fmt: skip
    return notes
