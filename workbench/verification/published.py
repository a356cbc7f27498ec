"""Published numbers that the cases compare with: where their files are, and how they are read."""

import csv
from functools import cache
from importlib.resources import files
from pathlib import Path

import numpy as np

from workbench.errors import InputError


def checkout_folder() -> Path | None:
    """Folder of the checkout that this package runs from, or None when it is installed."""
    folder = Path(str(files("workbench"))).parent
    return folder if (folder / "tests" / "data" / "features.csv").is_file() else None


def data_folder() -> Path:
    """Folder with ``published/`` and ``features.csv``: of the checkout, or inside the installed package."""
    checkout = checkout_folder()
    return checkout / "tests" / "data" if checkout else Path(str(files("workbench"))) / "data"


def published_folder() -> Path:
    """Folder of the tables of published numbers."""
    folder = data_folder() / "published"
    if not folder.is_dir():
        raise InputError(
            f"published numbers must be in {folder}, which is missing; install the package again."
        )
    return folder


def csv_rows(path: Path) -> tuple[tuple[str, ...], tuple[dict[str, str], ...]]:
    """Head lines (without their #) and rows of a table."""
    lines = path.read_text(encoding="utf-8").splitlines()
    head = tuple(line[1:].strip() for line in lines if line.startswith("#"))
    return head, tuple(csv.DictReader(line for line in lines if line and not line.startswith("#")))


@cache
def rows(name: str) -> tuple[dict[str, str], ...]:
    """Rows of a published table as text by column name; ``name`` without .csv."""
    return csv_rows(published_folder() / f"{name}.csv")[1]


@cache
def citation(name: str) -> str:
    """Citation of a published table, the first line of its head."""
    return csv_rows(published_folder() / f"{name}.csv")[0][0]


def columns(name: str, **chosen: str | float) -> dict[str, np.ndarray]:
    """Numeric columns of a published table, of the rows in which the chosen columns have the given values.

    Columns that hold text are left out.
    """
    kept = [row for row in rows(name) if all(_same(row[key], value) for key, value in chosen.items())]
    found = {}
    for key in kept[0]:
        try:
            found[key] = np.array([float(row[key]) for row in kept])
        except ValueError:
            continue
    return found


def _same(text: str, value: str | float) -> bool:
    return text == value if isinstance(value, str) else float(text) == value


def value(name: str, label: str) -> tuple[float, float, str]:
    """Return number, tolerance and unit of the row whose first column is ``label``."""
    row = next(row for row in rows(name) if next(iter(row.values())) == label)
    number = float(row["value"])
    return number, abs(number) * float(row["relative_tolerance"]), row["unit"]
