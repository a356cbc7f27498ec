"""Linear potential flow about wetted panels: the one place that calls Capytaine [Ancellin2019]_.

Two ways in:

`influence`
    Capytaine's Green function as plain matrices, from which `radiation` builds
    and factorises one system per encounter frequency and serves every mode,
    heading and speed from it.
`forward_speed_coefficients`
    Capytaine's own ``forward_speed`` option, problem by problem.

Capytaine's conventions (time factor exp(-i omega t), outward normals, pitch
positive bow down when x points forward) are those of `workbench.conventions`.

.. [Ancellin2019] M. Ancellin and F. Dias, "Capytaine: a Python-based linear potential
    flow solver", Journal of Open Source Software 4(36), 1341, 2019.
"""

import functools
import logging
from collections.abc import Callable, Sequence
from importlib.metadata import version

import capytaine as cpt
import numpy as np

from workbench.conventions import GRAVITY, MODES, encounter_frequency
from workbench.errors import InputError
from workbench.geometry.faceted import Panels, turned_faces

logging.getLogger("capytaine").setLevel(logging.ERROR)

SOLVER_VERSION = f"capytaine {version('capytaine')}"
PANELS_PER_WAVELENGTH_RADIUS = 8.0
"""A wave must be at least this many panel radii long (the rule of Capytaine's own check)."""


@functools.cache
def _green_function(precision: str) -> cpt.Delhommeau:
    """Return Delhommeau's Green function in the form that allows panels on the free surface."""
    return cpt.Delhommeau(floating_point_precision=precision, gf_singularities="low_freq")


def prepared_green_function(precision: str = "float64") -> None:
    """Load (or, once per machine, tabulate: some 20 s) the Green function of `influence`."""
    _green_function(precision)


def _mesh(vertices: np.ndarray, faces: np.ndarray) -> cpt.Mesh:
    return cpt.Mesh(vertices=vertices, faces=faces, auto_check=False)


@functools.lru_cache(maxsize=8)
def _meshes(panels: Panels) -> tuple[cpt.Mesh, cpt.Mesh]:
    """Return the panels and their mirror image in y = 0 as Capytaine meshes (cached by identity)."""
    mirrored = panels.vertices * np.array([1.0, -1.0, 1.0])
    return _mesh(panels.vertices, panels.faces), _mesh(mirrored, turned_faces(panels.faces))


def influence(
    panels: Panels, wavenumber: float, points: np.ndarray | None = None, precision: str = "float64"
) -> dict[str, np.ndarray]:
    """Influence matrices of source panels in deep water.

    Parameters
    ----------
    panels : the source panels (n); when ``panels.mirrored`` the mirror image is a second set of sources.
    wavenumber : of the free-surface condition [rad/m]; ``numpy.inf`` for the infinite-frequency limit.
    points : (m, 3), optional field points.
    precision : "float64" or "float32".

    Returns
    -------
    dict of complex (n, n) matrices: ``potential`` and ``normal_velocity`` of unit
    sources at the panel centres, ``potential_mirror`` and
    ``normal_velocity_mirror`` of the mirror image's sources; and (m, n)
    ``potential_at_points``, ``potential_at_points_mirror``. Without mirror
    symmetry the mirror entries are absent.

    Notes
    -----
    Costs about 0.1 s for n = 500 on one core and grows with n squared.
    """
    green_function = _green_function(precision)
    mesh, mirror = _meshes(panels)
    free_surface = {"free_surface": 0.0, "water_depth": np.inf, "wavenumber": float(wavenumber)}
    matrices = {}
    matrices["potential"], matrices["normal_velocity"] = green_function.evaluate(mesh, mesh, **free_surface)
    if panels.mirrored:
        matrices["potential_mirror"], matrices["normal_velocity_mirror"] = green_function.evaluate(
            mesh, mirror, **free_surface, diagonal_term_in_double_layer=False
        )
    if points is not None:
        at_points = {**free_surface, "early_dot_product": False, "diagonal_term_in_double_layer": False}
        matrices["potential_at_points"] = green_function.evaluate(points, mesh, **at_points)[0]
        if panels.mirrored:
            matrices["potential_at_points_mirror"] = green_function.evaluate(points, mirror, **at_points)[0]
    return matrices


def highest_resolved_frequency(panels: Panels) -> float:
    """Highest wave (or encounter) frequency whose waves the panels resolve [rad/s].

    The wave is then eight panel radii long, Capytaine's own rule.
    """
    shortest = PANELS_PER_WAVELENGTH_RADIUS * float(np.max(panels.radius))
    return float(np.sqrt(2 * np.pi * GRAVITY / shortest))


