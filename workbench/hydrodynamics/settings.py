"""What a user may choose about the potential-flow method, and what follows from the ship and its speed."""

from dataclasses import asdict, dataclass

from workbench.conventions import froude_number
from workbench.errors import checked_choice, checked_number

INTERACTION = ("auto", "on", "off")
SPEED_TREATMENTS = ("encounter-frequency", "forward-speed")
WAVE_FIELDS = ("auto", "incident", "total")
LOW_FROUDE_NUMBER = 0.2
"""Up to here the panel method with hull interaction is taken to hold [-]."""


@dataclass(frozen=True, kw_only=True)
class PotentialFlowSettings:
    """Choices of the potential-flow method.

    Parameters
    ----------
    panels : wished number of panels of the whole ship, 100 to 6000.
    interaction : between the hulls: "on", "off" (each hull alone), or "auto": on
        below Fn 0.2, off above, where the zero-speed Green function keeps waves
        between the hulls that a tank does not show.
    lid : interior waterplane lid against irregular frequencies.
    tunnel_damping : damping of the water surface between the hulls [-], 0 to 0.2;
        0.02 to 0.05 tames gap resonance and leaves the incident wave alone.
    speed_treatment : "encounter-frequency" (potentials at rest at the encounter
        frequency with the speed terms of strip theory) or "forward-speed"
        (Capytaine's own option, some ten times dearer).
    wave_field : water under the deck: "incident" wave alone, "total" (diffracted
        and radiated waves too; at rest only), or "auto": total at rest, incident at speed.
    """

    panels: int = 1000
    interaction: str = "auto"
    lid: bool = True
    tunnel_damping: float = 0.0
    speed_treatment: str = "encounter-frequency"
    wave_field: str = "auto"

    def __post_init__(self):
        checked_number("panels", self.panels, at_least=100, at_most=6000)
        checked_choice("interaction", self.interaction, INTERACTION)
        checked_number("tunnel_damping", self.tunnel_damping, at_least=0, at_most=0.2)
        checked_choice("speed_treatment", self.speed_treatment, SPEED_TREATMENTS)
        checked_choice("wave_field", self.wave_field, WAVE_FIELDS)

    def interacts(self, count: int, speed: float, length: float) -> bool:
        """Whether the hulls are solved together at this speed."""
        if count == 1 or self.interaction != "auto":
            return count == 1 or self.interaction == "on"
        return froude_number(speed, length) < LOW_FROUDE_NUMBER

    def as_dict(self) -> dict:
        """Return the settings as plain values."""
        return asdict(self)


def validity_warnings(
    settings: PotentialFlowSettings, count: int, speed: float, length: float
) -> tuple[str, ...]:
    """Sentences on what the method is not known to do right at this speed."""
    froude = froude_number(speed, length)
    sentences = []
    if froude > LOW_FROUDE_NUMBER:
        sentences.append(
            f"Fn {froude:.2f} is above {LOW_FROUDE_NUMBER}: the panel method with a zero-speed Green function is a "
            "rough guide there. On the measured Delft 372 catamaran at Fn 0.30 its heave peak is 24 % low with each "
            "hull alone and 31 % high with both together."
        )
    whole_ship = settings.speed_treatment == "forward-speed" and speed > 0
    together = whole_ship or settings.interacts(count, speed, length)
    if count > 1 and together and froude >= LOW_FROUDE_NUMBER:
        sentences.append(
            "Hull interaction is on at speed: waves stay between the hulls that a tank does not show."
        )
    if count > 1 and not together:
        sentences.append(
            "Each hull is solved alone: waves between the hulls are left out of the coefficients."
        )
    if count > 1 and (speed > 0 or not together or settings.wave_field == "incident"):
        sentences.append(
            "The water under the deck is the incident wave: what the hulls scatter is left out of it."
        )
    if whole_ship:
        sentences.append(
            "Capytaine's forward-speed option assumes small speed; its heave peak on the Delft 372 with both hulls is "
            "1.68 times the measured one at Fn 0.30."
        )
    return tuple(sentences)
