"""Radiation potentials of wetted panels at rest, one factorised matrix per encounter frequency.

The potentials depend on panels and encounter frequency alone; `forward_speed` makes
added mass, damping and wave forces of them for any wave, heading and speed. Where the
elevation between the hulls is wanted, diffraction at rest uses the same factors.

Sources on the wetted panels, on an interior waterplane lid (no irregular
frequencies) and, if wanted, on a damping lid between the hulls, where
``g phi_z = omega^2 (1 + i eps) phi`` takes energy out of the gap resonance that
potential flow leaves undamped. (The sign goes with exp(-i omega t).)
"""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from multiprocessing import get_context

import numpy as np
import xarray as xr
from scipy.linalg import lu_factor, lu_solve

from workbench import quantities
from workbench.conventions import GRAVITY, MODES, wavenumber
from workbench.errors import InputError
from workbench.geometry.faceted import joined
from workbench.geometry.panels import Panels
from workbench.hydrodynamics import potential_flow
from workbench.hydrodynamics.incident_wave import incident_normal_velocity, incident_potential

SYMMETRIC_MODES = (0, 2, 4)
ANTISYMMETRIC_MODES = (1, 3, 5)


@dataclass(frozen=True, eq=False)
class RadiationProblem:
    """What is solved: wetted panels, lids and field points (all of one half when ``panels.mirrored``).

    Parameters
    ----------
    panels : wetted panels (n).
    lid : interior waterplane panels, or None.
    tunnel_lid : panels on z = 0 between the hulls, or None.
    tunnel_damping : eps of the tunnel lid [-]; 0.02 to 0.05 leaves the incident wave alone.
    field_x, field_y : grid on which the elevation is wanted [m]; field_y symmetric about 0.
    """

    panels: Panels
    lid: Panels | None = None
    tunnel_lid: Panels | None = None
    tunnel_damping: float = 0.0
    field_x: tuple[float, ...] = ()
    field_y: tuple[float, ...] = ()

    @property
    def points(self) -> np.ndarray:
        """Field points that are solved for, (m, 3): those with y >= 0 when mirrored."""
        y = np.array([value for value in self.field_y if value >= 0 or not self.panels.mirrored])
        grid = np.meshgrid(self.field_x, y, [0.0], indexing="ij")
        return np.stack([part.ravel() for part in grid], axis=-1)


def all_sources(problem: RadiationProblem) -> Panels:
    """Return wetted panels, lid and tunnel lid, in this order, as one set."""
    parts = [part for part in (problem.panels, problem.lid, problem.tunnel_lid) if part is not None]
    return joined(parts, mirrored=problem.panels.mirrored)


