"""What is drawn of a water entry: outline, and pressure, water and histories by theory, as plain values and one block.

No physics here: everything is taken from the Datasets of `workbench.impact.entry_case`.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from workbench.impact.entry_case import ON_REQUEST, THEORIES, ComparedEntries, EntryCase
from workbench.impact.free_surface import FreeSurface, free_surface
from workbench.impact.section import Circle, Section, TableSection, Wedge
from workbench.quantities import warnings_of
from workbench.theory_lines import THEORY_LINES

OUTLINE = 121
WIDEST, ROOM = 2.0, 1.5
"""Half-breadth drawn, in largest wetted half-breadths, at most and at least [-]."""

SETTLED, SOON = 0.5, 0.1
"""Shares of the film after which peaks, and averages over the panel, set their scales: blunt sections begin with
infinite ones."""

HISTORIES = {
    "half_breadth": "wetted_half_breadth", "rate": "wetted_rate", "force": "section_force",
    "peak": "peak_pressure", "k": "peak_coefficient", "peak_height": "peak_height",
}  # fmt: skip


def section_scene(
    case: EntryCase, compared: ComparedEntries, waiting: Mapping[str, str] | None = None, title: str = ""
) -> tuple[dict[str, Any], bytes]:
    """Return facts (plain values, SI) and block (float32) of what is drawn.

    Parameters
    ----------
    case : the entry; compared : its entries by theory.
    waiting : theories still to come, each with a sentence.
    title : above the picture.

    Notes
    -----
    Facts of a theory hold ``offset`` into the block [floats]; from there, instant by instant,
    ``points`` positions and as many pressures, then ``surface_points`` positions and heights of the water.
    """
    waiting = dict(waiting or {})
    times = case.times() if not compared.found else next(iter(compared.found.values())).time.values
    reach = _reach(case, compared.found)
    surfaces = {name: free_surface(case.section, one, reach) for name, one in compared.found.items()}
    blocks: list[np.ndarray] = []
    theories = []
    offset = 0
    for name, words in THEORIES.items():
        facts = {
            "name": name,
            "label": words,
            **_line(name),
            "on_request": name in ON_REQUEST,
        }
        if name in compared.found:
            one, block = _theory(compared.found[name], surfaces[name], case)
            theories.append({**facts, "status": "ready", "offset": offset, **one})
            blocks.append(block)
            offset += block.size
        elif name in compared.refused:
            theories.append({**facts, "status": "refused", "sentence": compared.refused[name]})
        elif name in waiting:
            theories.append({**facts, "status": "waiting", "sentence": waiting[name]})
    low, high = _heights(case, surfaces, reach)
    facts = {
        "title": title or f"{section_words(case.section)} enters calm water",
        "times": times.tolist(), "motion": _motion(case, times),
        "outline": _outline(case, reach, high), "reach": reach, "low": low, "high": high,
        "density": case.density, "panel": case.panel and list(case.panel),
        "tops": _tops(compared.found, case), "theories": theories,
    }  # fmt: skip
    block = np.concatenate(blocks).astype("<f4") if blocks else np.empty(0, "<f4")
    return facts, block.tobytes()


def _line(method: str) -> dict[str, Any]:
    """Return colour, dash and width of a theory's line."""
    colour, dash, width = THEORY_LINES[method]
    return {"colour": colour, "dash": list(dash), "width": width}


def section_words(section: Section) -> str:
    """Return what a section is, in some words."""
    if isinstance(section, Wedge):
        return f"Wedge of {np.degrees(section.deadrise_angle):.3g} degrees deadrise"
    if isinstance(section, TableSection):
        return f"Section of {len(section.points)} points"
    return f"{section.kind.capitalize()} of {section.radius:.4g} m radius"


def _motion(case: EntryCase, times: np.ndarray) -> dict[str, list[float]]:
    """Return penetration [m] and velocity [m/s] over the instants."""
    return {
        "penetration": (case.velocity * times - case.deceleration * times**2 / 2).tolist(),
        "velocity": (case.velocity - case.deceleration * times).tolist(),
    }


def _theory(
    found: xr.Dataset, surface: FreeSurface | None, case: EntryCase
) -> tuple[dict[str, Any], np.ndarray]:
    """Return facts and block of one theory."""
    histories = {word: _numbers(found[name].values) for word, name in HISTORIES.items()}
    if "panel_pressure" in found:
        histories["panel"] = _numbers(found["panel_pressure"].values[:, 0])
    place = found["peak_height"].values + found["penetration"].values
    histories["peak_place"] = _numbers(_half_breadth_at(case, place))
    parts = []
    if "section_pressure" in found:
        parts += [found["pressure_position"].values, found["section_pressure"].values]
    points = found.sizes.get("point", 0)
    if surface is not None:
        parts += list(surface)
    facts = {
        "points": points, "surface_points": 0 if surface is None else surface.position.shape[1],
        "histories": histories, "warnings": list(warnings_of(found)),
    }  # fmt: skip
    limit = np.finfo(np.float32).max
    block = np.concatenate([np.asarray(part) for part in parts], axis=1) if parts else np.empty((0, 0))
    return facts, np.clip(block, -limit, limit).ravel()


