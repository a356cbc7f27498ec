"""Research and naval ships: Educat, the COFEA frigate, the ASR catamaran model 5116 and USNS Hayes."""

import math

from workbench.design import Design, Hull, WetDeck
from workbench.hulls.vessels import fitting
from workbench.hulls.vessels.provenance import CHUANG, GRANDE, derived, ours, published
from workbench.shapes import RoundBilge

SEA, FRESH = 1025.0, 1000.0
FOOT, INCH, POUND = 0.3048, 0.0254, 0.45359237


def educat() -> Design:
    """Return a stand-in for the 8 m research catamaran Educat."""
    mass, length, beam, block, lcb = 2000.0, 6.80, 0.78, 0.47, -0.055
    draught = fitting.draught(mass, length, beam, block, 2, SEA)
    return Design(
        name="educat",
        title="Educat, 8 m research catamaran (stand-in)",
        hull=Hull(
            shape=RoundBilge(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 0.75,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.4,
                deadrise_angle=math.radians(15.0),
                entrance_angle=math.radians(9.0),
            ),
            count=2,
            spacing=1.97,
        ),
        wet_deck=WetDeck(
            aft=-2.6, fore=2.2, width=1.19, clearance=0.36, entry_length=0.8, entry_rise=0.22, vee_depth=0.10,
            vee_width=0.8,
        ),
        masses=fitting.balanced_masses(
            mass, lcb * length, 0.55, gyradii=(0.36 * 2.79, 0.26 * length, 0.28 * length)
        ),
        provenance=(
            published("length over all, of the waterline", "8 m, 6.80 m", f"{GRANDE}, table 3.3"),
            published("breadth over all", "2.79 m", f"{GRANDE}, table 3.3"),
            published("displacement", "about 2.0 t", f"{GRANDE}, table 3.3"),
            published("pod", "on rubber bushings between the hulls", f"{GRANDE}, table 3.3"),
            ours("beam, block coefficient, LCB of a hull", "0.78 m, 0.47, -5.5 %", "not given; usual"),
            derived("draught", f"{draught:.3f} m", "floats the published displacement"),
            ours("distance between centre planes", "1.97 m", "breadth over all less the breadth of a hull"),
            ours("centre of gravity", "above the centre of buoyancy, 0.55 m above still water", "not given"),
            ours("gyradii", "0.36 breadth, 0.26 and 0.28 length", "not given; usual values"),
            ours("wet deck", "clearance 0.36 m, shallow V of 0.10 m", "not given"),
        ),
    )  # fmt: skip


def cofea() -> Design:
    """Return a stand-in for the frigate of the COFEA tests, a single hull."""
    mass, length, draught, beam = 4.242e6, 120.0, 4.6, 17.0
    block, lcb = fitting.block_coefficient(mass, length, beam, draught, 1, SEA), -0.336 / 120.0
    source = f"{GRANDE}, table 3.4 (after Kapsenberg and Brouwer, 1998)"
    return Design(
        name="cofea",
        title="COFEA frigate, single hull (stand-in)",
        hull=Hull(
            shape=RoundBilge(
                length=length,
                beam=beam,
                draught=draught,
                depth=10.5,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.05,
                deadrise_angle=math.radians(8.0),
                entrance_angle=math.radians(12.0),
            )
        ),
        wet_deck=None,
        masses=fitting.balanced_masses(
            mass, lcb * length, 2.0, gyradii=(0.37 * beam, 0.25 * length, 0.25 * length)
        ),
        provenance=(
            published("length between perpendiculars, draught", "120 m, 4.6 m", source),
            published("displacement", "4242 t", source),
            published("LCB", "-0.336 m from midships", source),
            published("beam of the waterline", "20 m (not used)", source),
            published("prismatic and midship coefficients", "0.633, 0.925 (not used)", source),
            published("pitch gyradius", "0.25 lengths, an assumption of the source", GRANDE),
            ours(
                "beam",
                f"{beam:g} m",
                "the table is not consistent with one beam: its coefficients need 12.8 m for 4242 t, and "
                "20 m would give 6626 t; chosen between, so that the family carries displacement and LCB",
            ),
            derived("block coefficient", f"{block:.4f}", "floats the published displacement at that beam"),
            ours(
                "LCF",
                "as the family gives it",
                "-16.452 m in the source, not reproduced",
            ),
            ours("centre of gravity, height", "2.0 m above still water", "not given"),
            ours("roll and yaw gyradii", "0.37 beam, 0.25 length", "not given; usual values"),
        ),
    )


