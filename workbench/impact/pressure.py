"""Peak impact pressure by a named law, from entry velocity and the angle between deck and water."""

from dataclasses import dataclass

import numpy as np

from workbench.errors import checked_choice, checked_number
from workbench.impact import chuang, wagner

LAWS = ("chuang", "chuang-text", "wagner", "panel")


@dataclass(frozen=True, kw_only=True)
class PressureLaw:
    """How entry velocity becomes peak pressure.

    Parameters
    ----------
    name : "chuang" (k(xi) with the small-angle law of the source's program, and
        planing pressure), "chuang-text" (its printed small-angle law), "wagner"
        (k = pi**2/4 cot**2 of the relative angle, at least 3 degrees), or "panel"
        (a given k, the same for all angles).
    coefficient : k of "panel", pressure over rho V**2/2 [-].
    """

    name: str = "chuang"
    coefficient: float | None = None

    def __post_init__(self):
        checked_choice("pressure law", self.name, LAWS)
        if self.name == "panel":
            checked_number("coefficient", self.coefficient, above=0, at_most=1e5, cure="give k of the panel")

    @property
    def velocity(self) -> str:
        """Kind of entry velocity that the law needs.

        Chuang's kinematics are those of the wave surface passing the deck ("time-derivative");
        a two-dimensional theory takes hull surface against water particle ("material").
        """
        return "time-derivative" if self.name.startswith("chuang") else "material"

    @property
    def validity(self) -> tuple[str, ...]:
        """Sentences about the limits of the law."""
        if self.name == "wagner":
            return (
                "Wagner's pressure is taken at 3 degrees where the deck meets the water at a smaller angle: air is "
                "trapped there and the theory does not hold.",
            )
        if self.name.startswith("chuang"):
            return (
                "Chuang's pressure is the local peak of some milliseconds; averages over a panel of the deck are two "
                "to six times lower.",
            )
        return ()


def peak_pressure(law: PressureLaw, velocity, angle, density: float) -> np.ndarray:
    """Peak pressure of an entry [Pa].

    Parameters
    ----------
    law : the law.
    velocity : closing velocity, vertical [m/s]; angle : between deck and water surface [rad].
    density : of the water [kg/m3].

    Notes
    -----
    For Chuang's law the velocity is resolved on the water surface, v cos(xi)
    normal and v sin(xi) along it; his factor 1/cos(pitch)**2 is in
    `workbench.impact.chuang.method_one` alone, where the pitch is known.
    """
    velocity, angle = np.broadcast_arrays(np.asarray(velocity, float), np.asarray(angle, float))
    if law.name == "panel":
        return wagner.impact_pressure(velocity, law.coefficient, density)
    if law.name == "wagner":
        return wagner.impact_pressure(velocity, wagner.impact_coefficient(angle), density)
    small = "text" if law.name == "chuang-text" else "program"
    return chuang.impact_pressure(velocity * np.cos(angle), angle, density, small) + chuang.planing_pressure(
        velocity * np.sin(angle), density
    )


FASTEST_TRIAL_ENTRY = 6.3
"""Largest normal velocity of the slams of USNS Hayes that Chuang's pressures were compared with [m/s]."""


def velocity_notes(law: PressureLaw, fastest: float) -> tuple[str, ...]:
    """Say so where entries [m/s] are faster than in the trials behind Chuang's line."""
    if not law.name.startswith("chuang") or fastest <= FASTEST_TRIAL_ENTRY:
        return ()
    return (
        f"The hardest entries, {fastest:.1f} m/s, are faster than the {FASTEST_TRIAL_ENTRY} m/s of the full-scale "
        "trials that Chuang's pressures were compared with.",
    )
