"""What the command line reads: its options, and the values they stand for."""

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from workbench.conventions import GRAVITY, KNOT, MODES
from workbench.design import Design
from workbench.errors import InputError, checked_choice, checked_number
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import METHODS, RecommendedSettings, TheorySettings
from workbench.hydrodynamics.settings import WAVE_FIELDS, PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.running_state import RunningState
from workbench.sailing import flies, sailing_design
from workbench.sails import TrueWind
from workbench.seas import SeaState

DesignArgument = Annotated[str, typer.Argument(metavar="DESIGN", help="A library name or a TOML file.")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]
SpeedOption = Annotated[float | None, typer.Option("--speed-knots", help="Speed [kn].")]
FroudeOption = Annotated[
    float | None, typer.Option("--froude", help="Froude number on the length, instead of knots.")
]
HeadingOption = Annotated[float, typer.Option("--heading-degrees", help="180 is head seas, 0 following.")]
PanelsOption = Annotated[int, typer.Option("--panels", help="Panels of the whole ship.")]
InteractionOption = Annotated[str, typer.Option("--interaction", help="Between the hulls: auto, on or off.")]
TreatmentOption = Annotated[
    str,
    typer.Option("--speed-treatment", help="encounter-frequency or forward-speed (Capytaine's own option)."),
]
MethodOption = Annotated[
    str, typer.Option("--method", help="recommended, strip, high-speed or potential-flow.")
]
HeelOption = Annotated[
    float,
    typer.Option("--heel-degrees", help="Heel, starboard side down; the ship floats at her displacement."),
]
WindOption = Annotated[
    float | None, typer.Option("--wind-speed", help="True wind [m/s] going where the waves go, on the sails.")
]
LockOption = Annotated[
    str, typer.Option("--lock", help="Modes held at zero, such as roll or surge,sway,yaw.")
]
SpectrumOption = Annotated[str, typer.Option(help="bretschneider, jonswap or pierson-moskowitz.")]
PeakEnhancementOption = Annotated[float, typer.Option(help="gamma of jonswap.")]
SpectrumFileOption = Annotated[
    Path | None, typer.Option(help="Measured spectrum: lines of omega, ordinate; scaled to --hs.")
]
SpreadingOption = Annotated[
    float | None, typer.Option(help="n of cos**n spreading; long-crested if left out.")
]
WaveFieldOption = Annotated[
    str,
    typer.Option(
        "--wave-field", help="Water under the deck: auto, incident, or total (with the hulls' waves)."
    ),
]
RunningTrimOption = Annotated[
    float,
    typer.Option("--running-trim-degrees", help="Trim at speed beyond that at rest, bow down positive."),
]
RunningSinkageOption = Annotated[
    float,
    typer.Option("--running-sinkage", help="Sinkage at speed of the centre of gravity [m], down positive."),
]
TunnelOption = Annotated[
    float, typer.Option("--tunnel-damping", help="Damping of the water between the hulls, 0 to 0.2.")
]


def speed_of(design: Design, speed_knots: float | None, froude: float | None) -> float:
    """Speed [m/s] from knots or a Froude number, exactly one of which is given."""
    if (speed_knots is None) == (froude is None):
        raise InputError("speed must be given once: either --speed-knots or --froude.")
    if froude is not None:
        checked_number("froude", froude, at_least=0, at_most=3)
        return froude * float(np.sqrt(GRAVITY * design.hull.length))
    return checked_number("speed-knots", speed_knots, "kn", at_least=0, at_most=100) * KNOT


def wave_direction_of(heading_degrees: float) -> float:
    """Wave direction [rad] from a heading in degrees, 0 to 360."""
    return float(
        np.radians(
            checked_number(
                "heading-degrees",
                heading_degrees,
                "degrees",
                at_least=0,
                at_most=360,
                cure="180 is head seas",
            )
        )
    )


def settings_of(
    panels: int, interaction: str, speed_treatment: str, tunnel_damping: float
) -> PotentialFlowSettings:
    """Settings of the potential-flow method."""
    return PotentialFlowSettings(
        panels=panels,
        interaction=interaction,
        speed_treatment=speed_treatment,
        tunnel_damping=tunnel_damping,
    )


def theory_of(method: str, panel_settings: PotentialFlowSettings, wave_field: str = "auto") -> TheorySettings:
    """Settings of the theory that is asked for.

    Interaction between the hulls and ``wave_field`` (auto, incident or total; auto is incident except for the
    panel method at rest) go to every theory, the rest of ``panel_settings`` to the panel method.
    """
    checked_choice("method", method, METHODS)
    checked_choice("wave-field", wave_field, WAVE_FIELDS)
    panel_settings = replace(panel_settings, wave_field=wave_field)
    water = "total" if wave_field == "total" else "incident"
    both = {"interaction": panel_settings.interaction, "wave_field": water}
    strip, high_speed = StripSettings(**both), HighSpeedSettings(**both)
    if method == "strip":
        return strip
    if method == "high-speed":
        return high_speed
    if method == "potential-flow":
        return panel_settings
    return RecommendedSettings(potential_flow=panel_settings, strip=strip, high_speed=high_speed)


