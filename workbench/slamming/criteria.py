"""The designer's inverse questions: how high the deck must be, answered from the closed form."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.slamming.statistics import HOUR

CRITERION_SLAMS_PER_HOUR = 20.0
"""Slams per hour of the naval criterion commonly applied (STANAG 4154) [1/h]."""


def required_height(moments: xr.Dataset, slams_per_hour: float, threshold: float = 0.0) -> xr.DataArray:
    """Height above still water at which each point slams as often as the criterion allows (x, y) [m].

    Parameters
    ----------
    moments : from `workbench.slamming.statistics.response_moments`.
    slams_per_hour : the criterion, > 0 [1/h]; threshold : least entry velocity that counts [m/s].

    Notes
    -----
    Solves nu_0 exp(-d**2/(2 m0) - v**2/(2 m2)) = N for d; 0 where even a deck at
    the still waterline would meet the criterion.
    """
    velocity_std = np.maximum(moments.relative_velocity_std, 1e-12)
    most = HOUR * moments.upcrossing_rate * np.exp(-(threshold**2) / (2 * velocity_std**2))
    with np.errstate(divide="ignore"):
        exponent = np.log(np.maximum(most, 1e-300) / slams_per_hour)
    height = moments.relative_motion_std * np.sqrt(2 * np.maximum(exponent, 0.0))
    return height.assign_attrs(quantities.attributes("required_height")).rename("required_height")


def least_clearance(
    moments: xr.Dataset,
    height: xr.DataArray,
    clearance: float,
    slams_per_hour: float,
    threshold: float = 0.0,
) -> float:
    """Least clearance of a deck, raised as a whole, that meets a criterion at its worst point [m].

    Parameters
    ----------
    moments, slams_per_hour, threshold : as for `required_height`.
    height : of the deck at its present ``clearance`` (x, y) [m].
    """
    missing = required_height(moments, slams_per_hour, threshold) - height
    return max(float(clearance + missing.max()), 0.0)


def clearance_curve(
    moments: xr.Dataset,
    height: xr.DataArray,
    clearance: float,
    clearances: np.ndarray,
    threshold: float = 0.0,
) -> xr.Dataset:
    """Slams per hour at the worst point of the deck against its clearance.

    Parameters
    ----------
    moments, height, clearance, threshold : as for `least_clearance`.
    clearances : clearances asked for [m].
    """
    raised = np.maximum(height.values + (np.asarray(clearances, float)[:, None, None] - clearance), 0.0)
    motion_std = np.maximum(moments.relative_motion_std.values, 1e-12)
    velocity_std = np.maximum(moments.relative_velocity_std.values, 1e-12)
    rate = moments.upcrossing_rate.values * np.exp(
        -(raised**2) / (2 * motion_std**2) - threshold**2 / (2 * velocity_std**2)
    )
    return quantities.dataset(
        {"clearance": np.asarray(clearances, float)},
        method=moments.attrs["method"],
        slams_per_hour=("clearance", HOUR * rate.max(axis=(1, 2))),
    )
