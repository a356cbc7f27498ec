"""A water entry from first contact to a penetration, and the theories of it side by side."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import SEAWATER_DENSITY
from workbench.errors import InputError, checked_number
from workbench.impact.entry import VelocityHistory, entry
from workbench.impact.section import Section, TableSection, Wedge

THEORIES = {
    "von-karman": "von Karman",
    "wagner": "Wagner",
    "logvinovich": "modified Logvinovich",
    "generalised-wagner": "generalised Wagner",
    "similarity": "exact wedge",
    "nonlinear": "fully non-linear",
    "chuang": "Chuang's tests",
}
"""Words for each theory, the simplest first."""

ON_REQUEST = ("nonlinear",)
"""Theories that take up to a minute and are computed when they are asked for."""

INSTANTS = 32
SHALLOW = 0.05
"""Penetration over the radius of a parabola or circle where none is given."""


@dataclass(frozen=True, kw_only=True)
class EntryCase:
    """A section that enters calm water, and how.

    Parameters
    ----------
    section : symmetric and convex.
    velocity : downwards at first contact [m/s].
    penetration : of the lowest point below calm water at the end [m].
    deceleration : constant, upwards [m/s2].
    density : of the water [kg/m3].
    panel : inner and outer half-breadth of the panel to average over [m], or None.
    """

    section: Section
    velocity: float
    penetration: float
    deceleration: float = 0.0
    density: float = SEAWATER_DENSITY
    panel: tuple[float, float] | None = None

    def __post_init__(self):
        checked_number(
            "downward entry velocity", self.velocity, "m/s", above=0, at_most=100,
            cure="water exit is not in these theories",
        )  # fmt: skip
        deepest = np.inf if np.isinf(self.section.reach) else self.section.mean_height(self.section.reach)
        checked_number(
            "penetration", self.penetration, "m", above=0, at_most=min(deepest, 100.0),
            cure="" if np.isinf(deepest) else "beyond it the water has passed the end of the section",
        )  # fmt: skip
        fastest = self.velocity**2 / (2 * self.penetration)
        checked_number(
            "deceleration", self.deceleration, "m/s2", at_least=0, below=fastest,
            cure="at that the section stops before the penetration",
        )  # fmt: skip
        if self.panel is not None:
            inner, outer = self.panel
            checked_number("inner edge of the panel", inner, "m", at_least=0)
            checked_number("outer edge of the panel", outer, "m", above=inner)

    @property
    def duration(self) -> float:
        """Time from first contact to the penetration [s]."""
        end = np.sqrt(self.velocity**2 - 2 * self.deceleration * self.penetration)
        return float(2 * self.penetration / (self.velocity + end))

    def times(self, count: int = INSTANTS) -> np.ndarray:
        """Instants after first contact, equally spaced, the last at the penetration [s]."""
        return np.linspace(0.0, self.duration, count + 1)[1:]

    @property
    def motion(self) -> float | VelocityHistory:
        """Velocity, constant or as a history."""
        if self.deceleration == 0:
            return self.velocity
        end = self.velocity - self.deceleration * self.duration
        return VelocityHistory((0.0, self.duration), (self.velocity, end))

    def by(self, method: str, count: int = INSTANTS) -> xr.Dataset:
        """Return the entry by one theory, at ``count`` instants; see `workbench.impact.entry.entry`."""
        panels = () if self.panel is None else (self.panel,)
        return entry(self.section, self.motion, method, self.density, self.times(count), panels)


class ComparedEntries(NamedTuple):
    """Entries by theory in the order of `THEORIES`, and the sentence why each of the others is refused."""

    found: dict[str, xr.Dataset]
    refused: dict[str, str]


def compared_entries(
    case: EntryCase, methods: Sequence[str] = tuple(THEORIES), count: int = INSTANTS
) -> ComparedEntries:
    """Return the entry by every theory that takes the case."""
    found, refused = {}, {}
    for method in methods:
        try:
            found[method] = case.by(method, count)
        except InputError as error:
            refused[method] = str(error)
    return ComparedEntries(found, refused)


def is_quick(section: Section, method: str) -> bool:
    """Whether a theory answers, or refuses, while a slider is dragged: within some hundredths of a second."""
    if method == "generalised-wagner":
        return isinstance(section, Wedge)
    if method == "similarity":
        return not isinstance(section, Wedge)
    return method not in ON_REQUEST


def wedge_coefficients(
    deadrise_angles: Sequence[float], methods: Sequence[str] = ("similarity", "wagner", "logvinovich")
) -> xr.Dataset:
    """Coefficients of wedges at constant velocity by theory; NaN where a theory refuses or gives none.

    Parameters
    ----------
    deadrise_angles : [rad]; methods : of `workbench.impact.entry.METHODS`.

    Returns
    -------
    Over ``entry_theory`` and ``deadrise_angle``: ``peak_coefficient`` p_max/(rho V**2/2), ``force_coefficient``
    F/(rho V**3 t), ``peak_height_ratio`` z/(V t), ``wetted_rate_ratio`` c'/V.

    Notes
    -----
    The exact wedge costs about 0.3 s an angle, the others milliseconds.
    """
    names = ("peak_coefficient", "force_coefficient", "peak_height_ratio", "wetted_rate_ratio")
    values = np.full((len(names), len(methods), len(deadrise_angles)), np.nan)
    for column, angle in enumerate(deadrise_angles):
        case = EntryCase(section=Wedge(angle), velocity=1.0, penetration=1.0, density=1.0)
        found = compared_entries(case, methods, 1).found
        for row, method in enumerate(methods):
            if method in found:
                one = found[method].isel(time=0)
                parts = (one.peak_coefficient, one.section_force, one.peak_height, one.wetted_rate)
                values[:, row, column] = [float(part) for part in parts]
    variables = {
        name: (("entry_theory", "deadrise_angle"), table) for name, table in zip(names, values, strict=True)
    }
    coords = {"entry_theory": list(methods), "deadrise_angle": np.asarray(deadrise_angles, float)}
    return quantities.dataset(coords, method="wedges by theory", **variables)


def usual_penetration(section: Section) -> float:
    """Penetration that shows an entry well [m]: half a metre of a wedge, little of what is blunt."""
    if isinstance(section, Wedge):
        return 0.5
    if isinstance(section, TableSection):
        return section.mean_height(section.reach) / 2
    return SHALLOW * section.radius
