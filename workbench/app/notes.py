"""Small words under the controls: what a number means, and what an automatic choice comes to."""

import math
from collections.abc import Mapping
from typing import Any

from workbench.app.deck_pressure_inputs import deck_pressure_notes
from workbench.app.method_inputs import method_notes
from workbench.app.running_inputs import running_notes
from workbench.conventions import KNOT, froude_number
from workbench.design import Design
from workbench.errors import InputError
from workbench.verdict import heading_words


def notes_under(inputs: Mapping[str, Any], design: Design) -> dict[str, str]:
    """Return the notes by name of the control; none where the number is still being typed."""
    notes = running_notes(design)
    try:
        speed = float(inputs["speed_knots"]) * KNOT
        notes["speed_knots"] = f"Froude number {froude_number(speed, design.hull.length):.2f}"
        heading = float(inputs["heading_degrees"])
        words = heading_words(heading)
        notes["heading_degrees"] = f"{words} (180 is from ahead)"
        notes |= method_notes(inputs, design, speed, math.radians(heading))
    except (InputError, TypeError, ValueError):
        pass
    if design.wet_deck is not None:
        notes |= deck_pressure_notes()
        notes["sinkage"] = "The clearance of the wet deck is from still water and stays as given."
    return notes
