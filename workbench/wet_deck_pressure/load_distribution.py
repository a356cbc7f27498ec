"""Slam load of a given shape over nodes or cells of the deck: how it falls off along and across the ship.

.. [Amin] W. Amin, M. R. Davis, G. A. Thomas and D. S. Holloway, "Slamming quasi-static analysis of an Incat
    98-m high-speed wave piercing catamaran", University of Tasmania and Australian Maritime College, undated,
    section 3.2.
.. [Thomas2003] G. A. Thomas, PhD thesis, University of Tasmania, 2003, as [Amin]_ quotes it.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_choice, checked_number

SHAPES = ("linear along, quadratic across", "quadratic along, linear across")
"""Of [Amin]_ by the pressures measured on a model, and of [Thomas2003]_."""

QUASI_STATIC = (
    "A quasi-static load: provisional, since it leaves out how the slam grows and how the response travels "
    "along the ship; use a history of the load for whipping."
)


@dataclass(frozen=True, kw_only=True)
class SlamDistribution:
    """Shape of a slam load, 1 at its largest.

    Parameters
    ----------
    x : station of the largest load, from amidships [m].
    fore_length, aft_length : over which it falls to nothing forward and aft of that [m].
    y : half-breadth of the largest load [m]: the top of the arch of a wave piercer, or half way between
        centre bow and demihull. The load is mirrored in y; 0 for one strip on the centreline.
    half_width : over which it falls to nothing to either side of that [m].
    shape : one of `SHAPES`.

    Notes
    -----
    The source shows the shapes in figures only; the lengths are the user's. With distances over these
    lengths, "linear" is 1 - d, "quadratic" 1 - d**2, neither below 0 ([Amin]_ 3.2).
    """

    x: float
    fore_length: float
    aft_length: float
    y: float
    half_width: float
    shape: str = SHAPES[0]

    def __post_init__(self):
        checked_number("station of the largest load", self.x, "m")
        checked_number("half-breadth of the largest load", self.y, "m", at_least=0)
        for name, length in (
            ("length of the load forward", self.fore_length),
            ("length of the load aft", self.aft_length),
            ("half-width of the load", self.half_width),
        ):
            checked_number(name, length, "m", above=0)
        checked_choice("shape of the load", self.shape, SHAPES)

    def along(self, x) -> np.ndarray:
        """Lengthwise share at stations [m], 1 at the largest [-]."""
        ahead = np.asarray(x, float) - self.x
        distance = np.where(ahead > 0, ahead / self.fore_length, -ahead / self.aft_length)
        return _fall(distance, 1 if self.shape == SHAPES[0] else 2)

    def across(self, y) -> np.ndarray:
        """Transverse share at half-breadths of either side [m], 1 at the largest [-]."""
        distance = np.abs(np.abs(np.asarray(y, float)) - self.y) / self.half_width
        return _fall(distance, 2 if self.shape == SHAPES[0] else 1)


def _fall(distance: np.ndarray, power: int) -> np.ndarray:
    return np.maximum(1 - distance**power, 0.0)


def nodal_forces(
    distribution: SlamDistribution,
    x,
    y,
    *,
    largest: float | None = None,
    total: float | None = None,
    area=None,
) -> xr.Dataset:
    """Vertical forces on nodes [N], and their resultant.

    Parameters
    ----------
    distribution : its shape.
    x, y : nodes (n) [m].
    largest : force on a node where the shape is 1 [N], the input of the source; or
    total : sum of the forces [N]. One of both.
    area : that each node stands for (n) [m2]: forces then go with the area, ``largest`` with the
        largest one. None takes nodes of equal weight, as the source does.

    Returns
    -------
    Dataset over point: ``nodal_force``, ``lengthwise_share``, ``transverse_share``, ``point_x``,
    ``point_y``; attributes ``total`` [N] and the resultant's place ``resultant_x``, ``resultant_y`` [m].
    """
    x, y = np.broadcast_arrays(*(np.atleast_1d(np.asarray(part, float)) for part in (x, y)))
    if (largest is None) == (total is None):
        raise InputError("a slam load must be given by its largest nodal force or by its total, one of both.")
    along, across = distribution.along(x), distribution.across(y)
    weight = np.ones(x.shape) if area is None else np.broadcast_to(np.asarray(area, float), x.shape)
    share = along * across * weight / weight.max()
    if not np.any(share > 0):
        raise InputError(
            f"a slam load must reach at least one of the {x.size} nodes, got none; move its largest load "
            f"(x {distribution.x:g} m, y {distribution.y:g} m), or make it longer or wider."
        )
    if total is not None:
        largest = checked_number("total of the slam load", total, "N", above=0) / share.sum()
    force = checked_number("largest nodal force", largest, "N", above=0) * share
    return quantities.dataset(
        {"point": np.arange(x.size)},
        method=f"slam load {distribution.shape}",
        warnings=[QUASI_STATIC],
        attrs={
            "total": float(force.sum()),
            "resultant_x": float((force * x).sum() / force.sum()),
            "resultant_y": float((force * y).sum() / force.sum()),
        },
        nodal_force=("point", force),
        lengthwise_share=("point", along),
        transverse_share=("point", across),
        point_x=("point", x),
        point_y=("point", y),
    )


def deck_forces(
    distribution: SlamDistribution,
    deck: xr.Dataset,
    *,
    largest: float | None = None,
    total: float | None = None,
) -> xr.Dataset:
    """Forces on the cells of a deck grid, as `nodal_forces` with the areas of the cells; point by rows of x."""
    x, y = np.meshgrid(deck.x.values, deck.y.values, indexing="ij")
    area = np.broadcast_to(deck.area.values, x.shape)
    return nodal_forces(distribution, x.ravel(), y.ravel(), largest=largest, total=total, area=area.ravel())


@dataclass(frozen=True, kw_only=True)
class Frames:
    """Frames of a ship, counted forward from the transom.

    Parameters
    ----------
    spacing : of the frames [m]; length : of the waterline, its aft end the transom [m].
    """

    spacing: float
    length: float

    def __post_init__(self):
        checked_number("frame spacing", self.spacing, "m", above=0)
        checked_number("waterline length", self.length, "m", above=0)

    def from_transom(self, frame):
        """Place of a frame from the transom [m]."""
        return self.spacing * np.asarray(frame, float)

    def x(self, frame):
        """Place of a frame from amidships [m]."""
        return self.from_transom(frame) - self.length / 2

    def frame(self, x):
        """Frame at a place from amidships [m], with its fraction."""
        return (np.asarray(x, float) + self.length / 2) / self.spacing

    def share_of_length(self, x):
        """Place from amidships [m] as the share of the waterline from the transom [-]."""
        return np.asarray(x, float) / self.length + 0.5

    def at_share(self, share):
        """Place from amidships of a share of the waterline from the transom [m]."""
        return (np.asarray(share, float) - 0.5) * self.length


INCAT_061 = Frames(spacing=1.2, length=92.4)
"""Of hull 061: waterline of [Amin]_ table 1; with this spacing all six places of table 3 are whole frames."""