def mode_normals(centres: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Normal velocity of unit motions about the origin, (6, n): n and r x n."""
    return np.concatenate([normals, np.cross(centres, normals)], axis=1).T


def frequency_solution(
    problem: RadiationProblem,
    encounter_omega: float,
    waves: Sequence[tuple[float, float]] = (),
    sources: Panels | None = None,
) -> dict[str, np.ndarray]:
    """Solve one encounter frequency.

    Parameters
    ----------
    problem : what to solve.
    encounter_omega : [rad/s], or ``numpy.inf``.
    waves : (omega [rad/s], wave_direction [rad]) of incident waves met at this frequency.
    sources : the joined panels, if the caller keeps them over the frequencies.

    Returns
    -------
    ``potential`` (6, n) on the panels and ``field`` (6, m) at the points, per unit
    velocity of the six modes; ``diffraction`` (waves, n or 2 n) potential on the
    panels (the second n on the mirror image) and ``diffraction_field`` (waves, m
    or 2 m).
    """
    if np.isinf(encounter_omega):  # the potential vanishes on z = 0, and with it the sources of the lids
        problem, sources = replace(problem, lid=None, tunnel_lid=None), problem.panels
    panels = problem.panels
    n_hull = len(panels.faces)
    n_lid = 0 if problem.lid is None else len(problem.lid.faces)
    if sources is None:
        sources = all_sources(problem)
    kappa = wavenumber(encounter_omega)
    points = problem.points
    matrices = potential_flow.influence(sources, kappa, points if len(points) else None)
    modes = mode_normals(panels.centres, panels.normals)
    mirror = np.array([1.0, -1.0, 1.0])
    parities = (
        ((1.0, SYMMETRIC_MODES), (-1.0, ANTISYMMETRIC_MODES)) if panels.mirrored else ((0.0, range(6)),)
    )

    potential = np.zeros((6, n_hull), complex)
    field = np.zeros((6, len(points)), complex)
    by_parity = []
    for parity, own_modes in parities:
        single_layer, normal_velocity, at_points = (
            _combined(matrices, name, parity)
            for name in ("potential", "normal_velocity", "potential_at_points")
        )
        tunnel = slice(n_hull + n_lid, None)
        damped = kappa * (1 + 1j * problem.tunnel_damping)
        system = np.asarray(normal_velocity, complex)
        if problem.tunnel_lid is not None:
            system[tunnel] += damped * single_layer[tunnel]
        right = np.zeros((len(system), len(own_modes) + len(waves)), complex)
        right[:n_hull, : len(own_modes)] = modes[list(own_modes)].T
        for j, (omega, direction) in enumerate(waves, start=len(own_modes)):

            def part(values_at, parity=parity):
                here = values_at(np.ones(3))
                return here if parity == 0 else (here + parity * values_at(mirror)) / 2

            right[:n_hull, j] = -part(
                lambda side, omega=omega, direction=direction: incident_normal_velocity(
                    panels.centres * side, panels.normals * side, omega, direction
                )
            )
            if problem.tunnel_lid is not None:
                k = wavenumber(omega)
                right[tunnel, j] = -(damped - k) * part(
                    lambda side, omega=omega, direction=direction: incident_potential(
                        problem.tunnel_lid.centres * side, omega, direction
                    )
                )
        strengths = lu_solve(
            lu_factor(system, overwrite_a=True, check_finite=False), right, check_finite=False
        )
        on_hull = single_layer[:n_hull] @ strengths
        on_field = at_points @ strengths if len(points) else np.zeros((0, right.shape[1]))
        potential[list(own_modes)] = on_hull[:, : len(own_modes)].T
        field[list(own_modes)] = on_field[:, : len(own_modes)].T
        by_parity.append((parity, on_hull[:, len(own_modes) :].T, on_field[:, len(own_modes) :].T))

    def whole(index: int) -> np.ndarray:
        here = sum(part[index] for part in by_parity)
        if not panels.mirrored:
            return here
        return np.concatenate([here, sum(part[0] * part[index] for part in by_parity)], axis=-1)

    return {"potential": potential, "field": field, "diffraction": whole(1), "diffraction_field": whole(2)}


def _combined(matrices: dict[str, np.ndarray], name: str, parity: float) -> np.ndarray | None:
    """Return the matrix of sources of the given parity about y = 0 (0: no symmetry)."""
    if name not in matrices:
        return None
    return matrices[name] if parity == 0 else matrices[name] + parity * matrices[f"{name}_mirror"]


def on_field_grid(problem: RadiationProblem, half: np.ndarray, other_half: np.ndarray) -> np.ndarray:
    """Arrange field values (..., m) of the half y >= 0 and of its image on the grid (..., field_x, field_y)."""
    n_x = len(problem.field_x)
    half = half.reshape(*half.shape[:-1], n_x, -1)
    if not problem.panels.mirrored:
        return half
    other_half = other_half.reshape(*other_half.shape[:-1], n_x, -1)
    on_axis = 1 if 0.0 in problem.field_y else 0
    return np.concatenate([other_half[..., ::-1][..., : other_half.shape[-1] - on_axis], half], axis=-1)


@contextmanager
def solution_stream(
    problem: RadiationProblem,
    encounter_omega: Sequence[float],
    waves: Sequence[Sequence[tuple[float, float]]],
    workers: int,
) -> Iterator[Iterator[dict[str, np.ndarray]]]:
    """Give the solutions one by one, in order; from worker processes when ``workers`` > 1.

    The solver holds the interpreter lock: an interface that must stay alive asks for workers.
    """
    if workers > 1:
        with ProcessPoolExecutor(workers, mp_context=get_context("forkserver")) as pool:
            futures = [
                pool.submit(frequency_solution, problem, frequency, own)
                for frequency, own in zip(encounter_omega, waves, strict=True)
            ]
            try:
                yield (future.result() for future in futures)
            finally:
                for future in futures:
                    future.cancel()
    else:
        sources = all_sources(problem)
        yield (
            frequency_solution(problem, frequency, own, sources)
            for frequency, own in zip(encounter_omega, waves, strict=True)
        )


def radiation(
    problem: RadiationProblem,
    encounter_omega: Sequence[float],
    wave_directions: Sequence[float] = (),
    *,
    workers: int = 1,
    progress: Callable[[float, str], None] = lambda fraction, message: None,
) -> xr.Dataset:
    """Radiation potentials and field of a set of panels at rest, in deep water.

    Parameters
    ----------
    problem : panels, lids and field points.
    encounter_omega : increasing encounter frequencies [rad/s].
    wave_directions : directions [rad] for which the diffracted field at rest is
        wanted; needs field points.
    workers : worker processes; 1 solves in this process.
    progress : called with the fraction done and a sentence after each frequency; may raise to cancel.

    Returns
    -------
    Dataset with ``radiation_potential`` (encounter_omega, radiating_dof, face) per
    unit velocity about the origin, the panels (``panel_centre``, ``panel_normal``,
    ``panel_area``), ``radiated_elevation`` (encounter_omega, radiating_dof,
    field_x, field_y) per unit motion and ``diffracted_elevation``
    (encounter_omega, wave_direction, field_x, field_y). The last
    encounter_omega is infinite.

    Notes
    -----
    Costs about 0.3 s a frequency for 1000 panels on two cores, growing with the
    square to the cube of the number of panels; 2 kB a panel and frequency.
    """
    encounter_omega = np.asarray(encounter_omega, float)
    if encounter_omega.size == 0 or np.any(np.diff(encounter_omega) <= 0) or encounter_omega[0] <= 0:
        raise InputError("encounter_omega must be increasing and > 0 rad/s; sort the frequencies.")
    directions = np.asarray(wave_directions, float)
    frequencies = [*encounter_omega.tolist(), np.inf]
    waves = [[(frequency, beta) for beta in directions] for frequency in frequencies[:-1]] + [[]]
    potentials, fields, diffracted = [], [], []
    with solution_stream(problem, frequencies, waves, workers) as solutions:
        for i, (frequency, solution) in enumerate(zip(frequencies, solutions, strict=True)):
            potentials.append(solution["potential"])
            if problem.field_x:
                signs = np.where(np.isin(range(6), SYMMETRIC_MODES), 1.0, -1.0)[:, None]
                per_motion = 0.0 if np.isinf(frequency) else frequency**2 / GRAVITY
                fields.append(
                    per_motion * on_field_grid(problem, solution["field"], signs * solution["field"])
                )
            if waves[i] and problem.field_x:
                half, other = _halves(problem, solution["diffraction_field"])
                diffracted.append(1j * frequency / GRAVITY * on_field_grid(problem, half, other))
            progress((i + 1) / len(frequencies), f"frequency {i + 1} of {len(frequencies)}")

    panels = problem.panels
    coords = {"encounter_omega": frequencies, "radiating_dof": list(MODES), "axis": ["x", "y", "z"]}
    variables = {
        "radiation_potential": (("encounter_omega", "radiating_dof", "face"), np.array(potentials)),
        "panel_centre": (("face", "axis"), panels.centres),
        "panel_normal": (("face", "axis"), panels.normals),
        "panel_area": ("face", panels.areas),
        "panel_is_transom": ("face", panels.is_transom.astype(np.int8)),
    }
    if problem.field_x:
        coords |= {"field_x": list(problem.field_x), "field_y": list(problem.field_y)}
        grid = ("field_x", "field_y")
        variables["radiated_elevation"] = (("encounter_omega", "radiating_dof", *grid), np.array(fields))
        if diffracted:
            coords["wave_direction"] = directions
            diffracted.append(np.zeros_like(diffracted[0]))
            variables["diffracted_elevation"] = (
                ("encounter_omega", "wave_direction", *grid),
                np.array(diffracted),
            )
    return quantities.dataset(
        coords,
        method="potential flow at rest",
        attrs={
            "solver": potential_flow.SOLVER_VERSION,
            "mirrored": int(panels.mirrored),
            "highest_resolved_frequency": potential_flow.highest_resolved_frequency(panels),
            "transom_end": float(np.min(panels.vertices[:, 0])),
        },
        **variables,
    )


def _halves(problem: RadiationProblem, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Split field values of a diffraction solution into the two sides."""
    return tuple(np.split(values, 2, axis=-1)) if problem.panels.mirrored else (values, values)
