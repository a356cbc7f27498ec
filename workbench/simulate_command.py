"""Command that simulates motions in time: ``workbench simulate``."""

import json
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
import xarray as xr

from workbench import designs, pipeline, quantities, sea_energy, simulation_files
from workbench.command_inputs import (
    DesignArgument,
    FroudeOption,
    HeadingOption,
    InteractionOption,
    JsonOption,
    PanelsOption,
    SpeedOption,
    TreatmentOption,
    TunnelOption,
    progress_line,
    settings_of,
    spectrum_table_of,
    speed_of,
    wave_direction_of,
)
from workbench.conventions import GRAVITY
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.pipeline import Response
from workbench.seas import Condition, SeaState
from workbench.simulation.records import ShipInWaves, simulation
from workbench.time_domain import Realisation, components_from, wave_components

Respond = Callable[[Sequence[float], np.ndarray | None], Response]
"""Response of the ship for wave directions [rad] and wave frequencies [rad/s] (None: the usual ones)."""

RADIATION_DIRECTIONS = np.pi / 2, np.pi
"""Headings that tell, beside the wanted one, of the radiation forces at speed over frequency [rad]."""

_SHORT_OF_OVERTAKING = 0.9
_WAVES_OVERTAKING = 150  # frequencies times headings: enough for the stored potentials to serve


def simulated_sea(
    design: Design,
    condition: Condition,
    realisation: Realisation,
    respond: Respond,
    *,
    forces: str = "non-linear",
    points: Sequence[tuple[float, float]] = (),
    radiation_directions: Sequence[float] = RADIATION_DIRECTIONS,
    progress: Callable[[float, str], None] = pipeline.silent,
) -> xr.Dataset:
    """Records of a ship in a realisation of a sea; parameters as `simulation`.

    Parameters
    ----------
    respond : makes the linear response of the design at the speed of the condition, by any method;
        its ``hydrodynamics``, ``motions`` and ``wave_field`` are read, and ``additions`` where it has them.
    radiation_directions : further headings that a non-linear simulation at speed asks for [rad]; with a
        method that is dear, head seas alone do.
    """
    directions = sea_energy.directions_for(condition)
    found = _response(design, condition.speed, directions, forces, respond, radiation_directions)
    lowest, highest = float(found.motions.omega[0]), float(found.motions.omega[-1])
    components = wave_components(condition, realisation, lowest, highest)
    energy = sea_energy.wave_energy(
        condition,
        found.motions.omega,
        found.motions.wave_direction.sel(wave_direction=directions, method="nearest"),
    )
    made = _records(
        design, found, components, realisation.hours * 3600, realisation.time_step, forces, points, progress
    )
    sea = condition.sea_state
    made.attrs["seed"] = int(realisation.seed)
    made.attrs["waves"] = (
        f"{sea.spectrum} sea, Hs {sea.significant_wave_height:g} m, Tp {sea.peak_period:.4g} s, "
        f"heading {np.degrees(condition.wave_direction):g} degrees"
    )
    made.attrs["warnings"] = quantities.joined_warnings(
        [*quantities.warnings_of(made), *sea_energy.band_notes(energy, condition)]
    )
    return made


def simulated_regular_wave(
    design: Design,
    speed: float,
    wave_direction: float,
    amplitude: float,
    omega: float,
    respond: Respond,
    *,
    hours: float,
    time_step: float | None = None,
    forces: str = "non-linear",
    points: Sequence[tuple[float, float]] = (),
    radiation_directions: Sequence[float] = RADIATION_DIRECTIONS,
    progress: Callable[[float, str], None] = pipeline.silent,
) -> xr.Dataset:
    """Records of a ship in a regular wave of an amplitude [m] and wave frequency [rad/s]; else as `simulated_sea`."""
    checked_number("regular-wave-amplitude", amplitude, "m", above=0, at_most=30)
    checked_number("omega", omega, "rad/s", above=0, at_most=100)
    steepness = 2 * amplitude * omega**2 / GRAVITY / (2 * np.pi)
    if steepness > 1 / 7:
        most = GRAVITY * np.pi / (7 * omega**2)
        raise InputError(
            f"regular-wave-amplitude must be <= {most:.3g} m at omega {omega:g} rad/s, got {amplitude:g} m; steeper "
            "waves break: lower it or take a longer wave."
        )
    found = _response(design, speed, [wave_direction], forces, respond, radiation_directions)
    _check_covered(omega, found.motions.omega.values)
    components = components_from(omega, amplitude, 0.0, wave_direction, speed)
    made = _records(design, found, components, hours * 3600, time_step, forces, points, progress)
    made.attrs["waves"] = (
        f"regular waves of {amplitude:g} m amplitude, omega {omega:g} rad/s, heading "
        f"{np.degrees(wave_direction):g} degrees"
    )
    return made


