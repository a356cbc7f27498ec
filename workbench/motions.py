"""Rigid-body motions in regular waves: the equation of motion, and motions at any point.

With exp(-i omega_e t), about the ship's origin::

    [-omega_e^2 (M + A) - i omega_e (B + B_viscous) + C] xi = F

Forces that are not of the hull in potential flow (`workbench.damping`) are added
to A, B, C and F; drag across the hulls is linearised by iteration.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from workbench import quantities
from workbench.conventions import MODES, wavenumber
from workbench.damping.cross_flow import CrossFlow
from workbench.design import MassProperties
from workbench.errors import checked_number
from workbench.motion_solution import energy_notes, free_modes, solution, solution_with_drag, total


def translation_matrix(point) -> np.ndarray:
    """Motions at a point from motions at the origin, (6, 6): u + theta x r."""
    x, y, z = point
    matrix = np.eye(6)
    matrix[0, 4], matrix[0, 5] = z, -y
    matrix[1, 3], matrix[1, 5] = -z, x
    matrix[2, 3], matrix[2, 4] = y, -x
    return matrix


def mass_matrix(masses: MassProperties) -> np.ndarray:
    """Mass matrix about the origin, (6, 6) [kg, kg m, kg m2].

    Principal axes of inertia through the centre of gravity are taken parallel to
    the ship's. The source's printed matrix ([Grande2002]_ 2.2) lacks the squares
    of the gyradii; this is the repaired one, moved to the origin.
    """
    about_centre = masses.mass * np.diag(
        [
            1.0,
            1.0,
            1.0,
            masses.roll_gyradius**2,
            masses.pitch_gyradius**2,
            masses.yaw_gyradius**2,
        ]
    )
    to_centre = translation_matrix(masses.centre_of_gravity)
    return to_centre.T @ about_centre @ to_centre


def roll_damping(masses: MassProperties, stiffness: np.ndarray, added_mass: np.ndarray) -> np.ndarray:
    """Viscous roll damping about the centre of gravity, referred to the origin (..., 6, 6) [kg m2/s].

    A share ``masses.roll_damping_ratio`` of the critical damping
    2 sqrt((I44 + A44) C44), with A44 of the same wave and heading.

    Parameters
    ----------
    stiffness : (6, 6) about the origin; added_mass : (..., 6, 6) about the origin.
    """
    to_centre = translation_matrix(masses.centre_of_gravity)
    from_centre = np.linalg.inv(to_centre)
    added = from_centre[:, 3] @ added_mass @ from_centre[:, 3]
    restoring = from_centre[:, 3] @ stiffness @ from_centre[:, 3]
    inertia = masses.mass * masses.roll_gyradius**2 + added
    critical = 2 * np.sqrt(np.maximum(inertia * restoring, 0.0))
    about_centre = np.zeros((*np.shape(critical), 6, 6))
    about_centre[..., 3, 3] = masses.roll_damping_ratio * critical
    return to_centre.T @ about_centre @ to_centre


def motions(
    hydrodynamics: xr.Dataset,
    masses: MassProperties,
    hydrostatic_stiffness: xr.DataArray,
    *,
    additions: Sequence[xr.Dataset] = (),
    locked: Sequence[str] = (),
    cross_flow: CrossFlow | None = None,
    wave_amplitude: float | None = None,
) -> xr.Dataset:
    """Motions per wave amplitude of a free ship, at its centre of gravity.

    Parameters
    ----------
    hydrodynamics : added mass, damping and excitation over (omega, wave_direction), about the origin.
    masses : mass, centre of gravity, gyradii, roll damping.
    hydrostatic_stiffness : (6, 6) about the origin, gravity's part included.
    additions : Datasets with any of ``added_mass``, ``damping``, ``stiffness`` and ``excitation_force`` about
        the origin, for the same waves where they depend on them (sails, foils, fins, roll damping).
    locked : modes that are held at zero at the centre of gravity, such as ("roll",) for a ship that
        flies a hull, or ("surge", "sway", "yaw") for a captive model.
    cross_flow : pieces of hull with drag, linearised for waves of ``wave_amplitude`` [m]; the
        response then depends on this amplitude.

    Returns
    -------
    Dataset: ``motion_rao`` (omega, wave_direction, dof) complex, at the centre of
    gravity, for a crest at the *origin* at t = 0; ``wave_at_reference`` the
    incident elevation at the centre of gravity (phases are quoted against it);
    ``encounter_frequency``, ``wavenumber``; the centre of gravity, the locked modes and the wave
    amplitude of the linearisation in the attributes.

    Notes
    -----
    In long waves heave tends to 1 and pitch to the wave slope. Linear: small
    motions; no lift and no viscous damping but the roll damping of ``masses`` and what is added.
    """
    stiffness = np.asarray(hydrostatic_stiffness)
    added = hydrodynamics.added_mass.values + total(additions, "added_mass", hydrodynamics)
    damping = hydrodynamics.radiation_damping.values + total(additions, "damping", hydrodynamics)
    damping = damping + roll_damping(masses, stiffness, hydrodynamics.added_mass.values)
    stiffness = stiffness + total(additions, "stiffness", hydrodynamics)
    force = hydrodynamics.excitation_force.values + total(additions, "excitation_force", hydrodynamics)
    encounter = hydrodynamics.encounter_frequency.values[..., None, None]
    system = -(encounter**2) * (mass_matrix(masses) + added) - 1j * encounter * damping + stiffness
    centre = masses.centre_of_gravity
    from_centre = np.linalg.inv(translation_matrix(centre))
    free = free_modes(locked)
    notes = list(quantities.warnings_of(hydrodynamics, *additions))
    attrs = {
        "speed": hydrodynamics.attrs["speed"],
        "density": hydrodynamics.attrs["density"],
        "centre_of_gravity": [float(value) for value in centre],
    }
    if len(free) < 6:
        held = [mode for mode in MODES if mode in locked]
        attrs["locked"] = ", ".join(held)
        notes.append(f"{' and '.join(held).capitalize()} held at zero at the centre of gravity.")
    if cross_flow is None:
        at_origin = solution(system, force, from_centre, free)
    else:
        attrs["wave_amplitude"] = checked_number(
            "wave amplitude of the drag", wave_amplitude, "m", above=0.0, at_most=50.0,
            cure="drag across the hulls is linearised for waves of one amplitude",
        )  # fmt: skip
        at_origin, note = solution_with_drag(
            hydrodynamics, system, force, from_centre, free, cross_flow, wave_amplitude
        )
        notes.append(note)
    notes += energy_notes(additions, hydrodynamics, at_origin)
    at_centre = at_origin @ translation_matrix(centre).T
    at_centre[..., [index for index in range(6) if index not in free]] = 0.0
    k = hydrodynamics.wavenumber.values[:, None]
    direction = hydrodynamics.wave_direction.values[None, :]
    along = centre[0] * np.cos(direction) + centre[1] * np.sin(direction)
    return quantities.dataset(
        {"omega": hydrodynamics.omega, "wave_direction": hydrodynamics.wave_direction, "dof": list(MODES)},
        method=hydrodynamics.attrs["method"],
        warnings=notes,
        attrs=attrs,
        motion_rao=(("omega", "wave_direction", "dof"), at_centre),
        wave_at_reference=(("omega", "wave_direction"), np.exp(1j * k * along)),
        encounter_frequency=(("omega", "wave_direction"), hydrodynamics.encounter_frequency.values),
        wavenumber=("omega", hydrodynamics.wavenumber.values),
    )


def motions_at(motion_set: xr.Dataset, point) -> xr.DataArray:
    """Motions per wave amplitude at another point of the ship (omega, wave_direction, dof).

    Velocity is ``-1j * encounter_frequency`` times this, acceleration
    ``-encounter_frequency**2`` times this (see `velocity`, `acceleration`).
    """
    lever = np.asarray(point, float) - np.asarray(motion_set.attrs["centre_of_gravity"])
    moved = motion_set.motion_rao.copy(data=motion_set.motion_rao.values @ translation_matrix(lever).T)
    return moved


def velocity(rao: xr.DataArray, encounter_frequency: xr.DataArray) -> xr.DataArray:
    """Velocity per wave amplitude from motion per wave amplitude."""
    return -1j * encounter_frequency * rao


def acceleration(rao: xr.DataArray, encounter_frequency: xr.DataArray) -> xr.DataArray:
    """Acceleration per wave amplitude from motion per wave amplitude."""
    return -(encounter_frequency**2) * rao


def lead_over_wave(motion_set: xr.Dataset) -> xr.DataArray:
    """Phase lead of each motion over the wave elevation at the centre of gravity [rad], in (-pi, pi]."""
    lead = -np.angle(motion_set.motion_rao / motion_set.wave_at_reference)
    return motion_set.motion_rao.real.copy(data=lead)


def interpolated_motions(motion_set: xr.Dataset, omega: np.ndarray) -> np.ndarray:
    """Motions at other wave frequencies (len(omega), wave_direction, 6), referred to a crest at the origin.

    Interpolated in the phase against the wave at the centre of gravity, which turns
    slowly, not against the wave at the origin; beyond the ends of the table the end
    value is held.
    """
    steady = motion_set.motion_rao.values / motion_set.wave_at_reference.values[..., None]
    found = between(motion_set.omega.values, steady, omega)
    centre = motion_set.attrs["centre_of_gravity"]
    direction = motion_set.wave_direction.values
    along = centre[0] * np.cos(direction) + centre[1] * np.sin(direction)
    k = wavenumber(omega)
    return found * np.exp(1j * k[:, None] * along)[..., None]


def between(nodes: np.ndarray, values: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Complex values (nodes, ...) at other places (wanted, ...), by cubic splines.

    Straight lines would cut the peaks of a response: by 2 % of the deviation of relative motion in the
    usual frequencies, and a tenth of the slams. Beyond the ends the end value is held.
    """
    if len(nodes) < 3:
        upper = np.clip(np.searchsorted(nodes, wanted), min(1, len(nodes) - 1), len(nodes) - 1)
        lower = np.maximum(upper - 1, 0)
        width = np.where(upper > lower, nodes[upper] - nodes[lower], 1.0)
        share = np.clip((wanted - nodes[lower]) / width, 0, 1).reshape(-1, *[1] * (values.ndim - 1))
        return values[lower] * (1 - share) + values[upper] * share
    parts = np.stack([values.real, values.imag], axis=-1)
    found = CubicSpline(nodes, parts, axis=0)(np.clip(wanted, nodes[0], nodes[-1]))
    return found[..., 0] + 1j * found[..., 1]
