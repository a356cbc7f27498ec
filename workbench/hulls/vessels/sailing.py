"""Sailing multihulls: Crowther 318, as built and lengthened, and the two 35 m concepts, as stand-ins."""

from dataclasses import replace

from workbench.design import Design, Hull, WetDeck
from workbench.hulls.vessels import fitting
from workbench.hulls.vessels.provenance import GRANDE, derived, ours, published
from workbench.sails import SailPlan, tapered_sail_plan
from workbench.shapes import SemiSwath, SlenderRacing
from workbench.variants import lengthened

SEA = 1025.0
LENGTH_318, MODIFIED_LENGTH = 15.2, 17.1
"""Over all, of the Crowther 318 as built and modified [m]."""
UPWIND_LIFT = 1.2
"""Lift coefficient of sails close-hauled, ours [-]."""
UPWIND_SAIL_AREA_35 = 577.0
"""Of both 35 m concepts [m2]."""


def crowther_318() -> Design:
    """Return a stand-in for the 50 ft racing catamaran Crowther design 318."""
    mass, length, lcb, block = 3700.0, 14.9, -0.030, 0.45
    beam = 15.2 / 22.0
    draught = fitting.draught(mass, length, beam, block, 2, SEA)
    return Design(
        name="crowther-318",
        title="Crowther 318, 15.2 m racing catamaran (stand-in)",
        hull=Hull(
            shape=SemiSwath(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 1.15,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.2,
                bulb_ratio=0.15,
            ),
            count=2,
            spacing=10.0,
        ),
        wet_deck=WetDeck(
            aft=-3.5,
            fore=2.2,
            width=9.2,
            clearance=1.05,
            entry_length=0.6,
            entry_rise=0.25,
            vee_depth=0.40,
            vee_width=2.2,
        ),
        masses=fitting.balanced_masses(
            mass, lcb * length, 1.3, gyradii=(0.32 * 10.8, 0.27 * length, 0.33 * length)
        ),
        sail_plan=tapered_sail_plan(10.4, 2.0, 1.8, 22.8, UPWIND_LIFT),
        provenance=(
            published("length and breadth over all", "15.2 m, 10.8 m", f"{GRANDE}, table 3.1"),
            published("displacement", "3700 kg, sailing condition", f"{GRANDE}, table 3.1"),
            published("length/beam of a hull", "about 22", f"{GRANDE}, table 3.1"),
            published("kind of hull", "semi-SWATH bow sections; central deep-vee pod", f"{GRANDE}, 3.1.1"),
            derived("beam of a hull", f"{beam:.3f} m", "length over all / 22"),
            ours("waterline length", "14.9 m", "not given; nearly upright stems"),
            ours("block coefficient, LCB, transom ratio", "0.45, -3 %, 0.2", "not given; usual for the kind"),
            derived("draught", f"{draught:.3f} m", "floats the published displacement"),
            ours(
                "canting of the hulls",
                "none",
                "the hulls of the ship are canted outward by an angle not given",
            ),
            ours("distance between centre planes", "10.0 m", "breadth over all less the breadth of a hull"),
            ours("centre of gravity", "above the centre of buoyancy, 1.3 m above still water", "not given"),
            ours("gyradii", "0.32 breadth, 0.27 and 0.33 length", "not given; with the rig"),
            ours(
                "wet deck",
                "clearance 1.05 m; pod V 0.40 m deep and 2.2 m wide on the centreline",
                "not given; one deck carries both main beam and pod, which stand apart on the ship",
            ),
            ours(
                "sail plan",
                "130 m2 from 1.8 to 22.8 m, chord 10.4 m tapering to 2 m, lift coefficient 1.2",
                "not given; usual for the kind",
            ),
        ),
    )


def crowther_318_modified() -> Design:
    """Return a stand-in for the Crowther 318 lengthened from 15.2 to 17.1 m."""
    base = crowther_318()
    longer = lengthened(base, MODIFIED_LENGTH - LENGTH_318)
    mass = longer.masses.mass
    return replace(
        longer,
        name="crowther-318-modified",
        title="Crowther 318 lengthened to 17.1 m (stand-in)",
        provenance=(
            *base.provenance,
            published("length over all, modified", "17.1 m (56 ft)", f"{GRANDE}, 3.1.2"),
            ours(
                "modified hulls",
                f"waterline {longer.hull.length:.1f} m, sections of the original further apart",
                "how she was lengthened is missing in the source",
            ),
            derived("displacement, modified", f"{mass:.0f} kg", "floats the longer hulls at the same draught"),
            ours(
                "masses, modified",
                "centre of gravity and gyradii in proportion to the length; wet deck and sails kept",
                "missing in the source",
            ),
        ),
    )  # fmt: skip


