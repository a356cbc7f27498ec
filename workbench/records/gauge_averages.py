"""Pressure averaged over an area from gauges read at the same instant.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, p. 20, table 3 and figure 7.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_choice
from workbench.records.reading import channel, channel_unit

PAIR = {"P6": 0.5, "P7": 0.5}
"""The two gauges off the centreline count as one."""


def _weights(gauges: tuple[str, ...], count: int) -> dict[str, float]:
    shares = {gauge: 1.0 for gauge in gauges if gauge != "pair"} | (PAIR if "pair" in gauges else {})
    return {gauge: share / count for gauge, share in shares.items()}


AREAS: dict[str, dict[str, float]] = {
    "I": _weights(("P1", "P2", "P3", "P8", "P9", "pair"), 6),
    "II": _weights(("P1", "P2", "P3", "pair"), 4),
    "III": _weights(("P1", "P8"), 2),
    "IV": _weights(("P1", "P8", "P2", "pair"), 4),
    "V": _weights(("P2", "pair"), 2),
}
"""Weights of the gauges in the five averages over the forward section ([Chuang1975]_)."""

SILENT = ("P9",)
"""Gauges that are 0 where they were not recorded, as in the tables of [Chuang1975]_."""

BOUNDS = {"I": 6.0, "II": 4.0}
"""Largest peak over average while no gauge reads suction: one gauge alone is loaded [-]."""


def area_average(pressures, area: str) -> np.ndarray:
    """Average over an area of simultaneous pressures by gauge, in their unit.

    Parameters
    ----------
    pressures : mapping of gauge ("P1" ...) to pressures of one shape; those of `SILENT` may be absent.
    area : one of I to V.
    """
    weights = AREAS[checked_choice("area of an average", area, AREAS)]
    absent = [gauge for gauge in weights if gauge not in pressures and gauge not in SILENT]
    if absent:
        raise InputError(
            f"average {area} needs the gauges {', '.join(weights)}; {', '.join(absent)} are missing."
        )
    return np.sum(
        [
            weight * np.asarray(pressures[gauge], float)
            for gauge, weight in weights.items()
            if gauge in pressures
        ],
        axis=0,
    )


def possible_areas(gauges) -> list[str]:
    """Areas that can be averaged with these gauges."""
    return [area for area, weights in AREAS.items() if set(weights) - set(SILENT) <= set(gauges)]


def area_averages(record_set: xr.Dataset) -> xr.Dataset:
    """Averages over all areas that the gauges of a record allow (time, gauge_area).

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`, with channels P1, P2 ... in Pa.

    Returns
    -------
    Dataset: ``average_pressure`` (time, gauge_area) [Pa].
    """
    pressures = gauge_samples(record_set)
    areas = possible_areas(pressures)
    if not areas:
        raise InputError(
            f"record must hold the gauges of an average, such as P1 and P8; it has {', '.join(pressures)}."
        )
    values = np.stack([area_average(pressures, area) for area in areas], axis=1)
    return quantities.dataset(
        {"time": record_set.time, "gauge_area": areas},
        method="equal weights, simultaneous",
        warnings=quantities.warnings_of(record_set),
        average_pressure=(("time", "gauge_area"), values),
    )


def gauge_samples(record_set: xr.Dataset) -> dict[str, np.ndarray]:
    """Pressures by gauge of the channels named P and a number [Pa]."""
    names = [str(name) for name in record_set.channel.values]
    gauges = [name for name in names if name[:1] == "P" and name[1:].isdigit()]
    for gauge in gauges:
        if channel_unit(record_set, gauge) not in ("Pa", "?"):
            raise InputError(f"gauge {gauge} must be in Pa, got {channel_unit(record_set, gauge)}.")
    if not gauges:
        raise InputError(f"record must hold gauges named P1, P2 and so on, got {', '.join(names)}.")
    return {gauge: channel(record_set, gauge) for gauge in gauges}


def largest_averages(record_set: xr.Dataset) -> xr.Dataset:
    """Largest simultaneous averages of a slam, and the largest gauge of each area over them (gauge_area).

    Parameters
    ----------
    record_set : of one slam.

    Returns
    -------
    Dataset over gauge_area: ``largest_average`` [Pa], ``average_time``, ``peak_over_average`` (largest maximum
    among the area's own gauges over its average, whenever they occur).
    """
    found = area_averages(record_set)
    pressures = gauge_samples(record_set)
    values = found.average_pressure.values
    areas = [str(area) for area in found.gauge_area.values]
    peaks = [max(pressures[gauge].max() for gauge in AREAS[area] if gauge in pressures) for area in areas]
    largest = values.max(axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(largest > 0, peaks / largest, np.nan)
    notes = [sentence for area, one in zip(areas, ratio, strict=True) for sentence in bound_notes(area, one)]
    return quantities.dataset(
        {"gauge_area": areas},
        method="equal weights, simultaneous",
        warnings=[*quantities.warnings_of(record_set), *notes],
        largest_average=("gauge_area", largest),
        average_time=("gauge_area", found.time.values[np.argmax(values, axis=0)]),
        peak_over_average=("gauge_area", ratio),
    )


def bound_notes(area: str, ratio: float) -> tuple[str, ...]:
    """Say so where a peak over average exceeds its bound without suction."""
    if area not in BOUNDS or not ratio > BOUNDS[area] * (1 + 1e-9):
        return ()
    return (
        f"Peak over average {area} is {ratio:.3g}, above {BOUNDS[area]:g}, which only simultaneous suction at other "
        "gauges allows; check their zeros.",
    )
