"""Displacement, velocity and relative motion of points of the ship from six recorded motions.

The direct method of [Grande2002]_ 4.2: nothing is linear but the waves, so that
recorded or non-linear motions serve as well. In this package's axes (x forward,
pitch bow down positive) the equations keep their form; only the term of the speed
in 4.18 changes its sign with the pitch.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, eqs 4.5-4.18.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_choice
from workbench.time_domain import elevation_amplitudes, records

FORMS = ("exact", "printed")
"""Forms of 4.9: the derivative of 4.5, or the sine of the angular rates as it is printed."""

_FEWEST_SAMPLES = 4


def rate_of(values, time_step: float) -> np.ndarray:
    """Rate of change by second-order differences, also at the ends (4.6-4.8), (time, ...)."""
    values = np.asarray(values, float)
    if len(values) < _FEWEST_SAMPLES:
        raise InputError(
            f"a record must have at least {_FEWEST_SAMPLES} samples to be differenced, got {len(values)}."
        )
    found = np.empty_like(values)
    found[1:-1] = (values[2:] - values[:-2]) / (2 * time_step)
    found[0] = (-3 * values[0] + 4 * values[1] - values[2]) / (2 * time_step)
    found[-1] = (values[-3] - 4 * values[-2] + 3 * values[-1]) / (2 * time_step)
    return found


def point_displacement(motion, lever_x, lever_y) -> np.ndarray:
    """Vertical displacement of points (4.5), (time, point) [m].

    Parameters
    ----------
    motion : (time, 6) at the centre of gravity; lever_x, lever_y : of the points from it (point) [m].

    Notes
    -----
    xi3 - X sin(xi5) + Y sin(xi4); the height of the point is left out, a second-order effect.
    """
    motion = np.asarray(motion, float)
    x, y = np.atleast_1d(lever_x), np.atleast_1d(lever_y)
    return motion[:, 2, None] - x * np.sin(motion[:, 4, None]) + y * np.sin(motion[:, 3, None])


def point_velocity(motion, time_step: float, lever_x, lever_y, form: str = "exact") -> np.ndarray:
    """Vertical velocity of points (4.9), (time, point) [m/s].

    Parameters
    ----------
    motion, lever_x, lever_y : as for `point_displacement`; time_step : [s].
    form : "exact", xi3' - X xi5' cos(xi5) + Y xi4' cos(xi4); or "printed", with sin(xi5')
        and sin(xi4') [sic], right for small angles and rates only.
    """
    checked_choice("form", form, FORMS)
    motion = np.asarray(motion, float)
    x, y = np.atleast_1d(lever_x), np.atleast_1d(lever_y)
    rate = rate_of(motion[:, 2:5], time_step)
    heave, roll, pitch = rate[:, 0, None], rate[:, 1, None], rate[:, 2, None]
    if form == "printed":
        return heave - x * np.sin(pitch) + y * np.sin(roll)
    return heave - x * pitch * np.cos(motion[:, 4, None]) + y * roll * np.cos(motion[:, 3, None])


def point_motion(
    history: xr.Dataset,
    components: xr.Dataset,
    points,
    centre_of_gravity,
    *,
    form: str = "exact",
    steady_elevation=0.0,
) -> xr.Dataset:
    """Displacement, velocity, clearance left and closing velocity at points over a record.

    Parameters
    ----------
    history : ``motion`` (time, dof) at the centre of gravity, evenly sampled, such as of
        `workbench.time_domain.time_histories`.
    components : wave components of the same sea, whose attribute ``speed`` is the ship's.
    points : (point, 3) x, y, z in the ship's axes [m]; z is the height above still water.
    centre_of_gravity : (3,) [m]; form : of 4.9.
    steady_elevation : of the water at the points by the ship's own waves, one or (point) [m].

    Returns
    -------
    Dataset over (time, vertex): ``point_displacement``, ``point_velocity``, ``elevation_at_point``,
    ``clearance_left`` Z_R = z + displacement - elevation (4.17) and
    ``closing_velocity`` = -dZ_R/dt in the material sense (4.18).

    Notes
    -----
    The water's velocity is that of its surface particles (4.15, 4.16 with the encounter
    frequency inside the cosine). 4.18 adds the vertical velocity of a pitched hull
    advancing at the speed: the result is the derivative that follows the water past the
    ship, not the rate of the gap; see `workbench.relative_motion.material_velocity`.
    """
    points = np.atleast_2d(np.asarray(points, float))
    if points.shape[1] != 3:
        raise InputError(f"points must have x, y and z, got {points.shape[1]} numbers a point.")
    motion, time = history.motion.values, history.time.values
    step = float(time[1] - time[0])
    if np.ptp(np.diff(time)) > 1e-6 * step:
        raise InputError("motions must be evenly sampled to be differenced; resample them.")
    x, y = points[:, 0], points[:, 1]
    lever_x, lever_y = x - centre_of_gravity[0], y - centre_of_gravity[1]
    frequency = components.component_frequency.values
    wave = elevation_amplitudes(components, x, y)
    elevation = records(wave, frequency, time).T
    particle = records(-1j * components.component_omega.values[:, None] * wave, frequency, time).T
    moved = point_displacement(motion, lever_x, lever_y)
    velocity = point_velocity(motion, step, lever_x, lever_y, form)
    left = points[:, 2] + moved - elevation - np.asarray(steady_elevation, float)
    advance = float(components.attrs["speed"]) * np.sin(motion[:, 4, None])
    dims = ("time", "vertex")
    return quantities.dataset(
        {"time": time, "vertex": np.arange(len(points))},
        method=f"direct, {form} form of the velocity",
        attrs={"speed": components.attrs["speed"], "time_step": step},
        point_displacement=(dims, moved),
        point_velocity=(dims, velocity),
        elevation_at_point=(dims, elevation),
        clearance_left=(dims, left),
        closing_velocity=(dims, -(velocity - particle + advance)),
    )


def water_entries(at_points: xr.Dataset, threshold: float = 0.0) -> xr.Dataset:
    """Slams: crossings of zero clearance from above with the gap closing (event).

    Parameters
    ----------
    at_points : from `point_motion`; threshold : least closing velocity that counts [m/s].

    Returns
    -------
    Dataset over event, in time order: ``event_time``, ``event_vertex`` (number of the point),
    ``entry_velocity``; instant and velocity interpolated by a line, as in [Grande2002]_ 4.2.
    """
    left, closing = at_points.clearance_left.values, at_points.closing_velocity.values
    before, point = np.nonzero((left[:-1] > 0) & (left[1:] <= 0))
    first, second = left[before, point], left[before + 1, point]
    share = first / (first - second)
    instant = at_points.time.values[before] + share * at_points.attrs["time_step"]
    velocity = (1 - share) * closing[before, point] + share * closing[before + 1, point]
    kept = np.flatnonzero(velocity > threshold)
    return quantities.dataset(
        {"event": np.arange(len(kept))},
        method="direct",
        attrs={"threshold_velocity": float(threshold)},
        event_time=("event", instant[kept]),
        event_vertex=("event", point[kept]),
        entry_velocity=("event", velocity[kept]),
    )
