"""Lifting surfaces under a hull: foils that stand free, and fins that stand on the hull."""

import dataclasses
import math
from dataclasses import dataclass
from typing import ClassVar

from workbench.errors import InputError, checked_number
from workbench.hull_shape import set_number


@dataclass(frozen=True, kw_only=True)
class LiftingSurface:
    """What foils and fins have in common; use `Foil` or `Fin`.

    Parameters
    ----------
    name : for messages.
    area : of the plan [m2].
    span : from tip to tip, or from root to tip of a fin [m].
    position : (x, y, z) of the quarter-chord point at mid span [m], in ship axes.
    cant : angle of the span above the horizontal [rad], towards +y: 0 lies flat, pi/2 stands upright.
    sweep : of the quarter-chord line [rad].
    pair : there is a second one, its mirror image in the centre plane.
    lift_slope : of the whole surface on its area [1/rad]; None takes it from the aspect ratio.
    """

    kind: ClassVar[str] = ""
    images: ClassVar[int] = 1
    """Spans that count for the aspect ratio: 2 where the hull acts as a mirror."""

    name: str
    area: float
    span: float
    position: tuple[float, float, float]
    cant: float = 0.0
    sweep: float = 0.0
    pair: bool = False
    lift_slope: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name.strip():
            raise InputError(f"name of an appendage must be text, got {self.name!r}; give it a name.")
        label = self.name
        set_number(self, "area", f"area of {label}", "m2", above=0.0, at_most=1e4)
        set_number(self, "span", f"span of {label}", "m", above=0.0, at_most=100.0)
        set_number(self, "cant", f"cant of {label}", "rad", at_least=-math.pi / 2, at_most=math.pi / 2)
        set_number(self, "sweep", f"sweep of {label}", "rad", at_least=-1.3, at_most=1.3)
        if self.lift_slope is not None:
            set_number(self, "lift_slope", f"lift slope of {label}", "1/rad", at_least=0.0, at_most=10.0)
        if not isinstance(self.pair, bool):
            raise InputError(f"pair of {label} must be true or false, got {self.pair!r}; give one of them.")
        object.__setattr__(self, "position", self._checked_position())

    def _checked_position(self) -> tuple[float, float, float]:
        given = self.position
        if isinstance(given, str | bytes) or not hasattr(given, "__iter__") or len(tuple(given)) != 3:
            raise InputError(
                f"position of {self.name} must be three numbers (x, y, z) in m, got {given!r}; give all three."
            )
        x, y, z = (
            checked_number(f"{axis} of {self.name}", number, "m", at_least=-1000.0, at_most=1000.0)
            for axis, number in zip("xyz", given, strict=True)
        )
        highest = z + self.span / 2 * abs(math.sin(self.cant))
        if z >= 0.0 or highest > 1e-6 * self.span:
            raise InputError(
                f"highest point of {self.name} must be under water, got {highest:.4g} m above still water; "
                "z of its position is that of its mid span, negative below still water."
            )
        if self.pair and y == 0.0:
            raise InputError(
                f"y of {self.name} must not be 0 m for a pair; place one of the two beside the centre plane."
            )
        return x, y, z

    @property
    def chord(self) -> float:
        """Mean chord [m]."""
        return self.area / self.span

    @property
    def aspect_ratio(self) -> float:
        """Effective aspect ratio [-], with the image in the hull for a fin."""
        return self.images * self.span**2 / self.area

    def placed(self) -> tuple["LiftingSurface", ...]:
        """Return this surface alone, or both of a pair."""
        if not self.pair:
            return (self,)
        x, y, z = self.position
        one = dataclasses.replace(self, pair=False)
        return one, dataclasses.replace(one, position=(x, -y, z), cant=-self.cant)

    def scaled(self, factor: float) -> "LiftingSurface":
        """Return the geometrically similar surface, `factor` times as long."""
        return dataclasses.replace(
            self,
            area=self.area * factor**2,
            span=self.span * factor,
            position=tuple(value * factor for value in self.position),
        )

    def as_dict(self) -> dict:
        """Return the surface as plain text and numbers; what is None is left out."""
        values = {"kind": self.kind, **dataclasses.asdict(self)}
        return {name: value for name, value in values.items() if value is not None}


@dataclass(frozen=True, kw_only=True)
class Foil(LiftingSurface):
    """A surface with two free tips, such as a T-foil on its strut; it lies flat unless canted."""

    kind: ClassVar[str] = "foil"


@dataclass(frozen=True, kw_only=True)
class Fin(LiftingSurface):
    """A surface that stands on the hull, which mirrors it: daggerboard, rudder, skeg, fin. Upright unless canted."""

    kind: ClassVar[str] = "fin"
    images: ClassVar[int] = 2
    cant: float = math.pi / 2


APPENDAGES: dict[str, type[LiftingSurface]] = {"foil": Foil, "fin": Fin}
"""Kinds of appendages by their word in a file."""
