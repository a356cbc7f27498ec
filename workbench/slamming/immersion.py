"""Immersions of the wet deck: where, when, how long, how deep, how fast and at which angle points get wet.

.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025, 5.2.1 and 6.2.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import checked_number
from workbench.slamming.level_crossings import crossings, peaks
from workbench.time_domain import record_blocks, records

SAMPLES_PER_PERIOD = 60
"""Samples in the shortest period of encounter, where no time step is given [-]."""

_LEAD = 2
_CHUNK = 8192


def immersions(
    relative_amplitudes: np.ndarray,
    slope_amplitudes: np.ndarray,
    frequency: np.ndarray,
    deck: xr.Dataset,
    *,
    duration: float,
    start: float = 0.0,
    time_step: float | None = None,
    periodic: bool = False,
) -> xr.Dataset:
    """Every immersion of every deck point in a record, or in one period of waves that repeat.

    Parameters
    ----------
    relative_amplitudes, slope_amplitudes : (component, x, y) complex, of relative motion [m] and of
        relative slope [-], as from `workbench.time_domain.relative_amplitudes`.
    frequency : encounter frequencies of the components [rad/s].
    deck : with ``height``, ``slope_x``, ``area`` (x, y).
    duration : of the record or of the period [s]; start : its first instant [s].
    time_step : [s]; None takes `SAMPLES_PER_PERIOD` in the shortest period.
    periodic : the waves repeat after ``duration``: an immersion that lasts past the end is followed
        beyond it, and so is not met a second time at the start.

    Returns
    -------
    Dataset over event, in time order: ``event_time`` of entry, ``event_x``, ``event_y``,
    ``entry_velocity``, ``entry_angle``, ``immersion_duration``, ``immersion_depth``, ``time_of_depth``.
    A point in the water at the start of a record, or through a whole period, has entry velocity and
    angle NaN. An immersion that the end of a record cuts off lasts to the end.

    Notes
    -----
    The entry is that of `workbench.slamming.events.entries`. Where waves repeat only nearly, nothing
    jumps: the record goes on as it is. Dips shorter than a time step may be missed. One hour of 240
    components at 20 Hz on 400 points costs about 4 s, one period of two waves some hundredths.
    """
    frequency = np.asarray(frequency, float)
    checked_number("duration of the record", duration, "s", above=0)
    checked_number("start of the record", start, "s", at_least=0)
    fastest = float(np.max(np.abs(frequency)))
    step = 2 * np.pi / fastest / SAMPLES_PER_PERIOD if time_step is None else time_step
    checked_number("time_step", step, "s", above=0, at_most=duration)
    relative_flat = np.asarray(relative_amplitudes).reshape(len(frequency), -1)
    slope_flat = np.asarray(slope_amplitudes).reshape(len(frequency), -1)
    level = deck.height.values.reshape(-1, 1)
    end = start + duration * (2 if periodic else 1)

    entry, leave, top = _found(relative_flat, frequency, level, start, end, step)
    point, begin, velocity = _begun(entry, relative_flat, frequency, level, start)
    finish = _ends(point, begin, leave, end)
    depth, deepest = _depths(point, begin, finish, top, relative_flat, frequency, level, end)
    kept = np.ones(len(begin), bool)
    if periodic:
        # in the water at the start: that immersion began in the period before, unless it never ends
        kept = np.where(np.isnan(velocity), finish >= end, begin < start + duration)
        finish = np.minimum(finish, begin + duration)
    order = np.flatnonzero(kept)[np.argsort(begin[kept], kind="stable")]
    point, begin, finish, velocity = point[order], begin[order], finish[order], velocity[order]
    incline = np.broadcast_to(deck.slope_x.values, deck.height.shape).ravel()[point]
    angle = np.arctan(_values(slope_flat, frequency, point, begin) - incline)
    row, column = np.unravel_index(point, deck.height.shape)
    return quantities.dataset(
        {"event": np.arange(len(point))},
        method="immersions in a period" if periodic else "immersions in a record",
        attrs={
            "start": float(start),
            "duration": float(duration),
            "time_step": float(step),
            "periodic": int(periodic),
        },
        event_time=("event", begin),
        event_x=("event", deck.x.values[row]),
        event_y=("event", deck.y.values[column]),
        entry_velocity=("event", velocity),
        entry_angle=("event", np.where(np.isnan(velocity), np.nan, angle)),
        immersion_duration=("event", finish - begin),
        immersion_depth=("event", depth[order]),
        time_of_depth=("event", deepest[order]),
    )


def _found(amplitudes, frequency, level, start, end, step):
    """Entries (point, time, velocity), exits (point, time) and peaks (point, time, depth) of the record."""
    begin = start - _LEAD * step
    turned = amplitudes * np.exp(-1j * frequency * begin)[:, None]
    parts: tuple[list, list, list] = [], [], []
    for first, rise in record_blocks(turned, frequency, end - begin + 3 * step, step, overlap=3):
        up, down, top = crossings(rise, level), crossings(rise, level, upwards=False), peaks(rise, level)
        parts[0].append((up.point, begin + (first + up.sample + up.share) * step, up.rate / step))
        parts[1].append((down.point, begin + (first + down.sample + down.share) * step))
        parts[2].append((top.point, begin + (first + top.sample + top.share) * step, top.height))
    joined = [[np.concatenate(columns) for columns in zip(*kind, strict=True)] for kind in parts]
    inside = [(kind[1] >= start) & (kind[1] <= end) for kind in joined]
    return [[column[mask] for column in kind] for kind, mask in zip(joined, inside, strict=True)]


def _begun(entry, amplitudes, frequency, level, start):
    """Point, time and velocity of entries and of points already in the water, by point and time."""
    point, time, velocity = entry
    wet = np.flatnonzero(records(amplitudes, frequency, np.array([start]))[:, 0] >= level[:, 0])
    point = np.concatenate([wet, point])
    time = np.concatenate([np.full(len(wet), float(start)), time])
    velocity = np.concatenate([np.full(len(wet), np.nan), velocity])
    order = np.lexsort((time, point))
    return point[order], time[order], velocity[order]


def _ends(point, begin, leave, end):
    """Time of the first exit of each point after each entry, or the end of the record."""
    order = np.lexsort((leave[1], leave[0]))
    leave_point, leave_time = leave[0][order], leave[1][order]
    index = np.searchsorted(_key(leave_point, leave_time, end), _key(point, begin, end), side="right")
    followed = index < len(leave_time)
    index = np.where(followed, index, 0)
    if not len(leave_time):
        return np.full(len(begin), float(end))
    return np.where(followed & (leave_point[index] == point), leave_time[index], end)


def _values(amplitudes, frequency, point, time):
    """Record of each point at its own instant."""
    found = np.empty(len(point))
    for first in range(0, len(point), _CHUNK):
        part = slice(first, first + _CHUNK)
        phase = np.exp(-1j * np.multiply.outer(frequency, time[part]))
        found[part] = np.einsum("cp,cp->p", amplitudes[:, point[part]], phase).real
    return found


def _key(point, time, end):
    """One number that orders by point, then by time."""
    return point * (4 * (abs(end) + 1.0)) + time


def _depths(point, begin, finish, top, amplitudes, frequency, level, end):
    """Largest depth of each immersion and its instant: of its peaks, its start and its end."""
    depth, instant = np.zeros(len(begin)), begin.copy()
    for ends in (begin, finish):
        there = _values(amplitudes, frequency, point, ends) - level[point, 0]
        deeper = there > depth
        depth, instant = np.where(deeper, there, depth), np.where(deeper, ends, instant)
    if not len(begin) or not len(top[0]):
        return depth, instant
    owner = np.searchsorted(_key(point, begin, end), _key(top[0], top[1], end), side="right") - 1
    valid = (owner >= 0) & (point[owner] == top[0]) & (top[1] <= finish[owner])
    order = np.argsort(top[2][valid], kind="stable")
    owner, time, height = owner[valid][order], top[1][valid][order], top[2][valid][order]
    np.maximum.at(depth, owner, height)
    last = height >= depth[owner]
    instant[owner[last]] = time[last]
    return depth, instant


def immersion_map(found: xr.Dataset, deck: xr.Dataset) -> xr.Dataset:
    """Map of the immersions over the deck, a value a point ([Baggus2025]_ 5.2.1, 6.2).

    Parameters
    ----------
    found : from `immersions`; deck : the same deck.

    Returns
    -------
    Dataset over (x, y): ``immersion_count`` entries, ``wetted_duration`` in all and
    ``longest_immersion`` [s], ``first_entry_time``, ``deepest_entry_time`` [s], ``immersion_depth`` [m],
    ``entry_velocity`` [m/s] and ``immersion_angle`` [rad] of the entry of the deepest immersion, ``area``
    [m2], and the flags ``ever_wet``, ``starts_in_water``, ``always_wet``. Points that are never wet have 0
    for number, durations and depth, and NaN for what belongs to an entry; so have those that are in the
    water already.
    """
    shape = deck.height.shape
    size = int(np.prod(shape))
    row = np.searchsorted(deck.x.values, found.event_x.values)
    column = np.searchsorted(deck.y.values, found.event_y.values)
    point = np.ravel_multi_index((row, column), shape)
    velocity, lasts = found.entry_velocity.values, found.immersion_duration.values
    depth, time = found.immersion_depth.values, found.event_time.values
    enters = ~np.isnan(velocity)

    longest, deepest = np.zeros(size), np.zeros(size)
    np.maximum.at(longest, point, lasts)
    np.maximum.at(deepest, point, depth)
    first = np.full(size, np.inf)
    np.minimum.at(first, point[enters], time[enters])
    chosen = np.full(size, -1)
    order = np.argsort(depth, kind="stable")
    chosen[point[order]] = order  # the deepest comes last and stays
    known = chosen >= 0

    def of_deepest(values):
        return np.where(known, values[chosen] if len(values) else np.nan, np.nan).reshape(shape)

    at_entry = np.where(enters, time, np.nan)
    dims = ("x", "y")
    starts = np.bincount(point[~enters], minlength=size) > 0
    total = np.bincount(point, lasts, minlength=size)
    always = starts & (total >= found.attrs["duration"] * (1 - 1e-12))
    return quantities.dataset(
        {"x": deck.x, "y": deck.y},
        method=found.attrs["method"],
        warnings=quantities.warnings_of(found),
        attrs={name: found.attrs[name] for name in ("start", "duration", "periodic")},
        immersion_count=(dims, np.bincount(point[enters], minlength=size).reshape(shape)),
        wetted_duration=(dims, total.reshape(shape)),
        longest_immersion=(dims, longest.reshape(shape)),
        first_entry_time=(dims, np.where(np.isfinite(first), first, np.nan).reshape(shape)),
        deepest_entry_time=(dims, of_deepest(at_entry)),
        immersion_depth=(dims, deepest.reshape(shape)),
        entry_velocity=(dims, of_deepest(velocity)),
        immersion_angle=(dims, of_deepest(found.entry_angle.values)),
        area=(dims, np.broadcast_to(deck.area.values, shape)),
        ever_wet=(dims, known.reshape(shape)),
        starts_in_water=(dims, starts.reshape(shape)),
        always_wet=(dims, always.reshape(shape)),
    )
