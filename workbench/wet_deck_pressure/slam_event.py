"""Slams as groups of immersions that belong together, and the one that matters most, by itself.

.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025, 6.2.
"""

import numpy as np
import xarray as xr
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from workbench import quantities
from workbench.errors import InputError, checked_number

ISOLATION = 0.2
"""Time after first contact within which wetted points belong to the slam [s], for a model of 1.1 m [Baggus2025]_."""

ISOLATION_LENGTH = 1.1
"""Length of the ship of which that is the window [m]."""


def isolation_window(length: float) -> float:
    """Window of the source for a ship of a length, by Froude's law [s]."""
    return ISOLATION * float(np.sqrt(checked_number("length", length, "m", above=0) / ISOLATION_LENGTH))


def slams(immersions: xr.Dataset, deck: xr.Dataset, window: float = ISOLATION) -> xr.Dataset:
    """Immersions grouped into slams.

    Parameters
    ----------
    immersions : from `workbench.slamming.immersion.immersions`; deck : the same deck.
    window : two immersions of the same or of neighbouring points, diagonals included, belong to one
        slam if they start within this time of one another [s].

    Returns
    -------
    Dataset over event and slam: ``slam_number`` (event), -1 for points in the water at the start; by
    slam, in order of first contact, ``slam_start``, ``slam_spread``, ``slam_points`` (entries),
    ``contact_x``, ``contact_y`` (of the first point, the mean of those that are first together),
    ``immersion_depth`` and ``entry_velocity``, the largest of it.

    Notes
    -----
    The instants of waves that repeat lie on a circle: a slam across the end of the period is one slam,
    and its start is what follows its longest pause. A slam that spreads for longer than its own pauses
    and the whole period has no such start; then the earliest instant serves.
    """
    checked_number("window of a slam", window, "s", above=0)
    entered = np.flatnonzero(~np.isnan(immersions.entry_velocity.values))
    period = float(immersions.attrs["duration"]) if immersions.attrs["periodic"] else None
    time = immersions.event_time.values[entered]
    labels = np.full(immersions.sizes["event"], -1)
    labels[entered] = _groups(immersions, deck, entered, time, window, period)
    x, y = immersions.event_x.values, immersions.event_y.values
    rows = []
    for label in range(labels.max(initial=-1) + 1):
        mine = np.flatnonzero(labels == label)
        start, since = _since_first(immersions.event_time.values[mine], period)
        first = mine[since <= 1e-9 * max(window, 1.0)]
        rows.append(
            (
                start, since.max(), len(mine), x[first].mean(), y[first].mean(),
                immersions.immersion_depth.values[mine].max(), immersions.entry_velocity.values[mine].max(),
                label,
            )
        )  # fmt: skip
    rows.sort()
    renamed = np.full(len(rows) + 1, -1)
    renamed[[row[-1] for row in rows]] = np.arange(len(rows))
    columns = np.array([row[:-1] for row in rows]).reshape(-1, 7).T
    names = (
        "slam_start",
        "slam_spread",
        "slam_points",
        "contact_x",
        "contact_y",
        "immersion_depth",
        "entry_velocity",
    )
    return quantities.dataset(
        {"event": immersions.event, "slam": np.arange(len(rows))},
        method="immersions of neighbouring points grouped in time",
        attrs={"window": float(window)},
        slam_number=("event", renamed[labels]),
        **{name: ("slam", column) for name, column in zip(names, columns, strict=True)},
    )


def _groups(immersions, deck, entered, time, window, period) -> np.ndarray:
    """Label of the connected group of each entry."""
    if not len(entered):
        return np.zeros(0, int)
    row = np.searchsorted(deck.x.values, immersions.event_x.values[entered])
    column = np.searchsorted(deck.y.values, immersions.event_y.values[entered])
    places, box = [row, column, time / window], None
    if period is not None:
        # box sides of the two directions along the deck are so wide that nothing meets around them
        places[2] = np.mod(time - float(immersions.attrs["start"]), period) / window
        box = [row.max() + 10.0, column.max() + 10.0, period / window]
        places[2] = np.where(places[2] >= box[2], 0.0, places[2])
    pairs = cKDTree(np.stack(places, axis=1).astype(float), boxsize=box).query_pairs(
        1.0 + 1e-9, p=np.inf, output_type="ndarray"
    )
    count = len(entered)
    graph = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return connected_components(graph, directed=False)[1]


