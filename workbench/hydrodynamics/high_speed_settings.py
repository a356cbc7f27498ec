"""What a user may choose about the high-speed theory, and where it holds."""

from dataclasses import asdict, dataclass

import numpy as np

from workbench.conventions import GRAVITY, encounter_frequency, froude_number
from workbench.errors import InputError, checked_choice, checked_number

INTERACTIONS = ("auto", "on", "off")
TRANSOMS = ("released", "none")
LEAST_FROUDE_NUMBER = 0.1
"""Below this the march from the bow is refused: it would take thousands of stations [-]."""
LOW_FROUDE_NUMBER = 0.25
"""Below this the transverse waves that the theory leaves out count [-]."""
LEAST_TAU = 0.25
"""Below this value of U omega_e / g waves run ahead of the ship, which the theory cannot know [-]."""


@dataclass(frozen=True, kw_only=True)
class HighSpeedSettings:
    """Choices of the high-speed theory.

    Parameters
    ----------
    stations : of the march along the ship, 40 to 1000, more where the encounter frequencies need it.
    panels : along the wetted contour of one hull, 8 to 80.
    interaction : between the hulls: "on" (all hulls in one cross-plane), "off" (each alone), or "auto":
        each hull alone up to where waves of the encounter frequency from another hull can have reached it,
        and together behind.
    transom : "released" (pressure falls to that of the air at a dry transom, [Garme2005]_) or "none".
    wave_field : water under the deck: "incident" wave alone, or "total".
    """

    stations: int = 100
    panels: int = 20
    interaction: str = "auto"
    transom: str = "released"
    wave_field: str = "incident"

    method = "high-speed"

    def __post_init__(self):
        checked_number("stations", self.stations, at_least=40, at_most=1000)
        checked_number("panels of a section", self.panels, at_least=8, at_most=80)
        checked_choice("interaction", self.interaction, INTERACTIONS)
        checked_choice("transom", self.transom, TRANSOMS)
        checked_choice("wave_field", self.wave_field, ("incident", "total"))

    def as_dict(self) -> dict:
        """Return the settings as plain values."""
        return asdict(self)


def check_speed(speed: float, length: float) -> None:
    """Refuse speeds at which the march from the bow has no meaning."""
    froude = froude_number(speed, length)
    if froude < LEAST_FROUDE_NUMBER:
        raise InputError(
            f"Froude number must be >= {LEAST_FROUDE_NUMBER} for the high-speed theory, got {froude:.3g}; use strip "
            "theory or the panel method at low speed."
        )


def tau(omega: np.ndarray, wave_directions: np.ndarray, speed: float) -> np.ndarray:
    """Brard's number U omega_e / g (omega, wave_direction) [-]."""
    return speed * encounter_frequency(omega[:, None], speed, wave_directions) / GRAVITY


def validity_warnings(
    settings: HighSpeedSettings, count: int, speed: float, length: float, lowest_tau: float
) -> tuple[str, ...]:
    """Sentences on what the theory is not known to do right here."""
    froude = froude_number(speed, length)
    sentences = []
    if froude < LOW_FROUDE_NUMBER:
        sentences.append(
            f"Fn {froude:.2f} is below {LOW_FROUDE_NUMBER}: the high-speed theory leaves out the transverse waves, "
            "which count there."
        )
    if lowest_tau < LEAST_TAU:
        sentences.append(
            f"The number tau = U omega_e/g falls to {lowest_tau:.2f}, below {LEAST_TAU}: such waves run ahead of the "
            "ship, which the high-speed theory cannot know; use strip theory for them."
        )
    if count > 1 and settings.interaction == "off":
        sentences.append(
            "Each hull is solved alone: waves between the hulls are left out of the coefficients."
        )
    if count > 1 and settings.wave_field == "incident":
        sentences.append(
            "The water under the deck is the incident wave: what the hulls scatter is left out of it."
        )
    return tuple(sentences)
