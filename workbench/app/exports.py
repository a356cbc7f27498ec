"""Files for the reader: CSV with a head that says where the numbers come from, netCDF, TOML, JSON, HTML."""

import io
import json
import tempfile
from pathlib import Path

import numpy as np
import xarray as xr

from workbench import __version__, quantities
from workbench.app.case import Case
from workbench.app.method_inputs import recommended_theories, theory_words
from workbench.app.model import Findings
from workbench.cache import with_split_complex
from workbench.hydrodynamics.recommended import IN_A_SENTENCE, THEORY_NAMES, RecommendedSettings

FILM_SECONDS, FILM_RATE = 12.0, 15
"""Length [s] and pictures per second of a film."""

HARDEST_AT = 0.4
"""Where in an animation its hardest slam comes, as a fraction of its length."""


def heading_lines(case: Case) -> list[str]:
    """Lines on version and inputs for the head of a file."""
    design, condition, sea = case.design, case.condition, case.condition.sea_state
    lines = [
        f"workbench {__version__}",
        f"design: {design.name} {design.title}".rstrip(),
        f"speed: {condition.speed:.6g} m/s; wave direction: {np.degrees(condition.wave_direction):.6g} "
        f"deg (180 head seas)",
        f"sea: {sea.spectrum}, significant wave height {sea.significant_wave_height:.6g} m, peak period "
        f"{sea.peak_period:.6g} s, spreading exponent {sea.spreading_exponent}",
    ]
    lines.append(f"theory: {_theory_line(case)}")
    running = case.running_state
    if running.running_trim or running.running_sinkage:
        lines.append(
            f"running trim: {np.degrees(running.running_trim):.6g} deg, bow down; running sinkage "
            f"{running.running_sinkage:.6g} m"
        )
    if running.wind is not None:
        lines.append(f"damping by the sails in a true wind of {running.wind.speed:.6g} m/s, with the waves")
    if design.wet_deck is not None:
        lines.append(
            f"wet-deck clearance: {design.wet_deck.clearance:.6g} m; threshold: {case.threshold} m/s"
        )
    return lines


def _theory_line(case: Case) -> str:
    """Return the theory with its choices."""
    theory = case.theory
    if isinstance(theory, RecommendedSettings):
        chosen = recommended_theories(
            case.design.hull.length, case.condition.speed, (case.condition.wave_direction,), theory.quick
        )
        words = f"recommended, {theory_words(chosen)} at this heading, interaction {theory.strip.interaction}"
        by_panels = theory.potential_flow if "potential-flow" in chosen else None
    else:
        name = next(name for name in THEORY_NAMES if theory == case.within.of(name))
        words = f"{IN_A_SENTENCE[name]}, interaction {theory.interaction}"
        by_panels = theory if name == "potential-flow" else None
    if by_panels is None:
        return words
    return (
        f"{words}, wave field {by_panels.wave_field}, tunnel damping {by_panels.tunnel_damping:g}, "
        f"{by_panels.panels} panels"
    )


def csv_file(table: xr.Dataset, case: Case) -> bytes:
    """Text of a Dataset as CSV; complex values become amplitude and phase [rad]; units stand in the head."""
    plain = table.copy()
    units = []
    for name in list(table.variables):
        unit = (
            quantities.TABLE[str(name)].units
            if str(name) in quantities.TABLE
            else table[name].attrs.get("units", "")
        )
        if np.iscomplexobj(table[name]):
            plain[f"{name}_amplitude"] = np.abs(table[name])
            plain[f"{name}_phase"] = xr.apply_ufunc(np.angle, table[name])
            plain = plain.drop_vars(str(name))
            units += [f"{name}_amplitude [{unit}]", f"{name}_phase [rad]"]
        else:
            units.append(f"{name} [{unit}]")
    stream = io.StringIO()
    for line in (
        *heading_lines(case),
        f"method: {table.attrs.get('method', '')}",
        "units: " + ", ".join(units),
    ):
        stream.write(f"# {line}\n")
    for line in quantities.warnings_of(table):
        stream.write(f"# note: {line}\n")
    plain.to_dataframe().to_csv(stream, float_format="%.8g")
    return stream.getvalue().encode()


def netcdf_file(table: xr.Dataset, case: Case) -> bytes:
    """Bytes of a Dataset as netCDF; complex values have a last dimension of real and imaginary part."""
    split = with_split_complex(table)
    split.attrs = {**split.attrs, "inputs": "\n".join(heading_lines(case))}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "table.nc"
        split.to_netcdf(path)
        return path.read_bytes()


def inputs_file(state: dict) -> bytes:
    """Text of the inputs of the page as JSON."""
    return json.dumps(
        {"workbench": __version__, **state}, indent=1, ensure_ascii=False, allow_nan=False
    ).encode()


def film_file(scene: xr.Dataset) -> bytes:
    """Bytes of an MP4 of the scene about its hardest slam, `FILM_SECONDS` long at most; takes about a minute."""
    from workbench.scene import stills

    first, last = float(scene.time[0]), float(scene.time[-1])
    start = min(max(first, first + HARDEST_AT * (last - first) - FILM_SECONDS / 2), last)
    with tempfile.TemporaryDirectory() as folder:
        path = stills.film(
            scene,
            Path(folder) / "film.mp4",
            start=start,
            end=min(start + FILM_SECONDS, last),
            frames_per_second=FILM_RATE,
        )
        return path.read_bytes()


def motion_table(found: Findings) -> xr.Dataset:
    """Motions at all computed headings."""
    return found.ship.motions


def slamming_table(found: Findings) -> xr.Dataset:
    """Statistics and moments at all points of the deck, with its height."""
    merged = found.slam.statistics.merge(found.slam.moments).merge(found.slam.deck)
    merged.attrs = dict(found.slam.statistics.attrs)
    return merged
