"""Commands of Chuang's prediction: ``workbench cross-structure`` of a design, ``slam-record`` of a record."""

import json
import sys
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from workbench import designs, pipeline
from workbench.command_inputs import (
    DesignArgument,
    FroudeOption,
    JsonOption,
    MethodOption,
    SpeedOption,
    speed_of,
    theory_of,
)
from workbench.conventions import FRESHWATER_DENSITY, KNOT
from workbench.errors import checked_number
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.impact.regular_wave import celerity
from workbench.quantities import warnings_of


def slam(
    design: DesignArgument,
    wave_height: Annotated[float, typer.Option(help="From trough to crest [m].")],
    wave_period: Annotated[float, typer.Option(help="Period of the wave [s].")],
    speed_knots: SpeedOption = None,
    froude: FroudeOption = None,
    method: MethodOption = "recommended",
    as_json: JsonOption = False,
) -> None:
    """Print Chuang's prediction of a slam on the cross structure in a regular head wave, and its design load."""
    from workbench.cross_structure import cross_structure
    from workbench.cross_structure_report import report_text, report_values

    ship = designs.design(design)
    speed = speed_of(ship, speed_knots, froude)
    response = pipeline.response(ship, speed, [np.pi], settings=theory_of(method, PotentialFlowSettings()))
    found = cross_structure(response, wave_period, wave_height)
    if as_json:
        print(json.dumps(report_values(found), allow_nan=False))
        return
    print(report_text(found))


COLUMNS = {
    "event_time": ("time [s]", 1.0),
    "attitude": ("pitch, bow up [deg]", 180 / np.pi),
    "wave_slope": ("wave slope [deg]", 180 / np.pi),
    "impact_angle": ("impact angle [deg]", 180 / np.pi),
    "normal_velocity": ("normal velocity [m/s]", 1.0),
    "recorded_pressure": ("recorded [kPa]", 1e-3),
    "peak_pressure": ("calculated [kPa]", 1e-3),
    "recorded_constant": ("k recorded [1]", 1.0),
    "pressure_constant": ("k prediction [1]", 1.0),
}
"""What is printed of each slam: label and factor from SI."""


def slam_record(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="CSV: time [s], pressure, pitch, heave, wave at a probe.")
    ],
    lever: Annotated[float, typer.Option(help="Gauge forward of the centre of gravity [m].")],
    probe_distance: Annotated[float, typer.Option(help="Wave probe ahead of the gauge [m].")],
    wave_period: Annotated[float, typer.Option(help="Period of the waves [s].")],
    least_pressure: Annotated[float, typer.Option(help="Peaks from here up are slams [kPa].")],
    speed_knots: Annotated[float, typer.Option("--speed-knots", help="Speed [kn].")] = 0.0,
    pressure: Annotated[str, typer.Option(help="Channel of the gauge [Pa].")] = "pressure",
    pitch: Annotated[str, typer.Option(help="Channel of pitch.")] = "pitch",
    heave: Annotated[str, typer.Option(help="Channel of heave of the centre of gravity, up.")] = "heave",
    wave: Annotated[str, typer.Option(help="Channel of the probe, up.")] = "wave",
    bow_down: Annotated[bool, typer.Option("--bow-down", help="Pitch is positive bow down.")] = False,
    window: Annotated[float, typer.Option(help="Half the stretch of a slope [s].")] = 0.01,
    density: Annotated[float, typer.Option(help="Of the water [kg/m3].")] = FRESHWATER_DENSITY,
    as_json: JsonOption = False,
) -> None:
    """Read the slams of a record and print their recorded and predicted pressures and k."""
    from workbench.impact.slam_table import predicted_slams
    from workbench.records.reading import read_record
    from workbench.records.slam_reduction import ReductionSettings, SlamChannels, reduced_slams

    checked_number("wave-period", wave_period, "s", above=0)
    settings = ReductionSettings(
        lever=lever,
        probe_distance=probe_distance,
        closing_speed=float(celerity(wave_period))
        + KNOT * checked_number("speed-knots", speed_knots, "kn", at_least=0),
        window=window,
        least_pressure=1e3 * least_pressure,
    )
    channels = SlamChannels(
        pressure=pressure, pitch=pitch, heave=heave, wave=wave, pitch_factor=-1.0 if bow_down else 1.0
    )
    found = predicted_slams(reduced_slams(read_record(file), settings, channels), density)
    columns = {label: (factor * found[name].values).tolist() for name, (label, factor) in COLUMNS.items()}
    notes = list(warnings_of(found))
    if as_json:
        print(
            json.dumps(
                {"slams": found.sizes["event"], "columns": columns, "warnings": notes}, allow_nan=False
            )
        )
        return
    if not found.sizes["event"]:
        print("No slam was found.")
    else:
        print("  ".join(columns))
    for row in zip(*columns.values(), strict=True):
        print("  ".join(f"{value:>{len(label)}.4g}" for label, value in zip(columns, row, strict=True)))
    for sentence in notes:
        print(f"warning: {sentence}", file=sys.stderr)
