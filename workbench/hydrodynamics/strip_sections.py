"""Sections of the hulls of a ship as stacks that are solved together: each hull alone, or all at a station.

Dry stations are left out and count as zero. A section that has shrunk to a line (a sharp
stem, a skeg) is given a thickness of half a per cent of its girth, which leaves it the
sway of a plate. Where only the upper part has shrunk to a line (above a bulb), the section
is the closed contour below it.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from workbench.design import Hull
from workbench.geometry.lines import station_positions
from workbench.geometry.sections import HullSections, sections
from workbench.hulls.lines import evenly_spaced
from workbench.hydrodynamics.sections import SectionStack, WettedPanels, stack, wetted_panels

PINCHED = 1e-4
"""Two sides of a contour nearer than this share of its girth have shrunk to a line."""
PLATE = 0.0025
"""Half thickness given to a section without any, over its girth."""


class StationGroup(NamedTuple):
    """Stations (numbers) whose sections have the same number of panels, and these sections."""

    stations: np.ndarray
    sections: SectionStack
    panels: WettedPanels


@dataclass(frozen=True, eq=False)
class StripBody:
    """Sections over the length that do not feel those of other bodies.

    Parameters
    ----------
    x : stations from aft to fore [m].
    y : of the body's own axes in the ship [m]; its sections are about them.
    groups : the sections by equal numbers of panels; a station in none of them has no section.
    transoms : the last sections of the hulls that end in one.
    """

    x: np.ndarray
    y: float
    groups: tuple[StationGroup, ...]
    transoms: tuple["Transom", ...]


class Transom(NamedTuple):
    """Last section of one hull: numbers of its group and its row there, draught [m], numbers of its panels."""

    group: int
    row: int
    draught: float
    columns: np.ndarray


def strip_bodies(hull: Hull, stations: int, panels: int, together: bool) -> tuple[StripBody, ...]:
    """Bodies of a ship: one with all hulls, or one for each wet hull (the same sections for equal hulls)."""
    hulls = [one for one in sections(hull, stations, panels + 1) if one.x.size]
    if together and len(hulls) > 1:
        return (_joint_body(hulls, stations),)
    made: list[tuple[HullSections, StripBody]] = []
    for one in hulls:
        same = next((body for other, body in made if _are_alike(one, other)), None)
        if same is None:
            contours = _contours(one) - [one.position[1], 0.0]
            body = _body(one.x, one.position[1], [contours], [one.x[0]])
        else:
            body = StripBody(same.x, one.position[1], same.groups, same.transoms)
        made.append((one, body))
    return tuple(body for _, body in made)


def _contours(one: HullSections) -> np.ndarray:
    return np.stack([one.y, one.z], axis=-1)


def _are_alike(one: HullSections, other: HullSections) -> bool:
    """Whether two hulls have the same sections about their own axes."""
    close = 1e-9 * np.ptp(one.x)
    return (
        one.x.shape == other.x.shape
        and np.allclose(one.x, other.x, atol=close)
        and np.allclose(one.y - one.position[1], other.y - other.position[1], atol=close)
        and np.allclose(one.z, other.z, atol=close)
    )


def _joint_body(hulls: list[HullSections], stations: int) -> StripBody:
    """Return one body of all hulls, at common stations."""
    x = hulls[0].x
    if not all(one.x.shape == x.shape and np.allclose(one.x, x) for one in hulls):
        aft, fore = min(one.x[0] for one in hulls), max(one.x[-1] for one in hulls)
        beyond = 1e-6 * (fore - aft)  # where a hull ends in a transom, its forces end too
        ends = [(one.x[0], one.x[0] - beyond, one.x[-1], one.x[-1] + beyond) for one in hulls]
        x = np.unique(np.clip([*station_positions(aft, fore, stations), *np.ravel(ends)], aft, fore))
    return _body(x, 0.0, [_at_stations(one, x) for one in hulls], [one.x[0] for one in hulls])


def _at_stations(one: HullSections, x: np.ndarray) -> np.ndarray:
    """Contours of a hull at other stations, between its own; shrunk to a point beyond its ends."""
    upper = np.clip(np.searchsorted(one.x, x), 1, len(one.x) - 1)
    share = np.clip((x - one.x[upper - 1]) / (one.x[upper] - one.x[upper - 1]), 0.0, 1.0)[:, None, None]
    contours = _contours(one)
    found = contours[upper - 1] + share * (contours[upper] - contours[upper - 1])
    close = 1e-9 * np.ptp(one.x)
    beyond = (x < one.x[0] - close) | (x > one.x[-1] + close)
    found[beyond] = found[beyond][:, :1] * [1.0, 0.0]
    return found


def _body(x: np.ndarray, y: float, hulls: list[np.ndarray], aft: list[float]) -> StripBody:
    """Return a body from the contours (stations, points, 2) and the aft end of each of its hulls."""
    size = float(np.ptp(x))
    usable, wet, thin = zip(*(_usable(contours, size) for contours in hulls), strict=True)
    pattern = np.array(wet).T
    groups, places = [], {}
    for kept in np.unique(pattern[pattern.any(axis=1)], axis=0):
        members = np.flatnonzero(kept)
        stations = np.flatnonzero((pattern == kept).all(axis=1))
        sections_there, order = _group([usable[h][stations] for h in members], size)
        for h, columns in zip(members, order, strict=True):
            for row, station in enumerate(stations):
                places[h, station] = (len(groups), row, columns)
        groups.append(StationGroup(stations, sections_there, wetted_panels(sections_there)))
    transoms = []
    for h, contours in enumerate(hulls):
        last = int(np.argmin(np.abs(x - aft[h])))
        if pattern[last, h] and not thin[h][last]:
            group, row, columns = places[h, last]
            transoms.append(Transom(group, row, float(-contours[last, :, 1].min()), columns))
    return StripBody(x, y, tuple(groups), tuple(transoms))


def _usable(contours: np.ndarray, size: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Contours without pinched tops, at which stations there is a section at all, and where it was a line."""
    found = contours.copy()
    steps = np.diff(contours, axis=1)
    girths = np.hypot(*np.moveaxis(steps, -1, 0)).sum(axis=1)
    half = contours.shape[1] // 2
    gaps = np.linalg.norm(contours[:, :half] - contours[:, : -half - 1 : -1], axis=-1)
    closed = (gaps < PINCHED * girths[:, None]).cumprod(axis=1).sum(axis=1)
    for station in np.flatnonzero((closed > 1) & (closed < half) & (girths > 0)):
        top = closed[station] - 1
        below = contours[station, top : contours.shape[1] - top].copy()
        below[[0, -1]] = below[[0, -1]].mean(axis=0)
        found[station] = evenly_spaced(below, contours.shape[1])
    thin = gaps.max(axis=1) < 2 * PLATE * girths
    height = np.linspace(-1.0, 1.0, contours.shape[1])  # from starboard waterline to port, 0 on the keel
    profile = np.sign(height) * np.sqrt(1 - (1 - np.abs(height)) ** 2)
    found[thin, :, 0] += PLATE * girths[thin, None] * profile
    return found, girths > 1e-6 * size, thin


