"""Attitude at speed, and the wind on the sails, as the page offers them."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from workbench.app.control import Input, number_input
from workbench.conventions import KNOT
from workbench.damping.sail_damping import SailDampingSettings
from workbench.design import Design
from workbench.errors import checked_number
from workbench.running_state import RunningState
from workbench.sails import TrueWind

RUNNING_DEFAULTS: dict[str, Any] = {
    "running_trim_degrees": 0.0, "running_sinkage": 0.0, "sail_damping": "off", "wind_knots": 15.0,
}  # fmt: skip
LARGEST_TRIM_DEGREES, STRONGEST_WIND_KNOTS = 10.0, 100.0


def running_inputs(design: Design) -> list[Input]:
    """Return the controls of the attitude at speed and, for a ship with sails, of the wind."""
    draught = design.hull.shape.draught
    found = [
        number_input(
            "running_trim_degrees", "Running trim, bow down [deg]", "running", -3, 3, step=0.05,
            phrases=("running trim",),
        ),
        number_input(
            "running_sinkage", "Running sinkage [m]", "running", -0.3 * draught, 0.3 * draught,
            phrases=("running sinkage",),
        ),
    ]  # fmt: skip
    if design.sail_plan is None:
        return found
    return [
        *found,
        Input(
            name="sail_damping", label="Damping by the sails", group="sails", kind="choice",
            choices=(("off", "left out"), ("on", "close-hauled in the true wind")),
        ),
        number_input(
            "wind_knots", "True wind speed [kn]", "sails", 0, 40, step=0.5,
            phrases=("true wind", "wind speed", "sail damping", "sail plan"),
            shown_if=(("sail_damping", ("on",)),),
        ),
    ]  # fmt: skip


def running_state_of(
    inputs: Mapping[str, Any], number: Callable[[str], float], design: Design
) -> RunningState:
    """Return the running state; what the page does not offer for a design is off.

    Parameters
    ----------
    number : gives the number typed into a control.
    """
    trim = checked_number(
        "running trim", _given(inputs, number, "running_trim_degrees"), "degrees",
        at_least=-LARGEST_TRIM_DEGREES, at_most=LARGEST_TRIM_DEGREES,
    )  # fmt: skip
    sinkage = checked_number(
        "running sinkage", _given(inputs, number, "running_sinkage"), "m", at_least=-20, at_most=20
    )
    if design.sail_plan is None or inputs.get("sail_damping", "off") != "on":
        return RunningState(running_trim=float(np.radians(trim)), running_sinkage=sinkage)
    wind = checked_number(
        "true wind speed", _given(inputs, number, "wind_knots"), "kn", at_least=0,
        at_most=STRONGEST_WIND_KNOTS,
    )  # fmt: skip
    return RunningState(
        running_trim=float(np.radians(trim)),
        running_sinkage=sinkage,
        wind=TrueWind(speed=wind * KNOT),
        sails=SailDampingSettings(),
    )


def _given(inputs: Mapping[str, Any], number: Callable[[str], float], name: str) -> float:
    """Return a typed number, or the usual one where the page has no such control."""
    return number(name) if name in inputs else RUNNING_DEFAULTS[name]


def running_notes(design: Design) -> dict[str, str]:
    """Small words under the controls."""
    notes = {
        "running_sinkage": "Of the centre of gravity, beyond that at rest; the clearance of the wet deck stays "
        "as given.",
    }
    if design.sail_plan is not None:
        notes["wind_knots"] = "The wind blows where the waves go."
    return notes
