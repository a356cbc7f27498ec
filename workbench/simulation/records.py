"""Records of a ship in a sea: motions, and water against chosen points, linear or with the wet hull's forces."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import GRAVITY, MODES, froude_number
from workbench.design import Design
from workbench.errors import InputError, checked_choice, checked_number
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.geometry.wet_deck import wet_deck_height
from workbench.motions import mass_matrix, roll_damping, translation_matrix
from workbench.relative_motion import relative_motion
from workbench.simulation.cummins import DEPARTING, DepartureEquation, SimulatedDeparture, simulated_departure
from workbench.simulation.hull_grid import hull_surface
from workbench.simulation.incident_pressure import HullInWaves
from workbench.simulation.retardation import MEMORY, radiation_forces, stable_operator
from workbench.time_domain import (
    elevation_amplitudes,
    motion_amplitudes,
    record_blocks,
    relative_amplitudes,
    sampling_times,
)

FORCES = ("linear", "non-linear")

STEPS_PER_PERIOD = 16
"""Least number of time steps in the shortest natural period of heave, roll and pitch [-]."""

LEAST_SAMPLES, MOST_SAMPLES = 32, 4_000_000


@dataclass(frozen=True, eq=False)
class ShipInWaves:
    """A ship at one speed with its linear response.

    Parameters
    ----------
    design : hull, masses, wet deck and density are used.
    hydrodynamics : coefficients of any method; headings beyond the wanted one tell more
        of the radiation forces over frequency (beam and head seas are enough).
    motions : linear motions that follow from them.
    wave_field : scattered waves under the deck, or None.
    additions : forces beside those of the hulls that the motions contain, as for `workbench.motions.motions`.
    """

    design: Design
    hydrodynamics: xr.Dataset
    motions: xr.Dataset
    wave_field: xr.Dataset | None = None
    additions: tuple[xr.Dataset, ...] = ()


def simulation(
    ship: ShipInWaves,
    components: xr.Dataset,
    duration: float,
    time_step: float,
    *,
    forces: str = "non-linear",
    points: Sequence[tuple[float, float]] = (),
    panels: int = 1000,
    progress: Callable[[float, str], None] = lambda fraction, message: None,
) -> xr.Dataset:
    """Records of the six motions, the wave and the relative motion at points.

    Parameters
    ----------
    ship : its linear response, at the speed of the components.
    components : waves, from `workbench.time_domain.wave_components` or ``components_from``.
    duration, time_step : [s].
    forces : "linear", or "non-linear": buoyancy and the pressure of the undisturbed wave
        on the hull up to the instantaneous surface, see `workbench.simulation.cummins`.
    points : (x, y) of points of the ship [m].
    panels : of the hull surface in the non-linear simulation.
    progress : called with the fraction done and a sentence; may raise to cancel.

    Returns
    -------
    Dataset over time: ``motion`` (time, dof) at the centre of gravity, ``elevation`` at
    its mean place; ``relative_motion_history`` (time, point), ``point_x``, ``point_y``, and,
    for points under the wet deck, ``deck_height`` and ``slam_count``, the entries of the
    deck into the water there (-1 for others); ``linear_motion`` in a non-linear simulation.

    Notes
    -----
    Not in the forces: slams and green water on the wet deck, lift, the steady wave of the
    ship, and whatever is of second order in diffraction and radiation. One hour at 20 Hz
    with 1000 panels costs some 20 s.
    """
    checked_choice("forces", forces, FORCES)
    checked_number("duration of the record", duration, "s", above=0)
    checked_number("time_step", time_step, "s", above=0)
    _check_samples(duration, time_step)
    if abs(components.attrs["speed"] - ship.motions.attrs["speed"]) > 1e-6:
        raise InputError(
            f"speed of the wave components must be that of the response, {ship.motions.attrs['speed']:g} m/s, got "
            f"{components.attrs['speed']:g} m/s; compute one of them anew."
        )
    times = sampling_times(duration, time_step)
    frequency = components.component_frequency.values
    centre = np.asarray(ship.design.masses.centre_of_gravity, float)
    own = motion_amplitudes(components, ship.motions)
    wave = elevation_amplitudes(components, np.array(centre[0]), np.array(centre[1]))
    places = np.asarray(points, float).reshape(-1, 2)
    relative = _relative_amplitudes(ship, components, places)
    together = np.concatenate([wave[:, None], relative, own], axis=1)
    blocks = [
        part for _, part in record_blocks(together, frequency, (len(times) - 1.5) * time_step, time_step)
    ]
    series = np.concatenate(blocks, axis=1).astype(float)
    elevation, water, linear = series[0], series[1 : 1 + len(places)].T, series[1 + len(places) :].T
    variables, notes = {}, ()
    motion = linear
    if forces == "non-linear":
        found = _departure(ship, components, own, len(times), time_step, panels, progress)
        motion, notes = linear + found.departure, _surface_notes(found)
        water = water - (_heights(motion, centre, places) - _linear_heights(linear, centre, places))
        variables["linear_motion"] = (("time", "dof"), linear)
    if len(places):
        height = _deck_heights(ship.design, places)
        variables |= {
            "relative_motion_history": (("time", "point"), water),
            "point_x": ("point", places[:, 0]),
            "point_y": ("point", places[:, 1]),
            "deck_height": ("point", height),
            "slam_count": ("point", _entries(water, height)),
        }
    return quantities.dataset(
        {
            "time": times,
            "dof": list(MODES),
            **({"point": np.arange(1, len(places) + 1)} if len(places) else {}),
        },
        method=f"{forces} simulation on {ship.motions.attrs['method']}",
        warnings=[*quantities.warnings_of(ship.motions), *_steepness_notes(components), *notes],
        attrs={
            "forces": forces,
            "design": ship.design.name,
            "speed": float(ship.motions.attrs["speed"]),
            "froude_number": float(froude_number(ship.motions.attrs["speed"], ship.design.hull.length)),
            "centre_of_gravity": [float(value) for value in centre],
            "density": float(ship.design.density),
            "time_step": float(time_step),
            "significant_wave_height": 4
            * float(np.sqrt(np.sum(components.component_amplitude.values**2) / 2)),
        },
        motion=(("time", "dof"), motion),
        elevation=("time", elevation),
        **variables,
    )


def departure_equation(ship: ShipInWaves, time_step: float) -> DepartureEquation:
    """Left side of the equation for the departure from linear motion, about the centre of gravity.

    Raises
    ------
    InputError where the time step is too coarse for the natural periods.
    """
    design, hydrodynamics = ship.design, ship.hydrodynamics
    stiffness = stiffness_matrix(design.hull, design.masses, design.density)
    viscous = roll_damping(design.masses, stiffness, hydrodynamics.added_mass.values)
    omega, force = radiation_forces(hydrodynamics, viscous, ship.additions)
    locked = str(ship.motions.attrs.get("locked", "")).split(", ")
    modes = tuple(MODES.index(mode) for mode in DEPARTING if mode not in locked)
    if not modes:
        raise InputError(
            "a non-linear simulation needs heave, roll or pitch free, all three are locked; free one, or choose the "
            "linear simulation."
        )
    back = np.linalg.inv(translation_matrix(design.masses.centre_of_gravity))[:, modes]

    def about_centre(matrix):
        return back.T @ matrix @ back

    mass, restoring = about_centre(mass_matrix(design.masses)), about_centre(stiffness)
    fastest = float(np.sqrt(np.max(np.diag(restoring) / np.diag(mass))))
    longest = 2 * np.pi / fastest / STEPS_PER_PERIOD
    if time_step > longest:
        raise InputError(
            f"time_step must be <= {longest:.3g} s to follow the motions of this ship, got {time_step:g} s; leave it "
            "out, or take a shorter one."
        )
    plain = ship.motions.attrs["speed"] == 0 and not ship.additions
    operator = stable_operator(
        omega, about_centre(force), design.hull.length, time_step, plain, mass, restoring
    )
    return DepartureEquation(modes, mass, restoring, operator)


def _departure(
    ship: ShipInWaves,
    components: xr.Dataset,
    own: np.ndarray,
    count: int,
    time_step: float,
    panels: int,
    progress: Callable[[float, str], None],
) -> SimulatedDeparture:
    """Departure from linear motion by the forces of the wet hull."""
    design = ship.design
    equation = departure_equation(ship, time_step)
    surface = hull_surface(design.hull, design.masses.centre_of_gravity, panels)
    centre = np.asarray(design.masses.centre_of_gravity, float)
    in_waves = HullInWaves(surface, centre, components, design.density)
    memory = MEMORY * np.sqrt(design.hull.length / GRAVITY)
    lead_in = int(np.ceil(2 * memory / time_step))
    return simulated_departure(equation, in_waves, own, steps=count, lead_in=lead_in, progress=progress)


def _relative_amplitudes(ship: ShipInWaves, components: xr.Dataset, places: np.ndarray) -> np.ndarray:
    """Complex amplitudes of the linear relative motion at points (component, point) [m]."""
    if not len(places):
        return np.zeros((components.sizes["component"], 0), complex)
    x, row = np.unique(places[:, 0], return_inverse=True)
    y, column = np.unique(places[:, 1], return_inverse=True)
    deck = xr.Dataset(coords={"x": x, "y": y})
    rise, _ = relative_amplitudes(
        components, ship.motions, relative_motion(ship.motions, deck, ship.wave_field)
    )
    return rise[:, row, column]


def _linear_heights(motion: np.ndarray, centre: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Vertical motion (time, point) of points by small rotations [m]."""
    x, y = places[:, 0] - centre[0], places[:, 1] - centre[1]
    return motion[:, 2, None] - motion[:, 4, None] * x + motion[:, 3, None] * y


