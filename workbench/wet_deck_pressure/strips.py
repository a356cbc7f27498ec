"""The deck cut into strips: lengthwise, as waves meet it, or across, where a pod or centre bow hangs under it."""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench.design import WetDeck
from workbench.errors import checked_choice
from workbench.geometry.wet_deck import wet_deck_height
from workbench.wet_deck_pressure.strip_profiles import value_operator

DIRECTIONS = ("auto", "lengthwise", "across")
_TABLE_PER_PANEL = 16


@dataclass(frozen=True, eq=False)
class DeckStrips:
    """Strips of a deck grid.

    Parameters
    ----------
    direction : "lengthwise" or "across".
    nodes : centres of the panels along a strip [m]; edges : of the panels [m].
    width : of a strip [m].
    table : (strips, m) height of the deck above the water at rest, evenly spaced along each strip [m].
    smooth : (strips, panels) share of that height that goes through a spline of the nodes [m]: lengthwise
        all of it, so that the deck's kinks are as soft as a panel is long; across none, where the V of a pod
        is what matters.
    """

    direction: str
    nodes: np.ndarray
    edges: np.ndarray
    width: float
    table: np.ndarray
    smooth: np.ndarray

    @property
    def sharp(self) -> np.ndarray:
        """Share of the height that keeps its kinks (strip, m) [m]."""
        return np.zeros_like(self.table) if self.is_lengthwise else self.table

    @property
    def is_lengthwise(self) -> bool:
        """Whether the strips run along the ship."""
        return self.direction == "lengthwise"

    @property
    def panel_area(self) -> float:
        """Area of a panel [m2]."""
        return self.width * float(self.edges[1] - self.edges[0])

    @property
    def lowest(self) -> np.ndarray:
        """Lowest height of the deck in each panel (strip, panel) [m]."""
        inside = self.table[:, :-1].reshape(len(self.table), len(self.nodes), -1).min(axis=2)
        return np.minimum(inside, self.table[:, _TABLE_PER_PANEL::_TABLE_PER_PANEL])

    @property
    def mean(self) -> np.ndarray:
        """Mean height of the deck over each panel (strip, panel) [m]."""
        middle = (self.table[:, 1:] + self.table[:, :-1]) / 2
        return middle.reshape(len(self.table), len(self.nodes), -1).mean(axis=2)

    def by_strip(self, field: np.ndarray) -> np.ndarray:
        """Field (..., x, y) of the grid as (..., strip, panel)."""
        return np.swapaxes(field, -1, -2) if self.is_lengthwise else field

    def on_grid(self, field: np.ndarray) -> np.ndarray:
        """Field (..., strip, panel) as (..., x, y)."""
        return self.by_strip(field)


def deck_strips(wet_deck: WetDeck, deck: xr.Dataset, direction: str = "auto") -> DeckStrips:
    """Cut a deck into strips, one for each row of panels.

    Parameters
    ----------
    wet_deck : its shape between the points of the grid.
    deck : grid from `workbench.geometry.wet_deck.wet_deck_grid`; where its ``height`` is less than that of
        the shape, the water under it stands higher, by the ship's own steady wave.
    direction : "lengthwise", "across", or "auto": across for a deck with a pod or centre bow, whose V is
        what meets the water, lengthwise otherwise.
    """
    checked_choice("direction of the strips", direction, DIRECTIONS)
    if direction == "auto":
        hangs = wet_deck.vee_depth > 0 or wet_deck.centre_bow_depth > 0
        direction = "across" if hangs else "lengthwise"
    x, y = deck.x.values, deck.y.values
    steady = wet_deck_height(wet_deck, *np.meshgrid(x, y, indexing="ij")) - deck.height.values
    ends_x, ends_y = (wet_deck.aft, wet_deck.fore), (-wet_deck.width / 2, wet_deck.width / 2)
    if direction == "lengthwise":
        nodes, ends, width = x, ends_x, wet_deck.width / len(y)
    else:
        nodes, ends, width = y, ends_y, (wet_deck.fore - wet_deck.aft) / len(x)
    places = np.linspace(*ends, _TABLE_PER_PANEL * len(nodes) + 1)
    shape = np.broadcast_arrays(places[None, :], (y if direction == "lengthwise" else x)[:, None])
    height = wet_deck_height(wet_deck, *(shape if direction == "lengthwise" else reversed(shape)))
    rise = steady.T if direction == "lengthwise" else steady
    table = height - rise @ value_operator(nodes, places).T
    centres = table[:, _TABLE_PER_PANEL // 2 :: _TABLE_PER_PANEL]
    smooth = centres if direction == "lengthwise" else np.zeros_like(centres)
    return DeckStrips(direction, nodes, np.linspace(*ends, len(nodes) + 1), width, table, smooth)
