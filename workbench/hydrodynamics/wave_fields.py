"""The Dataset of scattered waves between the hulls that every theory returns."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES


def elevation_set(
    omega: np.ndarray,
    wave_directions: np.ndarray,
    field_x: np.ndarray,
    field_y: np.ndarray,
    *,
    radiated: np.ndarray,
    diffracted: np.ndarray,
    speed: float,
    method: str,
) -> xr.Dataset:
    """Elevations of the water at points of a grid, as `relative_motion.scattered_elevation` takes them.

    Parameters
    ----------
    radiated : (omega, wave_direction, 6, field_x, field_y) per unit motion about the origin.
    diffracted : (omega, wave_direction, field_x, field_y) per wave amplitude, without the incident wave.
    """
    plane = ("field_x", "field_y")
    return quantities.dataset(
        {
            "omega": omega,
            "wave_direction": wave_directions,
            "radiating_dof": list(MODES),
            "field_x": field_x,
            "field_y": field_y,
        },
        method=method,
        attrs={"speed": float(speed)},
        radiated_elevation=(("omega", "wave_direction", "radiating_dof", *plane), radiated),
        diffracted_elevation=(("omega", "wave_direction", *plane), diffracted),
    )
