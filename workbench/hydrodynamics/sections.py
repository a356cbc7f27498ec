"""Oscillation of two-dimensional sections of any shape at the water surface: potentials, forces, waves.

Green's identity on straight panels with constant potential and the wave source of
`section_green_function`; the section may be asymmetric, heeled, submerged, or several
contours at once (the hulls of a catamaran, which then feel each other). The irregular
frequencies of the closed interior are removed by asking in least squares that the
identity also hold at points of the interior waterline, where it must give zero
([Schenck1968]_; the weight of these rows fades below the first irregular frequency).

Time factor exp(-i omega t), unit-velocity potentials, outward normals; modes sway,
heave, and roll about a given point, right-handed about x (y to port, z up)::

    force_jk = -rho omega^2 int phi_k n_j dl = omega^2 A_jk + i omega B_jk

Limits: A remains finite as omega -> 0 for modes that displace no water and grows as
-ln(omega) for heave; omega = infinity has phi = 0 on the surface.

.. [Schenck1968] H. A. Schenck, "Improved integral formulation for acoustic radiation
    problems", J. Acoust. Soc. Am. 44, 41-58, 1968.
"""

from dataclasses import dataclass

import numpy as np

from workbench.hydrodynamics.section_green_function import Segments, influence

SECTION_MODES = ("sway", "heave", "roll")
EVEN = np.array([False, True, False])
"""Which modes are even in y when the water on both sides of y = 0 moves as a mirror image."""
INSIDE = np.array([-0.78, -0.43, 0.06, 0.39, 0.81])
INSIDE_HALF = np.array([0.17, 0.52, 0.83])
"""Interior points over the waterline of a contour, and of half a contour from its middle."""
LARGEST_BATCH = 1_500_000


@dataclass(frozen=True, eq=False)
class SectionStack:
    """Panelled sections of equal numbers of panels, solved together.

    Parameters
    ----------
    segments : nodes (sections, nodes); only the side y > 0 (or half a contour) when ``mirrored``.
    interior : (sections, points) y of points on the interior waterlines [m].
    half_beam : (sections, points) half the waterline beam there [m]; 0 where there is no interior.
    mirrored : whether the image in y = 0 belongs to the body too.
    """

    segments: Segments
    interior: np.ndarray
    half_beam: np.ndarray
    mirrored: bool

    @property
    def middles(self) -> tuple[np.ndarray, np.ndarray]:
        """Middles of the panels, y and z (sections, panels) [m]."""
        first, last = self.segments.first, self.segments.last
        return tuple((part[:, first] + part[:, last]) / 2 for part in (self.segments.y, self.segments.z))

    @property
    def normals(self) -> tuple[np.ndarray, np.ndarray]:
        """Outward normals, n_y and n_z (sections, panels)."""
        along_y, along_z = self.segments.along()
        return along_z / self.lengths, -along_y / self.lengths

    @property
    def lengths(self) -> np.ndarray:
        """Lengths of the panels (sections, panels) [m]."""
        return np.hypot(*self.segments.along())

    def unfolded(self, even: np.ndarray, odd: np.ndarray) -> np.ndarray:
        """Values (..., panels), the sum of an even and an odd part, and those on the image side after them."""
        return np.concatenate([even + odd, even - odd], axis=-1) if self.mirrored else even + odd


@dataclass(frozen=True, eq=False)
class WettedPanels:
    """All panels of the sections, images included: arrays (sections, panels) [m, -]."""

    y: np.ndarray
    z: np.ndarray
    normal_y: np.ndarray
    normal_z: np.ndarray
    length: np.ndarray

    def modes(self) -> np.ndarray:
        """Normal velocity of unit sway, heave and roll about the origin (sections, 3, panels)."""
        roll = self.y * self.normal_z - self.z * self.normal_y
        return np.stack([self.normal_y, self.normal_z, roll], axis=1)


