"""A scene packed into the few binary blocks that the browser reads.

The elevation film goes as 16-bit integers, fields of the deck as bytes with
limits fixed over the whole film, geometry and curves as 32-bit floats. Colours
and limits are chosen here, so that every painter shows the same ones.
"""

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.colors import to_hex

from workbench.errors import InputError
from workbench.scene.description import COMPONENTS, DECK_FIELDS, EVENTS, checked_scene, has_components

BANDS = 12
"""Number of contour bands over the deck."""

FILM_LIMIT = 64e6
"""Largest elevation film that is sent to a browser [bytes]."""

MISSING = 255
"""Byte of a deck field that has no value there."""

_COLOUR_MAPS = {"relative_motion_history": "RdBu_r", "clearance_left": "viridis", "pressure": "cividis"}
_LABELS = {
    "relative_motion_history": "Relative motion",
    "clearance_left": "Clearance left",
    "pressure": "Impact pressure",
}
_EDGE_UNITS = {"Pa": ("kPa", 1e-3)}
_STEPS = np.array([1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0])

BLOCKS = (
    "pose",
    "water",
    "water_grid",
    "hull_vertices",
    "hull_faces",
    "deck",
    "slams",
    "curves",
    *DECK_FIELDS,
)
"""Names of the binary blocks, in the order in which they are documented in `packed_scene`."""


def packed_scene(scene: xr.Dataset) -> dict:
    """Scene as a dict of JSON (``scene``) and binary blocks (`BLOCKS`).

    Blocks, little-endian, C order: ``pose`` float32 (time, 6); ``water`` float32 (component, 5) or
    int16 (time, sea_x, sea_y); ``water_grid`` float32, sea_x then sea_y, empty for components;
    ``hull_vertices`` float32 (vertex, 3); ``hull_faces`` uint32 (triangle, 3); ``deck`` float32,
    x, y, then height (x, y); ``slams`` float32 (event, 5), by time; ``curves`` float32 (curve, time);
    each field of the deck uint8 (time, x, y), empty where the scene has none.
    """
    scene = checked_scene(scene)
    time = scene["time"].values
    water, grid, water_facts = _water(scene)
    slams = np.array([scene[name].values for name in EVENTS]).T if EVENTS[0] in scene else np.zeros((0, 5))
    slams = slams[np.argsort(slams[:, 0], kind="stable")]
    curve_facts, curves = _curves(scene)
    blocks = {
        "pose": _floats(scene["pose"]),
        "water": water,
        "water_grid": grid,
        "hull_vertices": _floats(scene["hull_vertices"]),
        "hull_faces": _triangles(scene["hull_faces"].values).astype("<u4").tobytes(),
        "deck": b"".join(_floats(scene[name]) for name in ("x", "y", "deck_height")),
        "slams": _floats(slams),
        "curves": _floats(curves),
    }
    fields = {name: deck_field(scene[name]) for name in DECK_FIELDS if name in scene}
    for name in DECK_FIELDS:
        facts = fields.get(name)
        blocks[name] = (
            quantised_bytes(scene[name].values, facts["low"], facts["high"]).tobytes() if facts else b""
        )
    facts = {
        "title": scene.attrs.get("title", ""),
        "speed": float(scene.attrs.get("speed", 0.0)),
        "start": float(time[0]),
        "step": float((time[-1] - time[0]) / (time.size - 1)),
        "count": int(time.size),
        "deck": [scene.sizes["x"], scene.sizes["y"]],
        "water": water_facts,
        "curves": curve_facts,
        "fields": [{"name": name, **field} for name, field in fields.items()],
    }
    return {"scene": facts, **blocks}


