"""Responses made dimensionless, as towing tanks publish them, and their sums over a sea.

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, eqs 6.1, 7.1, 7.3 and 9.1.2.

The source calls the *square* of a transfer function the response amplitude operator.
"""

import numpy as np

from workbench.conventions import GRAVITY
from workbench.errors import InputError, checked_choice, checked_number

KINDS = ("heave", "pitch", "acceleration")


def _factor(kind: str, omega, encounter_omega) -> np.ndarray:
    """Response over wave amplitude for a transfer function of 1."""
    checked_choice("kind of transfer function", kind, KINDS)
    omega, encounter = np.broadcast_arrays(np.asarray(omega, float), np.asarray(encounter_omega, float))
    return {"heave": np.ones(omega.shape), "pitch": omega**2 / GRAVITY, "acceleration": encounter**2}[kind]


def transfer_function(kind: str, response, wave, omega, encounter_omega) -> np.ndarray:
    """Transfer function, 7.1 [-].

    Parameters
    ----------
    kind : "heave" xi3/zeta; "pitch" xi5 g/(zeta omega^2), pitch over wave slope;
        "acceleration" a/(zeta omega_e^2).
    response, wave : amplitudes of both, or RMS values of both [m, rad or m/s2; m].
    omega, encounter_omega : wave and encounter frequency [rad/s].

    Notes
    -----
    At the centre of gravity the transfer functions of acceleration and heave are the same.
    """
    wave = np.asarray(wave, float)
    if np.any(wave <= 0):
        raise InputError(f"wave amplitude must be > 0 m, got {wave.min():g} m.")
    return np.asarray(response) / wave / _factor(kind, omega, encounter_omega)


def response_of(kind: str, function, omega, encounter_omega) -> np.ndarray:
    """Response per wave amplitude from a transfer function; undoes `transfer_function`."""
    return np.asarray(function) * _factor(kind, omega, encounter_omega)


def acceleration_at(heave, pitch, encounter_omega, lever) -> np.ndarray:
    """Amplitude of vertical acceleration from complex heave and pitch [m/s2 per m].

    Parameters
    ----------
    heave, pitch : complex, at the centre of gravity, pitch bow down positive [m/m, rad/m].
    lever : of the point forward of the centre of gravity [m].

    Notes
    -----
    omega_e^2 |xi3 - x xi5|; with pitch bow up positive the sign turns ([Couser1996]_ 7.3).
    """
    return np.asarray(encounter_omega, float) ** 2 * np.abs(np.asarray(heave) - lever * np.asarray(pitch))


def added_resistance_coefficient(
    resistance_in_waves,
    calm_resistance,
    wave,
    density: float,
    beam: float,
    length: float,
    wave_is: str = "amplitude",
) -> np.ndarray:
    """Added-resistance coefficient, R_AW/(rho g zeta^2 B^2/L) [-] (7.3).

    Parameters
    ----------
    resistance_in_waves, calm_resistance : [N].
    wave : amplitude, or RMS elevation (zeta^2 = 2 RMS^2) [m]; wave_is : "amplitude" or "rms".
    density : [kg/m3]; beam, length : of one demihull, for one hull and for two [m].
    """
    checked_choice("wave_is", wave_is, ("amplitude", "rms"))
    square = np.asarray(wave, float) ** 2 * (2.0 if wave_is == "rms" else 1.0)
    unit = density * GRAVITY * checked_number("beam", beam, "m", above=0) ** 2
    added = np.asarray(resistance_in_waves, float) - np.asarray(calm_resistance, float)
    return added / (unit * square / checked_number("length", length, "m", above=0))


def response_variance(kind: str, function, omega, encounter_omega, encounter_spectrum) -> float:
    """Variance m0 of a response in a sea, over encounter frequency (9.1.2, 6.1).

    Parameters
    ----------
    kind : of transfer function; function : its magnitude on ``encounter_omega``.
    omega, encounter_omega : of the same waves [rad/s], increasing.
    encounter_spectrum : over encounter frequency [m2 s/rad].
    """
    square = np.abs(response_of(kind, function, omega, encounter_omega)) ** 2
    return float(np.trapezoid(square * encounter_spectrum, encounter_omega))


def scaled_frequency(encounter_omega, from_length: float, to_length: float) -> np.ndarray:
    """Encounter frequency of a ship of another length, at equal omega_e sqrt(L/g) [rad/s]."""
    ratio = checked_number("from_length", from_length, "m", above=0) / checked_number(
        "to_length", to_length, "m", above=0
    )
    return np.asarray(encounter_omega, float) * np.sqrt(ratio)


def sea_response(variance: float) -> dict[str, float]:
    """Figures of a response from its variance: RMS, significant amplitude 2 sqrt(m0), significant height 4 sqrt(m0).

    The source prints RMS and significant amplitudes as equivalent; they are not.
    """
    deviation = float(np.sqrt(checked_number("variance", variance, at_least=0)))
    return {"rms": deviation, "significant_amplitude": 2 * deviation, "significant_height": 4 * deviation}
