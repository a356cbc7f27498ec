"""A study over conditions as one file: headings, speeds, heights and periods, and the watched places of the deck.

The file is TOML::

    name = "ferry"                    # title, source, design and theory may stand beside it
    [conditions]
    speed_knots = [20, 30]
    heading_degrees = [180, 150]      # 180 is head seas
    significant_wave_height = [3.0]   # [m]
    mean_period = [8, 10]             # or peak_period, or zero_crossing_period [s]
    heel_degrees = [0, 5]             # one for each speed; may be left out, as wind_speed [m/s]
    [slams]                           # may be left out
    velocity = "material"             # or "time-derivative"
    threshold = 0.0                   # [m/s], of the time derivative
    hours = 1.0
    [[places]]                        # may be left out: the whole deck
    name = "wet deck"
    panel = "austal-63 wet deck"      # or coefficient = 113.7
    x = [-10.0, 30.0]                 # from, to [m]; may be left out
    y = [0.0, 2.0]                    # distance from the centreline [m]; may be left out

The studies of [Grande2002]_ come with the package (`example`).

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 5.1 and 5.2.
"""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.resources import files
from math import inf

import numpy as np

from workbench.conventions import KNOT
from workbench.errors import InputError, checked_choice, checked_number
from workbench.hydrodynamics.recommended import METHODS
from workbench.impact.panel_library import PANELS, panel_coefficient
from workbench.sea_scatter import PERIODS, sea_by_period
from workbench.seas import Condition
from workbench.slamming.statistics import VELOCITIES

THEORIES = (*METHODS, "sailing")
"""Theories of the motions; "sailing" is strip theory with the heave of single hulls, and surge, sway and yaw held."""
EXAMPLES = ("grande-austal-63", "grande-crowther-318-flying", "grande-crowther-318-sailing")
"""Studies that come with the package: the 108, 84 and 27 conditions of [Grande2002]_."""
MOST_CONDITIONS = 5000


@dataclass(frozen=True, kw_only=True)
class DeckPlace:
    """Part of a wet deck whose most exposed point is watched, and the k of its panels.

    Parameters
    ----------
    name : in words; coefficient : k [-]; panel : name of the panel in `PANELS`, or "".
    x : from and to, forward of amidships [m]; y : least and greatest distance from the centreline [m].
    """

    name: str = "wet deck"
    coefficient: float = PANELS[0].coefficient
    panel: str = PANELS[0].name
    x: tuple[float, float] = (-inf, inf)
    y: tuple[float, float] = (0.0, inf)

    def __post_init__(self):
        checked_number(f"coefficient of {self.name}", self.coefficient, above=0, at_most=1e5)
        for axis, (start, end) in (("x", self.x), ("y", self.y)):
            if not start < end:
                raise InputError(
                    f"{axis} of {self.name} must go from less to more, got {start:g} to {end:g} m."
                )


@dataclass(frozen=True, kw_only=True)
class ConditionStudy:
    """Conditions made of every speed, heading, height and period, and what is asked of each.

    Parameters
    ----------
    name, title, source : in words; design : of the library that the study is about, or "".
    speeds : [m/s]; heels : of each speed, starboard side down [rad]; wave_directions : [rad].
    heights : significant, [m]; periods : [s] of the kind ``period_kind``.
    places : of the deck.
    velocity : kind of entry velocity: with "material" a crossing counts only where the deck comes down on the water, as
        in the source; threshold : least time derivative that counts [m/s].
    hours : of each condition [h]; theory : one of `THEORIES`; wind_speed : on the sails [m/s], or None.
    """

    name: str
    speeds: tuple[float, ...]
    wave_directions: tuple[float, ...]
    heights: tuple[float, ...]
    periods: tuple[float, ...]
    period_kind: str = "mean"
    heels: tuple[float, ...] = ()
    places: tuple[DeckPlace, ...] = (DeckPlace(),)
    velocity: str = "material"
    threshold: float = 0.0
    hours: float = 1.0
    theory: str = "recommended"
    wind_speed: float | None = None
    title: str = ""
    source: str = ""
    design: str = ""

    def __post_init__(self):
        checked_choice("velocity of the study", self.velocity, VELOCITIES)
        checked_choice("theory of the study", self.theory, THEORIES)
        checked_number("threshold of the study", self.threshold, "m/s", at_least=0, at_most=50)
        checked_number("hours of the study", self.hours, "h", above=0, at_most=24)
        if self.velocity == "material" and self.threshold > 0:
            raise InputError(
                "threshold of the study must be 0 with the material velocity, as in its source, got "
                f"{self.threshold:g} m/s; take velocity = 'time-derivative'."
            )
        if not self.heels:
            object.__setattr__(self, "heels", (0.0,) * len(self.speeds))
        if len(self.heels) != len(self.speeds):
            raise InputError(
                f"heel_degrees must be one for each speed, {len(self.speeds)}, got {len(self.heels)}."
            )
        for words in ("speeds", "wave_directions", "heights", "periods"):
            values = getattr(self, words)
            if not values or len(set(values)) < len(values):
                raise InputError(
                    f"{words} of the study must be different numbers, at least one, got {values}."
                )
        if self.count > MOST_CONDITIONS:
            raise InputError(
                f"conditions must be {MOST_CONDITIONS} at most, got {self.count}; split the study."
            )
        names = [place.name for place in self.places]
        if not names or len(set(names)) < len(names):
            raise InputError(f"places of the study must have different names, at least one, got {names}.")
        for height in self.heights:
            for period in self.periods:
                sea_by_period(height, period, self.period_kind)
        for speed in self.speeds:
            for direction in self.wave_directions:
                self.condition(speed, direction, self.heights[0], self.periods[0])

    @property
    def count(self) -> int:
        """Number of conditions."""
        return len(self.speeds) * len(self.wave_directions) * len(self.heights) * len(self.periods)

    def condition(self, speed: float, wave_direction: float, height: float, period: float) -> Condition:
        """Condition of these values."""
        sea = sea_by_period(height, period, self.period_kind)
        return Condition(speed=speed, wave_direction=wave_direction, sea_state=sea)


