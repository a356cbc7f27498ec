"""When a cross structure slams: phases of bow, heave and pitch against the wave, and synchronism.

The rules are the source's words on its model tests; the figures that make them
checks (how near to a maximum, how near to a natural period) are ours.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, pp. 34-36.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench.design import MassProperties
from workbench.errors import InputError, checked_number
from workbench.impact.regular_motion import RegularMotion
from workbench.motions import mass_matrix, translation_matrix

NEAR_MAXIMUM = float(np.cos(np.radians(30.0)))
"""Share of its amplitude from which a motion counts as near its maximum: within 30 degrees of phase [-]."""

SYNCHRONISM_BAND = 0.15
"""Departure of the period of encounter from a natural period, within which they are synchronous [-]."""


@dataclass(frozen=True, kw_only=True)
class SlamTiming:
    """Outcome of the checks at one point of the deck in one regular head wave.

    Parameters
    ----------
    relative_motion_amplitude : of the water against the point [m].
    slams : whether it exceeds the clearance.
    bow_phase : lead of the point's upward motion over the wave there, in (-pi, pi] [rad].
    is_out_of_phase : more than 90 degrees, where slams come even from waves lower than the clearance.
    bow_down_share : bow-down pitch at impact over its amplitude [-]; NaN without a slam.
    heave_velocity_share : downward heave velocity at impact over its amplitude [-].
    is_typical : bow down and heave velocity both near their maxima, as in model and ship.
    synchronous : names of the modes whose natural period the wave meets.
    notes : the findings as sentences.
    """

    relative_motion_amplitude: float
    slams: bool
    bow_phase: float
    is_out_of_phase: bool
    bow_down_share: float
    heave_velocity_share: float
    is_typical: bool
    synchronous: tuple[str, ...]
    notes: tuple[str, ...]


def slam_timing(
    motion: RegularMotion, lever: float, clearance: float, natural_periods: dict[str, float] | None = None
) -> SlamTiming:
    """Check a point of the deck by the rules of [Chuang1975]_.

    Parameters
    ----------
    motion : in a regular head wave.
    lever : of the point forward of the centre of gravity; clearance : in still water [m].
    natural_periods : by mode, such as {"heave": 6.0, "pitch": 5.5} [s]; see `natural_periods`.
    """
    checked_number("lever", lever, "m")
    amplitude = float(np.abs(motion.relative_motion(lever)))
    wave = np.exp(1j * motion.wave.wavenumber * lever)
    phase = float(np.angle(motion.point_motion(lever) / wave))
    instant = float(motion.impact_instant(lever, clearance))
    slams = bool(np.isfinite(instant))
    state = motion.at(instant, lever)
    omega = motion.wave.encounter_frequency
    down = _share(-state.pitch, motion.pitch_amplitude)
    heave = _share(state.heave_velocity, omega * motion.heave_amplitude)
    out = bool(abs(phase) > np.pi / 2)
    typical = bool(min(down, heave) >= NEAR_MAXIMUM) if slams else False
    met = synchronous(2 * np.pi / omega, natural_periods or {})
    return SlamTiming(
        relative_motion_amplitude=amplitude,
        slams=slams,
        bow_phase=phase,
        is_out_of_phase=out,
        bow_down_share=down,
        heave_velocity_share=heave,
        is_typical=typical,
        synchronous=met,
        notes=_sentences(motion, amplitude, clearance, slams, out, typical, met),
    )


def synchronous(period: float, natural_periods: dict[str, float]) -> tuple[str, ...]:
    """Modes whose natural period [s] is within `SYNCHRONISM_BAND` of the period of encounter [s]."""
    for mode, natural in natural_periods.items():
        checked_number(f"natural period of {mode}", natural, "s", above=0)
    return tuple(
        mode for mode, natural in natural_periods.items() if abs(period / natural - 1) <= SYNCHRONISM_BAND
    )


def natural_periods(
    hydrodynamics: xr.Dataset, masses: MassProperties, hydrostatic_stiffness: xr.DataArray
) -> dict[str, float]:
    """Natural periods of heave and pitch, uncoupled, about the centre of gravity [s].

    Parameters
    ----------
    hydrodynamics : added mass (omega, wave_direction) about the origin, with its encounter frequencies.
    masses, hydrostatic_stiffness : as for `workbench.motions.motions`.

    Notes
    -----
    Where omega_e^2 (M + A(omega_e)) meets C, by a line between the frequencies in head
    seas (or the nearest direction); a mode that is not met there is left out.
    """
    away = np.abs((hydrodynamics.wave_direction.values) % (2 * np.pi) - np.pi)
    head = int(np.argmin(away))
    from_centre = np.linalg.inv(translation_matrix(masses.centre_of_gravity))
    added = hydrodynamics.added_mass.values[:, head]
    encounter = np.abs(hydrodynamics.encounter_frequency.values[:, head])
    order = np.argsort(encounter)
    found = {}
    for mode, index in (("heave", 2), ("pitch", 4)):
        arm = from_centre[:, index]
        inertia = arm @ (mass_matrix(masses) + added) @ arm
        stiffness = arm @ np.asarray(hydrostatic_stiffness) @ arm
        left = (encounter**2 * inertia - stiffness)[order]
        rising = np.flatnonzero((left[:-1] < 0) & (left[1:] >= 0))
        if len(rising):
            first, omega = rising[0], encounter[order]
            share = left[first] / (left[first] - left[first + 1])
            found[mode] = float(2 * np.pi / (omega[first] + share * (omega[first + 1] - omega[first])))
    if not found:
        raise InputError(
            "frequencies must reach the natural frequency of heave or pitch; compute more of them."
        )
    return found


def _share(value, amplitude: float) -> float:
    return float(value) / amplitude if amplitude > 0 else 0.0


def _sentences(motion, amplitude, clearance, slams, out, typical, met) -> tuple[str, ...]:
    against = "exceeds" if slams else "stays below"
    notes = [f"Relative motion of {amplitude:.3g} m {against} the clearance of {clearance:.3g} m."]
    if out:
        higher = "above" if motion.wave.amplitude > clearance else "below"
        notes.append(
            "The point moves more than 90 degrees out of phase with the wave, which makes slams frequent; the wave's "
            f"amplitude of {motion.wave.amplitude:.3g} m is {higher} the clearance."
        )
    if slams:
        notes.append(
            "At impact the bow is near fully down and heave velocity near its largest, the usual slam."
            if typical
            else "At impact bow-down pitch and heave velocity are not both near their largest: not the usual slam."
        )
    if met:
        notes.append(
            f"The wave meets the natural period of {' and '.join(met)}: motions and pressures are highest."
        )
    return tuple(notes)
