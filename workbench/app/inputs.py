"""The inputs of the app: names, labels with units, ranges and choices, in the order of the page."""

from typing import Any

from workbench.app.control import Input, number_input, rounded_to
from workbench.app.deck_pressure_inputs import DECK_PRESSURE_DEFAULTS, deck_pressure_inputs
from workbench.app.method_inputs import METHOD_DEFAULTS, method_inputs
from workbench.app.running_inputs import RUNNING_DEFAULTS, running_inputs
from workbench.app.ship_inputs import clearance_input, ship_inputs
from workbench.design import Design
from workbench.impact.pressure import LAWS
from workbench.seas import SPECTRA, sea_presets

OWN_SEA = "own"
NO_CHOICE = ""

GROUPS = (
    ("design", "Design", True),
    ("run", "Speed and heading", True),
    ("sea", "Sea", True),
    ("slams", "Criterion and slams", True),
    ("deck", "More of the wet deck", False),
    ("hull", "Hulls", False),
    ("masses", "Masses", False),
    ("running", "Attitude at speed", False),
    ("sails", "Wind and sails", False),
    ("pressure", "Pressure over the deck", False),
    ("method", "Method", False),
)
"""Groups: key, heading, whether open at first."""

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
    **METHOD_DEFAULTS,
    **RUNNING_DEFAULTS,
    **DECK_PRESSURE_DEFAULTS,
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


def inputs_for(design: Design) -> tuple[Input, ...]:
    """All controls for a design; ranges of sliders follow its size."""
    length = design.hull.length
    froude = (9.80665 * length) ** 0.5 / 0.514444
    number = number_input
    found: list[Input] = [] if design.wet_deck is None else [clearance_input(design)]
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
    others = (ship_inputs, running_inputs, deck_pressure_inputs, method_inputs)
    return (*found, *(one for inputs in others for one in inputs(design)))
