"""Variants of a design, one change at a time: longer, with wider hulls, wet deck further aft, wet deck higher.

The four changes of the parametric study of [Grande2002]_ 8. The first two change the
hulls and so the motions; the other two move the wet deck alone, and the motions of
the design serve them as they are.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

import math
from dataclasses import replace

from scipy.optimize import brentq

from workbench.appendages import LiftingSurface
from workbench.arrangement import Hull
from workbench.design import Design
from workbench.errors import InputError, checked_number
from workbench.geometry.hydrostatics import hydrostatics
from workbench.hull_shape import HullShape
from workbench.shapes import HeavyLiftBox, Offsets, PanelMesh, RoundBilge

SOURCE = 'after K. Grande, "Prediction of slamming occurrence of catamarans", 2002, chapter 8'


def lengthened(design: Design, by: float) -> Design:
    """Design with longer hulls of the same sections: all their stations further apart.

    Parameters
    ----------
    by : what is added to the length of the waterline [m]; less than 0 shortens.

    Notes
    -----
    Draught, breadth and freeboard stay, displacement grows with the length. The mass follows the
    displacement; the centre of gravity keeps its height and its share of the length, pitch and yaw
    gyradii keep their share of it, the roll gyradius stays. Appendages stay at their station.
    The wet deck stays where it is, counted from midships. The source does not say from where it
    counts, nor whether it spread the stations or put a piece amidships.
    """
    by = checked_number("added length", by, "m", above=-0.5 * design.hull.length, at_most=design.hull.length)
    ratio = 1.0 + by / design.hull.length
    hull, masses = design.hull, design.masses
    x, y, z = masses.centre_of_gravity
    return _changed(
        design,
        f"lengthened by {by:g} m, sections kept",
        "mass, centre of gravity, pitch and yaw gyradii in proportion; wet deck kept",
        hull=replace(
            hull,
            shape=stretched(hull.shape, ratio),
            centre_shape=hull.centre_shape and stretched(hull.centre_shape, ratio),
            centre_x=hull.centre_x * ratio,
            trim=math.atan(math.tan(hull.trim) / ratio),
        ),
        masses=replace(
            masses,
            mass=masses.mass * ratio,
            centre_of_gravity=(x * ratio, y, z),
            pitch_gyradius=masses.pitch_gyradius * ratio,
            yaw_gyradius=masses.yaw_gyradius * ratio,
        ),
        appendages=tuple(_moved(one, ratio, 0.0) for one in design.appendages),
    )


def widened(design: Design, by: float) -> Design:
    """Design with hulls of more beam and less draught, at the same displacement.

    Parameters
    ----------
    by : what is added to the beam of one hull [m]; less than 0 narrows. A centre hull follows in proportion.

    Notes
    -----
    Sections are spread sideways and flattened under water. Masses, freeboard, distance of the
    hulls and wet deck stay, the latter two counted from the water. Fins go up with the keel.
    """
    hull = design.hull
    if hull.heel or hull.trim or hull.sinkage:
        raise InputError(
            f"hull to be widened must float upright at its draught, got heel {hull.heel:g} rad, trim "
            f"{hull.trim:g} rad and sinkage {hull.sinkage:g} m; widen it first, then heel, trim or sink it."
        )
    beam = hull.shape.beam
    by = checked_number("added beam of a hull", by, "m", above=-0.5 * beam, at_most=beam)
    ratio = 1.0 + by / beam
    shape = flattened(hull.shape, ratio)
    raised = hull.shape.draught - shape.draught
    return _changed(
        design,
        f"beam of a hull {by:+g} m, draught {-raised:+.4g} m",
        "same displacement, masses, freeboard and wet deck",
        hull=replace(
            hull, shape=shape, centre_shape=hull.centre_shape and flattened(hull.centre_shape, ratio)
        ),
        appendages=tuple(_moved(one, 1.0, raised) for one in design.appendages),
    )


def deck_moved(design: Design, aft: float) -> Design:
    """Design with its wet deck moved aft by so much [m]; hulls and motions stay."""
    aft = checked_number(
        "move of the wet deck", aft, "m", at_least=-design.hull.length, at_most=design.hull.length
    )
    deck = _wet_deck(design)
    return _changed(
        design,
        f"wet deck moved aft by {aft:g} m",
        "hulls kept",
        wet_deck=replace(deck, aft=deck.aft - aft, fore=deck.fore - aft),
    )


def deck_raised(design: Design, by: float) -> Design:
    """Design with its wet deck raised by so much [m]; hulls and motions stay."""
    deck = _wet_deck(design)
    by = checked_number("rise of the wet deck", by, "m", above=-deck.clearance, at_most=100.0)
    return _changed(
        design,
        f"wet deck raised by {by:g} m",
        "hulls kept",
        wet_deck=replace(deck, clearance=deck.clearance + by),
    )


def same_motions(design: Design) -> Design:
    """Design without what its motions do not depend on: wet deck and words. Equal ones move alike."""
    return replace(design, name="as far as it moves", title="", provenance=(), wet_deck=None)


def stretched(shape: HullShape, ratio: float) -> HullShape:
    """Shape with its stations spread lengthwise by a ratio, the sections kept."""
    if isinstance(shape, Offsets):
        return replace(
            shape, length=shape.length * ratio, stations=tuple((x * ratio, points) for x, points in shape.stations)
        )  # fmt: skip
    if isinstance(shape, PanelMesh):
        return replace(
            shape, length=shape.length * ratio, vertices=tuple((x * ratio, y, z) for x, y, z in shape.vertices)
        )  # fmt: skip
    more = {}
    if isinstance(shape, RoundBilge):
        more = {"entrance_angle": math.atan(math.tan(shape.entrance_angle) / ratio)}
    elif isinstance(shape, HeavyLiftBox):
        more = {"bow_length": shape.bow_length * ratio, "stern_length": shape.stern_length * ratio}
    return replace(shape, length=shape.length * ratio, **more)


def flattened(shape: HullShape, ratio: float) -> HullShape:
    """Shape spread sideways by a ratio and flattened under water to the same displacement; freeboard kept.

    A bilge keeps its radius, and the draught is then found for the displacement.
    """
    if isinstance(shape, Offsets):
        draught = shape.draught / ratio
        stations = tuple(
            (x, tuple((_flat(z - shape.draught, ratio) + draught, y * ratio) for z, y in points))
            for x, points in shape.stations
        )
        return replace(shape, stations=stations, draught=draught)
    if isinstance(shape, PanelMesh):
        vertices = tuple((x, y * ratio, _flat(z, ratio)) for x, y, z in shape.vertices)
        return replace(shape, vertices=vertices, draught=shape.draught / ratio)
    if isinstance(shape, HeavyLiftBox):
        return _flat_box(shape, ratio)
    more = {}
    if isinstance(shape, RoundBilge):
        more = {
            "entrance_angle": math.atan(math.tan(shape.entrance_angle) * ratio),
            "deadrise_angle": math.atan(math.tan(shape.deadrise_angle) / ratio**2),
        }
    return _at_draught(replace(shape, beam=shape.beam * ratio, **more), shape.draught / ratio)


def _flat(height: float, ratio: float) -> float:
    """Return a height over the water [m], flattened below it."""
    return height / ratio if height < 0.0 else height


def _at_draught(shape: HullShape, draught: float) -> HullShape:
    """Return a shape at another draught with the same freeboard."""
    return replace(shape, draught=draught, depth=shape.depth - shape.draught + draught)


def _flat_box(shape: HeavyLiftBox, ratio: float) -> HeavyLiftBox:
    """Return a box of more beam at the draught at which it displaces the same."""

    def volume(box: HeavyLiftBox) -> float:
        return float(hydrostatics(Hull(shape=box), 1000.0, 0.0).volume)

    wide, wanted = replace(shape, beam=shape.beam * ratio), volume(shape)
    least, most = (factor * shape.draught / ratio for factor in (0.8, 1.25))
    found = brentq(
        lambda draught: volume(_at_draught(wide, draught)) - wanted, least, most, xtol=1e-9 * least
    )
    return _at_draught(wide, float(found))


def _moved(surface: LiftingSurface, ratio: float, raised: float) -> LiftingSurface:
    """Return an appendage at its station of a stretched hull, or higher."""
    x, y, z = surface.position
    return replace(surface, position=(x * ratio, y, z + raised))


def _wet_deck(design: Design):
    if design.wet_deck is None:
        raise InputError(
            f"design must have a wet deck to be moved, but {design.name} has none; choose one with a wet deck."
        )
    return design.wet_deck


def _changed(design: Design, what: str, how: str, **parts) -> Design:
    """Return the design with changed parts, its name and provenance saying so."""
    entry = ("variant", what, f"{how}; {SOURCE}", "derived")
    return replace(
        design, name=f"{design.name}, {what}", title=f"{design.title or design.name}, {what}",
        provenance=(*design.provenance, entry), **parts,
    )  # fmt: skip
