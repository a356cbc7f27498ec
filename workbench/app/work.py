"""The work of a page: what the desk has done, here or in a job. Imports what is heavy only when it is done."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from workbench.app.case import Case
from workbench.app.job import Progress, Work
from workbench.app.model import Counted, DeckSlams, Findings, Model
from workbench.time_domain import Realisation

if TYPE_CHECKING:
    from workbench.pressure_stage import RealisedDeck

WORKERS = 2
CURVE_POINTS = 81


def ship(case: Case, lone_heading: float | None) -> Work:
    """Work that gives hydrodynamics and motions of a case, of one heading [rad] or (None) of all."""

    def task(progress: Progress):
        from workbench import pipeline, theory_stage

        speed, odd = case.condition.speed, case.odd_heading
        headings = None if lone_heading is None else [lone_heading]
        if headings is None and odd is not None:
            usual = theory_stage.directions_for(case.theory, case.design.hull.length, speed)
            headings = np.sort(np.append(usual, odd))
        return pipeline.response(
            case.design, speed, headings,
            settings=case.theory, running_state=case.running_state, workers=WORKERS, progress=progress,
        )  # fmt: skip

    return task


def comparison(case: Case, with_panels: bool) -> Work:
    """Work that gives the theories beside each other, and what was measured."""

    def task(progress: Progress):
        from workbench.theory_comparison import QUICK_THEORIES, compared
        from workbench.verification.measured_motions import measured_motions

        condition = case.condition
        measured = measured_motions(case.design, condition.speed, condition.wave_direction)
        methods = (*QUICK_THEORIES, "potential-flow") if with_panels else QUICK_THEORIES
        found = compared(
            case.design, condition.speed, condition.wave_direction, methods, measured=measured,
            settings=case.within, running_state=case.running_state, workers=WORKERS, progress=progress,
        )  # fmt: skip
        return found, measured

    return task


def deck_response(ship, case: Case) -> xr.Dataset:
    """Relative motion over the deck."""
    from workbench import pipeline

    return pipeline.deck_response(ship, case.design.wet_deck)


def statistics(ship, relative: xr.Dataset | None, case: Case) -> tuple:
    """Closed-form slamming and its curve over the clearance; None without a wet deck, where the sea is checked."""
    from workbench import pipeline, sea_energy
    from workbench.slamming.criteria import clearance_curve

    deck = case.design.wet_deck
    if deck is None:
        sea_energy.wave_energy(case.condition, ship.motions.omega, ship.motions.wave_direction)
        return None, None
    slam = pipeline.slamming(
        ship, relative, deck, case.condition, threshold=case.threshold, law=case.law, hours=case.hours,
        criterion_per_hour=case.criterion_per_hour,
    )  # fmt: skip
    reach = np.linspace(0.05, 1.25, CURVE_POINTS) * max(1.6 * deck.clearance, 1.2 * slam.least_clearance)
    return slam, clearance_curve(slam.moments, slam.deck.height, slam.clearance, reach, slam.threshold)


def counts(model: Model, found: Findings, case: Case, wants_scene: bool, post: Callable[[], None]) -> Work:
    """Work that counts the slams of a case and, where it is wanted, builds the scene; both go to the model."""

    def task(progress: Progress) -> None:
        from workbench import pipeline

        realisation = case.realisation
        progress(0.05, f"Counting slams in {realisation.hours:g} h")
        if model.counted is None or model.counted.key != case.counting_key:
            events, counted = pipeline.counted_slams(found.ship, found.relative, found.slam, realisation)
            progress(0.7, "counted")
            model.counted = Counted(case.counting_key, found, events, counted)
            post()
        if wants_scene:
            from workbench.animation import animation_scene

            progress(0.8, "Building the animation")
            scene = animation_scene(
                found.ship, found.relative, found.slam, model.counted.events, realisation,
                realised=_realised_deck(found, case, realisation),
            )  # fmt: skip
            progress(1.0, "built")
            model.scene_key = case.scene_key
            model.scene = scene

    return task


def deck_slams(found: Findings, case: Case) -> Work:
    """Work that gives the pressure over the deck in every slam of a realisation."""

    def task(progress: Progress) -> DeckSlams:
        from workbench.pressure_stage import slam_pressures

        realised = _realised_deck(found, case, case.pressure_realisation)
        hours = case.pressure_realisation.hours
        slams = slam_pressures(realised, lambda done, _: progress(done, f"slams of {hours:g} h"))
        return DeckSlams(case.deck_pressure_key, found, realised, slams)

    return task


def _realised_deck(found: Findings, case: Case, realisation: Realisation) -> RealisedDeck:
    """Water against the deck of a case in a realisation of its sea."""
    from workbench.pressure_stage import RealisedDeck

    deck, settings = case.design.wet_deck, case.deck_pressure
    return RealisedDeck(found.ship, found.relative, found.slam, deck, realisation, settings)
