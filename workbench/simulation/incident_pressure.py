"""Pressure of still water and incident waves on a hull that moves in them, up to the instantaneous surface.

At a depth d below the instantaneous surface the wave pressure is that which
linear theory gives at d below still water (the stretching of [Wheeler1970]_), so
that the whole pressure vanishes on the surface::

    p = rho g [d + (zeta_d - zeta)],   zeta_d = sum a_j exp(-k_j d) cos(...)

It is kept as two records a vertex, the elevation zeta and the drop
zeta_D - zeta at the depth D of the vertex at rest (at least half the ship's
depth in the water); between and beyond them the drop goes with 1 - exp(-K d),
which is exact for a regular wave, K being the mean wavenumber.

.. [Wheeler1970] J. D. Wheeler, "Method for calculating forces produced by irregular waves",
    J. Petroleum Technology 22, 359-367, 1970.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench.conventions import GRAVITY, wavenumber
from workbench.simulation.wetted_surface import HullSurface
from workbench.time_domain import complex_amplitudes, elevation_amplitudes

ROTATIONS = slice(3, 6)


def rotation(roll: float, pitch: float, yaw: float) -> np.ndarray:
    """Ship's axes in space (3, 3): roll about x, then pitch about y, then yaw about z."""
    (cr, cp, cy), (sr, sp, sy) = np.cos((roll, pitch, yaw)), np.sin((roll, pitch, yaw))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


@dataclass(frozen=True, eq=False)
class HullInWaves:
    """A hull surface in the waves of one realisation.

    Parameters
    ----------
    surface : with moments about the centre of gravity.
    centre : centre of gravity, in ship axes [m].
    components : of the realisation.
    density : of the water [kg/m3].

    Notes
    -----
    The waves are taken where each vertex is on average: surge, sway and yaw, and
    what roll and pitch move it sideways, do not shift their phase.
    """

    surface: HullSurface
    centre: np.ndarray
    components: xr.Dataset
    density: float

    def __post_init__(self):
        heights = self.surface.vertices[:, 2] + self.centre[2]
        k = wavenumber(self.components.component_omega.values)
        energy = np.abs(complex_amplitudes(self.components)) ** 2
        object.__setattr__(self, "heights", heights)
        object.__setattr__(self, "mean_wavenumber", float(np.sum(energy * k) / np.sum(energy)))
        object.__setattr__(self, "_depths", np.maximum(-heights, -heights.min() / 2))
        object.__setattr__(self, "_scale", 1 / -np.expm1(-self.mean_wavenumber * self._depths))

    def amplitudes(self) -> np.ndarray:
        """Complex amplitudes of elevation, then drop, at every vertex (component, 2 nv) [m]."""
        x, y = self.surface.vertices[:, 0] + self.centre[0], self.surface.vertices[:, 1] + self.centre[1]
        rise = elevation_amplitudes(self.components, x, y)
        k = wavenumber(self.components.component_omega.values)
        return np.concatenate([rise, rise * np.expm1(-np.multiply.outer(k, self._depths))], axis=1)

    def pressure(self, pose: np.ndarray, attitude: np.ndarray, waves: np.ndarray) -> np.ndarray:
        """Pressure at the vertices (nv,) [Pa], negative above the surface.

        Parameters
        ----------
        pose : six motions of the centre of gravity; attitude : their `rotation`.
        waves : (2 nv,) elevation and drop at the vertices at the moment.
        """
        count = len(self.heights)
        depth = waves[:count] - (self.surface.vertices @ attitude[2] + (self.centre[2] + pose[2]))
        share = -np.expm1(-self.mean_wavenumber * np.maximum(depth, 0.0)) * self._scale
        return self.density * GRAVITY * (depth + share * waves[count:])

    def force(self, pose: np.ndarray, waves: np.ndarray) -> np.ndarray:
        """Force and moment of the water about the centre of gravity, (6,), in axes fixed in space.

        Parameters as `pressure`.
        """
        attitude = rotation(*pose[ROTATIONS])
        return self.turned_force(self.pressure(pose, attitude, waves), attitude)

    def turned_force(self, pressure: np.ndarray, attitude: np.ndarray) -> np.ndarray:
        """Force and moment (6,) of pressures at the vertices, turned into axes fixed in space."""
        own = self.surface.pressure_force(pressure)
        return np.concatenate([attitude @ own[:3], attitude @ own[3:]])

    def at_rest(self) -> np.ndarray:
        """Force and moment in still water, (6,): what the weight is taken to balance."""
        return self.force(np.zeros(6), np.zeros(2 * len(self.heights)))

    def stiffness(self) -> np.ndarray:
        """Minus the derivative of `force` by the motions in still water, (6, 6)."""
        still = np.zeros(2 * len(self.heights))
        found = np.zeros((6, 6))
        span = float(np.abs(self.surface.vertices).max())
        for mode, step in enumerate((1e-5 * span,) * 3 + (1e-5,) * 3):
            moved = np.zeros(6)
            moved[mode] = step
            found[:, mode] = -(self.force(moved, still) - self.force(-moved, still)) / (2 * step)
        return found

    def wave_force_amplitudes(self) -> np.ndarray:
        """Derivative of `force` by the waves in still water times their amplitudes, (component, 6).

        The Froude-Krylov force of linear theory on this surface.
        """
        amplitudes, count = self.amplitudes(), len(self.heights)
        share = -np.expm1(-self.mean_wavenumber * np.maximum(-self.heights, 0.0)) * self._scale
        drop = amplitudes[:, :count] + share * amplitudes[:, count:]
        pressure = -self.density * GRAVITY * self.heights
        return self.density * GRAVITY * drop @ self.surface.force_gradient(pressure).T
