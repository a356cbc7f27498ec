"""Impact pressure: Wagner's wedge and three panels of Grande 2002, Chuang's k and his two tables of slams."""

from functools import cache

import numpy as np

from workbench.conventions import GRAVITY, SEAWATER_DENSITY
from workbench.impact import chuang, wagner
from workbench.impact.pressure import PressureLaw, peak_pressure
from workbench.verification import published
from workbench.verification.case import Case

MODEL_DENSITY, SHIP_DENSITY = 1.94, 1.99
"""Fresh and sea water in the units of Chuang 1975 [slug/ft3]."""

SQUARE_INCHES = 144.0
CLOSING = {
    "impact_angle_deg": 0.025,
    "k": 0.0012,
    "k_recorded": 0.0012,
    "calculated_psi": 0.016,
    "wave_velocity_fps": 0.025,
}
"""Rounding of the printed table of model slams, by column."""


def model_slam(row: dict[str, str]) -> dict[str, float]:
    """Angle [deg], k, k from record, pressure [psi] and wave velocity [ft/s] of a row of table 2."""
    slam = chuang.method_one(
        float(row["heave_velocity_fps"]),
        float(row["wave_velocity_fps"]),
        float(row["pitch_velocity_fps"]),
        np.radians(float(row["pitch_deg"])),
        np.radians(float(row["wave_slope_deg"])),
        MODEL_DENSITY,
    )
    recorded = SQUARE_INCHES * float(row["recorded_psi"])
    return {
        "impact_angle_deg": float(np.degrees(slam.impact_angle)),
        "k": float(slam.coefficient),
        "k_recorded": float(chuang.back_calculated_coefficient(recorded, slam, MODEL_DENSITY)),
        "calculated_psi": float(slam.total_pressure / SQUARE_INCHES),
        "wave_velocity_fps": wave_velocity(row),
    }


def printed_slam_agrees(row: dict[str, str], prefix: str = "") -> bool:
    """Whether the numbers of a row of table 2 follow from one another by Method I, within their rounding.

    ``prefix`` "printed_" takes the numbers as read from the damaged scan.
    """
    if prefix:
        row = {
            **row,
            **{key.removeprefix(prefix): text for key, text in row.items() if key.startswith(prefix)},
        }
    try:
        found = model_slam(row)
        return all(abs(found[name] - float(row[name])) <= band for name, band in CLOSING.items())
    except ValueError:
        return False


def wave_velocity(row: dict[str, str]) -> float:
    """Vertical velocity of the surface at the moving ship, -(V_h + g T/2 pi) tan(slope) [ft/s]."""
    foot = 0.3048
    speed = float(row["speed_kn"]) * 1852 / 3600 / foot
    celerity = GRAVITY / foot * float(row["wave_period_s"]) / (2 * np.pi)
    return -(speed + celerity) * np.tan(np.radians(float(row["wave_slope_deg"])))


@cache
def _closing_rows() -> tuple[dict[str, str], ...]:
    return tuple(row for row in published.rows("chuang_1975_table_2") if row["closes"] == "yes")


def _rows_that_agree(prefix: str = "") -> float:
    chosen = published.rows("chuang_1975_table_2") if prefix else _closing_rows()
    return sum(printed_slam_agrees(row, prefix) for row in chosen)


def _largest_pressure_difference() -> float:
    return max(
        abs(model_slam(row)["calculated_psi"] - float(row["calculated_psi"])) for row in _closing_rows()
    )


def _rows_with_wave_velocity() -> float:
    rows = published.rows("chuang_1975_table_2")
    return sum(abs(wave_velocity(row) - float(row["wave_velocity_fps"])) <= 0.025 for row in rows)


def ship_slam(row: dict[str, str]) -> chuang.Prediction:
    """Method I for one row of Chuang's table A.1, in feet and slugs."""
    return chuang.method_one(
        float(row["heave_velocity_fps"] or 0.0),
        float(row["wave_velocity_fps"]),
        float(row["pitch_velocity_fps"]),
        np.radians(float(row["pitch_deg"])),
        np.radians(float(row["wave_slope_deg"])),
        SHIP_DENSITY,
        roll=np.radians(float(row["roll_deg"])),
    )


def _ship_rows_that_agree() -> float:
    count = 0
    for row in published.rows("chuang_1975_table_a1"):
        slam = ship_slam(row)
        computed = (np.degrees(slam.impact_angle), slam.normal_velocity, slam.total_pressure / SQUARE_INCHES)
        printed = (float(row[key]) for key in ("impact_angle_deg", "normal_velocity_fps", "calculated_psi"))
        count += all(
            abs(a - b) <= band for a, b, band in zip(computed, printed, (0.01, 0.025, 0.7), strict=True)
        )
    return count


def _largest_k_difference(law: str) -> float:
    table = published.columns("chuang_1975_pressure_constant")
    found = chuang.impact_coefficient(np.radians(table["impact_angle_deg"]), law)
    return float(np.abs(found - table[f"k_{law}"]).max())


def _largest_k_step() -> float:
    joins = np.radians([2.2, 11.0, 20.0])
    below, above = (chuang.impact_coefficient(joins * (1 + shift)) for shift in (-1e-9, 1e-9))
    return float(np.abs(above - below).max())


def _panel_pressure(coefficient: float) -> float:
    law = PressureLaw(name="panel", coefficient=coefficient)
    return float(peak_pressure(law, 4.0, 0.0, SEAWATER_DENSITY)) / 1000


def _wedge_coefficient(degrees: float) -> float:
    return float(wagner.impact_coefficient(np.radians(degrees)))


