"""Commands of the wet deck in a sea: ``workbench slam`` (how often) and ``workbench pressure`` (how hard, in time)."""

import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import typer

from workbench import designs, tables
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
    PeakEnhancementOption,
    RunningSinkageOption,
    RunningTrimOption,
    SpectrumFileOption,
    SpectrumOption,
    SpeedOption,
    SpreadingOption,
    TreatmentOption,
    TunnelOption,
    WaveFieldOption,
    WindOption,
    deck_points_of,
    heeled_design,
    number_or_word,
    progress_line,
    running_state_of,
    sea_state_of,
    settings_of,
    speed_of,
    theory_of,
    wave_direction_of,
)
from workbench.design import Design
from workbench.design_commands import print_json, print_warnings


class _Case(NamedTuple):
    """A ship in a sea, its slamming, and the realisation that is counted."""

    design: Design
    ship: Any
    relative: Any
    slamming: Any
    realisation: Any


def slam(
    design: DesignArgument,
    clearance: Annotated[
        float | None, typer.Option(help="Wet-deck clearance [m]; that of the design if left out.")
    ] = None,
    method: MethodOption = "recommended",
    hs: Annotated[float, typer.Option("--hs", help="Significant wave height [m].")] = 2.0,
    tp: Annotated[float | None, typer.Option("--tp", help="Peak period [s].")] = None,
    spectrum: SpectrumOption = "bretschneider",
    peak_enhancement: PeakEnhancementOption = 3.3,
    spectrum_file: SpectrumFileOption = None,
    spreading: SpreadingOption = None,
    speed_knots: SpeedOption = None,
    froude: FroudeOption = None,
    heading_degrees: HeadingOption = 180.0,
    threshold: Annotated[str, typer.Option(help="Least entry velocity: 0, ochi, or a number [m/s].")] = "0",
    seed: Annotated[int, typer.Option(help="Seed of the realisation that is counted.")] = 1,
    hours: Annotated[float, typer.Option(help="Hours counted, and of the largest pressure.")] = 1.0,
    criterion_per_hour: Annotated[float, typer.Option(help="Slams per hour that are allowed.")] = 20.0,
    pressure_law: Annotated[str, typer.Option(help="chuang, chuang-text or wagner.")] = "chuang",
    deck_points: Annotated[str, typer.Option(help="Points of the deck, lengthwise x across.")] = "40x10",
    panels: PanelsOption = 1000,
    interaction: InteractionOption = "auto",
    speed_treatment: TreatmentOption = "encounter-frequency",
    tunnel_damping: TunnelOption = 0.0,
    wave_field: WaveFieldOption = "auto",
    own_wave: Annotated[
        bool,
        typer.Option(
            "--own-wave/--no-own-wave", help="Add the ship's own steady wave, by the high-speed theory."
        ),
    ] = False,
    running_trim_degrees: RunningTrimOption = 0.0,
    running_sinkage: RunningSinkageOption = 0.0,
    heel_degrees: HeelOption = 0.0,
    wind_speed: WindOption = None,
    lock: LockOption = "",
    as_json: JsonOption = False,
) -> None:
    """Wet-deck slamming in an irregular sea: closed form over the deck, and counted."""
    from workbench import pipeline

    case = _case(**{name: value for name, value in locals().items() if name in _SEA_OPTIONS})
    _, counts = pipeline.counted_slams(case.ship, case.relative, case.slamming, case.realisation)
    _print(
        tables.slamming_table(case.ship, case.slamming, counts, case.realisation),
        tables.slamming_text,
        as_json,
    )


_SEA_OPTIONS = tuple(name for name in inspect.signature(slam).parameters if name != "as_json")


def _case(
    *, design, clearance, method, hs, tp, spectrum, peak_enhancement, spectrum_file, spreading, speed_knots, froude,
    heading_degrees, threshold, seed, hours, criterion_per_hour, pressure_law, deck_points, panels, interaction,
    speed_treatment, tunnel_damping, wave_field, own_wave, running_trim_degrees, running_sinkage, heel_degrees,
    wind_speed, lock,
) -> _Case:  # fmt: skip
    """Compute the closed-form slamming that the options ask for."""
    from workbench import pipeline, sea_energy
    from workbench.impact.pressure import PressureLaw
    from workbench.seas import Condition
    from workbench.time_domain import Realisation

    chosen = designs.with_clearance(heeled_design(designs.design(design), heel_degrees), clearance)
    condition = Condition(
        speed=speed_of(chosen, speed_knots, froude),
        wave_direction=wave_direction_of(heading_degrees),
        sea_state=sea_state_of(hs, tp, spectrum, peak_enhancement, spectrum_file, spreading),
    )
    realisation = Realisation(seed=seed, hours=hours)
    panel_settings = settings_of(panels, interaction, speed_treatment, tunnel_damping)
    settings = theory_of(method, panel_settings, wave_field)
    state = running_state_of(chosen, running_trim_degrees, running_sinkage, wind_speed, lock)
    law = PressureLaw(name=pressure_law)
    points = deck_points_of(deck_points)
    least_velocity = pipeline.threshold_of(number_or_word(threshold), chosen)
    directions = sea_energy.directions_for(condition)
    ship = pipeline.response(
        chosen, condition.speed, directions, None, settings, running_state=state, progress=progress_line()
    )
    relative = pipeline.deck_response(ship, chosen.wet_deck, points)
    found = pipeline.slamming(
        ship,
        relative,
        chosen.wet_deck,
        condition,
        threshold=least_velocity,
        law=law,
        hours=hours,
        criterion_per_hour=criterion_per_hour,
        steady_elevation=pipeline.steady_elevation(ship, chosen.wet_deck, points) if own_wave else 0.0,
    )
    return _Case(chosen, ship, relative, found, realisation)