def _half_breadth_at(case: EntryCase, height: np.ndarray) -> np.ndarray:
    """Half-breadth of the section [m] at heights above its lowest point [m], for where a peak is marked."""
    top = float(np.nanmax(height)) if np.any(np.isfinite(height)) else 0.0
    wide = 1.0 if np.isinf(case.section.reach) else case.section.reach
    while np.isinf(case.section.reach) and float(case.section.height(wide)) < top:
        wide *= 2
    y = np.linspace(0.0, wide, 4001)
    rise = case.section.height(y)
    last = np.searchsorted(rise, 1e-12 * max(top, 1e-12), side="right") - 1
    return np.where(np.isfinite(height), np.interp(height, rise[last:], y[last:]), np.nan)


def _numbers(values: np.ndarray) -> list[float | None]:
    """Return numbers, None where there is none."""
    return [float(value) if np.isfinite(value) else None for value in np.asarray(values, float)]


def _reach(case: EntryCase, found: Mapping[str, xr.Dataset]) -> float:
    """Return the half-breadth that is drawn [m]."""
    breadths = [
        float(one["wetted_half_breadth"][-1])
        for one in found.values()
        if np.isfinite(one["wetted_half_breadth"][-1])
    ]
    wetted = max(breadths, default=1.0)
    tips = [_tip(case, one) for one in found.values() if "jet_height" in one]
    outer = 1.1 * max(tips, default=0.0)
    if case.panel is not None:
        outer = max(outer, 1.15 * case.panel[1])
    return float(np.clip(outer, ROOM * wetted, WIDEST * wetted))


def _tip(case: EntryCase, one: xr.Dataset) -> float:
    """Return the half-breadth of the jet tip at the end [m]."""
    height = np.atleast_1d(float(one["jet_height"][-1]) + float(one["penetration"][-1]))
    return float(_half_breadth_at(case, height)[0])


def _heights(
    case: EntryCase, surfaces: Mapping[str, FreeSurface | None], reach: float
) -> tuple[float, float]:
    """Return lowest and highest z that are drawn [m]."""
    depth = case.penetration
    high = 0.6 * depth
    for surface in surfaces.values():
        if surface is not None:
            drawn = surface.position[-1] < reach
            high = max(high, 1.15 * float(surface.height[-1][drawn].max(initial=0.0)))
    return -1.25 * depth, high


def _outline(case: EntryCase, reach: float, high: float) -> dict[str, list[float]]:
    """Return the half of the section as far as it is drawn, z above its lowest point."""
    section = case.section
    end = min(reach, section.reach)
    y = np.linspace(0.0, end, OUTLINE)
    if isinstance(section, TableSection):
        bends = np.array(section.points)[:, 0]
        y = np.union1d(y, bends[bends <= end])
    if isinstance(section, Circle):
        y = np.union1d(y, section.radius * np.sin(np.linspace(0, np.pi / 2, OUTLINE))[:-1])
        y = y[y <= max(end, 0.0)]
    z = section.height(y)
    below = z <= 2.5 * (high + case.penetration)
    last = int(np.flatnonzero(below)[-1]) + 2
    return {"y": y[:last].tolist(), "z": z[:last].tolist()}


def _tops(found: Mapping[str, xr.Dataset], case: EntryCase) -> dict[str, float]:
    """Return where the axes end: pressure [Pa], force [N/m], pressure of the panel [Pa], k [-]."""
    count = len(case.times())

    def largest(name: str, share: float = 0.0) -> float:
        first = int(share * count)
        values = [
            np.ravel(one[name].values[min(first, one.sizes["time"] - 1) :])
            for one in found.values()
            if name in one
        ]
        together = np.concatenate([np.empty(0), *values])
        return float(together[np.isfinite(together)].max(initial=0.0))

    pressure = largest("peak_pressure", SETTLED)
    if pressure == 0 and "von-karman" in found:
        pressure = 4 * float(found["von-karman"]["section_pressure"][-1, 0])
    return {
        "pressure": 1.12 * pressure, "force": 1.08 * largest("section_force"),
        "panel": 1.12 * largest("panel_pressure", SOON), "k": 1.12 * largest("peak_coefficient", SETTLED),
    }  # fmt: skip
