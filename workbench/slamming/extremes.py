"""Extremes: the largest entry velocity and peak pressure to expect in a number of hours.

.. [Ochi1964] M. K. Ochi, "Prediction of occurrence and severity of ship slamming
    at sea", 5th Symp. on Naval Hydrodynamics, Bergen, 1964, pp. 545-596.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.impact.pressure import PressureLaw
from workbench.slamming.joint_law import ranked_pressures


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
    Read from the ordered cells of `workbench.slamming.joint_law`. Costs some 20 ms for 400 points.
    """
    ranked = ranked_pressures(moments, statistics, deck, law, density, exceedance / hours)
    expected = statistics.slams_per_hour.values * hours
    found = np.where(expected > exceedance, ranked.pressure_exceeded(exceedance / hours), 0.0)
    return xr.DataArray(
        found,
        coords={"x": moments.x, "y": moments.y},
        dims=("x", "y"),
        attrs=quantities.attributes("most_probable_peak_pressure"),
    )