def deck_field(field: xr.DataArray) -> dict:
    """Label, unit, limits over the whole film and band colours of a field of the deck.

    ``low`` and ``high`` are in the field's own unit; the number shown is the value times
    ``factor``, in ``unit``. Limits lie on round numbers so that every band is round.
    """
    name = str(field.name)
    unit, factor = _EDGE_UNITS.get(field.attrs.get("units", ""), (field.attrs.get("units", ""), 1.0))
    values = field.values[np.isfinite(field.values)]
    least, most = (float(values.min()) * factor, float(values.max()) * factor) if values.size else (0.0, 1.0)
    if name == "relative_motion_history":
        step = _round_step(max(-least, most, 1e-9) / (BANDS // 2))
        low = -step * (BANDS // 2)
    elif name == "pressure":
        step, low = _round_step((most if most > 0 else 1.0) / BANDS), 0.0
    else:
        step = _round_step(max(most - least, 1e-9) / BANDS)
        low = np.floor(least / step) * step
        if low + BANDS * step < most:
            step = _round_step(step * 1.01)
            low = np.floor(least / step) * step
    colours = colormaps[_COLOUR_MAPS[name]]((np.arange(BANDS) + 0.5) / BANDS)
    return {
        "label": _LABELS[name],
        "unit": unit,
        "factor": factor,
        "low": float(low / factor),
        "high": float((low + BANDS * step) / factor),
        "colours": [to_hex(colour) for colour in colours],
    }


def quantised_bytes(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """Values as bytes 0 to 254 over `low` to `high`; 255 where there is none.

    The error of the way back is at most (high - low)/508.
    """
    scaled = np.clip((np.asarray(values, float) - low) / (high - low), 0.0, 1.0) * (MISSING - 1)
    return np.where(np.isfinite(scaled), np.rint(np.nan_to_num(scaled)), MISSING).astype(np.uint8)


def values_of_bytes(quantised: np.ndarray, low: float, high: float) -> np.ndarray:
    """Values of the bytes of `quantised_bytes`; NaN where there is none."""
    values = low + quantised.astype(float) / (MISSING - 1) * (high - low)
    return np.where(quantised == MISSING, np.nan, values)


def quantised_film(elevation: np.ndarray) -> tuple[np.ndarray, float]:
    """Elevation as 16-bit integers and the metres of one unit; NaN becomes 0, still water.

    The error of the way back is at most half a unit, max|elevation|/65534.
    """
    filled = np.nan_to_num(np.asarray(elevation, float))
    unit = float(max(np.abs(filled).max(initial=0.0), 1e-6) / 32767)
    return np.rint(filled / unit).astype("<i2"), unit


def worst_point(scene: xr.Dataset) -> tuple[int, int] | None:
    """Indices (x, y) of the deck point with the least clearance left; None if the scene has no such field."""
    if "clearance_left" in scene:
        left = scene["clearance_left"].values
    elif "relative_motion_history" in scene:
        left = scene["deck_height"].values - scene["relative_motion_history"].values
    else:
        return None
    least = np.where(np.isfinite(left), left, np.inf).min(axis=0)
    i, j = np.unravel_index(np.argmin(least), least.shape)
    return int(i), int(j)


def _water(scene: xr.Dataset) -> tuple[bytes, bytes, dict]:
    """Block, grid and facts of the water."""
    if has_components(scene):
        table = np.array([scene[name].values for name in COMPONENTS]).T
        return _floats(table), b"", {"kind": "components", "count": len(table)}
    film = scene["elevation"].values
    if film.size * 2 > FILM_LIMIT:
        raise InputError(
            f"The elevation film has {film.size * 2e-6:.0f} MB, at most {FILM_LIMIT * 1e-6:.0f} MB "
            "can be shown; use a shorter time, a coarser grid or wave components."
        )
    quantised, unit = quantised_film(film)
    grid = _floats(scene["sea_x"]) + _floats(scene["sea_y"])
    facts = {"kind": "film", "size": [scene.sizes["sea_x"], scene.sizes["sea_y"]], "unit": unit}
    return quantised.tobytes(), grid, facts


def _curves(scene: xr.Dataset) -> tuple[list[dict], np.ndarray]:
    """Facts and values of the curves beside the picture: heave, pitch, worst point, largest pressure."""
    pose = scene["pose"].values
    facts = [
        {"key": "heave", "label": "Heave", "unit": "m"},
        {"key": "pitch", "label": "Pitch, bow down", "unit": "deg"},
    ]
    curves = [pose[:, 2], np.degrees(pose[:, 4])]
    worst = worst_point(scene)
    if worst is not None:
        i, j = worst
        height = float(scene["deck_height"].values[i, j])
        if "relative_motion_history" in scene:
            rise = scene["relative_motion_history"].values[:, i, j]
        else:
            rise = height - scene["clearance_left"].values[:, i, j]
        place = [float(scene["x"][i]), float(scene["y"][j]), height]
        label = "Relative motion"
        facts.append({"key": "worst", "label": label, "unit": "m", "line": height, "place": place})
        curves.append(np.nan_to_num(rise))
    if "pressure" in scene:
        largest = np.nan_to_num(scene["pressure"].values).max(axis=(1, 2)) * 1e-3
        facts.append({"key": "largest_pressure", "label": "Largest pressure", "unit": "kPa"})
        curves.append(largest)
    return facts, np.array(curves)


def _triangles(faces: np.ndarray) -> np.ndarray:
    """Triangles of quadrilaterals; those without area (a corner repeated) are left out."""
    halves = np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])
    a, b, c = halves.T
    return halves[(a != b) & (b != c) & (c != a)]


def _floats(values) -> bytes:
    """Bytes of the values as little-endian 32-bit floats."""
    return np.ascontiguousarray(values, dtype="<f4").tobytes()


def _round_step(least: float) -> float:
    """Smallest round number that is not below `least` > 0."""
    decade = 10.0 ** np.floor(np.log10(least))
    return float(decade * _STEPS[np.argmax(_STEPS * decade >= least * (1 - 1e-9))])