_TOP = ("name", "title", "source", "design", "theory", "conditions", "slams", "places")
_PERIOD_KEYS = {f"{kind.replace('-', '_')}_period": kind for kind in PERIODS}
_CONDITIONS = (
    "speed_knots", "heading_degrees", "significant_wave_height", *_PERIOD_KEYS, "heel_degrees", "wind_speed",
)  # fmt: skip


def study_of_text(text: str) -> ConditionStudy:
    """Study from the text of its TOML file."""
    try:
        given = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InputError(f"study file must be TOML, got: {error}; see the examples.") from None
    _known("study", given, _TOP)
    if not isinstance(given.get("name"), str) or not isinstance(given.get("conditions"), Mapping):
        raise InputError("study file must have a name and a table [conditions].")
    conditions, slams = given["conditions"], given.get("slams", {})
    if not isinstance(slams, Mapping):
        raise InputError("slams of the study must be a table [slams].")
    _known("[conditions]", conditions, _CONDITIONS)
    _known("[slams]", slams, ("velocity", "threshold", "hours"))
    kinds = [key for key in _PERIOD_KEYS if key in conditions]
    if len(kinds) != 1:
        raise InputError(f"[conditions] must have one of {', '.join(_PERIOD_KEYS)}, got {len(kinds)}.")
    places = given.get("places", [])
    if not isinstance(places, list) or not all(isinstance(place, Mapping) for place in places):
        raise InputError("places of the study must be tables [[places]].")
    headings = [
        checked_number("heading_degrees", one, "degrees", at_least=0, at_most=360, cure="180 is head seas")
        for one in _numbers("heading_degrees", conditions)
    ]
    heels = _numbers("heel_degrees", conditions) if "heel_degrees" in conditions else []
    texts = {key: str(given.get(key, "")) for key in ("title", "source", "design")}
    return ConditionStudy(
        name=given["name"],
        speeds=tuple(KNOT * one for one in _numbers("speed_knots", conditions)),
        wave_directions=tuple(float(np.radians(one)) for one in headings),
        heights=tuple(_numbers("significant_wave_height", conditions)),
        periods=tuple(_numbers(kinds[0], conditions)),
        period_kind=_PERIOD_KEYS[kinds[0]],
        heels=tuple(float(np.radians(one)) for one in heels),
        places=tuple(map(_place, places)) or (DeckPlace(),),
        theory=given.get("theory", "recommended"),
        wind_speed=conditions.get("wind_speed"),
        **slams,
        **texts,
    )


def example_text(name: str) -> str:
    """Text of the file of a study that comes with the package."""
    checked_choice("example study", name, EXAMPLES)
    return files("workbench").joinpath("data", "studies", f"{name}.toml").read_text(encoding="utf-8")


def example(name: str) -> ConditionStudy:
    """Study that comes with the package, one of `EXAMPLES`."""
    return study_of_text(example_text(name))


def _known(where: str, given: Mapping, keys: tuple[str, ...]) -> None:
    for key in given:
        checked_choice(f"key of {where}", key, keys)


def _numbers(key: str, table: Mapping) -> list[float]:
    values = table.get(key)
    if not isinstance(values, list) or not values:
        raise InputError(f"{key} must be a list of numbers in [conditions], got {values!r}.")
    return [checked_number(key, one) for one in values]


def _place(given: Mapping) -> DeckPlace:
    _known("[[places]]", given, ("name", "panel", "coefficient", "x", "y"))
    if ("panel" in given) == ("coefficient" in given):
        raise InputError("each of [[places]] must have either a panel or a coefficient.")
    values: dict = {"name": str(given.get("name", "wet deck"))}
    for axis in ("x", "y"):
        if axis in given:
            pair = given[axis]
            if not isinstance(pair, list) or len(pair) != 2:
                raise InputError(
                    f"{axis} of {values['name']} must be two numbers, from and to, got {pair!r}."
                )
            values[axis] = tuple(checked_number(f"{axis} of {values['name']}", one, "m") for one in pair)
    if "panel" in given:
        return DeckPlace(
            panel=given["panel"], coefficient=panel_coefficient(given["panel"]).coefficient, **values
        )
    return DeckPlace(panel="", coefficient=given["coefficient"], **values)
