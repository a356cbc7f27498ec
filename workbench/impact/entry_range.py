"""What each theory of water entry holds for: refusals, and sentences outside its range."""

import numpy as np

from workbench.errors import InputError, checked_number
from workbench.impact.section import Section, TableSection, Wedge

AIR_CUSHION = 3.0
"""Deadrise below which air is trapped [degrees]."""

STEEPEST_LOGVINOVICH = 70.0
"""Deadrise beyond which the modified Logvinovich model has no positive pressure worth the name [degrees]."""

FLATTEST_NONLINEAR, STEEPEST_NONLINEAR = 4.0, 80.0
"""Range of deadrise at the keel of the non-linear method [degrees]; within 0.6 % of the exact wedge inside."""

STEEPEST_ROUND = 45.0
"""Angle up to which the non-linear method was compared on sections other than wedges [degrees]."""

SHARPEST_TURN = 10.0
"""Turn at a corner of a table up to which the non-linear method was compared [degrees]."""

BEYOND = {
    "von-karman": ((45.0, "Von Karman's theory holds for small deadrise"),),
    "wagner": (
        (
            20.0,
            "Wagner's theory holds for small deadrise: its force is 17 % above that of the exact wedge at 10 degrees, "
            "38 % at 20 and 66 % at 30",
        ),
    ),
    "generalised-wagner": (
        (
            45.0,
            "The generalised Wagner model has 11 % more force than the exact wedge at 45 degrees, 21 % at 60",
        ),
    ),
    "logvinovich": (
        (
            20.0,
            "The modified Logvinovich model has 18 % more peak pressure than the exact wedge at 20 degrees, 40 % at 30",
        ),
        (
            45.0,
            "The modified Logvinovich model holds below 45 degrees, where it has 22 % more force than the exact wedge",
        ),
    ),
}
"""Limit of deadrise [degrees] and sentence by theory; the figures are those of the verification cases."""


def check_range(section: Section, method: str, constant: bool) -> None:
    """Refuse what a theory cannot do at all."""
    if method in ("similarity", "chuang") and not isinstance(section, Wedge):
        raise InputError(
            f"The method {method} is for wedges only, got a {section.kind}; take generalised-wagner or logvinovich."
        )
    if method == "similarity" and not constant:
        raise InputError("The similarity solution needs a constant velocity; take generalised-wagner.")
    if method == "logvinovich" and isinstance(section, Wedge):
        checked_number(
            "deadrise for the modified Logvinovich model",
            np.degrees(section.deadrise_angle),
            "degrees",
            at_most=STEEPEST_LOGVINOVICH,
            cure="take the similarity solution",
        )

    if method == "nonlinear":
        keel = np.degrees(np.arctan(float(section.slope(0.0))))
        if keel > 0:
            checked_number(
                "deadrise at the keel for the non-linear method",
                keel,
                "degrees",
                at_least=FLATTEST_NONLINEAR - 1e-9,
                at_most=STEEPEST_NONLINEAR + 1e-9,
                cure="take generalised-wagner below and the similarity solution above",
            )


def validity(section: Section, method: str, half_breadth: np.ndarray, peak_position) -> tuple[str, ...]:
    """Sentences on what lies outside the range of the theory."""
    sentences = []
    finite = half_breadth[np.isfinite(half_breadth)]
    if isinstance(section, Wedge):
        angles = np.degrees([section.deadrise_angle])
    else:
        angles = np.degrees(np.arctan(section.slope(np.minimum(finite, section.reach))))
    if angles.min() < AIR_CUSHION and method != "chuang":
        sentences.append(
            f"The section meets the water at {angles.min():.3g} degrees, below {AIR_CUSHION:g}: air is trapped there, "
            "and the real pressure is lower than any theory without air."
        )
    for limit, words in BEYOND.get(method, ()):
        if angles.max() > limit + 1e-9:
            sentences.append(f"{words}; the section meets the water at {angles.max():.3g} degrees.")
    if method == "von-karman":
        sentences.append("Von Karman's theory has no pile-up of water and no finite peak pressure.")
    if method == "wagner":
        sentences.append(
            "The distribution is Wagner's outer pressure, infinite at its edge; the peak is that of his spray root."
        )
    if method == "generalised-wagner" and isinstance(section, TableSection) and len(section.points) > 2:
        sentences.append(
            "The corners of the table are rounded over a quarter of the shorter piece beside each."
        )
    if method == "nonlinear" and not isinstance(section, Wedge):
        if angles.max() > STEEPEST_ROUND:
            sentences.append(
                f"The non-linear method was compared up to {STEEPEST_ROUND:g} degrees on sections other than wedges; "
                f"this one meets the water at {angles.max():.3g} degrees."
            )
        turn = _sharpest_turn(section, finite.max(initial=0.0))
        if turn > SHARPEST_TURN:
            sentences.append(
                f"The section turns by {turn:.3g} degrees at a corner; the non-linear method was compared up to "
                f"{SHARPEST_TURN:g}, and its flow has suction there, which real water escapes by leaving the section."
            )
        sentences.append("The jet is kept on the section throughout; no water leaves it.")
    if method == "similarity" and np.all(peak_position == 0):
        sentences.append(
            "The largest pressure is at the apex; the wetted half-breadth is that of the jet tip."
        )
    if method == "chuang":
        sentences.append(
            "Chuang's k is a fit to drop tests of three-dimensional bodies and gives neither force nor distribution."
        )
    return tuple(sentences)


def _sharpest_turn(section: Section, breadth: float) -> float:
    """Largest turn of a table at a corner inside a half-breadth [degrees]."""
    if not isinstance(section, TableSection):
        return 0.0
    y, z = np.array(section.points).T
    turns = np.degrees(np.diff(np.arctan(np.diff(z) / np.diff(y))))
    return float(turns[y[1:-1] < breadth].max(initial=0.0))
