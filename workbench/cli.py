"""Command line: the same numbers as the app and the notebooks, for scripts and checks.

Every command that prints numbers takes ``--json`` and then prints one JSON
object and nothing else on standard output. A refused input is one sentence on
standard error and exit code 2.
"""

import sys
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from workbench import (
    __version__,
    conditions_command,
    cross_structure_command,
    design_commands,
    designs,
    entry_command,
    record_commands,
    simulate_command,
    slam_command,
    tables,
    tool_commands,
)
from workbench.command_inputs import (
    DesignArgument,
    FroudeOption,
    HeadingOption,
    HeelOption,
    InteractionOption,
    JsonOption,
    LockOption,
    MethodOption,
    PanelsOption,
    RunningSinkageOption,
    RunningTrimOption,
    SpeedOption,
    TreatmentOption,
    TunnelOption,
    WindOption,
    frequencies_of,
    heeled_design,
    progress_line,
    running_state_of,
    settings_of,
    speed_of,
    theory_of,
    wave_direction_of,
)
from workbench.design_commands import print_json, print_warnings
from workbench.errors import InputError

application = typer.Typer(
    help="Motions and wet-deck slamming of catamarans: from hull and sea to slams, pressure and clearance.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def main() -> None:
    """Run the command line; a refused input is one sentence and exit code 2."""
    try:
        application()
    except InputError as error:
        print(f"workbench: {error}", file=sys.stderr)
        raise SystemExit(2) from None


@application.callback(invoke_without_command=True)
def version_option(
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """Print the version if asked to."""
    if version:
        print(__version__)
        raise typer.Exit


@application.command()
def rao(
    design: DesignArgument,
    method: MethodOption = "recommended",
    speed_knots: SpeedOption = None,
    froude: FroudeOption = None,
    heading_degrees: HeadingOption = 180.0,
    omega: Annotated[str | None, typer.Option(help="Wave frequencies LO:HI:N [rad/s].")] = None,
    wavelength_ratio: Annotated[str | None, typer.Option(help="Wavelengths over length LO:HI:N.")] = None,
    panels: PanelsOption = 1000,
    interaction: InteractionOption = "auto",
    speed_treatment: TreatmentOption = "encounter-frequency",
    tunnel_damping: TunnelOption = 0.0,
    running_trim_degrees: RunningTrimOption = 0.0,
    running_sinkage: RunningSinkageOption = 0.0,
    heel_degrees: HeelOption = 0.0,
    wind_speed: WindOption = None,
    lock: LockOption = "",
    as_json: JsonOption = False,
) -> None:
    """Motions per wave amplitude in regular waves."""
    from workbench import pipeline

    chosen = heeled_design(designs.design(design), heel_degrees)
    speed = speed_of(chosen, speed_knots, froude)
    direction = wave_direction_of(heading_degrees)
    frequencies, ratios_rise = frequencies_of(chosen, omega, wavelength_ratio)
    settings = theory_of(method, settings_of(panels, interaction, speed_treatment, tunnel_damping))
    ship = pipeline.response(
        chosen,
        speed,
        [direction],
        np.sort(frequencies),
        settings,
        running_state=running_state_of(chosen, running_trim_degrees, running_sinkage, wind_speed, lock),
        progress=progress_line(),
    )
    values = tables.motion_table(ship, descending=ratios_rise)
    if as_json:
        print_json(values)
    else:
        print(tables.motion_text(values))
        print_warnings(values["warnings"])


@application.command()
def run(
    design: DesignArgument,
    out: Annotated[Path, typer.Option("--out", help="Folder for the results; made if it is missing.")],
    speed_knots: SpeedOption = None,
    froude: FroudeOption = None,
    heading_degrees: HeadingOption = 180.0,
    hs: Annotated[
        float | None, typer.Option("--hs", help="Significant wave height [m]; L/25 if left out.")
    ] = None,
    tp: Annotated[
        float | None, typer.Option("--tp", help="Peak period [s]; waves of 1.5 L if left out.")
    ] = None,
    clearance: Annotated[float | None, typer.Option(help="Wet-deck clearance [m].")] = None,
    seed: Annotated[int, typer.Option(help="Seed of the realisation.")] = 1,
    hours: Annotated[float, typer.Option(help="Hours counted.")] = 1.0,
    film: Annotated[bool, typer.Option("--film/--no-film", help="Also render an MP4.")] = False,
    method: MethodOption = "recommended",
    panels: PanelsOption = 1000,
) -> None:
    """Do everything for a design and write results, tables, figures, animation and an index page."""
    from workbench import study

    chosen = designs.with_clearance(designs.design(design), clearance)
    if speed_knots is None and froude is None:
        froude = 0.3
    speed = speed_of(chosen, speed_knots, froude)
    index = study.written_study(
        chosen,
        out,
        speed=speed,
        wave_direction=wave_direction_of(heading_degrees),
        significant_wave_height=hs,
        peak_period=tp,
        seed=seed,
        hours=hours,
        film=film,
        settings=theory_of(method, settings_of(panels, "auto", "encounter-frequency", 0.0)),
    )
    print(index)


application.command("designs")(design_commands.list_designs)
application.command("show")(design_commands.show)
application.command("simulate")(simulate_command.simulate)
application.command("records")(record_commands.records)
application.command("cross-structure")(cross_structure_command.slam)
application.command("slam-record")(cross_structure_command.slam_record)
for command in (
    *slam_command.COMMANDS,
    *tool_commands.COMMANDS,
    *entry_command.COMMANDS,
    *conditions_command.COMMANDS,
):
    application.command(command.__name__.removeprefix("open_"))(command)


if __name__ == "__main__":
    main()
