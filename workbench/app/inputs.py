"""The inputs of the app: names, labels with units, ranges and choices, in the order of the page."""

from dataclasses import dataclass, field
from typing import Any

from workbench.design import Design
from workbench.impact.pressure import LAWS
from workbench.seas import SPECTRA, sea_presets

OWN_SEA = "own"
NO_CHOICE = ""


@dataclass(frozen=True, kw_only=True)
class Input:
    """One control of the page.

    Parameters
    ----------
    name : of the input; label : its words, with the unit.
    group : the heading under which it stands.
    kind : "number" or "choice".
    low, high, step : of the slider beside a number; None leaves the slider out.
    choices : pairs (value, words) of a choice.
    phrases : words by which a refused input names this control.
    shown_if : pairs (name of another input, allowed values); all must hold.
    """

    name: str
    label: str
    group: str
    kind: str = "number"
    low: float | None = None
    high: float | None = None
    step: float | None = None
    choices: tuple[tuple[str, str], ...] = ()
    phrases: tuple[str, ...] = ()
    shown_if: tuple[tuple[str, tuple[str, ...]], ...] = field(default=())

    def as_dict(self) -> dict[str, Any]:
        """Return what the page needs to draw the control."""
        return {
            "name": self.name, "label": self.label, "group": self.group, "kind": self.kind, "low": self.low,
            "high": self.high, "step": self.step, "choices": [list(pair) for pair in self.choices],
            "shown_if": [[name, list(values)] for name, values in self.shown_if],
        }  # fmt: skip


GROUPS = (
    ("design", "Design", True),
    ("run", "Speed and heading", True),
    ("sea", "Sea", True),
    ("slams", "Criterion and slams", True),
    ("deck", "More of the wet deck", False),
    ("hull", "Hulls", False),
    ("masses", "Masses", False),
)
"""Groups: key, heading, whether open at first."""

DECK_LENGTHS = (
    "deck_aft", "deck_fore", "deck_width", "entry_length", "entry_rise", "camber", "vee_depth", "vee_width",
    "corner_radius",
)  # fmt: skip

CONDITION_DEFAULTS: dict[str, Any] = {
    "heading_degrees": 180.0,
    "preset": OWN_SEA,
    "period_kind": "peak",
    "spectrum": "bretschneider",
    "peak_enhancement": 3.3,
    "spreading": NO_CHOICE,
    "threshold_kind": "none",
    "threshold": 1.0,
    "criterion": 20.0,
    "hours": 1.0,
    "law": "chuang",
    "coefficient": 50.0,
    "seed": 1,
}

_LAW_WORDS = {
    "chuang": "Chuang (as in the source's program)",
    "chuang-text": "Chuang (as printed)",
    "wagner": "Wagner",
    "panel": "given coefficient k",
}
_SPECTRUM_WORDS = {
    "bretschneider": "Bretschneider (ITTC)",
    "jonswap": "JONSWAP",
    "pierson-moskowitz": "Pierson-Moskowitz",
}


def rounded_to(value: float, digits: int = 2) -> float:
    """Value rounded to a number of significant digits."""
    return float(f"{value:.{digits}g}")


def slider_step(span: float) -> float:
    """Step of a slider: 1, 2 or 5 times a power of ten, some 100 to 250 to the span."""
    wanted = max(span, 1e-9) / 200
    power = 10.0 ** (len(f"{wanted:.0f}") - 1) if wanted >= 1 else 10.0 ** -_leading_zeros(wanted)
    for factor in (1, 2, 5, 10):
        if factor * power >= wanted:
            return rounded_to(factor * power, 1)
    return rounded_to(10 * power, 1)


def _leading_zeros(value: float) -> int:
    """Number of the first decimal of a value below 1 that is not 0."""
    return int(f"{value:e}".split("e-")[1]) if "e-" in f"{value:e}" else 0


