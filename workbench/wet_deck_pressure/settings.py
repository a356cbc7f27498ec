"""How the pressure over the deck is computed.

.. [Pabst1930] W. Pabst, "Theorie des Landestosses von Seeflugzeugen", Zeitschrift fuer Flugtechnik und
    Motorluftschiffahrt 21, 1930.
"""

from dataclasses import dataclass

from workbench.errors import checked_choice, checked_number
from workbench.wet_deck_pressure.deck_motion import FRAMES
from workbench.wet_deck_pressure.strips import DIRECTIONS

REDUCTIONS = ("none", "pabst")
PRESSURES = ("wagner", "logvinovich")
ATMOSPHERE = 101325.0
"""Largest suction that water bears without cavities [Pa]."""


@dataclass(frozen=True, kw_only=True)
class DeckPressureSettings:
    """Settings of the pressure over a wet deck.

    Parameters
    ----------
    direction : of the strips, "lengthwise", "across" or "auto" (across for decks with a pod or centre bow).
    frame : "material" (closing velocity of deck and water particle) or "time-derivative" (of the gap).
    pressure : "wagner" (the outer pressure, whose impulse is that of the added mass) or "logvinovich" (less
        what Bernoulli's squared velocity takes of it, as the modified Logvinovich model has it).
    suction : largest suction that the deck bears before air gets under it [Pa]; 0 lets air in at once.
    reduction : for the finite width of the deck, "none" (the hulls beside it keep the flow in its plane) or
        "pabst" (the added mass of a rectangular plate in open water, [Pabst1930]_).
    time_step : over which pressures are averaged [s]; None takes a fifth of the record's.
    gap : dry time up to which two contacts are one slam [s]; None takes a quarter of the peak period.
    """

    direction: str = "auto"
    frame: str = "material"
    pressure: str = "wagner"
    suction: float = 0.0
    reduction: str = "none"
    time_step: float | None = None
    gap: float | None = None

    def __post_init__(self):
        checked_choice("direction of the strips", self.direction, DIRECTIONS)
        checked_choice("frame of the closing velocity", self.frame, FRAMES)
        checked_choice("pressure model", self.pressure, PRESSURES)
        checked_choice("reduction for the width of the deck", self.reduction, REDUCTIONS)
        checked_number(
            "suction", self.suction, "Pa", at_least=0, at_most=ATMOSPHERE, cure="the atmosphere bears no more"
        )
        if self.time_step is not None:
            checked_number("time step of the pressures", self.time_step, "s", above=0, at_most=1)
        if self.gap is not None:
            checked_number("dry time between two slams", self.gap, "s", at_least=0)
