"""Slam pressures as plain values for the command line, as text, and as files."""

import csv
import io
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.cache import save_dataset
from workbench.conventions import KNOT
from workbench.design import Design
from workbench.errors import InputError
from workbench.impact.rule_pressure import rule_pressures
from workbench.seas import Condition
from workbench.slamming.tail_fit import deck_slams, panel_slams, tail_extremes
from workbench.whole_files import written_whole

SUFFIXES = (".csv", ".nc")

_TOLD = (
    "design", "motions", "speed", "wave_direction", "significant_wave_height", "peak_period", "clearance", "seed",
    "strips", "frame",
    "pressure_model", "suction", "reduction", "density", "time_step", "panel_length", "strip_width", "duration",
)  # fmt: skip
SLAM_COLUMNS = (
    "slam_start", "slam_duration", "slam_pressure", "slam_x", "slam_y", "slam_root_pressure", "slam_force",
    "slam_force_x", "slam_force_y", "slam_impulse", "slam_wetted_area", "slam_is_whole",
)  # fmt: skip
_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""))
_MOST_HISTORY = 400
_QUANTILES = (0.5, 0.9, 0.99, 1.0)


def pressure_table(slams: xr.Dataset, hardest: xr.Dataset | None) -> dict[str, Any]:
    """Envelope over the deck, extremes, pressure against area and the force of the hardest slam, in SI units.

    Parameters
    ----------
    slams : of `workbench.pressure_stage.slam_pressures`; hardest : of ``hardest_slam``.
    """
    count, attrs = slams.sizes["slam"], slams.attrs
    values: dict[str, Any] = {name: attrs[name] for name in _TOLD}
    values["heading_degrees"] = float(np.degrees(values.pop("wave_direction")))
    values |= {
        "slams": count,
        "slams_per_hour": count * 3600 / attrs["duration"],
        "x": slams.x.values.tolist(),
        "y": slams.y.values.tolist(),
        "envelope": slams.pressure_envelope.values.astype(float).tolist(),
        "pressure_area": {
            "area": slams.block_area.values.tolist(),
            "largest_average_pressure": slams.block_pressure.values.tolist(),
        },
        "quantiles": {
            f"{quantile:g}": {
                name: float(np.quantile(slams[name].values, quantile))
                for name in ("slam_pressure", "slam_force", "slam_impulse", "slam_duration")
            }
            for quantile in _QUANTILES
            if count
        },
        "hardest": None,
        "force_history": None,
    }
    if count and hardest is not None:
        one = slams.isel(slam=int(np.argmax(slams.slam_pressure.values)))
        values["hardest"] = {name: _plain(one[name]) for name in SLAM_COLUMNS}
        thinned = hardest.isel(time=slice(None, None, max(1, hardest.sizes["time"] // _MOST_HISTORY)))
        values["force_history"] = {
            "time": thinned.time.values.tolist(),
            "force": thinned.deck_force.values.tolist(),
            "force_x": [_plain(value) for value in thinned.deck_force_x],
            "wetted_area": thinned.wetted_area.values.tolist(),
        }
    values["warnings"] = list(quantities.warnings_of(slams))
    return values


def extremes_table(slams: xr.Dataset, hours: float, risk: float) -> dict[str, Any]:
    """Largest panel pressure to expect in a number of hours, anywhere and at the hardest panel, with 99 % bands [Pa].

    Parameters
    ----------
    slams : of `workbench.pressure_stage.slam_pressures`; hours : [h]; risk : of being exceeded [-].
    """
    found: dict[str, Any] = {"hours": hours, "risk": risk}
    row, column = np.unravel_index(
        int(np.argmax(slams.pressure_envelope.values)), slams.pressure_envelope.shape
    )
    place = float(slams.x[row]), float(slams.y[column])
    for name, (pressures, times) in (
        ("deck", deck_slams(slams)),
        ("hardest_panel", panel_slams(slams, *place)),
    ):
        tail = tail_extremes(pressures, times, slams.attrs["duration"], hours, risk=risk)
        found[name] = {
            "most_probable_largest": _plain(tail.most_probable_peak_pressure),
            "most_probable_band": [_plain(tail.most_probable_low), _plain(tail.most_probable_high)],
            "exceeded_with_risk": _plain(tail.extreme_pressure),
            "exceeded_with_risk_band": [_plain(tail.extreme_low), _plain(tail.extreme_high)],
            "slams_in_tail": _plain(tail.tail_count),
            "notes": list(quantities.warnings_of(tail)),
        }
    found["hardest_panel"] |= {"x": place[0], "y": place[1]}
    return found


def rules_table(design: Design, condition: Condition, slams: xr.Dataset) -> dict[str, Any]:
    """Rule pressures at the place of the largest panel pressure, for a panel of that size, for orientation [Pa]."""
    row = int(np.argmax(slams.pressure_envelope.values.max(axis=1)))
    area = slams.attrs["panel_length"] * slams.attrs["strip_width"]
    found = rule_pressures(design, condition, panel_area=area, x=[float(slams.x[row])]).isel(x=0)
    return {
        "x": float(slams.x[row]),
        "panel_area": area,
        "rules": [
            {
                "rule": str(rule),
                "reference": str(found.rule_reference.sel(rule=rule).item()),
                "standing": str(found.rule_standing.sel(rule=rule).item()),
                "pressure": _plain(found.rule_pressure.sel(rule=rule)),
            }
            for rule in found.rule.values
        ],
        "notes": list(quantities.warnings_of(found)),
    }


def pressure_text(values: dict[str, Any]) -> str:
    """`pressure_table` for reading."""
    lines = [
        f"{values['design']}: {values['speed'] / KNOT:.2f} kn, heading {values['heading_degrees']:.0f} degrees, "
        f"Hs {values['significant_wave_height']:g} m, Tp {values['peak_period']:.3g} s, clearance "
        f"{values['clearance']:g} m",
        f"  {values['slams']} slams in {values['duration'] / 3600:g} h; pressures averaged over panels of "
        f"{values['panel_length']:.3g} x {values['strip_width']:.3g} m and {1e3 * values['time_step']:.3g} ms",
    ]
    if not values["hardest"]:
        return "\n".join([*lines, "  the deck stays dry"])
    one = values["hardest"]
    lines += [
        f"  largest panel pressure {_scaled(one['slam_pressure'], 'Pa')} at x {one['slam_x']:.3g} m, "
        f"y {one['slam_y']:.3g} m, in the slam at {one['slam_start']:.1f} s",
        f"  its force {_scaled(one['slam_force'], 'N')} at x {one['slam_force_x']:.3g} m, impulse "
        f"{_scaled(one['slam_impulse'], 'N s')}, wetted area {one['slam_wetted_area']:.4g} m2",
        "",
        f"  {'of all slams':<14}{'panel pressure':>16}{'force':>14}{'impulse':>14}{'duration':>12}",
    ]
    for share, found in values["quantiles"].items():
        lines.append(
            f"  {100 * float(share):>4.0f} % below{'':2}{_scaled(found['slam_pressure'], 'Pa'):>17}"
            f"{_scaled(found['slam_force'], 'N'):>14}{_scaled(found['slam_impulse'], 'N s'):>14}"
            f"{_scaled(found['slam_duration'], 's'):>12}"
        )
    lines += ["", *_extreme_lines(values.get("extremes")), "  largest average over an area"]
    area = values["pressure_area"]
    for size, mean in zip(area["area"], area["largest_average_pressure"], strict=True):
        lines.append(f"  {size:>12.4g} m2{_scaled(mean, 'Pa'):>16}")
    rules = values.get("rule_pressures")
    if rules:
        lines += ["", f"  rule pressures at x {rules['x']:.3g} m, for orientation"]
        for row in rules["rules"]:
            shown = "-" if row["pressure"] is None else _scaled(row["pressure"], "Pa")
            lines.append(f"  {row['rule']:<44}{shown:>12}  {row['standing']}")
    return "\n".join(lines)


def _extreme_lines(extremes: dict[str, Any] | None) -> list[str]:
    if not extremes:
        return []
    lines = [f"  largest panel pressure to expect in {extremes['hours']:g} h, 99 % band of the fit"]
    for name, words in (("deck", "anywhere"), ("hardest_panel", "at the hardest panel")):
        one = extremes[name]
        if one["most_probable_largest"] is None:
            lines.append(f"  {words:<22}{one['notes'][0]}")
            continue
        low, high = (_scaled(value, "Pa") for value in one["most_probable_band"])
        lines.append(f"  {words:<22}{_scaled(one['most_probable_largest'], 'Pa')} ({low} to {high})")
    return [*lines, ""]


def _scaled(value: float, unit: str) -> str:
    """Value with the prefix that suits its size, such as 4.41 MN."""
    factor, prefix = next(
        ((factor, prefix) for factor, prefix in _PREFIXES if abs(value) >= factor or factor == 1.0)
    )
    if unit == "s":
        factor, prefix = 1.0, ""
    return f"{value / factor:.4g} {prefix}{unit}"


def _plain(value) -> float | int | None:
    number = np.asarray(value).item()
    return number if np.isfinite(number) else None


def checked_path(path: Path) -> Path:
    """Return the path of a results file, or refuse what cannot be written there."""
    path = Path(path)
    if path.suffix.lower() not in SUFFIXES:
        raise InputError(f"The results file must end in {' or '.join(SUFFIXES)}, got {str(path)!r}.")
    if not path.parent.is_dir():
        raise InputError(
            f"The results file must lie in a folder that exists, got {path}; make {path.parent} first."
        )
    return path


def write_slams(slams: xr.Dataset, path: Path) -> Path:
    """Write all results as netCDF, or the slams one by one as CSV, by the file's ending."""
    return _written(slams, path, {name: slams[name].values for name in SLAM_COLUMNS})


def write_history(history: xr.Dataset | None, path: Path) -> Path:
    """Write the history of one slam: all of it as netCDF, or force, centre and wetted area as CSV."""
    if history is None:
        raise InputError(
            "There was no slam whose history could be written; take a rougher sea or more hours."
        )
    names = (
        "deck_force",
        "deck_pitch_moment",
        "deck_force_x",
        "deck_force_y",
        "wetted_area",
        "root_pressure",
    )
    return _written(
        history, path, {"time": history.time.values, **{name: history[name].values for name in names}}
    )


def csv_text(found: xr.Dataset, columns: dict[str, np.ndarray]) -> str:
    """Columns as CSV text; lines of # say what they are, the head carries the units."""
    stream = io.StringIO()
    for name in ("version", "method", *_TOLD):
        if name in found.attrs:
            stream.write(f"# {name}: {found.attrs[name]}\n")
    for sentence in quantities.warnings_of(found):
        stream.write(f"# warning: {sentence}\n")
    writer = csv.writer(stream, lineterminator="\n")
    units = {name: quantities.attributes(name)["units"] for name in columns}
    writer.writerow([name if unit == "1" else f"{name} [{unit}]" for name, unit in units.items()])
    for row in zip(*columns.values(), strict=True):
        writer.writerow([f"{value:.7g}" for value in row])
    return stream.getvalue()


def _written(found: xr.Dataset, path: Path, columns: dict[str, np.ndarray]) -> Path:
    path = checked_path(path)
    if path.suffix.lower() == ".nc":
        save_dataset(found, path)
        return path
    text = csv_text(found, columns)
    try:
        with written_whole(path) as temporary:
            temporary.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(
            f"The results file {path} cannot be written ({error.strerror}); choose another folder."
        ) from None
    return path
