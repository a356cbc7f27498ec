"""Two-dimensional source under a free surface in deep water, integrated exactly over straight panels.

With exp(-i omega t), K = omega**2/g, outgoing waves, and a source at (eta, zeta)
([Wehausen1960]_ section 13, conjugated)::

    G = ln r - ln r' - 2 Re(exp(t) E1(t)) - 2 pi i exp(t),   t = K ((z + zeta) + i |y - eta|)

r' is the distance from the image above the surface, E1 the exponential integral
(principal value). Of the wave part only F(t) = exp(t) E1(t) at the ends of the panels is
needed, because F' = F - 1/t: its integrals along a panel are differences of F and of ln t.
That is the close-fit idea of [Frank1967]_, here for Green's identity.

F is read from a table of Taylor series in ln t over the left half plane, good to 1e-7.

.. [Wehausen1960] J. V. Wehausen and E. V. Laitone, "Surface waves", Handbuch der Physik 9,
    446-778, Springer, 1960.
.. [Frank1967] W. Frank, "Oscillation of cylinders in or below the free surface of deep
    fluids", NSRDC report 2375, 1967.
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.special import exp1

STEP = 0.1
LOWEST, HIGHEST = np.log(1e-3), np.log(1e3)
ORDER = 5
EULER = float(np.euler_gamma)


@cache
def _table() -> tuple[np.ndarray, ...]:
    """Taylor coefficients of F(exp(L)) about nodes L = LOWEST + i pi/2 + STEP (j + i l), flattened."""
    real = np.arange(LOWEST, HIGHEST + STEP, STEP)
    nodes = real[:, None] + 1j * (np.pi / 2 + STEP * np.arange(_angles()))
    turns = np.exp(2j * np.pi * np.arange(16) / 16)
    radius = 0.1
    t = np.exp(nodes[..., None] + radius * turns)
    beyond = np.imag(nodes[..., None] + radius * turns) > np.pi  # continued across the cut of E1
    far = t.real < -600.0  # exp would underflow and E1 overflow
    near = np.where(far, -1.0, t)
    values = np.exp(near) * (exp1(near) - 2j * np.pi * beyond)
    values = np.where(far, (1 - 1 / t + 2 / t**2 - 6 / t**3) / t, values)
    series = np.fft.fft(values, axis=-1) / 16
    return tuple(np.ascontiguousarray(series[..., n].ravel() / radius**n) for n in range(ORDER + 1))


def _angles() -> int:
    return int(np.ceil(np.pi / 2 / STEP)) + 1


def wave_integral(log_t: np.ndarray) -> np.ndarray:
    """F = exp(t) E1(t) for ln t with imaginary part pi/2 to pi."""
    table = _table()
    real = np.clip(log_t.real, LOWEST, HIGHEST)
    j = np.rint((real - LOWEST) / STEP).astype(np.intp)
    angle = np.rint((log_t.imag - np.pi / 2) / STEP).astype(np.intp)
    step = np.empty_like(log_t)
    step.real = real - (LOWEST + STEP * j)
    step.imag = log_t.imag - (np.pi / 2 + STEP * angle)
    index = j * _angles() + angle
    found = table[ORDER][index]
    for n in range(ORDER - 1, -1, -1):
        found *= step
        found += table[n][index]
    small, large = log_t.real < LOWEST, log_t.real > HIGHEST
    if small.any():
        t = np.exp(log_t[small])
        found[small] = np.exp(t) * (t - t**2 / 4 + t**3 / 18 - EULER - log_t[small])
    if large.any():
        t = np.exp(np.where(large, log_t, 0.0)[large])
        found[large] = (1 - 1 / t + 2 / t**2) / t
    return found


class Segments(NamedTuple):
    """Straight panels of a stack of sections, between nodes that neighbours share.

    y, z : (sections, nodes) [m]; first, last : (panels,) node numbers, the water on the
    right of the way from first to last; a node ends one panel and starts one at most.
    """

    y: np.ndarray
    z: np.ndarray
    first: np.ndarray
    last: np.ndarray

    def along(self) -> tuple[np.ndarray, np.ndarray]:
        """Vectors (y, z) from first to last node, each (sections, panels) [m]."""
        return self.y[:, self.last] - self.y[:, self.first], self.z[:, self.last] - self.z[:, self.first]


def rankine(segments: Segments, y: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Integrals of ln r and of its derivative along the outward normal of the panels.

    Parameters
    ----------
    y, z : (sections, points) [m].

    Returns
    -------
    Two arrays (sections, points, panels); a panel's own derivative is 0 at its middle.
    """
    along = np.asarray(segments.along())
    length = np.hypot(*along)
    turn = ((along[0] - 1j * along[1]) / length)[:, None, :]
    points = (y + 1j * z)[:, :, None]
    nodes = segments.y + 1j * segments.z
    start = (points - nodes[:, None, segments.first]) * turn
    end = (points - nodes[:, None, segments.last]) * turn
    start, end = _off_corners(start), _off_corners(end)
    log_start, log_end = np.log(start), np.log(end)
    single = (start * (log_start - 1) - end * (log_end - 1)).real
    double = log_end.imag - log_start.imag
    own = np.abs(start.imag) < 1e-9 * length[:, None, :]
    return single, np.where(own, 0.0, double)


