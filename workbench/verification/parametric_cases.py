"""Parametric studies of the Austal 63 and the Crowther 318: sign and size of what each change does to the slams."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from workbench.verification import published
from workbench.verification.case import Case
from workbench.verification.parametric_misses import MISSES, reason
from workbench.verification.parametric_ships import (
    AUSTAL_KNOTS,
    AUSTAL_SEAS,
    CROWTHER_HEEL,
    OFF_HEAD,
    austal,
    crowther,
)

SLAMS = "grande_2002_parametric_slams"
HULLS = ("as built", "longer", "wider hulls", "deck aft", "deck raised")
AUSTAL_NOTE = (
    "stand-in with forward T-foils of 6 m2 each (ours), head seas of 8 s mean period (ours: the source states no sea); "
    "within two deviations of the change between counts of one hour"
)
AUSTAL_VELOCITY = AUSTAL_NOTE.split("; within")[0]
CROWTHER_NOTE = (
    "stand-in by the sailing theory, 2.25 m and 4 s mean period, 45 degrees off the bow (ours: the source states no "
    "sea), 0, 2 and 5 degrees of heel; within two deviations of the change between counts of one hour"
)


def changes(vessel: str, place: str, knots: int, hull: int) -> tuple[float, float]:
    """Published change of the slams [percent], and two deviations of it between counts of one hour."""
    slams = published.columns(SLAMS, vessel=vessel, place=place, speed_knots=knots)["slams_per_hour"]
    ratio = slams[hull] / slams[0]
    return 100.0 * (ratio - 1.0), 200.0 * ratio * float(np.sqrt(1 / slams[0] + 1 / slams[hull]))


def _change_case(
    name: str,
    title: str,
    where: str,
    known: tuple[float, float],
    computed: Callable[[], float],
    note: str,
    slow: bool = False,
) -> Case:
    miss = {}
    if name in MISSES:
        miss = {"miss": reason(name), "miss_figure": MISSES[name], "miss_band": 2.0}
    return Case(
        id=name, title=title, kind="trend", source=f"{published.citation(SLAMS)}, {where}",
        published=known[0], computed=computed, tolerance=known[1], unit="%", note=note, slow=slow, **miss,
    )  # fmt: skip


def _austal_cases() -> list[Case]:
    return [
        _change_case(
            f"austal-{HULLS[hull].replace(' ', '-')}-{knots}-knots-hs{height:.0f}",
            f"change of the slams of the Austal 63, {HULLS[hull]}, {knots} knots, Hs {height:g} m",
            "tables 8.2-8.4",
            changes("austal-63", "wet deck", knots, hull),
            lambda hull=hull, knots=knots, height=height: (
                100.0 * (austal(hull, knots, height)[0] / austal(0, knots, height)[0] - 1.0)
            ),
            AUSTAL_NOTE,
            slow=hull in (1, 2),  # hulls of their own: some seconds each
        )
        for height, _ in AUSTAL_SEAS
        for knots in AUSTAL_KNOTS
        for hull in ((1, 2, 3, 4) if height == 4.0 else (3, 4))
    ]


def _crowther_cases() -> list[Case]:
    return [
        _change_case(
            f"crowther-{place.replace(' ', '-')}-{HULLS[hull].replace(' ', '-')}-{knots}-knots",
            f"change of the slams of the Crowther 318's {place}, {HULLS[hull]}, {knots} knots",
            "tables 8.6-8.11",
            changes("crowther-318", place, knots, hull),
            lambda place=place, hull=hull, knots=knots: (
                100.0 * (crowther(place, hull, knots) / crowther(place, 0, knots) - 1.0)
            ),
            CROWTHER_NOTE,
        )
        for place in ("pod", "main beam")
        for knots in CROWTHER_HEEL
        for hull in (1, 2, 3, 4)
    ]


def _falls(values: list[float]) -> bool:
    """Whether numbers of slams fall all along, those below one in a hundred hours left out."""
    return all(later < earlier or earlier < 0.01 for earlier, later in pairwise(values))


def _all_seas() -> list[tuple[float, float]]:
    return [(height, period) for height in (3.0, 4.0) for period in (8.0, 10.0, 12.0)]


def _trend(name: str, title: str, where: str, holds: Callable[[], bool], note: str) -> Case:
    miss = {"miss": reason(name), "miss_figure": 0.0, "miss_band": 0.1} if name in MISSES else {}
    return Case(
        id=name, title=f"{title} (1: yes)", kind="trend", source=f"{published.citation(SLAMS)}, {where}",
        published=1.0, computed=lambda: float(holds()), tolerance=0.0, note=note, **miss,
    )  # fmt: skip


def _strongest(rate: Callable[[int], float]) -> bool:
    return rate(4) < min(rate(hull) for hull in (0, 1, 2, 3))


def _trend_cases() -> list[Case]:
    made = [
        _trend(
            "austal-raised-strongest", "raising the deck is the strongest measure on the Austal 63, 20 and 40 knots",
            "8.1", lambda: all(
                _strongest(lambda hull, knots=knots, height=height: austal(hull, knots, height)[0])
                for knots in (20, 40) for height, _ in AUSTAL_SEAS
            ), AUSTAL_NOTE,
        ),
        _trend(
            "crowther-raised-strongest",
            "raising pod and beam of the Crowther 318 is the strongest measure, all speeds",
            "8.2", lambda: all(
                _strongest(lambda hull, place=place, knots=knots: crowther(place, hull, knots))
                for place in ("pod", "main beam") for knots in CROWTHER_HEEL
            ), CROWTHER_NOTE,
        ),
        _trend(
            "crowther-beam-aft", "the Crowther's main beam slams less further aft, all speeds",
            "8.2", lambda: all(crowther("main beam", 3, k) < crowther("main beam", 0, k) for k in CROWTHER_HEEL),
            CROWTHER_NOTE,
        ),
        _trend(
            "crowther-pod-aft", "the Crowther's pod slams more further aft, all speeds",
            "8.2", lambda: all(crowther("pod", 3, k) > crowther("pod", 0, k) for k in CROWTHER_HEEL), CROWTHER_NOTE,
        ),
        _trend(
            "austal-heading-from-head", "slams of the Austal 63 are most frequent in head seas, 20 knots, six seas",
            "5.1", lambda: all(
                austal(0, 20, *sea)[0] > max(austal(0, 20, *sea, off)[0] for off in OFF_HEAD[1:]) for sea in _all_seas()
            ), AUSTAL_NOTE,
        ),
        _trend(
            "austal-heading", "slams of the Austal 63 fall from 15 to 75 degrees off head seas, 20 knots, six seas",
            "5.1", lambda: all(
                _falls([austal(0, 20, *sea, off)[0] for off in OFF_HEAD[1:]]) for sea in _all_seas()
            ), AUSTAL_NOTE,
        ),
        _trend(
            "austal-period", "slams of the Austal 63 fall from 8 to 12 s mean period, all speeds, Hs 3 and 4 m",
            "5.1", lambda: all(
                _falls([austal(0, knots, height, period)[0] for period in (8.0, 10.0, 12.0)])
                for knots in AUSTAL_KNOTS for height in (3.0, 4.0)
            ), AUSTAL_NOTE,
        ),
        _trend(
            "austal-height", "slams of the Austal 63 more than double from Hs 3 to 4 m, all speeds and periods",
            "5.1 (strongly increasing; taken as twofold)", lambda: all(
                austal(0, knots, 4.0, period)[0] > 2 * austal(0, knots, 3.0, period)[0]
                for knots in AUSTAL_KNOTS for period in (8.0, 10.0, 12.0)
            ), AUSTAL_NOTE,
        ),
        _trend(
            "austal-largest-velocity", "mean entry velocity of the Austal 63 is largest at 20 knots, Hs 4 m, 8 s",
            "5.1", lambda: austal(0, 20)[1] > max(austal(0, knots)[1] for knots in (30, 40)), AUSTAL_NOTE,
        ),
    ]  # fmt: skip
    mean = published.columns(SLAMS, vessel="austal-63", hull=0)["mean_entry_velocity"]
    made += [
        Case(
            id=f"austal-velocity-{knots}-knots", kind="trend", source=f"{published.citation(SLAMS)}, tables 8.2-8.4",
            title=f"mean entry velocity of the Austal 63 at {knots} knots over that at 20 knots, Hs 4 m",
            published=float(known / mean[0]), computed=lambda knots=knots: austal(0, knots)[1] / austal(0, 20)[1],
            tolerance=0.2, note=f"{AUSTAL_VELOCITY}; at 20 knots 2.27 m/s in the source",
        )
        for knots, known in zip(AUSTAL_KNOTS[1:], mean[1:], strict=True)
    ]  # fmt: skip
    made += [
        _trend(
            f"austal-speed-hs{height:.0f}", f"slams of the Austal 63 fall from 20 to 40 knots, Hs {height:g} m",
            "5.1", lambda height=height: _falls([austal(0, knots, height)[0] for knots in AUSTAL_KNOTS]), AUSTAL_NOTE,
        )
        for height, _ in AUSTAL_SEAS
    ]  # fmt: skip
    return made


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_austal_cases(), *_trend_cases(), *_crowther_cases()]
