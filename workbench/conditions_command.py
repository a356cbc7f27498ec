"""Command of studies over conditions: ``workbench conditions``."""

import csv
import io
import json
import sys
from pathlib import Path
from typing import Annotated, Any

import typer
import xarray as xr

from workbench import condition_study, designs
from workbench.command_inputs import DesignArgument, JsonOption, progress_line
from workbench.errors import InputError
from workbench.quantities import warnings_of
from workbench.whole_files import written_whole

KINDS = (".csv", ".nc")
"""Endings of the file with the results."""


def study_of(name_or_path: str) -> condition_study.ConditionStudy:
    """Return a study that comes with the package by its name, or the one of a TOML file."""
    if name_or_path in condition_study.EXAMPLES:
        return condition_study.example(name_or_path)
    path = Path(name_or_path)
    if path.suffix != ".toml":
        raise InputError(
            f"STUDY must be a TOML file or one of {', '.join(condition_study.EXAMPLES)}, got {name_or_path!r}."
        )
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"STUDY must be a file that can be read, got {path}: {error}.") from None
    return condition_study.study_of_text(text)


def summary_of(found: xr.Dataset, rows: list[dict]) -> dict[str, Any]:
    """Return what the command prints: the rows, and for each place and height how many conditions slam."""
    of_height = found.is_slamming.sum(("forward_speed", "wave_direction", "period"))
    conditions = found.sizes["forward_speed"] * found.sizes["wave_direction"] * found.sizes["period"]
    return {
        "study": found.attrs["study"],
        "design": found.attrs["design"],
        "method": found.attrs["method"],
        "hours": found.attrs["hours"],
        "velocity": found.attrs["velocity"],
        "period_kind": found.attrs["period_kind"],
        "slamming": [
            {
                "place": str(place),
                "significant_wave_height": float(height),
                "conditions_with_slams": int(of_height.sel(place=place, significant_wave_height=height)),
                "conditions": conditions,
            }
            for place in found.place.values
            for height in found.significant_wave_height.values
        ],
        "rows": rows,
        "warnings": list(warnings_of(found)),
    }


def conditions(
    design: DesignArgument,
    study: Annotated[
        str,
        typer.Argument(
            metavar="STUDY", help=f"A TOML file, or one of {', '.join(condition_study.EXAMPLES)}."
        ),
    ],
    out: Annotated[
        Path | None, typer.Option("--out", help="File for the results, ending in .csv or .nc.")
    ] = None,
    figures: Annotated[
        Path | None, typer.Option("--figures", help="Folder for a PNG of each place and height.")
    ] = None,
    counted: Annotated[
        bool, typer.Option("--counted/--closed-form", help="Also count a realisation of each condition.")
    ] = False,
    seed: Annotated[int, typer.Option(help="Seed of the first realisation.")] = 1,
    as_json: JsonOption = False,
) -> None:
    """Slams per hour, entry velocity and pressure over headings, speeds, heights and periods."""
    from workbench import condition_runs

    if out is not None and out.suffix not in KINDS:
        raise InputError(f"--out must end in {' or '.join(KINDS)}, got {out}.")
    chosen, asked = designs.design(design), study_of(study)
    found = condition_runs.slamming_of_conditions(
        chosen, asked, counted=counted, seed=seed, progress=progress_line()
    )
    rows = condition_runs.condition_rows(found)
    if out is not None:
        _write(found, rows, out)
    if figures is not None:
        _draw(found, figures)
    values = summary_of(found, rows)
    if as_json:
        print(json.dumps(values, allow_nan=False))
        return
    print(f"{values['study']} with {values['design']}, {values['method']}, {values['hours']:g} h each")
    for line in values["slamming"]:
        print(
            f"  {line['place']:20s} Hs {line['significant_wave_height']:5.2f} m   slams in "
            f"{line['conditions_with_slams']} of {line['conditions']} conditions"
        )
    worst = max(rows, key=lambda row: row["slams_per_hour"])
    print(
        f"Most slams: {worst['slams_per_hour']:.4g} per hour at {worst['mean_entry_velocity']:.3g} m/s, "
        f"{worst['place']}, {worst['speed_knots']:g} kn, {worst['heading_degrees']:g} degrees, Hs "
        f"{worst['significant_wave_height']:g} m, {values['period_kind']} period {worst['period']:g} s"
    )
    for sentence in values["warnings"]:
        print(f"warning: {sentence}", file=sys.stderr)


def _write(found: xr.Dataset, rows: list[dict], path: Path) -> None:
    if path.suffix == ".nc":
        from workbench.cache import save_dataset

        save_dataset(found, path)
        return
    stream = io.StringIO()
    stream.write(
        f"# {found.attrs['study']}, {found.attrs['design']}, {found.attrs['method']}, {found.attrs['hours']:g} h, "
        f"{found.attrs['period_kind']} period\n# SI units beside what the names say; 180 degrees are head seas\n"
    )
    writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow(
            {key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}
        )
    _write_bytes(path, stream.getvalue().encode())


def _draw(found: xr.Dataset, folder: Path) -> None:
    from workbench.figures import style
    from workbench.figures.conditions import conditions_figure

    for place in found.place.values:
        for height in found.significant_wave_height.values:
            figure = conditions_figure(found, place=str(place), significant_wave_height=float(height))
            name = f"{str(place).replace(' ', '-')}-hs{height:g}.png"
            _write_bytes(folder / name, style.picture(figure))


def _write_bytes(path: Path, content: bytes) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with written_whole(path) as temporary:
            temporary.write_bytes(content)
    except OSError as error:
        raise InputError(f"File {path} cannot be written: {error.strerror}; choose another.") from None


COMMANDS = (conditions,)
