"""What happens after a change: read the inputs, follow with the statistics, send for what takes longer.

One thread does this, the newest state of the inputs first, so that widget
callbacks (in the main thread under Voila, in subshell threads under
JupyterLab) only set traits and return.

Where one heading is all that a sea needs, its motions come first and those of the other headings after a
pause; where the panel method is to refine, what was there before stays until it is ready.
"""

import dataclasses
import threading
from collections.abc import Callable

import numpy as np
import traitlets

from workbench.app import work
from workbench.app.case import Case
from workbench.app.job import Job
from workbench.app.model import Compared, Findings, Model
from workbench.app.reading import control_named, in_words
from workbench.errors import InputError
from workbench.impact.entry_case import EntryCase

HULL_DELAY, COUNT_DELAY, PRESSURE_DELAY, REST_DELAY = 0.35, 0.8, 1.2, 1.5
"""Pause after the last change before a new hull is solved, before slams are counted, before the pressure over the
deck is computed, and before the headings that the sea does not need [s]."""

MOST_ENTRIES = 8
"""Water entries by slow theories that are remembered."""


class Desk(traitlets.HasTraits):
    """Keeps the results of a model up to date.

    Attributes
    ----------
    hull_job : hydrodynamics and motions; rest_job : those of the other headings; count_job : counted slams and
    the scene; pressure_job : the pressure over the deck; compare_job : theories laid over each other;
    section_job : a water entry by a slow theory.
    is_current : whether the findings belong to the present inputs.
    error : a sentence on what went wrong unexpectedly.
    """

    is_current = traitlets.Bool(False)
    error = traitlets.Unicode("")

    def __init__(self, model: Model, show: Callable[[Callable[[], bool]], None]) -> None:
        super().__init__()
        self.model = model
        self.hull_job, self.rest_job, self.count_job = Job("hull"), Job("headings"), Job("count")
        self.compare_job, self.section_job = Job("theories"), Job("section")
        self.pressure_job = Job("pressure")
        self.needs_counts = self.needs_scene = self.needs_pressures = False
        self._show = show
        self._ship = None
        self._ship_key: tuple | None = None
        self._ship_is_whole = False
        self._relative = None
        self._relative_of: tuple | None = None
        self._stopped: dict[str, tuple | None] = {}
        self._condition = threading.Condition()
        self._wanted, self._done = 0, 0
        self._thread = threading.Thread(target=self._run, name="desk", daemon=True)
        self._thread.start()

    @property
    def jobs(self) -> tuple[Job, ...]:
        """All jobs, the most urgent first."""
        return (
            self.hull_job, self.compare_job, self.section_job, self.count_job, self.pressure_job, self.rest_job,
        )  # fmt: skip

    def post(self, *_: object) -> None:
        """Say that something changed; returns at once."""
        with self._condition:
            self._wanted += 1
            self._condition.notify_all()

    def stop(self) -> None:
        """Cancel the present long work and do not start it again by itself."""
        for job in self.jobs:
            if job.state == "running":
                self._stopped[job.name] = job.key
            job.cancel()
        case = self.model.case()
        if case is not None and case.is_refined and self._ship_key != case.response_key:
            self.model.leave_unrefined(case)
        self.post()

    def resume(self) -> None:
        """Start again what was stopped or has failed."""
        self._stopped = {}
        self.hull_job.key = self.rest_job.key = self.pressure_job.key = None
        self.post()

    def settle(self, timeout: float = 60.0) -> bool:
        """Wait until nothing is left to do (for tests); False if it takes longer than this [s]."""
        import time

        end = time.monotonic() + timeout
        while time.monotonic() < end:
            with self._condition:
                idle = self._wanted == self._done
            if idle and not any(job.state == "running" for job in self.jobs):
                return True
            time.sleep(0.02)
        return False

    def compare(self, with_panels: bool) -> None:
        """Lay the theories over each other for the present inputs."""
        case = self.model.case()
        if case is None:
            return
        key = case.comparison_key

        def done(found) -> None:
            self.model.compared = Compared(key, *found)
            self.post()

        task = work.comparison(case, with_panels)
        self.compare_job.start((key, with_panels), task, done)

    def solve_entry(self, case: EntryCase, method: str) -> None:
        """Ask for a water entry by a theory that takes long."""
        key = (case, method)

        def done(found) -> None:
            kept = list(self.model.solved_entries.items())[-MOST_ENTRIES + 1 :]
            self.model.solved_entries = dict([*kept, (key, found)])
            self.post()

        self.section_job.start(key, work.entry_by(case, method), done)

    def _run(self) -> None:
        while True:
            with self._condition:
                while self._wanted == self._done:
                    self._condition.wait()
                number = self._wanted
            try:
                self._work(lambda number=number: number == self._wanted)
                self.error = ""
            except Exception as error:
                self.is_current = False
                what = f"{type(error).__name__}: {error}"
                self.error = f"Something went wrong ({what}); change an input or reload the page."
            with self._condition:
                self._done = max(self._done, number)

    def _work(self, is_newest: Callable[[], bool]) -> None:
        case = self.model.case()
        if case is None:
            self.is_current = False
            self._drop_counts()
            self._show(is_newest)
            return
        answered = self._answered(case)
        if answered is not None and answered.response_key == case.response_key:
            if self.hull_job.state != "finished":
                self.hull_job.cancel()
                self.hull_job.clear()
            self._stopped.pop("hull", None)
            self._send_for_other_headings(case)
        else:
            self.rest_job.cancel()
            self.rest_job.clear()
            if self._has_failed(case):
                self._explain_failure(case)
            elif self._stopped.get("hull") != _key(case, case.lone_heading):
                self._send_for_ship(case)
        if answered is None:
            self.is_current = False
            self._drop_counts()
            self._show(is_newest)
            return
        if not self._follow(answered):
            self._show(is_newest)
            return
        self.is_current = True
        self._show(is_newest)
        if is_newest() and answered.design.wet_deck is not None:
            self._send_for_counts(answered)
            self._send_for_pressures(answered)

    def _answered(self, case: Case) -> Case | None:
        """Return the case that the present ship answers: this one, or the same before it is refined."""
        for one in (case, case.unrefined):
            if self._ship is None or one.response_key != self._ship_key:
                continue
            known = self._ship.motions.wave_direction.values
            has_heading = one.heading is None or bool(np.any(np.abs(known - one.heading) < 1e-9))
            if has_heading and (self._ship_is_whole or one.lone_heading is not None):
                return one
        return None

    def _drop_counts(self) -> None:
        """Stop counting for inputs that are no longer those of the page."""
        for job in (self.count_job, self.pressure_job):
            job.cancel()
            job.clear()

    def _has_failed(self, case: Case) -> bool:
        return self.hull_job.state == "failed" and self.hull_job.key == _key(case, case.lone_heading)

    def _explain_failure(self, case: Case) -> None:
        """Put what was refused at its control; a refused refinement is taken back."""
        if not isinstance(self.hull_job.failure, InputError):
            return
        sentence = self.hull_job.error
        if case.is_refined:
            self.model.leave_unrefined(case)
            self.model.notice = f"Not refined: {in_words(sentence)}"
            self.post()
            return
        name = control_named(sentence, self.model.base, "masses")
        running = case.running_state
        if name == "sinkage" and running.running_sinkage:
            name = "running_sinkage"
        elif name in ("trim_degrees", "sinkage") and running.running_trim:
            name = "running_trim_degrees"
        self.model.problems = {name: in_words(sentence)}

    def _send_for_ship(self, case: Case) -> None:
        """Ask for motions: of the one heading that is needed, or of all."""
        heading = case.lone_heading
        pause = HULL_DELAY if self._ship is not None and not case.is_refined else 0.0
        self._ask(self.hull_job, case, heading, pause)

    def _send_for_other_headings(self, case: Case) -> None:
        """Ask for the motions of all headings, once those of the one that is needed are there."""
        key = _key(case, None)
        if self._ship_is_whole:
            self.rest_job.cancel()
            self.rest_job.clear()
        elif self._stopped.get("headings") != key and (self.rest_job.state, self.rest_job.key) != (
            "failed", key,
        ):  # fmt: skip
            self._ask(self.rest_job, case, None, REST_DELAY)

    def _ask(self, job: Job, case: Case, heading: float | None, pause: float) -> None:
        def done(ship) -> None:
            self._ship, self._ship_key, self._ship_is_whole = ship, case.response_key, heading is None
            self.post()

        job.start(_key(case, heading), work.ship(case, heading), done, pause)

    def _follow(self, case: Case) -> bool:
        """Bring the closed-form statistics up to date; False where the inputs are refused."""
        found = self.model.findings
        if found is not None and found.ship is self._ship and found.case.slamming_key == case.slamming_key:
            if found.case != case:
                self.model.findings = dataclasses.replace(found, case=case)
            return True
        if case.design.wet_deck is not None and (self._ship, case.plan_key) != self._relative_of:
            self._relative = work.deck_response(self._ship, case)
            self._relative_of = (self._ship, case.plan_key)
        relative = self._relative if case.design.wet_deck is not None else None
        try:
            slam, curve = work.statistics(self._ship, relative, case)
        except InputError as error:
            self.is_current = False
            cure = "choose one of these, or another speed"
            sentence = str(error).replace("compute that heading first", cure)
            self.model.problems = {control_named(sentence, self.model.base, "run"): in_words(sentence)}
            return False
        self.model.findings = Findings(case, self._ship, relative, slam, curve)
        return True

    def _send_for_counts(self, case: Case) -> None:
        wants_scene = self.needs_scene and self.model.scene_key != case.scene_key
        has_counts = self.model.counted is not None and self.model.counted.key == case.counting_key
        if not wants_scene and (has_counts or not self.needs_counts):
            return
        key = (case.scene_key if wants_scene else case.counting_key, wants_scene)
        if key == self._stopped.get("count"):
            return
        self._stopped.pop("count", None)
        task = work.counts(self.model, self.model.findings, case, wants_scene, self.post)
        self.count_job.start(key, task, lambda _: self.post(), 0.0 if has_counts else COUNT_DELAY)

    def _send_for_pressures(self, case: Case) -> None:
        key, job = case.deck_pressure_key, self.pressure_job
        known = self.model.deck_slams
        has_them = known is not None and known.key == key and known.is_whole
        if job.state == "running" and job.key != key:
            job.cancel()
            job.clear()
        has_failed = (job.state, job.key) == ("failed", key)
        if has_them or has_failed or not self.needs_pressures or key == self._stopped.get("pressure"):
            return
        self._stopped.pop("pressure", None)
        task = work.deck_slams(self.model, self.model.findings, case, self.post)
        job.start(key, task, lambda _: self.post(), PRESSURE_DELAY)


def _key(case: Case, lone_heading: float | None) -> tuple:
    """Return what the motions depend on, of one heading [rad] or (None) of all."""
    return case.response_key, lone_heading, case.odd_heading