def catamaran_35() -> Design:
    """Return the 35 m catamaran concept."""
    mass, length, beam, block, lcb = 24_000.0, 34.0, 1.3, 0.43, -0.030
    draught = fitting.draught(mass, length, beam, block, 2, SEA)
    return Design(
        name="catamaran-35",
        title="35 m sailing catamaran concept (stand-in)",
        hull=Hull(
            shape=SlenderRacing(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 2.6,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.1,
            ),
            count=2,
            spacing=19.5,
        ),
        wet_deck=_deck_35(18.0),
        masses=_masses_35(mass, lcb * length, length),
        sail_plan=_sails_35(),
        provenance=(
            *_published_35(),
            ours("waterline length and beam of a hull", "34.0, 1.3 m", "not given; length/beam about 26"),
            ours("block coefficient, LCB, transom ratio", "0.43, -3 %, 0.1", "not given; usual for the kind"),
            derived("draught", f"{draught:.3f} m", "floats the published displacement"),
            ours("distance between centre planes", "19.5 m", "breadth over all less the breadth of a hull"),
            *_chosen_35(),
        ),
    )


def trimaran_35() -> Design:
    """Return the 35 m trimaran concept, of the same displacement and breadth as the catamaran."""
    mass, length, lcb = 24_000.0, 34.0, -0.030
    float_length, float_beam, float_block, float_share = 28.0, 0.60, 0.42, 0.12
    beam, block = 1.75, 0.44
    draught = fitting.draught((1 - float_share) * mass, length, beam, block, 1, SEA)
    float_draught = fitting.draught(float_share * mass, float_length, float_beam, float_block, 2, SEA)
    float_lcb = lcb * length / float_length
    freeboard = 2.4
    outer = SlenderRacing(
        length=float_length,
        beam=float_beam,
        draught=float_draught,
        depth=float_draught + freeboard,
        block_coefficient=float_block,
        lcb=float_lcb,
        transom_ratio=0.1,
    )
    centre = SlenderRacing(
        length=length,
        beam=beam,
        draught=draught,
        depth=draught + freeboard,
        block_coefficient=block,
        lcb=lcb,
        transom_ratio=0.1,
    )
    return Design(
        name="trimaran-35",
        title="35 m sailing trimaran concept (stand-in)",
        hull=Hull(shape=outer, count=3, spacing=20.2, centre_shape=centre),
        wet_deck=_deck_35(19.4),
        masses=_masses_35(mass, lcb * length, length),
        sail_plan=_sails_35(),
        provenance=(
            *_published_35(),
            ours(
                "centre hull",
                f"waterline length 34 m, beam {beam:g} m, block coefficient {block:g}, LCB -3 %",
                "not given; carries 88 % of the displacement",
            ),
            ours(
                "outer hulls",
                f"waterline length {float_length:g} m, beam {float_beam:g} m",
                "not given; carry 12 % of the displacement and touch the water at rest",
            ),
            derived("draughts", f"{draught:.3f}, {float_draught:.3f} m", "float the published displacement"),
            ours(
                "distance between outer centre planes",
                "20.2 m",
                "breadth over all less the breadth of a hull",
            ),
            *_chosen_35(),
        ),
    )


def _deck_35(width: float) -> WetDeck:
    """Return the deck at the height of the main beam."""
    return WetDeck(aft=-7.0, fore=5.0, width=width, clearance=2.5, entry_length=1.0, entry_rise=0.5)


def _sails_35() -> SailPlan:
    """Return the sails of both concepts, with the published area."""
    lowest, highest, head = 3.5, 43.5, 4.0
    foot = 2 * UPWIND_SAIL_AREA_35 / (highest - lowest) - head
    return tapered_sail_plan(foot, head, lowest, highest, UPWIND_LIFT)


def _masses_35(mass: float, x: float, length: float):
    """Return the masses of both concepts."""
    return fitting.balanced_masses(mass, x, 2.6, gyradii=(0.30 * 21.0, 0.25 * length, 0.30 * length))


def _published_35() -> tuple:
    """Return what the source gives of both concepts."""
    source = f"{GRANDE}, table 3.5"
    return (
        published("length and breadth over all", "35 m, 21 m", source),
        published("displacement", "24000 kg", source),
        published("height of the main beam above still water", "2.5 m", source),
        published("upwind sail area", "577 m2", source),
    )


def _chosen_35() -> tuple:
    """Return what is chosen alike for both concepts."""
    return (
        ours("extent of the wet deck", "x -7 to 5 m, raked over its first metre", "not given"),
        ours("centre of gravity", "above the centre of buoyancy, 2.6 m above still water", "not given"),
        ours("gyradii", "0.30 breadth, 0.25 and 0.30 length", "not given; with the rig"),
        ours(
            "height, taper and lift coefficient of the sails",
            "3.5 to 43.5 m, chord tapering to 4 m, 1.2",
            "not given; usual for the kind",
        ),
    )
