"""Command of the water entry of a section: ``workbench entry``."""

import csv
import json
import sys
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
import xarray as xr

from workbench.command_inputs import JsonOption
from workbench.conventions import SEAWATER_DENSITY
from workbench.errors import InputError, checked_number
from workbench.impact import entry as water_entry
from workbench.impact.entry_case import usual_penetration
from workbench.impact.nonlinear_start import first_penetration
from workbench.impact.section import Circle, Parabola, Section, TableSection, Wedge
from workbench.quantities import warnings_of

MOST_INSTANTS = 1000


def section_of(name: str, deadrise: float | None, radius: float | None) -> Section:
    """Return the section that the options name.

    Parameters
    ----------
    name : wedge, parabola, circle or a CSV file of y, z [m] from the centreline outwards.
    deadrise : of a wedge [degrees]; radius : of a parabola or circle [m].
    """
    if name == "wedge":
        _given("--deadrise-degrees", "a wedge", deadrise)
        return Wedge(np.radians(deadrise))
    if name in ("parabola", "circle"):
        _given("--radius", f"a {name}", radius)
        return (Parabola if name == "parabola" else Circle)(radius)
    return TableSection(_points(Path(name)))


def _given(option: str, what: str, value: float | None) -> None:
    if value is None:
        raise InputError(f"The section is {what}, which needs {option}.")


def _points(path: Path) -> tuple[tuple[float, float], ...]:
    if not path.is_file():
        raise InputError(
            f"--section must be wedge, parabola, circle or a CSV file of y, z in metres, got {str(path)!r}."
        )
    try:
        rows = [
            row for row in csv.reader(path.read_text().splitlines()) if row and not row[0].startswith("#")
        ]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"The section file {path} cannot be read: {error}.") from None
    try:
        return tuple((float(row[0]), float(row[1])) for row in (rows[1:] if _is_head(rows) else rows))
    except (ValueError, IndexError):
        raise InputError(
            f"Every row of the section file {path} must hold two numbers, y and z [m]."
        ) from None


def _is_head(rows: list[list[str]]) -> bool:
    try:
        [float(text) for text in rows[0]]
    except (ValueError, IndexError):
        return bool(rows)
    return False


def entry_values(found: xr.Dataset, section: Section, density: float, index: int = -1) -> dict[str, Any]:
    """Return the values that the command prints, at one instant of an entry at constant velocity."""
    last = found.isel(time=index)
    velocity, depth = float(last["entry_velocity"]), float(last["penetration"])
    wedge = isinstance(section, Wedge)

    def ratio(name: str, scale: float, when: bool = True) -> float | None:
        value = float(last[name]) / scale
        return value if when and np.isfinite(value) else None

    k = ratio("peak_coefficient", 1.0)
    return {
        "section": section.kind,
        "method": found.attrs["method"],
        "peak_pressure_coefficient": k,
        "peak_height": ratio("peak_height", depth, wedge),
        "force_coefficient": ratio("section_force", density * velocity**2 * depth, wedge),
        "wetted_rate": ratio("wetted_rate", velocity),
        "k": k,
        "penetration": depth,
        "wetted_half_breadth": ratio("wetted_half_breadth", 1.0),
        "peak_pressure": ratio("peak_pressure", 1.0),
        "force_per_length": ratio("section_force", 1.0),
        "warnings": list(warnings_of(found)),
    }


def _instants(section: Section, method: str, depth: float, count: int) -> np.ndarray:
    """Penetrations at which the values are taken [m]: the last, or so many from the start to it."""
    if count < 2:
        return np.array([depth])
    first = first_penetration(section) if method == "nonlinear" else 0.0
    return np.linspace(max(depth / count, min(first, depth / 2)), depth, count)


def history_values(found: xr.Dataset) -> dict[str, list[float | None]]:
    """Return the arrays that ``--history`` prints; a value that a theory does not have is None."""
    names = {
        "time": "time",
        "penetration": "penetration",
        "force_per_length": "section_force",
        "peak_pressure": "peak_pressure",
        "wetted_half_breadth": "wetted_half_breadth",
    }
    return {
        key: [float(value) if np.isfinite(value) else None for value in found[name].to_numpy()]
        for key, name in names.items()
    }


def entry(
    section: Annotated[
        str, typer.Option(help="wedge, parabola, circle, or a CSV file of y, z [m] from the centreline out.")
    ] = "wedge",
    deadrise_degrees: Annotated[
        float | None, typer.Option("--deadrise-degrees", help="Deadrise of the wedge.")
    ] = None,
    radius: Annotated[float | None, typer.Option(help="Radius of the parabola or circle [m].")] = None,
    method: Annotated[
        str, typer.Option(help=f"One of {', '.join(water_entry.METHODS)}.")
    ] = "generalised-wagner",
    velocity: Annotated[float, typer.Option(help="Downward velocity, constant [m/s].")] = 1.0,
    penetration: Annotated[
        float | None,
        typer.Option(help="Depth below calm water at which the values are taken [m]; shallow if left out."),
    ] = None,
    density: Annotated[float, typer.Option(help="Of the water [kg/m3].")] = SEAWATER_DENSITY,
    history: Annotated[
        int,
        typer.Option(help="Number of instants from the start to the penetration to print as arrays (JSON)."),
    ] = 0,
    as_json: JsonOption = False,
) -> None:
    """Print peak pressure and force of a section that enters calm water."""
    shape = section_of(section, deadrise_degrees, radius)
    checked_number("downward entry velocity", velocity, "m/s", above=0, cure="the section enters the water")
    if penetration is not None:
        checked_number("penetration", penetration, "m", above=0)
    usual = 1.0 if isinstance(shape, Wedge) else usual_penetration(shape)
    depth = usual if penetration is None else penetration
    checked_number("number of instants of the history", history, at_least=0, at_most=MOST_INSTANTS)
    times = _instants(shape, method, depth, history) / velocity
    found = water_entry.entry(shape, velocity, method, density, times)
    values = entry_values(found, shape, density)
    if history:
        values["history"] = history_values(found)
    if as_json:
        print(json.dumps(values, allow_nan=False))
        return
    for name, value in values.items():
        if name not in ("warnings", "history"):
            text = f"{value:.6g}" if isinstance(value, float) else value or "-"
            print(f"{name.replace('_', ' '):27s}{text}")
    for sentence in values["warnings"]:
        print(f"warning: {sentence}", file=sys.stderr)


COMMANDS = (entry,)