def refuse_overtaken_waves(omega: np.ndarray, wave_directions: Sequence[float], speed: float) -> None:
    """Raise `InputError` where the ship overtakes the waves, or runs with them.

    There Capytaine's incident velocity is not the gradient of its incident
    potential (checked with 3.0.0), and the encounter frequency passes through
    zero, where no theory of small disturbances about a steady speed holds.
    """
    for direction in wave_directions:
        encounter = encounter_frequency(np.asarray(omega, float), speed, direction)
        if np.any(encounter <= 0.02 * np.asarray(omega)):
            limit = GRAVITY / (speed * np.cos(direction))
            raise InputError(
                f"At {speed:.2f} m/s and heading {np.degrees(direction):.0f} degrees the ship overtakes waves of "
                f"omega >= {limit:.3g} rad/s, which the potential-flow method cannot do: omega must be below "
                f"{0.98 * limit:.3g} rad/s there; lower the speed, or choose a heading of 90 to 270 degrees."
            )


def forward_speed_coefficients(
    panels: Panels,
    lid: Panels | None,
    omega: Sequence[float],
    wave_directions: Sequence[float],
    speed: float,
    density: float,
    progress: Callable[[float, str], None] = lambda fraction, message: None,
) -> dict[str, np.ndarray]:
    """Added mass, damping and wave forces by Capytaine's own ``forward_speed`` option.

    Parameters
    ----------
    panels, lid : wetted panels of the whole ship and its interior lid (both mirrored, or neither).
    omega : wave frequencies [rad/s]; wave_directions : [rad].
    speed : [m/s]; density : [kg/m3].
    progress : called with the fraction done and a sentence; may raise to cancel.

    Returns
    -------
    ``added_mass``, ``radiation_damping`` (omega, wave_direction, influenced_dof,
    radiating_dof) and ``froude_krylov_force``, ``diffraction_force`` (omega,
    wave_direction, influenced_dof), about the origin.

    Notes
    -----
    Valid for small speeds of slender hulls; for twin hulls at Fn 0.3 to 0.75 its
    heave peak is 1.68 to 2.2 times the measured one (Delft 372). Costs about ten
    times `radiation` per frequency: the gradient matrix is rebuilt for each problem.
    """
    refuse_overtaken_waves(np.asarray(omega), wave_directions, speed)
    body = _body(panels, lid)
    solver = cpt.BEMSolver(engine=cpt.DefaultMatrixEngine(green_function=_green_function("float64")))
    shape = (len(omega), len(wave_directions), 6)
    found = {
        "added_mass": np.zeros((*shape, 6)),
        "radiation_damping": np.zeros((*shape, 6)),
        "froude_krylov_force": np.zeros(shape, complex),
        "diffraction_force": np.zeros(shape, complex),
    }
    total = len(omega) * len(wave_directions)
    for j, direction in enumerate(wave_directions):
        for i, frequency in enumerate(omega):
            common = {
                "body": body,
                "omega": float(frequency),
                "wave_direction": float(direction),
                "forward_speed": float(speed),
                "rho": density,
                "g": GRAVITY,
                "water_depth": np.inf,
            }
            problems = [cpt.RadiationProblem(radiating_dof=dof, **common) for dof in body.dofs]
            problems.append(cpt.DiffractionProblem(**common))
            results = solver.solve_all(
                problems, keep_details=False, progress_bar=False, _check_wavelength=False
            )
            for k, result in enumerate(results[:-1]):
                found["added_mass"][i, j, :, k] = [result.added_masses[dof.capitalize()] for dof in MODES]
                found["radiation_damping"][i, j, :, k] = [
                    result.radiation_dampings[dof.capitalize()] for dof in MODES
                ]
            froude_krylov = cpt.bem.airy_waves.froude_krylov_force(problems[-1])
            found["froude_krylov_force"][i, j] = [froude_krylov[dof.capitalize()] for dof in MODES]
            found["diffraction_force"][i, j] = [results[-1].forces[dof.capitalize()] for dof in MODES]
            done = j * len(omega) + i + 1
            progress(done / total, f"frequency {done} of {total}")
    return found


def _body(panels: Panels, lid: Panels | None) -> cpt.FloatingBody:
    """Return a Capytaine body with its six rigid modes about the origin."""

    def meshed(part: Panels):
        mesh = _mesh(part.vertices, part.faces)
        return cpt.ReflectionSymmetricMesh(half=mesh, plane="xOz") if part.mirrored else mesh

    return cpt.FloatingBody(
        mesh=meshed(panels),
        lid_mesh=meshed(lid) if lid is not None else None,
        dofs=cpt.rigid_body_dofs(rotation_center=(0.0, 0.0, 0.0)),
        center_of_mass=(0.0, 0.0, 0.0),
    )
