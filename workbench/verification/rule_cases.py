"""Rule pressures: the printed example, and two transcriptions against each other."""

from workbench.conventions import GRAVITY, KNOT
from workbench.impact.rule_formulas import (
    RuleInput,
    abs_area_factor,
    gl_impact_velocity,
    gl_pressure,
    rule_rows,
)
from workbench.verification.case import Case

EXAMPLE = RuleInput(
    length=50.0, speed=35 * KNOT, displacement=200e3, draught=1.8, significant_wave_height=4.0, air_gap=2.0,
    panel_area=0.6, spacing=0.5, vertical_acceleration=GRAVITY,
)  # fmt: skip
STATION = 0.9
GL = "Germanischer Lloyd, I-3-1 High Speed Craft, 2012, C3.5.4, by the program of R. Sevalho"
HIGHER = RuleInput(
    length=50.0, speed=35 * KNOT, displacement=200e3, draught=1.8, significant_wave_height=4.5, air_gap=2.0,
    panel_area=0.6, spacing=0.5,
)  # fmt: skip


def _abs_over_gl() -> float:
    found = {row.key: row.pressure for row in rule_rows(HIGHER, STATION)}["abs-hsc"]
    return found / gl_pressure(HIGHER, STATION, abs_area_factor(HIGHER), 1.0)


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [
        Case(
            id="rule-gl-impact-velocity", title="relative velocity of GL for 50 m and 4 m", kind="published",
            source=GL, published=3.26274, tolerance=5e-6, unit="m/s",
            computed=lambda: float(gl_impact_velocity(4.0, 50.0)),
            note="the rule's own number, metres and m/s as it prints them",
        ),
        Case(
            id="rule-gl-example", title="wet-deck pressure of GL, 50 m, 35 kn, Hs 4 m, gap 2 m, x/L 0.9, K2 = K3 = 1",
            kind="published", source=GL, published=196.988, tolerance=5e-4, unit="kPa",
            computed=lambda: gl_pressure(EXAMPLE, STATION, 1.0, 1.0) / 1e3,
        ),
        Case(
            id="rule-abs-is-gl", title="wet-deck pressure of ABS below 61 m over that of GL with K2 K3 = F_D",
            kind="second code", source=f"Cotecmar, ABSHSC_ISO_scantlings, against {GL}", published=1.0,
            tolerance=1e-12, unit="-", computed=_abs_over_gl,
            note="two independent transcriptions of two rules that are the same formula; Hs above L/12",
        ),
    ]  # fmt: skip
