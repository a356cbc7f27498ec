"""Command that simulates motions in time: ``workbench simulate``."""

import json
import sys
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from workbench import designs, pipeline, sea_energy, simulation_files
from workbench.command_inputs import (
    DesignArgument,
    FroudeOption,
    HeadingOption,
    InteractionOption,
    JsonOption,
    MethodOption,
    PanelsOption,
    PeakEnhancementOption,
    RunningSinkageOption,
    RunningTrimOption,
    SpectrumFileOption,
    SpectrumOption,
    SpeedOption,
    SpreadingOption,
    TreatmentOption,
    TunnelOption,
    progress_line,
    running_state_of,
    sea_state_of,
    settings_of,
    speed_of,
    theory_of,
    wave_direction_of,
)
from workbench.errors import InputError
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.seas import Condition
from workbench.simulation_stage import RADIATION_DIRECTIONS, one_theory, simulated_regular_wave, simulated_sea
from workbench.time_domain import Realisation


def points_of(text: str | None) -> tuple[tuple[float, float], ...]:
    """Read points x,y;x,y [m]."""
    if not text:
        return ()
    try:
        pairs = [tuple(float(part) for part in pair.split(",")) for pair in text.split(";") if pair.strip()]
    except ValueError:
        pairs = []
    if not pairs or any(len(pair) != 2 or not np.all(np.isfinite(pair)) for pair in pairs):
        raise InputError(f"points must be x,y;x,y in metres, for instance 20,0;25,-3, got {text!r}.")
    if len(pairs) > 200:
        raise InputError(f"points must be at most 200, got {len(pairs)}; choose fewer.")
    return tuple(pairs)


def simulate(
    design: DesignArgument,
    speed_knots: SpeedOption = None,
    froude: FroudeOption = None,
    heading_degrees: HeadingOption = 180.0,
    hs: Annotated[float | None, typer.Option("--hs", help="Significant wave height [m].")] = None,
    tp: Annotated[float | None, typer.Option("--tp", help="Peak period [s].")] = None,
    spectrum: SpectrumOption = "bretschneider",
    peak_enhancement: PeakEnhancementOption = 3.3,
    spectrum_file: SpectrumFileOption = None,
    spreading: SpreadingOption = None,
    regular_wave_amplitude: Annotated[
        float | None, typer.Option(help="Amplitude of a regular wave [m], instead of a sea.")
    ] = None,
    omega: Annotated[float | None, typer.Option(help="Frequency of the regular wave [rad/s].")] = None,
    hours: Annotated[float, typer.Option(help="Length of the record [h].")] = 1.0,
    seed: Annotated[int, typer.Option(help="Seed of the realisation.")] = 1,
    time_step: Annotated[
        float | None, typer.Option(help="Time step [s]; 1/20 s at full scale if left out.")
    ] = None,
    non_linear: Annotated[
        bool, typer.Option("--non-linear/--linear", help="Forces on the hull as it is wet, or linear ones.")
    ] = True,
    points: Annotated[
        str | None, typer.Option(help="Points x,y;x,y [m] whose relative motion is wanted.")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="File of the records, .csv or .nc.")] = None,
    method: MethodOption = "recommended",
    panels: PanelsOption = 1000,
    interaction: InteractionOption = "auto",
    speed_treatment: TreatmentOption = "encounter-frequency",
    tunnel_damping: TunnelOption = 0.0,
    running_trim_degrees: RunningTrimOption = 0.0,
    running_sinkage: RunningSinkageOption = 0.0,
    as_json: JsonOption = False,
) -> None:
    """Motions in time, in an irregular sea or a regular wave, with linear or non-linear forces."""
    chosen = designs.design(design)
    speed = speed_of(chosen, speed_knots, froude)
    direction = wave_direction_of(heading_degrees)
    places = points_of(points)
    if out is not None:
        simulation_files.checked_path(out)
    theory = theory_of(method, settings_of(panels, interaction, speed_treatment, tunnel_damping))
    state = running_state_of(chosen, running_trim_degrees, running_sinkage)

    def respond(directions, frequencies):
        return pipeline.response(
            chosen, speed, directions, frequencies, settings, running_state=state, progress=progress_line()
        )

    regular = regular_wave_amplitude is not None or omega is not None
    if regular and (regular_wave_amplitude is None or omega is None or hs is not None or tp is not None):
        raise InputError(
            "waves must be given once: either --hs and --tp, or --regular-wave-amplitude and --omega."
        )
    directions = [direction]
    if not regular:
        sea = sea_state_of(hs, tp, spectrum, peak_enhancement, spectrum_file, spreading)
        condition = Condition(speed=speed, wave_direction=direction, sea_state=sea)
        directions = sea_energy.directions_for(condition)
    settings = one_theory(theory, chosen.hull.length, speed, directions)
    head_seas_do = isinstance(settings, HighSpeedSettings)
    common = {
        "forces": "non-linear" if non_linear else "linear",
        "points": places,
        "radiation_directions": RADIATION_DIRECTIONS[1:] if head_seas_do else RADIATION_DIRECTIONS,
        "progress": progress_line(),
    }
    realisation = Realisation(seed=seed, hours=hours, time_step=time_step)
    if regular:
        records = simulated_regular_wave(
            chosen, speed, direction, regular_wave_amplitude, omega, respond, hours=hours, time_step=time_step, **common
        )  # fmt: skip
    else:
        records = simulated_sea(chosen, condition, realisation, respond, **common)
    values = simulation_files.summary(records)
    if out is not None:
        values["out"] = str(simulation_files.write_records(records, out))
    if as_json:
        print(json.dumps(values, allow_nan=False))
        return
    print(simulation_files.summary_text(values))
    for sentence in values["warnings"]:
        print(f"warning: {sentence}", file=sys.stderr)


COMMANDS = (simulate,)
