"""Motion of the water relative to points of the wet deck.

Relative motion is the rise of the water towards the deck at a point moving with
the ship, ``r = zeta - (heave - x pitch + y roll)`` with lever arms from the ship's
origin; relative velocity is its time derivative there, ``-i omega_e r``. The
source of the direct method uses the material derivative instead
([Grande2002]_ 4.18): ship-surface velocity minus particle velocity, which adds
``U d/dx`` of both: `material_velocity`. What closes the gap, and what Chuang's
kinematics on the wave surface use, is the time derivative; a two-dimensional
theory of a strip of the deck needs the material one.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 4.2.
"""

import numpy as np
import xarray as xr
from scipy.interpolate import RegularGridInterpolator

from workbench import quantities
from workbench.motions import translation_matrix


def vertical_motion(motion_rao: np.ndarray, centre_of_gravity, x, y) -> np.ndarray:
    """Vertical motion at points (x, y) of the ship.

    Parameters
    ----------
    motion_rao : (..., 6) motions at the centre of gravity.
    centre_of_gravity : (3,) [m]; x, y : points, any common shape [m].

    Returns
    -------
    (..., *x.shape) [m per m]: heave - (x - x_G) pitch + (y - y_G) roll.
    """
    x, y = np.asarray(x, float), np.asarray(y, float)
    heave, roll, pitch = (
        motion_rao[..., mode].reshape(*motion_rao.shape[:-1], *[1] * x.ndim) for mode in (2, 3, 4)
    )
    return heave - (x - centre_of_gravity[0]) * pitch + (y - centre_of_gravity[1]) * roll


def incident_elevation(wavenumber, wave_direction, x, y) -> np.ndarray:
    """Incident wave at points (x, y) for a crest at the origin at t = 0, (*wavenumber.shape, *x.shape) [m/m]."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    k, beta = np.broadcast_arrays(wavenumber, wave_direction)
    k, beta = (part.reshape(*part.shape, *[1] * x.ndim) for part in (k, beta))
    return np.exp(1j * k * (x * np.cos(beta) + y * np.sin(beta)))


def scattered_elevation(
    wave_field: xr.Dataset, motion_rao_at_origin: np.ndarray, x: np.ndarray, y: np.ndarray
) -> np.ndarray:
    """Diffracted plus radiated elevation at deck points, (omega, wave_direction, *x.shape) [m/m].

    Parameters
    ----------
    wave_field : ``radiated_elevation`` (omega, radiating_dof, field_x, field_y) per
        unit motion about the origin, or (omega, wave_direction, radiating_dof, ...)
        where a ship at speed meets each heading at its own frequency, and
        ``diffracted_elevation`` (omega, wave_direction, field_x, field_y).
    motion_rao_at_origin : (omega, wave_direction, 6).
    x, y : points [m]. Outside the field grid (over a hull) the nearest point of the grid serves.
    """
    per_motion = wave_field.radiated_elevation
    dims = "fbjxy" if "wave_direction" in per_motion.dims else "fjxy"
    radiated = np.einsum(f"{dims},fbj->fbxy", per_motion.values, motion_rao_at_origin)
    total = radiated + wave_field.diffracted_elevation.values
    grid = (wave_field.field_x.values, wave_field.field_y.values)
    nearest = np.stack([np.clip(x, grid[0][0], grid[0][-1]), np.clip(y, grid[1][0], grid[1][-1])], axis=-1)
    values = np.moveaxis(total, (0, 1), (2, 3))
    found = RegularGridInterpolator(grid, values)(nearest)
    return np.moveaxis(found, (-2, -1), (0, 1))


def relative_motion(
    motion_set: xr.Dataset,
    deck: xr.Dataset,
    wave_field: xr.Dataset | None = None,
) -> xr.Dataset:
    """Relative motion, velocity and slope at every point of a deck, per wave amplitude.

    Parameters
    ----------
    motion_set : from `workbench.motions.motions`.
    deck : grid with coordinates x, y [m].
    wave_field : diffracted and radiated elevations; None takes the incident wave alone.

    Returns
    -------
    Dataset over (omega, wave_direction, x, y), complex: ``relative_motion`` [m/m],
    ``relative_velocity`` [m/s per m], ``relative_slope`` [1/m], the slope of the water
    along the ship against the moving deck's base plane.

    Notes
    -----
    Tends to 0 in long waves. The incident wave alone is fair for the fore deck and
    for slender hulls at speed; diffraction and radiation matter aft and at low speed.
    """
    x, y = np.meshgrid(deck.x.values, deck.y.values, indexing="ij")
    centre = np.asarray(motion_set.attrs["centre_of_gravity"])
    rao = motion_set.motion_rao.values
    k = motion_set.wavenumber.values[:, None]
    beta = motion_set.wave_direction.values[None, :]
    incident = incident_elevation(k, beta, x, y)
    vertical = vertical_motion(rao, centre, x, y)
    encounter = motion_set.encounter_frequency.values[..., None, None]
    along = (1j * k * np.cos(beta))[..., None, None] * incident
    scattered = np.zeros_like(incident)
    if wave_field is not None:
        scattered = scattered_elevation(wave_field, rao @ translation_matrix(-centre).T, x, y)
        if len(deck.x) > 1:
            along = along + np.gradient(scattered, deck.x.values, axis=2)
    rise = incident + scattered - vertical
    slope = along + rao[..., 4, None, None]
    rate = -1j * encounter * rise
    dims = ("omega", "wave_direction", "x", "y")
    return quantities.dataset(
        {
            "omega": motion_set.omega,
            "wave_direction": motion_set.wave_direction,
            "x": deck.x,
            "y": deck.y,
        },
        method=motion_set.attrs["method"],
        warnings=quantities.warnings_of(motion_set),
        attrs={
            "speed": motion_set.attrs["speed"],
            "density": motion_set.attrs["density"],
            "waves": "incident" if wave_field is None else "incident, diffracted and radiated",
        },
        relative_motion=(dims, rise),
        relative_velocity=(dims, rate),
        relative_slope=(dims, slope),
        encounter_frequency=(("omega", "wave_direction"), motion_set.encounter_frequency.values),
    )


def material_velocity(relative: xr.Dataset) -> xr.DataArray:
    """Relative velocity of hull surface and water particle per wave amplitude, r' - U dr/dx [m/s per m].

    Parameters
    ----------
    relative : from `relative_motion`.

    Notes
    -----
    [Grande2002]_ 4.18, whose x points aft; a bow-up pitch raises it.
    """
    found = relative.relative_velocity - relative.attrs["speed"] * relative.relative_slope
    return found.assign_attrs(quantities.attributes("relative_velocity"))