def _with_sea_options(command: Callable) -> Callable:
    """Give a command the options of `slam` before its own; it takes them as keywords."""
    own = [one for one in inspect.signature(command).parameters.values() if one.kind != one.VAR_KEYWORD]
    shared = [one for name, one in inspect.signature(slam).parameters.items() if name in _SEA_OPTIONS]
    command.__signature__ = inspect.Signature([*shared, *own])
    command.__annotations__ = {one.name: one.annotation for one in (*shared, *own)}
    return command


@_with_sea_options
def pressure(
    strips: Annotated[
        str, typer.Option(help="Strips of the deck: lengthwise, across, or auto (across under a pod).")
    ] = "auto",
    frame: Annotated[
        str, typer.Option(help="Closing velocity: material (against the water particle) or time-derivative.")
    ] = "material",
    pressure_model: Annotated[
        str, typer.Option(help="wagner, or logvinovich (less what the squared velocity takes).")
    ] = "wagner",
    suction: Annotated[
        float, typer.Option(help="Largest suction before air gets under the deck [Pa], 0 to 101325.")
    ] = 0.0,
    reduction: Annotated[str, typer.Option(help="For the width of the deck: none or pabst.")] = "none",
    time_step: Annotated[
        float | None,
        typer.Option(help="Time over which pressures are averaged [s]; about 10 ms if left out."),
    ] = None,
    extreme_hours: Annotated[
        float | None,
        typer.Option(
            "--extreme-hours", help="Hours for the largest pressure to expect; --hours if left out."
        ),
    ] = None,
    risk: Annotated[
        float, typer.Option(help="Of being exceeded in that time, for the extreme pressure.")
    ] = 0.01,
    out: Annotated[
        Path | None, typer.Option("--out", help="File: .nc of all results, .csv of the slams one by one.")
    ] = None,
    history: Annotated[
        Path | None,
        typer.Option(
            "--history", help="File .csv of the force and .nc of the pressures of the hardest slam."
        ),
    ] = None,
    as_json: JsonOption = False,
    **sea_options,
) -> None:
    """Pressure over the wet deck in an irregular sea: every slam, envelope, extremes, force in time."""
    from workbench import pressure_stage, pressure_tables
    from workbench.wet_deck_pressure.settings import DeckPressureSettings

    settings = DeckPressureSettings(
        direction=strips,
        frame=frame,
        pressure=pressure_model,
        suction=suction,
        reduction=reduction,
        time_step=time_step,
    )
    for path in (out, history):
        if path is not None:
            pressure_tables.checked_path(path)
    case = _case(**sea_options)
    realised = pressure_stage.RealisedDeck(
        case.ship, case.relative, case.slamming, case.design.wet_deck, case.realisation, settings
    )
    slams = pressure_stage.slam_pressures(realised, progress_line())
    hardest = pressure_stage.hardest_slam(realised, slams)
    expected_hours = case.realisation.hours if extreme_hours is None else extreme_hours
    values = pressure_tables.pressure_table(slams, hardest) | {
        "extremes": pressure_tables.extremes_table(slams, expected_hours, risk),
        "rule_pressures": pressure_tables.rules_table(case.design, case.slamming.condition, slams),
    }
    if out is not None:
        values["out"] = str(pressure_tables.write_slams(slams, out))
    if history is not None:
        values["history"] = str(pressure_tables.write_history(hardest, history))
    _print(values, pressure_tables.pressure_text, as_json)


def _print(values: dict[str, Any], text: Callable[[dict[str, Any]], str], as_json: bool) -> None:
    if as_json:
        print_json(values)
    else:
        print(text(values))
        print_warnings(values["warnings"])


COMMANDS = (slam, pressure)
