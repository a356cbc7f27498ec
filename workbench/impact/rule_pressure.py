"""Rule pressures along the wet deck of a design."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.geometry.wet_deck import wet_deck_height
from workbench.impact.rule_formulas import LIMITING_ACCELERATION, RuleInput, rule_rows
from workbench.seas import Condition

POINTS = 41
"""Places along the deck."""


def rule_pressures(
    design: Design,
    condition: Condition,
    *,
    panel_area: float = 1.0,
    spacing: float = 0.5,
    vertical_acceleration: float | None = None,
    stiffener: bool = False,
    y: float = 0.0,
    x: np.ndarray | None = None,
) -> xr.Dataset:
    """Design pressure of each rule along the wet deck (rule, x), for orientation beside computed pressures.

    Parameters
    ----------
    design : with a wet deck; length, mass, draught and deck are used.
    condition : its speed and significant height; the heading is not asked for by any rule.
    panel_area : [m2]; spacing : of the stiffeners [m]; stiffener : whether the pressure is for one.
    vertical_acceleration : design value at the centre of gravity [m/s2]; None takes 1 g and says so.
    y : of the line along the deck whose height is the air gap [m]; x : places [m]; None takes `POINTS` over the deck.

    Returns
    -------
    Dataset over (rule, x): ``rule_pressure`` [Pa]; over rule ``rule_society``, ``rule_reference``,
    ``rule_standing``; over x ``height``. Range and assumptions are in the attribute ``warnings``.
    """
    deck = design.wet_deck
    if deck is None:
        raise InputError(
            f"design must have a wet deck, but {design.name} has none; choose a multihull with one."
        )
    y = checked_number(
        "y of the line along the deck", y, "m", at_least=-deck.width / 2, at_most=deck.width / 2
    )
    x = np.linspace(deck.aft, deck.fore, POINTS) if x is None else np.atleast_1d(np.asarray(x, float))
    gaps = wet_deck_height(deck, x, y)
    notes = []
    if vertical_acceleration is None:
        vertical_acceleration = LIMITING_ACCELERATION
        notes.append("No design vertical acceleration was given: 1 g is taken.")
    columns = [
        rule_rows(
            RuleInput(
                length=design.hull.length,
                speed=condition.speed,
                displacement=design.masses.mass,
                draught=design.hull.shape.draught + design.hull.sinkage,
                significant_wave_height=condition.sea_state.significant_wave_height,
                air_gap=float(gap),
                panel_area=panel_area,
                spacing=spacing,
                vertical_acceleration=vertical_acceleration,
                stiffener=stiffener,
            ),
            float(place / design.hull.length + 0.5),
        )
        for place, gap in zip(x, gaps, strict=True)
    ]
    rows = columns[0]
    notes += [sentence for column in columns for row in column for sentence in row.warnings]
    notes.append("Rule pressures are static design loads that go with the stresses their rules allow.")
    return quantities.dataset(
        {"rule": [row.key for row in rows], "x": x},
        method="rules of classification societies",
        warnings=notes,
        attrs={"panel_area": float(panel_area), "spacing": float(spacing), "speed": condition.speed},
        rule_pressure=(("rule", "x"), np.array([[row.pressure for row in column] for column in columns]).T),
        rule_society=("rule", [f"{row.society}, {row.rule}, {row.applicability}" for row in rows]),
        rule_reference=("rule", [row.reference for row in rows]),
        rule_standing=("rule", [row.standing for row in rows]),
        height=("x", gaps),
    )
