"""Cruising multihulls: Sally Malay, as a stand-in."""

from workbench.design import Design, Hull, WetDeck
from workbench.hulls.vessels import fitting
from workbench.hulls.vessels.provenance import GRANDE, derived, ours, published
from workbench.sails import tapered_sail_plan
from workbench.shapes import SlenderRacing

SEA = 1025.0
FOOT = 0.3048


def sally_malay() -> Design:
    """Return a stand-in for the 36 ft cruiser/racer Sally Malay by Kurt Hughes."""
    mass, length, beam, block, lcb, breadth = 2600.0, 10.4, 0.80, 0.45, -0.030, 6.0
    draught = fitting.draught(mass, length, beam, block, 2, SEA)
    spacing = breadth - beam
    sails = tapered_sail_plan(6.2, 1.2, 1.6, 15.6, 1.2)
    source = f"{GRANDE}, 3.4.1"
    return Design(
        name="sally-malay",
        title="Sally Malay, 36 ft cruising catamaran (stand-in)",
        hull=Hull(
            shape=SlenderRacing(
                length=length,
                beam=beam,
                draught=draught,
                depth=draught + 1.0,
                block_coefficient=block,
                lcb=lcb,
                transom_ratio=0.15,
            ),
            count=2,
            spacing=spacing,
        ),
        wet_deck=WetDeck(
            aft=-3.2, fore=2.0, width=spacing - beam, clearance=0.55, entry_length=0.8, entry_rise=0.20
        ),
        masses=fitting.balanced_masses(
            mass, lcb * length, 0.8, gyradii=(0.32 * breadth, 0.27 * length, 0.30 * length)
        ),
        sail_plan=sails,
        provenance=(
            published("length over all", f"36 ft ({36 * FOOT:.2f} m), stretched from 30 ft", source),
            published("kind of ship", "cruiser/racer by Kurt Hughes, fractional rig", source),
            published("kind of hull", "narrow, symmetric; canted daggerboards; low bridgedeck", source),
            published("usual speed", "6 to 9 kn upwind, 6 to 20 kn downwind", source),
            ours("breadth over all", f"{breadth:g} m", "missing in the source, which has no table of her"),
            ours("displacement", f"{mass:g} kg", "missing in the source; usual for the length and kind"),
            ours("waterline length", f"{length:g} m", "missing in the source; nearly upright stems"),
            ours("beam of a hull", f"{beam:g} m", "missing in the source; length/beam 13 for narrow hulls"),
            ours("block coefficient, LCB, transom ratio", "0.45, -3 %, 0.15", "missing in the source; usual"),
            derived("draught", f"{draught:.3f} m", "floats that displacement"),
            ours("distance between centre planes", f"{spacing:.2f} m", "breadth less the beam of a hull"),
            ours(
                "wet deck",
                "clearance 0.55 m, x -3.2 to 2.0 m, raked over its first 0.8 m",
                "missing in the source but for being low",
            ),
            ours("centre of gravity", "above the centre of buoyancy, 0.8 m above still water", "missing in the source"),
            ours("gyradii", "0.32 breadth, 0.27 and 0.30 length", "missing in the source; usual, with the rig"),
            ours(
                "sail plan",
                f"{sails.area:.0f} m2 from 1.6 to 15.6 m, chord 6.2 m tapering to 1.2 m, lift coefficient 1.2",
                "missing in the source; usual for the kind",
            ),
            ours("daggerboards", "left out", "their area, place and cant are missing in the source"),
        ),
    )  # fmt: skip
