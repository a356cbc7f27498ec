"""Added mass and damping of a hemisphere [Hulme1982]_ and a half-immersed circular cylinder [Ursell1949]_.

.. [Hulme1982] A. Hulme, "The wave forces acting on a floating hemisphere undergoing forced
    periodic oscillations", J. Fluid Mech. 121, 443-463, 1982.
.. [Ursell1949] F. Ursell, "On the heaving motion of a circular cylinder on the surface of a
    fluid", Q. J. Mech. Appl. Math. 2, 218-231, 1949.
"""

from functools import cache

from workbench.verification import published
from workbench.verification.bodies import (
    HEAVE,
    SWAY,
    cylinder_coefficients,
    extrapolated,
    hemisphere_heave,
)
from workbench.verification.case import Case

HEMISPHERE = ("0.2", "1.0", "2.0", "3.0")
CYLINDER = ("0.50", "1.00", "2.00")
PANEL_NOTE = "limit of infinitely many panels, from 112 and 448 panels on the half"


@cache
def _hemisphere(reduced: float) -> tuple[float, float]:
    return extrapolated(hemisphere_heave(reduced, 8), hemisphere_heave(reduced, 16))


@cache
def _cylinder(reduced: float, mode: int) -> tuple[float, float]:
    return extrapolated(cylinder_coefficients(reduced, mode, 5), cylinder_coefficients(reduced, mode, 10))


def cases() -> list[Case]:
    """Return the cases of this module."""
    made = []
    source = published.citation("hulme_1982_hemisphere")
    for row in published.rows("hulme_1982_hemisphere"):
        if row["Ka"] not in HEMISPHERE:
            continue
        reduced = float(row["Ka"])
        for which, column in enumerate(("A33", "B33")):
            made.append(
                Case(
                    id=f"hemisphere-{column}-{reduced:g}".lower().replace(".", "-"),
                    title=f"{column} of a hemisphere at Ka = {reduced:g}",
                    kind="published",
                    source=source,
                    published=float(row[column]),
                    computed=lambda reduced=reduced, which=which: _hemisphere(reduced)[which],
                    tolerance=0.003,
                    note=PANEL_NOTE,
                )
            )
    made.append(
        Case(
            id="hemisphere-panel-error",
            title="A33 of a hemisphere at Ka = 1 with 896 panels, not extrapolated",
            kind="published",
            source=source,
            published=float(
                next(row for row in published.rows("hulme_1982_hemisphere") if row["Ka"] == "1.0")["A33"]
            ),
            computed=lambda: hemisphere_heave(1.0, 16)[0],
            tolerance=0.013,
            note="what a usual number of panels costs: 3 % of added mass on a body without a straight side",
        )
    )
    source = published.citation("ursell_1949_half_immersed_cylinder")
    for row in published.rows("ursell_1949_half_immersed_cylinder"):
        if row["ka"] not in CYLINDER:
            continue
        reduced = float(row["ka"])
        for column, mode, which in (("A33", HEAVE, 0), ("B33", HEAVE, 1), ("A22", SWAY, 0), ("B22", SWAY, 1)):
            made.append(
                Case(
                    id=f"cylinder-{column}-{reduced:g}".lower().replace(".", "-"),
                    title=f"{column} of a half-immersed circular cylinder at ka = {reduced:g}",
                    kind="published",
                    source=source,
                    published=float(row[column]),
                    computed=lambda reduced=reduced, mode=mode, which=which: _cylinder(reduced, mode)[which],
                    tolerance=0.012,
                    note="middle of a cylinder 20 diameters long, where the ends are felt by less than 0.01; "
                    "limit of infinitely many panels",
                )
            )
    return made
