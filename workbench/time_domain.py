"""Seeded realisations of a sea, and the ship's linear response to them as records in time.

A record of many points is a product of a (points x components) with a
(components x times) matrix, block by block in time: the table of cosines of one
block serves all blocks, since a shift in time only turns the phases of the
amplitudes. Frequencies are unevenly spaced (one drawn in each of equal bins), so
that nothing repeats.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES, encounter_frequency, wavenumber
from workbench.errors import InputError, checked_choice, checked_number
from workbench.motions import between, interpolated_motions
from workbench.relative_motion import incident_elevation, vertical_motion
from workbench.seas import Condition, wave_spectrum

BLOCK_OF_TIMES = 4096
AMPLITUDES = ("deterministic", "rayleigh")


@dataclass(frozen=True, kw_only=True)
class Realisation:
    """How a sea is realised.

    Parameters
    ----------
    seed : of the random numbers, >= 0.
    hours : length of the record [h], up to 24.
    time_step : [s]; None takes 20 samples in the shortest encounter period that matters,
        at most 1/20 s at full scale, by Froude's law below.
    components : number of wave components, 2 to 2000.
    amplitudes : "deterministic" (sqrt(2 S d omega)) or "rayleigh" (drawn about it).
    """

    seed: int = 1
    hours: float = 1.0
    time_step: float | None = None
    components: int = 240
    amplitudes: str = "deterministic"

    def __post_init__(self):
        checked_number("seed", self.seed, at_least=0, at_most=2**63)
        if int(self.seed) != self.seed:
            raise InputError(f"seed must be a whole number >= 0, got {self.seed!r}.")
        checked_number("hours", self.hours, "h", above=0, at_most=24)
        if self.time_step is not None:
            checked_number("time_step", self.time_step, "s", above=0, at_most=10)
        checked_number("components", self.components, at_least=2, at_most=2000)
        checked_choice("amplitudes", self.amplitudes, AMPLITUDES)


def wave_components(
    condition: Condition, realisation: Realisation, lowest_omega: float, highest_omega: float
) -> xr.Dataset:
    """Draw the wave components of one realisation of an irregular sea (component).

    Parameters
    ----------
    condition : speed, direction and sea.
    realisation : seed, number of components, kind of amplitudes.
    lowest_omega, highest_omega : band of wave frequencies [rad/s].

    Notes
    -----
    One frequency is drawn in each of equal bins; the phase is uniform. In
    short-crested seas each component gets a direction drawn from the spreading.
    """
    rng = np.random.default_rng(int(realisation.seed))
    count = int(realisation.components)
    width = (highest_omega - lowest_omega) / count
    omega = lowest_omega + width * (np.arange(count) + rng.uniform(size=count))
    phase = rng.uniform(0, 2 * np.pi, count)
    energy = wave_spectrum(condition.sea_state, omega) * width
    amplitude = np.sqrt(2 * energy)
    if realisation.amplitudes == "rayleigh":
        amplitude = amplitude * rng.rayleigh(1 / np.sqrt(2), count)
    direction = np.full(count, condition.wave_direction)
    exponent = condition.sea_state.spreading_exponent
    if exponent is not None:
        direction = direction + _spread_angles(rng, exponent, count)
    return components_from(omega, amplitude, phase, direction, condition.speed)


def components_from(omega, amplitude, phase, wave_direction, speed: float) -> xr.Dataset:
    """Wave components given one by one: monochromatic, bichromatic, or any number (component).

    Parameters
    ----------
    omega : wave frequencies [rad/s], > 0; amplitude : [m]; phase : of the crest at the
        origin at t = 0, the elevation being a cos(k.x - omega_e t + phase) [rad].
    wave_direction : [rad], one or one each; speed : [m/s].
    """
    omega, amplitude, phase, direction = np.broadcast_arrays(
        *(np.atleast_1d(np.asarray(part, float)) for part in (omega, amplitude, phase, wave_direction))
    )
    if np.any(~np.isfinite(omega)) or np.any(omega <= 0):
        raise InputError(f"omega of a wave component must be > 0 rad/s, got {omega.min():g}.")
    k = wavenumber(omega)
    return quantities.dataset(
        {"component": np.arange(len(omega))},
        method="sum of regular waves",
        attrs={"speed": float(speed)},
        component_omega=("component", omega),
        component_amplitude=("component", amplitude),
        component_phase=("component", phase),
        component_direction=("component", direction),
        component_frequency=("component", encounter_frequency(omega, speed, direction)),
        component_kx=("component", k * np.cos(direction)),
        component_ky=("component", k * np.sin(direction)),
    )


def _spread_angles(rng: np.random.Generator, exponent: float, count: int) -> np.ndarray:
    """Draw angles about the main direction from cos**n over +-90 degrees, stratified and shuffled."""
    angles = np.linspace(-np.pi / 2, np.pi / 2, 2001)
    cumulative = np.cumsum(np.cos(angles) ** exponent)
    cumulative = (cumulative - cumulative[0]) / (cumulative[-1] - cumulative[0])
    level = (rng.permutation(count) + rng.uniform(size=count)) / count
    return np.interp(level, cumulative, angles)


def complex_amplitudes(components: xr.Dataset) -> np.ndarray:
    """Complex amplitude of each component, a exp(i phase), so that zeta(0, t) = Re sum A exp(-i omega_e t)."""
    return components.component_amplitude.values * np.exp(1j * components.component_phase.values)


def elevation_amplitudes(components: xr.Dataset, x, y) -> np.ndarray:
    """Complex amplitudes of the incident elevation at points, (component, *x.shape) [m]."""
    k, direction = wavenumber(components.component_omega.values), components.component_direction.values
    shape = (-1, *[1] * np.ndim(x))
    return complex_amplitudes(components).reshape(shape) * incident_elevation(k, direction, x, y)


def motion_amplitudes(components: xr.Dataset, motion_set: xr.Dataset) -> np.ndarray:
    """Complex amplitudes of the six motions at the centre of gravity, (component, 6) [m, rad].

    Each component takes the response of the nearest computed heading (in
    short-crested seas; the headings of the motions should cover the spreading).
    """
    omega = components.component_omega.values
    found = interpolated_motions(motion_set, omega)
    nearest = _nearest_direction(motion_set, components)
    return complex_amplitudes(components)[:, None] * found[np.arange(len(omega)), nearest]


def relative_amplitudes(
    components: xr.Dataset, motion_set: xr.Dataset, relative: xr.Dataset
) -> tuple[np.ndarray, np.ndarray]:
    """Complex amplitudes of relative motion [m] and relative slope [-], (component, x, y).

    Parameters
    ----------
    components : of the realisation.
    motion_set : motions per wave amplitude.
    relative : relative motion per wave amplitude on the deck, for the same headings.

    Notes
    -----
    Between the frequencies of the table, the motions and the ratio of the total
    to the incident elevation are interpolated, and the incident phase is exact.
    """
    x, y = np.meshgrid(relative.x.values, relative.y.values, indexing="ij")
    centre = np.asarray(motion_set.attrs["centre_of_gravity"])
    nearest = _nearest_direction(motion_set, components)
    omega = components.component_omega.values
    incident = elevation_amplitudes(components, x, y)
    own = motion_amplitudes(components, motion_set)
    nodes = motion_set.omega.values
    elevation, along = np.empty_like(incident), np.empty_like(incident)
    for direction in np.unique(nearest):
        mine = nearest == direction
        beta = motion_set.wave_direction.values[direction]
        at_nodes = incident_elevation(wavenumber(nodes), beta, x, y)
        rao = motion_set.motion_rao.values[:, direction]
        total = relative.relative_motion.values[:, direction] + vertical_motion(rao, centre, x, y)
        slope = relative.relative_slope.values[:, direction] - rao[:, 4, None, None]
        elevation[mine] = incident[mine] * between(nodes, total / at_nodes, omega[mine])
        along[mine] = incident[mine] * between(nodes, slope / at_nodes, omega[mine])
    return elevation - vertical_motion(own, centre, x, y), along + own[:, 4, None, None]


def _nearest_direction(motion_set: xr.Dataset, components: xr.Dataset) -> np.ndarray:
    """Index of the computed heading nearest to each component's direction."""
    away = components.component_direction.values[:, None] - motion_set.wave_direction.values[None, :]
    return np.argmin(np.abs(np.angle(np.exp(1j * away))), axis=1)


