"""Relative motion as [Baggus2025]_ writes it: eqs. 5.1-5.6, 6.1 and 6.2, printed and repaired, in three readings.

A quantity X is |X| sin(phase - omega t) there, the imaginary part of X exp(-i omega t). The relative distance
counts from the water up to the deck: wet where it is below 0.

Readings of the undisturbed equation 5.1:

- "printed": x in the pitch term and in the phase of the wave both from the centre of gravity. The wave
  sin(k x - omega t) then runs *forward* and pitch counts bow up, while the responses are those of head
  waves with pitch bow down: a mirrored ship, consistent in itself where x is aft.
- "head sea": wave sin(-k x - omega t), pitch term -x. The ship in head waves; that of `workbench.relative_motion`.
- "mixed": phase of the wave from the aft end, as the symbol x_O says, responses at the centre of gravity.

.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from workbench.errors import checked_choice
from workbench.verification import published

READINGS = ("printed", "head sea", "mixed")
FORMS = ("printed", "repaired")

GRAVITY = 9.81
"""Of the source, by its printed digits [m/s2]."""

DRAUGHT = 0.0583
"""Of the model [m] (table 2.2)."""

AFT_TO_CENTRE = 0.544
"""From the aft end to the centre of gravity by table 5.1 [m]."""


@dataclass(frozen=True)
class Response:
    """Heave [m/m] and pitch [rad/m] in one regular wave, by amplitude and phase [rad]."""

    heave: float
    heave_phase: float
    pitch: float
    pitch_phase: float


@dataclass(frozen=True)
class Wave:
    """Amplitude [m] and frequency [rad/s] of a regular wave in deep water."""

    amplitude: float
    omega: float

    @property
    def wavenumber(self) -> float:
        """omega**2/g with g of the source [rad/m]."""
        return self.omega**2 / GRAVITY


@dataclass(frozen=True)
class Point:
    """A point of the deck: x from the centre of gravity, y, and z above the keel [m]."""

    x: float
    y: float
    z: float

    @property
    def gap(self) -> float:
        """Height above still water, z_AG of eq. 5.2 [m]."""
        return self.z - DRAUGHT


def table_response(omega: float) -> Response:
    """Response of table 3.1, its degrees per millimetre made rad/m."""
    row = published.columns("baggus_2025_table_3_1", omega=omega)
    return Response(
        float(row["heave_mm_per_mm"][0]),
        float(row["heave_phase"][0]),
        float(np.radians(row["pitch_deg_per_mm"][0]) * 1000),
        float(row["pitch_phase"][0]),
    )


def table_point(number: int) -> Point:
    """Point of table 5.1."""
    row = published.columns("baggus_2025_table_5_1", point=number)
    return Point(float(row["x_cog"][0]), float(row["y"][0]), float(row["z"][0]))


def pitch_amplitude(wave: Wave, response: Response, tangent: bool = True) -> float:
    """tan(zeta_a RAO_P) of the source, or the angle itself [-]."""
    angle = wave.amplitude * response.pitch
    return float(np.tan(angle)) if tangent else angle


def motion_amplitude(
    point: Point, wave: Wave, response: Response, reading: str, tangent: bool = True
) -> complex:
    """Complex amplitude of the point's rise: the heave and pitch terms of eqs. 5.1, 5.5 and 6.1 [m]."""
    checked_choice("reading of the equation", reading, READINGS)
    side = -1.0 if reading == "head sea" else 1.0
    pitch = pitch_amplitude(wave, response, tangent) * np.exp(1j * response.pitch_phase)
    return complex(
        wave.amplitude * response.heave * np.exp(1j * response.heave_phase) + side * point.x * pitch
    )


def wave_amplitude(point: Point, wave: Wave, reading: str) -> complex:
    """Complex amplitude of the undisturbed wave at the point in eq. 5.1 [m]."""
    checked_choice("reading of the equation", reading, READINGS)
    x = {"printed": point.x, "head sea": -point.x, "mixed": point.x + AFT_TO_CENTRE}[reading]
    return complex(wave.amplitude * np.exp(1j * wave.wavenumber * x))


