"""Incident waves on sections: Froude-Krylov and diffraction forces per length, any heading.

The wave has its own frequency omega; the section answers at the encounter frequency. With
unit-velocity radiation potentials phi_j of the section at omega_e, outward normals and
exp(-i omega_e t), per unit wave amplitude and density::

    d_j =  i omega_e int phi_j dphi_I/dn dl     (Haskind's relation, [Grande2002]_ A1.96 conjugated)
    f_j = -i omega   int phi_I n_j dl           ([Grande2002]_ A1.95 conjugated)

The transverse phase is k y sin(beta); the thesis prints k y cos(beta). Only the normal in the
plane of the section is used (slender hulls).

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, appendix 1.
"""

from typing import NamedTuple

import numpy as np

from workbench.conventions import GRAVITY, wavenumber
from workbench.hydrodynamics.sections import SectionStack, WettedPanels


class Waves(NamedTuple):
    """Waves met, all (waves,): frequency [rad/s], direction [rad], signed encounter frequency [rad/s], not 0."""

    omega: np.ndarray
    direction: np.ndarray
    encounter: np.ndarray


def orbital_decay(panels: WettedPanels, x: np.ndarray, waves: Waves) -> np.ndarray:
    """exp(k z + i k (x cos beta + y sin beta)) on the panels of sections at x, (waves, sections, panels) [-]."""
    k = wavenumber(waves.omega)[:, None, None]
    along, across = np.cos(waves.direction)[:, None, None], np.sin(waves.direction)[:, None, None]
    transverse = np.exp(k * (panels.z + 1j * across * panels.y))
    return transverse * np.exp(1j * k * along * x[:, None])


def haskind_density(
    panels: WettedPanels, potential: np.ndarray, elevation: np.ndarray, waves: Waves
) -> np.ndarray:
    """Diffraction force per length over density in sway, heave and roll (waves, sections, 3) [m2/s2, m3/s2].

    Parameters
    ----------
    potential : radiation potentials at the encounter frequencies (waves, sections, 3, panels).
    elevation : of `orbital_decay`.
    """
    across = np.sin(waves.direction)[:, None, None]
    flow = elevation * ((panels.normal_z + 1j * across * panels.normal_y) * panels.length)
    met = (waves.encounter * waves.omega)[:, None, None]  # i omega_e times -i omega
    return met * (potential @ flow[..., None])[..., 0]


def froude_krylov_density(panels: WettedPanels, elevation: np.ndarray) -> np.ndarray:
    """Froude-Krylov force per length over density in sway, heave and roll (waves, sections, 3)."""
    modes = panels.modes() * panels.length[:, None, :]
    return -GRAVITY * np.einsum("wsp,sjp->wsj", elevation, modes, optimize=True)


def lengthwise_density(panels: WettedPanels, elevation: np.ndarray, waves: Waves) -> np.ndarray:
    """Froude-Krylov force of the lengthwise normal per length over density: surge, pitch, yaw (waves, sections, 3).

    -int p n_x dS = -int dp/dx dV over the closed body, and each section's integral of
    exp(k z) g is one along its contour of the integral of exp(k z) g from z to the surface.
    """
    k = wavenumber(waves.omega)[:, None, None]
    depth = k * panels.z
    strip = elevation * np.exp(-depth) * (panels.normal_z * panels.length)
    column = strip * np.expm1(depth) / k
    small = np.abs(depth) < 1e-3
    safe = np.where(small, -1.0, depth)
    moment = np.where(small, 0.5 + depth / 3, ((safe - 1) * np.exp(safe) + 1) / safe**2) * panels.z**2
    slope = -1j * GRAVITY * (k[:, :, 0] * np.cos(waves.direction)[:, None])
    parts = (column.sum(axis=-1), (strip * moment).sum(axis=-1), -(column * panels.y).sum(axis=-1))
    return slope[..., None] * np.stack(parts, axis=-1)


def arresting_velocity(sections: SectionStack, waves: Waves) -> tuple[np.ndarray, np.ndarray]:
    """Normal velocity that cancels the wave's on the panels, even and odd in y (waves, sections, panels, 1).

    For a wave with its crest at the section; at another station x the answer turns by
    exp(i k x cos beta). Without mirror the odd part is zero.
    """
    (y, z), (normal_y, normal_z) = sections.middles, sections.normals
    k = wavenumber(waves.omega)[:, None, None]
    across = np.sin(waves.direction)[:, None, None]

    def velocity(side):
        elevation = np.exp(k * (z + 1j * across * side * y))
        return 1j * waves.omega[:, None, None] * elevation * (normal_z + 1j * across * side * normal_y)

    here = velocity(1.0)[..., None]
    if not sections.mirrored:
        return here, np.zeros_like(here)
    other = velocity(-1.0)[..., None]
    return (here + other) / 2, (here - other) / 2
