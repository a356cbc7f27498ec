"""The water of one cross-plane that a hull passes through: sources on the contour, and a linear free surface.

In the high-speed theory each cross-plane is a two-dimensional problem that
starts at rest when the bow arrives. With ``Phi`` the potential on still water
and ``Z`` the elevation, both times exp(i omega_e s) with s the time since the
bow passed::

    dPhi/ds = -g Z        dZ/ds = Phi_z

The potential is split: one part carries the values of ``Phi`` on the water and
continues them harmonically downwards (a Fourier series across), the other
vanishes on the water (sources on the contour, with images of opposite sign above
it) and meets the body condition. Inside a hull, where there is no water surface,
the values are interpolated: they have no effect outside but through the split.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from workbench.conventions import GRAVITY
from workbench.hydrodynamics.marched_contour import Contour, section_weights

BEACH_SHARE = 0.3
"""Share of the cross-plane, at its outer edge, that absorbs waves [-]."""
TOUCH = 0.02
"""A point of the water this near to a hull, over the spacing, counts as covered: sources are singular there [-]."""


@dataclass(frozen=True, eq=False)
class Water:
    """Grid of the water surface of a cross-plane, and the harmonic continuation of values on it.

    Parameters
    ----------
    half_width : of the cross-plane [m]; spacing : wished distance of grid points [m].
    parity : 1 for motions even in y and -1 for odd ones, on the half y >= 0; 0 for the whole plane.
    """

    half_width: float
    spacing: float
    parity: int

    @cached_property
    def y(self) -> np.ndarray:
        """Grid points (n,) [m]."""
        count = max(int(np.ceil(self.half_width / self.spacing)), 8)
        if self.parity:
            return self.half_width / count * np.arange(count + 1)
        return self.half_width / count * np.arange(-count, count)

    @cached_property
    def _series(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return wavenumbers (m,), whether each term is a sine, and the (m, n) matrix from values to terms."""
        n = len(self.y) - 1 if self.parity else len(self.y) // 2
        k = np.pi / self.half_width * np.arange(n + 1)
        if self.parity > 0:
            wavenumbers, sine = k, np.zeros(n + 1, bool)
        elif self.parity < 0:
            wavenumbers, sine = k[1:n], np.ones(n - 1, bool)
        else:
            wavenumbers = np.concatenate([k, k[1:n]])
            sine = np.concatenate([np.zeros(n + 1, bool), np.ones(n - 1, bool)])
        basis = np.where(sine, np.sin(self.y[:, None] * wavenumbers), np.cos(self.y[:, None] * wavenumbers))
        weights = np.ones(len(self.y))
        if self.parity:
            weights[[0, -1]] = 0.5
        matrix = (basis * weights[:, None]).T
        return wavenumbers, sine, matrix / np.sum(matrix.T * basis, axis=0)[:, None]

    @cached_property
    def vertical_velocity(self) -> np.ndarray:
        """Matrix (n, n) from values on the water to the vertical velocity of their continuation there."""
        k, sine, terms = self._series
        basis = np.where(sine, np.sin(self.y[:, None] * k), np.cos(self.y[:, None] * k))
        return (basis * k) @ terms

    def continuation(self, points: np.ndarray, normals: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Matrices (p, n) from values on the water to potential and normal velocity at points below it."""
        k, sine, terms = self._series
        decay = np.exp(k * points.imag[:, None])
        cosine, sines = np.cos(k * points.real[:, None]), np.sin(k * points.real[:, None])
        shape, across = np.where(sine, sines, cosine), np.where(sine, cosine, -sines)
        normal = decay * k * (normals.real[:, None] * across + normals.imag[:, None] * shape)
        return (decay * shape) @ terms, normal @ terms

    def absorption(self, time_step: float) -> np.ndarray:
        """Factor (n, 1) by which waves fade per step on the beach."""
        inner = (1 - BEACH_SHARE) * self.half_width
        share = np.clip((np.abs(self.y) - inner) / (self.half_width - inner), 0.0, 1.0)
        rate = 8.0 * np.sqrt(GRAVITY / self.half_width)
        return np.exp(-rate * share**2 * time_step)[:, None]


@dataclass(frozen=True, eq=False)
class Passage:
    """What a cross-plane saw while the hulls passed.

    Parameters
    ----------
    section_potential : (stations, families, 3, columns) integrals of potential times n2, n3 and n4.
    elevation : (stations, points, columns) of the water at the wanted points.
    """

    section_potential: np.ndarray
    elevation: np.ndarray


def passage(
    contours: Sequence[Contour | None],
    time_step: float,
    water: Water,
    normal_velocity: Callable[[int, Contour], np.ndarray],
    columns: int,
    families: int = 1,
    field_y: np.ndarray | None = None,
) -> Passage:
    """March through the stations, bow first.

    Parameters
    ----------
    contours : of each station, evenly spaced in time; None where no hull is wet.
    time_step : between stations [s].
    normal_velocity : gives, for station number and contour, the wanted normal velocity (m, columns) of
        the water at the panels, real or complex.
    columns : number of independent problems; families : of hulls.
    field_y : points at which the elevation is wanted [m].

    Notes
    -----
    Staggered leapfrog; stable while time_step sqrt(pi g / spacing) < 2. Costs some 2 ms per station
    and then grows with the columns, all of which share the matrices.
    """
    points = len(water.y)
    values = np.zeros((points, columns), complex)
    elevation = np.zeros_like(values)
    fading = water.absorption(time_step)
    field_y = np.zeros(0) if field_y is None else np.asarray(field_y, float)
    reading = _reading(water, field_y)
    potentials = np.zeros((len(contours), families, 3, columns), complex)
    field = np.zeros((len(contours), len(field_y), columns), complex)
    for number, contour in enumerate(contours):
        rate = _times(water.vertical_velocity, values)
        if contour is not None:
            wet = ~np.any([_covered(water, sides) for sides in contour.waterlines], axis=0)
            own, velocity = contour.influence(contour.centres, water.parity, on_panels=True)
            normals = contour.normals
            below, below_normal = water.continuation(contour.centres, normals)
            wanted = normal_velocity(number, contour) - _times(below_normal, values)
            strength = _times(np.linalg.inv((velocity * normals[:, None]).real), wanted)
            potential = _times(own, strength) + _times(below, values)
            weights = section_weights(contour)
            for family in range(families):
                potentials[number, family] = _times(weights * (contour.family == family), potential)
            _, at_surface = contour.influence(water.y[wet] + 0j, water.parity, on_panels=False)
            rate[wet] += _times(-at_surface.imag, strength)
        before = elevation
        elevation = (elevation + (0.5 if number == 0 else 1.0) * time_step * rate) * fading
        values = (values - GRAVITY * time_step * elevation) * fading
        if contour is not None:
            for sides in contour.waterlines:
                _bridge(water, sides, values)
                _bridge(water, sides, elevation)
        field[number] = _times(reading, (before + elevation) / 2)
    if water.parity:
        potentials *= 2.0
        potentials[:, :, [0, 2] if water.parity > 0 else [1]] = 0.0
    return Passage(potentials, field)


def _times(matrix: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Return the product of a real matrix with complex columns, without making the matrix complex."""
    columns = np.ascontiguousarray(columns, complex)
    return (matrix @ columns.view(float)).view(complex)


def _covered(water: Water, sides: tuple[float, float]) -> np.ndarray:
    """Return which points of the water are inside a hull or touch it; half a hull covers the centreline too."""
    touch = TOUCH * (water.y[1] - water.y[0])
    half = water.parity and sides[0] <= 0.0
    return (water.y < sides[1] + touch) & (half or water.y > sides[0] - touch)


def _bridge(water: Water, sides: tuple[float, float], values: np.ndarray) -> None:
    """Interpolate values across a hull from its waterline, in place.

    Those at the waterline are the nearest wet ones carried on by half their slope: with the whole slope or none,
    the error of a half circle whose beam is 12 to 40 spacings is two to four times as large.
    """
    covered = np.flatnonzero(_covered(water, sides))
    if not covered.size:
        return
    y, low, high = water.y, covered[0] - 1, covered[-1] + 1
    port = values[high] + (sides[1] - y[high]) * (values[high + 1] - values[high]) / (y[1] - y[0]) / 2
    if low < 0:  # half a hull on the centreline
        left, starboard = -sides[1], water.parity * port
    else:
        before = max(low - 1, 0)
        left, starboard = (
            sides[0],
            values[low] + (sides[0] - y[low]) * (values[low] - values[before]) / (y[1] - y[0]) / 2,
        )
    width = max(sides[1] - left, 1e-9 * y[-1])
    share = np.clip((y[covered] - left) / width, 0.0, 1.0)[:, None]
    values[covered] = (1 - share) * starboard + share * port


def _reading(water: Water, field_y: np.ndarray) -> np.ndarray:
    """Return the matrix (points, n) that interpolates values of the grid."""
    sign = np.where(field_y < 0, float(water.parity), 1.0) if water.parity else np.ones(len(field_y))
    at = np.abs(field_y) if water.parity else field_y
    unit = np.eye(len(water.y))
    found = (
        np.stack([np.interp(at, water.y, row) for row in unit], axis=1)
        if len(at)
        else np.zeros((0, len(unit)))
    )
    return sign[:, None] * found