def asr_5116() -> Design:
    """Return a stand-in for model 5116 of the submarine rescue ship ASR-21."""
    length, beam, draught, mass = 10.91 * FOOT, 1.22 * FOOT, 0.89 * FOOT, 800.0 * POUND
    block, lcb = fitting.block_coefficient(mass, length, beam, draught, 2, FRESH), -0.020
    spacing = (4.04 - 1.22) * FOOT
    clearance = 7.25 * INCH
    return Design(
        name="asr-5116",
        title="Model 5116 of the catamaran ASR-21 (stand-in)",
        hull=Hull(
            shape=RoundBilge(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 0.35,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.1,
                deadrise_angle=math.radians(8.0),
                entrance_angle=math.radians(12.0),
            ),
            count=2,
            spacing=spacing,
        ),
        wet_deck=WetDeck(aft=-4.0 * FOOT, fore=4.0 * FOOT, width=19.0 * INCH, clearance=clearance),
        masses=fitting.balanced_masses(
            mass, lcb * length, 0.15, gyradii=(0.40 * 4.04 * FOOT, 0.25 * length, 0.26 * length)
        ),
        density=FRESH,
        provenance=(
            published("length and width of a hull, draught", "10.91, 1.22, 0.89 ft", f"{CHUANG}, p. 11"),
            published("overall width", "4.04 ft", f"{CHUANG}, p. 11"),
            published("weight", "800 lb", f"{CHUANG}, p. 11"),
            published("scale ratio", "21.28", f"{CHUANG}, p. 11"),
            published("width and length of the cross structure", "19 in, 8 ft", f"{CHUANG}, pp. 11-14"),
            published("clearances tested", "4.25, 7.25, 10.25 in; here 7.25 in", f"{CHUANG}, pp. 11-14"),
            derived(
                "distance between centre planes", f"{spacing:.4f} m", "overall width less the width of a hull"
            ),
            derived("block coefficient", f"{block:.4f}", "floats the published weight in fresh water"),
            ours(
                "place of the cross structure", "amidships", "its position along the hulls is not recoverable"
            ),
            ours("hull lines, LCB", "round-bilge family, -2 %", "lines are not recoverable"),
            ours("centre of gravity, height", "0.15 m above still water", "not given"),
            ours("gyradii", "0.40 breadth, 0.25 and 0.26 length", "not given; usual values"),
        ),
    )


def hayes() -> Design:
    """Return a stand-in for the catamaran research ship USNS Hayes."""
    length, beam, draught, block, lcb = 220.0 * FOOT, 24.0 * FOOT, 18.0 * FOOT, 0.53, -0.020
    mass = SEA * 2 * block * length * beam * draught
    spacing = 51.0 * FOOT
    return Design(
        name="hayes",
        title="USNS Hayes, catamaran research ship (stand-in)",
        hull=Hull(
            shape=RoundBilge(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 7.0,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.1,
                deadrise_angle=math.radians(8.0),
                entrance_angle=math.radians(12.0),
            ),
            count=2,
            spacing=spacing,
        ),
        wet_deck=WetDeck(
            aft=-28.0, fore=24.0, width=27.0 * FOOT, clearance=3.7, entry_length=3.0, entry_rise=0.8
        ),
        masses=fitting.balanced_masses(
            mass, lcb * length, 2.2, gyradii=(0.40 * 75.0 * FOOT, 0.25 * length, 0.27 * length)
        ),
        provenance=(
            published("full-scale slams without the forward foil", "12 events", f"{CHUANG}, appendix A"),
            ours(
                "length, beam and draught of a hull", "220, 24, 18 ft", "not in the report; usual description"
            ),
            ours("distance between centre planes", "51 ft", "not in the report; breadth over all of 75 ft"),
            ours("block coefficient, LCB", "0.53, -2 %", "not given; usual for the kind"),
            derived("mass", f"{mass / 1000:.0f} t", "floats these hulls"),
            ours("wet deck", "clearance 3.7 m, x -28 to 24 m", "not given"),
            ours("centre of gravity", "above the centre of buoyancy, 2.2 m above still water", "not given"),
            ours("gyradii", "0.40 breadth, 0.25 and 0.27 length", "not given; usual values"),
        ),
    )
