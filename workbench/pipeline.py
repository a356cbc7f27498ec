"""The stages in order: from a design and a condition to motions, slamming and pressure.

Results of falling price per change: `response` (hull, masses, speed, headings:
seconds to minutes for a new hull, milliseconds for a known one), `deck_response`
(plan of the deck: tens of milliseconds), `slamming` (sea, clearance, criterion:
tens of milliseconds). Each takes only what it needs, so that raising the deck
cannot rerun the hydrodynamics. `counted_slams` draws a realisation and counts.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
import xarray as xr

from workbench import quantities
from workbench import theory_stage as stage
from workbench.conventions import froude_number
from workbench.damping.additions import additions
from workbench.damping.cross_flow import cross_flow
from workbench.design import Design, WetDeck
from workbench.errors import InputError, checked_number
from workbench.geometry.hydrostatics import equilibrium, hydrostatics, stiffness_matrix
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hydrodynamics.own_wave import own_wave
from workbench.hydrodynamics.recommended import RecommendedSettings, TheorySettings
from workbench.impact.pressure import PressureLaw, velocity_notes
from workbench.motions import motions
from workbench.relative_motion import relative_motion
from workbench.running_state import RunningState
from workbench.sea_energy import band_notes, wave_energy
from workbench.seas import Condition
from workbench.slamming import criteria, events, extremes, statistics
from workbench.time_domain import Realisation, relative_amplitudes, wave_components

DECK_POINTS = (40, 10)
"""Points of the deck grid, lengthwise and across."""


def silent(fraction: float, message: str) -> None:
    """Take notice of progress, and do nothing."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Response:
    """Hydrodynamics and motions of a ship at one speed, for all its headings and frequencies."""

    design: Design
    speed: float
    settings: TheorySettings
    hydrostatics: xr.Dataset
    hydrodynamics: xr.Dataset
    motions: xr.Dataset
    wave_field: xr.Dataset | None
    additions: tuple[xr.Dataset, ...] = ()
    running_state: RunningState = field(default_factory=RunningState)


@dataclass(frozen=True, kw_only=True, eq=False)
class Slamming:
    """Closed-form slamming of a deck in one condition."""

    condition: Condition
    deck: xr.Dataset
    clearance: float
    threshold: float
    law: PressureLaw
    hours: float
    criterion_per_hour: float
    moments: xr.Dataset
    statistics: xr.Dataset
    motion_statistics: xr.Dataset
    least_clearance: float

    @property
    def worst_point(self) -> dict[str, int]:
        """Indices of the deck point that slams most (where none does, that is nearest to it)."""
        exponent = self.deck.height / self.moments.relative_motion_std.clip(1e-12)
        rate = self.statistics.slams_per_hour
        chosen = rate if float(rate.max()) > 0 else -exponent
        row, column = np.unravel_index(int(np.argmax(chosen.values)), chosen.shape)
        return {"x": int(row), "y": int(column)}