def heeled_design(design: Design, heel_degrees: float) -> Design:
    """Design at a heel, starboard side down, risen or sunk to its displacement."""
    heel = checked_number("heel-degrees", heel_degrees, "degrees", at_least=-30, at_most=30)
    return sailing_design(design, float(np.radians(heel))) if heel else design


def running_state_of(
    design: Design,
    running_trim_degrees: float = 0.0,
    running_sinkage: float = 0.0,
    wind_speed: float | None = None,
    lock: str = "",
) -> RunningState:
    """Attitude at speed, wind on the sails, and the modes that are held; roll always where a hull flies."""
    trim = checked_number(
        "running-trim-degrees",
        running_trim_degrees,
        "degrees",
        at_least=-10,
        at_most=10,
        cure="positive bow down",
    )
    held = [mode for mode in lock.replace(" ", "").split(",") if mode]
    for mode in held:
        checked_choice("lock", mode, MODES, cure="separate several by commas")
    if flies(design) and "roll" not in held:
        held.append("roll")
    return RunningState(
        running_trim=float(np.radians(trim)),
        running_sinkage=running_sinkage,
        wind=None if wind_speed is None else TrueWind(speed=wind_speed),
        locked=tuple(held),
    )


def frequencies_of(
    design: Design, omega: str | None, wavelength_ratio: str | None
) -> tuple[np.ndarray, bool]:
    """Wave frequencies [rad/s] and whether the wavelengths were asked for (so that they shall rise)."""
    if (omega is None) == (wavelength_ratio is None):
        raise InputError(
            "frequencies must be given once: either --omega LO:HI:N or --wavelength-ratio LO:HI:N."
        )
    if omega is not None:
        return numbers_of_range("omega", omega, "rad/s"), False
    ratios = numbers_of_range("wavelength-ratio", wavelength_ratio, "")
    return np.sqrt(2 * np.pi * GRAVITY / (ratios * design.hull.length)), True


def numbers_of_range(name: str, text: str, unit: str) -> np.ndarray:
    """Read LO:HI:N."""
    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(f"{name} must be LO:HI:N, for instance 0.5:2:16, got {text!r}.")
    try:
        low, high, count = float(parts[0]), float(parts[1]), int(parts[2])
    except ValueError:
        raise InputError(f"{name} must be two numbers and a whole number LO:HI:N, got {text!r}.") from None
    checked_number(f"lowest {name}", low, unit, above=0)
    checked_number(f"highest {name}", high, unit, at_least=low)
    checked_number(f"number of {name} values", count, at_least=1, at_most=500)
    if (count > 1) == (high == low):
        raise InputError(
            f"{name} must have a highest value above its lowest and N > 1, or both equal and N = 1."
        )
    return np.linspace(low, high, count)


def number_or_word(text: str) -> str | float:
    """Return "ochi", or a number."""
    if text == "ochi":
        return text
    try:
        return float(text)
    except ValueError:
        raise InputError(f"threshold must be 0, ochi or a velocity in m/s, got {text!r}.") from None


def deck_points_of(text: str) -> tuple[int, int]:
    """Read NXxNY."""
    parts = text.lower().split("x")
    if len(parts) != 2 or not all(part.isdigit() and 1 <= int(part) <= 400 for part in parts):
        raise InputError(f"deck-points must be two whole numbers from 1 to 400 such as 40x10, got {text!r}.")
    return int(parts[0]), int(parts[1])


def sea_state_of(
    significant_wave_height: float | None,
    peak_period: float | None,
    spectrum: str,
    peak_enhancement: float,
    spectrum_file: Path | None,
    spreading: float | None,
) -> SeaState:
    """Sea of the options; a measured spectrum takes the place of the named one."""
    return SeaState(
        significant_wave_height=significant_wave_height,
        peak_period=peak_period,
        spectrum="user" if spectrum_file else spectrum,
        peak_enhancement=peak_enhancement,
        table=spectrum_table_of(spectrum_file),
        spreading_exponent=spreading,
    )


def spectrum_table_of(path: Path | None) -> tuple[tuple[float, float], ...]:
    """Read a measured spectrum: lines of omega [rad/s] and ordinate [m2 s/rad], by comma or blank, # for remarks."""
    if path is None:
        return ()
    try:
        text = Path(path).read_text(encoding="utf-8")
        lines = [line.split("#")[0].replace(",", " ").split() for line in text.splitlines()]
        rows = [tuple(float(part) for part in line) for line in lines if line]
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            f"spectrum-file must be a readable text file, got {path}: {error}; check the path."
        ) from error
    except ValueError as error:
        raise InputError(f"spectrum-file must hold two numbers a line, got {path}: {error}.") from error
    if any(len(row) != 2 for row in rows):
        raise InputError(
            f"spectrum-file must hold two numbers a line (omega, ordinate), {path} has other lines."
        )
    return rows


def progress_line() -> Callable[[float, str], None]:
    """Progress on standard error, where a person is looking at it."""

    def told(fraction: float, message: str) -> None:
        if sys.stderr.isatty():
            ending = "\n" if fraction >= 1 else ""
            sys.stderr.write(f"\r  {100 * fraction:3.0f} %  {message:<40}{ending}")
            sys.stderr.flush()

    return told
