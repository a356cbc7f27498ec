"""A piece of long work beside the page: progress, cancel, and the newest request wins."""

import threading
import time
from collections.abc import Callable, Hashable
from typing import Any

import traitlets

UPDATES_PER_SECOND = 5.0

Progress = Callable[[float, str], None]
Work = Callable[[Progress], Any]


class Cancelled(Exception):  # noqa: N818
    """Raised inside the work when it is no longer wanted."""


class Job(traitlets.HasTraits):
    """One worker thread; each request replaces the one before.

    The work is called with a function of progress (fraction, message) that raises
    `Cancelled` when the work is no longer wanted. Traits are set from the worker thread.

    Attributes
    ----------
    state : 'idle', 'running', 'finished', 'failed' or 'cancelled'.
    progress : 0 to 1; message : what is being done, with the time left once it is known.
    error : one sentence when failed; ``failure`` is the exception.
    """

    state = traitlets.Enum(("idle", "running", "finished", "failed", "cancelled"), "idle")
    progress = traitlets.Float(0.0)
    message = traitlets.Unicode("")
    error = traitlets.Unicode("")

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name
        self.key: Hashable = None
        self.failure: Exception | None = None
        self._condition = threading.Condition()
        self._waiting: tuple[int, Hashable, Work, Callable[[Any], None], float] | None = None
        self._newest = 0
        self._thread: threading.Thread | None = None

    def start(self, key: Hashable, work: Work, done: Callable[[Any], None], delay: float = 0.0) -> None:
        """Ask for work, unless the same (by its key) is being done already.

        Parameters
        ----------
        key : of the result; work : called in the worker thread.
        done : called there with the result, if it is still wanted.
        delay : wait for a newer request before starting [s].
        """
        with self._condition:
            if self.state == "running" and key == self.key:
                return
            self._newest += 1
            self.key = key
            self._waiting = (self._newest, key, work, done, delay)
            if self._thread is None or not self._thread.is_alive():
                self._thread = threading.Thread(target=self._run, name=f"{self.name} job", daemon=True)
                self._thread.start()
            self._condition.notify_all()
        self.error = ""
        self.progress = 0.0
        self.message = ""
        self.state = "running"

    def cancel(self) -> None:
        """Stop the present work at its next report of progress; without one, do nothing."""
        with self._condition:
            if self.state != "running":
                return
            self._newest += 1
            self._waiting = None
            self._condition.notify_all()
        self.state = "cancelled"
        self.message = ""

    def clear(self) -> None:
        """Forget a failure or a cancellation."""
        if self.state != "running":
            self.error = self.message = ""
            self.failure = None
            self.state = "idle"

    def _is_wanted(self, number: int) -> bool:
        return number == self._newest

    def _run(self) -> None:
        while True:
            with self._condition:
                while self._waiting is None:
                    self._condition.wait()
                number, _, work, done, delay = self._waiting
                self._waiting = None
                if delay > 0:
                    self._condition.wait_for(lambda number=number: not self._is_wanted(number), timeout=delay)
                if not self._is_wanted(number):
                    continue
            self._do(number, work, done)

    def _do(self, number: int, work: Work, done: Callable[[Any], None]) -> None:
        started = reported = time.monotonic()

        def progress(fraction: float, message: str = "") -> None:
            nonlocal reported
            if not self._is_wanted(number):
                raise Cancelled
            now = time.monotonic()
            if now - reported < 1 / UPDATES_PER_SECOND and fraction < 1:
                return
            reported = now
            self.progress = min(max(float(fraction), 0.0), 1.0)
            self.message = message + _time_left(fraction, now - started)

        try:
            result = work(progress)
            if not self._is_wanted(number):
                return
            done(result)
        except Cancelled:
            return
        except Exception as error:
            if self._is_wanted(number):
                self.failure = error
                self.error = str(error) or type(error).__name__
                self.state = "failed"
            return
        if self._is_wanted(number):
            self.progress = 1.0
            self.message = ""
            self.state = "finished"


def _time_left(fraction: float, elapsed: float) -> str:
    """Words for the time left, once some work is done."""
    if not 0.05 < fraction < 1 or elapsed < 1:
        return ""
    left = elapsed * (1 - fraction) / fraction
    return f", about {left:.0f} s left" if left < 90 else f", about {left / 60:.0f} min left"
