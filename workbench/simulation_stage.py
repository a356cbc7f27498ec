"""Simulations of a design in a sea or a regular wave: from its linear response, by any theory, to records."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import xarray as xr

from workbench import pipeline, quantities, sea_energy
from workbench.conventions import GRAVITY
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.hydrodynamics.recommended import RecommendedSettings, TheorySettings, recommended
from workbench.pipeline import Response
from workbench.radiation_store import wave_frequencies
from workbench.seas import Condition
from workbench.simulation.records import ShipInWaves, simulation
from workbench.time_domain import Realisation, components_from, wave_components

Respond = Callable[[Sequence[float], np.ndarray | None], Response]
"""Response of the ship for wave directions [rad] and wave frequencies [rad/s] (None: the usual ones)."""

RADIATION_DIRECTIONS = np.pi / 2, np.pi
"""Headings that tell, beside the wanted one, of the radiation forces at speed over frequency [rad]."""

_SHORT_OF_OVERTAKING = 0.9
_WAVES_OVERTAKING = 150  # frequencies times headings: enough for the stored potentials to serve


def simulated_sea(
    design: Design,
    condition: Condition,
    realisation: Realisation,
    respond: Respond,
    *,
    forces: str = "non-linear",
    points: Sequence[tuple[float, float]] = (),
    radiation_directions: Sequence[float] = RADIATION_DIRECTIONS,
    progress: Callable[[float, str], None] = pipeline.silent,
) -> xr.Dataset:
    """Records of a ship in a realisation of a sea; parameters as `simulation`.

    Parameters
    ----------
    respond : makes the linear response of the design at the speed of the condition, by any method;
        all headings by the same.
    radiation_directions : further headings that a non-linear simulation at speed asks for [rad]; with a
        method that is dear, head seas alone do.
    """
    directions = sea_energy.directions_for(condition)
    found = _response(design, condition.speed, directions, forces, respond, radiation_directions)
    lowest, highest = float(found.motions.omega[0]), float(found.motions.omega[-1])
    components = wave_components(condition, realisation, lowest, highest)
    energy = sea_energy.wave_energy(
        condition,
        found.motions.omega,
        found.motions.wave_direction.sel(wave_direction=directions, method="nearest"),
    )
    made = _records(
        design, found, components, realisation.hours * 3600, realisation.time_step, forces, points, progress
    )
    sea = condition.sea_state
    made.attrs["seed"] = int(realisation.seed)
    made.attrs["waves"] = (
        f"{sea.spectrum} sea, Hs {sea.significant_wave_height:g} m, Tp {sea.peak_period:.4g} s, "
        f"heading {np.degrees(condition.wave_direction):g} degrees"
    )
    made.attrs["warnings"] = quantities.joined_warnings(
        [*quantities.warnings_of(made), *sea_energy.band_notes(energy, condition)]
    )
    return made


def simulated_regular_wave(
    design: Design,
    speed: float,
    wave_direction: float,
    amplitude: float,
    omega: float,
    respond: Respond,
    *,
    hours: float,
    time_step: float | None = None,
    forces: str = "non-linear",
    points: Sequence[tuple[float, float]] = (),
    radiation_directions: Sequence[float] = RADIATION_DIRECTIONS,
    progress: Callable[[float, str], None] = pipeline.silent,
) -> xr.Dataset:
    """Records of a ship in a regular wave of an amplitude [m] and wave frequency [rad/s]; else as `simulated_sea`."""
    checked_number("regular-wave-amplitude", amplitude, "m", above=0, at_most=30)
    checked_number("omega", omega, "rad/s", above=0, at_most=100)
    steepness = 2 * amplitude * omega**2 / GRAVITY / (2 * np.pi)
    if steepness > 1 / 7:
        most = GRAVITY * np.pi / (7 * omega**2)
        raise InputError(
            f"regular-wave-amplitude must be <= {most:.3g} m at omega {omega:g} rad/s, got {amplitude:g} m; steeper "
            "waves break: lower it or take a longer wave."
        )
    found = _response(design, speed, [wave_direction], forces, respond, radiation_directions)
    _check_covered(omega, found.motions.omega.values)
    components = components_from(omega, amplitude, 0.0, wave_direction, speed)
    made = _records(design, found, components, hours * 3600, time_step, forces, points, progress)
    made.attrs["waves"] = (
        f"regular waves of {amplitude:g} m amplitude, omega {omega:g} rad/s, heading "
        f"{np.degrees(wave_direction):g} degrees"
    )
    return made


def _response(
    design: Design,
    speed: float,
    directions,
    forces: str,
    respond: Respond,
    radiation_directions: Sequence[float],
) -> Response:
    """Response at the wanted directions, and at those of the radiation where a simulation needs them.

    With a method that refuses waves that the ship overtakes, those are left out.
    """
    wanted = np.asarray(directions, float)
    more = tuple(radiation_directions) if forces == "non-linear" and speed > 0 else ()
    together = np.unique(np.round(np.mod(np.concatenate([wanted, more]), 2 * np.pi), 12))
    along = speed * float(np.cos(wanted).max())
    try:
        return respond(together, None)
    except InputError:
        if along <= 0:
            raise
    usual = respond([np.pi], None).motions.omega.values
    top = min(_SHORT_OF_OVERTAKING * GRAVITY / along, usual[-1])
    if top <= 2 * usual[0]:
        raise InputError(
            f"speed must be below that of the waves for a simulation, at {speed:.4g} m/s and this heading the ship "
            "overtakes nearly all of them; lower the speed, or choose a heading of 90 to 270 degrees."
        )
    count = max(len(usual), -(-_WAVES_OVERTAKING // len(together)))
    return respond(together, np.linspace(usual[0], top, count))


def _check_covered(omega: float, computed: np.ndarray) -> None:
    """Refuse a wave frequency beyond the computed ones."""
    if not computed[0] <= omega <= computed[-1]:
        raise InputError(
            f"omega must be {computed[0]:.3g} to {computed[-1]:.3g} rad/s for this ship, speed and heading, got "
            f"{omega:g} rad/s; take a wave among these."
        )


def _records(
    design, found: Response, components, duration, time_step, forces, points, progress
) -> xr.Dataset:
    """Records of a response in given waves."""
    running = found.running_state.running_hull(design.hull, design.masses.centre_of_gravity[0])
    ship = ShipInWaves(
        replace(design, hull=running), found.hydrodynamics, found.motions, found.wave_field, found.additions
    )
    step = time_step or pipeline.time_step(design.hull.length)
    return simulation(ship, components, duration, step, forces=forces, points=points, progress=progress)


def one_theory(
    settings: TheorySettings, length: float, speed: float, wave_directions: Sequence[float]
) -> TheorySettings:
    """Settings of one theory for all headings: radiation forces in time need those of one ship, not of several.

    Where different theories are recommended for the headings, strip theory, which can do all.
    """
    if not isinstance(settings, RecommendedSettings):
        return settings
    chosen = set(recommended(length, speed, wave_directions, wave_frequencies(length), settings.quick))
    return settings.of(chosen.pop() if len(chosen) == 1 else "strip")
