"""Solving the equation of motion: with forces added to those of the hull, modes locked, and drag linearised."""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench.conventions import MODES
from workbench.damping.cross_flow import LINEARISED, CrossFlow
from workbench.errors import InputError, checked_choice

DRAG_ITERATIONS = 100
DRAG_TOLERANCE = 1e-6
"""Largest change of a displacement or rotation in an iteration, over the largest, that ends the iteration [-]."""


def free_modes(locked: Sequence[str]) -> list[int]:
    """Numbers of the modes that are not locked."""
    if isinstance(locked, str):
        raise InputError(f"locked must be a list of modes, got {locked!r}; write ({locked!r},).")
    for mode in locked:
        checked_choice("locked mode", mode, MODES)
    free = [index for index, mode in enumerate(MODES) if mode not in locked]
    if not free:
        raise InputError("locked must leave one mode free, got all six; take one out.")
    return free


def total(additions: Sequence[xr.Dataset], name: str, hydrodynamics: xr.Dataset):
    """Sum of a variable over the additions, on the waves of the hydrodynamics; 0 if there is none."""
    summed = 0.0
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
        summed = summed + variable.transpose("omega", "wave_direction", *modes).values
    return summed


def energy_notes(
    additions: Sequence[xr.Dataset], hydrodynamics: xr.Dataset, at_origin: np.ndarray
) -> list[str]:
    """Say where added damping puts energy into the motion: where xi* B xi < 0, for additions that no wave drives."""
    notes = []
    for one in additions:
        if "damping" not in one or "excitation_force" in one:
            continue
        damping = np.broadcast_to(total([one], "damping", hydrodynamics), (*at_origin.shape, 6))
        taken = np.einsum("fbj,fbjk,fbk->fb", at_origin.conj(), damping, at_origin).real
        feeds = int((taken < -1e-9 * np.abs(taken).max()).sum())
        if feeds:
            name = one.attrs.get("method", "An addition").capitalize()
            notes.append(f"{name}: in {feeds} of {taken.size} waves the damping puts energy into the motion.")
    return notes


def solution(system: np.ndarray, force: np.ndarray, from_centre: np.ndarray, free: list[int]) -> np.ndarray:
    """Motions at the origin, (omega, wave_direction, 6), of the modes that are free at the centre of gravity.

    Parameters
    ----------
    system : (omega, wave_direction, 6, 6) and force : (omega, wave_direction, 6), about the origin.
    from_centre : (6, 6), motions at the origin from those at the centre of gravity.
    """
    try:
        if len(free) == 6:
            return np.linalg.solve(system, force[..., None])[..., 0]
        moving = from_centre[:, free]
        reduced = moving.T @ system @ moving
        return np.linalg.solve(reduced, (force @ moving)[..., None])[..., 0] @ moving.T
    except np.linalg.LinAlgError as error:
        raise InputError(
            "The equation of motion is singular; check masses and gyradii of the design."
        ) from error


def solution_with_drag(
    hydrodynamics: xr.Dataset,
    system: np.ndarray,
    force: np.ndarray,
    from_centre: np.ndarray,
    free: list[int],
    drag: CrossFlow,
    amplitude: float,
) -> tuple[np.ndarray, str]:
    """Motions at the origin with linearised drag, and a sentence about the linearisation.

    Parameters
    ----------
    hydrodynamics : for waves, speed and encounter frequencies.
    system, force, from_centre, free : as for `solution`, without the drag.
    drag : pieces of hull; amplitude : of the waves [m].

    Notes
    -----
    Each wave and heading is linearised alone, for a regular wave of this amplitude. The
    mean of two successive iterates is taken, which settles where either alone would swing.
    """
    speed = hydrodynamics.attrs["speed"]
    met = hydrodynamics.encounter_frequency.values[..., None, None]
    moved = drag.velocity_rows
    flow = -1j * met * moved + speed * drag.turning_rows
    wave = drag.wave_velocity(hydrodynamics.omega.values, hydrodynamics.wave_direction.values)
    found = solution(system, force, from_centre, free)
    for _ in range(DRAG_ITERATIONS):
        across = np.abs(np.einsum("fbnj,fbj->fbn", flow, found) - wave)
        strength = LINEARISED * amplitude * drag.strengths * across
        resisted = system + np.einsum("fbn,nj,fbnk->fbjk", strength, moved, flow, optimize=True)
        driven = force + np.einsum("fbn,nj->fbj", strength * wave, moved)
        new = solution(resisted, driven, from_centre, free)
        kinds = np.maximum(np.abs(new).reshape(-1, 2, 3).max(axis=(0, 2)), np.finfo(float).tiny)
        change = float((np.abs(new - found).reshape(-1, 2, 3).max(axis=(0, 2)) / kinds).max())
        found = (found + new) / 2
        if change < DRAG_TOLERANCE:
            note = f"Drag across the hulls is linearised for waves of {amplitude:g} m amplitude."
            return new, note
    return found, (
        f"Drag across the hulls did not settle in {DRAG_ITERATIONS} iterations; the last change was "
        f"{100 * change:.2g} % of the largest motion."
    )
