"""Slams counted in records of relative motion: when, where, how fast and at which angle.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 4.2-4.3.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.impact.pressure import PressureLaw, peak_pressure
from workbench.slamming.level_crossings import crossings
from workbench.slamming.statistics import HOUR
from workbench.time_domain import record_blocks

BAND_DEVIATES = 2.576
"""Normal deviate of the 99 % sampling band of a count [-]."""

CLASSES = 5
PARTS = 24
"""Equal parts of a record in which slams are counted, for the spread of their number."""


def entries(
    relative_amplitudes: np.ndarray,
    slope_amplitudes: np.ndarray,
    frequency: np.ndarray,
    deck: xr.Dataset,
    *,
    duration: float,
    time_step: float,
    threshold: float = 0.0,
    law: PressureLaw | None = None,
    density: float = 1025.0,
    drift: float = 0.0,
) -> xr.Dataset:
    """Every entry of every deck point into the water in a record.

    Parameters
    ----------
    relative_amplitudes, slope_amplitudes : (component, x, y) complex, of relative
        motion [m] and relative slope [-].
    frequency : encounter frequencies of the components [rad/s].
    deck : with ``height``, ``slope_x`` (x, y).
    duration, time_step : [s].
    threshold : least closing velocity (time derivative) that counts [m/s].
    law, density : pressure law and water density [kg/m3] for the peak pressures.
    drift : speed of the ship [m/s] if the entry velocity shall be the material one
        (closing velocity less speed times slope, not below 0); 0 gives the time derivative.

    Returns
    -------
    Dataset over event, in time order: ``event_time``, ``event_x``, ``event_y``,
    ``entry_velocity``, ``entry_angle``, ``peak_pressure``.

    Notes
    -----
    An entry is an up-crossing of the deck's height by the relative motion
    ([Grande2002]_ 4.2: crossing from above with closing velocity). Instant and
    velocity come from the cubic through the four samples about it. One hour at
    20 Hz on 400 points costs about 2 s.
    """
    shape = deck.height.shape
    height = deck.height.values.reshape(-1, 1)
    relative_flat = relative_amplitudes.reshape(len(frequency), -1)
    slope_flat = slope_amplitudes.reshape(len(frequency), -1)
    found = []
    for start, rise in record_blocks(relative_flat, frequency, duration, time_step, overlap=3):
        point, index, share, velocity = crossings(rise, height)
        if not point.size:
            continue
        instant = (start + index + share) * time_step
        phase = np.exp(-1j * np.multiply.outer(frequency, instant))
        water = np.einsum("ce,ce->e", slope_flat[:, point], phase).real
        found.append((instant, point, velocity / time_step, water))
    times, point, velocity, water = (
        (np.concatenate(parts) for parts in zip(*found, strict=True)) if found else (np.zeros(0),) * 4
    )
    point = point.astype(int)
    kept = (velocity > threshold) & (times <= duration)
    order = np.flatnonzero(kept)[np.argsort(times[kept], kind="stable")]
    times, point, velocity, water = times[order], point[order], velocity[order], water[order]
    row, column = np.unravel_index(point, shape)
    angle = np.arctan(water - deck.slope_x.values.ravel()[point])
    velocity = np.maximum(velocity - drift * water, 0.0) if drift else velocity
    pressure = peak_pressure(law or PressureLaw(), velocity, angle, density)
    return quantities.dataset(
        {"event": np.arange(len(times))},
        method="up-crossings counted in a record",
        attrs={
            "duration": float(duration),
            "time_step": float(time_step),
            "threshold_velocity": float(threshold),
        },
        event_time=("event", times),
        event_x=("event", deck.x.values[row]),
        event_y=("event", deck.y.values[column]),
        entry_velocity=("event", velocity),
        entry_angle=("event", angle),
        peak_pressure=("event", pressure),
    )


def counts(events: xr.Dataset, deck: xr.Dataset) -> xr.Dataset:
    """Slams per hour counted at each deck point, with the sampling band of the count.

    Returns
    -------
    Dataset over (x, y): ``counted_per_hour``, ``counted_band_low``,
    ``counted_band_high``.

    Notes
    -----
    The 99 % band of the rate behind the count. A Poisson count alone would be too
    sure of itself: slams come in groups, so the variance is that of the counts in
    24 equal parts of the record, pooled over the deck's points, and no less than
    the count. With no slam counted the upper end is the rate that would have given
    one with a probability of 99 %.
    """
    duration = events.attrs["duration"]
    n_x, n_y = deck.height.shape
    row = np.searchsorted(deck.x.values, events.event_x.values)
    column = np.searchsorted(deck.y.values, events.event_y.values)
    part = parts_of_record(events.event_time.values, duration)
    grouped = np.zeros((PARTS, n_x, n_y))
    np.add.at(grouped, (part, row, column), 1.0)
    number = grouped.sum(axis=0)
    dispersion = grouping_dispersion(grouped)
    half_width = BAND_DEVIATES * np.sqrt(dispersion)
    centre = number + half_width**2 / 2
    reach = half_width * np.sqrt(number + half_width**2 / 4)
    low = np.where(number > 0, np.maximum(centre - reach, 0.0), 0.0)
    high = np.where(number > 0, centre + reach, -np.log(0.01) * dispersion)
    per_hour = HOUR / duration
    dims = ("x", "y")
    return quantities.dataset(
        {"x": deck.x, "y": deck.y},
        method=events.attrs["method"],
        attrs={"duration": duration, "dispersion": dispersion},
        counted_per_hour=(dims, number * per_hour),
        counted_band_low=(dims, low * per_hour),
        counted_band_high=(dims, high * per_hour),
    )


def parts_of_record(times: np.ndarray, duration: float) -> np.ndarray:
    """Index of the equal part of the record that each time [s] falls in."""
    return np.clip((times / duration * PARTS).astype(int), 0, PARTS - 1)


def grouping_dispersion(grouped: np.ndarray) -> float:
    """Variance of the number of slams over that of a Poisson process [-], at least 1.

    Parameters
    ----------
    grouped : numbers in equal parts of a record (part, ...); pooled over all points with a slam a part or more.
    """
    parts, number = len(grouped), grouped.sum(axis=0)
    spread = grouped.var(axis=0, ddof=1)
    busy = number >= parts
    return max(1.0, float(np.mean(spread[busy] * parts / number[busy]))) if busy.any() else 1.0


def velocity_classes(events: xr.Dataset, classes: int = CLASSES) -> xr.Dataset:
    """Slams in classes of equal width of entry velocity squared (velocity_class).

    Pressure goes with the velocity squared; the source sorts the slams of a
    condition into five such groups ([Grande2002]_ 4.3). The classes reach from 0
    to the largest of the record.
    """
    square = events.entry_velocity.values**2
    top = float(square.max()) if square.size else 1.0
    limits = np.linspace(0, top, classes + 1)
    count, _ = np.histogram(square, bins=limits)
    return quantities.dataset(
        {"velocity_class": np.arange(1, classes + 1)},
        method=events.attrs["method"],
        class_limit=("velocity_class", limits[1:]),
        class_count=("velocity_class", count),
    )