def response(
    design: Design,
    speed: float,
    wave_directions: Sequence[float] | None = None,
    omega: Sequence[float] | None = None,
    settings: TheorySettings | None = None,
    *,
    running_state: RunningState | None = None,
    workers: int = 1,
    progress: Callable[[float, str], None] = silent,
) -> Response:
    """Hydrodynamics and motions of a design at one speed.

    Parameters
    ----------
    design : hull and masses are used, and the density of its water.
    speed : [m/s].
    wave_directions : [rad]; None takes 0 to 345 degrees by 15, less those that the theory cannot do.
    omega : wave frequencies [rad/s]; None takes `radiation_store.wave_frequencies`.
    settings : of one theory, which thereby is chosen; None takes the recommended ones.
    running_state : running attitude, sails, appendages, locked modes, drag.
    workers : processes for a new hull of the panel method; progress : called with fraction and sentence, may
        raise to cancel.

    Raises
    ------
    InputError for a design out of equilibrium, waves too short for the panels, or a
    speed and heading at which the theory cannot be used.
    """
    checked_number("speed", speed, "m/s", at_least=0, at_most=60)
    settings = settings or RecommendedSettings()
    state = running_state or RunningState()
    masses = design.masses
    afloat = hydrostatics(design.hull, design.density, masses.centre_of_gravity[2])
    notes = equilibrium(design.hull, masses, design.density, may_capsize="roll" in state.locked)
    if wave_directions is None:
        wave_directions = stage.directions_for(settings, design.hull.length, speed)
    running = state.running_hull(design.hull, masses.centre_of_gravity[0])
    found, wave_field = stage.hydrodynamics(
        running,
        design.density,
        speed,
        wave_directions,
        omega,
        settings,
        workers=workers,
        progress=progress,
    )
    stiffness = stiffness_matrix(running, masses, design.density)
    found.attrs["warnings"] = quantities.joined_warnings([*notes, *quantities.warnings_of(found)])
    added = additions(design, found, wind=state.wind, sails=state.sails, lift=state.lift)
    if "stiffness_correction" in found:
        added = (*added, stage.stiffness_addition(found))
    drag = state.drag_coefficients
    moved = motions(
        found,
        masses,
        stiffness,
        additions=added,
        locked=state.locked,
        cross_flow=None if drag is None else cross_flow(running, design.density, *drag),
        wave_amplitude=state.drag_wave_amplitude,
    )
    if "recommendation" in found.attrs:
        moved.attrs["recommendation"] = found.attrs["recommendation"]
    return Response(
        design=design,
        speed=float(speed),
        settings=settings,
        hydrostatics=afloat,
        hydrodynamics=found,
        motions=moved,
        wave_field=wave_field,
        additions=added,
        running_state=state,
    )


def deck_response(
    ship: Response,
    wet_deck: WetDeck,
    points: tuple[int, int] = DECK_POINTS,
) -> xr.Dataset:
    """Relative motion, velocity and slope per wave amplitude over a deck (omega, wave_direction, x, y).

    Depends on the plan of the deck, not on its height.
    """
    return relative_motion(ship.motions, wet_deck_grid(wet_deck, *points), ship.wave_field)


def steady_elevation(
    ship: Response, wet_deck: WetDeck, points: tuple[int, int] = DECK_POINTS
) -> xr.DataArray:
    """Rise of the water under the deck by the ship's own steady wave (x, y) [m], by the high-speed theory."""
    deck = wet_deck_grid(wet_deck, *points)
    design = ship.design
    found = own_wave(design.hull, design.masses, design.density, ship.speed, deck.x.values, deck.y.values)
    return found.steady_elevation


def threshold_of(choice: str | float, design: Design) -> float:
    """Threshold velocity [m/s] from 0, a number, or "ochi" (0.093 sqrt(g L))."""
    if choice == "ochi":
        return float(statistics.threshold_velocity(design.hull.length))
    return checked_number("threshold velocity", choice, "m/s", at_least=0, at_most=50)