GRANDE = (
    ("grande-panel-932-kpa", "wet deck panel pressure k 113.7 at 4 m/s", lambda: _panel_pressure(113.7)),
    (
        "grande-panel-library",
        "wet deck panel pressure k 113.7 at 4 m/s",
        lambda: _library_pressure("austal-63 wet deck"),
    ),
    ("grande-pod-22-kpa", "pod pressure k 2.71 at 4 m/s", lambda: _library_pressure("crowther-318 pod")),
    (
        "grande-beam-335-kpa",
        "main beam pressure k 40.8 at 4 m/s",
        lambda: _library_pressure("crowther-318 main beam"),
    ),
    ("wagner-45-degrees", "Wagner k at 45 degrees", lambda: _wedge_coefficient(45.0)),
    ("wagner-8-degrees", "Wagner k at 8.38 degrees", lambda: _wedge_coefficient(8.38)),
    ("wagner-14-degrees", "Wagner k at 13.82 degrees", lambda: _wedge_coefficient(13.82)),
    ("grande-hydrostatic", "hydrostatic pressure at 0.4 m", lambda: SEAWATER_DENSITY * GRAVITY * 0.4),
)


def _library_pressure(name: str) -> float:
    return _panel_pressure(wagner.PANEL_COEFFICIENTS[name])


def cases() -> list[Case]:
    """Return the cases of this module."""
    source = published.citation("grande_2002_numbers")
    made = []
    for name, label, computed in GRANDE:
        number, tolerance, unit = published.value("grande_2002_numbers", label)
        kind = "closed form" if name.startswith("wagner") else "published"
        made.append(
            Case(
                id=name,
                title=f"{label}, k of the library" if "library" in name else label,
                kind=kind,
                source=source,
                published=number,
                computed=computed,
                tolerance=tolerance,
                unit=unit,
            )
        )
    made += [*_coefficient_cases(), *_slam_cases()]
    return made


def _coefficient_cases() -> list[Case]:
    source = published.citation("chuang_1975_pressure_constant")
    laws = [
        Case(
            id=f"chuang-k-{law}",
            title=f"Chuang's k at 14 angles, small-angle law of the {words}: largest difference",
            kind="published",
            source=source,
            published=0.0,
            computed=lambda law=law: _largest_k_difference(law),
            tolerance=1e-6,
        )
        for law, words in (("program", "program"), ("text", "text"))
    ]
    return [
        *laws,
        Case(
            id="chuang-k-continuous",
            title="Chuang's k at 2.2, 11 and 20 degrees: largest step",
            kind="closed form",
            source=source,
            published=0.0,
            computed=_largest_k_step,
            tolerance=1.3e-4,
            note="the printed coefficients themselves leave a step of 1.2e-4 at 11 degrees",
        ),
    ]


def _slam_cases() -> list[Case]:
    source = published.citation("chuang_1975_table_2")
    made = [
        Case(
            id="chuang-table-2-rows",
            title="Rows of Chuang's table 2 whose numbers follow from one another by Method I, of 77",
            kind="published",
            source=source,
            published=77,
            computed=_rows_that_agree,
            tolerance=0,
            unit="rows",
            note="with the repaired digits; which rows were repaired stands in the table",
        ),
        Case(
            id="chuang-table-2-as-read",
            title="Rows of Chuang's table 2 that follow by Method I as read from the damaged scan, of 81",
            kind="published",
            source=source,
            published=47,
            computed=lambda: _rows_that_agree("printed_"),
            tolerance=0,
            unit="rows",
            note="the independent part of the comparison: nothing in these rows was repaired",
        ),
        Case(
            id="chuang-table-2-pressure",
            title="Calculated pressure of 77 rows of Chuang's table 2: largest difference",
            kind="published",
            source=source,
            published=0.0,
            computed=_largest_pressure_difference,
            tolerance=CLOSING["calculated_psi"],
            unit="psi",
        ),
        Case(
            id="chuang-wave-velocity",
            title="Rows of Chuang's table 2 whose wave velocity follows from period, speed and slope, of 81",
            kind="published",
            source=source,
            published=79,
            computed=_rows_with_wave_velocity,
            tolerance=0,
            unit="rows",
            note="runs 12 and 407 II print another wave velocity than their own wave has",
        ),
        Case(
            id="chuang-table-a1-rows",
            title="Rows of Chuang's table A.1 (USNS HAYES) that follow by Method I with roll, of 23",
            kind="published",
            source=published.citation("chuang_1975_table_a1"),
            published=23,
            computed=_ship_rows_that_agree,
            tolerance=0,
            unit="rows",
        ),
    ]
    return made + [
        _open_row_case(row) for row in published.rows("chuang_1975_table_2") if row["closes"] == "no"
    ]


def _open_row_case(row: dict[str, str]) -> Case:
    """Return the case of a row whose printed numbers contradict one another."""
    run = f"{row['run']} {row['case']}".strip()
    column = "wave_velocity_fps" if row["contradiction"] == "wave velocity" else "k_recorded"
    figures = {"12": 0.2238, "407 II": -0.7824, "206": 0.1001, "326": 0.1817}
    return Case(
        id=f"chuang-run-{run.lower().replace(' ', '-')}",
        title=f"Run {run} of Chuang's table 2, which contradicts itself: {row['contradiction']}",
        kind="published",
        source=published.citation("chuang_1975_table_2"),
        published=float(row[column]),
        computed=lambda: model_slam(row)[column],
        tolerance=CLOSING[column],
        unit={"wave_velocity_fps": "ft/s", "k_recorded": "-"}[column],
        miss="the numbers printed in this row contradict one another, and nothing says which is right",
        miss_figure=figures[run],
        miss_band=0.002,
    )
