"""Panels of two bodies whose added mass and damping are known: a hemisphere and a long half-cylinder."""

import numpy as np

from workbench.conventions import GRAVITY
from workbench.geometry.faceted import Panels, cleaned, grid_faces, joined
from workbench.hydrodynamics.radiation import RadiationProblem, frequency_solution, mode_normals

HEAVE, SWAY = 2, 1


def hemisphere(strips: int) -> RadiationProblem:
    """Half of a floating hemisphere of radius 1 m and of the true volume, with its lid."""
    below = np.linspace(0.0, np.pi / 2, strips + 1)
    around = np.linspace(np.pi, 0.0, 2 * (7 * strips // 8) + 1)
    phi, theta = np.meshgrid(around, below, indexing="ij")
    inscribed = _surface(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), -np.cos(theta))
    growth = (2 * np.pi / 3 / inscribed.volume) ** (1 / 3)
    hull = Panels(inscribed.vertices * growth, inscribed.faces, inscribed.is_transom, True)
    phi, radius = np.meshgrid(around, np.linspace(0.0, 1.0, strips // 2 + 1), indexing="ij")
    return RadiationProblem(panels=hull, lid=_surface(radius * np.cos(phi), radius * np.sin(phi), 0 * phi))


def half_cylinder(length: float, strips: int) -> RadiationProblem:
    """Half of a half-immersed circular cylinder of radius 1 m and of the true section area, with its lid."""
    columns = round(1.5 * length)
    x = np.linspace(-length / 2, length / 2, columns + 1)
    angle = np.linspace(0.0, np.pi / 2, strips + 1)
    step = np.pi / 2 / strips
    radius = np.sqrt(step / np.sin(step))
    along, theta = np.meshgrid(x, angle, indexing="ij")
    parts = [_surface(along, radius * np.sin(theta), -radius * np.cos(theta))]
    share, theta = np.meshgrid(np.linspace(0.0, radius, 3), angle, indexing="ij")
    for end in (-length / 2, length / 2):
        order = slice(None) if end < 0 else slice(None, None, -1)
        parts.append(
            _surface(
                np.full_like(share, end), (share * np.sin(theta))[order], -(share * np.cos(theta))[order]
            )
        )
    along, y = np.meshgrid(x[::2], np.linspace(0.0, 1.0, 5), indexing="ij")
    return RadiationProblem(panels=joined(parts, mirrored=True), lid=_surface(along, y, 0 * along))


def _surface(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> Panels:
    faces = grid_faces(*x.shape)
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    return cleaned(points, faces, np.zeros(len(faces), bool), True)


def hemisphere_heave(reduced: float, strips: int) -> tuple[float, float]:
    """Heave added mass over rho V and damping over rho V omega at K a = ``reduced``."""
    problem = hemisphere(strips)
    omega = np.sqrt(reduced * GRAVITY)
    force = _force(problem, omega, HEAVE, 2 * problem.panels.areas)
    volume = 2 * np.pi / 3
    return float(force.real / (omega**2 * volume)), float(force.imag / (omega**2 * volume))


def cylinder_coefficients(
    reduced: float, mode: int, strips: int, length: float = 40.0
) -> tuple[float, float]:
    """Added mass and damping of the middle of a long half-cylinder over rho pi a**2/2 (and omega).

    The middle is weighed with a squared cosine over four fifths of the length,
    which takes the waves from the ends out.
    """
    problem = half_cylinder(length, strips)
    omega = np.sqrt(reduced * GRAVITY)
    x = problem.panels.centres[:, 0]
    reach = 0.4 * length
    weight = np.where(np.abs(x) < reach, np.cos(np.pi * x / (2 * reach)) ** 2, 0.0)
    columns = round(1.5 * length)
    inside = np.abs(x) < length / 2 - 1e-6
    equivalent = weight[inside].sum() / strips * length / columns
    force = _force(problem, omega, mode, 2 * problem.panels.areas * weight * inside)
    scale = omega**2 * equivalent * np.pi / 2
    return float(force.real / scale), float(force.imag / scale)


def _force(problem: RadiationProblem, omega: float, mode: int, weights: np.ndarray) -> complex:
    """Return omega**2 A + i omega B over density, from panels weighed with their areas."""
    normals = mode_normals(problem.panels.centres, problem.panels.normals)[mode]
    potential = frequency_solution(problem, omega)["potential"][mode]
    return complex(-(omega**2) * np.sum(potential * normals * weights))


def extrapolated(coarse: tuple[float, float], fine: tuple[float, float]) -> tuple[float, float]:
    """Limit of infinitely many panels from n and 2 n strips; the error goes with 1/n."""
    return 2 * fine[0] - coarse[0], 2 * fine[1] - coarse[1]
