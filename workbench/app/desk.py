"""What happens after a change: read the inputs, follow with the statistics, send for what takes longer.

One thread does this, the newest state of the inputs first, so that widget
callbacks (in the main thread under Voila, in subshell threads under
JupyterLab) only set traits and return.
"""

import threading
from collections.abc import Callable

import numpy as np
import traitlets

from workbench.app.case import Case
from workbench.app.job import Job
from workbench.app.model import Counted, Findings, Model
from workbench.app.reading import control_named, in_words
from workbench.errors import InputError

WORKERS = 2
HULL_DELAY, COUNT_DELAY = 0.35, 0.8
"""Pause after the last change before a new hull is solved, and before slams are counted [s]."""

CURVE_POINTS = 81


class Desk(traitlets.HasTraits):
    """Keeps the results of a model up to date.

    Attributes
    ----------
    hull_job : hydrodynamics and motions; count_job : counted slams and the scene.
    is_current : whether the findings belong to the present inputs.
    error : a sentence on what went wrong unexpectedly.
    """

    is_current = traitlets.Bool(False)
    error = traitlets.Unicode("")

    def __init__(self, model: Model, show: Callable[[Callable[[], bool]], None]) -> None:
        super().__init__()
        self.model = model
        self.hull_job, self.count_job = Job("hull"), Job("count")
        self.needs_counts = self.needs_scene = False
        self._show = show
        self._ship = None
        self._ship_key: tuple | None = None
        self._relative = None
        self._plan_key: tuple | None = None
        self._stopped_key: tuple | None = None
        self._stopped_count: tuple | None = None
        self._condition = threading.Condition()
        self._wanted, self._done = 0, 0
        self._thread = threading.Thread(target=self._run, name="desk", daemon=True)
        self._thread.start()

    def post(self, *_: object) -> None:
        """Say that something changed; returns at once."""
        with self._condition:
            self._wanted += 1
            self._condition.notify_all()

    def stop(self) -> None:
        """Cancel the present long work and do not start it again by itself."""
        if self.hull_job.state == "running":
            self._stopped_key = self.hull_job.key
        self._stopped_count = self.count_job.key
        self.hull_job.cancel()
        self.count_job.cancel()
        self.post()

    def resume(self) -> None:
        """Start again what was stopped or has failed."""
        self._stopped_key = self._stopped_count = None
        self.hull_job.key = None
        self.post()

    def settle(self, timeout: float = 60.0) -> bool:
        """Wait until nothing is left to do (for tests); False if it takes longer than this [s]."""
        import time

        end = time.monotonic() + timeout
        while time.monotonic() < end:
            with self._condition:
                idle = self._wanted == self._done
            if idle and "running" not in (self.hull_job.state, self.count_job.state):
                return True
            time.sleep(0.02)
        return False

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
        if case.response_key != self._ship_key:
            self.is_current = False
            self._drop_counts()
            if self._has_failed(case):
                self._explain_failure()
            elif case.response_key != self._stopped_key:
                self._send_for_ship(case)
            self._show(is_newest)
            return
        if self.hull_job.key != case.response_key:
            self.hull_job.cancel()
            self.hull_job.clear()
        self._stopped_key = None
        if not self._follow(case):
            self._show(is_newest)
            return
        self.is_current = True
        self._show(is_newest)
        if is_newest() and case.design.wet_deck is not None:
            self._send_for_counts(case)

    def _drop_counts(self) -> None:
        """Stop counting for inputs that are no longer those of the page."""
        self.count_job.cancel()
        self.count_job.clear()

    def _has_failed(self, case: Case) -> bool:
        return self.hull_job.state == "failed" and self.hull_job.key == case.response_key

    def _explain_failure(self) -> None:
        """Put what was refused at its control."""
        if isinstance(self.hull_job.failure, InputError):
            sentence = self.hull_job.error
            self.model.problems = {control_named(sentence, self.model.base, "masses"): in_words(sentence)}

    def _send_for_ship(self, case: Case) -> None:
        from workbench import pipeline

        def work(progress):
            return pipeline.response(
                case.design, case.condition.speed, settings=case.settings, workers=WORKERS, progress=progress
            )

        def done(ship):
            self._ship, self._ship_key = ship, case.response_key
            self.post()

        self.hull_job.start(case.response_key, work, done, HULL_DELAY if self._ship is not None else 0.0)

    def _follow(self, case: Case) -> bool:
        """Bring the closed-form statistics up to date; False where the inputs are refused."""
        from workbench import pipeline, sea_energy
        from workbench.slamming.criteria import clearance_curve

        found = self.model.findings
        if found is not None and found.ship is self._ship and found.case.slamming_key == case.slamming_key:
            return True
        deck = case.design.wet_deck
        relative = slam = curve = None
        try:
            if deck is not None:
                if case.plan_key != self._plan_key:
                    self._relative = pipeline.deck_response(self._ship, deck)
                    self._plan_key = case.plan_key
                relative = self._relative
                slam = pipeline.slamming(
                    self._ship, relative, deck, case.condition, threshold=case.threshold, law=case.law,
                    hours=case.hours, criterion_per_hour=case.criterion_per_hour,
                )  # fmt: skip
                reach = np.linspace(0.05, 1.25, CURVE_POINTS) * max(
                    1.6 * deck.clearance, 1.2 * slam.least_clearance
                )
                curve = clearance_curve(slam.moments, slam.deck.height, slam.clearance, reach, slam.threshold)
            else:
                sea_energy.wave_energy(
                    case.condition, self._ship.motions.omega, self._ship.motions.wave_direction
                )
        except InputError as error:
            self.is_current = False
            cure = "choose one of these, or another speed"
            sentence = str(error).replace("compute that heading first", cure)
            self.model.problems = {control_named(sentence, self.model.base, "run"): in_words(sentence)}
            return False
        self.model.findings = Findings(case, self._ship, relative, slam, curve)
        return True

    def _send_for_counts(self, case: Case) -> None:
        wants_scene = self.needs_scene and self.model.scene_key != case.counting_key
        has_counts = self.model.counted is not None and self.model.counted.key == case.counting_key
        if not wants_scene and (has_counts or not self.needs_counts):
            return
        found = self.model.findings

        def work(progress):
            return self._counted_work(found, case, has_counts, wants_scene, progress)

        key = (case.counting_key, wants_scene)
        if key == self._stopped_count:
            return
        self._stopped_count = None
        self.count_job.start(key, work, lambda _: self.post(), 0.0 if has_counts else COUNT_DELAY)

    def _counted_work(
        self, found: Findings, case: Case, has_counts: bool, wants_scene: bool, progress
    ) -> None:
        from workbench import pipeline

        realisation = case.realisation
        progress(0.05, f"Counting slams in {realisation.hours:g} h")
        if not has_counts:
            events, counts = pipeline.counted_slams(found.ship, found.relative, found.slam, realisation)
            progress(0.7, "counted")
            self.model.counted = Counted(case.counting_key, found, events, counts)
            self.post()
        if wants_scene:
            from workbench.animation import animation_scene

            progress(0.8, "Building the animation")
            scene = animation_scene(
                found.ship, found.relative, found.slam, self.model.counted.events, realisation
            )
            progress(1.0, "built")
            self.model.scene_key = case.counting_key
            self.model.scene = scene
