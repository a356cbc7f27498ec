"""Water beside an entering section: Wagner's surface in closed form, what was displaced, and the exact wedge's."""

import numpy as np

from workbench.impact.free_surface import level_elevation, wagner_elevation
from workbench.impact.generalised_wagner import wedge_flow
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.impact.similarity import similarity_solution
from workbench.verification.case import Case

WAGNER = "H. Wagner, ZAMM 12, 193-215, 1932"
WETTED = 1.3
TABLE = TableSection(((0.0, 0.0), (0.5, 0.0), (1.0, 0.1), (2.0, 0.5)))


def displaced_over_raised(section) -> float:
    """Water raised beside a section by Wagner's theory, over what the section has displaced."""
    x = np.linspace(0.0, 14.0, 4001)
    raised = np.trapezoid(wagner_elevation(section, WETTED, WETTED * np.cosh(x)) * WETTED * np.sinh(x), x)
    inside = np.linspace(0.0, WETTED, 4001)
    return float(raised / np.trapezoid(section.mean_height(WETTED) - section.height(inside), inside))


def surface_over_exact(method: str, ratio: float, degrees: float = 2.0) -> float:
    """Elevation beside a wedge [degrees] at a half-breadth, in wetted ones of Wagner, over the exact one."""
    wedge = Wedge(np.radians(degrees))
    y = ratio * np.pi / 2 / np.tan(wedge.deadrise_angle)
    exact = similarity_solution(wedge.deadrise_angle).surface
    outer = exact[int(exact.real.argmin()) :]  # before it the jet overhangs
    known = np.exp(np.interp(np.log(y), np.log(outer.real), np.log(outer.imag)))
    found = (
        wagner_elevation(wedge, y / ratio, y)
        if method == "wagner"
        else level_elevation(wedge.deadrise_angle, 1.0, y)
    )
    return float(found / known)


def cases() -> list[Case]:
    """Return the cases of this module."""
    beta, y = np.radians(20), 1.5 * WETTED
    depth = 2 / np.pi * WETTED * np.tan(beta)
    edge = wedge_flow(beta).spread
    rows = [
        ("water-beside-wedge", "Wedge of 20 degrees, Wagner: elevation at 1.5 wetted half-breadths",
         2 / np.pi * y * np.tan(beta) * np.arcsin(1 / 1.5) - depth,
         lambda: float(wagner_elevation(Wedge(beta), WETTED, y)), 1e-12, "m", "closed form"),
        ("water-beside-parabola", "Parabola of 5 m radius, Wagner: elevation at 1.5 wetted half-breadths",
         y / 10 * (y - np.sqrt(y**2 - WETTED**2)) - WETTED**2 / 20,
         lambda: float(wagner_elevation(Parabola(5.0), WETTED, y)), 1e-12, "m", "closed form"),
        ("water-raised-by-circle", "Circle, Wagner: water raised over water displaced", 1.0,
         lambda: displaced_over_raised(Circle(2.0)), 1e-4, "-", "closed form"),
        ("water-raised-by-table", "Section of points, Wagner: water raised over water displaced", 1.0,
         lambda: displaced_over_raised(TABLE), 1e-4, "-", "closed form"),
        ("water-meets-wedge", "Wedge of 20 degrees, generalised Wagner model: elevation at the edge over the side's",
         1.0, lambda: float(level_elevation(beta, 1.0, edge) / (edge * np.tan(beta) - 1)), 1e-7, "-", "closed form"),
        ("water-wagner-far", "Wedge of 2 degrees, Wagner: elevation at 3 half-breadths over the exact one", 1.0,
         lambda: surface_over_exact("wagner", 3.0), 0.025, "-", "second method"),
        ("water-generalised-far", "Wedge of 2 degrees, generalised Wagner model: the same", 1.0,
         lambda: surface_over_exact("generalised-wagner", 3.0), 0.025, "-", "second method"),
    ]  # fmt: skip
    return [
        Case(
            id=name,
            title=title,
            kind=kind,
            source=WAGNER if kind == "closed form" and "meets" not in name else _SOURCES[name],
            published=float(known),
            computed=computed,
            tolerance=tolerance,
            unit=unit,
            note=_NOTE if name.endswith("far") else "",
        )
        for name, title, known, computed, tolerance, unit, kind in rows
    ]


_NOTE = "the difference grows with the deadrise: at 10 degrees 9 % by Wagner, 11 % by the generalised model"
_SOURCES = {
    "water-meets-wedge": "R. Zhao, O. M. Faltinsen and J. V. Aarsnes, 21st Symp. Naval Hydrodynamics, 1996",
    "water-wagner-far": "exact wedge of Z. N. Dobrovol'skaya, J. Fluid Mech. 36, 805-829, 1969",
    "water-generalised-far": "exact wedge of Z. N. Dobrovol'skaya, J. Fluid Mech. 36, 805-829, 1969",
}
