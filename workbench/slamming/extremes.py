"""Extremes: the largest entry velocity and peak pressure to expect in a number of hours.

.. [Ochi1964] M. K. Ochi, "Prediction of occurrence and severity of ship slamming
    at sea", 5th Symp. on Naval Hydrodynamics, Bergen, 1964, pp. 545-596.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.impact.pressure import PressureLaw, peak_pressure

_VELOCITY_STEPS = 36
_ANGLE_STEPS = 21
_ANGLE_REACH = 4.0


def largest_entry_velocity(
    moments: xr.Dataset, statistics: xr.Dataset, hours: float, exceedance: float = 1.0
) -> xr.DataArray:
    """Most probable largest entry velocity in a time (x, y) [m/s].

    Parameters
    ----------
    moments, statistics : from `workbench.slamming.statistics`.
    hours : duration [h].
    exceedance : expected number of entries above the answer; 1 gives the most probable
        largest value, alpha << 1 the value with that risk of being exceeded ([Ochi1964]_).

    Notes
    -----
    sqrt(v_threshold**2 + 2 m2 ln(N/exceedance)) for N slams expected; 0 where fewer are.
    """
    expected = statistics.slams_per_hour * hours / exceedance
    threshold = statistics.attrs["threshold_velocity"]
    square = threshold**2 + 2 * moments.relative_velocity_std**2 * np.log(np.maximum(expected, 1.0))
    velocity = np.sqrt(square).where(expected > 1.0, 0.0)
    return velocity.assign_attrs(quantities.attributes("most_probable_entry_velocity"))


def largest_peak_pressure(
    moments: xr.Dataset,
    statistics: xr.Dataset,
    deck: xr.Dataset,
    law: PressureLaw,
    density: float,
    hours: float,
    exceedance: float = 1.0,
) -> xr.DataArray:
    """Most probable largest peak pressure in a time, at every deck point (x, y) [Pa].

    Parameters
    ----------
    moments, statistics : from `workbench.slamming.statistics`.
    deck : with ``height`` and ``slope_x`` (x, y).
    law : pressure law; density : of the water [kg/m3].
    hours, exceedance : as for `largest_entry_velocity`.

    Notes
    -----
    At an entry the velocity is Rayleigh distributed and the slope of the water
    against the deck is Gaussian about its regression on relative motion and
    velocity. The joint law is laid on 36 velocities by 21 angles over four deviations; the
    pressure with ``exceedance`` expected entries above it is read from the ordered
    sum, between two of its cells in the logarithm of the number. Costs
    some 20 ms for 400 points.
    """
    expected = statistics.slams_per_hour.values * hours
    threshold = statistics.attrs["threshold_velocity"]
    motion_std = np.maximum(moments.relative_motion_std.values, 1e-12)
    velocity_std = np.maximum(moments.relative_velocity_std.values, 1e-12)

    deepest = np.log(np.maximum(expected / exceedance, 1.0)) + 4.0
    edges = np.linspace(0.0, 1.0, _VELOCITY_STEPS + 1)[:, None, None] * np.sqrt(deepest)
    exceeded = np.exp(-(edges**2))
    share = exceeded[:-1] - exceeded[1:]
    middle = -np.log((exceeded[:-1] + exceeded[1:]) / 2)
    velocity = np.sqrt(threshold**2 + 2 * velocity_std**2 * middle)

    on_motion = moments.motion_slope_covariance.values / motion_std**2
    on_velocity = moments.velocity_slope_covariance.values / velocity_std**2
    left = (
        moments.relative_slope_std.values**2
        - moments.motion_slope_covariance.values**2 / motion_std**2
        - moments.velocity_slope_covariance.values**2 / velocity_std**2
    )
    nodes = np.linspace(-_ANGLE_REACH, _ANGLE_REACH, _ANGLE_STEPS)
    node_weights = np.exp(-(nodes**2) / 2)
    node_weights = node_weights / node_weights.sum()
    mean_slope = on_motion * deck.height.values + on_velocity * velocity
    slope = mean_slope + np.sqrt(np.maximum(left, 0.0)) * nodes[:, None, None, None]
    if statistics.attrs["velocity"] == "material":
        velocity = np.maximum(velocity - moments.attrs["speed"] * slope, 0.0)
    pressure = peak_pressure(law, velocity, np.arctan(slope - deck.slope_x.values), density)

    count = expected * share * node_weights[:, None, None, None]
    shape = (-1, *expected.shape)
    pressure, count = pressure.reshape(shape), np.broadcast_to(count, pressure.shape).reshape(shape)
    order = np.argsort(-pressure, axis=0)
    ranked = np.take_along_axis(pressure, order, axis=0)
    ranked_count = np.take_along_axis(count, order, axis=0)
    above = np.cumsum(ranked_count, axis=0) - ranked_count / 2
    second = np.maximum(np.argmax(above >= exceedance, axis=0), 1)[None]
    fewer, more = (np.take_along_axis(above, index, axis=0)[0] for index in (second - 1, second))
    higher, lower = (np.take_along_axis(ranked, index, axis=0)[0] for index in (second - 1, second))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        between = np.log(exceedance / fewer) / np.log(more / fewer)
    found = higher + np.clip(np.nan_to_num(between), 0.0, 1.0) * (lower - higher)
    found = np.where(expected > exceedance, found, 0.0)
    return xr.DataArray(
        found,
        coords={"x": moments.x, "y": moments.y},
        dims=("x", "y"),
        attrs=quantities.attributes("most_probable_peak_pressure"),
    )
