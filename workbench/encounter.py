"""Encounter of waves and ship: the way back from encounter to wave frequency, and spectra over either.

In deep water ``omega_e = omega - omega^2 c`` with ``c = U cos(beta)/g``. In head and
beam seas (c <= 0) one wave frequency belongs to each encounter frequency. In
following and quartering seas three do, as long as the encounter frequency is
below ``1/(4 c)``, and one beyond it:

0 the long waves that overtake the ship, omega < 1/(2 c);
1 shorter waves that still overtake it, 1/(2 c) < omega < 1/c;
2 the waves that the ship overtakes, omega > 1/c, met with a negative omega_e.

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, 7.3 and 9.1.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 3.2 and 3.4.
"""

import numpy as np

from workbench.conventions import GRAVITY, encounter_frequency
from workbench.errors import InputError, checked_choice, checked_number

BRANCHES = 3
OVERLAPS = ("refuse", "sum")
_NO_SPEED = 1e-12


def _drift(speed: float, wave_direction: float) -> float:
    """U cos(beta)/g [s]; 0 where it is lost in rounding (beam seas)."""
    checked_number("speed", speed, "m/s", at_least=0, at_most=100)
    checked_number("wave_direction", wave_direction, "rad", at_least=-2 * np.pi, at_most=2 * np.pi)
    drift = speed * np.cos(wave_direction) / GRAVITY
    return 0.0 if abs(drift) < _NO_SPEED else float(drift)


def highest_overtaking(speed: float, wave_direction: float) -> float:
    """Highest encounter frequency with which waves can overtake the ship, g/(4 U cos(beta)) [rad/s].

    Infinite in head and beam seas and at rest. The Jacobian of the encounter is zero there.
    """
    drift = _drift(speed, wave_direction)
    return 1 / (4 * drift) if drift > 0 else np.inf


def wave_frequencies(encounter_omega, speed: float, wave_direction: float) -> np.ndarray:
    """All wave frequencies met with an encounter frequency, (3, *encounter_omega.shape) [rad/s].

    Parameters
    ----------
    encounter_omega : magnitude of the encounter frequency [rad/s], >= 0, scalar or array.
    speed : [m/s]; wave_direction : [rad], pi is head seas.

    Returns
    -------
    The branches of the module's head, NaN where there is no such wave. In head and
    beam seas all is in branch 0.
    """
    magnitude = np.asarray(encounter_omega, float)
    if np.any(magnitude < 0) or not np.all(np.isfinite(magnitude)):
        raise InputError("encounter_omega must be finite and >= 0 rad/s; give its magnitude.")
    drift = _drift(speed, wave_direction)
    found = np.full((BRANCHES, *magnitude.shape), np.nan)
    if drift <= 0:
        found[0] = 2 * magnitude / (1 + np.sqrt(1 - 4 * drift * magnitude))
        return found
    inside = 1 - 4 * drift * magnitude
    root = np.sqrt(np.where(inside >= 0, inside, np.nan))
    found[0] = 2 * magnitude / (1 + root)
    found[1] = (1 + root) / (2 * drift)
    found[2] = (1 + np.sqrt(1 + 4 * drift * magnitude)) / (2 * drift)
    return found


def wave_frequency(encounter_omega, speed: float, wave_direction: float) -> np.ndarray:
    """The wave frequency met with an encounter frequency, the longest wave if there are three [rad/s].

    NaN where no wave overtakes the ship so often. Head seas:
    (sqrt(1 + 4 U omega_e/g) - 1) g/(2 U) ([Couser1996]_ 7.2 solved for omega).
    """
    return wave_frequencies(encounter_omega, speed, wave_direction)[0]


def wavelength_ratio(encounter_omega, froude: float, length: float, wave_direction: float = np.pi):
    """Wavelength over ship length for an encounter frequency, deep water [-] ([Couser1996]_ tables 7.2, 7.3).

    Parameters
    ----------
    encounter_omega : [rad/s]; froude : Froude number on ``length`` [m].
    """
    checked_number("length", length, "m", above=0)
    speed = checked_number("froude", froude, at_least=0, at_most=5) * np.sqrt(GRAVITY * length)
    omega = wave_frequency(encounter_omega, speed, wave_direction)
    return 2 * np.pi * GRAVITY / omega**2 / length


def encounter_jacobian(omega, speed: float, wave_direction: float) -> np.ndarray:
    """Derivative of the encounter frequency, d omega_e/d omega = 1 - 2 omega U cos(beta)/g [-]."""
    return 1 - 2 * np.asarray(omega, float) * _drift(speed, wave_direction)


def to_encounter(omega, spectrum, speed: float, wave_direction: float) -> tuple[np.ndarray, np.ndarray]:
    """Spectrum over encounter frequency, point by point: S(omega)/|d omega_e/d omega|.

    Parameters
    ----------
    omega : wave frequencies [rad/s], increasing; spectrum : ordinates there [m2 s/rad].
    speed, wave_direction : of the encounter.

    Returns
    -------
    Encounter frequencies [rad/s] and ordinates [m2 s/rad].

    Notes
    -----
    Only where the encounter is single-valued: the table must end below
    omega = g/(2 U cos(beta)) in following seas; `encounter_bins` goes beyond.
    """
    omega, spectrum = _checked_table(omega, spectrum)
    slope = encounter_jacobian(omega, speed, wave_direction)
    if np.any(slope <= 0):
        limit = 2 * highest_overtaking(speed, wave_direction)
        raise InputError(
            f"omega must be < {limit:.4g} rad/s at this speed and direction, got {omega[-1]:.4g} rad/s: beyond it "
            "several waves are met with one encounter frequency; cut the table there, or sum the branches in bins."
        )
    return encounter_frequency(omega, speed, wave_direction), spectrum / slope


