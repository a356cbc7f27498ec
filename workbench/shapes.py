"""Shapes of one hull about its own centre plane: frozen, validated, hashable.

Every shape has ``length`` (of the waterline; also between perpendiculars),
``beam`` (largest, at or below the waterline), ``draught`` and ``depth`` (keel
to deck edge) in metres. ``lcb`` is the longitudinal centre of buoyancy as a
fraction of the length, from midships, positive forward. Angles are in radians.

A parametric family meets the asked block coefficient and centre of buoyancy by
solving for its inner numbers when it is made, or is refused with the range
that it can reach.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from workbench.errors import InputError, checked_choice
from workbench.given_shapes import Offsets, PanelMesh
from workbench.hull_shape import HullShape, set_number
from workbench.hulls.families.fine_form import FineForm, inner_numbers

__all__ = [
    "SHAPES",
    "HeavyLiftBox",
    "HullShape",
    "Offsets",
    "PanelMesh",
    "RoundBilge",
    "SemiSwath",
    "SlenderRacing",
    "Wigley",
    "set_number",
    "shape_from_dict",
]


@dataclass(frozen=True, kw_only=True)
class Wigley(HullShape):
    """The parabolic hull of Wigley: bow and stern alike, block coefficient 4/9."""

    kind: ClassVar[str] = "wigley"
    length: float
    beam: float
    draught: float
    depth: float

    def __post_init__(self) -> None:
        self._check_main_dimensions()


class _FineShape(HullShape):
    """What the fine transom-stern families have in common."""

    block_coefficient: float
    lcb: float
    transom_ratio: float

    def _check_form(self) -> None:
        self._check_main_dimensions()
        set_number(self, "block_coefficient", "block coefficient", at_least=0.2, at_most=0.9)
        set_number(self, "lcb", "longitudinal centre of buoyancy", "lengths", at_least=-0.2, at_most=0.2)
        set_number(self, "transom_ratio", "transom ratio", at_least=0.0, at_most=0.95)

    @property
    def form(self) -> FineForm:
        """The ratios and angles that the surface is made of."""
        raise NotImplementedError

    def _form(self, **character: float) -> FineForm:
        return FineForm(
            block_coefficient=self.block_coefficient,
            lcb=self.lcb,
            transom_ratio=self.transom_ratio,
            length_beam=self.length / self.beam,
            beam_draught=self.beam / self.draught,
            depth_draught=self.depth / self.draught,
            **character,
        )


@dataclass(frozen=True, kw_only=True)
class RoundBilge(_FineShape):
    """A round-bilge demihull with a transom, of the kind of the NPL series.

    Parameters
    ----------
    block_coefficient : volume / (length beam draught) [-].
    lcb : longitudinal centre of buoyancy, lengths forward of midships [-].
    transom_ratio : wetted transom area over the largest section area [-].
    deadrise_angle : at the keel amidships [rad].
    entrance_angle : half angle of the waterline at the bow [rad].
    """

    kind: ClassVar[str] = "round-bilge"
    length: float
    beam: float
    draught: float
    depth: float
    block_coefficient: float
    lcb: float
    transom_ratio: float
    deadrise_angle: float
    entrance_angle: float

    def __post_init__(self) -> None:
        self._check_form()
        set_number(self, "deadrise_angle", "deadrise angle", "rad", at_least=0.0, at_most=math.radians(60.0))
        set_number(self, "entrance_angle", "entrance angle", "rad", above=0.0, at_most=math.radians(45.0))
        inner_numbers(self.form)

    @property
    def form(self) -> FineForm:
        """The ratios and angles that the surface is made of."""
        return self._form(deadrise=self.deadrise_angle, entrance=self.entrance_angle)


@dataclass(frozen=True, kw_only=True)
class SemiSwath(_FineShape):
    """A semi-SWATH demihull: a slender strut at the waterline forward, fuller below, U sections aft.

    Parameters
    ----------
    block_coefficient, lcb, transom_ratio : as for `RoundBilge`.
    bulb_ratio : breadth added below the fore waterline over the beam [-].
    """

    kind: ClassVar[str] = "semi-swath"
    length: float
    beam: float
    draught: float
    depth: float
    block_coefficient: float
    lcb: float
    transom_ratio: float
    bulb_ratio: float = 0.25

    def __post_init__(self) -> None:
        self._check_form()
        set_number(self, "bulb_ratio", "bulb ratio", at_least=0.0, at_most=0.4)
        inner_numbers(self.form)

    @property
    def form(self) -> FineForm:
        """The ratios and angles that the surface is made of."""
        return self._form(
            deadrise=math.radians(15.0),
            entrance=math.atan(0.6 * self.beam / self.length),
            bulb=self.bulb_ratio,
            forefoot=0.035,
            overhang=0.02,
        )


@dataclass(frozen=True, kw_only=True)
class SlenderRacing(_FineShape):
    """The slender hull of a racing catamaran: round sections, rocker, fine entrance, upright stem.

    Parameters
    ----------
    block_coefficient, lcb, transom_ratio : as for `RoundBilge`.
    """

    kind: ClassVar[str] = "slender-racing"
    length: float
    beam: float
    draught: float
    depth: float
    block_coefficient: float
    lcb: float
    transom_ratio: float

    def __post_init__(self) -> None:
        self._check_form()
        inner_numbers(self.form)

    @property
    def form(self) -> FineForm:
        """The ratios and angles that the surface is made of."""
        return self._form(
            deadrise=math.radians(8.0),
            entrance=math.atan(1.05 * self.beam / self.length),
            forefoot=0.12,
            overhang=0.01,
            keel_rise=2.0,
        )


@dataclass(frozen=True, kw_only=True)
class HeavyLiftBox(HullShape):
    """A wall-sided box with round bilges, a ship-shaped bow and a rising stern.

    Parameters
    ----------
    bilge_radius : [m].
    bow_length, stern_length : over which the bow narrows and the keel rises aft [m].
    """

    kind: ClassVar[str] = "heavy-lift-box"
    length: float
    beam: float
    draught: float
    depth: float
    bilge_radius: float = 0.0
    bow_length: float = 0.0
    stern_length: float = 0.0
    LENGTHS: ClassVar[tuple[str, ...]] = (
        *HullShape.LENGTHS,
        "bilge_radius",
        "bow_length",
        "stern_length",
    )

    def __post_init__(self) -> None:
        self._check_main_dimensions()
        most = min(self.draught, self.beam / 2)
        set_number(
            self,
            "bilge_radius",
            "bilge radius",
            "m",
            at_least=0.0,
            at_most=most,
            cure="the bilge lies within half the beam and the draught",
        )
        for end in ("bow", "stern"):
            set_number(self, f"{end}_length", f"{end} length", "m", at_least=0.0, at_most=0.45 * self.length)


SHAPES: dict[str, type[HullShape]] = {
    shape.kind: shape
    for shape in (Wigley, RoundBilge, SemiSwath, SlenderRacing, HeavyLiftBox, Offsets, PanelMesh)
}
"""Every shape by the word that names it in a design file."""


def shape_from_dict(values: Mapping) -> HullShape:
    """Return the shape described by `HullShape.as_dict`; unknown words are refused by name."""
    values = dict(values)
    if "kind" not in values:
        raise InputError(f'hull shape must have a kind, one of {", ".join(SHAPES)}; add kind = "...".')
    return SHAPES[checked_choice("kind of hull shape", values.pop("kind"), SHAPES)](**values)