def _group(contours: list[np.ndarray], size: float) -> tuple[SectionStack, list[np.ndarray]]:
    """Stack of the sections of several hulls, as a half where it is its own mirror image.

    With it, for each hull, the numbers of its panels among all panels.
    """
    close = 1e-9 * size
    panels = contours[0].shape[1] - 1

    def is_image(one, other):
        return np.allclose(one * [-1, 1], other[:, ::-1], atol=close)

    alone = [is_image(one, one) for one in contours]
    pair = len(contours) > 1 and is_image(contours[0], contours[1])
    half = panels // 2
    if alone == [True]:
        whole = np.concatenate([np.arange(half), half + np.arange(half)])
        return stack([contours[0][:, half:]], mirrored=True, half=(True,)), [whole]
    if pair and len(contours) == 2:
        order = sorted((0, 1), key=lambda h: -contours[h][0, :, 0].mean())
        stacked = stack([contours[order[0]]], mirrored=True)
        columns = [np.arange(panels), panels + np.arange(panels)]
        return stacked, [columns[order.index(h)] for h in (0, 1)]
    if pair and len(contours) == 3 and alone[2]:
        order = sorted((0, 1), key=lambda h: -contours[h][0, :, 0].mean())
        stacked = stack([contours[order[0]], contours[2][:, half:]], mirrored=True, half=(False, True))
        outer, centre = np.arange(panels), panels + np.arange(half)
        columns = [outer, outer + panels + half]
        both = np.concatenate([centre, centre + panels + half])
        return stacked, [columns[order.index(h)] for h in (0, 1)] + [both]
    return stack(contours), [panels * h + np.arange(panels) for h in range(len(contours))]
