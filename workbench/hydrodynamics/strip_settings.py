"""What a user may choose about strip theory, and what follows from the ship and its speed."""

from dataclasses import asdict, dataclass

from workbench.conventions import froude_number
from workbench.errors import InputError, checked_choice, checked_number

INTERACTION = ("auto", "on", "off")
TRANSOM = ("auto", "dry", "wet")
FORMULATIONS = ("full", "heave-only")
WAVE_FIELDS = ("incident", "total")
LOW_FROUDE_NUMBER = 0.2
"""Up to here the hulls are solved together unless asked otherwise [-]."""
HIGH_FROUDE_NUMBER = 0.35
"""Up to here strip theory of this kind is usually taken to hold [-]."""


@dataclass(frozen=True, kw_only=True)
class StripSettings:
    """Choices of strip theory.

    Parameters
    ----------
    stations : sections over the length of each hull, 5 to 201.
    panels : on the wetted contour of each section, 8 to 120; even.
    frequencies : encounter frequencies at which sections are solved, 8 to 200; a smooth
        curve through them serves all others. Hulls together are solved at every one.
    interaction : "on": the sections of all hulls at a station are solved together; "off":
        each hull alone; "auto": together below Fn 0.2, where the motions are then those of the
        panel method with both hulls within 2 % of the peak in heave and 4 % in pitch (Delft 372
        and a Wigley twin at rest), and alone above.
    transom : end terms of the last section: "dry", "wet" (none), or "auto": dry above a Froude
        number on the transom draught of 2.5.
    formulation : "full" (sway, heave and roll of every section) or "heave-only": all from the
        heave of each hull alone, modes heave, roll and pitch, the roll of a hull about its
        own axis neglected ([Grande2002]_ 2.21-2.32, for sailing multihulls).

    .. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
        Curtin University of Technology, 2002.
    """

    stations: int = 41
    panels: int = 32
    frequencies: int = 40
    interaction: str = "auto"
    transom: str = "auto"
    formulation: str = "full"
    wave_field: str = "incident"

    def __post_init__(self):
        for name, least, most in (("stations", 5, 201), ("panels", 8, 120), ("frequencies", 8, 200)):
            number = checked_number(
                f"{name} of strip theory", getattr(self, name), at_least=least, at_most=most
            )
            if number != int(number):
                raise InputError(f"{name} of strip theory must be a whole number, got {number:g}.")
        if self.panels % 2:
            raise InputError(f"panels of strip theory must be even, got {self.panels}; take one more.")
        checked_choice("interaction", self.interaction, INTERACTION)
        checked_choice("transom", self.transom, TRANSOM)
        checked_choice("formulation", self.formulation, FORMULATIONS)
        checked_choice("wave_field", self.wave_field, WAVE_FIELDS)
        if self.formulation == "heave-only" and self.interaction == "on":
            raise InputError(
                "interaction must be off or auto with the heave-only formulation, which takes each hull alone; "
                "choose the full formulation to solve the hulls together."
            )

    def interacts(self, count: int, speed: float, length: float) -> bool:
        """Whether the hulls are solved together at this speed."""
        if count == 1 or self.formulation == "heave-only":
            return False
        if self.interaction != "auto":
            return self.interaction == "on"
        return froude_number(speed, length) < LOW_FROUDE_NUMBER

    def as_dict(self) -> dict:
        """Return the settings as plain values."""
        return asdict(self)


def validity_warnings(settings: StripSettings, count: int, speed: float, length: float) -> tuple[str, ...]:
    """Sentences on what strip theory is not known to do right here."""
    froude = froude_number(speed, length)
    sentences = []
    if froude > HIGH_FROUDE_NUMBER:
        sentences.append(
            f"Fn {froude:.2f} is above {HIGH_FROUDE_NUMBER}: strip theory takes the waves of a hull to run out "
            "sideways at once, and is a rough guide there."
        )
    if count > 1 and froude > LOW_FROUDE_NUMBER:
        sentences.append(
            "On the measured Delft 372 catamaran at Fn 0.30 the heave peak of strip theory is 28 % low with each hull "
            "alone and 25 % high with both together."
        )
    if settings.interacts(count, speed, length):
        sentences.append(
            "Hull interaction is taken section by section: waves between the hulls cannot leave lengthwise, and "
            "their resonances are too sharp."
        )
    elif count > 1:
        sentences.append(
            "Each hull is solved alone: waves between the hulls are left out of the coefficients."
        )
    if count > 1 and settings.wave_field == "incident":
        sentences.append(
            "The water under the deck is the incident wave: what the hulls scatter is left out of it."
        )
    if settings.formulation == "heave-only":
        sentences.append(
            "Heave of single hulls only: surge, sway and yaw are not computed, and a hull's roll about its own "
            "axis is neglected."
        )
    else:
        sentences.append("Strip theory gives no added mass, damping or diffraction in surge.")
    return tuple(sentences)
