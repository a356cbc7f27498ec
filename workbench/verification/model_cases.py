"""The heavy-lift catamaran model of Baggus 2025: scaling and motions at rest, by the pattern of its table."""

import numpy as np

from workbench import pipeline
from workbench.hulls.library import design
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.verification import published
from workbench.verification.case import Case

NOTE = "hull lines and gyradii are not published: a stand-in, so below 6 rad/s only and roughly"


def _box_motion(omega: float, column: str) -> float:
    """Heave [m/m] or pitch [deg/mm] of the model of the heavy-lift catamaran in head waves at rest."""
    ship = pipeline.response(
        design("heavy-lift-198-model"), 0.0, [np.pi], [2.5, 5.0], PotentialFlowSettings(wave_field="incident")
    )
    rao = ship.motions.motion_rao.sel(omega=omega).values[0]
    if column == "heave_mm_per_mm":
        return float(np.abs(rao[2]))
    return float(np.degrees(np.abs(rao[4])) / 1000)


def cases() -> list[Case]:
    """Return the cases of this module."""
    source = published.citation("baggus_2025_table_3_1")
    units = {"heave_mm_per_mm": "mm/mm", "pitch_deg_per_mm": "deg/mm"}
    made = []
    for row in published.rows("baggus_2025_table_3_1")[:2]:
        omega = float(row["omega"])
        for column, unit in units.items():
            name = column.split("_")[0]
            made.append(
                Case(
                    id=f"baggus-{name}-{omega:g}".replace(".", "-"),
                    title=f"{name} of the heavy-lift catamaran model at {omega:g} rad/s, head waves, at rest",
                    kind="published",
                    source=source,
                    published=float(row[column]),
                    computed=lambda omega=omega, column=column: _box_motion(omega, column),
                    tolerance=0.2 * float(row[column]),
                    unit=unit,
                    note=NOTE,
                )
            )
    ship = design("heavy-lift-198").scaled(1 / 180)
    for name, label, unit, known, compute in (
        ("length", "length of the 1:180 model", "mm", 1100.0, lambda: 1000 * ship.hull.length),
        ("mass", "mass of the 1:180 model", "kg", 14.52, lambda: ship.masses.mass),
    ):
        made.append(
            Case(
                id=f"froude-scale-{name}",
                title=f"{label}, by Froude's law",
                kind="published",
                source=source,
                published=known,
                computed=compute,
                tolerance=0.001 * known,
                unit=unit,
            )
        )
    return made
