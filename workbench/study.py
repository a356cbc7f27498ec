"""One whole study of a design in one condition, written to a folder: results, tables, figures, animation, index."""

import csv
import io
import json
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import xarray as xr

from workbench import (
    animation,
    cache,
    files,
    pipeline,
    pressure_stage,
    pressure_tables,
    quantities,
    report,
    sea_energy,
    tables,
)
from workbench.conventions import GRAVITY
from workbench.design import Design
from workbench.errors import InputError
from workbench.hydrodynamics.recommended import TheorySettings
from workbench.pipeline import Response, Slamming
from workbench.scene.standalone import standalone_html
from workbench.seas import Condition, SeaState
from workbench.slamming import criteria, events
from workbench.time_domain import Realisation
from workbench.whole_files import written_whole

USUAL_STEEPNESS = 1 / 25
"""Significant height of the usual sea, over the length of the ship [-]."""

LONGEST_PRESSURES = 1.0
"""Hours at most in which the pressure over the deck is computed [h]; an hour of slams takes some 12 s."""

USUAL_WAVELENGTH = 1.5
"""Length of the wave of its peak period, over the length of the ship [-]."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Study:
    """Everything computed for a design in a condition."""

    ship: Response
    slam: Slamming
    relative: xr.Dataset
    events: xr.Dataset
    counts: xr.Dataset
    classes: xr.Dataset
    curve: xr.Dataset
    scene: xr.Dataset
    realisation: Realisation
    deck_slams: xr.Dataset
    hardest_slam: xr.Dataset | None


def usual_sea(length: float, significant_wave_height: float | None, peak_period: float | None) -> SeaState:
    """Sea for a ship of this length where none is given: Hs = L/25, and a peak wavelength of 1.5 L."""
    return SeaState(
        significant_wave_height=(
            USUAL_STEEPNESS * length if significant_wave_height is None else significant_wave_height
        ),
        peak_period=(
            float(np.sqrt(2 * np.pi * USUAL_WAVELENGTH * length / GRAVITY))
            if peak_period is None
            else peak_period
        ),
    )


def study(
    design: Design,
    condition: Condition,
    realisation: Realisation,
    settings: TheorySettings | None = None,
) -> Study:
    """Compute a whole study; some 15 s for a known hull, half a minute more for a new one.

    The pressure over the deck is that of the first hour of the realisation.
    """
    ship = pipeline.response(design, condition.speed, sea_energy.directions_for(condition), None, settings)
    relative = pipeline.deck_response(ship, design.wet_deck)
    slam = pipeline.slamming(ship, relative, design.wet_deck, condition, hours=realisation.hours)
    found, counts = pipeline.counted_slams(ship, relative, slam, realisation)
    first = replace(realisation, hours=min(realisation.hours, LONGEST_PRESSURES))
    beginning, whole = (
        pressure_stage.RealisedDeck(ship, relative, slam, design.wet_deck, one)
        for one in (first, realisation)
    )
    deck_slams = pressure_stage.slam_pressures(beginning)
    clearances = np.linspace(0.3, 2.2, 60) * max(slam.clearance, slam.least_clearance)
    return Study(
        ship=ship,
        slam=slam,
        relative=relative,
        events=found,
        counts=counts,
        classes=events.velocity_classes(found),
        curve=criteria.clearance_curve(
            slam.moments, slam.deck.height, slam.clearance, clearances, slam.threshold
        ),
        scene=animation.animation_scene(ship, relative, slam, found, realisation, realised=whole),
        realisation=realisation,
        deck_slams=deck_slams,
        hardest_slam=pressure_stage.hardest_slam(beginning, deck_slams),
    )


def written_study(
    design: Design,
    folder: Path,
    *,
    speed: float,
    wave_direction: float,
    significant_wave_height: float | None = None,
    peak_period: float | None = None,
    seed: int = 1,
    hours: float = 1.0,
    film: bool = False,
    settings: TheorySettings | None = None,
) -> Path:
    """Compute a study and write it to a folder; return its index page.

    Writes ``index.html``, ``results.nc``, ``motions.csv``, ``slamming.csv``,
    ``slams.csv``, ``deck-slams.csv``, ``deck-slams.nc``, ``hardest-slam.csv``, ``hardest-slam.nc`` (where the
    deck slams), ``summary.json``, ``design.toml``, ``figures/*.png`` and ``*.svg``,
    ``animation.html`` and, if asked for, ``animation.mp4``. Each file is written under
    a temporary name and then renamed.
    """
    condition = Condition(
        speed=speed,
        wave_direction=wave_direction,
        sea_state=usual_sea(design.hull.length, significant_wave_height, peak_period),
    )
    realisation = Realisation(seed=seed, hours=hours)
    folder = _writable(Path(folder))
    done = study(design, condition, realisation, settings)

    cache.save_dataset(all_results(done), folder / "results.nc")
    summary = tables.slamming_table(done.ship, done.slam, done.counts, realisation)
    write(folder / "summary.json", json.dumps(summary, indent=1, allow_nan=False))
    write(folder / "motions.csv", motions_csv(tables.motion_table(done.ship)))
    write(folder / "slamming.csv", _grid_csv(done))
    write(folder / "slams.csv", done.events.to_dataframe().to_csv(float_format="%.6g"))
    for ending in pressure_tables.SUFFIXES:
        pressure_tables.write_slams(done.deck_slams, folder / f"deck-slams{ending}")
        if done.hardest_slam is not None:
            pressure_tables.write_history(done.hardest_slam, folder / f"hardest-slam{ending}")
    files.save_design(design, folder / "design.toml")
    pictures = report.pictures(done)
    (folder / "figures").mkdir(exist_ok=True)
    for name, figure in pictures.items():
        for kind in ("png", "svg"):
            write(folder / "figures" / f"{name}.{kind}", report.drawn(figure, kind))
    write(folder / "animation.html", standalone_html(done.scene, done.scene.attrs["title"]))
    if film:
        from workbench.scene import stills

        stills.film(done.scene, folder / "animation.mp4")
    write(folder / "index.html", report.index_page(done, summary, list(pictures), film))
    return folder / "index.html"


def all_results(done: Study) -> xr.Dataset:
    """Motions, deck statistics and counts of a study as one Dataset (x, y, omega, dof)."""
    motion = done.ship.motions.isel(wave_direction=0, drop=True)
    merged = xr.merge(
        [
            motion,
            done.slam.moments,
            done.slam.statistics,
            done.counts,
            done.slam.deck,
            done.slam.motion_statistics,
        ],
        combine_attrs="override",
        compat="no_conflicts",
        join="outer",
    )
    merged.attrs = {
        "title": done.scene.attrs["title"],
        "method": done.ship.motions.attrs["method"],
        "version": done.slam.statistics.attrs["version"],
        "speed": done.ship.speed,
        "wave_direction": done.slam.condition.wave_direction,
        "least_clearance": done.slam.least_clearance,
        "warnings": "\n".join(quantities.warnings_of(done.slam.statistics)),
    }
    return merged


def motions_csv(values: dict) -> str:
    """Motion table as CSV with a head of # lines."""
    stream = io.StringIO()
    stream.write(f"# {values['design']}, {values['method']}, speed {values['speed']:.6g} m/s, ")
    stream.write(f"heading {values['heading_degrees']:.6g} degrees (180 head seas)\n")
    stream.write(
        "# amplitudes per wave amplitude [m/m, rad/m]; phases lead the wave at the centre of gravity\n"
    )
    writer = csv.writer(stream, lineterminator="\n")
    modes = [name for name, entry in values.items() if isinstance(entry, dict)]
    header = ["omega_rad_s", "encounter_frequency_rad_s", "wavelength_ratio"]
    header += [f"{mode}_{part}" for mode in modes for part in ("amplitude", "phase_degrees")]
    writer.writerow(header)
    for i in range(len(values["omega"])):
        row = [values[name][i] for name in ("omega", "encounter_frequency", "wavelength_ratio")]
        row += [values[mode][part][i] for mode in modes for part in ("amplitude", "phase_degrees")]
        writer.writerow([f"{value:.6g}" for value in row])
    return stream.getvalue()


def _grid_csv(done: Study) -> str:
    """Deck statistics as CSV, a line for each point, units in the head."""
    grid = xr.merge([done.slam.deck, done.slam.statistics, done.counts], compat="override")
    units = ", ".join(f"{name} [{variable.attrs['units']}]" for name, variable in grid.data_vars.items())
    return f"# {done.scene.attrs['title']}\n# {units}\n" + grid.to_dataframe().to_csv(float_format="%.6g")


def write(path: Path, content: str | bytes) -> None:
    """Write a file under a temporary name, then rename it; `InputError` if that cannot be done."""
    data = content.encode() if isinstance(content, str) else content
    try:
        with written_whole(path) as temporary:
            temporary.write_bytes(data)
    except OSError as error:
        raise InputError(
            f"File {path} cannot be written: {error.strerror}; choose another folder."
        ) from error


def _writable(folder: Path) -> Path:
    """Make the folder, before anything is computed, or refuse it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = tempfile.NamedTemporaryFile(dir=folder, prefix=".")
        probe.close()
    except OSError as error:
        raise InputError(
            f"Folder {folder} must be writable, got: {error.strerror}; choose another folder with --out."
        ) from error
    return folder
