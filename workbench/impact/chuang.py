"""Chuang's prediction of cross-structure slamming pressure [Chuang1975]_.

The source works in feet, slugs and psi: ``p[psi] = k rho[slug/ft3] V_n[ft/s]**2``
with the conversion 1/144 inside k. In SI the same law is
``p[Pa] = 144 k rho[kg/m3] V_n[m/s]**2``.

Signs here are the source's: angles bow **up** positive, wave slope positive where
the surface rises towards the bow, velocities of the ship and of the surface
positive downward. With these the impact angle is |pitch - slope|; the printed
eq. (3) adds magnitudes and holds for a bow-down ship on a rising wave alone.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975.
"""

from typing import NamedTuple

import numpy as np

from workbench.errors import checked_choice

SQUARE_INCHES_PER_SQUARE_FOOT = 144.0
SMALL_ANGLE_LAWS = ("program", "text")
"""Below 2.2 degrees the source gives two laws: its computer program's (used for all its tables) and eq. (2)'s."""

_MIDDLE = (2.1820894, -0.9451815, 0.2037541, -0.0233896, 0.0013578, -0.00003132)
_STEEP = (4.748742, -1.3450284, 0.1576516, -0.0092976, 0.0002735, -0.00000319864)


def impact_coefficient(impact_angle, small_angle_law: str = "program") -> np.ndarray:
    """Pressure constant k of the "three-dimensional prediction" line [-] ([Chuang1975]_ eq. 2).

    Parameters
    ----------
    impact_angle : angle between hull surface and wave surface [rad]; the modulus counts.
    small_angle_law : below 2.2 degrees, "program" (linear, k(0) = 0.5) or "text"
        (quadratic, k(0) = 0.32).

    Notes
    -----
    Largest (0.870) at 2.2 degrees; towards 0 the air cushion lowers it. From 20
    degrees up it is Wagner's wedge times 0.7686. Fitted to drop tests on calm
    water for flat-bottomed bodies.
    """
    checked_choice("small_angle_law", small_angle_law, SMALL_ANGLE_LAWS)
    angle = np.abs(np.asarray(impact_angle, float))
    xi = np.degrees(angle)
    if small_angle_law == "program":
        small = 0.5 + 0.37 * xi / 2.2
    else:
        small = 0.045833 * xi**2 + 0.149167 * xi + 0.32
    middle = np.polynomial.polynomial.polyval(np.clip(xi, 2.2, 11.0), _MIDDLE)
    steep = np.polynomial.polynomial.polyval(np.clip(xi, 11.0, 20.0), _STEEP)
    with np.errstate(divide="ignore"):
        tangent = np.tan(np.minimum(np.where(xi >= 20, angle, np.radians(20)), np.pi / 2 - 1e-12))
    wedge = 0.76856471 * (1 + 2.4674 / tangent**2) / 288
    return np.select([xi < 2.2, xi < 11, xi < 20], [small, middle, steep], wedge)


def impact_pressure(normal_velocity, impact_angle, density, small_angle_law: str = "program"):
    """Peak impact pressure 144 k rho V_n**2 [Pa] ([Chuang1975]_ eq. 1) from velocity [m/s], angle [rad], density."""
    k = impact_coefficient(impact_angle, small_angle_law)
    return SQUARE_INCHES_PER_SQUARE_FOOT * k * density * np.square(normal_velocity)


def planing_pressure(tangential_velocity, density):
    """Planing pressure rho V_t**2/2 [Pa] ([Chuang1975]_ eq. 4)."""
    return density * np.square(tangential_velocity) / 2


class Prediction(NamedTuple):
    """Velocities [m/s], impact angle [rad], k [-] and pressures [Pa] of Method I or II."""

    normal_velocity: np.ndarray
    tangential_velocity: np.ndarray
    impact_angle: np.ndarray
    coefficient: np.ndarray
    impact_pressure: np.ndarray
    planing_pressure: np.ndarray
    total_pressure: np.ndarray


def method_one(
    heave_velocity,
    wave_velocity,
    pitch_velocity,
    pitch,
    wave_slope,
    density,
    roll=0.0,
    small_angle_law: str = "program",
    trim=0.0,
) -> Prediction:
    """Peak pressure by wave-surface kinematics ([Chuang1975]_ eqs 5-7, Method I).

    Parameters
    ----------
    heave_velocity, wave_velocity, pitch_velocity : downward positive [m/s]; of the
        centre of gravity, of the water surface at the moving impact point, and
        pitch rate times lever.
    pitch : bow-**up** positive, as in the source [rad]; wave_slope : positive where the
        surface rises towards the bow [rad].
    density : [kg/m3]; roll : [rad].
    trim : of a sloping deck against the ship's base, bow up positive [rad]; added to the pitch.

    Notes
    -----
    Head seas, flat bottom. The impact angle is |pitch - slope|, with roll by the
    square root of squares that the source's full-scale table obeys. The
    velocities do not depend on units: with ft/s they come in ft/s. The source adds
    the trim in the impact angle alone and gives no formula; here the deck's whole
    attitude takes the place of the pitch, so that the vertical velocity still comes
    out where the wave has no slope.
    """
    attitude = np.asarray(pitch, float) + trim
    velocity = (np.asarray(heave_velocity) - wave_velocity) * np.cos(attitude) + pitch_velocity
    normal, tangential, angle = on_wave_surface(velocity, attitude, wave_slope, roll)
    return predicted(normal, tangential, angle, density, small_angle_law)


def pitch_velocity(pitch_rate, lever):
    """Velocity of the impact point by pitching, downward positive [m/s] ([Chuang1975]_ eq. 6).

    Parameters
    ----------
    pitch_rate : bow-up positive [rad/s]; lever : from the centre of gravity forward to the impact point [m].
    """
    return -np.asarray(pitch_rate) * lever


def on_wave_surface(velocity, attitude, wave_slope, roll=0.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Velocity normal to the hull [m/s] resolved on the wave surface ([Chuang1975]_ eq. 7).

    Returns
    -------
    Velocity normal to the wave surface, with the factor 1/cos(attitude)**2 that refers
    it to the vertical velocity of the drop tests behind k; velocity along it, with
    the sign of attitude - slope (without roll); impact angle [rad].
    """
    difference = np.asarray(attitude) - np.asarray(wave_slope)
    angle = np.hypot(difference, roll)
    normal = velocity * np.cos(angle) / np.cos(attitude) ** 2
    tangential = velocity * np.sin(np.where(np.asarray(roll) == 0, difference, angle))
    return normal, tangential, angle


def predicted(normal, tangential, angle, density, small_angle_law: str = "program") -> Prediction:
    """Pressures of velocities [m/s] normal to and along the wave surface ([Chuang1975]_ eqs 1-5)."""
    impact = impact_pressure(normal, angle, density, small_angle_law)
    planing = planing_pressure(tangential, density)
    k = impact_coefficient(angle, small_angle_law)
    return Prediction(normal, tangential, angle, k, impact, planing, impact + planing)


def back_calculated_coefficient(recorded_pressure, method: Prediction, density):
    """Pressure constant k [-] that a recorded total peak pressure [Pa] implies."""
    impact = np.asarray(recorded_pressure) - method.planing_pressure
    return impact / (SQUARE_INCHES_PER_SQUARE_FOOT * density * method.normal_velocity**2)
