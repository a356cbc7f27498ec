"""A design: hull, wet deck, masses, appendages and sails. Frozen, validated, hashable, and plain enough for a file.

A variant is `dataclasses.replace(design, wet_deck=...)`; a model of it is
`design.scaled(1 / 30)`. Meshes are made from a design by `workbench.geometry`
and never kept in it.
"""

import dataclasses
from dataclasses import dataclass

from workbench.appendages import APPENDAGES, Fin, Foil, LiftingSurface
from workbench.arrangement import Hull, WetDeck
from workbench.conventions import SEAWATER_DENSITY
from workbench.errors import InputError, checked_choice, checked_number
from workbench.hull_shape import set_number
from workbench.sails import SailPlan

__all__ = ["Design", "Fin", "Foil", "Hull", "MassProperties", "SailPlan", "WetDeck"]

STANDINGS = "published", "derived", "ours"


@dataclass(frozen=True, kw_only=True)
class MassProperties:
    """Mass, centre of gravity and gyradii of the whole ship.

    Parameters
    ----------
    mass : [kg].
    centre_of_gravity : (x, y, z) from the origin at still water amidships [m].
    roll_gyradius, pitch_gyradius, yaw_gyradius : about the centre of gravity [m].
    roll_damping_ratio : added roll damping as a fraction of critical [-].
    """

    mass: float
    centre_of_gravity: tuple[float, float, float]
    roll_gyradius: float
    pitch_gyradius: float
    yaw_gyradius: float
    roll_damping_ratio: float = 0.0

    def __post_init__(self) -> None:
        set_number(self, "mass", "mass", "kg", above=0.0, at_most=1e10)
        given = self.centre_of_gravity
        try:
            if isinstance(given, str | bytes):
                raise TypeError
            numbers = tuple(given)
        except TypeError:
            numbers = ()
        if len(numbers) != 3:
            raise InputError(
                f"centre of gravity must be three numbers (x, y, z) in m, got {given!r}; give all three."
            )
        checked = tuple(
            checked_number(f"{axis} of the centre of gravity", number, "m", at_least=-1000.0, at_most=1000.0)
            for axis, number in zip("xyz", numbers, strict=True)
        )
        object.__setattr__(self, "centre_of_gravity", checked)
        for mode in ("roll", "pitch", "yaw"):
            set_number(self, f"{mode}_gyradius", f"{mode} gyradius", "m", above=0.0, at_most=1000.0)
        set_number(self, "roll_damping_ratio", "roll damping ratio", at_least=0.0, at_most=1.0)

    def scaled(self, factor: float) -> "MassProperties":
        """Return the masses of the Froude-scaled ship, `factor` times as long, in the same water."""
        return dataclasses.replace(
            self,
            mass=self.mass * factor**3,
            centre_of_gravity=tuple(c * factor for c in self.centre_of_gravity),
            roll_gyradius=self.roll_gyradius * factor,
            pitch_gyradius=self.pitch_gyradius * factor,
            yaw_gyradius=self.yaw_gyradius * factor,
        )

    def as_dict(self) -> dict:
        """Return the masses as plain numbers."""
        return dataclasses.asdict(self)


