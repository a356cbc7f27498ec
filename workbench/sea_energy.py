"""The energy of a sea over the computed waves: frequencies and directions."""

import numpy as np
import xarray as xr

from workbench.errors import InputError
from workbench.seas import Condition, spreading_weights, wave_spectrum


def directions_for(condition: Condition) -> np.ndarray:
    """Directions that a condition needs: its own, or in short-crested seas 13 over +-90 degrees about it [rad]."""
    if condition.sea_state.spreading_exponent is None:
        return np.array([condition.wave_direction])
    around = condition.wave_direction + np.radians(np.arange(-90, 91, 15))
    return np.unique(np.round(np.mod(around, 2 * np.pi), 12))


def wave_energy(condition: Condition, omega: xr.DataArray, wave_directions: xr.DataArray) -> xr.DataArray:
    """Spectrum times the share of each direction (omega, wave_direction) [m2 s/rad].

    Raises
    ------
    InputError if the condition's direction is not among (within half a degree of) the computed ones.
    """
    directions = wave_directions.values
    away = np.abs(np.angle(np.exp(1j * (directions - condition.wave_direction))))
    if away.min() > np.radians(0.5):
        known = ", ".join(f"{np.degrees(direction):.0f}" for direction in directions)
        raise InputError(
            f"wave direction must be one of the computed ones ({known} degrees), got "
            f"{np.degrees(condition.wave_direction):.1f} degrees; compute that heading first."
        )
    shares = spreading_weights(directions, condition.wave_direction, condition.sea_state.spreading_exponent)
    spectrum = wave_spectrum(condition.sea_state, omega.values)
    return xr.DataArray(
        spectrum[:, None] * shares, coords={"omega": omega, "wave_direction": wave_directions}
    )


def band_notes(energy: xr.DataArray, condition: Condition) -> tuple[str, ...]:
    """Say so where the computed frequencies miss much of the sea."""
    omega = energy.omega.values
    covered = np.trapezoid(energy.sum("wave_direction").values, omega)
    share = covered / (condition.sea_state.significant_wave_height**2 / 16)
    if share > 0.95:
        return ()
    return (
        f"The computed waves of omega {omega[0]:.2f} to {omega[-1]:.2f} rad/s hold {100 * share:.0f} % of the energy "
        "of this sea: the rest is too long or too short for this ship and is left out.",
    )
