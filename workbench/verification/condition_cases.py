"""Grande's studies over conditions of the Austal 63 and the Crowther 318: trends, and how many conditions slam."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import xarray as xr

from workbench.condition_runs import slamming_of_conditions
from workbench.condition_study import DeckPlace, example
from workbench.conventions import KNOT
from workbench.hulls.library import design
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.verification import published
from workbench.verification.case import Case
from workbench.verification.parametric_ships import AUSTAL_KNOTS, COARSE, austal_base, austal_response

CONDITIONS = "grande_2002_slamming_conditions"
FERRY, FLYING, SAILING = "grande-austal-63", "grande-crowther-318-flying", "grande-crowther-318-sailing"
CENTRELINE = DeckPlace(name="wet deck", y=(0.0, 0.5))
QUICK = StripSettings(stations=21, panels=20, frequencies=16)
ONE_CONDITION = ("forward_speed", "wave_direction", "period")
FERRY_NOTE = (
    "stand-in with forward T-foils (ours), most exposed point of the centreline: the point of the source is not "
    "published; closed form of its direct method"
)
CROWTHER_NOTE = (
    "stand-in; most exposed point on the centreline (pod), or beside the pod (main beam); linear strip theory"
)
COUNT_NOTE = (
    "expected number of conditions with a slam in one hour; tolerance two deviations of it in one realisation"
)

MISSES: dict[str, tuple[float, str]] = {
    f"conditions-{FERRY}-wet-deck-hs3": (
        25.6,
        "where slams are few their number hangs on the clearance, which is not published: 19 of the 54 conditions "
        "have more than 5 slams an hour here, 13 have 0.2 to 5",
    ),
    **dict.fromkeys(
        (f"conditions-{FLYING}-pod-hs2", f"conditions-{FLYING}-main-beam-hs2"),
        (
            0.0,
            "linear motions on one hull at 2 m; the source has non-linear ones. Its speeds and periods between the "
            "ends, clearances and attitude are not published",
        ),
    ),
    **dict.fromkeys(
        [f"conditions-{SAILING}-{place}-hs{height}" for place, height in (
            ("pod", "0.75"), ("main-beam", "0.75"), ("pod", "1.5"), ("main-beam", "1.5"), ("main-beam", "2.25"),
        )],
        (
            0.0,
            "the stand-in slams in one or two conditions more of nine: her clearances, hull lines and canted hulls are "
            "not published",
        ),
    ),
    "crowther-flying-low-speed": (
        0.0,
        "the stand-in on one hull slams the more the faster, as the encounters do; the source has its most slams at "
        "low speed by a non-linear theory, and itself calls the trend with speed a matter of attitude (5.2.2)",
    ),
}  # fmt: skip
"""Computed figure (0: from `FIGURES`) and reason of the comparisons that are known not to agree."""
FIGURES: dict[str, float] = {
    f"conditions-{FLYING}-pod-hs2": 26.3,
    f"conditions-{FLYING}-main-beam-hs2": 19.0,
    f"conditions-{SAILING}-pod-hs0.75": 2.0,
    f"conditions-{SAILING}-main-beam-hs0.75": 2.0,
    f"conditions-{SAILING}-pod-hs1.5": 5.4,
    f"conditions-{SAILING}-main-beam-hs1.5": 4.2,
    f"conditions-{SAILING}-main-beam-hs2.25": 6.7,
}
TOLERANCES = {
    (FERRY, 3.0): 3.4, (FERRY, 4.0): 1.9, (FLYING, 1.0): 1.9, (FLYING, 2.0): 2.0, (SAILING, 0.75): 0.3,
    (SAILING, 1.5): 1.0, (SAILING, 2.25): 1.4,
}  # fmt: skip


@cache
def ferry(velocity: str) -> xr.Dataset:
    """Return the 108 conditions of the Austal 63 for one kind of entry velocity."""
    study = replace(example(FERRY), places=(CENTRELINE,), velocity=velocity)
    return slamming_of_conditions(austal_base(), study, responses=_response, points=(40, 3))


def _response(speed: float):
    return austal_response(round(speed / KNOT))


@cache
def crowther(name: str) -> xr.Dataset:
    """Return the 84 or the 27 conditions of the Crowther 318."""
    return slamming_of_conditions(design("crowther-318"), example(name), COARSE if name == SAILING else QUICK)


@cache
def counted_ferry() -> xr.Dataset:
    """Return conditions at 20 knots with every crossing counted in one hour."""
    study = example(FERRY)
    chosen = replace(
        study, speeds=study.speeds[:1], heels=(), wave_directions=study.wave_directions[:5:2],
        places=(CENTRELINE,), velocity="time-derivative",
    )  # fmt: skip
    return slamming_of_conditions(
        austal_base(), chosen, responses=_response, points=(40, 3), counted=True, seed=63
    )


def conditions_with_slams(name: str, place: str, height: float) -> float:
    """Return the number of conditions with a slam in one hour that is to be expected."""
    found = ferry("material") if name == FERRY else crowther(name)
    slams = found.slams_per_hour.sel(place=place, significant_wave_height=height) * found.attrs["hours"]
    return float((1.0 - np.exp(-slams)).sum())


def _count_cases() -> list[Case]:
    made = []
    for row in published.rows(CONDITIONS):
        name, place, height = row["study"], row["place"], float(row["significant_wave_height"])
        key = f"conditions-{name}-{place.replace(' ', '-')}-hs{height:g}"
        miss = {}
        if key in MISSES:
            figure, reason = MISSES[key]
            miss = {"miss": reason, "miss_figure": figure or FIGURES[key], "miss_band": 0.3}
        made.append(
            Case(
                id=key.replace(".", "-"),
                title=f"slamming conditions of {row['conditions']}, {name.partition('-')[2]}, {place}, Hs {height:g} m",
                kind="trend", source=f"{published.citation(CONDITIONS)}, {row['figures']}",
                published=float(row["with_slams"]),
                computed=lambda name=name, place=place, height=height: conditions_with_slams(name, place, height),
                tolerance=TOLERANCES[name, height],
                note=f"{COUNT_NOTE}; {FERRY_NOTE if name == FERRY else CROWTHER_NOTE}", **miss,
            )
        )  # fmt: skip
    return made


def _falls_along(dim: str) -> bool:
    """Whether slams of the Austal fall along a dimension everywhere, those below one in a hundred hours left out."""
    slams = ferry("material").slams_per_hour.transpose(dim, ...).values
    return bool(np.all((slams[1:] < slams[:-1]) | (slams[:-1] < 0.01)))


def _more_than_doubles() -> bool:
    low, high = (
        ferry("material").slams_per_hour.sel(significant_wave_height=height) for height in (3.0, 4.0)
    )
    return bool((high > 2 * low).where(low > 0.01, True).all())


def _fastest() -> bool:
    found = ferry("material")
    velocity = found.mean_entry_velocity.where(found.slams_per_hour >= 1).squeeze("place")
    at = velocity.argmax(velocity.dims)
    return [int(at[name]) for name in velocity.dims] == [0, 0, 1, 0]


def _excess() -> xr.DataArray:
    """Crossings over slams of the direct method, where there is a slam in two hours."""
    direct = ferry("material").slams_per_hour
    return (ferry("time-derivative").slams_per_hour / direct).where(direct > 0.5)


def _excess_where_few() -> bool:
    """Whether the excess over the direct method is largest at the fewest slams, at each speed."""
    direct, excess = ferry("material").slams_per_hour, _excess()
    for index in range(len(AUSTAL_KNOTS)):
        number, more = (one.isel(forward_speed=index).values.ravel() for one in (direct, excess))
        there = np.isfinite(more)
        order = np.argsort(number[there])
        few, many = np.array_split(more[there][order], 3)[::2]
        if few.mean() <= many.mean():
            return False
    return True


def _inside_bands() -> float:
    found = counted_ferry()
    inside = (found.counted_band_low <= found.slams_per_hour) & (
        found.slams_per_hour <= found.counted_band_high
    )
    return float(inside.mean())


def _pod_more() -> bool:
    found = crowther(FLYING)
    pod, beam = (found.slams_per_hour.sel(place=place) for place in ("pod", "main beam"))
    return bool((pod > beam).where(pod > 0.01, True).all())


def _flying_falls(dim: str) -> bool:
    slams = crowther(FLYING).slams_per_hour.transpose(dim, ...).values
    return bool(np.all((slams[1:] < slams[:-1]) | (slams[:-1] < 0.01)))


def _trend(name: str, title: str, where: str, holds: Callable[[], bool], note: str) -> Case:
    miss = {}
    if name in MISSES:
        miss = {"miss": MISSES[name][1], "miss_figure": MISSES[name][0], "miss_band": 0.1}
    return Case(
        id=name, title=f"{title} (1: yes)", kind="trend", source=f"{published.citation(CONDITIONS)}, {where}",
        published=1.0, computed=lambda: float(holds()), tolerance=0.0, note=note, **miss,
    )  # fmt: skip


def _trend_cases() -> list[Case]:
    return [
        _trend(
            "conditions-austal-heading", "slams of the Austal 63 fall from head seas to 75 degrees off, 108 conditions",
            "5.1", lambda: _falls_along("wave_direction"), FERRY_NOTE,
        ),
        _trend(
            "conditions-austal-period", "slams of the Austal 63 fall from 8 to 12 s mean period, 108 conditions",
            "5.1", lambda: _falls_along("period"), FERRY_NOTE,
        ),
        _trend(
            "conditions-austal-height", "slams of the Austal 63 more than double from Hs 3 to 4 m, 108 conditions",
            "5.1 (strongly increasing; taken as twofold)", _more_than_doubles, FERRY_NOTE,
        ),
        _trend(
            "conditions-austal-fastest",
            "largest mean entry velocity of 108 conditions at 20 knots, head seas, Hs 4 m, 8 s", "5.1", _fastest,
            FERRY_NOTE,
        ),
        _trend(
            "conditions-probabilistic-higher",
            "crossings of the probabilistic method are more than the slams of the direct one, 108 conditions",
            "5.1.3", lambda: bool((_excess() > 1).where(np.isfinite(_excess()), True).all()),
            "the direct method leaves out crossings at which the deck does not come down on the water",
        ),
        _trend(
            "conditions-probabilistic-where-few", "their excess is largest where slams are few, at each speed",
            "5.1.3", _excess_where_few, "mean of the third with fewest slams against that of the third with most",
        ),
        Case(
            id="conditions-counted-in-bands", kind="second method", published=1.0, computed=_inside_bands,
            title="share of 18 conditions whose counted hour holds the closed form in its 99 % band",
            source=f"{published.citation(CONDITIONS)}, 5.1.3 (generally good agreement)", tolerance=0.06,
            note="Austal 63 at 20 knots, 180, 150 and 120 degrees, crossings; tolerance: one of them outside",
        ),
        _trend(
            "crowther-flying-short-waves", "slams of the Crowther 318 on one hull fall with the period, 84 conditions",
            "5.2.1", lambda: _flying_falls("period"), CROWTHER_NOTE,
        ),
        _trend(
            "crowther-flying-low-speed", "slams of the Crowther 318 on one hull fall with speed, 84 conditions",
            "5.2.1", lambda: _flying_falls("forward_speed"), CROWTHER_NOTE,
        ),
        _trend(
            "crowther-flying-pod", "her pod slams more often than her main beam, 84 conditions", "5.2.1",
            _pod_more, CROWTHER_NOTE,
        ),
    ]  # fmt: skip


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_count_cases(), *_trend_cases()]