def inputs_for(design: Design) -> tuple[Input, ...]:
    """All controls for a design; ranges of sliders follow its size."""
    length, deck, masses = design.hull.length, design.wet_deck, design.masses
    froude = (9.80665 * length) ** 0.5 / 0.514444

    def number(name, label, group, low, high, **others):
        step = others.pop("step", None) or slider_step(high - low)
        low = round(low / step) * step
        return Input(
            name=name, label=label, group=group, low=rounded_to(low, 10),
            high=rounded_to(round(high / step) * step, 10),
            step=step, **others,
        )  # fmt: skip

    found: list[Input] = []
    if deck is not None:
        found.append(
            number(
                "clearance", "Wet-deck clearance [m]", "design", 0.2 * deck.clearance, 2.5 * deck.clearance,
                phrases=("wet-deck clearance", "lowest point of the wet deck"),
            )
        )  # fmt: skip
    found += [
        number("speed_knots", "Speed [kn]", "run", 0, rounded_to(froude), phrases=("speed",)),
        number(
            "heading_degrees", "Heading [deg]", "run", 0, 180, step=15.0,
            phrases=("wave direction", "wave_direction", "heading", "overtak"),
        ),
        Input(
            name="preset", label="Sea", group="sea", kind="choice",
            choices=(
                (OWN_SEA, "as given below"),
                *(
                    (one.name, f"{one.name}: Hs {one.significant_wave_height:g} m, Tp {one.peak_period:g} s")
                    for one in sea_presets()
                ),
            ),
        ),
        number(
            "wave_height", "Significant height Hs [m]", "sea", 0.02 * rounded_to(length / 10),
            rounded_to(length / 8),
            phrases=("significant_wave_height",),
        ),
        Input(
            name="period_kind", label="Period given as", group="sea", kind="choice",
            choices=(
                ("peak", "peak period Tp"), ("mean", "mean period T01"), ("zero", "zero-crossing period T02"),
            ),
            shown_if=(("spectrum", ("bretschneider", "jonswap")),),
        ),
        number(
            "period", "Wave period [s]", "sea", 0.3 * length**0.5, 2.4 * length**0.5,
            phrases=("peak_period", "mean_period", "zero_crossing_period", "period"),
            shown_if=(("spectrum", ("bretschneider", "jonswap")),),
        ),
        Input(
            name="spectrum", label="Spectrum", group="sea", kind="choice",
            choices=tuple((name, _SPECTRUM_WORDS[name]) for name in SPECTRA if name in _SPECTRUM_WORDS),
        ),
        number(
            "peak_enhancement", "Peak enhancement γ [-]", "sea", 1, 10, step=0.1,
            phrases=("peak_enhancement",),
            shown_if=(("spectrum", ("jonswap",)),),
        ),
        Input(
            name="spreading", label="Spreading", group="sea", kind="choice", phrases=("spreading_exponent",),
            choices=((NO_CHOICE, "none (long-crested)"), ("2", "cos² over ±90°"), ("4", "cos⁴ over ±90°")),
        ),
        number(
            "criterion", "Criterion [slams per hour]", "slams", 1, 60, step=1.0, phrases=("criterion",),
        ),
        Input(
            name="threshold_kind", label="Least entry velocity", group="slams", kind="choice",
            choices=(
                ("none", "none: every entry counts"), ("ochi", "Ochi: 0.093 √(gL)"),
                ("value", "as given below"),
            ),
        ),
        number(
            "threshold", "Threshold velocity [m/s]", "slams", 0, 6, step=0.05, phrases=("threshold",),
            shown_if=(("threshold_kind", ("value",)),),
        ),
        Input(
            name="law", label="Pressure law", group="slams", kind="choice",
            choices=tuple((name, _LAW_WORDS.get(name, name)) for name in LAWS),
        ),
        number(
            "coefficient", "Coefficient k [-]", "slams", 1, 300, step=1.0, phrases=("coefficient",),
            shown_if=(("law", ("panel",)),),
        ),
        Input(name="hours", label="Hours of exposure [h]", group="slams", phrases=("hours",), step=0.5),
        Input(name="seed", label="Seed of the realisation [-]", group="slams", phrases=("seed",), step=1),
    ]  # fmt: skip
    if deck is not None:
        found += _deck_inputs(design, number)
    if design.hull.count > 1:
        found.append(
            number(
                "spacing", "Spacing of the hulls' centre planes [m]", "hull", 1.05 * design.hull.shape.beam,
                2 * design.hull.spacing,
                phrases=("spacing",),
            )
        )  # fmt: skip
    tonnes = masses.mass / 1e3
    found += [
        number("mass", "Mass [t]", "masses", 0.8 * tonnes, 1.2 * tonnes, phrases=("mass",)),
        number(
            "centre_height", "Centre of gravity above keel KG [m]", "masses", 0,
            4 * design.hull.shape.draught,
            phrases=("height of the centre", "z of the centre"),
        ),
        number(
            "centre_x", "Centre of gravity forward of amidships [m]", "masses", -0.15 * length, 0.15 * length,
            phrases=("x of the centre", "centre of gravity x"),
        ),
        *(
            number(
                f"{mode}_gyradius", f"{mode.capitalize()} gyradius [m]", "masses",
                0.3 * getattr(masses, f"{mode}_gyradius"),
                2 * getattr(masses, f"{mode}_gyradius"), phrases=(f"{mode} gyradius",),
            )
            for mode in ("roll", "pitch", "yaw")
        ),
    ]  # fmt: skip
    return tuple(found)


def _deck_inputs(design: Design, number) -> list[Input]:
    """Return the controls of the wet deck but for its clearance."""
    length, deck = design.hull.length, design.wet_deck
    span, height = deck.fore - deck.aft, deck.clearance
    rows = (
        ("deck_aft", "Aft end, x [m]", -0.6 * length, 0.4 * length, "aft end"),
        ("deck_fore", "Fore end, x [m]", -0.4 * length, 0.6 * length, "fore end"),
        ("deck_width", "Width [m]", 0.2 * deck.width, 1.5 * deck.width, "width of the wet deck"),
        ("entry_length", "Raked entry: length [m]", 0, span, "entry length"),
        ("entry_rise", "Raked entry: rise [m]", 0, 2 * height, "entry rise"),
        ("camber", "Camber [m]", 0, height, "camber"),
        ("vee_depth", "V of the pod: depth [m]", 0, height, "vee depth"),
        ("vee_width", "V of the pod: width [m]", 0, deck.width, "vee width"),
        ("corner_radius", "Corner radius [m]", 0, min(deck.width / 2, height), "corner radius"),
    )
    return [
        number(name, label, "deck", low, high, phrases=(phrase,)) for name, label, low, high, phrase in rows
    ]
