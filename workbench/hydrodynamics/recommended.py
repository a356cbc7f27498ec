"""Which theory of the motions is recommended for a ship at a speed, heading by heading."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field

import numpy as np

from workbench.conventions import GRAVITY, encounter_frequency, froude_number
from workbench.hydrodynamics.high_speed_settings import LEAST_TAU, HighSpeedSettings
from workbench.hydrodynamics.high_speed_settings import LOW_FROUDE_NUMBER as LEAST_HIGH_SPEED
from workbench.hydrodynamics.settings import LOW_FROUDE_NUMBER as MOST_POTENTIAL_FLOW
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings

METHODS = ("recommended", "strip", "high-speed", "potential-flow")
THEORY_NAMES = {"strip": "strip theory", "high-speed": "high-speed theory", "potential-flow": "panel method"}
"""Theories in words."""
IN_A_SENTENCE = {**THEORY_NAMES, "potential-flow": "the panel method"}
"""Theories in words, within a sentence."""
GOVERNING_WAVES = (1.0, 2.0)
"""Shortest and longest of the waves that move a ship most in head seas, in ship lengths [-]."""


@dataclass(frozen=True, kw_only=True)
class RecommendedSettings:
    """Leave the choice of theory to the workbench.

    Parameters
    ----------
    quick : take strip theory where the panel method is recommended; answers in about a second for any hull.
    potential_flow, strip, high_speed : choices within each theory.
    """

    quick: bool = False
    potential_flow: PotentialFlowSettings = field(default_factory=PotentialFlowSettings)
    strip: StripSettings = field(default_factory=StripSettings)
    high_speed: HighSpeedSettings = field(default_factory=HighSpeedSettings)

    def as_dict(self) -> dict:
        """Return the settings as plain values."""
        return asdict(self)

    def of(self, method: str) -> "TheorySettings":
        """Return the choices within one theory."""
        return {"strip": self.strip, "high-speed": self.high_speed, "potential-flow": self.potential_flow}[
            method
        ]


TheorySettings = PotentialFlowSettings | StripSettings | HighSpeedSettings | RecommendedSettings


def recommended(
    length: float, speed: float, wave_directions: Sequence[float], omega: np.ndarray, quick: bool = False
) -> tuple[str, ...]:
    """Recommended theory for each wave direction.

    Below Fn 0.2 the panel method, whose waves are those of a ship at rest; from Fn 0.25 the high-speed
    theory where tau = U omega_e/g is above 1/4 for waves of one to two ship lengths, so that no wave runs
    ahead of the ship; strip theory otherwise, and wherever the ship overtakes some of the waves.

    Parameters
    ----------
    length : of the ship [m]; speed : [m/s]; wave_directions : [rad]; omega : wave frequencies asked for [rad/s].
    quick : strip theory instead of the panel method.
    """
    directions = np.asarray(wave_directions, float)
    froude = froude_number(speed, length)
    governing = np.sqrt(2 * np.pi * GRAVITY / (np.array(GOVERNING_WAVES) * length))
    tau = speed * encounter_frequency(governing[:, None], speed, directions) / GRAVITY
    overtaken = np.any(encounter_frequency(np.asarray(omega)[:, None], speed, directions) <= 0, axis=0)
    slow = "strip" if quick else "potential-flow"
    chosen = []
    for lowest_tau, is_overtaken in zip(tau.min(axis=0), overtaken, strict=True):
        if is_overtaken:
            chosen.append("strip")
        elif froude < MOST_POTENTIAL_FLOW:
            chosen.append(slow)
        elif froude >= LEAST_HIGH_SPEED * (1 - 1e-9) and lowest_tau > LEAST_TAU:
            chosen.append("high-speed")
        else:
            chosen.append("strip")
    return tuple(chosen)


def reason(length: float, speed: float, chosen: Sequence[str]) -> str:
    """Sentence on the choice."""
    froude = froude_number(speed, length)
    names = " and ".join(dict.fromkeys(IN_A_SENTENCE[one] for one in chosen))
    split = ", by heading" if len(set(chosen)) > 1 else ""
    return f"Recommended at Fn {froude:.2f}: {names}{split}."
