"""Pressure over the wet deck: forces and impulses of water whose meeting with the deck is known in closed form."""

import numpy as np

from workbench.design import WetDeck
from workbench.verification.case import Case
from workbench.verification.known_water import CLEARANCE, DENSITY, crest, impact, impulse, slope

WAGNER = "H. Wagner, ZAMM 12, 193-215, 1932"
BAGGUS = "K. R. Baggus, MSc thesis, Delft University of Technology, 2025, 3.4"
KARMAN = "T. von Karman, NACA TN 321, 1929"
LENGTH, WIDTH = 60.0, 4.0
CURVATURE, VELOCITY, CELERITY, START, UNTIL = 0.02, 3.0, 5.0, 0.0513, 0.3513
PARABOLA_FORCE = 2 * np.pi * VELOCITY**2 / CURVATURE
POD_ANGLE, POD_VELOCITY, POD_UNTIL = np.radians(20.0), 2.0, 0.2


def _flat() -> WetDeck:
    return WetDeck(aft=-LENGTH / 2, fore=LENGTH / 2, width=WIDTH, clearance=CLEARANCE)


def _crest(speed: float = 0.0, celerity: float = CELERITY, **others):
    return impact(
        crest(CURVATURE, VELOCITY, celerity, speed, START), _flat(), speed=speed, until=UNTIL, **others
    )


def _impulse_of_crest(**others) -> float:
    """Over that of the spreading plate, pi/2 rho V l**2 with l**2 = 4 V t/kappa."""
    grown = 4 * VELOCITY * (UNTIL - START) / CURVATURE
    return impulse(_crest(**others)) / (np.pi / 2 * DENSITY * VELOCITY * grown * WIDTH)


def _force_of_crest(speed: float) -> float:
    found = _crest(speed)
    return float(found.deck_force[-1]) / (DENSITY * PARABOLA_FORCE * WIDTH)


def _level_water() -> float:
    found = impact(slope(0.0, VELOCITY, 0.103), _flat(), until=0.2)
    return impulse(found) / (np.pi / 2 * DENSITY * (LENGTH / 2) ** 2 * VELOCITY * WIDTH)


def _pod():
    depth = 5 * np.tan(POD_ANGLE)
    pod = WetDeck(aft=-2.0, fore=2.0, width=10.0, clearance=CLEARANCE, vee_depth=depth, vee_width=10.0)
    water = slope(0.0, POD_VELOCITY, depth / POD_VELOCITY)  # at the keel of the pod at t = 0
    return impact(water, pod, points=(4, 40), until=POD_UNTIL)


def _pod_coefficient(quantity: str) -> float:
    """Force over rho V**3 t or impulse over rho V**3 t**2/2, a metre, at the end."""
    found = _pod()
    scale = DENSITY * POD_VELOCITY**3 * 4.0
    if quantity == "impulse":
        return impulse(found) / (scale * POD_UNTIL**2 / 2)
    return float(found.deck_force[-1]) / (scale * (POD_UNTIL - found.attrs["time_step"] / 2))


def _over_the_end() -> float:
    """Impulse of water that comes over the fore end, over pi/8 rho V L**2 with L = 4 V t/(3 g)."""
    gradient, until = 0.1, 0.7
    found = impact(slope(gradient, VELOCITY, 0.0, LENGTH / 2), _flat(), until=until)
    length = 4 * VELOCITY * until / (3 * gradient)
    return impulse(found) / (np.pi / 8 * DENSITY * VELOCITY * length**2 * WIDTH)


def _receding() -> float:
    """Least pressure under water that falls away from the deck at a steady velocity [kPa]."""
    found = impact(crest(CURVATURE, -VELOCITY, 0.0, 0.0, 0.3), _flat(), until=0.4)
    return float(found.deck_pressure.min()) / 1e3


def cases() -> list[Case]:
    """Return the cases of this module."""
    wagner_wedge = np.pi**3 / (4 * np.tan(POD_ANGLE) ** 2)
    rows = (
        ("deck-crest-force", "Crest that travels along a flat deck: force over 2 pi rho V2 R", WAGNER, 1.0,
         lambda: _force_of_crest(0.0), 0.01),
        ("deck-crest-force-at-speed", "The same past a ship at 8 m/s, by the velocity of the water particle", WAGNER,
         1.0, lambda: _force_of_crest(8.0), 0.01),
        ("deck-parabola-impulse", "Parabola on a flat deck: impulse over that of the spreading plate", BAGGUS, 1.0,
         lambda: _impulse_of_crest(celerity=0.0), 0.01),
        ("deck-crest-impulse", "Travelling crest: impulse over that of the spreading plate", BAGGUS, 1.0,
         lambda: _impulse_of_crest(), 0.01),
        ("deck-crest-impulse-coarse-step", "The same in steps of 25 ms", BAGGUS, 1.0,
         lambda: _impulse_of_crest(step=0.025), 0.01),
        ("deck-crest-impulse-coarse-panels", "The same on panels of 6 m", BAGGUS, 1.0,
         lambda: _impulse_of_crest(points=(10, 2)), 0.01),
        ("deck-plate-impulse", "Level water that meets a flat deck: impulse over that of its added mass", KARMAN, 1.0,
         _level_water, 0.01),
        ("deck-pod-force", "Pod of 20 degrees cut across: force over rho V3 t", WAGNER, wagner_wedge,
         lambda: _pod_coefficient("force"), 0.01 * wagner_wedge),
        ("deck-pod-impulse", "Pod of 20 degrees cut across: impulse over rho V3 t2/2", WAGNER, wagner_wedge,
         lambda: _pod_coefficient("impulse"), 0.01 * wagner_wedge),
        ("deck-edge-impulse", "Water over the fore end: impulse over pi/8 rho V L2, L = 4 V t/(3 slope)", WAGNER, 1.0,
         _over_the_end, 0.01),
        ("deck-exit-suction", "Water that leaves at a steady velocity: least pressure, less buoyancy",
         "A. A. Korobkin, J. Fluid Mech. 737, 368-386, 2013", 0.0, _receding, 1e-6),
    )  # fmt: skip
    return [
        Case(
            id=name,
            title=title,
            kind="closed form",
            source=source,
            published=float(known),
            computed=computed,
            tolerance=tolerance,
            unit="kPa" if name == "deck-exit-suction" else "-",
        )
        for name, title, source, known, computed, tolerance in rows
    ]
