"""The ten demihulls of Couser's systematic series, each as a catamaran with separation/length 0.2."""

import math

from workbench.design import Design, Hull, WetDeck
from workbench.hulls.vessels.fitting import balanced_masses
from workbench.hulls.vessels.provenance import COUSER, derived, ours, published
from workbench.shapes import RoundBilge

LENGTH = 1.6
SEPARATION_RATIO = 0.2
BLOCK_COEFFICIENT, LCB = 0.397, -0.064

RATIOS = {
    "3b": (7.0, 2.0),
    "4a": (10.4, 1.5),
    "4b": (9.0, 2.0),
    "4c": (8.0, 2.5),
    "5a": (12.8, 1.5),
    "5b": (11.0, 2.0),
    "5c": (9.9, 2.5),
    "6a": (15.1, 1.5),
    "6b": (13.1, 2.0),
    "6c": (11.7, 2.5),
}
"""Length/beam and beam/draught of every model (table 4.2)."""


def npl_model(model: str) -> Design:
    """Return one model of the series, such as '5b'."""
    length_beam, beam_draught = RATIOS[model]
    beam = LENGTH / length_beam
    draught = beam / beam_draught
    freeboard = 0.06 * LENGTH
    shape = RoundBilge(
        length=LENGTH,
        beam=beam,
        draught=draught,
        depth=draught + freeboard,
        block_coefficient=BLOCK_COEFFICIENT,
        lcb=LCB,
        transom_ratio=0.4,
        deadrise_angle=math.radians(30.0),
        entrance_angle=math.atan(1.25 / length_beam),
    )
    spacing = SEPARATION_RATIO * LENGTH
    mass = 1000.0 * 2 * BLOCK_COEFFICIENT * LENGTH * beam * draught
    return Design(
        name=f"npl-{model}",
        title=f"NPL-series catamaran {model}, separation/length 0.2",
        hull=Hull(shape=shape, count=2, spacing=spacing),
        wet_deck=WetDeck(
            aft=-0.48 * LENGTH,
            fore=0.40 * LENGTH,
            width=spacing - beam,
            clearance=0.04 * LENGTH,
            entry_length=0.12 * LENGTH,
            entry_rise=0.015 * LENGTH,
        ),
        masses=balanced_masses(
            mass,
            LCB * LENGTH,
            0.5 * draught,
            gyradii=(0.4 * (spacing + beam), 0.25 * LENGTH, 0.26 * LENGTH),
        ),
        density=1000.0,
        provenance=(
            published("length", "1.6 m", f"{COUSER}, table 4.2"),
            published(
                "length/beam, beam/draught", f"{length_beam:g}, {beam_draught:g}", f"{COUSER}, table 4.2"
            ),
            published("block coefficient, LCB", "0.397, -6.4 % of the length", f"{COUSER}, table 4.2"),
            published("separation/length", "0.2, one of the values tested", f"{COUSER}, table 2.1"),
            published("centre of gravity, height", "1.5 draughts above base", f"{COUSER}, table 7.1"),
            published("pitch gyradius", "0.25 lengths (models 4b, 5b, 6b)", f"{COUSER}, table 7.1"),
            derived("mass", f"{mass:.3f} kg", "two hulls of the published block coefficient, fresh water"),
            derived("centre of gravity, x", f"{LCB * LENGTH:.4f} m", "at the published LCB, level trim"),
            ours(
                "hull lines",
                "round-bilge family; transom ratio 0.4, deadrise 30 degrees",
                "offsets are not given; a stand-in of the published ratios, C_P is 0.693 in the source",
            ),
            ours("freeboard", "0.06 lengths", "not given"),
            ours("wet deck", "clearance 0.04 lengths", "not given; in proportion to fast ferries"),
            ours(
                "roll and yaw gyradii", "0.40 of the breadth, 0.26 of the length", "not given; usual values"
            ),
        ),
    )
