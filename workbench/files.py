"""Designs to and from TOML files.

A file holds ``name``, ``title`` and ``density``, the tables ``[hull]``,
``[hull.shape]``, ``[hull.centre_shape]``, ``[wet_deck]``, ``[masses]`` and
``[sail_plan]`` with the fields of the classes of those names, in SI units and
radians, and entries ``[[appendages]]`` (of kind "foil" or "fin") and
``[[provenance]]``. An angle may be given in degrees by adding
``_degrees`` to its name. A shape of kind "offsets" may name a CSV ``file``
(with ``unit``) in place of stations, one of kind "mesh" a mesh ``file`` (with
``unit``, ``waterline`` and ``midships``), both relative to the design file.

Nothing in a file is ever executed.
"""

import dataclasses
import difflib
import math
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path

import tomli_w

from workbench.appendages import APPENDAGES, LiftingSurface
from workbench.design import Design, Hull, MassProperties, SailPlan, WetDeck
from workbench.errors import InputError, checked_choice
from workbench.hulls.mesh_files import mesh_from_file
from workbench.hulls.offset_files import offsets_from_csv
from workbench.shapes import SHAPES, HullShape
from workbench.whole_files import written_whole

ANGLES = "heel", "trim", "deadrise_angle", "entrance_angle", "cant", "sweep"
ENTRY_KEYS = "quantity", "value", "source", "standing"
FILE_KEYS = {
    "offsets": ("file", "unit", "draught", "length"),
    "mesh": ("file", "unit", "waterline", "midships", "draught", "length"),
}
LARGEST_FILE = 50_000_000


def design_to_toml(design: Design) -> str:
    """Text of a design file; `design_from_toml` gives back an equal design."""
    values = design.as_dict()
    values["provenance"] = [dict(zip(ENTRY_KEYS, entry, strict=True)) for entry in values["provenance"]]
    return tomli_w.dumps(_plain(values))


def design_from_toml(source: str | Path) -> Design:
    """Design from the path of a TOML file, or from its text.

    A string that has a line break or an equals sign is taken as text.
    """
    if isinstance(source, str) and ("\n" in source or "=" in source):
        return _design(_parsed(source, "design"), Path())
    if not isinstance(source, str | Path):
        raise InputError(f"design file must be a path or text, got {source!r}; give one.")
    path = Path(source)
    return _design(_parsed(_text(path, "design file"), path.name), path.parent)


def save_design(design: Design, path: str | Path) -> Path:
    """Write a design file, whole or not at all, and return its path."""
    path = Path(path)
    text = design_to_toml(design)
    try:
        with written_whole(path) as temporary:
            temporary.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(
            f"design file must be writable, {path} is not ({error.strerror}); choose another folder."
        ) from None
    return path


def _plain(value):
    """Return lists for tuples, all the way down, and leave out what is None."""
    if isinstance(value, Mapping):
        return {key: _plain(entry) for key, entry in value.items() if entry is not None}
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    return value


def _text(path: Path, what: str) -> str:
    """Return the text of a file."""
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(f"{what} must be smaller than {LARGEST_FILE / 1e6:g} MB, got {path}; check it.")
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(
            f"{what} must be readable, {path} is not ({error.strerror}); check its name and folder."
        ) from None
    except UnicodeDecodeError:
        raise InputError(
            f"{what} must be text in UTF-8, {path} is not; check that it is the right file."
        ) from None


def _parsed(text: str, name: str) -> dict:
    """Return the tables of a TOML text."""
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InputError(f"{name} must be valid TOML, it is not ({error}); repair that line.") from None


