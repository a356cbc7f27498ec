"""Waves that the hulls radiate and diffract, by strips: the elevation of the water between and beside them.

Every section gives the potential at points of the surface in its own plane; along the ship these
potentials are what strip theory knows of the wave. With exp(-i omega_e t)::

    eta = (i omega_e + U d/dx) phi / g

where phi is the potential per unit motion (with the m-terms of pitch and yaw) or of the
diffracted wave. Waves that run along the ship are not in it.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench.conventions import GRAVITY, wavenumber
from workbench.design import Hull
from workbench.errors import InputError, checked_number
from workbench.geometry.sections import sections
from workbench.hydrodynamics.section_waves import Waves, arresting_velocity
from workbench.hydrodynamics.sections import (
    SectionStack,
    field_potentials,
    mode_velocities,
    potentials,
)
from workbench.hydrodynamics.strip_forces import at_encounter
from workbench.hydrodynamics.strip_sections import StationGroup, StripBody, strip_bodies
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.hydrodynamics.strip_theory import met_waves, section_frequencies
from workbench.hydrodynamics.wave_fields import elevation_set

FIELD_STATIONS = 21
"""Most stations at which the field is solved."""
CLEAR = 0.02
"""Points over a hull are taken beside it, this share of its waterline beam away."""


def tunnel_grid(hull: Hull, count: tuple[int, int] = (21, 5)) -> tuple[np.ndarray, np.ndarray]:
    """Points x and y [m] between the outer hulls of a ship of several: the whole length, the narrowest gap."""
    if hull.count == 1:
        raise InputError(
            "hull count must be 2 or 3 for waves between hulls, got 1; give field_x and field_y."
        )
    wet = [one for one in sections(hull, FIELD_STATIONS, 21) if one.x.size]
    aft, fore = min(one.x[0] for one in wet), max(one.x[-1] for one in wet)
    port = [one.y.min() for one in wet if one.position[1] > 0]
    starboard = [one.y.max() for one in wet if one.position[1] < 0]
    half = hull.spacing / 2
    low, high = max(starboard, default=-half), min(port, default=half)
    return np.linspace(aft, fore, count[0]), np.linspace(low, high, count[1])


def wave_field(
    hull: Hull,
    omega: Sequence[float],
    wave_directions: Sequence[float],
    speed: float,
    settings: StripSettings | None = None,
    field_x: Sequence[float] | None = None,
    field_y: Sequence[float] | None = None,
) -> xr.Dataset:
    """Radiated and diffracted elevation on a grid of points of the water surface.

    Parameters
    ----------
    hull, omega, wave_directions, speed, settings : as for `strip_theory.hydrodynamics`.
    field_x, field_y : grid [m]; None takes `tunnel_grid`. A point over a hull is taken beside it.

    Returns
    -------
    Dataset with ``radiated_elevation`` (omega, wave_direction, radiating_dof, field_x, field_y)
    per unit motion about the origin, and ``diffracted_elevation`` (omega, wave_direction,
    field_x, field_y) per wave amplitude, without the incident wave; as
    `relative_motion.scattered_elevation` takes them.

    Notes
    -----
    Zero before and behind the hulls, zero radiated by surge. With hulls alone, the waves of each
    pass the other as if it were not there. Near a piston resonance the plane theory
    overstates the elevation.
    """
    settings = StripSettings() if settings is None else settings
    checked_number("speed", speed, "m/s", at_least=0)
    omega = np.array([checked_number("omega", value, "rad/s", above=0) for value in omega])
    directions = np.array([checked_number("wave direction", value, "rad") for value in wave_directions])
    if field_x is None or field_y is None:
        default_x, default_y = tunnel_grid(hull)
        field_x, field_y = (
            default_x if field_x is None else field_x,
            default_y if field_y is None else field_y,
        )
    grid = np.asarray(field_x, float), np.asarray(field_y, float)
    waves = met_waves(omega, directions, speed)
    together = settings.interacts(hull.count, speed, hull.length)
    bodies = strip_bodies(hull, min(settings.stations, FIELD_STATIONS), settings.panels, together)
    nodes = section_frequencies(bodies, waves, settings, together)

    shape = (len(omega), len(directions))
    radiated = np.zeros((len(waves.omega), 6, len(grid[0]), len(grid[1])), complex)
    diffracted = np.zeros((len(waves.omega), len(grid[0]), len(grid[1])), complex)
    for body in bodies:
        own, scattered = _body_field(body, nodes, waves, speed, grid)
        shift = np.eye(6)
        shift[0, 5], shift[2, 3] = -body.y, body.y
        radiated += np.einsum("wjxy,jk->wkxy", own, shift)
        turn = np.exp(1j * wavenumber(waves.omega) * body.y * np.sin(waves.direction))
        diffracted += turn[:, None, None] * scattered
    return elevation_set(
        omega,
        directions,
        *grid,
        radiated=radiated.reshape(*shape, *radiated.shape[1:]),
        diffracted=diffracted.reshape(*shape, *diffracted.shape[1:]),
        speed=speed,
        method="strip",
    )


def _body_field(body: StripBody, nodes, waves: Waves, speed: float, grid) -> tuple[np.ndarray, np.ndarray]:
    """Elevations of one body about its own axes: per unit motion (waves, 6, x, y), diffracted (waves, x, y)."""
    count, width = len(waves.omega), len(grid[1])
    motion = np.zeros((count, 3, len(body.x), width), complex)
    stopped = np.zeros((count, len(body.x), width), complex)
    for group in body.groups:
        y = _beside(group, grid[1] - body.y)
        z = np.zeros_like(y)
        even, odd = mode_velocities(group.sections)
        k = wavenumber(nodes)
        solved = potentials(group.sections, k, even, odd)
        at_nodes = field_potentials(group.sections, k, even, odd, solved, y, z)
        there = at_encounter(nodes, at_nodes, waves.encounter)
        motion[:, :, group.stations] = np.moveaxis(there, -1, 1)
        stopped[:, group.stations] = _diffracted(group.sections, waves, y, z)
    met = waves.encounter[:, None, None]
    unit = -1j * met * np.moveaxis(motion, 1, 0)  # per unit motion of the section: sway, heave, roll
    x = body.x[:, None]
    zero = np.zeros_like(stopped)
    modes = [zero, unit[0], unit[1], unit[2]]
    modes += [-x * unit[1] + speed * motion[:, 1], x * unit[0] - speed * motion[:, 0]]

    def elevation(potential):
        drift = speed * np.gradient(potential, body.x, axis=1) if speed else 0.0
        return _along((1j * met * potential + drift) / GRAVITY, body.x, grid[0])

    phase = (wavenumber(waves.omega) * np.cos(waves.direction))[:, None, None]
    drift = speed * (1j * phase * stopped + (np.gradient(stopped, body.x, axis=1) if speed else 0.0))
    steady = _along((1j * met * stopped + drift) / GRAVITY, body.x, grid[0])
    scattered = steady * np.exp(1j * phase * grid[0][:, None])
    return np.stack([elevation(potential) for potential in modes], axis=1), scattered


def _beside(group: StationGroup, y: np.ndarray) -> np.ndarray:
    """Points y at every station of the group (stations, points), those over a hull moved beside it."""
    found = np.broadcast_to(y, (len(group.stations), len(y))).copy()
    for low, high in _waterlines(group.sections):
        margin = CLEAR * (high - low)[:, None]
        low, high = low[:, None] - margin, high[:, None] + margin
        inside = (found > low) & (found < high)
        nearest = np.where(found < (low + high) / 2, low, high)
        found = np.where(inside, nearest, found)
    return found


def _waterlines(stacked: SectionStack) -> list[tuple[np.ndarray, np.ndarray]]:
    """Ends (stations,) of the interior waterline of every contour, images included."""
    segments = stacked.segments
    begins = np.setdiff1d(segments.first, segments.last)
    ends = np.setdiff1d(segments.last, segments.first)
    found = []
    for first, last in zip(np.sort(begins), np.sort(ends), strict=True):
        low, high = segments.y[:, first], segments.y[:, last]
        is_half = stacked.mirrored and np.allclose(low, 0.0)
        if is_half:
            found.append((-high, high))
        else:
            found.append((low, high))
            if stacked.mirrored:
                found.append((-high, -low))
    return found


def _diffracted(stacked: SectionStack, waves: Waves, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Diffracted potential for waves with a crest at each section (waves, stations, points)."""
    velocity = arresting_velocity(stacked, waves)
    k = wavenumber(waves.encounter)
    backwards = waves.encounter < 0
    if backwards.any():  # the conjugate problem has waves that run out
        velocity = tuple(np.where(backwards[:, None, None, None], part.conj(), part) for part in velocity)
    solved = potentials(stacked, k, *velocity)
    found = field_potentials(stacked, k, *velocity, solved, y, z)[..., 0]
    return np.where(backwards[:, None, None], found.conj(), found)


def _along(values: np.ndarray, stations: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Values (waves, stations, points) at other x (waves, x, points), linear between; zero beyond the ends."""
    upper = np.clip(np.searchsorted(stations, x), 1, len(stations) - 1)
    share = ((x - stations[upper - 1]) / (stations[upper] - stations[upper - 1]))[:, None]
    found = values[:, upper - 1] * (1 - share) + values[:, upper] * share
    close = 1e-9 * np.ptp(stations)
    return np.where(((x < stations[0] - close) | (x > stations[-1] + close))[:, None], 0.0, found)