def stack(contours, mirrored: bool = False, half: tuple[bool, ...] | None = None) -> SectionStack:
    """Sections from one or several contours each.

    Parameters
    ----------
    contours : sequence of arrays (sections, points, 2) of (y, z) [m], each from its starboard
        waterline round the keel to port, or closed under water (first point = last).
    mirrored : whether the image in y = 0 belongs to the body.
    half : for each contour whether it is the port half of a contour that begins on y = 0.
    """
    half = half or (False,) * len(contours)
    first, last, inside, beams, start = [], [], [], [], 0
    for contour, is_half in zip(contours, half, strict=True):
        count = contour.shape[1]
        first.append(start + np.arange(count - 1))
        last.append(start + np.arange(1, count))
        start += count
        low = np.zeros(len(contour)) if is_half else contour[:, 0, 0]
        high = contour[:, -1, 0]
        middle, reach = (low + high) / 2, (high - low) / 2
        shares = 2 * INSIDE_HALF - 1 if is_half else INSIDE
        inside.append(middle[:, None] + shares * reach[:, None])
        at_surface = contour[:, -1, 1] >= -1e-9 * np.abs(contour).max()
        beam = reach * (2.0 if is_half else 1.0) * at_surface
        beams.append(np.repeat(beam[:, None], len(shares), axis=1))
    nodes = np.concatenate(contours, axis=1)
    segments = Segments(nodes[..., 0], nodes[..., 1], np.concatenate(first), np.concatenate(last))
    return SectionStack(segments, np.concatenate(inside, axis=1), np.concatenate(beams, axis=1), mirrored)


def wetted_panels(sections: SectionStack) -> WettedPanels:
    """Panels with their images."""
    (y, z), (normal_y, normal_z) = sections.middles, sections.normals
    none = np.zeros_like(y)
    return WettedPanels(
        y=sections.unfolded(none, y),
        z=sections.unfolded(z, none),
        normal_y=sections.unfolded(none, normal_y),
        normal_z=sections.unfolded(normal_z, none),
        length=sections.unfolded(sections.lengths, none),
    )


def radiation_potentials(sections: SectionStack, wavenumber: np.ndarray) -> np.ndarray:
    """Potentials of unit sway, heave and roll about the origin on all panels.

    Parameters
    ----------
    wavenumber : omega**2/g (frequencies,) [rad/m]; above 0, infinity allowed.

    Returns
    -------
    (frequencies, sections, 3, panels) complex [m, m, m2].
    """
    return potentials(sections, wavenumber, *mode_velocities(sections))


def mode_velocities(sections: SectionStack) -> tuple[np.ndarray, np.ndarray]:
    """Normal velocity of unit sway, heave and roll, even and odd part (sections, panels, 3)."""
    (y, z), (normal_y, normal_z) = sections.middles, sections.normals
    modes = np.stack([normal_y, normal_z, y * normal_z - z * normal_y], axis=-1)
    return modes * EVEN, modes * ~EVEN


