"""What a towing tank allows: waves reflected by its walls, its depth, and enough encounters in a run.

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, 6.2 and 7.2.
.. [Lloyd1989] A. R. J. M. Lloyd, "Seakeeping: ship behaviour in rough weather", 1989.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY, encounter_frequency
from workbench.errors import InputError, checked_number

LONGEST_OVER_DEPTH = 1.3
"""Longest wave over depth that the bottom leaves alone, as [Couser1996]_ 6.2 states it; 2 is the usual rule."""

REGULAR_ENCOUNTERS = 6
"""Waves to record in regular waves, after as many have been let by ([Couser1996]_ 6.2)."""

IRREGULAR_ENCOUNTERS = 100
"""Encounters that statistics of an irregular sea want; runs may be added up ([Couser1996]_ 6.2)."""


@dataclass(frozen=True, kw_only=True)
class Tank:
    """A towing tank: breadth, depth and length of run [m]; those of Southampton unless given ([Couser1996]_ 4.3)."""

    breadth: float = 3.7
    depth: float = 1.8
    run: float = 15.24

    def __post_init__(self):
        for name in ("breadth", "depth", "run"):
            checked_number(name, getattr(self, name), "m", above=0)


def _wave_unit(omega: float, length: float) -> float:
    """sqrt(g/L)/(2 omega) [-], the Froude number of half the wave's speed."""
    checked_number("omega", omega, "rad/s", above=0)
    checked_number("length", length, "m", above=0)
    return float(np.sqrt(GRAVITY / length) / (2 * omega))


def least_froude_head(omega: float, length: float, breadth: float) -> float:
    """Least Froude number in head seas at which waves off the walls miss the model [-].

    Parameters
    ----------
    omega : wave frequency [rad/s]; length : of the model; breadth : of the tank [m].

    Notes
    -----
    A radiated wave runs at g/omega_e to the wall and back, a way of the tank's breadth,
    while the model must advance its length: u omega_e >= g L/B. Hence
    (sqrt(1 + 4 L/B) - 1) sqrt(g/L)/(2 omega); 6.2 is printed with the bracket under the
    root, which is then of a negative number ([Couser1996]_, repaired after [Lloyd1989]_).
    """
    return _wave_unit(omega, length) * (
        np.sqrt(1 + 4 * length / checked_number("breadth", breadth, "m", above=0)) - 1
    )


@dataclass(frozen=True, kw_only=True)
class FollowingLimits:
    """Froude numbers free of wall reflections in following seas.

    ``band`` : (least, most) while the waves overtake the model; None for models longer
    than a quarter of the breadth, which have none. ``overtaking`` : least Froude number
    of a model that overtakes the waves.
    """

    band: tuple[float, float] | None
    overtaking: float


def following_limits(omega: float, length: float, breadth: float) -> FollowingLimits:
    """Froude numbers at which waves off the walls miss the model in following seas.

    Notes
    -----
    The criterion of `least_froude_head` with omega_e = |omega - omega^2 u/g|. The source
    prints one bound, sqrt(g/L)/(2 omega) (1 + sqrt(1 - 4 L/B)), as a least one (6.3); by
    the derivation that is the *upper* end of the band below the wave's speed, and
    beyond it the bound is with + under the root. Both are given; see `printed_following`.
    """
    unit = _wave_unit(omega, length)
    ratio = 4 * length / checked_number("breadth", breadth, "m", above=0)
    band = None
    if ratio <= 1:
        band = (unit * (1 - np.sqrt(1 - ratio)), unit * (1 + np.sqrt(1 - ratio)))
    return FollowingLimits(band=band, overtaking=unit * (1 + np.sqrt(1 + ratio)))


def printed_following(omega: float, length: float, breadth: float) -> float:
    """Least Froude number in following seas as 6.3 is printed [-]; exists for models below a quarter of the breadth."""
    if 4 * length > breadth:
        raise InputError(
            f"length must be at most a quarter of the breadth, {breadth / 4:g} m, "
            f"for the printed limit, got {length:g} m."
        )
    return _wave_unit(omega, length) * (1 + np.sqrt(1 - 4 * length / breadth))


def longest_wave(depth: float, ratio: float = LONGEST_OVER_DEPTH) -> float:
    """Longest wave that the bottom leaves alone [m].

    The same source runs waves of 4.5 m in 1.8 m of water: 2.5 times the depth, at which
    the wave is 1 % shorter than in deep water.
    """
    return checked_number("ratio", ratio, above=0) * checked_number("depth", depth, "m", above=0)


def encounters(omega: float, speed: float, run: float, wave_direction: float = np.pi) -> float:
    """Waves met in a run of a length [-], omega_e run/(2 pi u)."""
    checked_number("speed", speed, "m/s", above=0)
    checked_number("run", run, "m", above=0)
    return float(abs(encounter_frequency(omega, speed, wave_direction)) * run / (2 * np.pi * speed))


def tank_report(
    omega: float, froude: float, length: float, tank: Tank | None = None
) -> dict[str, float | bool]:
    """Whether a run in regular head seas is free of the tank, with the figures behind it.

    Parameters
    ----------
    omega : wave frequency [rad/s]; froude : on ``length``, of the model [m].
    """
    tank = tank or Tank()
    least = least_froude_head(omega, length, tank.breadth)
    wave = 2 * np.pi * GRAVITY / omega**2
    met = encounters(omega, checked_number("froude", froude, above=0) * np.sqrt(GRAVITY * length), tank.run)
    return {
        "least_froude_number": least,
        "clear_of_walls": froude >= least,
        "wavelength": wave,
        "longest_wave": longest_wave(tank.depth),
        "clear_of_bottom": wave <= longest_wave(tank.depth),
        "encounters": met,
        "enough_regular": met >= 2 * REGULAR_ENCOUNTERS,
        "runs_for_statistics": int(np.ceil(IRREGULAR_ENCOUNTERS / met)),
    }
