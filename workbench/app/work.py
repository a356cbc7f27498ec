"""The work of a page: what the desk has done, here or in a job. Imports what is heavy only when it is done."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable
from multiprocessing import get_context
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from workbench.app.case import Case
from workbench.app.job import Progress, Work
from workbench.app.model import Counted, DeckSlams, Findings, Model
from workbench.errors import InputError
from workbench.impact.entry_case import EntryCase
from workbench.time_domain import Realisation

if TYPE_CHECKING:
    from workbench.pressure_stage import RealisedDeck

WORKERS = 2
FIRST_PRESSURES = 0.2
"""Hours of slams over the deck that are shown while the rest is computed [h]."""
CURVE_POINTS = 81
POLL = 0.1
"""Pause between two looks at a process [s]."""


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


def entry_by(case: EntryCase, method: str) -> Work:
    """Work that gives a water entry by a slow theory, or the sentence why it is refused.

    A process of its own marches it, and ends when the work is no longer wanted.
    """

    def task(progress: Progress) -> xr.Dataset | str:
        context = get_context("forkserver")
        ours, theirs = context.Pipe(duplex=False)
        process = context.Process(target=_entry, args=(theirs, case, method), daemon=True)
        process.start()
        theirs.close()
        start = time.monotonic()
        try:
            while not ours.poll(POLL):
                progress(0.0, f"{time.monotonic() - start:.0f} s so far, up to a minute")
            return ours.recv()
        except EOFError:
            return "The calculation ended without an answer; choose a smaller penetration or another theory."
        finally:
            process.terminate()
            process.join()
            ours.close()

    return task


def _entry(answer: Connection, case: EntryCase, method: str) -> None:
    """Send an entry, or the sentence why it is refused."""
    try:
        found: xr.Dataset | str = case.by(method)
    except InputError as error:
        found = str(error)
    answer.send(found)


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


def deck_slams(model: Model, found: Findings, case: Case, post: Callable[[], None]) -> Work:
    """Work that gives the model the pressure over the deck in every slam: of a first part early, then of all."""

    def task(progress: Progress) -> None:
        from workbench.pressure_stage import slam_pressures

        whole = case.pressure_realisation
        first = dataclasses.replace(whole, hours=min(whole.hours, FIRST_PRESSURES))
        ahead = first.hours < whole.hours / 2
        done = 0.0
        for realisation in (first, whole) if ahead else (whole,):
            share = realisation.hours / (whole.hours + first.hours if ahead else whole.hours)
            realised = _realised_deck(found, case, realisation)
            slams = slam_pressures(
                realised,
                lambda part, _, at=done, share=share: progress(
                    at + share * part, f"slams of {whole.hours:g} h"
                ),
            )
            is_whole = realisation == whole
            model.deck_slams = DeckSlams(case.deck_pressure_key, found, realised, slams, is_whole)
            done += share
            post()

    return task


def _realised_deck(found: Findings, case: Case, realisation: Realisation) -> RealisedDeck:
    """Water against the deck of a case in a realisation of its sea."""
    from workbench.pressure_stage import RealisedDeck

    deck, settings = case.design.wet_deck, case.deck_pressure
    return RealisedDeck(found.ship, found.relative, found.slam, deck, realisation, settings)
