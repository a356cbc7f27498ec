"""Non-linear water entry: against the exact wedge, the published k, other theories, and its own balances."""

from collections.abc import Callable

import numpy as np
from scipy.integrate import quad

from workbench.impact import nonlinear_start
from workbench.impact.boundary_elements import far_source
from workbench.impact.entry import VelocityHistory, entry
from workbench.impact.nonlinear import March
from workbench.impact.panel_average import panel_coefficient
from workbench.impact.section import Parabola, Section, Wedge
from workbench.verification import nonlinear_balance
from workbench.verification.case import Case

EXACT = "workbench.impact.similarity (Z. N. Dobrovol'skaya, J. Fluid Mech. 36, 805-829, 1969)"
GRANDE = "K. Grande, MSc thesis, Curtin University of Technology, 2002"
GENERALISED = "R. Zhao, O. M. Faltinsen and J. V. Aarsnes, 21st Symp. Naval Hydrodynamics, 1996"

ANGLES = {10: False, 12: True, 20: False, 30: False, 37: True, 45: False, 52: True, 60: False, 75: True}
"""Deadrise [degrees], and whether the case is slow."""

POD, POD_PANEL, POD_VELOCITY = Wedge(np.pi / 4), (0.0, 0.2), 4.0
POD_REASON = (
    "the average over the panel is 2.34 once it is wet and grows slowly to the 2.70 of the apex; the published number "
    "is that of the apex, which both methods have"
)


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_wedge_cases(), *_published_cases(), *_balance_cases(), *_other_cases()]


def _value(section: Section, name: str, method: str = "nonlinear", velocity=1.0, time: float = 1.0) -> float:
    return float(entry(section, velocity, method, 1.0, [time])[name][0])


def _ratio(section: Section, name: str, other: str, velocity=1.0, time: float = 1.0) -> float:
    return _value(section, name, "nonlinear", velocity, time) / _value(section, name, other, velocity, time)


def _wedge_cases() -> list[Case]:
    return [
        Case(
            id=f"nonlinear-wedge-{degrees}-{quantity}",
            title=f"Wedge of {degrees} degrees, boundary elements: {quantity} over that of the exact wedge",
            kind="second method",
            source=EXACT,
            published=1.0,
            computed=lambda d=degrees, n=name: _ratio(Wedge(np.radians(d)), n, "similarity"),
            tolerance=0.01,
            note="stepped from the exact solution until the spray root has moved by 17 jet thicknesses",
            slow=slow,
        )
        for degrees, slow in ANGLES.items()
        for quantity, name in (("peak", "peak_pressure"), ("force", "section_force"))
    ]


def pod_averages(method: str, times) -> np.ndarray:
    """Average pressure over the pod's panel over rho V**2/2 at times [s]."""
    found = entry(POD, POD_VELOCITY, method, 1.0, times, [POD_PANEL])
    return found["panel_pressure"].to_numpy()[:, 0] / (POD_VELOCITY**2 / 2)


def _steady_from() -> float:
    """Time where the first, straight rise of the average would reach its level on the wet panel [s]."""
    early, level = pod_averages("nonlinear", (0.02, 0.04))
    return 0.02 * level / early


def _published_cases() -> list[Case]:
    made = [
        Case(
            id="nonlinear-pod-k",
            title="Wedge of 45 degrees, boundary elements: peak pressure over rho V2/2",
            kind="published",
            source=f"{GRANDE}, table 7.2",
            published=2.71,
            computed=lambda: _value(POD, "peak_coefficient"),
            tolerance=0.02 * 2.71,
        ),
        Case(
            id="nonlinear-pod-steady",
            title="Pod, panel 0.4 m wide at 4 m/s, boundary elements: the average pressure is steady from",
            kind="published",
            source=f"{GRANDE}, 7.1.2, figures 7.11-7.16",
            published=0.035,
            computed=_steady_from,
            tolerance=0.005,
            unit="s",
            note="read off a curve",
        ),
    ]
    figures = {"nonlinear": 2.3757, "similarity": 2.3815}
    made += [
        Case(
            id=f"nonlinear-pod-average-{method}",
            title=f"Pod, panel 0.4 m wide, {method}: largest average pressure over rho V2/2",
            kind="published",
            source=f"{GRANDE}, table 7.2",
            published=2.71,
            computed=lambda m=method: panel_coefficient(POD, POD_PANEL, m),
            tolerance=0.02 * 2.71,
            note="until the wetted half-breadth is twice the panel by Wagner's theory",
            miss=POD_REASON,
            miss_figure=figure,
            miss_band=0.005,
        )
        for method, figure in figures.items()
    ]
    return made


