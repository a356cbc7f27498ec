"""How the pressure over the wet deck is computed, as the page offers it."""

from collections.abc import Callable, Mapping
from typing import Any

from workbench.app.control import Input, number_input
from workbench.design import Design
from workbench.errors import checked_number
from workbench.wet_deck_pressure.settings import ATMOSPHERE, DeckPressureSettings

DECK_PRESSURE_DEFAULTS: dict[str, Any] = {
    "deck_strips": "auto", "deck_model": "wagner", "deck_suction": "none", "deck_reduction": "none",
    "averaging": "auto", "averaging_time": 10.0,
}  # fmt: skip
SHORTEST_MS, LONGEST_MS = 2.0, 50.0
"""Averaging times that the page takes [ms]; shorter ones cost too long for an hour of slams."""

_SUCTION = {"none": 0.0, "atmosphere": ATMOSPHERE}


def deck_pressure_inputs(design: Design) -> list[Input]:
    """Return the controls; none for a design without wet deck."""
    if design.wet_deck is None:
        return []
    return [
        Input(
            name="deck_strips", label="Strips of the deck", group="pressure", kind="choice",
            choices=(
                ("auto", "automatic: across under a pod"), ("lengthwise", "lengthwise"), ("across", "across"),
            ),
            phrases=("direction of the strips",),
        ),
        Input(
            name="deck_model", label="Pressure over the wetted part", group="pressure", kind="choice",
            choices=(("wagner", "Wagner"), ("logvinovich", "Logvinovich: less the squared velocity")),
        ),
        Input(
            name="deck_suction", label="Suction as water leaves", group="pressure", kind="choice",
            choices=(("none", "none: air gets under the deck"), ("atmosphere", "down to a vacuum")),
        ),
        Input(
            name="deck_reduction", label="Allowance for the deck's width", group="pressure", kind="choice",
            choices=(("none", "none: hulls hold the flow"), ("pabst", "plate in open water (Pabst)")),
        ),
        Input(
            name="averaging", label="Pressures averaged over", group="pressure", kind="choice",
            choices=(("auto", "a fifth of the record's step"), ("value", "a time as given below")),
        ),
        number_input(
            "averaging_time", "Averaging time [ms]", "pressure", SHORTEST_MS, LONGEST_MS, step=1.0,
            phrases=("averaging time",), shown_if=(("averaging", ("value",)),),
        ),
    ]  # fmt: skip


def deck_pressure_settings(inputs: Mapping[str, Any], number: Callable[[str], float]) -> DeckPressureSettings:
    """Return the settings; what is not given has its usual value.

    Parameters
    ----------
    number : gives the number typed into a control.
    """
    given = DECK_PRESSURE_DEFAULTS | {name: inputs[name] for name in DECK_PRESSURE_DEFAULTS if name in inputs}
    step = None
    if given["averaging"] == "value":
        step = 1e-3 * checked_number(
            "averaging time", number("averaging_time"), "ms", at_least=SHORTEST_MS, at_most=LONGEST_MS
        )
    return DeckPressureSettings(
        direction=given["deck_strips"],
        pressure=given["deck_model"],
        suction=_SUCTION.get(given["deck_suction"], 0.0),
        reduction=given["deck_reduction"],
        time_step=step,
    )


def deck_pressure_notes() -> dict[str, str]:
    """Small words under the controls."""
    return {
        "averaging": "As a gauge or a plate would feel it: short peaks are higher the shorter the time.",
        "averaging_time": "Half the time takes twice as long.",
        "deck_suction": "Acts on the force as the deck leaves the water.",
    }
