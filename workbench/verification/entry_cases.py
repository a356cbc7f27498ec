"""Water entry of sections: the exact wedge against published values, and every theory against the exact wedge."""

import numpy as np

from workbench.impact import generalised_wagner
from workbench.impact.entry import entry
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.impact.similarity import similarity_solution
from workbench.verification import published
from workbench.verification.case import Case

EXACT_SOURCE = "Z. N. Dobrovol'skaya, J. Fluid Mech. 36, 805-829, 1969; numbers of an independent program"
EXACT = {10: (77.69831, 212.95466), 30: (6.89476, 14.02010)}
"""Peak coefficient and force coefficient of the exact wedge by deadrise [degrees], of the independent program."""

BAND = 0.05
"""A theory agrees with the exact wedge within this share."""

MISSES = {
    ("wagner", 10, "force"): (
        249.317,
        "linear pressure on the wetted part is too much at any finite deadrise",
    ),
    ("wagner", 30, "force"): (23.2547, "a theory of small deadrise"),
    ("wagner", 30, "peak"): (7.40220, "a theory of small deadrise"),
    ("von-karman", 10, "force"): (101.044, "without pile-up the wetted part is too narrow by pi/2"),
    ("von-karman", 30, "force"): (9.42478, "without pile-up the wetted part is too narrow"),
    ("logvinovich", 10, "peak"): (81.7973, "its peak pi**2/(4 sin**2) - sin**2 lies above Wagner's"),
    ("logvinovich", 30, "peak"): (9.61960, "its peak pi**2/(4 sin**2) - sin**2 lies above Wagner's"),
    ("logvinovich", 30, "force"): (15.0857, "beyond about 25 degrees the model has too much force"),
    ("generalised-wagner", 30, "peak"): (
        7.69610,
        "the model keeps the water beside the section level, which is wrong at large deadrise",
    ),
}
"""What each theory misses: its figure, and the reason."""

SQUARE = 4.754
"""Added mass of a square over rho a**2, a half of its side, in any direction."""


def wedge_values(method: str, degrees: float) -> tuple[float, float]:
    """Return peak coefficient and force coefficient F/(rho V**3 t) of a wedge."""
    found = entry(Wedge(np.radians(degrees)), 2.0, method, 1000.0, [0.5]).isel(time=0)
    return float(found["peak_coefficient"]), float(found["section_force"]) / (1000.0 * 8.0 * 0.5)


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_published_cases(), *_theory_cases(), *_closed_cases()]


def _published_cases() -> list[Case]:
    source = published.citation("zhao_1993_wedge")
    note = "quoted in later literature, not read in the paper; the converged solution is up to 0.9 % lower"
    made = []
    for row in published.rows("zhao_1993_wedge"):
        degrees = float(row["deadrise_deg"])
        beta = np.radians(degrees)
        peak, force = float(row["peak_coefficient"]), float(row["force_coefficient"])
        quantities = (
            (
                "peak",
                "peak pressure over rho V2/2",
                peak,
                0.01 * peak,
                lambda b: 2 * similarity_solution(b).peak,
            ),
            ("force", "force over rho V3 t", force, 0.01 * force, lambda b: similarity_solution(b).force),
            ("height", "height of the peak over V t", float(row["peak_height"]), 0.004, _peak_height),
        )
        made += [
            Case(
                id=f"wedge-{degrees:g}-exact-{name}",
                title=f"Wedge of {degrees:g} degrees, similarity solution: {words}",
                kind="published",
                source=source,
                published=number,
                computed=lambda beta=beta, quantity=quantity: quantity(beta),
                tolerance=tolerance,
                note=note,
            )
            for name, words, number, tolerance, quantity in quantities
        ]
    return made


def _peak_height(beta: float) -> float:
    return similarity_solution(beta).peak_position * np.sin(beta) - 1


