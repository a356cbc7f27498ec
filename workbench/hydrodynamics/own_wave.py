"""The ship's own steady wave at high speed, and the sinkage and trim that it gives her, by the march from the bow.

The steady part of the high-speed theory: no time factor, the water starts at rest at the bow and
each section pushes it aside as it widens, at the rate ``U d(contour)/ds``. Waves that run with
the ship, which make the humps of resistance at Fn 0.3 to 0.5, are not in it.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import GRAVITY
from workbench.design import Hull, MassProperties
from workbench.errors import checked_number
from workbench.geometry.hydrostatics import longitudinal_stiffness_about, stiffness_matrix
from workbench.hydrodynamics.cross_plane import Water, passage
from workbench.hydrodynamics.high_speed_forces import ends, lengthwise
from workbench.hydrodynamics.high_speed_hulls import Problem, Stations, all_together, hull_alone, stationed
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings, check_speed
from workbench.hydrodynamics.marched_contour import Contour

LEAST_FROUDE_NUMBER = 0.5
"""Below this the waves that run with the ship are too large a part of her own wave [-]."""


def own_wave(
    hull: Hull,
    masses: MassProperties,
    density: float,
    speed: float,
    field_x: Sequence[float],
    field_y: Sequence[float],
    settings: HighSpeedSettings | None = None,
) -> xr.Dataset:
    """Steady elevation [m] at points of the water, and the running sinkage [m] and trim [rad] it leads to.

    Parameters
    ----------
    hull : in its attitude at rest; masses : give the centre of gravity; density : [kg/m3]; speed : [m/s].
    field_x, field_y : grid of points [m]; over a hull the water beside it is meant.
    settings : stations and panels; hulls share the water unless interaction is off.

    Returns
    -------
    Dataset over (x, y): ``steady_elevation``; ``running_sinkage`` of the centre of gravity, positive down,
    ``running_trim``, positive bow down; warnings.

    Notes
    -----
    Linear; fair from Fn 0.5 up. The trim of the Delft 372 comes out at 1.4 degrees by the stern at Fn 0.75
    (measured 1.35), her sinkage within 2 mm; at Fn 0.30 her trim is 0.7 degrees too far by the stern. The
    hull in its running attitude *and* her own wave together lie close to the waterline at rest (within a
    tenth of the draught amidships at Fn 0.75): motions are best computed with both or with neither.
    """
    settings = settings or HighSpeedSettings()
    checked_number("speed", speed, "m/s", at_least=0, at_most=60)
    check_speed(speed, hull.length)
    stations = stationed(hull, int(settings.stations), settings.panels)
    field_x, field_y = np.asarray(field_x, float), np.asarray(field_y, float)
    together = len(stations.hulls) > 1 and settings.interaction != "off"
    problems = (
        [(all_together(stations), field_y)]
        if together
        else [
            (hull_alone(stations, numbers[0]), field_y - stations.hulls[number].y)
            for numbers in stations.families
            for number in numbers
        ]
    )
    elevation = np.zeros((len(stations.x), len(field_y)))
    force = np.zeros(6)
    for number, (problem, beside) in enumerate(problems):
        found = _march(
            problem, stations, speed, beside, hull.length + (hull.spacing / 2 if together else 0.0)
        )
        elevation += found.elevation[..., 0].real
        for family in range(problem.families):
            own = stations.families[family][0] if together else number
            end = ends(stations, stations.hulls[own], speed, released=False)
            values = found.section_potential[:, family]
            force += density * lengthwise(values, stations, end, np.zeros(1), speed)[:, 0].real
    elevation_there = np.stack(
        [np.interp(field_x, stations.x[::-1], row[::-1], left=0.0, right=0.0) for row in elevation.T], axis=1
    )
    rise, trim = _attitude(force, hull, masses, density)
    froude = speed / np.sqrt(GRAVITY * hull.length)
    notes = []
    if froude < LEAST_FROUDE_NUMBER:
        notes.append(
            f"Fn {froude:.2f} is below {LEAST_FROUDE_NUMBER}: the waves that run with the ship, which the march "
            "leaves out, are a large part of her own wave there."
        )
    return quantities.dataset(
        {"x": field_x, "y": field_y},
        method="high-speed",
        warnings=notes,
        attrs={"speed": float(speed), "density": float(density)},
        steady_elevation=(("x", "y"), elevation_there),
        running_sinkage=((), -rise),
        running_trim=((), trim),
    )


def _march(problem: Problem, stations: Stations, speed: float, field_y: np.ndarray, half_width: float):
    """Return the steady passage of one problem; only what is even in y is steady."""
    step = stations.spacing / speed
    contours = problem.contours

    def widening(number: int, contour: Contour) -> np.ndarray:
        before, after = contours[max(number - 1, 0)], contours[min(number + 1, len(contours) - 1)]
        before = before if _alike(before, contour) else contour
        after = after if _alike(after, contour) else contour
        steps = (number > 0 and before is not contour) + (after is not contour)
        if not steps:
            return np.zeros((len(contour.starts), 1))
        rate = (after.centres - before.centres) / (steps * step)
        return (rate * np.conj(contour.normals)).real[:, None]

    parity = 1 if 1 in problem.parities else 0
    water = Water(half_width, half_width / max(round(150 * half_width / _length(stations)), 8), parity)
    return passage(contours, step, water, widening, 1, problem.families, field_y)


def _alike(one: Contour | None, other: Contour) -> bool:
    """Return whether two contours have the same panels."""
    return one is not None and one is not other and len(one.starts) == len(other.starts)


def _length(stations: Stations) -> float:
    return float(stations.bow - stations.x[-1])


def _attitude(force: np.ndarray, hull: Hull, masses: MassProperties, density: float) -> tuple[float, float]:
    """Return rise of the centre of gravity [m] and trim [rad] under a steady vertical force and pitch moment."""
    centre_x = masses.centre_of_gravity[0]
    matrix = longitudinal_stiffness_about(stiffness_matrix(hull, masses, density), centre_x)
    moment = force[4] + centre_x * force[2]
    rise, trim = np.linalg.solve(np.asarray(matrix), [force[2], moment])
    return float(rise), float(trim)
