"""Drag of the flow across the hulls, linearised for waves of one amplitude.

[Thwaites1960] B. Thwaites (ed.), "Incompressible aerodynamics", Oxford University Press, 1960: force across a
    slender body as the sum of a part linear and a part quadratic in the flow across it.
[LeeCurphey1977] C. M. Lee and R. M. Curphey, "Prediction of motion, stability, and wave load of
    small-waterplane-area, twin-hull ships", Trans. SNAME 85, 94-130, 1977: the same for the motions of twin hulls.
[Faltinsen1990] O. M. Faltinsen, "Sea loads on ships and offshore structures", Cambridge University Press,
    1990: cross-flow principle, equivalent linearisation.
[Hoerner1965] S. F. Hoerner, "Fluid-dynamic drag", 1965, chapter 3: drag of sections.
"""

from dataclasses import dataclass

import numpy as np

from workbench.damping.normal_flow import turning_rows, velocity_rows, wave_velocity
from workbench.design import Hull
from workbench.errors import checked_number
from workbench.geometry.sections import sections

LINEARISED = 8.0 / (3.0 * np.pi)
"""Share of |q| q that is linear in q, of the amplitude of q: equal work over a cycle [Faltinsen1990]_."""

FLAT_PLATE, CIRCULAR_CYLINDER = 1.98, 1.17
"""Drag coefficients of a plate, and of a circular cylinder below its critical Reynolds number [Hoerner1965]_."""


@dataclass(frozen=True, eq=False)
class CrossFlow:
    """Pieces of hull that water flows across.

    Parameters
    ----------
    points, normals : (n, 3) [m], [-].
    strengths : rho C_D a / 2 (n,) [kg/m]; the force on a piece is -strength |q| q along its normal.
    """

    points: np.ndarray
    normals: np.ndarray
    strengths: np.ndarray

    @property
    def velocity_rows(self) -> np.ndarray:
        """Flow across the pieces for unit velocities of the ship, (n, 6)."""
        return velocity_rows(self.points, self.normals)

    @property
    def turning_rows(self) -> np.ndarray:
        """Flow across the pieces for unit motions of the ship in a stream of unit speed, (n, 6)."""
        return turning_rows(self.normals)

    def wave_velocity(self, omega, wave_directions) -> np.ndarray:
        """Flow across the pieces by waves of unit amplitude, (omega, wave_direction, n) [1/s]."""
        return wave_velocity(self.points, self.normals, omega, wave_directions)


def cross_flow(
    hull: Hull,
    density: float,
    vertical_drag: float,
    lateral_drag: float = 0.0,
    stations: int = 21,
) -> CrossFlow:
    """Pieces of the hulls that water flows across, vertically and sideways, section by section.

    Parameters
    ----------
    vertical_drag : coefficient on the greatest breadth of a section, for heave, pitch, and roll of
        hulls beside the centreline [-]: 1.98 for a plate, 1.17 for a circular cylinder at low
        Reynolds number [Hoerner1965]_; a rounded or pointed section has less. There is no usual value.
    lateral_drag : coefficient on the draught of a section, for sway, yaw and roll [-].
    stations : sections of each hull.

    Notes
    -----
    Each section stands alone in the flow across it (cross-flow principle), which is taken at its
    middle and at half its depth, the undisturbed wave included. A hull that is out of the water has none.
    """
    checked_number("vertical drag coefficient", vertical_drag, at_least=0.0, at_most=4.0)
    checked_number("lateral drag coefficient", lateral_drag, at_least=0.0, at_most=4.0)
    checked_number("density of the water", density, "kg/m3", above=0.0)
    points, normals, strengths = [], [], []
    for part in sections(hull, stations):
        if len(part.x) == 0:
            continue
        low, high = part.y.min(axis=1), part.y.max(axis=1)
        middle = np.stack([part.x, (low + high) / 2, -part.draughts / 2], axis=1)
        lengths = np.gradient(part.x)
        lengths[[0, -1]] /= 2
        for normal, drag, width in (
            ((0.0, 0.0, 1.0), vertical_drag, high - low),
            ((0.0, 1.0, 0.0), lateral_drag, part.draughts),
        ):
            if drag > 0.0:
                points.append(middle)
                normals.append(np.tile(normal, (len(middle), 1)))
                strengths.append(0.5 * density * drag * width * lengths)
    empty = np.empty((0, 3))
    return CrossFlow(
        np.concatenate(points) if points else empty,
        np.concatenate(normals) if normals else empty,
        np.concatenate(strengths) if strengths else np.empty(0),
    )