def _heights(motion: np.ndarray, centre: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Vertical motion (time, point) of points on the waterplane by finite rotations [m]."""
    x, y = places[:, 0] - centre[0], places[:, 1] - centre[1]
    roll, pitch = motion[:, 3, None], motion[:, 4, None]
    arms = -np.sin(pitch) * x + np.cos(pitch) * (np.sin(roll) * y - centre[2] * np.cos(roll))
    return motion[:, 2, None] + arms + centre[2]


def _deck_heights(design: Design, places: np.ndarray) -> np.ndarray:
    """Height of the wet deck above still water at points, NaN where there is none [m]."""
    deck = design.wet_deck
    if deck is None:
        return np.full(len(places), np.nan)
    x, y = places.T
    under = (x >= deck.aft) & (x <= deck.fore) & (np.abs(y) <= deck.width / 2)
    return np.where(under, wet_deck_height(deck, x, y), np.nan)


def _entries(water: np.ndarray, height: np.ndarray) -> np.ndarray:
    """Number of up-crossings of the deck's height by relative motion (time, point); -1 without a deck."""
    above = water >= np.where(np.isnan(height), np.inf, height)
    return np.where(np.isnan(height), -1, np.count_nonzero(~above[:-1] & above[1:], axis=0))


def _check_samples(duration: float, time_step: float) -> None:
    """Refuse records of too few or too many samples."""
    samples = duration / time_step
    if not LEAST_SAMPLES <= samples <= MOST_SAMPLES:
        raise InputError(
            f"record must have {LEAST_SAMPLES} to {MOST_SAMPLES} samples, got {samples:.0f} "
            f"({duration:g} s at {time_step:g} s); {'lengthen' if samples < LEAST_SAMPLES else 'shorten'} it or "
            "change the time step."
        )


def _steepness_notes(components: xr.Dataset) -> tuple[str, ...]:
    """Say so where the sum of waves is steeper than waves can be."""
    slope = components.component_amplitude.values * np.hypot(
        components.component_kx.values, components.component_ky.values
    )
    steepest = float(np.sqrt(np.sum(slope**2) / 2)) * np.sqrt(2)
    if steepest < 0.3:
        return ()
    return (
        f"The waves are steep (significant slope {steepest:.2f}): real ones would break, and linear waves are a rough "
        "guide.",
    )


def _surface_notes(found: SimulatedDeparture) -> tuple[str, ...]:
    """Say so where no hull was wet, or water stood on the deck of one, for part of the time."""
    notes = []
    if found.flying > 0:
        notes.append(
            f"The ship was out of the water for {100 * found.flying:.2g} % of the time: linear radiation and "
            "diffraction are far outside their range then."
        )
    if found.covered > 0:
        notes.append(
            f"Water stood above the deck edge of a hull for {100 * found.covered:.2g} % of the time: the hull ends "
            "there, and what stands on it is left out."
        )
    return tuple(notes)