def _off_corners(offset: np.ndarray) -> np.ndarray:
    return np.where(np.abs(offset) < 1e-14, 1e-14, offset)


def influence(
    segments: Segments, charges: np.ndarray, wavenumber: np.ndarray, y: np.ndarray, z: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Integrals of G times given strengths, and of the normal derivative of G, over the panels.

    Parameters
    ----------
    charges : (sections, panels, modes), or one such array for each frequency; constant on each panel.
    wavenumber : (frequencies,) [rad/m]; infinity allowed (no surface potential).
    y, z : (sections, points) [m].

    Returns
    -------
    (frequencies, sections, points, modes) and (frequencies, sections, points, panels), complex.
    """
    single, double = rankine(segments, y, z)
    image_single, image_double = rankine(segments, y, -z)
    rigid_single = (single - image_single) @ charges
    rigid_double = double - image_double
    shape = (len(wavenumber), *y.shape)
    sources = np.empty((*shape, charges.shape[-1]), complex)
    normals = np.empty((*shape, len(segments.first)), complex)
    finite = np.isfinite(wavenumber)
    sources[:], normals[:] = rigid_single, rigid_double
    if finite.any():
        wave_sources, wave_normals = _wave_part(segments, charges, wavenumber[finite], y, z)
        sources[finite] += wave_sources
        normals[finite] += wave_normals
    return sources, normals


def _wave_part(segments, charges, wavenumber, y, z) -> tuple[np.ndarray, np.ndarray]:
    """Return the two integrals of `influence` for the wave part of G at finite wavenumbers."""
    across = y[:, :, None] - segments.y[:, None, :]
    side = np.where(across >= 0, 1.0, -1.0)
    rise = np.minimum(z[:, :, None] + segments.z[:, None, :], 0.0)
    w = rise + 1j * np.abs(across)
    w = np.where(np.abs(w) < 1e-14, -1e-14, w)
    log_image = np.log(-np.conj(w))  # angle 0 to pi/2; ln(-w) is its conjugate
    log_w = np.conj(log_image) + 1j * np.pi
    k = wavenumber[:, None, None, None]
    f = wave_integral(log_w[None] + np.log(k))
    e = np.exp(k * w)

    along = np.asarray(segments.along())
    turn = np.hypot(*along) / (along[1] - 1j * along[0])  # panel length over its step in w
    upright, level = (_at_ends(segments, 2 * charges * part[..., None]) for part in (turn.real, turn.imag))

    even = np.pi * 1j * e
    even.real += f.real + log_image.real
    odd = np.pi * e
    odd.real += f.imag
    odd *= side
    sources = even @ upright - (odd - side * log_image.imag) @ level
    normals = -2 * (odd[..., segments.last] - odd[..., segments.first])
    return -sources / k, normals


def _at_ends(segments: Segments, values: np.ndarray) -> np.ndarray:
    """Values of panels (..., panels, modes) at their last nodes less those at their first (..., nodes, modes)."""
    ends = np.zeros((*values.shape[:-2], segments.y.shape[1], values.shape[-1]), values.dtype)
    ends[..., segments.last, :] += values
    ends[..., segments.first, :] -= values
    return ends
