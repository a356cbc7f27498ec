"""The wet deck as a grid of points with height, slopes and area."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.design import WetDeck
from workbench.errors import checked_number

CENTRE_BOW_RUN = 0.6
"""Fraction of the length of a centre bow over which its keel comes down from the deck."""


def wet_deck_height(wet_deck: WetDeck, x, y) -> np.ndarray:
    """Height of the wet deck above still water [m] at points x, y [m] (broadcast), inside its outline.

    Flat part at the clearance; camber parabolic across; raked entry straight;
    pod and centre bow V-shaped, the keel of the centre bow coming down smoothly
    from its aft end over `CENTRE_BOW_RUN` of its length; corners quarter circles.
    """
    x, y = np.broadcast_arrays(np.asarray(x, float), np.abs(np.asarray(y, float)))
    half_width = wet_deck.width / 2
    height = wet_deck.clearance + wet_deck.camber * (1 - (y / half_width) ** 2)
    if wet_deck.entry_length > 0.0:
        height = height + wet_deck.entry_rise * np.clip(
            (x - wet_deck.fore) / wet_deck.entry_length + 1.0, 0.0, None
        )
    hanging = np.zeros_like(height)
    if wet_deck.vee_depth > 0.0:
        hanging = wet_deck.vee_depth * np.clip(1 - y / (wet_deck.vee_width / 2), 0.0, None)
    if wet_deck.centre_bow_depth > 0.0:
        run = (x - wet_deck.fore) / wet_deck.centre_bow_length + 1.0
        share = np.clip(run / CENTRE_BOW_RUN, 0.0, 1.0)
        keel = wet_deck.centre_bow_depth * share**2 * (3 - 2 * share)
        vee = keel * np.clip(1 - y / (wet_deck.centre_bow_width / 2), 0.0, None)
        hanging = np.maximum(hanging, vee)
    if wet_deck.corner_radius > 0.0:
        inward = np.clip(wet_deck.corner_radius - (half_width - y), 0.0, wet_deck.corner_radius)
        drop = wet_deck.corner_radius - np.sqrt(wet_deck.corner_radius**2 - inward**2)
        hanging = np.maximum(hanging, drop)
    return height - hanging - x * np.tan(wet_deck.trim)


def wet_deck_grid(wet_deck: WetDeck, n_x: int = 40, n_y: int = 10) -> xr.Dataset:
    """Grid over the wet deck: centres of n_x by n_y equal cells.

    Returns
    -------
    Dataset over x (from aft) and y (from starboard): ``height`` above still water [m], ``slope_x``
    and ``slope_y`` of the deck [-] over the cell, ``area`` of the cell on the water plane [m2] (the
    sum is exactly length times width).
    """
    n_x = int(checked_number("number of points along the wet deck", n_x, at_least=1, at_most=2000))
    n_y = int(checked_number("number of points across the wet deck", n_y, at_least=1, at_most=2000))
    step_x, step_y = (wet_deck.fore - wet_deck.aft) / n_x, wet_deck.width / n_y
    x = wet_deck.aft + step_x * (np.arange(n_x) + 0.5)
    y = -wet_deck.width / 2 + step_y * (np.arange(n_y) + 0.5)
    grid_x, grid_y = np.meshgrid(x, y, indexing="ij")

    def height(dx: float, dy: float) -> np.ndarray:
        return wet_deck_height(wet_deck, grid_x + dx, grid_y + dy)

    return quantities.dataset(
        coords={"x": x, "y": y},
        method="wet deck grid",
        height=(("x", "y"), height(0.0, 0.0)),
        slope_x=(("x", "y"), (height(step_x / 4, 0.0) - height(-step_x / 4, 0.0)) / (step_x / 2)),
        slope_y=(("x", "y"), (height(0.0, step_y / 4) - height(0.0, -step_y / 4)) / (step_y / 2)),
        area=(("x", "y"), np.full(grid_x.shape, step_x * step_y)),
    )


def lowest_height(wet_deck: WetDeck) -> float:
    """Height of the lowest point of the wet deck above still water [m]."""
    x = np.linspace(wet_deck.aft, wet_deck.fore, 201)
    y = np.linspace(0.0, wet_deck.width / 2, 101)
    return float(wet_deck_height(wet_deck, x[:, None], y[None, :]).min())