def _since_first(time: np.ndarray, period: float | None) -> tuple[float, np.ndarray]:
    """First instant of a group, and the time of each since then, around the circle of a period."""
    if period is None:
        return float(time.min()), time - time.min()
    ordered = np.sort(time)
    pauses = np.diff(np.append(ordered, ordered[0] + period))
    start = float(ordered[(np.argmax(pauses) + 1) % len(ordered)])
    return start, np.mod(time - start, period)


def slam_event(
    immersions: xr.Dataset,
    deck: xr.Dataset,
    *,
    window: float = ISOLATION,
    number: int | None = None,
) -> xr.Dataset:
    """One slam by itself: its wetted points, with times counted from first contact.

    Parameters
    ----------
    immersions : from `workbench.slamming.immersion.immersions`; deck : the same deck.
    window : of `slams`; what gets wet later than this after first contact is left out [s] ([Baggus2025]_
        6.2: 0.2 s for a model of 1.1 m, see `isolation_window`).
    number : of the slam in `slams`; None takes the deepest immersion, as the source does.

    Returns
    -------
    Dataset over event, in the order of wetting: ``event_x``, ``event_y``, ``time_since_contact``,
    ``entry_velocity``, ``entry_angle``, ``immersion_depth``, ``area``, ``panel_aft`` and ``panel_fore``
    (edges of the cell); attributes ``start``, ``spread`` (time from the first to the last point [s]),
    ``contact_x``, ``contact_y``. Only the first wetting of each point counts.
    """
    grouped = slams(immersions, deck, window)
    if not grouped.sizes["slam"]:
        raise InputError(
            "immersions must hold a point that enters the water, got none; raise the waves or lower the deck."
        )
    if number is None:
        number = int(np.argmax(grouped.immersion_depth.values))
    count = grouped.sizes["slam"]
    checked_number("number of the slam", number, at_least=0, at_most=count - 1)
    chosen = np.flatnonzero(grouped.slam_number.values == int(number))
    period = float(immersions.attrs["duration"]) if immersions.attrs["periodic"] else None
    start, since = _since_first(immersions.event_time.values[chosen], period)
    order = np.argsort(since, kind="stable")
    chosen, since = chosen[order], since[order]
    row = np.searchsorted(deck.x.values, immersions.event_x.values[chosen])
    column = np.searchsorted(deck.y.values, immersions.event_y.values[chosen])
    _, earliest = np.unique(row * deck.sizes["y"] + column, return_index=True)
    kept = np.sort(earliest)
    kept = kept[since[kept] <= window]
    chosen, since, row, column = chosen[kept], since[kept], row[kept], column[kept]
    edges = cell_edges(deck.x.values)
    own = immersions.isel(event=chosen)
    return quantities.dataset(
        {"event": np.arange(len(chosen))},
        method="one slam by itself",
        warnings=quantities.warnings_of(immersions),
        attrs={
            "start": start,
            "spread": float(since.max()),
            "contact_x": float(grouped.contact_x[int(number)]),
            "contact_y": float(grouped.contact_y[int(number)]),
            "window": float(window),
        },
        time_since_contact=("event", since),
        area=("event", np.broadcast_to(deck.area.values, deck.height.shape)[row, column]),
        panel_aft=("event", edges[row]),
        panel_fore=("event", edges[row + 1]),
        **{
            name: ("event", own[name].values)
            for name in ("event_x", "event_y", "entry_velocity", "entry_angle", "immersion_depth")
        },
    )


def cell_edges(centres: np.ndarray) -> np.ndarray:
    """Edges of the cells of evenly or unevenly spaced centres, (n + 1); a single cell has no length."""
    centres = np.asarray(centres, float)
    if len(centres) < 2:
        return np.array([centres[0], centres[0]])
    middles = (centres[1:] + centres[:-1]) / 2
    return np.concatenate([[2 * centres[0] - middles[0]], middles, [2 * centres[-1] - middles[-1]]])