def distance_amplitude(
    point: Point, wave: Wave, response: Response, reading: str, tangent: bool = True
) -> complex:
    """Complex amplitude of the relative distance in the undisturbed wave (eq. 5.1) [m]."""
    return motion_amplitude(point, wave, response, reading, tangent) - wave_amplitude(point, wave, reading)


def relative_distance(point: Point, wave: Wave, response: Response, reading: str, time) -> np.ndarray:
    """Relative distance in the undisturbed wave at instants [s] (eqs. 5.1 and 5.2) [m]."""
    return _in_time(distance_amplitude(point, wave, response, reading), wave, time) + point.gap


def relative_velocity(
    point: Point, wave: Wave, response: Response, reading: str, time, form: str = "repaired"
) -> np.ndarray:
    """Rate of the relative distance (eq. 5.3) [m/s].

    ``form`` "printed" has the wave's term with the wrong sign; the repaired one is the derivative of 5.1,
    and agrees with the sign of eqs. 5.6 and 6.2.
    """
    sign = -1.0 if checked_choice("form of the equation", form, FORMS) == "printed" else 1.0
    motion = motion_amplitude(point, wave, response, reading)
    return _rate(motion - sign * wave_amplitude(point, wave, reading), wave, time)


def relative_angle(point: Point, wave: Wave, response: Response, reading: str, time) -> np.ndarray:
    """Pitch, bow up, less slope of the undisturbed wave (eq. 5.4) [rad]; in the head sea both change sign."""
    pitch = wave.amplitude * response.pitch * np.sin(response.pitch_phase - wave.omega * np.asarray(time))
    wave_phase = np.angle(wave_amplitude(point, wave, reading)) - wave.omega * np.asarray(time)
    slope = np.arctan(wave.amplitude * wave.wavenumber * np.cos(wave_phase))
    return slope - pitch if reading == "head sea" else pitch - slope


def disturbed_distance(
    point: Point,
    waves: Sequence[Wave],
    responses: Sequence[Response],
    elevations: Sequence[complex],
    reading: str,
    time,
    form: str = "repaired",
) -> np.ndarray:
    """Relative distance in one or more disturbed waves (eqs. 5.5 and 6.1) [m].

    Parameters
    ----------
    elevations : disturbed elevation at the point per wave amplitude, complex, one a wave.
    reading : of the pitch term, "head sea" or, as printed, any other.
    form : "printed" gives each wave the phase k x_O - omega t of the undisturbed one, and to all the
        frequency of the first, although eq. 6.2 differentiates the phase of the disturbed wave.
    """
    checked_choice("form of the equation", form, FORMS)
    total = np.full(np.shape(time), point.gap)
    for wave, response, elevation in zip(waves, responses, elevations, strict=True):
        total = total + _in_time(motion_amplitude(point, wave, response, reading), wave, time)
        if form == "repaired":
            total = total - _in_time(wave.amplitude * elevation, wave, time)
            continue
        phase = wave.wavenumber * (point.x + AFT_TO_CENTRE) - waves[0].omega * np.asarray(time)
        total = total - wave.amplitude * abs(elevation) * np.sin(phase)
    return total


def disturbed_velocity(
    point: Point,
    waves: Sequence[Wave],
    responses: Sequence[Response],
    elevations: Sequence[complex],
    reading: str,
    time,
) -> np.ndarray:
    """Rate of the relative distance in one or more disturbed waves (eqs. 5.6 and 6.2) [m/s]."""
    return sum(
        _rate(motion_amplitude(point, wave, response, reading) - wave.amplitude * elevation, wave, time)
        for wave, response, elevation in zip(waves, responses, elevations, strict=True)
    )


def _in_time(amplitude: complex, wave: Wave, time) -> np.ndarray:
    return np.imag(amplitude * np.exp(-1j * wave.omega * np.asarray(time, float)))


def _rate(amplitude: complex, wave: Wave, time) -> np.ndarray:
    return _in_time(-1j * wave.omega * amplitude, wave, time)