@dataclass(frozen=True, kw_only=True)
class Design:
    """A ship: its hulls, wet deck and masses, the water it floats in, and where each figure comes from.

    Parameters
    ----------
    appendages : foils and fins under the hulls.
    sail_plan : of a sailing ship, or None.
    provenance : entries (quantity, value as text, source, standing), standing one of 'published',
        'derived' and 'ours'.
    """

    name: str
    hull: Hull
    wet_deck: WetDeck | None
    masses: MassProperties
    density: float = SEAWATER_DENSITY
    title: str = ""
    provenance: tuple[tuple[str, str, str, str], ...] = ()
    appendages: tuple[LiftingSurface, ...] = ()
    sail_plan: SailPlan | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name.strip():
            raise InputError(f"name of the design must be text, got {self.name!r}; give it a name.")
        if not isinstance(self.title, str):
            raise InputError(f"title of the design must be text, got {self.title!r}; put it in quotes.")
        for field, kind in (("hull", Hull), ("masses", MassProperties)):
            if not isinstance(getattr(self, field), kind):
                raise InputError(
                    f"{field} of the design must be a {kind.__name__}, got {getattr(self, field)!r}; "
                    "give one."
                )
        if self.wet_deck is not None and not isinstance(self.wet_deck, WetDeck):
            raise InputError(f"wet deck must be a WetDeck or None, got {self.wet_deck!r}; give one.")
        if self.sail_plan is not None and not isinstance(self.sail_plan, SailPlan):
            raise InputError(f"sail plan must be a SailPlan or None, got {self.sail_plan!r}; give one.")
        object.__setattr__(self, "appendages", _checked_appendages(self.appendages))
        set_number(
            self, "density", "density of the water", "kg/m3", at_least=900.0, at_most=1200.0,
            cure="fresh water is 1000, sea water 1025",
        )  # fmt: skip
        object.__setattr__(self, "provenance", tuple(map(_checked_entry, self.provenance)))
        self._check_fits()

    def _check_fits(self) -> None:
        masses, length = self.masses, self.hull.length
        for mode in ("roll", "pitch", "yaw"):
            checked_number(
                f"{mode} gyradius", getattr(masses, f"{mode}_gyradius"), "m", at_most=length,
                cure="a gyradius is a fraction of the length; check its unit",
            )  # fmt: skip
        checked_number(
            "x of the centre of gravity", masses.centre_of_gravity[0], "m",
            at_least=-length / 2, at_most=length / 2, cure="x is counted from midships, not from the stern",
        )  # fmt: skip
        for surface in self.appendages:
            x, y, _ = surface.position
            checked_number(
                f"x of {surface.name}", x, "m", at_least=-0.75 * length, at_most=0.75 * length,
                cure="x is counted from midships, positive forward",
            )  # fmt: skip
            widest = self.hull.beam / 2 + surface.span
            checked_number(
                f"y of {surface.name}", y, "m", at_least=-widest, at_most=widest,
                cure="appendages stand under or beside a hull",
            )  # fmt: skip
        if self.wet_deck is None:
            return
        if self.hull.count == 1:
            raise InputError("wet deck needs two or three hulls, got 1; remove the wet deck or add a hull.")
        checked_number(
            "width of the wet deck", self.wet_deck.width, "m", at_most=self.hull.beam,
            cure="the wet deck ends at the hulls",
        )  # fmt: skip
        for end in ("aft", "fore"):
            checked_number(
                f"{end} end of the wet deck", getattr(self.wet_deck, end), "m", at_least=-0.75 * length,
                at_most=0.75 * length, cure="x is counted from midships, positive forward",
            )  # fmt: skip

    def scaled(self, factor: float) -> "Design":
        """Return the Froude-scaled design, `factor` times as long, in the same water."""
        factor = checked_number("scale factor", factor, above=0.0)
        return dataclasses.replace(
            self,
            hull=self.hull.scaled(factor),
            wet_deck=self.wet_deck and self.wet_deck.scaled(factor),
            masses=self.masses.scaled(factor),
            appendages=tuple(surface.scaled(factor) for surface in self.appendages),
            sail_plan=self.sail_plan and self.sail_plan.scaled(factor),
            provenance=(*self.provenance, ("scale", f"{factor:g}", "Froude scaling of all above", "derived")),
        )

    def as_dict(self) -> dict:
        """Return the design as plain text and numbers, for files and content keys."""
        return {
            "name": self.name,
            "title": self.title,
            "density": self.density,
            "hull": self.hull.as_dict(),
            **({"wet_deck": self.wet_deck.as_dict()} if self.wet_deck else {}),
            "masses": self.masses.as_dict(),
            **({"appendages": [one.as_dict() for one in self.appendages]} if self.appendages else {}),
            **({"sail_plan": self.sail_plan.as_dict()} if self.sail_plan else {}),
            "provenance": [list(entry) for entry in self.provenance],
        }


def _checked_appendages(given: object) -> tuple[LiftingSurface, ...]:
    """Return the appendages as a tuple."""
    kinds = tuple(APPENDAGES.values())
    if not isinstance(given, tuple | list) or not all(isinstance(one, kinds) for one in given):
        raise InputError(f"appendages must be a tuple of Foil and Fin, got {given!r}; give these or none.")
    names = [one.name for one in given]
    if len(set(names)) < len(names):
        raise InputError(f"names of appendages must differ, got {', '.join(names)}; rename one.")
    return tuple(given)


def _checked_entry(entry: object) -> tuple[str, str, str, str]:
    """Return one entry of the provenance."""
    if not isinstance(entry, tuple | list) or len(entry) != 4 or not all(isinstance(e, str) for e in entry):
        raise InputError(
            f"provenance entry must be four texts (quantity, value, source, standing), got {entry!r}; "
            "give all four as text."
        )
    checked_choice(f"standing of {entry[0]}", entry[3], STANDINGS)
    return tuple(entry)  # type: ignore[return-value]
