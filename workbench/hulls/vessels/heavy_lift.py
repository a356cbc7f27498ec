"""The heavy-lift catamaran of 198 m and its model of 1.1 m."""

import dataclasses

from workbench.design import Design, Hull, WetDeck
from workbench.hulls.vessels.fitting import balanced_masses
from workbench.hulls.vessels.provenance import BAGGUS, derived, ours, published
from workbench.shapes import HeavyLiftBox

SCALE = 180.0

BOW_LENGTH, STERN_LENGTH = 70.44, 48.17
"""Of the demihull, so that it floats the published mass at the published centre of gravity [m]."""


def heavy_lift_198() -> Design:
    """Return the heavy-lift catamaran of 198 m, box-like demihulls."""
    return Design(
        name="heavy-lift-198",
        title="Heavy-lift catamaran, 198 m",
        hull=Hull(
            shape=HeavyLiftBox(
                length=198.0,
                beam=25.0,
                draught=10.5,
                depth=26.0,
                bilge_radius=3.0,
                bow_length=BOW_LENGTH,
                stern_length=STERN_LENGTH,
            ),
            count=2,
            spacing=65.0,
        ),
        wet_deck=WetDeck(
            aft=-73.98,
            fore=63.0,
            width=40.0,
            clearance=7.14,
            entry_length=5.04,
            entry_rise=5.04,
            corner_radius=4.86,
        ),
        masses=balanced_masses(84.662e6, -3.0, 14.5, gyradii=(31.0, 50.0, 56.0), roll_damping_ratio=0.03),
        density=1000.0,
        provenance=(
            published("length, breadth, depth, draught", "198, 90, 26, 10.5 m", f"{BAGGUS}, table 2.2"),
            published("mass", "84662 t", f"{BAGGUS}, table 2.2"),
            published(
                "centre of gravity", "LCG 96 m from aft, TCG 0, VCG 25 m above keel", f"{BAGGUS}, table 2.2"
            ),
            derived(
                "breadth of a demihull", "25 m", "inner side at 0.111 m of the model, table 5.1, times 180"
            ),
            derived("distance between centre planes", "65 m", "breadth less the breadth of a demihull"),
            derived(
                "height of the wet deck",
                "7.14 m above still water",
                "0.098 m of the model above keel, table 5.1",
            ),
            derived(
                "flat part of the wet deck", "x -68.9 to 58.0 m", "0.167 to 0.872 m of the model, table 5.1"
            ),
            derived("corner radius", "4.86 m", "side radius from 0.071 to 0.098 m of the model, table 5.1"),
            derived(
                "fore end of the wet deck",
                "rises 5.04 m over 5.04 m",
                "quarter circle of 0.028 m of the model, table 5.1, here its chord",
            ),
            derived("density", "1000 kg/m3", "the source scales mass with the cube of the length only"),
            ours(
                "bilge radius, lengths of bow and stern",
                f"3, {BOW_LENGTH:g}, {STERN_LENGTH:g} m",
                "lines are not given; chosen to float the published mass at the published LCG",
            ),
            ours("gyradii", "31, 50, 56 m", "not given; 0.34 breadth, 0.25 and 0.28 length"),
        ),
    )


def heavy_lift_198_model() -> Design:
    """Return the model of 1.1 m at its target draught."""
    ship = heavy_lift_198()
    model = ship.scaled(1.0 / SCALE)
    return dataclasses.replace(
        model,
        name="heavy-lift-198-model",
        title="Heavy-lift catamaran, model of 1.1 m",
        provenance=(
            *ship.provenance,
            derived("scale", "1 : 180", f"198 m / 1.1 m, {BAGGUS}, table 2.2"),
            published("mass of the model, target", "14.52 kg (as produced 15.89 kg)", f"{BAGGUS}, table 2.2"),
        ),
    )
