"""Offsets from text: CSV with the columns x, z and half_breadth."""

import csv
import io

from workbench.errors import InputError, checked_number
from workbench.shapes import Offsets

COLUMNS = "x", "z", "half_breadth"


def offsets_from_csv(text: str, *, draught: float, length: float, unit: float = 1.0) -> Offsets:
    """Hull from a table of offsets.

    Parameters
    ----------
    text : lines of a CSV file with the columns x (from midships, forward), z (above the keel datum)
        and half_breadth, in any order of rows; lines that start with # are notes.
    draught, length : of the waterline [m].
    unit : length of one unit of the table [m], such as 0.1.
    """
    unit = checked_number("unit of the offsets", unit, "m", above=0.0)
    stations: dict[float, list[tuple[float, float]]] = {}
    for number, (x, z, y) in _rows(text):
        points = stations.setdefault(x * unit, [])
        if any(z * unit == known for known, breadth in points if breadth == y * unit):
            raise InputError(
                f"offsets must not repeat a point, line {number} repeats x = {x:g}, z = {z:g}; remove one."
            )
        points.append((z * unit, y * unit))
    return Offsets(
        stations=tuple((x, _sorted_points(stations[x])) for x in sorted(stations)),
        draught=draught,
        length=length,
    )


def _sorted_points(points: list[tuple[float, float]]) -> tuple:
    """Return the points from the keel upwards; on a flat bottom from the centreline outwards."""
    return tuple(sorted(points))


def _rows(text: str):
    """Yield line number and (x, z, half-breadth) of every row."""
    lines = [
        (n, line) for n, line in enumerate(text.splitlines(), 1) if line.strip() and line.strip()[0] != "#"
    ]
    if not lines:
        raise InputError("table of offsets must have points, got an empty table; give x, z, half_breadth.")
    header = [name.strip().lower() for name in next(csv.reader(io.StringIO(lines[0][1])))]
    if sorted(header) != sorted(COLUMNS):
        raise InputError(
            f"columns of the offsets must be {', '.join(COLUMNS)}, got {', '.join(header)[:80]}; "
            "name them in the first line."
        )
    order = [header.index(name) for name in COLUMNS]
    for number, line in lines[1:]:
        cells = next(csv.reader(io.StringIO(line)))
        if len(cells) != len(COLUMNS):
            raise InputError(
                f"line {number} of the offsets must have 3 numbers, got {len(cells)}; repair the line."
            )
        try:
            values = [float(cells[k]) for k in order]
        except ValueError:
            raise InputError(
                f"line {number} of the offsets must be numbers, got {line.strip()[:60]!r}; repair the line."
            ) from None
        yield number, values