def _response(
    design: Design,
    speed: float,
    directions,
    forces: str,
    respond: Respond,
    radiation_directions: Sequence[float],
) -> Response:
    """Response at the wanted directions, and at those of the radiation where a simulation needs them.

    With a method that refuses waves that the ship overtakes, those are left out.
    """
    wanted = np.asarray(directions, float)
    more = tuple(radiation_directions) if forces == "non-linear" and speed > 0 else ()
    together = np.unique(np.round(np.mod(np.concatenate([wanted, more]), 2 * np.pi), 12))
    along = speed * float(np.cos(wanted).max())
    try:
        return respond(together, None)
    except InputError:
        if along <= 0:
            raise
    usual = respond([np.pi], None).motions.omega.values
    top = min(_SHORT_OF_OVERTAKING * GRAVITY / along, usual[-1])
    if top <= 2 * usual[0]:
        raise InputError(
            f"speed must be below that of the waves for a simulation, at {speed:.4g} m/s and this heading the ship "
            "overtakes nearly all of them; lower the speed, or choose a heading of 90 to 270 degrees."
        )
    count = max(len(usual), -(-_WAVES_OVERTAKING // len(together)))
    return respond(together, np.linspace(usual[0], top, count))


def _check_covered(omega: float, computed: np.ndarray) -> None:
    """Refuse a wave frequency beyond the computed ones."""
    if not computed[0] <= omega <= computed[-1]:
        raise InputError(
            f"omega must be {computed[0]:.3g} to {computed[-1]:.3g} rad/s for this ship, speed and heading, got "
            f"{omega:g} rad/s; take a wave among these."
        )


def _records(
    design, found: Response, components, duration, time_step, forces, points, progress
) -> xr.Dataset:
    """Records of a response in given waves."""
    ship = ShipInWaves(
        design, found.hydrodynamics, found.motions, found.wave_field, tuple(getattr(found, "additions", ()))
    )
    step = time_step or pipeline.time_step(design.hull.length)
    return simulation(ship, components, duration, step, forces=forces, points=points, progress=progress)


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
    spectrum: Annotated[
        str, typer.Option(help="bretschneider, jonswap or pierson-moskowitz.")
    ] = "bretschneider",
    peak_enhancement: Annotated[float, typer.Option(help="gamma of jonswap.")] = 3.3,
    spectrum_file: Annotated[
        Path | None, typer.Option(help="Measured spectrum: lines of omega, ordinate; scaled to --hs.")
    ] = None,
    spreading: Annotated[
        float | None, typer.Option(help="n of cos**n spreading; long-crested if left out.")
    ] = None,
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
    panels: PanelsOption = 1000,
    interaction: InteractionOption = "auto",
    speed_treatment: TreatmentOption = "encounter-frequency",
    tunnel_damping: TunnelOption = 0.0,
    as_json: JsonOption = False,
) -> None:
    """Motions in time, in an irregular sea or a regular wave, with linear or non-linear forces."""
    chosen = designs.design(design)
    speed = speed_of(chosen, speed_knots, froude)
    direction = wave_direction_of(heading_degrees)
    places = points_of(points)
    if out is not None:
        simulation_files.checked_path(out)
    settings = settings_of(panels, interaction, speed_treatment, tunnel_damping)

    def respond(directions, frequencies):
        return pipeline.response(chosen, speed, directions, frequencies, settings, progress=progress_line())

    common = {
        "forces": "non-linear" if non_linear else "linear",
        "points": places,
        "progress": progress_line(),
    }
    realisation = Realisation(seed=seed, hours=hours, time_step=time_step)
    if regular_wave_amplitude is None and omega is None:
        sea = SeaState(
            significant_wave_height=hs,
            peak_period=tp,
            spectrum="user" if spectrum_file else spectrum,
            peak_enhancement=peak_enhancement,
            table=spectrum_table_of(spectrum_file),
            spreading_exponent=spreading,
        )
        condition = Condition(speed=speed, wave_direction=direction, sea_state=sea)
        records = simulated_sea(chosen, condition, realisation, respond, **common)
    else:
        if regular_wave_amplitude is None or omega is None or hs is not None or tp is not None:
            raise InputError(
                "waves must be given once: either --hs and --tp, or --regular-wave-amplitude and --omega."
            )
        records = simulated_regular_wave(
            chosen, speed, direction, regular_wave_amplitude, omega, respond, hours=hours, time_step=time_step, **common
        )  # fmt: skip
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
