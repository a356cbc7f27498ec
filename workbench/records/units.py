"""Units in the names of columns, such as 'pitch [deg]', and their size in SI."""

import re

import numpy as np

from workbench.conventions import GRAVITY, KNOT
from workbench.errors import InputError

_SCALES: dict[str, tuple[str, float]] = {
    "1": ("1", 1.0), "-": ("1", 1.0), "%": ("1", 0.01),
    "s": ("s", 1.0), "sec": ("s", 1.0), "ms": ("s", 1e-3), "min": ("s", 60.0), "h": ("s", 3600.0),
    "m": ("m", 1.0), "cm": ("m", 1e-2), "mm": ("m", 1e-3), "ft": ("m", 0.3048),
    "m/s": ("m/s", 1.0), "kn": ("m/s", KNOT), "knots": ("m/s", KNOT),
    "m/s2": ("m/s2", 1.0), "m/s^2": ("m/s2", 1.0), "m/s**2": ("m/s2", 1.0), "m/s²": ("m/s2", 1.0),
    "g": ("m/s2", GRAVITY),
    "rad": ("rad", 1.0), "deg": ("rad", np.pi / 180), "degrees": ("rad", np.pi / 180), "°": ("rad", np.pi / 180),
    "rad/s": ("rad/s", 1.0), "deg/s": ("rad/s", np.pi / 180), "°/s": ("rad/s", np.pi / 180),
    "rad/s2": ("rad/s2", 1.0), "deg/s2": ("rad/s2", np.pi / 180),
    "pa": ("Pa", 1.0), "kpa": ("Pa", 1e3), "mpa": ("Pa", 1e6), "bar": ("Pa", 1e5), "mbar": ("Pa", 100.0),
    "n": ("N", 1.0), "kn_force": ("N", 1e3), "mn": ("N", 1e6), "nm": ("N m", 1.0), "n m": ("N m", 1.0),
    "knm": ("N m", 1e3), "kn m": ("N m", 1e3), "hz": ("Hz", 1.0), "v": ("V", 1.0), "mv": ("V", 1e-3),
}  # fmt: skip

_LABEL = re.compile(r"^\s*(?P<name>.*?)\s*[\[(](?P<unit>[^\])]*)[\])]\s*$")


_SUFFIX = re.compile(r"^(?P<name>.+)_(?P<unit>m|mm|s|rad|deg|degrees)$")


def split_label(label: str) -> tuple[str, str]:
    """Return name and unit of a column's label; the unit is empty if none is given.

    Units stand in brackets, 'pitch [deg]', or, some of length, angle and time, at the end: 'pitch_deg'.
    """
    found = _LABEL.match(label) or _SUFFIX.match(label.strip())
    if found is None:
        return label.strip(), ""
    return found["name"].strip(), found["unit"].strip()


def si_unit(unit: str, name: str = "") -> tuple[str, float]:
    """SI unit and the factor into it; ('?', 1) for no unit.

    'kN' is a force and 'kn' a knot, the only units in which the case of letters counts.
    """
    if not unit:
        return "?", 1.0
    key = "kn_force" if unit == "kN" else unit.lower()
    if key not in _SCALES:
        known = "m, mm, m/s, kn, m/s2, g, rad, deg, deg/s, Pa, kPa, N, kN, s, ms, Hz, V, 1"
        raise InputError(f"unit of {name or 'a column'} must be one of {known} or the like, got {unit!r}.")
    return _SCALES[key]