def sampling_times(duration: float, time_step: float) -> np.ndarray:
    """Times from 0 to the duration [s], evenly spaced by the step, the last at or past the duration."""
    return np.arange(int(np.ceil(duration / time_step)) + 1) * time_step


def record_blocks(
    amplitudes: np.ndarray,
    frequency: np.ndarray,
    duration: float,
    time_step: float,
    block: int = BLOCK_OF_TIMES,
    overlap: int = 0,
) -> Iterator[tuple[int, np.ndarray]]:
    """Records Re sum_j A_jp exp(-i omega_j t), block by block in time.

    Parameters
    ----------
    amplitudes : (component, point) complex.
    frequency : (component) signed encounter frequencies [rad/s].
    duration, time_step : [s]; block : samples a block; overlap : samples repeated
        from the block before, for what looks across the seam.

    Yields
    ------
    Index of the first sample, and a float32 array (point, samples).

    Notes
    -----
    Costs 4 x points x components x samples floating point operations in single
    precision, and memory for one block.
    """
    total = len(sampling_times(duration, time_step))
    table_times = np.arange(block) * time_step
    angle = frequency[:, None] * table_times[None, :]
    table = np.concatenate([np.cos(angle), np.sin(angle)]).astype(np.float32)
    start = 0
    while start < total:
        length = min(block, total - start)
        turned = amplitudes * np.exp(-1j * frequency * (start * time_step))[:, None]
        factors = np.concatenate([turned.real, turned.imag]).astype(np.float32)
        yield start, factors.T @ table[:, :length]
        if start + length >= total:
            return
        start += block - overlap


def records(amplitudes: np.ndarray, frequency: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Records at given times, (point, time) in float64, for a modest number of points.

    Parameters
    ----------
    amplitudes : (component, point) complex; frequency : (component) [rad/s]; times : [s].
    """
    phase = np.exp(-1j * np.multiply.outer(frequency, times))
    return (amplitudes.T @ phase).real


def time_histories(
    components: xr.Dataset, motion_set: xr.Dataset, duration: float, time_step: float
) -> xr.Dataset:
    """Six motions at the centre of gravity and the wave elevation there, over time.

    Returns
    -------
    Dataset over time: ``motion`` (time, dof) [m, rad], ``elevation`` (time) [m].
    """
    times = sampling_times(duration, time_step)
    frequency = components.component_frequency.values
    centre = motion_set.attrs["centre_of_gravity"]
    own = motion_amplitudes(components, motion_set)
    wave = elevation_amplitudes(components, np.array(centre[0]), np.array(centre[1]))
    together = np.concatenate([own, wave[:, None]], axis=1)
    blocks = [part for _, part in record_blocks(together, frequency, duration, time_step)]
    series = np.concatenate(blocks, axis=1).astype(float)
    return quantities.dataset(
        {"time": times, "dof": list(MODES)},
        method=motion_set.attrs["method"],
        attrs={"speed": motion_set.attrs["speed"]},
        motion=(("time", "dof"), series[:6].T),
        elevation=("time", series[6]),
    )
