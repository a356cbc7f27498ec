"""What every shape of one hull has in common: `HullShape`, and the checks of its main dimensions."""

import dataclasses
from typing import ClassVar

from workbench.errors import InputError, checked_number

LENGTH_RANGE = 0.1, 1000.0
BEAM_RANGE = 0.001, 300.0
DRAUGHT_RANGE = 0.001, 100.0
DEPTH_RANGE = 0.001, 300.0


class HullShape:
    """What all shapes have in common; use one of the subclasses."""

    kind: ClassVar[str] = ""
    length: float
    beam: float
    draught: float
    depth: float
    LENGTHS: ClassVar[tuple[str, ...]] = ("length", "beam", "draught", "depth")
    """Names of the fields that scale with the length of the ship."""

    def as_dict(self) -> dict:
        """Return the shape as plain text and numbers, for files and content keys."""
        fields = dataclasses.fields(self)  # type: ignore[arg-type]
        return {"kind": self.kind, **{field.name: getattr(self, field.name) for field in fields}}

    def scaled(self, factor: float) -> "HullShape":
        """Return the geometrically similar shape, `factor` times as long."""
        factor = checked_number("scale factor", factor, above=0.0)
        lengths = {name: getattr(self, name) * factor for name in self.LENGTHS}
        return dataclasses.replace(self, **lengths)  # type: ignore[type-var]

    def _check_main_dimensions(self) -> None:
        limits = (
            ("length", LENGTH_RANGE),
            ("beam", BEAM_RANGE),
            ("draught", DRAUGHT_RANGE),
            ("depth", DEPTH_RANGE),
        )
        for name, (least, most) in limits:
            set_number(self, name, f"hull {name}", "m", at_least=least, at_most=most)
        if self.draught >= self.depth:
            raise InputError(
                f"draught must be less than the depth of the hull ({self.depth:g} m, keel to deck edge), "
                f"got {self.draught:g} m; raise the depth or reduce the draught."
            )
        if self.beam >= self.length:
            raise InputError(
                f"beam of one hull must be less than its length ({self.length:g} m), got {self.beam:g} m; "
                "give the beam of one hull, not of the ship, in metres."
            )


def set_number(owner, field: str, name: str, unit: str = "", **limits) -> None:
    """Replace a field of a frozen dataclass by its checked float."""
    object.__setattr__(owner, field, checked_number(name, getattr(owner, field), unit, **limits))
