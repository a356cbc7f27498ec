"""A box-like hull with round bilges, a ship-shaped bow and a rising stern."""

import numpy as np

from workbench.hulls.lines import Lines

BOW_POWER = 2.5
"""The bow waterline narrows with this power of the distance from the fore shoulder."""

STERN_RISE, STERN_POWER = 0.8, 1.8
"""Fraction of the draught by which the keel rises to the transom, and with which power of the distance."""


def heavy_lift_box_lines(
    length: float,
    beam: float,
    draught: float,
    depth: float,
    bilge_radius: float,
    bow_length: float,
    stern_length: float,
) -> Lines:
    """Lines of a wall-sided hull [m].

    Sections are rectangles with bilges of `bilge_radius`, of area
    2 b d - (2 - pi/2) r**2 for half-breadth b and depth d. Over `bow_length`
    the half-breadth falls to zero as 1 - v**2.5; over `stern_length` the keel
    rises by 0.8 draughts as u**1.8. Without both ends it is a plain box.
    """
    x = _stations(length, bow_length, stern_length)
    bow = np.clip((x - length / 2 + bow_length) / bow_length, 0.0, 1.0) if bow_length else np.zeros_like(x)
    stern = np.clip((stern_length - length / 2 - x) / stern_length, 0.0, 1.0) if stern_length else 0 * x
    half_breadth = beam / 2 * (1.0 - bow**BOW_POWER)
    bottom = -draught * (1.0 - STERN_RISE * stern**STERN_POWER)
    contours = [
        _contour(b, z, min(bilge_radius, b, -z), depth - draught)
        for b, z in zip(half_breadth, bottom, strict=True)
    ]
    grid = np.stack(contours)
    return Lines(x, grid[..., 0], grid[..., 1])


def _stations(length: float, bow_length: float, stern_length: float) -> np.ndarray:
    """Return stations from the stern to the bow, close in both ends."""
    shoulders = stern_length - length / 2, length / 2 - bow_length
    pieces = [np.linspace(*shoulders, 5)]
    if stern_length:
        pieces.append(np.linspace(-length / 2, shoulders[0], 33))
    if bow_length:
        pieces.append(length / 2 - bow_length * np.linspace(1.0, 0.0, 41) ** 1.3)
    return np.unique(np.round(np.concatenate(pieces) / length, 12)) * length


def _contour(half_breadth: float, bottom: float, radius: float, freeboard: float) -> np.ndarray:
    """Return (y, z) from the keel over the bilge to the deck edge."""
    angle = np.linspace(0.0, np.pi / 2, 17)
    bilge = np.stack(
        [
            half_breadth - radius + radius * np.sin(angle),
            bottom + radius - radius * np.cos(angle),
        ],
        axis=1,
    )
    flat = np.stack([np.linspace(0.0, half_breadth - radius, 9)[:-1], np.full(8, bottom)], axis=1)
    side = np.linspace(bottom + radius, 0.0, 7)[1:]
    topside = np.linspace(0.0, freeboard, 6)[1:]
    wall = np.concatenate([side, topside])
    return np.concatenate([flat, bilge, np.stack([np.full(wall.size, half_breadth), wall], axis=1)])
