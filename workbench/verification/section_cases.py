"""Two-dimensional sections against series solutions: one circle [Ursell1949]_, two [Wang1971]_, Lewis forms.

.. [Ursell1949] F. Ursell, "On the heaving motion of a circular cylinder on the surface of a
    fluid", Q. J. Mech. Appl. Math. 2, 218-231, 1949.
.. [Wang1971] S. Wang and R. Wahab, "Heaving oscillations of twin cylinders in a free surface",
    J. Ship Res. 15, 33-48, 1971.
"""

from functools import cache

import numpy as np

from workbench.conventions import GRAVITY
from workbench.hydrodynamics.section_contours import section_coefficients
from workbench.verification import published
from workbench.verification.case import Case

SWAY, HEAVE = 0, 1
PANELS = 100
CIRCLE_POINTS = ("0.05", "0.50", "1.00", "2.50", "10.0")
TWIN_POINTS = {1.5: (0.2, 0.5, 1.0, 2.0), 2.0: (0.2, 0.4, 0.8, 2.0)}
PISTON = {1.5: 0.6531, 2.0: 0.4423}
"""Reduced frequencies k a of largest heave damping between two circles, by the same multipoles."""


def half_circle(centre: float = 0.0) -> np.ndarray:
    """Half-immersed circle of radius 1 m."""
    angle = np.linspace(-np.pi, 0.0, PANELS + 1)
    return np.stack([centre + np.cos(angle), np.sin(angle)], axis=-1)


@cache
def _reduced(ka: tuple[float, ...], half_spacing: float = 0.0) -> np.ndarray:
    """Added mass and damping (2, ka, 3, 3) over rho pi a^2/2 (times omega), per hull."""
    omega = np.sqrt(GRAVITY * np.array(ka))
    twin = half_spacing > 0
    density = 1 / np.pi if twin else 2 / np.pi
    found = section_coefficients(
        [half_circle(half_spacing)], omega, density=density, panels=PANELS, mirrored=twin
    )
    return np.array([found.added_mass, found.damping / omega[:, None, None]])


@cache
def _piston_peak(half_spacing: float) -> float:
    """Reduced frequency k a of the largest heave damping of two circles."""
    ka = PISTON[half_spacing] + np.linspace(-0.02, 0.02, 161)
    damping = _reduced(tuple(ka.tolist()), half_spacing)[1, :, HEAVE, HEAVE]
    return float(ka[damping.argmax()])


def lewis_added_mass(a1: float, a3: float) -> tuple[float, float]:
    """Heave added mass at infinite frequency over rho of a Lewis form: the closed form, and computed."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, 401)
    y = (1 + a1) * np.sin(angle) - a3 * np.sin(3 * angle)
    z = -((1 - a1) * np.cos(angle) + a3 * np.cos(3 * angle))
    z[[0, -1]] = 0.0
    found = section_coefficients([np.stack([y, z], axis=-1)], np.inf, density=1.0, panels=PANELS)
    return float(np.pi / 2 * ((1 + a1) ** 2 + 3 * a3**2)), float(found.added_mass[0, HEAVE, HEAVE])


def _circle_cases() -> list[Case]:
    table = "ursell_1949_half_immersed_cylinder"
    made = []
    for row in published.rows(table):
        if row["ka"] not in CIRCLE_POINTS:
            continue
        ka = float(row["ka"])
        for column, part, mode in (("A33", 0, HEAVE), ("B33", 1, HEAVE), ("A22", 0, SWAY), ("B22", 1, SWAY)):
            made.append(
                Case(
                    id=f"section-circle-{column}-{ka:g}".lower().replace(".", "-"),
                    title=f"{column} of a half-immersed circle at ka = {ka:g}, section solver",
                    kind="published",
                    source=published.citation(table),
                    published=float(row[column]),
                    computed=lambda ka=ka, part=part, mode=mode: _reduced((ka,))[part, 0, mode, mode],
                    tolerance=0.01 * float(row[column]),
                )
            )
    return made


def _twin_cases() -> list[Case]:
    table = "wang_1971_twin_cylinders"
    made = []
    for row in published.rows(table):
        spacing, ka = float(row["b_over_a"]), float(row["ka"])
        if ka not in TWIN_POINTS[spacing]:
            continue
        for column, part in (("A33", 0), ("B33", 1)):
            made.append(
                Case(
                    id=f"section-twin-{column}-{spacing:g}-{ka:g}".lower().replace(".", "-"),
                    title=f"{column} of each of two circles at b/a = {spacing:g}, ka = {ka:g}",
                    kind="published",
                    source=published.citation(table),
                    published=float(row[column]),
                    computed=lambda ka=ka, spacing=spacing, part=part: _reduced((ka,), spacing)[
                        part, 0, HEAVE, HEAVE
                    ],
                    tolerance=0.003,
                )
            )
    for spacing, peak in PISTON.items():
        made.append(
            Case(
                id=f"section-piston-{spacing:g}".replace(".", "-"),
                title=f"ka of the piston resonance between two circles at b/a = {spacing:g}",
                kind="published",
                source=published.citation(table),
                published=peak,
                computed=lambda spacing=spacing: _piston_peak(spacing),
                tolerance=5e-4,
            )
        )
    return made


def cases() -> list[Case]:
    """Return the cases of this module."""
    lewis = [
        Case(
            id=f"section-lewis-{number}",
            title=f"heave added mass over rho of a Lewis form at infinite frequency, a1 = {a1:g}, a3 = {a3:g}",
            kind="closed form",
            source="F. M. Lewis, The inertia of the water surrounding a vibrating ship, Trans. SNAME 37, 1-20, 1929",
            published=lewis_added_mass(a1, a3)[0],
            computed=lambda a1=a1, a3=a3: lewis_added_mass(a1, a3)[1],
            tolerance=0.006,
            unit="m2",
        )
        for number, (a1, a3) in enumerate(((0.2, -0.1), (-0.3, 0.05)), start=1)
    ]
    return [*_circle_cases(), *_twin_cases(), *lewis]
