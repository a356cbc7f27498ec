"""Rigid-body motions in regular waves: the equation of motion, and motions at any point.

With exp(-i omega_e t), about the ship's origin::

    [-omega_e^2 (M + A) - i omega_e (B + B_viscous) + C] xi = F

Forces that are not of the hull in potential flow (`workbench.damping`) are added
to A, B, C and F; drag across the hulls is linearised by iteration.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES, wavenumber
from workbench.damping.cross_flow import LINEARISED, CrossFlow
from workbench.design import MassProperties
from workbench.errors import InputError, checked_choice, checked_number

DRAG_ITERATIONS = 100
DRAG_TOLERANCE = 1e-6
"""Largest change of a displacement or rotation in an iteration, over the largest, that ends the iteration [-]."""


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
    added = hydrodynamics.added_mass.values + _sum(additions, "added_mass", hydrodynamics)
    damping = hydrodynamics.radiation_damping.values + _sum(additions, "damping", hydrodynamics)
    damping = damping + roll_damping(masses, stiffness, hydrodynamics.added_mass.values)
    stiffness = stiffness + _sum(additions, "stiffness", hydrodynamics)
    force = hydrodynamics.excitation_force.values + _sum(additions, "excitation_force", hydrodynamics)
    encounter = hydrodynamics.encounter_frequency.values[..., None, None]
    system = -(encounter**2) * (mass_matrix(masses) + added) - 1j * encounter * damping + stiffness
    centre = masses.centre_of_gravity
    free = _free_modes(locked)
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
        at_origin = _solution(system, force, centre, free)
    else:
        attrs["wave_amplitude"] = checked_number(
            "wave amplitude of the drag", wave_amplitude, "m", above=0.0, at_most=50.0,
            cure="drag across the hulls is linearised for waves of one amplitude",
        )  # fmt: skip
        at_origin, note = _with_drag(hydrodynamics, system, force, centre, free, cross_flow, wave_amplitude)
        notes.append(note)
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


def _free_modes(locked: Sequence[str]) -> list[int]:
    """Return the numbers of the modes that are not locked."""
    if isinstance(locked, str):
        raise InputError(f"locked must be a list of modes, got {locked!r}; write ({locked!r},).")
    for mode in locked:
        checked_choice("locked mode", mode, MODES)
    free = [index for index, mode in enumerate(MODES) if mode not in locked]
    if not free:
        raise InputError("locked must leave one mode free, got all six; take one out.")
    return free


def _sum(additions: Sequence[xr.Dataset], name: str, hydrodynamics: xr.Dataset):
    """Return the sum of a variable over the additions, on the waves of the hydrodynamics; 0 if there is none."""
    total = 0.0
    for one in additions:
        if name not in one:
            continue
        variable = one[name]
        for dim in ("omega", "wave_direction"):
            if dim not in variable.dims:
                variable = variable.expand_dims(dim)
            elif not np.array_equal(variable[dim], hydrodynamics[dim]):
                raise InputError(
                    f"{name} of {one.attrs.get('method', 'an addition')} must be for the waves of the hydrodynamics, "
                    f"its {dim} differs; compute it for the same."
                )
        modes = [dim for dim in ("influenced_dof", "radiating_dof") if dim in variable.dims]
        total = total + variable.transpose("omega", "wave_direction", *modes).values
    return total


def _solution(system: np.ndarray, force: np.ndarray, centre, free: list[int]) -> np.ndarray:
    """Return the motions at the origin of the modes that are free at the centre of gravity."""
    try:
        if len(free) == 6:
            return np.linalg.solve(system, force[..., None])[..., 0]
        from_centre = np.linalg.inv(translation_matrix(centre))[:, free]
        reduced = from_centre.T @ system @ from_centre
        return np.linalg.solve(reduced, (force @ from_centre)[..., None])[..., 0] @ from_centre.T
    except np.linalg.LinAlgError as error:
        raise InputError(
            "The equation of motion is singular; check masses and gyradii of the design."
        ) from error


def _with_drag(
    hydrodynamics: xr.Dataset,
    system: np.ndarray,
    force: np.ndarray,
    centre,
    free: list[int],
    drag: CrossFlow,
    amplitude: float,
) -> tuple[np.ndarray, str]:
    """Return the motions at the origin with linearised drag, and a sentence about the linearisation."""
    speed = hydrodynamics.attrs["speed"]
    met = hydrodynamics.encounter_frequency.values[..., None, None]
    moved = drag.velocity_rows
    flow = -1j * met * moved + speed * drag.turning_rows
    wave = drag.wave_velocity(hydrodynamics.omega.values, hydrodynamics.wave_direction.values)
    found = _solution(system, force, centre, free)
    for _ in range(DRAG_ITERATIONS):
        across = np.abs(np.einsum("fbnj,fbj->fbn", flow, found) - wave)
        strength = LINEARISED * amplitude * drag.strengths * across
        resisted = system + np.einsum("fbn,nj,fbnk->fbjk", strength, moved, flow, optimize=True)
        driven = force + np.einsum("fbn,nj->fbj", strength * wave, moved)
        new = _solution(resisted, driven, centre, free)
        kinds = np.abs(new).reshape(-1, 2, 3).max(axis=(0, 2))
        change = float((np.abs(new - found).reshape(-1, 2, 3).max(axis=(0, 2)) / kinds).max())
        found = (found + new) / 2
        if change < DRAG_TOLERANCE:
            note = f"Drag across the hulls is linearised for waves of {amplitude:g} m amplitude."
            return new, note
    return found, (
        f"Drag across the hulls did not settle in {DRAG_ITERATIONS} iterations; the last change was "
        f"{100 * change:.2g} % of the largest motion."
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

    Interpolated linearly in amplitude-weighted phase against the wave at the
    centre of gravity, which turns slowly, not against the wave at the origin;
    beyond the ends of the table the end value is held.
    """
    steady = motion_set.motion_rao.values / motion_set.wave_at_reference.values[..., None]
    nodes = motion_set.omega.values
    found = np.empty((len(omega), *steady.shape[1:]), complex)
    for index in np.ndindex(steady.shape[1:]):
        column = steady[(slice(None), *index)]
        found[(slice(None), *index)] = np.interp(omega, nodes, column.real) + 1j * np.interp(
            omega, nodes, column.imag
        )
    centre = motion_set.attrs["centre_of_gravity"]
    direction = motion_set.wave_direction.values
    along = centre[0] * np.cos(direction) + centre[1] * np.sin(direction)
    k = wavenumber(omega)
    return found * np.exp(1j * k[:, None] * along)[..., None]