def _design(values: dict, folder: Path) -> Design:
    """Return the design of parsed tables; files are named relative to `folder`."""
    values = _checked_table(values, _fields(Design), "the design")
    made = dict(values)
    hull = _checked_table(_needed(values, "hull", "the design"), _fields(Hull), "[hull]")
    hull["shape"] = _shape(_needed(hull, "shape", "[hull]"), folder, "[hull.shape]")
    if "centre_shape" in hull:
        hull["centre_shape"] = _shape(hull["centre_shape"], folder, "[hull.centre_shape]")
    made["hull"] = _made(Hull, hull, "[hull]")
    masses = _checked_table(_needed(values, "masses", "the design"), _fields(MassProperties), "[masses]")
    made["masses"] = _made(MassProperties, masses, "[masses]")
    made["wet_deck"] = None
    if "wet_deck" in values:
        table = _checked_table(values["wet_deck"], _fields(WetDeck), "[wet_deck]")
        made["wet_deck"] = _made(WetDeck, table, "[wet_deck]")
    if "sail_plan" in values:
        table = _checked_table(values["sail_plan"], _fields(SailPlan), "[sail_plan]")
        made["sail_plan"] = _made(SailPlan, table, "[sail_plan]")
    made["appendages"] = tuple(_appendage(table) for table in _tables(values, "appendages"))
    tables = [_checked_table(entry, ENTRY_KEYS, "[[provenance]]") for entry in _tables(values, "provenance")]
    made["provenance"] = tuple(
        tuple(_needed(table, key, "[[provenance]]") for key in ENTRY_KEYS) for table in tables
    )
    return _made(Design, made, "the design")


def _tables(values: Mapping, name: str) -> list:
    """Return the entries of an array of tables."""
    entries = values.get(name, [])
    if not isinstance(entries, list):
        raise InputError(f"{name} must be [[{name}]] tables, got {entries!r}; use double brackets.")
    return entries


def _appendage(table: object) -> LiftingSurface:
    """Return a foil or a fin."""
    where = "[[appendages]]"
    values = _checked_table(table, ("kind", *_fields(LiftingSurface)), where)
    kind = checked_choice(f"kind of {where}", _needed(values, "kind", where), APPENDAGES)
    del values["kind"]
    return _made(APPENDAGES[kind], values, where)


def _shape(table: object, folder: Path, where: str) -> HullShape:
    """Return a hull shape, read from its own file where one is named."""
    if not isinstance(table, dict):
        raise InputError(
            f"{where} must be a table, got {table!r}; start it with {where} on a line of its own."
        )
    values = dict(table)
    kind = checked_choice(f"kind of {where}", _needed(values, "kind", where), SHAPES)
    del values["kind"]
    if kind in FILE_KEYS and "file" in values:
        values = _checked_table(values, FILE_KEYS[kind], where)
        name = values.pop("file")
        if not isinstance(name, str):
            raise InputError(f"file of {where} must be text, got {name!r}; put the name in quotes.")
        if kind == "mesh":
            _needed(values, "length", where)
            return mesh_from_file(folder / name, **values)
        for key in ("draught", "length"):
            _needed(values, key, where)
        return offsets_from_csv(_text(folder / name, "offsets file"), **values)
    return _made(SHAPES[kind], _checked_table(values, _fields(SHAPES[kind]), where), where)


def _fields(owner: type) -> tuple[str, ...]:
    """Return the names of the fields of a dataclass."""
    return tuple(field.name for field in dataclasses.fields(owner))


def _checked_table(table: object, allowed: Iterable[str], where: str) -> dict:
    """Return a table with known keys only, its angles in radians."""
    if not isinstance(table, dict):
        raise InputError(
            f"{where} must be a table, got {table!r}; start it with {where} on a line of its own."
        )
    allowed = tuple(allowed)
    values = {}
    for key, value in table.items():
        base = key.removesuffix("_degrees")
        is_angle = base != key and base in ANGLES and base in allowed
        if not is_angle and key not in allowed:
            close = difflib.get_close_matches(key, allowed, n=1, cutoff=0.0)
            raise InputError(
                f"key of {where} must be one that is known, got {key!r}; the nearest is {close[0]!r}."
            )
        name = base if is_angle else key
        if name in values:
            raise InputError(f"{name} of {where} must be given once, got it twice; remove one.")
        number = isinstance(value, int | float) and not isinstance(value, bool)
        values[name] = math.radians(value) if is_angle and number else value
    return values


def _needed(table: Mapping, key: str, where: str):
    """Return the value of a key that must be there."""
    if key not in table:
        raise InputError(f"{key} must be given in {where}, it is missing; add it.")
    return table[key]


def _made(owner: type, values: Mapping, where: str):
    """Return owner(**values), or `InputError` naming the first field that is missing."""
    for field in dataclasses.fields(owner):
        no_default = field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING
        if no_default:
            _needed(values, field.name, where)
    return owner(**values)