def slamming(
    ship: Response,
    relative: xr.Dataset,
    wet_deck: WetDeck,
    condition: Condition,
    *,
    threshold: str | float = 0.0,
    law: PressureLaw | None = None,
    hours: float = 1.0,
    criterion_per_hour: float = criteria.CRITERION_SLAMS_PER_HOUR,
    steady_elevation: float | xr.DataArray = 0.0,
) -> Slamming:
    """Closed-form slamming statistics of a deck in a sea.

    Parameters
    ----------
    ship : from `response`; relative : from `deck_response` for a deck of the same plan.
    wet_deck : its height counts here; condition : at the speed of ``ship``.
    threshold : least entry velocity [m/s], or "ochi".
    law : pressure law; hours : for the most probable largest pressure [h].
    criterion_per_hour : slams per hour that are allowed.
    steady_elevation : rise of the water under the deck by the ship's own waves at speed,
        one value or (x, y) [m]; from model tests or a wave-resistance program.
    """
    checked_number("hours", hours, "h", above=0, at_most=1e5)
    checked_number("criterion", criterion_per_hour, "slams per hour", above=0, at_most=3600)
    if abs(condition.speed - ship.speed) > 1e-6 * max(ship.speed, 1.0):
        raise InputError(
            f"speed of the condition must be that of the computed response, {ship.speed:g} m/s, "
            f"got {condition.speed:g} m/s; compute the response at the new speed."
        )
    law = law or PressureLaw()
    least_velocity = threshold_of(threshold, ship.design)
    deck = wet_deck_grid(wet_deck, relative.sizes["x"], relative.sizes["y"])
    deck["height"] = (deck.height - steady_elevation).assign_attrs(deck.height.attrs)
    if not bool((deck.height > 0).all()):
        raise InputError(
            f"steady_elevation must leave the deck above water everywhere, got a gap of "
            f"{float(deck.height.min()):.3g} m; raise the clearance or check the elevation."
        )
    energy = wave_energy(condition, relative.omega, relative.wave_direction)
    moments = statistics.response_moments(relative, energy)
    found = statistics.slamming_statistics(moments, deck.height, least_velocity, law.velocity)
    found["most_probable_entry_velocity"] = extremes.largest_entry_velocity(moments, found, hours)
    found["most_probable_peak_pressure"] = extremes.largest_peak_pressure(
        moments, found, deck, law, ship.design.density, hours
    )
    found["required_height"] = criteria.required_height(moments, criterion_per_hour, least_velocity)
    of_pressure = (*law.validity, *velocity_notes(law, float(found.most_probable_entry_velocity.max())))
    notes = (*quantities.warnings_of(found), *band_notes(energy, condition), *of_pressure)
    found.attrs["warnings"] = quantities.joined_warnings(notes)
    found.attrs["pressure_warnings"] = quantities.joined_warnings(of_pressure)
    found.attrs["speed"] = ship.speed
    found.attrs["froude_number"] = float(froude_number(ship.speed, ship.design.hull.length))
    return Slamming(
        condition=condition,
        deck=deck,
        clearance=wet_deck.clearance,
        threshold=least_velocity,
        law=law,
        hours=hours,
        criterion_per_hour=criterion_per_hour,
        moments=moments,
        statistics=found,
        motion_statistics=statistics.motion_statistics(ship.motions, energy),
        least_clearance=criteria.least_clearance(
            moments, deck.height, wet_deck.clearance, criterion_per_hour, least_velocity
        ),
    )


def counted_slams(
    ship: Response,
    relative: xr.Dataset,
    slam: Slamming,
    realisation: Realisation | None = None,
) -> tuple[xr.Dataset, xr.Dataset]:
    """Slams counted in a realisation of the condition: events, and counts with bands per point.

    Costs about 3 s for one hour on 400 points at full scale.
    """
    realisation = realisation or Realisation()
    components = wave_components(
        slam.condition, realisation, float(relative.omega.min()), float(relative.omega.max())
    )
    rise, slope = relative_amplitudes(components, ship.motions, relative)
    found = events.entries(
        rise,
        slope,
        components.component_frequency.values,
        slam.deck,
        duration=3600 * realisation.hours,
        time_step=realisation.time_step or time_step(ship.design.hull.length),
        threshold=slam.threshold,
        law=slam.law,
        density=ship.design.density,
        drift=ship.speed if slam.law.velocity == "material" else 0.0,
    )
    found.attrs["seed"] = int(realisation.seed)
    return found, events.counts(found, slam.deck)


def time_step(length: float) -> float:
    """Usual time step of a record [s]: 1/20 s for a ship of 60 m, by Froude's law for others, at most 1/20 s."""
    return 0.05 * min(1.0, float(np.sqrt(length / 60.0)))