def potentials(
    sections: SectionStack, wavenumber: np.ndarray, even: np.ndarray, odd: np.ndarray
) -> np.ndarray:
    """Potentials of given normal velocities, on all panels.

    Parameters
    ----------
    even, odd : parts (sections, panels, modes) of the normal velocity on the panels that are even
        and odd in y, or one such array for each frequency; without mirror their sum counts.

    Returns
    -------
    (frequencies, sections, modes, panels) complex.
    """
    wavenumber = np.asarray(wavenumber, float)
    panels = len(sections.segments.first)
    points = panels + sections.interior.shape[1]
    per_frequency = len(sections.interior) * points * sections.segments.y.shape[1]
    batch = max(1, LARGEST_BATCH // per_frequency)
    found = []
    for start in range(0, len(wavenumber), batch):
        chosen = slice(start, start + batch)
        parts = (part[chosen] if part.ndim == 4 else part for part in (even, odd))
        found.append(_potentials(sections, wavenumber[chosen], *parts))
    return np.concatenate(found)


def _potentials(sections, wavenumber, even, odd) -> np.ndarray:
    """Return `potentials` of one batch of frequencies."""
    panels = len(sections.segments.first)
    y, z = sections.middles
    y = np.concatenate([y, sections.interior], axis=1)
    z = np.concatenate([z, np.zeros_like(sections.interior)], axis=1)
    reduced = np.where(np.isfinite(wavenumber), wavenumber, 0.0)[:, None, None] * sections.half_beam
    weight = np.broadcast_to(1.0, (len(wavenumber), *y.shape)).copy()
    weight[..., panels:] = reduced**2 / (1 + reduced**2)
    if not sections.mirrored:
        sources, normals = influence(sections.segments, even + odd, wavenumber, y, z)
        return np.swapaxes(_least_squares(normals, sources, weight), -1, -2)
    count = even.shape[-1]
    both = np.concatenate([even, odd], axis=-1)
    near_sources, near = influence(sections.segments, both, wavenumber, y, z)
    far_sources, far = influence(sections.segments, both, wavenumber, -y, z)
    even_part = _least_squares(near + far, (near_sources + far_sources)[..., :count], weight)
    odd_part = _least_squares(near - far, (near_sources - far_sources)[..., count:], weight)
    return sections.unfolded(np.swapaxes(even_part, -1, -2), np.swapaxes(odd_part, -1, -2))


def _least_squares(normals: np.ndarray, sources: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Solve (pi on panels, 0 inside) phi + normals phi = sources, rows weighted: (..., panels, modes)."""
    panels = normals.shape[-1]
    diagonal = np.arange(panels)
    matrix = normals.copy()
    matrix[..., diagonal, diagonal] += np.pi
    matrix *= weight[..., None]
    adjoint = np.conj(np.swapaxes(matrix, -1, -2))
    return np.linalg.solve(adjoint @ matrix, adjoint @ (sources * weight[..., None]))


def sectional_matrix(panels: WettedPanels, potential: np.ndarray) -> np.ndarray:
    """Integral of -phi_k n_j over each section, (frequencies, sections, 3 j, 3 k).

    Its real part times the density is the added mass per length, its imaginary part
    times density and omega the damping per length.
    """
    modes = panels.modes() * panels.length[:, None, :]
    return -np.swapaxes(potential @ np.swapaxes(modes, -1, -2), -1, -2)


def far_field_amplitude(panels: WettedPanels, potential: np.ndarray, wavenumber: np.ndarray) -> np.ndarray:
    """Amplitude of the potential of the outgoing waves to port and starboard (2, frequencies, sections, 3).

    The damping per length is rho omega / 2 times the sum of its squares.
    """
    k = np.asarray(wavenumber, float)[:, None, None, None]
    y, z = panels.y[:, None, :], panels.z[:, None, :]
    found = []
    for side in (1, -1):
        wave = np.exp(k * (z - 1j * side * y))
        slope = k * (panels.normal_z - 1j * side * panels.normal_y)[:, None, :] * wave
        found.append(((panels.modes() * wave - potential * slope) * panels.length[:, None, :]).sum(axis=-1))
    return np.array(found)


def field_potentials(
    sections: SectionStack,
    wavenumber: np.ndarray,
    even: np.ndarray,
    odd: np.ndarray,
    potential: np.ndarray,
    y: np.ndarray,
    z: np.ndarray,
) -> np.ndarray:
    """Potentials at points of the water, from those on the panels.

    Parameters
    ----------
    even, odd : normal velocities as for `potentials`; potential : its result.
    y, z : (sections, points) [m], in the water or on its surface.

    Returns
    -------
    (frequencies, sections, points, modes) complex.
    """
    segments, panels = sections.segments, len(sections.segments.first)
    sources, normals = influence(segments, even + odd, wavenumber, y, z)
    found = sources - normals @ np.swapaxes(potential[..., :panels], -1, -2)
    if sections.mirrored:
        sources, normals = influence(segments, even - odd, wavenumber, -y, z)
        found += sources - normals @ np.swapaxes(potential[..., panels:], -1, -2)
    return found / (2 * np.pi)
