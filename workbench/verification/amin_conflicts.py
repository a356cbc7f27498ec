"""Where [Amin]_ contradicts itself: what is printed, what its own numbers give, and what a reader should take.

.. [Amin] W. Amin, M. R. Davis, G. A. Thomas and D. S. Holloway, "Slamming quasi-static analysis of an Incat
    98-m high-speed wave piercing catamaran", University of Tasmania and Australian Maritime College, undated.
"""

from dataclasses import dataclass

import numpy as np

from workbench.verification import published
from workbench.wet_deck_pressure.load_distribution import INCAT_061

DISPLACEMENT = 1845.0
"""Of hull 061 [tonne] (table 1)."""


@dataclass(frozen=True, kw_only=True)
class Conflict:
    """A contradiction of the source.

    Parameters
    ----------
    place : sections and tables; printed : what they say; found : what follows from the source's numbers.
    """

    place: str
    printed: str
    found: str


def load_differences(instant: float) -> dict[str, float]:
    """How far the peak approach is above the simultaneous one in a slam [%], in three ways.

    "of simultaneous" and "of peak": relative differences of the loads; "of displacement": difference of
    load over displacement, in percentage points.
    """
    peak, together = (
        float(published.columns("amin_table_3", approach=name, instant=instant)["load_tonne"][0])
        for name in ("peak", "simultaneous")
    )
    return {
        "of simultaneous": 100 * (peak - together) / together,
        "of peak": 100 * (peak - together) / peak,
        "of displacement": 100 * (peak - together) / DISPLACEMENT,
    }


def section_stiffness(distance: str) -> np.ndarray:
    """EZ that the impulses of table 4 imply with a column of distances [tonne m]: one gauge has one."""
    table = published.columns("amin_table_4")
    return table["impulse_tonne_s"] * table[distance] / table["strain_integral"]


def origin_shift() -> np.ndarray:
    """Locations of table 4 less the frames that table 3 has for the same slams [m]."""
    fourth = published.columns("amin_table_4")
    frames = [
        published.columns("amin_table_3", approach="simultaneous", instant=float(instant))["frame"][0]
        for instant in fourth["instant"]
    ]
    return fourth["location"] - INCAT_061.from_transom(frames)


def conflicts() -> tuple[Conflict, ...]:
    """Return the contradictions with the numbers computed anew."""
    severest, weakest = load_differences(856.14), load_differences(773.89)
    printed, gauge = section_stiffness("printed_distance"), section_stiffness("gauge_distance")
    shift = origin_shift()
    return (
        Conflict(
            place="section 6 and conclusions",
            printed="peak strains give 48 % (later 45 %) more load than simultaneous ones in the severest slam, 14 % "
            "in the weakest",
            found=f"table 3: {severest['of simultaneous']:.1f} % and {weakest['of simultaneous']:.1f} % of the load; "
            f"{severest['of displacement']:.1f} and {weakest['of displacement']:.1f} are points of load over "
            "displacement, and 45 % is the weakest slam",
        ),
        Conflict(
            place="table 4, row of distances",
            printed="distances from gauge T1_5 at frame 25 are location less 55.8 m",
            found=f"with these the one gauge has EZ from {printed.min():.3g} to {printed.max():.3g} tonne m; counted "
            f"from 0.3 m forward of frame 25 it has {gauge.min():.4g} to {gauge.max():.4g}: the impulses "
            "are right, and the row counts from near frame 46 (gauge T1_6)",
        ),
        Conflict(
            place="tables 3 and 4, locations",
            printed="the same three slams",
            found=f"table 4 lies {shift.min():.2f} to {shift.max():.2f} m forward of the whole frames of table 3",
        ),
        Conflict(
            place="section 6, end of the centre bow",
            printed="the resultant at frame 64 is eight frames forward of the aft end of the centre bow",
            found=f"that is frame 56; 0.25 of the waterline is frame {INCAT_061.frame(INCAT_061.at_share(0.75)):.2f}",
        ),
        Conflict(
            place="section 7, impulses forward and aft",
            printed="forward gauges give more impulse since energy is lost along the hull",
            found="levers of the forward gauges are 2 to 4 m, or negative, so that eq. 3 is without weight there",
        ),
    )
