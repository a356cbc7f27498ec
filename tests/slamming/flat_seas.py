"""A sea of a flat band of frequencies, in which every moment is closed form, and records of it."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import GRAVITY

BAND = (0.4, 0.8)


def flat_band(closing_speed=0.0, n=401, slope=0.0):
    """Unit relative motion in a flat spectrum of unit variance, on a deck of two points."""
    omega = np.linspace(*BAND, n)
    met = omega + omega**2 * closing_speed / GRAVITY
    dims = ("omega", "wave_direction", "x", "y")
    rise = np.ones((n, 1, 2, 1), complex) * np.array([1.0, 0.5])[None, None, :, None]
    relative = quantities.dataset(
        {"omega": omega, "wave_direction": [np.pi], "x": [0.0, 1.0], "y": [0.0]},
        attrs={"density": 1025.0, "speed": 3.0},
        relative_motion=(dims, rise),
        relative_velocity=(dims, -1j * met[:, None, None, None] * rise),
        relative_slope=(dims, slope * 1j * rise),
        encounter_frequency=(("omega", "wave_direction"), met[:, None]),
    )
    energy = xr.DataArray(
        np.full((n, 1), 1 / np.ptp(BAND)), coords={"omega": omega, "wave_direction": [np.pi]}
    )
    return relative, energy


def deck(height):
    dims = ("x", "y")
    return quantities.dataset(
        {"x": [0.0, 1.0], "y": [0.0]},
        height=(dims, np.full((2, 1), height)),
        slope_x=(dims, np.zeros((2, 1))),
    )


def random_sea(closing_speed, seed, components=300, slope=0.0):
    rng = np.random.default_rng(seed)
    width = np.ptp(BAND) / components
    omega = BAND[0] + width * (np.arange(components) + rng.uniform(size=components))
    met = omega + omega**2 * closing_speed / GRAVITY
    amplitude = np.sqrt(2 / components) * np.exp(1j * rng.uniform(0, 2 * np.pi, components))
    rise = amplitude[:, None, None] * np.array([1.0, 0.5])[None, :, None]
    return rise, slope * 1j * rise, met
