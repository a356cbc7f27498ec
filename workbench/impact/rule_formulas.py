"""Design pressures of the rules for the wet deck, beside which computed pressures can be seen. For orientation.

The formulas are those of transcriptions, not of the rules themselves; each result says how it stands. A rule
pressure is a static design load that goes with the allowable stresses of its rule: it is no pressure of water.

.. [GL2012] Germanischer Lloyd, Rules for Classification and Construction, I-3-1, High Speed Craft, 2012, C3.5.4;
    the same in the UNITAS rules of GL, BV and RINA. As transcribed in R. Sevalho, "gl_hsc_scantling".
.. [ABSHSC] American Bureau of Shipping, Guide for Building and Classing High-Speed Craft, wet deck slamming.
    As transcribed in Cotecmar, "ABSHSC_ISO_scantlings" (there under cubierta principal).
.. [DNVHSLC] Det Norske Veritas, Rules for High Speed, Light Craft and Naval Surface Craft, Pt. 3 Ch. 1 Sec. 2,
    flat cross structures; recalled, not confirmed.
.. [LRSSC] Lloyd's Register, Rules for Special Service Craft, Pt. 5 Ch. 2, 6.2, impact pressure on
    the cross-deck; place and symbol confirmed, formula recalled, not confirmed.
.. [HSC2000] International Maritime Organization, International Code of Safety for High-Speed Craft, 2000, 1.4.30 and
    4.3.1.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY, KNOT, SEAWATER_DENSITY
from workbench.errors import InputError, checked_number

SEEN, RECALLED = "third-party transcription", "recalled, not confirmed"
GL_STATIONS, GL_FACTORS = (0.0, 0.2, 0.7, 0.8, 1.0), (0.5, 0.4, 0.4, 1.0, 1.0)
ABS_AREAS = (0.001, 0.005, 0.01, 0.05, 0.1, 0.5, 1.0)
ABS_FACTORS = (1.0, 0.86, 0.76, 0.47, 0.37, 0.235, 0.2)
ABS_LONG = 61.0
"""Length from which [ABSHSC]_ has another formula [m]."""
LIMITING_ACCELERATION = GRAVITY
"""Vertical acceleration at the centre of gravity above which [HSC2000]_ 4.3.1 wants no passenger craft [m/s2]."""
_KILOPASCAL = 1e3


@dataclass(frozen=True, kw_only=True)
class RuleInput:
    """What the rules ask of a ship, its panel and the sea.

    Parameters
    ----------
    length : of the waterline [m]; speed : [m/s]; displacement : [kg]; draught : [m].
    significant_wave_height : of the design [m]; air_gap : of the deck above still water [m].
    panel_area : of the plate or of what the stiffener carries [m2]; spacing : of the stiffeners [m].
    vertical_acceleration : design value at the centre of gravity [m/s2].
    stiffener : whether the pressure is for a stiffener, not a plate.
    deadrise, deadrise_at_centre : of the deck at the panel and at the centre of gravity [rad] ([GL2012]_ K3).
    distribution : longitudinal factors of [DNVHSLC]_ (k_t) and [LRSSC]_ (K_pc), which are not in the
        transcriptions [-].
    """

    length: float
    speed: float
    displacement: float
    draught: float
    significant_wave_height: float
    air_gap: float
    panel_area: float = 1.0
    spacing: float = 0.5
    vertical_acceleration: float = LIMITING_ACCELERATION
    stiffener: bool = False
    deadrise: float = 0.0
    deadrise_at_centre: float = 0.0
    distribution: float = 1.0

    def __post_init__(self):
        limits = {
            "length": ("m", {"above": 0, "at_most": 500}),
            "speed": ("m/s", {"above": 0, "at_most": 60}),
            "displacement": ("kg", {"above": 0, "at_most": 1e10}),
            "draught": ("m", {"above": 0, "at_most": 50}),
            "significant_wave_height": ("m", {"above": 0, "at_most": 30}),
            "air_gap": ("m", {"at_least": 0, "at_most": 100}),
            "panel_area": ("m2", {"above": 0, "at_most": 1e4}),
            "spacing": ("m", {"above": 0, "at_most": 50}),
            "vertical_acceleration": ("m/s2", {"above": 0, "at_most": 100}),
            "deadrise": ("rad", {"at_least": 0, "below": np.pi / 2}),
            "deadrise_at_centre": ("rad", {"at_least": 0, "below": np.pi / 2}),
            "distribution": ("", {"above": 0, "at_most": 2}),
        }
        for name, (unit, limit) in limits.items():
            number = checked_number(f"{name} of the rule", getattr(self, name), unit, **limit)
            object.__setattr__(self, name, number)
        if not isinstance(self.stiffener, bool):
            raise InputError(f"stiffener must be true or false, got {self.stiffener!r}.")


@dataclass(frozen=True, kw_only=True)
class RulePressure:
    """One rule at one place: where the formula stands, how sure it is, and the pressure.

    Parameters
    ----------
    key : short name; society, rule, edition, reference : which formula, and its place.
    standing : `SEEN` or `RECALLED`; applicability : range of the formula in words.
    pressure : [Pa]; warnings : sentences on what lies outside the range or was assumed.
    """

    key: str
    society: str
    rule: str
    edition: str
    reference: str
    standing: str
    applicability: str
    pressure: float
    warnings: tuple[str, ...] = ()


def rule_rows(given: RuleInput, station: float) -> tuple[RulePressure, ...]:
    """Wet-deck pressure by each rule at one station.

    Parameters
    ----------
    given : ship, panel and sea; station : distance from the aft end of the waterline over its length [-]. Ahead of
        the ends of the waterline the factors are those of its ends.
    """
    station = checked_number("station x/L", station, at_least=-0.5, at_most=1.5)
    common = _common_notes(given)
    rows = (_gl(given, station), _abs(given, station), _dnv(given), _lr(given))
    return tuple(RulePressure(**{**row, "warnings": (*row["warnings"], *common)}) for row in rows)


def gl_impact_velocity(significant_wave_height: float, length: float) -> float:
    """Relative velocity 4 Hs/sqrt(L) + 1 of [GL2012]_ and [ABSHSC]_ below 61 m, m and m/s as they print it."""
    return 4.0 * significant_wave_height / np.sqrt(length) + 1.0


def gl_pressure(given: RuleInput, station: float, area_factor: float, deadrise_factor: float) -> float:
    """Pressure 3 K2 K3 K_WD V V_REL (1 - 0.85 H_A/H_S) of [GL2012]_ for given K2 and K3 [Pa]; 0 beyond its air gap."""
    along = np.interp(station, GL_STATIONS, GL_FACTORS)
    velocity = gl_impact_velocity(given.significant_wave_height, given.length)
    left = max(0.0, 1.0 - 0.85 * given.air_gap / given.significant_wave_height)
    knots = given.speed / KNOT
    return float(_KILOPASCAL * 3.0 * area_factor * deadrise_factor * along * knots * velocity * left)


def gl_area_factor(given: RuleInput) -> float:
    """K2 of [GL2012]_: less pressure on a larger area [-], not below 0.50 for a plate, 0.45 for a stiffener."""
    reference = 0.7 * (given.displacement / 1000.0 / 2) / given.draught
    power = (100.0 * given.panel_area / reference) ** 0.75
    least = 0.45 if given.stiffener else 0.50
    return float(max(least, 0.455 - 0.35 * (power - 1.7) / (power + 1.7)))


def abs_area_factor(given: RuleInput) -> float:
    """F_D of [ABSHSC]_ from design over reference area A_R = 6.95 W/d [-], 0.4 to 1.

    A_R in cm2 for W in kg and d in cm, which is the reference area of [GL2012]_ to 1 %.
    """
    reference = 6.95e-6 * given.displacement / given.draught
    area = given.panel_area if given.stiffener else min(given.panel_area, 2.5 * given.spacing**2)
    return float(np.clip(np.interp(area / reference, ABS_AREAS, ABS_FACTORS), 0.4, 1.0))


def _gl(given: RuleInput, station: float) -> dict:
    beta, centre = (
        float(np.clip(np.degrees(angle), 10.0, 30.0)) for angle in (given.deadrise, given.deadrise_at_centre)
    )
    pressure = gl_pressure(given, station, gl_area_factor(given), (70.0 - beta) / (70.0 - centre))
    notes = []
    ratio = given.speed / KNOT / np.sqrt(given.length)
    if given.vertical_acceleration <= GRAVITY and ratio <= 5.0:
        ahead = 0.8 if ratio < 4.5 else 0.7
        if station < ahead:
            notes.append(
                f"At this acceleration and speed GL, as transcribed, has wet-deck impact only forward of {ahead} L."
            )
    return {
        "key": "gl-hsc", "society": "Germanischer Lloyd", "rule": "High Speed Craft (UNITAS)", "edition": "2012",
        "reference": "C3.5.4, p = 3 K2 K3 K_WD V V_REL (1 - 0.85 H_A/H_S)", "standing": SEEN,
        "applicability": "wet decks of high-speed twin-hulled craft", "pressure": pressure, "warnings": tuple(notes),
    }  # fmt: skip


def _abs(given: RuleInput, station: float) -> dict:
    height = max(given.significant_wave_height, given.length / 12.0)
    along = np.interp(station, GL_STATIONS, GL_FACTORS)
    knots, area = given.speed / KNOT, abs_area_factor(given)
    is_long = given.length >= ABS_LONG
    if is_long:
        velocity = 5.0 * np.sqrt(height / given.length) + 1.0
        left = max(0.0, 1.0 - 0.35 * given.air_gap / height)
        pressure = 55.0 * area * along * knots**0.1 * velocity * left
        formula, words = "p = 55 F_D F_I V^0.1 V_I (1 - 0.35 h_a/h_1/3)", "lengths of 61 m and more"
    else:
        left = max(0.0, 1.0 - 0.85 * given.air_gap / height)
        pressure = 3.0 * area * along * knots * gl_impact_velocity(height, given.length) * left
        formula, words = "p = 30 N1 F_D F_I V V_I (1 - 0.85 h_a/h_1/3), N1 = 0.1", "lengths below 61 m"
    notes = []
    if height > given.significant_wave_height:
        notes.append(
            f"ABS takes a significant height of at least L/12, here {height:.3g} m instead of "
            f"{given.significant_wave_height:.3g} m."
        )
    return {
        "key": "abs-hsc", "society": "American Bureau of Shipping", "rule": "High-Speed Craft",
        "edition": "of the transcription, not stated", "reference": f"wet deck slamming, {formula}",
        "standing": SEEN, "applicability": words, "pressure": float(_KILOPASCAL * pressure),
        "warnings": tuple(notes),
    }  # fmt: skip


def _dnv(given: RuleInput) -> dict:
    length = given.length
    limit = 0.22 * length * (0.3 - 0.8 * length / 1000.0)
    left = max(0.0, 1.0 - given.air_gap / limit) if limit > 0 else 0.0
    loading = (given.displacement / 1000.0 / given.panel_area) ** 0.3
    pressure = 2.6 * given.distribution * loading * given.vertical_acceleration * left
    notes = ["DNV's longitudinal factor k_t is not in the source of the formula: the one given is used."]
    if limit <= 0:
        notes.append(f"DNV's limit of the clearance is not above 0 for a length of {length:.4g} m.")
    return {
        "key": "dnv-hslc", "society": "Det Norske Veritas", "rule": "High Speed, Light Craft", "edition": "not known",
        "reference": "Pt. 3 Ch. 1 Sec. 2, p = 2.6 k_t (Delta/A)^0.3 a_cg (1 - H_C/H_L)", "standing": RECALLED,
        "applicability": "flat cross structures of catamarans", "pressure": float(_KILOPASCAL * pressure),
        "warnings": tuple(notes),
    }  # fmt: skip


def _lr(given: RuleInput) -> dict:
    height = given.significant_wave_height
    velocity = 8.0 * height / np.sqrt(given.length) + 2.0
    left = max(0.0, 1.0 - given.air_gap / height)
    pressure = given.distribution / 3.0 * velocity * given.speed / KNOT * left
    return {
        "key": "lr-ssc", "society": "Lloyd's Register", "rule": "Special Service Craft", "edition": "not known",
        "reference": "Pt. 5 Ch. 2, 6.2, P_pc = (1/3) K_pc V_R V (1 - G_A/H_03)", "standing": RECALLED,
        "applicability": "cross-decks of multi-hulled craft", "pressure": float(_KILOPASCAL * pressure),
        "warnings": (
            "LR's factor is recalled as 1/3 or 1/6, the greater is taken; its K_pc is not in the source of the "
            "formula: the one given is used.",
        ),
    }  # fmt: skip


def _common_notes(given: RuleInput) -> tuple[str, ...]:
    least = 3.7 * (given.displacement / SEAWATER_DENSITY) ** 0.1667
    if given.speed >= least:
        return ()
    return (
        f"The rules are for high-speed craft, of {least / KNOT:.3g} knots and more at this displacement (HSC Code "
        f"1.4.30), got {given.speed / KNOT:.3g} knots.",
    )
