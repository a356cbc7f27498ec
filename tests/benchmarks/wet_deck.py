"""One hour of pressure over a deck of 400 panels, one slam, and Wagner's condition against a root finder row by row."""

import time

import numpy as np
from scipy.optimize import fsolve

from workbench import pipeline, pressure_stage
from workbench.hulls import library
from workbench.seas import Condition, SeaState
from workbench.time_domain import Realisation
from workbench.wet_deck_pressure.strip_profiles import StripProfiles
from workbench.wet_deck_pressure.wetted_interval import COSINES, wetted_intervals

SPEED = 15.4333
ROWS = 2000


def hour() -> list[tuple[str, str, str]]:
    """The 76 m catamaran at 30 knots in head seas of 3 m: every slam of an hour, then the hardest one alone."""
    design = library.design("austal-63")
    ship = pipeline.response(design, SPEED, [np.pi])
    relative = pipeline.deck_response(ship, design.wet_deck, (40, 10))
    sea = SeaState(significant_wave_height=3.0, peak_period=8.0)
    condition = Condition(speed=SPEED, wave_direction=np.pi, sea_state=sea)
    slam = pipeline.slamming(ship, relative, design.wet_deck, condition)
    start = time.perf_counter()
    realised = pressure_stage.RealisedDeck(ship, relative, slam, design.wet_deck, Realisation())
    slams = pressure_stage.slam_pressures(realised)
    seconds = time.perf_counter() - start
    hardest = []
    for _ in range(5):
        start = time.perf_counter()
        pressure_stage.hardest_slam(realised, slams)
        hardest.append(time.perf_counter() - start)
    ours, rival = _rows()
    return [
        (
            f"one hour, 400 panels, {slams.sizes['slam']} slams: pressure, envelope, force",
            f"{seconds:.1f} s",
            "at most 20 s",
        ),
        ("the hardest slam in time, 1/400 s steps", f"{np.median(hardest):.2f} s", "at most 0.5 s"),
        ("wetted intervals: scipy's fsolve row by row / ours", f"{rival / ours:.0f}", ""),
    ]


def _rows() -> tuple[float, float]:
    """Seconds a row of ours and of a root finder called for each row, on the same crests."""
    nodes = np.linspace(-29.25, 29.25, 40)
    rng = np.random.default_rng(1)
    centre, height, curvature = (
        rng.uniform(-8, 8, ROWS),
        rng.uniform(0.1, 0.8, ROWS),
        rng.uniform(0.01, 0.03, ROWS),
    )
    rise = height[:, None] - curvature[:, None] * (nodes - centre[:, None]) ** 2 / 2
    still = np.zeros_like(rise)
    profiles = StripProfiles(nodes, rise, still, still, -30.0, 30.0, np.zeros((1, 641)), np.zeros(ROWS, int))
    start = time.perf_counter()
    found = wetted_intervals(profiles)
    ours = (time.perf_counter() - start) / ROWS
    few = 200
    start = time.perf_counter()
    for row in range(few):

        def conditions(ends, row=row):
            x = (ends[0] + ends[1]) / 2 + (ends[1] - ends[0]) / 2 * COSINES
            h = np.interp(x, nodes, rise[row])
            return np.mean(h * (1 - COSINES)), np.mean(h * (1 + COSINES))

        half = np.sqrt(2 * height[row] / curvature[row])
        ends = fsolve(conditions, [centre[row] - 1.4 * half, centre[row] + 1.4 * half])
        np.testing.assert_allclose(ends, [found.aft[row], found.fore[row]], atol=0.5)
    return ours, (time.perf_counter() - start) / few