def to_wave(encounter_omega, spectrum, speed: float, wave_direction: float) -> tuple[np.ndarray, np.ndarray]:
    """Spectrum over wave frequency from one over encounter frequency, point by point; undoes `to_encounter`.

    Parameters
    ----------
    encounter_omega : [rad/s], increasing; spectrum : ordinates there.

    Notes
    -----
    In following seas all energy is taken to be of the long waves (branch 0); a record
    alone cannot tell the branches apart.
    """
    magnitude, spectrum = _checked_table(encounter_omega, spectrum)
    most = highest_overtaking(speed, wave_direction)
    if magnitude[-1] >= most:
        raise InputError(
            f"encounter_omega must be < {most:.4g} rad/s at this speed and direction, got {magnitude[-1]:.4g} "
            "rad/s: no wave overtakes the ship so often; cut the spectrum there."
        )
    omega = wave_frequency(magnitude, speed, wave_direction)
    return omega, spectrum * encounter_jacobian(omega, speed, wave_direction)


def encounter_bins(
    omega, spectrum, edges, speed: float, wave_direction: float, overlap: str = "refuse"
) -> np.ndarray:
    """Spectrum over the magnitude of the encounter frequency, averaged over bins (len(edges) - 1).

    Parameters
    ----------
    omega, spectrum : table over wave frequency, taken linear between its points and 0 beyond.
    edges : of the bins [rad/s], increasing, >= 0.
    speed, wave_direction : of the encounter.
    overlap : "refuse" objects where several waves with energy share an encounter
        frequency, "sum" adds their energies, as a record does.

    Notes
    -----
    The energy of a bin is the difference of the running integral of the table at the
    wave frequencies of its edges, so that energy is kept exactly and the singular
    ordinate at g/(4 U cos(beta)) does no harm.
    """
    omega, spectrum = _checked_table(omega, spectrum)
    edges = np.asarray(edges, float)
    if edges.ndim != 1 or len(edges) < 2 or np.any(np.diff(edges) <= 0) or edges[0] < 0:
        raise InputError("edges must be two or more increasing encounter frequencies >= 0 rad/s.")
    checked_choice("overlap", overlap, OVERLAPS)
    most = highest_overtaking(speed, wave_direction)
    if overlap == "refuse" and np.isfinite(most):
        left = _running_energy(omega, spectrum, np.array([2 * most, np.inf]))
        if left[1] - left[0] > 1e-3 * max(left[1], 1e-300):
            raise InputError(
                f"{100 * (1 - left[0] / left[1]):.0f} % of the energy is above {2 * most:.4g} rad/s, where several "
                "waves are met with one encounter frequency; ask for the sum of the branches."
            )
    waves = wave_frequencies(np.minimum(edges, 1e9), speed, wave_direction)
    if np.isfinite(most):
        beyond = edges > most
        waves[:2, beyond] = 2 * most
    energy = np.zeros(len(edges) - 1)
    for branch in waves:
        if not np.any(np.isnan(branch)):
            energy += np.abs(np.diff(_running_energy(omega, spectrum, branch)))
    return energy / np.diff(edges)


def blended_response(first, second, encounter_omega, lower: float, upper: float) -> np.ndarray:
    """Response of one heading at low, of another at high encounter frequencies, linear between.

    Parameters
    ----------
    first, second : responses per wave amplitude on ``encounter_omega``, of the heading
        of the long waves and of that of the short ones.
    encounter_omega : [rad/s]; lower, upper : where the change begins and ends [rad/s].

    Notes
    -----
    [Grande2002]_ 3.4 takes head seas below 1.2 rad/s and 50 degrees off the bow above
    2.5 rad/s; the weights between are not stated there, linear ones are ours.
    """
    checked_number("lower", lower, "rad/s", at_least=0)
    checked_number("upper", upper, "rad/s", above=lower)
    share = np.clip((np.asarray(encounter_omega, float) - lower) / (upper - lower), 0.0, 1.0)
    return (1 - share) * np.asarray(first) + share * np.asarray(second)


def _checked_table(omega, spectrum) -> tuple[np.ndarray, np.ndarray]:
    """Return frequencies and ordinates as arrays, or refuse them."""
    omega, spectrum = np.asarray(omega, float), np.asarray(spectrum, float)
    if omega.ndim != 1 or omega.shape != spectrum.shape or len(omega) < 2:
        raise InputError("a spectrum must be two or more frequencies with one ordinate each.")
    if np.any(np.diff(omega) <= 0) or omega[0] < 0 or not np.all(np.isfinite(omega + spectrum)):
        raise InputError("a spectrum must have finite ordinates at increasing frequencies >= 0 rad/s.")
    if np.any(spectrum < 0):
        raise InputError(f"ordinates of a spectrum must be >= 0, got {spectrum.min():g}.")
    return omega, spectrum


def _running_energy(omega: np.ndarray, spectrum: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Integral of a piecewise linear spectrum from its start to the wanted frequencies."""
    step = np.diff(omega)
    total = np.concatenate([[0.0], np.cumsum(step * (spectrum[1:] + spectrum[:-1]) / 2)])
    inside = np.clip(wanted, omega[0], omega[-1])
    index = np.clip(np.searchsorted(omega, inside, side="right") - 1, 0, len(step) - 1)
    along = inside - omega[index]
    slope = (spectrum[index + 1] - spectrum[index]) / step[index]
    return total[index] + along * (spectrum[index] + along * slope / 2)
