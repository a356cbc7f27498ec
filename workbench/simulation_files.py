"""Records of a simulation as a CSV or netCDF file, and in short."""

import io
from pathlib import Path

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.cache import save_dataset
from workbench.conventions import MODES, ROTATIONS
from workbench.errors import InputError
from workbench.whole_files import written_whole

SUFFIXES = (".csv", ".nc")

_TOLD = ("design", "method", "version", "speed", "froude_number", "time_step")


def columns(records: xr.Dataset) -> dict[str, np.ndarray]:
    """Columns of the table: time, wave, six motions, relative motion at each point; names carry the unit."""
    found = {"time_s": records.time.values, "elevation_m": records.elevation.values}
    for name, suffix in (("motion", ""), ("linear_motion", "_linear")):
        if name in records:
            for mode in MODES:
                unit = "rad" if mode in ROTATIONS else "m"
                found[f"{mode}{suffix}_{unit}"] = records[name].sel(dof=mode).values
    if "relative_motion_history" in records:
        for number in records.point.values:
            found[f"relative_motion_{number}_m"] = records.relative_motion_history.sel(point=number).values
    return found


def csv_text(records: xr.Dataset) -> str:
    """Records as CSV text: lines of # say what they are and where the points lie, then names, then rows."""
    head = [f"# {name}: {records.attrs[name]}" for name in (*_TOLD, "seed", "waves") if name in records.attrs]
    head.append("# motions at the centre of gravity; pitch positive bow down; x forward, y to port")
    if "point" in records.coords:
        for number in records.point.values:
            at = records.sel(point=number)
            head.append(f"# point {number}: x {float(at.point_x):g} m, y {float(at.point_y):g} m")
    head += [f"# warning: {line}" for line in quantities.warnings_of(records)]
    table = columns(records)
    stream = io.StringIO()
    stream.write("\n".join([*head, ",".join(table)]) + "\n")
    np.savetxt(stream, np.stack(list(table.values()), axis=1), fmt="%.7g", delimiter=",")
    return stream.getvalue()


def checked_path(path: Path) -> Path:
    """Return the path of a file for records, or refuse what cannot be written there."""
    path = Path(path)
    if path.suffix.lower() not in SUFFIXES:
        raise InputError(f"out must be a file that ends in {' or '.join(SUFFIXES)}, got {str(path)!r}.")
    if not path.parent.is_dir():
        raise InputError(f"out must lie in a folder that exists, got {path}; make {path.parent} first.")
    return path


def write_records(records: xr.Dataset, path: Path) -> Path:
    """Write records to a CSV or netCDF file, by its ending, whole or not at all."""
    path = checked_path(path)
    if path.suffix.lower() == ".nc":
        save_dataset(records, path)
        return path
    text = csv_text(records)
    try:
        with written_whole(path) as temporary:
            temporary.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(
            f"out must be writable, {path} is not ({error.strerror}); choose another folder."
        ) from None
    return path


def summary(records: xr.Dataset) -> dict:
    """Standard deviations and extremes of a simulation as plain values, SI units and radians."""
    modes = {}
    for mode in MODES:
        series = records.motion.sel(dof=mode).values
        modes[mode] = {
            "mean": float(series.mean()),
            "std": float(series.std()),
            "least": float(series.min()),
            "largest": float(series.max()),
        }
        if "linear_motion" in records:
            modes[mode]["linear_std"] = float(records.linear_motion.sel(dof=mode).values.std())
    values = {
        name: records.attrs[name] for name in ("forces", *_TOLD, "seed", "waves") if name in records.attrs
    }
    values |= {"duration": float(records.time[-1]), "motions": modes, "points": []}
    values["elevation_std"] = float(records.elevation.values.std())
    for number in records.point.values if "point" in records.coords else ():
        at = records.sel(point=number)
        water, slams, height = at.relative_motion_history.values, int(at.slam_count), float(at.deck_height)
        under = bool(np.isfinite(height))
        values["points"].append(
            {
                "x": float(at.point_x),
                "y": float(at.point_y),
                "relative_motion_std": float(water.std()),
                "relative_motion_largest": float(water.max()),
                "deck_height": height if under else None,
                "slams": slams if under else None,
                "slams_per_hour": slams * 3600 / values["duration"] if under else None,
            }
        )
    return values | {"warnings": list(quantities.warnings_of(records))}


def summary_text(values: dict) -> str:
    """`summary` for reading."""
    lines = [
        f"{values['design']}: {values['method']}, {values['speed']:.2f} m/s (Fn {values['froude_number']:.3f}), "
        f"{values['waves']}, {values['duration']:.0f} s",
        f"  wave at the centre of gravity: standard deviation {values['elevation_std']:.3g} m",
        "                std     linear      least    largest",
    ]
    for mode, found in values["motions"].items():
        turn, unit = (180 / np.pi, "degrees") if mode in ROTATIONS else (1.0, "m")
        cells = [
            found[name] * turn if name in found else np.nan
            for name in ("std", "linear_std", "least", "largest")
        ]
        shown = "".join(f"{cell:>11.3g}" if np.isfinite(cell) else f"{'-':>11}" for cell in cells)
        lines.append(f"  {mode:<6}{shown}  {unit}")
    for point in values["points"]:
        slams = "no wet deck here" if point["slams"] is None else f"{point['slams']} slams"
        lines.append(
            f"  relative motion at x {point['x']:g} m, y {point['y']:g} m: standard deviation "
            f"{point['relative_motion_std']:.3g} m, largest {point['relative_motion_largest']:.3g} m; {slams}"
        )
    return "\n".join(lines)
