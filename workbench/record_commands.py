"""Command for measured records: summary, spectra, responses, fits, displacements and slams of a CSV file."""

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
import xarray as xr

from workbench import quantities
from workbench.command_inputs import HeadingOption, JsonOption, wave_direction_of
from workbench.conventions import KNOT
from workbench.errors import InputError, checked_choice, checked_number
from workbench.whole_files import written_whole

WHAT = ("summary", "spectra", "response", "fit", "displacement", "slams")
ROWS_PRINTED = 60

Columns = dict[str, Sequence]
"""Columns of a table by their label, unit in brackets."""


def records(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="CSV: time [s], then channels such as bow wave [m].")
    ],
    what: Annotated[str, typer.Option(help=", ".join(WHAT) + ".")] = "summary",
    channel: Annotated[list[str] | None, typer.Option(help="Channel to use; all if left out.")] = None,
    wave: Annotated[str | None, typer.Option(help="Channel of the wave elevation, for response.")] = None,
    speed_knots: Annotated[float, typer.Option("--speed-knots", help="Speed of the ship [kn].")] = 0.0,
    heading_degrees: HeadingOption = 180.0,
    segment: Annotated[int, typer.Option(help="Samples of a segment of the spectra.")] = 512,
    window: Annotated[str, typer.Option(help="hann or cosine-taper.")] = "hann",
    detrend: Annotated[str, typer.Option(help="none, constant or linear.")] = "constant",
    rate: Annotated[float | None, typer.Option(help="Thin out to so many samples per second [Hz].")] = None,
    longest_gap: Annotated[float | None, typer.Option(help="Longest gap that is filled [s].")] = None,
    resample: Annotated[bool, typer.Option("--resample", help="Move uneven samples to even times.")] = False,
    omega: Annotated[
        float | None, typer.Option(help="Frequency of the fit [rad/s]; found if left out.")
    ] = None,
    cutoff_hz: Annotated[float, typer.Option(help="High-pass of the double integration [Hz].")] = 0.1,
    threshold: Annotated[
        float | None, typer.Option(help="Of slams [m/s2]; matched to the ringing if left out.")
    ] = None,
    quickest_hz: Annotated[float, typer.Option(help="Slams are looked for above [Hz].")] = 3.0,
    ringing_hz: Annotated[
        float | None, typer.Option(help="Ringing after a slam [Hz]; found if left out.")
    ] = None,
    ringing_ratio: Annotated[
        float, typer.Option(help="Damping ratio of the ringing, with --ringing-hz.")
    ] = 0.05,
    out: Annotated[Path | None, typer.Option("--out", help="CSV file for the whole table.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Read a measured record: spectra, responses, sine fits, displacement from acceleration, slams."""
    from workbench.records.filters import decimated
    from workbench.records.reading import ReadingSettings, read_record
    from workbench.records.spectra import SpectrumSettings

    checked_choice("what", what, WHAT)
    if out is not None and out.resolve() == file.resolve():
        raise InputError(f"out must be another file than the record, got {out} for both.")
    settings = SpectrumSettings(segment=segment, window=window, detrend=detrend)
    record_set = read_record(file, ReadingSettings(longest_gap=longest_gap, resample=resample))
    if rate is not None:
        record_set = decimated(record_set, rate)
    if channel:
        wanted = list(dict.fromkeys([*channel, *([wave] if wave else [])]))
        known = [str(name) for name in record_set.channel.values]
        record_set = record_set.sel(channel=[checked_choice("channel", name, known) for name in wanted])
    if what == "response":
        speed = checked_number("speed-knots", speed_knots, "kn", at_least=0, at_most=100) * KNOT
        columns, notes = _response(record_set, wave, speed, wave_direction_of(heading_degrees), settings)
    elif what == "slams":
        columns, notes = _slams(record_set, threshold, quickest_hz, ringing_hz, ringing_ratio)
    elif what == "fit":
        columns, notes = _fits(record_set, omega)
    elif what == "displacement":
        columns, notes = _displacements(record_set, cutoff_hz)
    else:
        columns, notes = _summary(record_set) if what == "summary" else _spectra(record_set, settings)
    notes = list(dict.fromkeys([*quantities.warnings_of(record_set), *notes]))
    if out is not None:
        _write(out, columns, [f"{what} of {file.name}", *notes])
    _show(file, what, record_set, columns, notes, as_json)


def _named(record_set: xr.Dataset) -> list[tuple[str, str, np.ndarray]]:
    """Name, unit and samples of each channel."""
    units = [str(unit) for unit in record_set.channel_unit.values]
    names = [str(name) for name in record_set.channel.values]
    return [
        (*both, record_set.measured.values[:, place])
        for place, both in enumerate(zip(names, units, strict=True))
    ]


def _accelerations(record_set: xr.Dataset) -> list[tuple[str, np.ndarray]]:
    found = [(name, values) for name, unit, values in _named(record_set) if unit == "m/s2"]
    if not found:
        raise InputError(
            "record must hold a channel in m/s2 or g for this, it has none; name the unit in its label."
        )
    return found


def _summary(record_set: xr.Dataset) -> tuple[Columns, list[str]]:
    from workbench.records.crossings import significant, waves
    from workbench.records.spectra import length_notes

    rows, periods = [], []
    for name, unit, values in _named(record_set):
        number, period, largest = 0, np.nan, np.nan
        try:
            found = waves(record_set.time.values, values)
            number, period = found.sizes["event"], float(found.wave_period.mean())
            largest = float(found.double_amplitude.max())
        except InputError:
            pass  # a constant channel has no waves
        periods.append(period)
        rows.append((name, unit, values.mean(), values.std(), significant(values), largest, number, period))
    labels = ("channel", "unit", "mean", "standard deviation", "significant amplitude", "largest double amplitude",
              "waves", "zero-crossing period [s]")  # fmt: skip
    return dict(zip(labels, map(list, zip(*rows, strict=True)), strict=True)), length_notes(
        record_set, np.array(periods)
    )


def _spectra(record_set: xr.Dataset, settings) -> tuple[Columns, list[str]]:
    from workbench.records.spectra import record_spectra

    found = record_spectra(record_set, settings)
    columns: Columns = {"frequency [rad/s]": found.record_omega.values}
    for place, (name, unit, _) in enumerate(_named(record_set)):
        for part, word in (("record_spectrum", ""), ("spectrum_low", " low"), ("spectrum_high", " high")):
            columns[f"{name}{word} [({unit})2 s/rad]"] = found[part].values[:, place]
    return columns, list(quantities.warnings_of(found))


def _response(record_set, wave, speed, wave_direction, settings) -> tuple[Columns, list[str]]:
    from workbench.records.responses import estimated_response

    if wave is None:
        raise InputError("wave must name the channel of the wave elevation; give --wave.")
    found = estimated_response(record_set, wave, speed, wave_direction, settings)
    found = found.isel(record_omega=found.usable.values == 1)
    columns: Columns = {
        "encounter frequency [rad/s]": found.record_omega.values,
        "wave frequency [rad/s]": found.wave_omega.values,
    }
    for name, unit in zip(found.channel.values, found.channel_unit.values, strict=True):
        one, per = found.sel(channel=name), "slope" if str(unit).startswith("rad") else "m"
        columns[f"{name} [{unit} per {per}]"] = one.response_amplitude.values
        columns[f"{name} cross [{unit} per {per}]"] = one.cross_amplitude.values
        columns[f"{name} lead [rad]"] = one.response_lead.values
        columns[f"{name} coherence [1]"] = one.coherence.values
    return columns, list(quantities.warnings_of(found))


def _fits(record_set: xr.Dataset, omega: float | None) -> tuple[Columns, list[str]]:
    from workbench.records.sine_fit import sine_fit

    rows, notes = [], []
    for name, unit, values in _named(record_set):
        found = sine_fit(record_set.time.values, values, omega)
        notes += [f"Channel {name}: {note}" for note in found.warnings]
        rows.append(
            (name, unit, found.amplitude, found.phase, found.omega, found.rms_amplitude, found.unexplained)
        )
    labels = (
        "channel",
        "unit",
        "amplitude",
        "phase [rad]",
        "frequency [rad/s]",
        "sqrt(2) RMS",
        "unexplained share [1]",
    )
    return dict(zip(labels, map(list, zip(*rows, strict=True)), strict=True)), notes


def _displacements(record_set: xr.Dataset, cutoff_hz: float) -> tuple[Columns, list[str]]:
    from workbench.records.integration import displacement

    cutoff = 2 * np.pi * checked_number("cutoff-hz", cutoff_hz, "Hz", above=0)
    step = float(record_set.attrs["time_step"])
    columns: Columns = {"time [s]": record_set.time.values}
    for name, values in _accelerations(record_set):
        columns[f"{name} displacement [m]"] = displacement(values, step, cutoff)
    edge = 1.5 / cutoff_hz
    return columns, [f"Less sure within {edge:.3g} s of the ends, and void below {cutoff_hz:g} Hz."]


def _slams(record_set, threshold, quickest_hz, ringing_hz, ringing_ratio) -> tuple[Columns, list[str]]:
    from workbench.records.slam_signals import RingDown, matched_slams, ring_down, slams_above

    step, quickest = float(record_set.attrs["time_step"]), 2 * np.pi * quickest_hz
    names, times, peaks, strengths, notes = [], [], [], [], []
    for name, values in _accelerations(record_set):
        if threshold is not None:
            found = slams_above(values, step, threshold, quickest)
        else:
            if ringing_hz is None:
                ringing = ring_down(values, step, quickest)
            else:
                ringing = RingDown(omega=2 * np.pi * ringing_hz, damping_ratio=ringing_ratio)
            hertz = ringing.omega / (2 * np.pi)
            notes.append(
                f"Channel {name}: ringing of {hertz:.3g} Hz, damping ratio {ringing.damping_ratio:.2g}."
            )
            found = matched_slams(values, step, ringing, quickest)
        names += [name] * found.sizes["event"]
        times += (found.event_time.values + float(record_set.time[0])).tolist()
        peaks += found.slam_acceleration.values.tolist()
        strengths += found.slam_strength.values.tolist()
    return {
        "channel": names,
        "time [s]": times,
        "acceleration [m/s2]": peaks,
        "strength [1]": strengths,
    }, notes


def _plain(value):
    """Value as JSON holds it; not finite becomes None."""
    if isinstance(value, str):
        return value
    number = float(value)
    return (int(number) if isinstance(value, int | np.integer) else number) if np.isfinite(number) else None


def _show(
    file: Path, what: str, record_set: xr.Dataset, columns: Columns, notes: list[str], as_json: bool
) -> None:
    """Print the table as JSON or text, warnings on standard error."""
    step = float(record_set.attrs["time_step"])
    if as_json:
        table = {label: [_plain(value) for value in values] for label, values in columns.items()}
        head = {"file": file.name, "what": what, "samples": record_set.sizes["time"], "time_step": step}
        print(json.dumps({**head, "columns": table, "warnings": notes}, allow_nan=False))
        return
    print(f"{file.name}: {record_set.sizes['time']} samples, {1 / step:.4g} a second; {what}")
    rows = list(zip(*columns.values(), strict=True))
    cells = [
        [str(one) if isinstance(one, str) else f"{one:.5g}" for one in row] for row in rows[:ROWS_PRINTED]
    ]
    widths = [max(map(len, (label, *parts))) for label, *parts in zip(columns, *cells, strict=True)]
    for line in (list(columns), *cells):
        print("  ".join(f"{cell:>{width}}" for cell, width in zip(line, widths, strict=True)).rstrip())
    if len(rows) > ROWS_PRINTED:
        print(f"... {len(rows)} lines in all; --out FILE writes them, --json prints them.")
    for note in notes:
        print(f"warning: {note}", file=sys.stderr)


def _write(path: Path, columns: Columns, remarks: list[str]) -> None:
    """Write the table as CSV, whole or not at all."""

    def cell(value) -> str:
        text = value if isinstance(value, str) else "" if not np.isfinite(value) else f"{value:.9g}"
        return f'"{text}"' if "," in text else text

    lines = [f"# {remark}" for remark in remarks]
    lines.append(",".join(cell(label) for label in columns))
    lines += [",".join(cell(value) for value in row) for row in zip(*columns.values(), strict=True)]
    try:
        with written_whole(path) as temporary:
            temporary.write_text("\n".join(lines) + "\n", encoding="utf-8")
    except OSError as error:
        raise InputError(
            f"out must be a file that can be written, got {path}: {error.strerror}; check the folder."
        ) from None
