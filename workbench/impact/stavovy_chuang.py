"""Chuang's pressure on a hull surface with deadrise and buttock, by its angle with the wave surface.

The paper could not be consulted: the definition of the normal velocity is recalled
(the coefficients of k are Chuang's, which are verified), and every result says so.

.. [Stavovy1976] A. B. Stavovy and S.-L. Chuang, "Analytical determination of slamming pressures
    for high-speed vehicles in waves", J. Ship Research 20, 1976.
.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError
from workbench.impact import chuang

STEEPEST = 0.17
"""Least cosine of the angle between the surface and the level [-]."""

STANDING = (
    "The normal velocity on a surface with deadrise follows Stavovy and Chuang 1976 as recalled, not as read; it is "
    "checked against Chuang's flat bottom only."
)


def surface_normal(deadrise=0.0, buttock=0.0, pitch=0.0, roll=0.0) -> np.ndarray:
    """Unit normal of a hull surface, upward into the hull (..., 3) in x forward, y to port, z up.

    Parameters
    ----------
    deadrise : transverse slope, rising to port positive; buttock : longitudinal slope, rising
        towards the bow positive; pitch : bow up positive; roll : port side up positive [rad].
    """
    deadrise, buttock, pitch, roll = np.broadcast_arrays(
        *(np.asarray(angle, float) for angle in (deadrise, buttock, pitch, roll))
    )
    x, y, z = -np.tan(buttock), -np.tan(deadrise), np.ones(deadrise.shape)
    y, z = y * np.cos(roll) - z * np.sin(roll), y * np.sin(roll) + z * np.cos(roll)
    x, z = x * np.cos(pitch) - z * np.sin(pitch), x * np.sin(pitch) + z * np.cos(pitch)
    normal = np.stack([x, y, z], axis=-1)
    return normal / np.linalg.norm(normal, axis=-1, keepdims=True)


def surface_impact(
    vertical_velocity,
    density,
    *,
    deadrise=0.0,
    buttock=0.0,
    pitch=0.0,
    roll=0.0,
    wave_slope=0.0,
    pitch_velocity=0.0,
    small_angle_law: str = "program",
) -> xr.Dataset:
    """Peak pressure on a surface that is inclined to the wave in any direction ([Stavovy1976]_, recalled).

    Parameters
    ----------
    vertical_velocity : of the hull less that of the wave surface, downward positive [m/s].
    density : [kg/m3].
    deadrise, buttock, pitch, roll : of the surface, see `surface_normal` [rad].
    wave_slope : rising towards the bow positive [rad].
    pitch_velocity : of the impact point, normal to the surface as in [Chuang1975]_ [m/s].

    Returns
    -------
    Dataset over point (or without dimension): ``normal_velocity`` and ``tangential_velocity``
    against the wave surface, ``impact_angle`` between the two surfaces, ``pressure_constant``,
    ``impact_pressure``, ``planing_pressure``, ``peak_pressure``.

    Notes
    -----
    The relative velocity normal to the hull is resolved normal to and along the wave
    surface in the plane of the two normals, then referred to the vertical by the square
    of the hull normal's z, as Chuang refers his by 1/cos(pitch)**2. Without deadrise and
    roll this is his Method I exactly; with roll his root of squares to second order.
    """
    hull = surface_normal(deadrise, buttock, pitch, roll)
    if np.any(hull[..., 2] < STEEPEST):
        raise InputError(
            f"surface must face downward, within {np.degrees(np.arccos(STEEPEST)):.0f} degrees of level, to slam; "
            f"got {np.degrees(np.arccos(hull[..., 2].min())):.0f} degrees."
        )
    slope = np.asarray(wave_slope, float)
    cosine = np.clip(hull[..., 2] * np.cos(slope) - hull[..., 0] * np.sin(slope), -1.0, 1.0)
    angle = np.arccos(cosine)
    velocity = vertical_velocity * hull[..., 2] + pitch_velocity
    found = chuang.predicted(
        velocity * cosine / hull[..., 2] ** 2, velocity * np.sin(angle), angle, density, small_angle_law
    )
    parts = np.broadcast_arrays(*found)
    dims = ("point",)[: parts[0].ndim]
    named = dict(zip(PREDICTED, ((dims, part) for part in parts), strict=True))
    return quantities.dataset(
        {"point": np.arange(parts[0].size)} if dims else {},
        method="Stavovy and Chuang, recalled",
        warnings=[STANDING],
        **named,
    )


PREDICTED = (
    "normal_velocity",
    "tangential_velocity",
    "impact_angle",
    "pressure_constant",
    "impact_pressure",
    "planing_pressure",
    "peak_pressure",
)
"""Names, in results, of the parts of `chuang.Prediction`."""