def _theory_cases() -> list[Case]:
    made = []
    for method in ("von-karman", "wagner", "logvinovich", "generalised-wagner", "nonlinear", "similarity"):
        for degrees, exact in EXACT.items():
            for index, quantity in enumerate(("peak", "force")):
                if method == "von-karman" and quantity == "peak":
                    continue
                figure, reason = MISSES.get((method, degrees, quantity), (None, ""))
                made.append(
                    Case(
                        id=f"wedge-{degrees}-{method}-{quantity}",
                        title=f"Wedge of {degrees} degrees, {method}: {quantity} coefficient against the exact one",
                        kind="second code" if method == "similarity" else "second method",
                        source=EXACT_SOURCE,
                        published=exact[index],
                        computed=lambda m=method, d=degrees, i=index: wedge_values(m, d)[i],
                        tolerance=(1e-5 if method == "similarity" else BAND) * exact[index],
                        miss=reason,
                        miss_figure=figure,
                        miss_band=1e-4 * figure if figure else 0.0,
                    )
                )
    return made


def _force(section, method: str, depth: float) -> float:
    return float(entry(section, 1.0, method, 1.0, [depth])["section_force"][0])


def _square_added_mass() -> float:
    flow = generalised_wagner.wedge_flow(np.pi / 4)
    half = -2 * np.trapezoid(flow.potential * flow.slope_factor, flow.stretched)
    return float(2 * half * 2)


def _chine_force() -> float:
    """Generalised Wagner force of a 30 degree wedge given as a table, over that of the wedge itself."""
    table = TableSection(tuple((y, y * np.tan(np.pi / 6)) for y in (0.0, 1.0, 2.0, 3.0)))
    return _force(table, "generalised-wagner", 0.7) / _force(Wedge(np.pi / 6), "generalised-wagner", 0.7)


def _closed_cases() -> list[Case]:
    wagner, karman = "H. Wagner, ZAMM 12, 193-215, 1932", "T. von Karman, NACA TN 321, 1929"
    korobkin = "A. A. Korobkin, European J. Appl. Math. 15, 821-838, 2004"
    beta = np.radians(20)
    s0 = _logvinovich_edge(beta)
    pile = np.pi / np.tan(beta)
    logvinovich = (
        pile / 2 * (pile * np.arcsin(s0) - np.cos(beta) ** 2 * np.arctanh(s0) - s0 * np.sin(beta) ** 2)
    )
    rows = (
        ("entry-circle-wagner", "Circle at first contact, Wagner: force over rho V2 R", wagner, 2 * np.pi,
         lambda: _force(Circle(1.0), "wagner", 1e-7), 1e-5),
        ("entry-circle-von-karman", "Circle at first contact, von Karman: force over rho V2 R", karman, np.pi,
         lambda: _force(Circle(1.0), "von-karman", 1e-7), 1e-5),
        ("entry-parabola-wagner", "Parabola, Wagner: force over rho V2 R at any depth", wagner, 2 * np.pi,
         lambda: _force(Parabola(3.0), "wagner", 0.4) / 3, 1e-9),
        ("entry-logvinovich-force", "Wedge of 20 degrees, modified Logvinovich model: force over rho V3 t", korobkin,
         logvinovich, lambda: wedge_values("logvinovich", 20)[1], 1e-6),
        ("entry-square-added-mass", "Flow of the generalised Wagner model at 45 degrees: added mass of a square",
         "Added mass of a square, 1.51 pi rho a2 (J. N. Newman, Marine Hydrodynamics, 1977, table 4.3)", SQUARE,
         _square_added_mass, 2e-3),
        ("entry-map-of-a-table", "Generalised Wagner force of a wedge by the map of any section, over the wedge's own",
         "closed map of the wedge", 1.0, _chine_force, 1e-3),
    )  # fmt: skip
    return [
        Case(
            id=name,
            title=title,
            kind="second method" if "table" in name else "closed form",
            source=source,
            published=float(known),
            computed=computed,
            tolerance=tolerance,
        )
        for name, title, source, known, computed, tolerance in rows
    ]


def _logvinovich_edge(beta: float) -> float:
    pile = np.pi / np.tan(beta)
    root = (pile + np.sqrt(pile**2 - np.sin(2 * beta) ** 2)) / (2 * np.cos(beta) ** 2)
    return float(np.sqrt(1 - 1 / root**2))
