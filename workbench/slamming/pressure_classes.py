"""Slams of a condition in classes of entry velocity squared, each with its velocity and pressure.

Pressure goes with the velocity squared: [Grande2002]_ sorts the slams of a condition into five groups of equal
width in it, computes one pressure p = rho k v**2/2 for each (6.9), and shows how many slams have which
(4.3, 7.1.2). The source does not state the limits; here they go from 0 to the largest of the condition.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.impact.pressure import PressureLaw
from workbench.impact.wagner import impact_pressure
from workbench.slamming.events import CLASSES, velocity_classes
from workbench.slamming.joint_law import ranked_pressures
from workbench.slamming.pressure_statistics import level_exceeded
from workbench.slamming.statistics import HOUR

_FINE, _LEVELS = 16, 120
"""Parts of a class of constant velocity in the closed form, and pressures among which it finds the largest."""


def pressure_classes(
    events: xr.Dataset, coefficient: float, density: float, classes: int = CLASSES
) -> xr.Dataset:
    """Pressure histogram of a seaway: counted slams in classes of velocity squared (velocity_class).

    Parameters
    ----------
    events : from `workbench.slamming.events.entries`, of one point (`entries_at`) or of all; those whose velocity
        is 0 (material velocity, the deck not coming down on the water) are no slams.
    coefficient : k of the panel [-]; density : of the water [kg/m3]; classes : how many.

    Returns
    -------
    Dataset over velocity_class: ``class_limit`` (upper, of the velocity squared), ``class_count``,
    ``class_per_hour``, ``class_mean_velocity``, ``class_pressure`` (that of the mean of the velocity squared, which
    is the mean pressure of the class; of its middle where it is empty); ``slams_per_hour``, ``mean_entry_velocity``
    of all (0 without slams).
    """
    coefficient = _checked_coefficient(coefficient)
    slamming = events.isel(event=np.flatnonzero(events.entry_velocity.values > 0))
    velocity = slamming.entry_velocity.values
    found = velocity_classes(slamming, classes)
    limits = np.concatenate([[0.0], found.class_limit.values])
    count = found.class_count.values
    middle = (limits[1:] + limits[:-1]) / 2
    squares = _in_class(velocity**2, velocity**2, limits, count, middle)
    hours = checked_number("duration of the record", events.attrs.get("duration"), "s", above=0) / HOUR
    return _result(
        events.attrs["method"],
        quantities.warnings_of(events),
        {"coefficient": coefficient, "density": density, "duration": events.attrs["duration"]},
        limits,
        count / hours,
        _in_class(velocity**2, velocity, limits, count, np.sqrt(middle)),
        density * coefficient * squares / 2,
        float(velocity.mean()) if velocity.size else 0.0,
    ).assign(class_count=found.class_count)


def expected_classes(
    moments: xr.Dataset,
    statistics: xr.Dataset,
    deck: xr.Dataset,
    coefficient: float,
    density: float,
    hours: float = 1.0,
    classes: int = CLASSES,
) -> xr.Dataset:
    """Pressure histogram of a seaway in closed form, at one point of the deck (velocity_class).

    Parameters
    ----------
    moments, statistics, deck : as for `workbench.slamming.joint_law`, of one point (x and y of length 1). With
        the material velocity, crossings at which the deck does not come down on the water are no slams.
    coefficient : k of the panel [-]; density : of the water [kg/m3].
    hours : the classes reach to the most probable largest velocity of so many hours [h].

    Returns
    -------
    As `pressure_classes`, without ``class_count``, with ``most_probable_peak_pressure`` of the hours; the last class
    holds all slams above its lower limit.
    """
    coefficient = _checked_coefficient(coefficient)
    hours = checked_number("hours", hours, "h", above=0)
    if statistics.slams_per_hour.size != 1:
        raise InputError(f"classes are those of one point, got {statistics.slams_per_hour.size}; choose one.")
    law = PressureLaw(name="panel", coefficient=coefficient)
    ranked = ranked_pressures(moments, statistics, deck, law, density, min(1.0 / hours, 1.0) / 10)
    slams = float(ranked.number[ranked.pressure > 0].sum())
    levels = np.linspace(0.0, max(float(ranked.pressure[0].item()), 1.0), _LEVELS)
    largest = float(level_exceeded(levels, ranked.number_above(levels), 1 / hours).item())
    largest = largest if slams * hours > 1 else 0.0
    top = largest if largest > 0 else float(impact_pressure(1.0, coefficient, density))
    fine = np.linspace(0.0, top, classes * _FINE + 1)
    above = np.minimum(ranked.number_above(fine)[:, 0, 0], slams)
    above[0], above[-1] = slams, 0.0
    number = (above[:-1] - above[1:]).reshape(classes, _FINE)
    square = (2 / (density * coefficient) * (fine[1:] + fine[:-1]) / 2).reshape(classes, _FINE)
    weight = np.where(number.sum(axis=1, keepdims=True) > 0, number, 1.0)
    weight = weight / weight.sum(axis=1, keepdims=True)
    limits = 2 / (density * coefficient) * fine[::_FINE]
    speeds = np.sqrt(2 * ranked.pressure / (density * coefficient))
    mean = float((speeds * ranked.number).sum() / slams) if slams > 0 else 0.0
    return _result(
        statistics.attrs["method"],
        quantities.warnings_of(statistics),
        {"coefficient": coefficient, "density": density, "hours": hours},
        limits,
        number.sum(axis=1),
        (weight * np.sqrt(square)).sum(axis=1),
        density * coefficient / 2 * (weight * square).sum(axis=1),
        mean,
    ).assign(most_probable_peak_pressure=((), largest, quantities.attributes("most_probable_peak_pressure")))


def entries_at(events: xr.Dataset, x: float, y: float) -> xr.Dataset:
    """Entries of the one point of the deck at x, y [m]; none where it stays dry."""
    there = np.isclose(events.event_x.values, x) & np.isclose(events.event_y.values, y)
    return events.isel(event=np.flatnonzero(there))


def _checked_coefficient(coefficient: float) -> float:
    return checked_number("coefficient", coefficient, above=0, at_most=1e5, cure="give k of the panel")


def _in_class(square, values, limits, count, otherwise) -> np.ndarray:
    """Return the mean of values in each class of the velocity squared, or the other values where it is empty."""
    total, _ = np.histogram(square, bins=limits, weights=values)
    return np.where(count > 0, total / np.maximum(count, 1), otherwise)


def _result(method, notes, attrs, limits, per_hour, velocity, pressure, mean) -> xr.Dataset:
    return quantities.dataset(
        {"velocity_class": np.arange(1, len(limits))},
        method=method,
        warnings=notes,
        attrs=attrs,
        class_limit=("velocity_class", limits[1:]),
        class_per_hour=("velocity_class", per_hour),
        class_mean_velocity=("velocity_class", velocity),
        class_pressure=("velocity_class", pressure),
        slams_per_hour=((), float(np.sum(per_hour))),
        mean_entry_velocity=((), mean),
    )
