"""A case: a design in a condition, judged by a criterion; and what each of its results depends on."""

from dataclasses import dataclass

from workbench.design import Design
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.impact.pressure import PressureLaw
from workbench.seas import Condition
from workbench.time_domain import Realisation

LONGEST_COUNT = 3.0
"""Hours counted at most [h]; longer ones count for the extremes alone."""


@dataclass(frozen=True, kw_only=True)
class Case:
    """Everything a result depends on."""

    design: Design
    condition: Condition
    threshold: str | float
    law: PressureLaw
    hours: float
    criterion_per_hour: float
    seed: int
    settings: PotentialFlowSettings

    @property
    def realisation(self) -> Realisation:
        """The realisation in which slams are counted."""
        return Realisation(seed=self.seed, hours=min(self.hours, LONGEST_COUNT))

    @property
    def response_key(self) -> tuple:
        """What hydrodynamics and motions depend on."""
        design = self.design
        return design.hull, design.masses, design.density, self.condition.speed, self.settings

    @property
    def plan_key(self) -> tuple:
        """What the relative motion over the deck depends on."""
        deck = self.design.wet_deck
        return self.response_key, deck and (deck.aft, deck.fore, deck.width)

    @property
    def slamming_key(self) -> tuple:
        """What the closed-form statistics depend on."""
        return self.counting_key[:-1], self.hours, self.criterion_per_hour

    @property
    def counting_key(self) -> tuple:
        """What the counted slams depend on."""
        return (
            self.response_key, self.design.wet_deck, self.condition, self.threshold, self.law,
            (self.hours, self.seed),
        )  # fmt: skip
