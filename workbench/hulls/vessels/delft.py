"""The Delft 372 catamaran model, from its own offsets."""

from importlib.resources import files

from workbench.design import Design, Hull, MassProperties, WetDeck
from workbench.hulls.offset_files import offsets_from_csv
from workbench.hulls.vessels.provenance import VEER, VEER_BASIN, derived, ours, published

OFFSETS_FILE = "delft-372-offsets.csv"


def delft_372() -> Design:
    """Return the 372 model of Delft: 3 m, two demihulls 0.70 m apart, fresh water."""
    table = files("workbench").joinpath("data", "designs", OFFSETS_FILE).read_text(encoding="utf-8")
    shape = offsets_from_csv(table, draught=0.15, length=3.00, unit=0.1)
    return Design(
        name="delft-372",
        title="Delft 372 catamaran model",
        hull=Hull(shape=shape, count=2, spacing=0.70),
        wet_deck=WetDeck(
            aft=-1.45, fore=1.20, width=0.46, clearance=0.107, entry_length=0.30, entry_rise=0.04
        ),
        masses=MassProperties(
            mass=87.07,
            centre_of_gravity=(-0.09, 0.0, 0.19),
            roll_gyradius=0.389,
            pitch_gyradius=0.782,
            yaw_gyradius=0.930,
            roll_damping_ratio=0.03,
        ),
        density=1000.0,
        provenance=(
            published("offsets of one demihull", "23 stations and the profile of the stem", VEER),
            published("length between perpendiculars", "3.00 m (over all 3.11 m)", VEER),
            published("distance between centre planes", "0.70 m", VEER),
            published("draught", "0.15 m, even keel", VEER),
            published("displacement", "87.07 kg", VEER),
            published("centre of gravity, x", "1.41 m forward of the aft perpendicular: -0.09 m", VEER),
            published("centre of gravity, height", "0.34 m above the keel (towing tank): +0.19 m", VEER),
            published("pitch gyradius", "0.782 m (towing tank; 0.810 m in the seakeeping basin)", VEER),
            published("roll gyradius", "0.389 m (seakeeping basin)", VEER_BASIN),
            published("yaw gyradius", "0.930 m (seakeeping basin)", VEER_BASIN),
            published("density of the water", "1000 kg/m3 (towing tank)", VEER),
            derived(
                "width of the wet deck",
                "0.46 m",
                "distance between centre planes less the breadth 0.24 m of one demihull",
            ),
            ours(
                "wet deck",
                "x -1.45 to 1.20 m, clearance 0.107 m, entry rising 0.04 m over 0.30 m",
                "none was fitted to the model; Froude-scaled from a ferry of 62 m with a clearance of 2.2 m",
            ),
            ours("roll damping ratio", "0.03", "usual for a slender catamaran model"),
        ),
    )
