"""What the head of the page says about long work and about the theory behind the results."""

from typing import NamedTuple

from workbench.app.case import Case
from workbench.app.desk import Desk
from workbench.app.job import Job
from workbench.app.method_inputs import theory_words
from workbench.app.model import Findings
from workbench.app.theory_in_use import theories_of
from workbench.errors import InputError

_WORDS = {
    "hull": "Solving the waves about the hull",
    "theories": "Comparing theories",
    "section": "Marching the water entry",
    "count": "Counting slams",
    "pressure": "Pressure over the deck",
    "headings": "Solving the other headings",
}
_STOPPED = {
    "hull": "Stopped. The results below belong to former inputs.",
    "theories": "",
    "section": "",
    "count": "Stopped. The slams were not counted for these inputs.",
    "pressure": "Stopped. The pressure over the deck was not computed for these inputs.",
    "headings": "Stopped. The other headings were not solved.",
}


class Work(NamedTuple):
    """State of the long work: what the head shows of it."""

    busy: bool
    progress: float
    task: str
    action: str


def state_of(desk: Desk) -> Work:
    """Return what the head says about the jobs of a desk."""
    busy = next((job for job in desk.jobs if job.state == "running"), None)
    if busy is not None:
        return Work(True, busy.progress, _task(busy), "stop")
    failed = next((job for job in desk.jobs if job.state == "failed"), None)
    by_hand = desk.compare_job, desk.section_job
    if failed is not None and (failed in by_hand or not isinstance(failed.failure, InputError)):
        return Work(False, 0.0, failed.error, "" if failed in by_hand else "resume")
    stopped = next((job for job in desk.jobs if job.state == "cancelled" and _STOPPED[job.name]), None)
    if stopped is not None:
        return Work(False, 0.0, _STOPPED[stopped.name], "resume")
    return Work(False, 0.0, "", "")


def _task(job: Job) -> str:
    if job.name == "count" and job.message:
        return job.message
    return f"{_WORDS[job.name]}: {job.message}" if job.message else f"{_WORDS[job.name]} …"


def origin_of(found: Findings | None, wanted: Case | None) -> str:
    """Return by which theory the findings were computed, and what could refine them."""
    if found is None:
        return ""
    words = f"by {theory_words(theories_of(found.case))}"
    if may_refine(found, wanted):
        words += "; at this speed the panel method is recommended"
    return words


def may_refine(found: Findings | None, wanted: Case | None) -> bool:
    """Whether the panel method would refine the findings and has not been asked for."""
    return (
        found is not None and wanted is not None and wanted.refinement is not None
        and not found.case.is_refined and not wanted.is_refined
    )  # fmt: skip


def is_awaited(found: Findings | None, wanted: Case | None) -> bool:
    """Whether the panel method was asked for and has not answered yet."""
    return found is not None and wanted is not None and wanted.is_refined and not found.case.is_refined
