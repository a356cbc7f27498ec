"""Fast ferries: Austal hull 63 and the Incat wave piercers 061 and 064, as stand-ins."""

import math

from workbench.design import Design, Hull, WetDeck
from workbench.hulls.vessels.fitting import balanced_masses, block_coefficient
from workbench.hulls.vessels.provenance import AMIN, GRANDE, derived, ours, published
from workbench.shapes import RoundBilge, SemiSwath

SEA = 1025.0


def austal_63() -> Design:
    """Return a stand-in for the 86.6 m ferry Austal hull 63."""
    length, beam, draught, block, lcb = 76.0, 5.2, 3.1, 0.50, -0.050
    mass = SEA * 2 * block * length * beam * draught
    return Design(
        name="austal-63",
        title="Austal hull 63, 86.6 m ferry (stand-in)",
        hull=Hull(
            shape=SemiSwath(
                length=length,
                beam=beam,
                draught=draught,
                depth=9.0,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.5,
                bulb_ratio=0.22,
            ),
            count=2,
            spacing=18.6,
        ),
        wet_deck=WetDeck(
            aft=-36.0,
            fore=33.0,
            width=13.4,
            clearance=2.6,
            entry_length=8.0,
            entry_rise=1.2,
            corner_radius=0.6,
        ),
        masses=balanced_masses(mass, lcb * length, 3.4, gyradii=(0.38 * 24.0, 0.26 * length, 0.27 * length)),
        provenance=(
            published("length and breadth over all", "86.6 m, 24.0 m", f"{GRANDE}, table 3.2"),
            published("service speed", "40 kn", f"{GRANDE}, table 3.2"),
            published("kind of hull", "semi-SWATH bow blending to U sections aft", f"{GRANDE}, 3.1.3"),
            published("appendages", "forward T-foils, interceptors", f"{GRANDE}, 3.1.3"),
            ours("appendages of the stand-in", "none", "size and place are missing in the source"),
            ours(
                "waterline length, beam, draught",
                "76, 5.2, 3.1 m",
                "not given; usual for the length over all",
            ),
            ours("block coefficient, LCB, transom ratio", "0.50, -5 %, 0.5", "not given; usual for the kind"),
            ours(
                "distance between centre planes",
                "18.6 m",
                "breadth over all less the breadth of a hull at deck",
            ),
            derived("mass", f"{mass / 1000:.0f} t", "floats these hulls; the displacement is not given"),
            derived(
                "centre of gravity, x", f"{lcb * length:.2f} m", "above the centre of buoyancy, level trim"
            ),
            ours("centre of gravity, height", "3.4 m above still water", "not given; about 0.7 of the depth"),
            ours("gyradii", "0.38 breadth, 0.26 and 0.27 length", "not given; usual values"),
            ours("wet deck", "clearance 2.6 m, x -36 to 33 m, raked entry", "not given; usual for the kind"),
        ),
    )


def incat_061() -> Design:
    """Return a stand-in for the 98 m Incat hull 061."""
    return _incat(
        name="incat-061",
        title="Incat hull 061, 98 m wave piercer (stand-in)",
        over_all=(98.0, 26.6),
        length=92.4,
        spacing=21.7,
        draught=3.96,
        mass=1.845e6,
        beam=4.9,
        centre_bow_fraction=0.25,
        clearance=3.5,
        speed="38 kn",
    )


def incat_064() -> Design:
    """Return a stand-in for the 112 m Incat hull 064."""
    return _incat(
        name="incat-064",
        title="Incat hull 064, 112 m wave piercer (stand-in)",
        over_all=(112.0, 30.5),
        length=105.6,
        spacing=24.7,
        draught=3.93,
        mass=2.8e6,
        beam=5.8,
        centre_bow_fraction=0.19,
        clearance=3.7,
        speed="40 kn",
    )


def _incat(
    *, name, title, over_all, length, spacing, draught, mass, beam, centre_bow_fraction, clearance, speed
) -> Design:
    """Return a wave piercer with a centre bow from the particulars of table 1."""
    block, lcb = block_coefficient(mass, length, beam, draught, 2, SEA), -0.072
    width, centre_bow = spacing - beam, centre_bow_fraction * length
    source = f"{AMIN}, table 1"
    return Design(
        name=name,
        title=title,
        hull=Hull(
            shape=RoundBilge(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 5.5,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.6,
                deadrise_angle=math.radians(15.0),
                entrance_angle=math.atan(1.3 * beam / length),
            ),
            count=2,
            spacing=spacing,
        ),
        wet_deck=WetDeck(
            aft=-0.48 * length,
            fore=length / 2,
            width=width,
            clearance=clearance,
            camber=0.4,
            corner_radius=0.8,
            centre_bow_length=centre_bow,
            centre_bow_depth=2.2,
            centre_bow_width=0.55 * width,
        ),
        masses=balanced_masses(
            mass, lcb * length, 4.0, gyradii=(0.38 * over_all[1], 0.26 * length, 0.27 * length)
        ),
        provenance=(
            published("length and breadth over all", f"{over_all[0]:g} m, {over_all[1]:g} m", source),
            published("waterline length", f"{length:g} m", source),
            published("hull spacing", f"{spacing:g} m", source),
            published("draught", f"{draught:g} m", source),
            published("displacement", f"{mass / 1000:g} t", source),
            published("centre bow length", f"{centre_bow_fraction:g} LWL", source),
            published("service speed", speed, source),
            derived(
                "place of the centre bow",
                f"x {length / 2 - centre_bow:.2f} to {length / 2:.2f} m",
                "its length counted aft from the fore end of the waterline",
            ),
            ours("beam of a demihull", f"{beam:g} m", "breadth over all less hull spacing; not given itself"),
            derived("block coefficient", f"{block:.4f}", "floats the published displacement at that beam"),
            ours(
                "LCB, transom ratio, deadrise",
                "-7.2 %, 0.6, 15 degrees",
                "not given; usual for wave piercers",
            ),
            ours("centre of gravity", "above the centre of buoyancy, 4.0 m above still water", "not given"),
            ours("gyradii", "0.38 breadth, 0.26 and 0.27 length", "not given; usual values"),
            ours(
                "wet deck and depth of the centre bow",
                f"clearance {clearance:g} m, centre bow 2.2 m deep and 0.55 of the tunnel wide",
                "not given; the centre bow is dry at rest, as on the ships",
            ),
        ),
    )
