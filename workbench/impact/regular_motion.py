"""Chuang's prediction for a ship in a regular head wave, from amplitudes and phases of heave and pitch.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, p. 34 ("by trigonometrical
    equations if the motions are assumed to be sinusoidal"; none is printed, these are ours).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.impact import chuang
from workbench.impact.pressure import PressureLaw, velocity_notes
from workbench.impact.regular_wave import RegularWave, celerity
from workbench.impact.stavovy_chuang import PREDICTED
from workbench.motions import interpolated_motions

HEAD_SEA_BAND = np.radians(1.0)
"""Largest departure from head seas; other headings were not investigated by [Chuang1975]_ [rad]."""

FLAT_BAND = np.radians(1.0)
"""Largest transverse slope of a deck that counts as flat [rad]."""


class Instant(NamedTuple):
    """What Method I wants at an instant: velocities downward [m/s], angles bow up and rising to the bow [rad]."""

    heave_velocity: np.ndarray
    surface_velocity: np.ndarray
    pitch_velocity: np.ndarray
    pitch: np.ndarray
    wave_slope: np.ndarray


@dataclass(frozen=True, kw_only=True)
class RegularMotion:
    """Heave and pitch of a ship in a regular head wave.

    Parameters
    ----------
    wave : with the speed of the ship; a crest is at the centre of gravity at time 0.
    heave_amplitude : upward, at the centre of gravity [m].
    pitch_amplitude : bow **up** [rad].
    heave_lead, pitch_lead : over the wave at the centre of gravity [rad]; heave is
        ``heave_amplitude cos(omega_e t + heave_lead)``.
    """

    wave: RegularWave
    heave_amplitude: float
    heave_lead: float
    pitch_amplitude: float
    pitch_lead: float

    def __post_init__(self):
        checked_number("heave amplitude", self.heave_amplitude, "m", at_least=0)
        checked_number("pitch amplitude", self.pitch_amplitude, "rad", at_least=0, below=np.pi / 4)
        checked_number("heave lead", self.heave_lead, "rad")
        checked_number("pitch lead", self.pitch_lead, "rad")

    def at(self, time, lever) -> Instant:
        """State at times [s] and levers forward of the centre of gravity [m] (broadcast)."""
        turn = self.wave.encounter_frequency * np.asarray(time, float)
        omega, place = self.wave.encounter_frequency, self.wave.wavenumber * np.asarray(lever, float)
        heave, pitch = turn + self.heave_lead, turn + self.pitch_lead
        return Instant(
            omega * self.heave_amplitude * np.sin(heave),
            omega * self.wave.amplitude * np.sin(place + turn),
            chuang.pitch_velocity(-omega * self.pitch_amplitude * np.sin(pitch), lever),
            self.pitch_amplitude * np.cos(pitch),
            np.arctan(-self.wave.largest_slope * np.sin(place + turn)),
        )

    def point_motion(self, lever) -> np.ndarray:
        """Phasor of the upward motion of points [m], leading by its angle."""
        heave = self.heave_amplitude * np.exp(1j * self.heave_lead)
        return heave + np.asarray(lever, float) * self.pitch_amplitude * np.exp(1j * self.pitch_lead)

    def relative_motion(self, lever) -> np.ndarray:
        """Phasor of the rise of the water towards points moving with the ship [m], leading by its angle."""
        place = self.wave.wavenumber * np.asarray(lever, float)
        return self.wave.amplitude * np.exp(1j * place) - self.point_motion(lever)

    def impact_instant(self, lever, clearance) -> np.ndarray:
        """Time at which the water reaches points, in [0, period of encounter) [s]; NaN where it does not.

        Parameters
        ----------
        lever : forward of the centre of gravity; clearance : in still water, > 0 (broadcast) [m].
        """
        clearance = np.asarray(clearance, float)
        if np.any(clearance <= 0):
            raise InputError(
                f"clearance must be > 0 m, got {clearance.min():g} m; a deck in still water does not slam."
            )
        relative = self.relative_motion(lever)
        with np.errstate(invalid="ignore", divide="ignore"):
            before_crest = np.arccos(clearance / np.abs(relative))
        return (-np.angle(relative) - before_crest) % (2 * np.pi) / self.wave.encounter_frequency


def regular_motion(motion_set: xr.Dataset, omega: float, wave_amplitude: float) -> RegularMotion:
    """Heave and pitch in a regular head wave from motions per wave amplitude.

    Parameters
    ----------
    motion_set : from `workbench.motions.motions`, with head seas among its directions.
    omega : wave frequency, between those of the table [rad/s]; wave_amplitude : [m].
    """
    nodes = motion_set.omega.values
    checked_number("wave frequency", omega, "rad/s", at_least=float(nodes[0]), at_most=float(nodes[-1]))
    away = np.abs((motion_set.wave_direction.values - np.pi + np.pi) % (2 * np.pi) - np.pi)
    head = int(np.argmin(away))
    if away[head] > HEAD_SEA_BAND:
        raise InputError(
            "Chuang's method is for head seas, direction pi, but the nearest direction of these motions is "
            f"{motion_set.wave_direction.values[head]:.3g} rad; compute the motions in head seas."
        )
    centre = motion_set.attrs["centre_of_gravity"]
    found = interpolated_motions(motion_set, np.array([omega]))[0, head]
    along = centre[0] * np.cos(motion_set.wave_direction.values[head])
    crest = np.exp(1j * omega**2 / (2 * np.pi * float(celerity(1.0))) * along)
    heave, pitch = found[2] / crest, -found[4] / crest
    wave = RegularWave(
        amplitude=wave_amplitude, period=2 * np.pi / omega, speed=float(motion_set.attrs["speed"])
    )
    return RegularMotion(
        wave=wave,
        heave_amplitude=float(np.abs(heave)) * wave_amplitude,
        heave_lead=float(-np.angle(heave)),
        pitch_amplitude=float(np.abs(pitch)) * wave_amplitude,
        pitch_lead=float(-np.angle(pitch)),
    )


def regular_wave_slams(
    motion: RegularMotion,
    deck: xr.Dataset,
    centre_x: float,
    density: float,
    small_angle_law: str = "program",
) -> xr.Dataset:
    """Chuang's prediction at every point of a deck that a regular head wave reaches (x, y).

    Parameters
    ----------
    motion : of the ship; deck : from `workbench.geometry.wet_deck.wet_deck_grid`.
    centre_x : of the centre of gravity, forward of amidships [m]; density : [kg/m3].

    Returns
    -------
    Dataset (x, y): ``event_time`` after the crest passed the centre of gravity, the
    inputs of Method I and its outputs up to ``peak_pressure`` [Pa]; NaN where the water
    does not reach the deck.

    Notes
    -----
    Undisturbed wave, first closing of the clearance in a period, each point by itself:
    what a slam elsewhere does to the wave and the ship is left out. A velocity away from
    the water, possible under a steeply raked deck, makes no pressure.
    """
    lever = deck.x.values[:, None] - centre_x
    trim = np.arctan(deck.slope_x.values)
    instant = motion.impact_instant(lever, deck.height.values)
    state = motion.at(instant, lever)
    found = chuang.method_one(*state, density, small_angle_law=small_angle_law, trim=trim)
    closes = ~(found.normal_velocity < 0)
    found = chuang.Prediction(*found[:4], *(np.where(closes, pressure, 0.0) for pressure in found[4:]))
    dims = ("x", "y")
    notes = list(quantities.warnings_of(deck))
    notes.append(
        "Head seas, the undisturbed wave, local peaks of some milliseconds: not the load of a panel."
    )
    if float(np.abs(np.arctan(deck.slope_y.values)).max()) > FLAT_BAND:
        notes.append("The deck slopes across, which Chuang's method for flat bottoms leaves out.")
    if np.isfinite(found.normal_velocity).any():
        notes += velocity_notes(PressureLaw(), float(np.nanmax(found.normal_velocity)))
    inputs = dict(zip(Instant._fields, np.broadcast_arrays(*state), strict=True))
    attitude = inputs.pop("pitch") + trim
    return quantities.dataset(
        {"x": deck.x, "y": deck.y},
        method=f"Chuang, Method I, small-angle law of the {small_angle_law}",
        warnings=notes,
        attrs={"speed": motion.wave.speed, "density": float(density)},
        event_time=(dims, instant),
        attitude=(dims, attitude),
        **{name: (dims, values) for name, values in inputs.items()},
        **{name: (dims, values) for name, values in zip(PREDICTED, found, strict=True)},
    )
