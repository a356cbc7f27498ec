"""A case: a design in a condition, judged by a criterion; and what each of its results depends on."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass

from workbench.design import Design
from workbench.hydrodynamics.recommended import RecommendedSettings, TheorySettings
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.impact.pressure import PressureLaw
from workbench.running_state import RunningState
from workbench.seas import Condition
from workbench.time_domain import Realisation
from workbench.wet_deck_pressure.settings import DeckPressureSettings

LONGEST_COUNT = 3.0
"""Hours counted at most [h]; longer ones count for the extremes alone."""

LONGEST_PRESSURES = 1.0
"""Hours at most in which the pressure over the deck is computed [h]: an hour of slams takes some 12 s."""

HEADING_STEP = math.radians(15.0)
"""Step of the usual headings [rad]."""


@dataclass(frozen=True, kw_only=True)
class Case:
    """Everything a result depends on.

    ``settings`` are those to begin with, ``refinement`` those that refine by the panel method (None where it
    is not recommended), ``within`` the choices within every theory, ``deck_pressure`` those of the pressure over
    the deck.
    """

    design: Design
    condition: Condition
    threshold: str | float
    law: PressureLaw
    hours: float
    criterion_per_hour: float
    seed: int
    settings: TheorySettings
    within: RecommendedSettings
    running_state: RunningState
    deck_pressure: DeckPressureSettings
    refinement: RecommendedSettings | None = None
    is_refined: bool = False

    @property
    def realisation(self) -> Realisation:
        """The realisation in which slams are counted."""
        return Realisation(seed=self.seed, hours=min(self.hours, LONGEST_COUNT))

    @property
    def pressure_realisation(self) -> Realisation:
        """The beginning of that realisation in which the pressure over the deck is computed."""
        return Realisation(seed=self.seed, hours=min(self.hours, LONGEST_PRESSURES))

    @property
    def deck_pressure_key(self) -> tuple:
        """What the pressure over the deck depends on."""
        real = self.pressure_realisation
        return (
            self.plan_key,
            self.design.wet_deck,
            self.condition,
            (real.hours, real.seed),
            self.deck_pressure,
        )

    @property
    def scene_key(self) -> tuple:
        """What the animation depends on."""
        return self.counting_key, self.deck_pressure

    @property
    def response_key(self) -> tuple:
        """What hydrodynamics and motions depend on."""
        design = self.design
        return (
            design.hull, design.masses, design.density, design.sail_plan, design.appendages,
            self.condition.speed, self.theory, self.running_state,
        )  # fmt: skip

    @property
    def theory(self) -> TheorySettings:
        """The settings of the theory that is to answer."""
        return self.refinement if self.is_refined and self.refinement else self.settings

    @property
    def unrefined(self) -> Case:
        """The same as it was first answered."""
        return dataclasses.replace(self, is_refined=False)

    @property
    def lone_heading(self) -> float | None:
        """The one heading [rad] that the answer needs, where others cost more; None where it needs all."""
        has_all = isinstance(self.theory, PotentialFlowSettings) or self.is_refined
        return None if has_all or self.condition.speed == 0 else self.heading

    @property
    def heading(self) -> float | None:
        """The heading [rad] of a long-crested sea; None of one that spreads."""
        condition = self.condition
        return condition.wave_direction if condition.sea_state.spreading_exponent is None else None

    @property
    def odd_heading(self) -> float | None:
        """The heading [rad] of a long-crested sea that is not among the usual ones; None where it is."""
        heading = self.heading
        if heading is None or abs(math.remainder(heading, HEADING_STEP)) < 1e-9:
            return None
        return heading

    @property
    def comparison_key(self) -> tuple:
        """What a comparison of the theories depends on."""
        design = self.design
        return (
            design.hull, design.masses, design.density, design.sail_plan, design.appendages,
            self.condition.speed, self.condition.wave_direction, self.within, self.running_state,
        )  # fmt: skip

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