def _far_field_error() -> float:
    """Largest difference of the closed integral of log r/eta**2 beyond the edge from quadrature."""
    worst = 0.0
    for point in (0.3 - 0.5j, 2.0 - 0.1j, 0.1 - 3.0j, 2.9 + 0.2j):
        known = sum(
            quad(
                lambda x, p=point, s=side: np.log(np.hypot(x - s * p.real, p.imag)) / x**2,
                3.0,
                np.inf,
                epsabs=1e-12,
            )[0]
            for side in (1, -1)
        )
        worst = max(worst, abs(float(far_source(np.array([point]), 3.0)[0]) - known))
    return worst


def _started(degrees: float, other: float | None = None) -> March:
    wedge = Wedge(np.radians(degrees))
    start = nonlinear_start.started(wedge, 1.0, 1.0, None if other is None else np.radians(other))
    return March(wedge, lambda time: (time, 1.0, 0.0), 1.0, start)


def other_start_force(degrees: float, other: float, growth: float) -> float:
    """Force of a wedge begun with the flow of another, over that of the exact one, after it went deeper by a factor."""
    march = _started(degrees, other)
    march.to(growth)
    exact = _value(march.section, "section_force", "similarity", 1.0, growth)
    return march.instant().force / exact


def _balance_cases() -> list[Case]:
    rows: tuple[tuple[str, str, str, float, Callable[[], float], float, bool], ...] = (
        ("far-field", "Source beyond the edge of the free surface: closed form less quadrature", f"{GRANDE}, eq. 6.7",
         0.0, _far_field_error, 1e-9, False),
        ("volume", "Wedge of 30 degrees, 1.5 times deeper: water raised over volume displaced, less 1",
         "conservation of volume", 0.0, lambda: nonlinear_balance.volume_error(_started(30), 1.5), 0.005, False),
        ("momentum", "Wedge of 45 degrees: force by rate of momentum over force by pressure",
         "conservation of momentum", 1.0, lambda: nonlinear_balance.momentum_ratio(_started(45), 15), 0.002, False),
        ("start", "Wedge of 30 degrees begun with the flow of 25, 3 times deeper: force over that of the exact wedge",
         EXACT, 1.0, lambda: other_start_force(30, 25, 3.0), 0.015, True),
        ("march", "Wedge of 10 degrees stepped to 3 times its depth: force over that of the exact wedge",
         EXACT, 1.0, lambda: other_start_force(10, 10, 3.0), 0.015, True),
    )  # fmt: skip
    return [
        Case(
            id=f"nonlinear-{name}",
            title=title,
            kind="second method" if source == EXACT else "closed form",
            source=source,
            published=known,
            computed=computed,
            tolerance=tolerance,
            slow=slow,
        )
        for name, title, source, known, computed, tolerance, slow in rows
    ]


SLOWING = VelocityHistory((0.0, 0.1, 0.2, 0.3, 0.4), (2.0, 1.8, 1.6, 1.4, 1.2))


def _other_cases() -> list[Case]:
    rows = (
        ("parabola-force", "Parabola at a depth of R/36: force over that of the generalised Wagner model",
         lambda: _ratio(Parabola(1.0), "section_force", "generalised-wagner", 1.0, 1 / 36), 0.03),
        ("parabola-breadth", "Parabola at a depth of R/36: spray root over wetted half-breadth of Wagner's theory",
         lambda: _ratio(Parabola(1.0), "wetted_half_breadth", "wagner", 1.0, 1 / 36), 0.02),
        ("slowing-force", "Wedge of 20 degrees that slows down: force over that of the generalised Wagner model",
         lambda: _ratio(Wedge(np.radians(20)), "section_force", "generalised-wagner", SLOWING, 0.2), 0.03),
    )  # fmt: skip
    return [
        Case(
            id=f"nonlinear-{name}",
            title=title,
            kind="second method",
            source="H. Wagner, ZAMM 12, 193-215, 1932" if "breadth" in name else GENERALISED,
            published=1.0,
            computed=computed,
            tolerance=tolerance,
            slow=True,
        )
        for name, title, computed, tolerance in rows
    ]
