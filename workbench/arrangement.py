"""The parts of a design that its shape does not say: `Hull` (how many, where, how afloat) and `WetDeck`."""

import dataclasses
import math
from dataclasses import dataclass

from workbench.errors import InputError
from workbench.hull_shape import HullShape, set_number

LARGEST_HEEL = math.radians(30.0)
LARGEST_TRIM = math.radians(10.0)


@dataclass(frozen=True, kw_only=True)
class Hull:
    """One, two or three hulls and the attitude in which they float.

    Parameters
    ----------
    shape : of one hull, or of the two outer hulls.
    count : 1, 2 or 3 hulls.
    spacing : distance between the centre planes of the outer hulls [m]; 0 for one hull.
    centre_shape : of the centre hull of three; the outer shape if not given.
    centre_x : shift of the centre hull forward of the outer ones [m].
    heel : rotation about +x [rad], positive starboard side down.
    trim : rotation about +y [rad], positive bow down.
    sinkage : how much deeper the ship lies than at its draught [m], positive down.
    """

    shape: HullShape
    count: int = 1
    spacing: float = 0.0
    centre_shape: HullShape | None = None
    centre_x: float = 0.0
    heel: float = 0.0
    trim: float = 0.0
    sinkage: float = 0.0

    def __post_init__(self) -> None:
        for name in ("shape", "centre_shape"):
            part = getattr(self, name)
            if not isinstance(part, HullShape) and not (name == "centre_shape" and part is None):
                raise InputError(
                    f"hull {name} must be a hull shape, got {part!r}; use one of workbench.shapes."
                )
        if isinstance(self.count, bool) or self.count not in (1, 2, 3):
            raise InputError(f"count of hulls must be 1, 2 or 3, got {self.count!r}; choose one of these.")
        object.__setattr__(self, "count", int(self.count))
        length, draught = self.shape.length, self.shape.draught
        set_number(self, "spacing", "spacing between hulls", "m", at_least=0.0, at_most=2.0 * length)
        set_number(self, "centre_x", "shift of the centre hull", "m", at_least=-length, at_most=length)
        set_number(self, "heel", "heel", "rad", at_least=-LARGEST_HEEL, at_most=LARGEST_HEEL)
        set_number(self, "trim", "trim", "rad", at_least=-LARGEST_TRIM, at_most=LARGEST_TRIM)
        freeboard = self.shape.depth - draught
        set_number(
            self, "sinkage", "sinkage", "m", above=-draught, at_most=freeboard,
            cure="stay between hull just out of the water and deck edge awash",
        )  # fmt: skip
        self._check_arrangement()

    def _check_arrangement(self) -> None:
        if self.count == 1 and self.spacing != 0.0:
            raise InputError(
                f"spacing between hulls must be 0 for one hull, got {self.spacing:g} m; "
                "set it to 0 or the count to 2."
            )
        if self.count != 3 and (self.centre_shape is not None or self.centre_x != 0.0):
            raise InputError(
                f"centre hull needs a count of 3, got {self.count}; remove centre_shape and centre_x."
            )
        beams = {2: self.shape.beam, 3: self.shape.beam + (self.centre_shape or self.shape).beam}
        if self.count > 1 and self.spacing <= beams[self.count]:
            raise InputError(
                f"spacing between the centre planes of the outer hulls must be > {beams[self.count]:g} m "
                f"so that they do not touch, got {self.spacing:g} m; widen the spacing or narrow the hulls."
            )

    @property
    def length(self) -> float:
        """Waterline length of the longest hull [m]."""
        return max(self.shape.length, (self.centre_shape or self.shape).length)

    @property
    def beam(self) -> float:
        """Breadth of the whole ship near the waterline [m]."""
        return self.spacing + self.shape.beam

    def scaled(self, factor: float) -> "Hull":
        """Return the geometrically similar hull, `factor` times as long."""
        return dataclasses.replace(
            self,
            shape=self.shape.scaled(factor),
            centre_shape=self.centre_shape and self.centre_shape.scaled(factor),
            spacing=self.spacing * factor,
            centre_x=self.centre_x * factor,
            sinkage=self.sinkage * factor,
        )

    def as_dict(self) -> dict:
        """Return the hull as plain text and numbers."""
        values = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        values["shape"] = self.shape.as_dict()
        values["centre_shape"] = self.centre_shape and self.centre_shape.as_dict()
        return {name: value for name, value in values.items() if value is not None}


