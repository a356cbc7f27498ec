"""Sails of a ship and the wind that they stand in."""

import dataclasses
from dataclasses import dataclass

import numpy as np

from workbench.errors import InputError, checked_number
from workbench.hull_shape import set_number

AIR_DENSITY = 1.225
"""Density of air at 15 degrees Celsius, ISO 2533 [kg/m3]."""

GAUSS_NODES = 6
"""Points of quadrature on each straight piece of the chord."""


@dataclass(frozen=True, kw_only=True)
class SailPlan:
    """Chord of the sails over height, and their lift coefficient, close-hauled.

    Parameters
    ----------
    heights : above still water [m], rising; at least two.
    chords : sum of the chords of the sails at these heights [m]; straight in between.
    lift_coefficient : of the sails on the area of the plan, constant over height and time [-].
    air_density : [kg/m3].
    """

    heights: tuple[float, ...]
    chords: tuple[float, ...]
    lift_coefficient: float
    air_density: float = AIR_DENSITY

    def __post_init__(self) -> None:
        for name, at_least in (("heights", 0.0), ("chords", 0.0)):
            object.__setattr__(self, name, _numbers(name, getattr(self, name), at_least))
        if len(self.heights) != len(self.chords) or len(self.heights) < 2:
            raise InputError(
                f"heights and chords of the sails must be as many, at least two, got {len(self.heights)} and "
                f"{len(self.chords)}; give a chord for every height."
            )
        if any(b <= a for a, b in zip(self.heights, self.heights[1:], strict=False)):
            raise InputError(f"heights of the sails must rise, got {self.heights}; put them in order.")
        if not any(self.chords):
            raise InputError("chords of the sails must not all be 0 m; give one that is wider.")
        set_number(self, "lift_coefficient", "lift coefficient of the sails", above=0.0, at_most=5.0)
        set_number(self, "air_density", "density of the air", "kg/m3", at_least=0.5, at_most=2.0)

    @property
    def area(self) -> float:
        """Area of the sails [m2]."""
        return self.moment(0)

    @property
    def centre_height(self) -> float:
        """Height of the centre of the area above still water [m]."""
        return self.moment(1) / self.moment(0)

    def moment(self, power: int) -> float:
        """Integral of the chord times height to the power, over the height [m**(2 + power)]."""
        heights, widths = self.quadrature()
        return float(np.sum(widths * heights**power))

    def quadrature(self) -> tuple[np.ndarray, np.ndarray]:
        """Heights (n,) [m] and areas (n,) [m2] of the strips of a Gauss quadrature over the plan."""
        nodes, weights = np.polynomial.legendre.leggauss(GAUSS_NODES)
        low, high = np.array(self.heights[:-1])[:, None], np.array(self.heights[1:])[:, None]
        heights = ((high + low) / 2 + (high - low) / 2 * nodes).ravel()
        areas = ((high - low) / 2 * weights).ravel() * np.interp(heights, self.heights, self.chords)
        return heights, areas

    def scaled(self, factor: float) -> "SailPlan":
        """Return the geometrically similar sails, `factor` times as high."""
        return dataclasses.replace(
            self,
            heights=tuple(height * factor for height in self.heights),
            chords=tuple(chord * factor for chord in self.chords),
        )

    def as_dict(self) -> dict:
        """Return the plan as plain numbers."""
        return dataclasses.asdict(self)


def tapered_sail_plan(
    foot: float, head: float, lowest: float, highest: float, lift_coefficient: float
) -> SailPlan:
    """Sail plan with a chord that goes straight from `foot` at height `lowest` to `head` at `highest` [m]."""
    return SailPlan(heights=(lowest, highest), chords=(foot, head), lift_coefficient=lift_coefficient)


@dataclass(frozen=True, kw_only=True)
class TrueWind:
    """Wind over the water.

    Parameters
    ----------
    speed : [m/s].
    direction : where the wind goes [rad], counted like the wave direction: 0 from astern, pi from ahead,
        pi/2 from starboard. None: it blows where the waves go, whichever that is.
    """

    speed: float
    direction: float | None = None

    def __post_init__(self) -> None:
        set_number(self, "speed", "wind speed", "m/s", at_least=0.0, at_most=60.0)
        if self.direction is not None:
            set_number(self, "direction", "wind direction", "rad", at_least=-7.0, at_most=7.0)

    def apparent(self, boat_speed: float, wave_directions) -> tuple[np.ndarray, np.ndarray]:
        """Wind that the ship feels: parts towards the stern and towards port [m/s], shaped as `wave_directions`.

        V1 = U - V0 cos(direction) and V2 = V0 sin(direction). With the true wind
        angle from the bow, pi - direction, these are the V1 and V2 of
        K. Grande, MSc thesis, Curtin University of Technology, 2002, 2.33-2.34.
        """
        waves = np.asarray(wave_directions, float)
        direction = waves if self.direction is None else np.full_like(waves, self.direction)
        return boat_speed - self.speed * np.cos(direction), self.speed * np.sin(direction)

    def as_dict(self) -> dict:
        """Return the wind as plain numbers; a direction that is None is left out."""
        return {name: value for name, value in dataclasses.asdict(self).items() if value is not None}


def _numbers(name: str, given: object, at_least: float) -> tuple[float, ...]:
    """Return a table as a tuple of floats."""
    if isinstance(given, str | bytes) or not hasattr(given, "__iter__"):
        raise InputError(f"{name} of the sails must be a list of numbers in m, got {given!r}; give one.")
    return tuple(
        checked_number(f"{name} of the sails", number, "m", at_least=at_least, at_most=500.0)
        for number in given
    )
