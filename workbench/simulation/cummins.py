"""Motions with the water forces of the hull as it lies in the wave: the equation of Cummins about the linear solution.

Added mass, radiation damping and diffraction stay linear; buoyancy and the
pressure of the undisturbed wave act on the hull up to the instantaneous surface.
With x = x_lin + y, and x_lin the linear response to the same wave components, the
linear parts (diffraction among them) drop out of the equation of motion, and what
is left is an equation for the departure y from linear motion::

    (M + A) y'' + B y' + (C + C_U) y + int K(s) y'(t - s) ds = N(x, t)
    N(x, t) = F(x, t) - F(0, still) - [F_FK(t) - C_h x]

F is the force of water and incident wave on the wet hull, F_FK and C_h its own
derivatives by waves and motions, so that N is of second order. C is the
hydrostatic stiffness; A, B, C_U and K come from `workbench.simulation.retardation`.

This form is used, and not the equation for x, because in small waves it gives the
linear response whatever method the coefficients come from. Solved for x, errors of
the retardation functions stand in the linear response: 1 to 5 % of the peaks of
heave and pitch at speed, more for twin hulls at rest with undamped gap resonance.

Heave, roll and pitch depart from the linear solution. Surge, sway and yaw have no
restoring (and the yaw moment of a stream on a slender hull drives it off course):
they keep to it.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.simulation.incident_pressure import ROTATIONS, HullInWaves, rotation
from workbench.simulation.retardation import RadiationOperator
from workbench.time_domain import record_blocks

DEPARTING = ("heave", "roll", "pitch")
"""Modes that depart from the linear solution."""

LARGEST_ROLL, LARGEST_PITCH = np.radians(60.0), np.radians(40.0)
"""Beyond these a ship is taken to be lost [rad]."""

LONGEST_FLIGHT = 0.5
"""Longest time without a wet hull in units of sqrt(L/g) [-], after which a ship is taken to be lost."""

BLOCK = 1024


@dataclass(frozen=True, eq=False)
class DepartureEquation:
    """The linear left side of the equation for the departure of n modes.

    Parameters
    ----------
    modes : numbers of those modes, among heave, roll and pitch.
    mass, stiffness : (n, n) about the centre of gravity, hydrostatic stiffness.
    radiation : operator of these modes about the centre of gravity.
    """

    modes: tuple[int, ...]
    mass: np.ndarray
    stiffness: np.ndarray
    radiation: RadiationOperator


def departures(
    equation: DepartureEquation,
    force: Callable[[int, np.ndarray], np.ndarray],
    steps: int,
) -> np.ndarray:
    """Departure y at every step, (steps, n), from rest.

    Parameters
    ----------
    equation : left side; its radiation operator sets the time step.
    force : right side at a step for a departure there, (step, y) -> (n,).

    Notes
    -----
    Average-acceleration (Newmark) rule on the linear left side, unconditionally
    stable; the right side at the departure extrapolated to second order, so that
    the force is evaluated once a step.
    """
    operator = equation.radiation
    step = operator.time_step
    size, memory = len(equation.mass), len(operator.kernel) - 1
    stiffness = equation.stiffness + operator.stiffness
    damping = operator.damping + operator.kernel[0] * step / 2
    kernel = (
        np.ascontiguousarray(np.moveaxis(operator.kernel[:0:-1], 1, 2)).reshape(memory * size, size) * step
    )
    inverse = np.linalg.inv(
        equation.mass + operator.added_mass + step / 2 * damping + step**2 / 4 * stiffness
    )
    history = np.zeros((2 * memory, size))
    y, velocity = np.zeros(size), np.zeros(size)
    acceleration = inverse @ force(0, y)
    found = np.zeros((steps, size))
    for i in range(1, steps):
        oldest = (i - 1) % memory
        history[oldest] = history[oldest + memory] = velocity
        past = history[oldest + 1 : oldest + 1 + memory].reshape(-1) @ kernel
        right = force(i, y + step * velocity + step**2 / 2 * acceleration)
        y = y + step * velocity + step**2 / 4 * acceleration
        velocity = velocity + step / 2 * acceleration
        acceleration = inverse @ (right - past - damping @ velocity - stiffness @ y)
        y = y + step**2 / 4 * acceleration
        velocity = velocity + step / 2 * acceleration
        found[i] = y
    return found


@dataclass(frozen=True, eq=False)
class SimulatedDeparture:
    """Departure from linear motion (steps, 6) at the centre of gravity, and shares of the time [-].

    Shares: without a wet hull (flying), and with water on the deck of a hull (covered).
    """

    departure: np.ndarray
    flying: float
    covered: float


def simulated_departure(
    equation: DepartureEquation,
    ship: HullInWaves,
    motion_amplitudes: np.ndarray,
    *,
    steps: int,
    lead_in: int,
    progress: Callable[[float, str], None] = lambda fraction, message: None,
) -> SimulatedDeparture:
    """Departure of a ship from its linear motion in the waves of a realisation.

    Parameters
    ----------
    equation : of its departures; ship : its surface in these waves.
    motion_amplitudes : (component, 6) linear motions at the centre of gravity.
    steps : samples wanted from t = 0; lead_in : samples before, over whose first half
        the right side grows from nothing.
    progress : called with the fraction done and a sentence; may raise to cancel.

    Raises
    ------
    InputError where the ship leaves the water or lies over.
    """
    step = equation.radiation.time_step
    frequency = ship.components.component_frequency.values
    wave_force, stiffness, still = ship.wave_force_amplitudes(), ship.stiffness(), ship.at_rest()
    shared = np.concatenate([motion_amplitudes, wave_force, ship.amplitudes()], axis=1)
    shared = shared * np.exp(1j * frequency * lead_in * step)[:, None]
    total = lead_in + steps
    blocks = record_blocks(shared, frequency, (total - 1.5) * step, step, block=BLOCK)
    modes = list(equation.modes)
    state: dict = {"start": 0, "rows": np.zeros((0, shared.shape[1])), "dry": 0}
    flights, covered = np.zeros(total, bool), np.zeros(total, bool)
    deck = ship.surface.upper_vertices
    scale = float(np.sqrt(np.ptp(ship.surface.vertices[:, 0]) / GRAVITY))

    def row(i: int) -> np.ndarray:
        if i >= state["start"] + len(state["rows"]):
            state["start"], block = next(blocks)
            state["rows"] = np.ascontiguousarray(block.T)
            progress(i / total, f"{max(0.0, (i - lead_in) * step):.0f} s of {steps * step:.0f} s")
        return state["rows"][i - state["start"]]

    def force(i: int, y: np.ndarray) -> np.ndarray:
        here = row(i)
        pose = here[:6].astype(float)
        pose[modes] += y
        _check_afloat(pose, (i - lead_in) * step)
        attitude = rotation(*pose[ROTATIONS])
        pressure = ship.pressure(pose, attitude, here[12:])
        whole = ship.turned_force(pressure, attitude)
        covered[i] = (pressure[deck] > 0).any()
        state["dry"] = state["dry"] + 1 if whole[2] <= 0 else 0
        flights[i] = whole[2] <= 0
        if state["dry"] * step > LONGEST_FLIGHT * scale:
            raise InputError(_lost("leaves the water", (i - lead_in) * step))
        growth = min(1.0, 2 * i / max(lead_in, 1))
        return growth * (whole - still - here[6:12] + stiffness @ pose)[modes]

    departure = np.zeros((total, 6))
    departure[:, modes] = departures(equation, force, total)
    progress(1.0, "motions simulated")
    shares = (float(part[lead_in:].mean()) for part in (flights, covered))
    return SimulatedDeparture(departure[lead_in:], *shares)


def _check_afloat(pose: np.ndarray, time: float) -> None:
    """Refuse to go on where the ship lies over or its motions are no numbers."""
    if not abs(pose[3]) < LARGEST_ROLL:
        raise InputError(_lost(f"rolls beyond {np.degrees(LARGEST_ROLL):.0f} degrees", time))
    if not abs(pose[4]) < LARGEST_PITCH:
        raise InputError(_lost(f"pitches beyond {np.degrees(LARGEST_PITCH):.0f} degrees", time))


def _lost(what: str, time: float) -> str:
    """Return the sentence for a ship that the simulation has lost."""
    return (
        f"wave height must let the ship float through the record, in these waves it {what} "
        f"{'before the record starts' if time < 0 else f'{time:.0f} s into the record'}; lower the waves, or choose "
        "the linear simulation."
    )