@dataclass(frozen=True, kw_only=True)
class WetDeck:
    """The underside of the structure between the hulls.

    Parameters
    ----------
    aft, fore : x of its ends [m].
    width : between its edges, about the centreline [m].
    clearance : height of its flat part above still water [m].
    entry_length, entry_rise : its foremost `entry_length` rises forward by `entry_rise` [m].
    camber : rise of the centreline above the edges, parabolic [m].
    vee_depth, vee_width : pod hanging down in a V about the centreline [m].
    corner_radius : of the quarter circles by which it comes down to the hulls [m].
    centre_bow_length, centre_bow_depth, centre_bow_width : V-shaped body under its foremost part [m].
    trim : of the deck against still water [rad], positive bow down, about x = 0.
    """

    aft: float
    fore: float
    width: float
    clearance: float
    entry_length: float = 0.0
    entry_rise: float = 0.0
    camber: float = 0.0
    vee_depth: float = 0.0
    vee_width: float = 0.0
    corner_radius: float = 0.0
    centre_bow_length: float = 0.0
    centre_bow_depth: float = 0.0
    centre_bow_width: float = 0.0
    trim: float = 0.0

    def __post_init__(self) -> None:
        set_number(self, "aft", "aft end of the wet deck", "m", at_least=-1000.0, at_most=1000.0)
        set_number(
            self, "fore", "fore end of the wet deck", "m", above=self.aft, at_most=1000.0,
            cure="the fore end lies ahead of the aft end",
        )  # fmt: skip
        set_number(self, "width", "width of the wet deck", "m", above=0.0, at_most=300.0)
        set_number(
            self, "clearance", "wet-deck clearance", "m", above=0.0, at_most=100.0,
            cure="the flat part of the wet deck must lie above still water",
        )  # fmt: skip
        length = self.fore - self.aft
        within = {
            "entry_length": length, "entry_rise": 100.0, "camber": 100.0, "vee_depth": 100.0,
            "vee_width": self.width, "corner_radius": self.width / 2, "centre_bow_length": length,
            "centre_bow_depth": 100.0, "centre_bow_width": self.width,
        }  # fmt: skip
        for name, most in within.items():
            set_number(
                self, name, f"{name.replace('_', ' ')} of the wet deck", "m", at_least=0.0, at_most=most
            )
        set_number(self, "trim", "trim of the wet deck", "rad", at_least=-LARGEST_TRIM, at_most=LARGEST_TRIM)
        self._check_clear_of_water()

    def _check_clear_of_water(self) -> None:
        for one, other in (
            ("entry_length", "entry_rise"), ("vee_depth", "vee_width"),
            ("centre_bow_depth", "centre_bow_length"), ("centre_bow_depth", "centre_bow_width"),
        ):  # fmt: skip
            first, second = getattr(self, one), getattr(self, other)
            if (first > 0.0) != (second > 0.0):
                names = f"{one.replace('_', ' ')} and {other.replace('_', ' ')} of the wet deck"
                raise InputError(
                    f"{names} must both be 0 or both > 0 m, got {first:g} and {second:g} m; "
                    "give both or neither."
                )
        hanging = {
            "corner radius": self.corner_radius,
            "V of the pod": max(self.vee_depth - self.camber, 0.0),
            "centre bow": max(self.centre_bow_depth - self.camber, 0.0),
        }
        lower = max(self.fore * math.tan(self.trim), self.aft * math.tan(self.trim), 0.0)
        name = max(hanging, key=lambda part: hanging[part])
        lowest = self.clearance - hanging[name] - lower
        if lowest <= 0.0:
            what = f"{name} and trim" if hanging[name] > 0.0 else "trim"
            raise InputError(
                f"lowest point of the wet deck ({what}) must be above still water, got {lowest:g} m; "
                "raise the clearance or reduce what hangs below it."
            )

    def scaled(self, factor: float) -> "WetDeck":
        """Return the geometrically similar wet deck, `factor` times as long."""
        names = [field.name for field in dataclasses.fields(self) if field.name != "trim"]
        return dataclasses.replace(self, **{name: getattr(self, name) * factor for name in names})

    def as_dict(self) -> dict:
        """Return the wet deck as plain numbers."""
        return dataclasses.asdict(self)
