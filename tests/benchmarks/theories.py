"""Strip and high-speed theory on the Delft 372: what they cost, and how it grows with frequencies."""

import statistics
import time

import numpy as np

from workbench.conventions import GRAVITY
from workbench.hulls import library
from workbench.hydrodynamics import high_speed, strip_theory

HEADINGS = np.radians(np.linspace(90, 180, 7))


def _median(action, runs: int = 5) -> float:
    action()
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def theories() -> list[tuple[str, str, str]]:
    """Forty frequencies at one speed: seven headings by strips, head seas by the march from the bow."""
    design = library.design("delft-372")
    speed = 0.5 * np.sqrt(GRAVITY * design.hull.length)

    def strips():
        return strip_theory.hydrodynamics(
            design.hull, design.density, np.linspace(2, 8, 40), HEADINGS, 0.6 * speed
        )

    def march(count: int, headings=(np.pi,)):
        return high_speed.hydrodynamics(
            design.hull, design.density, np.linspace(2, 8, count), headings, speed
        )

    few, usual, many = (_median(lambda count=count: march(count)) for count in (10, 40, 160))
    start = time.perf_counter()
    for omega in np.linspace(2, 8, 40)[::8]:
        high_speed.hydrodynamics(design.hull, design.density, [omega], [np.pi], speed)
    one_by_one = 8 * (time.perf_counter() - start)
    return [
        ("strip theory, 40 frequencies x 7 headings", f"{_median(strips):.2f} s", "at most 1 s"),
        ("high-speed theory, 40 frequencies, head seas", f"{usual:.2f} s", "at most 2 s"),
        (
            "high-speed theory, 10 / 40 / 160 frequencies",
            f"{few:.2f} / {usual:.2f} / {many:.2f} s",
            "less than in proportion",
        ),
        (
            "a march for each frequency (five of them, times eight) / one march",
            f"{one_by_one / usual:.0f}",
            "",
        ),
        (
            "high-speed theory, 40 frequencies x 7 headings",
            f"{_median(lambda: march(40, HEADINGS), 3):.2f} s",
            "",
        ),
    ]
