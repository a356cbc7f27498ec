"""Long cylinders in the high-speed theory: an endless section, at rest until it begins to move or waves meet it.

Far behind its bow the cross-plane of a cylinder has long been moving, and its potential is that of
the section in the frequency domain. Amplitudes are weighed means over the end of the march, which
takes out what is left of the start.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from workbench.conventions import GRAVITY, encounter_frequency
from workbench.hydrodynamics.high_speed_hulls import Problem, Stations
from workbench.hydrodynamics.high_speed_march import Waves, sectional
from workbench.hydrodynamics.marched_contour import Contour

SPEED, TIME_STEP = 1.0, 0.06
"""Of the march [m/s, s]; the cylinders have a radius of 1 m."""
COARSE, FINE = 10.5, 20.5
"""Points of the water per metre: the error goes with the distance of the first one from the hull."""
PERIODS = 6


def arc(centre: float = 0.0, panels: int = 24, half: bool = False) -> np.ndarray:
    """Half-immersed circle of radius 1 m, or its port half: complex points from starboard or keel to port."""
    angle = np.linspace(-np.pi / 2 if half else -np.pi, 0.0, panels + 1)
    points = centre + np.cos(angle) + 1j * np.sin(angle)
    points[-1] = points[-1].real
    points[0] = centre - 1j if half else points[0].real
    return points


def contour_of(*parts: np.ndarray) -> Contour:
    """Contour of hulls from the points of each; every hull is a family."""
    return Contour(
        np.concatenate([part[:-1] for part in parts]),
        np.concatenate([part[1:] for part in parts]),
        tuple((float(part[0].real), float(part[-1].real)) for part in parts),
        np.repeat(np.arange(len(parts)), [len(part) - 1 for part in parts]),
    )


@dataclass(frozen=True, eq=False)
class Amplitudes:
    """What an endless cylinder, or two, feels long after the start; density 1 kg/m3, exp(-i omega t).

    Parameters
    ----------
    added_mass, damping : (ka, 3, 3) per length in sway, heave, roll about the origin.
    diffraction : (ka, directions, 3) force per length and wave amplitude, crest at the section.
    """

    added_mass: np.ndarray
    damping: np.ndarray
    diffraction: np.ndarray


@cache
def amplitudes(
    ka: tuple[float, ...],
    directions: tuple[float, ...] = (),
    half_spacing: float = 0.0,
    points: float = COARSE,
    half_width: float = 30.0,
    time: float = 30.0,
) -> Amplitudes:
    """Amplitudes of one cylinder, or of a twin with its axes ``half_spacing`` from the middle [m].

    Parameters
    ----------
    points : of the water per metre; half_width : of the cross-plane [m]; time : of the march [s].
    """
    section = contour_of(arc(half_spacing) if half_spacing else arc(half=True))
    count = round(time / TIME_STEP)
    x = -TIME_STEP * SPEED * np.arange(1, count + 1)
    omega = np.sqrt(GRAVITY * np.array(ka))
    frequency, direction = (part.ravel() for part in np.meshgrid(omega, directions, indexing="ij"))
    waves = Waves(frequency, direction, encounter_frequency(frequency, SPEED, direction))
    problem = Problem((section,) * count, 1, 0.0, (1, -1))
    stations = Stations(x, 0.0, (), True)
    found = sectional(problem, stations, SPEED, omega, waves, half_width, 1 / points, np.zeros(0))
    # the wave that a fixed cross-plane sees has the wave's own frequency
    passing = np.exp(1j * frequency**2 / GRAVITY * np.cos(direction) * x[:, None])
    moved = _mean(found.radiation[:, 0, :, :3], omega) / (1j * omega)
    met = _mean(found.diffraction[:, 0] * passing[:, None], frequency) * (1j * frequency)
    moved = -np.moveaxis(moved, -1, 0)
    return Amplitudes(
        added_mass=moved.real,
        damping=-moved.imag * omega[:, None, None],
        diffraction=np.conj(met).T.reshape(len(omega), len(directions), 3),
    )


def extrapolated(ka: tuple[float, ...], directions: tuple[float, ...] = (), **more) -> Amplitudes:
    """Amplitudes from two grids, as the error goes with the spacing."""
    coarse = amplitudes(ka, directions, points=COARSE, **more)
    fine = amplitudes(ka, directions, points=FINE, **more)
    return Amplitudes(
        *(
            getattr(fine, name) + (getattr(fine, name) - getattr(coarse, name)) * COARSE / (FINE - COARSE)
            for name in ("added_mass", "damping", "diffraction")
        )
    )


def _mean(values: np.ndarray, frequency: np.ndarray) -> np.ndarray:
    """Weighed mean over the last periods of each frequency, (stations, ..., frequency) to (..., frequency)."""
    steps = np.arange(len(values))[:, None] - len(values) + 1
    length = np.minimum(PERIODS * 2 * np.pi / frequency / TIME_STEP, len(values))
    weights = np.where(-steps < length, np.sin(np.pi * steps / length) ** 2, 0.0)
    return np.einsum("sf,s...f->...f", weights / weights.sum(axis=0), values)
