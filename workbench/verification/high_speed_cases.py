"""High-speed theory: long cylinders [Ursell1949]_ [Wang1971]_, impulsive start, strips, hulls far apart.

.. [Ursell1949] F. Ursell, "On the heaving motion of a circular cylinder on the surface of a
    fluid", Q. J. Mech. Appl. Math. 2, 218-231, 1949.
.. [Wang1971] S. Wang and R. Wahab, "Heaving oscillations of twin cylinders in a free surface",
    J. Ship Res. 15, 33-48, 1971.
"""

from dataclasses import replace
from functools import cache

import numpy as np

from workbench.conventions import GRAVITY
from workbench.design import Hull
from workbench.hydrodynamics import high_speed, strip_theory
from workbench.hydrodynamics.cross_plane import Water, passage
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.marched_contour import section_weights
from workbench.hydrodynamics.section_contours import section_wave_forces
from workbench.shapes import Wigley
from workbench.verification import delft, published
from workbench.verification.case import Case
from workbench.verification.cylinder_march import arc, contour_of, extrapolated
from workbench.verification.section_cases import half_circle

SWAY, HEAVE = 0, 1
KA = (1.0, 2.0)
SLENDER = Hull(shape=Wigley(length=40.0, beam=2.0, draught=1.2, depth=5.0))
OURS = "two ways to compute the same in this package"


def _cylinder(column: str, ka: float, half_spacing: float = 0.0) -> float:
    """Added mass over rho pi a^2/2, or damping over that times omega, of each cylinder."""
    found = extrapolated(KA, (np.pi,), half_spacing=half_spacing)
    mode = int(column[1]) - 2
    row = KA.index(ka)
    scale = np.pi / 2 * (2 if half_spacing else 1)
    if column.startswith("A"):
        return float(found.added_mass[row, mode, mode] / scale)
    return float(found.damping[row, mode, mode] / scale / np.sqrt(GRAVITY * ka))


def _scattered(ka: float) -> float:
    """Heave force of diffraction in head waves over that of the section solver [-]."""
    omega = np.sqrt(GRAVITY * ka)
    known = section_wave_forces([half_circle()], [omega], np.pi, density=1.0).diffraction[0, HEAVE]
    return float(
        np.abs(extrapolated(KA, (np.pi,), half_spacing=0.0).diffraction[KA.index(ka), 0, HEAVE] / known - 1)
    )


def _impulse(mode: int) -> float:
    """Added mass of a half circle, pushed at once, over rho pi a^2/2."""
    contour = contour_of(arc(panels=60, half=True))
    push = (section_weights(contour)[mode] / contour.lengths)[:, None]
    water = Water(10.0, 0.11, 1 if mode == HEAVE else -1)
    found = passage([contour], 0.01, water, lambda number, section: push, 1).section_potential
    return float(-found[0, 0, mode, 0].real / (np.pi / 2))


@cache
def _heave(theory: str, hull: Hull, froude_number: float, omega: float, interaction: str) -> complex:
    """Radiation force of heave by heave, omega^2 A + i omega B, in beam waves."""
    speed = froude_number * np.sqrt(GRAVITY * hull.length)
    if theory == "strip":
        found = strip_theory.hydrodynamics(hull, 1000.0, [omega], [np.pi / 2], speed)
    else:
        settings = HighSpeedSettings(interaction=interaction)
        found = high_speed.hydrodynamics(hull, 1000.0, [omega], [np.pi / 2], speed, settings)
    a, b = (float(found[name][0, 0, 2, 2]) for name in ("added_mass", "radiation_damping"))
    return omega**2 * a + 1j * omega * b


def cases() -> list[Case]:
    """Return the cases of this module."""
    made = []
    for table, half_spacing, tolerance in (
        ("ursell_1949_half_immersed_cylinder", 0.0, 0.025),
        ("wang_1971_twin_cylinders", 1.5, 0.06),
    ):
        for row in published.rows(table):
            ka = float(row["ka"])
            if ka not in KA or (half_spacing and (ka != 2.0 or float(row["b_over_a"]) != half_spacing)):
                continue
            for column in ("A33", "B33") if half_spacing else ("A33", "B33", "A22", "B22"):
                words = "each of two long cylinders" if half_spacing else "a long cylinder"
                made.append(
                    Case(
                        id=f"high-speed-{'twin' if half_spacing else 'cylinder'}-{column}-{ka:g}".lower(),
                        title=f"{column} of {words} far behind its bow, ka = {ka:g}, high-speed theory",
                        kind="published",
                        source=published.citation(table),
                        published=float(row[column]),
                        computed=lambda column=column, ka=ka, half_spacing=half_spacing: _cylinder(
                            column, ka, half_spacing
                        ),
                        tolerance=tolerance * float(row[column]),
                    )
                )
    for name, mode, known in (("heave", HEAVE, 1.0), ("sway", SWAY, 4 / np.pi**2)):
        made.append(
            Case(
                id=f"high-speed-impulse-{name}",
                title=f"{name} of a half circle pushed at once: added mass over rho pi a^2/2",
                kind="closed form",
                source="pressure-release image of the circle; for sway 4/pi^2",
                published=known,
                computed=lambda mode=mode: _impulse(mode),
                tolerance=0.01 * known,
            )
        )
    wide = replace(delft.model().hull, spacing=6.0)
    made += [
        Case(
            id="high-speed-diffraction",
            title="diffraction force on a long cylinder in head waves, ka = 1: difference from the section solver",
            kind="second method",
            source=OURS,
            published=0.0,
            computed=lambda: _scattered(1.0),
            tolerance=0.02,
        ),
        Case(
            id="high-speed-strips",
            title="heave of a slender Wigley hull, short encounters at Fn 0.3: high-speed over strip theory, less 1",
            kind="second method",
            source=OURS,
            published=0.0,
            computed=lambda: abs(
                _heave("march", SLENDER, 0.3, 8.0, "off") / _heave("strip", SLENDER, 0.3, 8.0, "") - 1
            ),
            tolerance=0.05,
        ),
        Case(
            id="high-speed-far-apart",
            title="heave of the Delft 372 with hulls 6 m apart at Fn 0.5: both together over each alone, less 1",
            kind="trend",
            source="hulls far apart do not feel each other",
            published=0.0,
            computed=lambda: abs(
                _heave("march", wide, 0.5, 6.0, "on") / _heave("march", wide, 0.5, 6.0, "off") - 1
            ),
            tolerance=0.05,
        ),
    ]
    return made
