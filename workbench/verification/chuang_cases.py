"""Chuang 1975 beyond his k: Method II, program CAT, and the statistics of his slams of model and ship."""

from functools import cache

import numpy as np

from workbench.conventions import KNOT
from workbench.impact import chuang
from workbench.impact.chuang_orbital import closing_difference, method_two
from workbench.impact.design_load import PSI
from workbench.impact.regular_motion import RegularMotion
from workbench.impact.regular_wave import RegularWave
from workbench.impact.slam_table import Agreement, matched_comparison
from workbench.impact.stavovy_chuang import surface_impact
from workbench.verification import chuang_tables as tables
from workbench.verification import published
from workbench.verification.case import Case
from workbench.verification.chuang_tables import FOOT, MODEL_DENSITY, MODEL_SLAMS, chuang_case

SOURCE = published.citation

SETS = {
    "all": {},
    "undamped": {"damped": "0"},
    "rigid": {"model": "rigid"},
    "elastic": {"model": "elastic"},
    **{table: {"table": table} for table in "abcdef"},
}
"""Sets of slams of table 2 whose statistics are known."""


def example_wave() -> RegularWave:
    """Wave and speed of the worked example of Method II."""
    return RegularWave(amplitude=0.30 * FOOT, period=1.71, speed=1.98 * KNOT)


def example_slam() -> chuang.Prediction:
    """Worked example of Method II: bow 8 degrees down at the largest slope."""
    return method_two(example_wave(), 0.0, 1.8 * FOOT, 1.0 * FOOT, np.radians(-8.0), MODEL_DENSITY)


@cache
def set_agreement(name: str) -> Agreement:
    """Agreement of the slams of a set of table 2."""
    return tables.slam_agreement(tables.model_slams(**SETS[name]))


def largest_statistic_difference(*fields: str) -> float:
    """Largest difference of statistics of table 2 from the known ones, over all sets; rms in psi."""
    found = 0.0
    for row in published.rows("chuang_1975_agreement"):
        values = set_agreement(row["set"])._asdict()
        values["rms_error_psi"] = values["rms_error"] / PSI
        found = max(found, *(abs(values[field] - float(row[field])) for field in fields))
    return found


def small_angle_ratio() -> float:
    """Difference of Methods I and II over its first-order form, at angles of some thousandths [-]."""
    wave = RegularWave(amplitude=2e-4, period=2.0, speed=1.5)
    slope, pitch = wave.largest_slope, -2e-3
    water = -wave.closing_speed * np.tan(slope)
    first = chuang.method_one(0.1, water, 0.05, pitch, slope, 1000.0)
    second = method_two(wave, 0.0, 0.1, 0.05, pitch, 1000.0)
    difference = first.normal_velocity - second.normal_velocity
    return float(difference / closing_difference(wave.speed, slope, pitch))


def largest_program_difference() -> float:
    """Largest difference of the program's pressure from Method I over table 2 [psi]."""
    printed = np.array([tables.printout(row).pnc for row in published.rows(MODEL_SLAMS)])
    return float(np.abs(printed - tables.model_slams().peak_pressure.values / PSI).max())


def program_rows_that_agree() -> float:
    """Rows of table 2 whose angle, k, k from record and pressure the program prints within their rounding."""
    bands = {"x": ("impact_angle_deg", 0.025), "k": ("k", 0.0012), "c": ("k_recorded", 0.0012)}
    bands["pnc"] = ("calculated_psi", 0.016)
    return sum(
        all(
            abs(getattr(tables.printout(row), name) - float(row[key])) <= band
            for name, (key, band) in bands.items()
        )
        for row in published.rows(MODEL_SLAMS)
        if row["closes"] == "yes"
    )


def matched_ratio(band_degrees: float) -> float:
    """Median k of the elastic bottom over that of the rigid one at impact angles within a band [-]."""
    rigid, elastic = (tables.model_slams(model=model) for model in ("rigid", "elastic"))
    return matched_comparison(rigid, elastic, np.radians(band_degrees)).median_ratio


def largest_mean_difference() -> float:
    """Largest difference of the mean k of an event of table A.1 from the printed one."""
    found = tables.ship_means()
    return max(
        abs(found[row["event"]][1] - float(row["k_mean"])) for row in published.rows("chuang_1975_table_a1")
    )


def flat_bottom_difference() -> float:
    """Largest relative difference of the pressure of an inclined surface without deadrise from Method I."""
    pitch, slope = np.meshgrid(np.radians([-14.0, -6.0, 0.0, 5.0]), np.radians([-5.0, 0.0, 7.0]))
    pitch, slope = pitch.ravel(), slope.ravel()
    flat = chuang.method_one(2.0, -0.5, 0.7, pitch, slope, 1025.0).total_pressure
    found = surface_impact(2.5, 1025.0, pitch=pitch, wave_slope=slope, pitch_velocity=0.7)
    return float(np.abs(found.peak_pressure.values / flat - 1).max())


def closing_identity() -> float:
    """Vertical closing velocity at the impact instants over w sqrt(r^2 - c^2), less 1: largest over a deck."""
    motion = RegularMotion(
        wave=RegularWave(amplitude=1.2, period=7.0, speed=8.0),
        heave_amplitude=1.1, heave_lead=-1.6, pitch_amplitude=0.07, pitch_lead=-2.4,
    )  # fmt: skip
    lever, clearance = np.linspace(10.0, 25.0, 9), 0.5
    state = motion.at(motion.impact_instant(lever, clearance), lever)
    closing = state.heave_velocity - state.surface_velocity + state.pitch_velocity
    amplitude = np.abs(motion.relative_motion(lever))
    known = motion.wave.encounter_frequency * np.sqrt(amplitude**2 - clearance**2)
    return float(np.abs(closing / known - 1).max())


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [
        *_method_cases(),
        *_program_cases(),
        *_statistics_cases(),
        *_ship_cases(),
    ]


def _method_cases() -> list[Case]:
    by_hand = {
        "kind": "second code",
        "note": "equations 8 and 9 worked out by hand; the report has no table for Method II",
    }
    return [
        chuang_case(
            "method-2-velocity", "Normal velocity of Method II in a worked slam", 3.3739,
            lambda: example_slam().normal_velocity / FOOT, 1e-4, "ft/s", **by_hand,
        ),
        chuang_case(
            "method-2-tangential", "Tangential velocity of Method II in a worked slam", -0.7465,
            lambda: example_slam().tangential_velocity / FOOT, 1e-4, "ft/s", **by_hand,
        ),
        chuang_case(
            "method-2-pressure", "Impact pressure of Method II in a worked slam", 1.781,
            lambda: example_slam().impact_pressure / PSI, 1e-3, "psi", **by_hand,
        ),
        chuang_case(
            "methods-differ", "Method I less Method II over V_h (slope - pitch), small angles", 1.0,
            small_angle_ratio, 5e-3, kind="closed form",
        ),
        chuang_case(
            "planing-share", "Largest share of the planing pressure in table 2 (run 411 II)", 0.0107,
            lambda: float((tables.model_slams().planing_pressure / tables.model_slams().peak_pressure).max()), 5e-5,
            kind="second code", note="the report calls it negligible",
        ),
        chuang_case(
            "flat-bottom-limit", "Inclined surface without deadrise against Method I: largest relative difference", 0.0,
            flat_bottom_difference, 1e-9, kind="closed form",
            note="what is recalled of Stavovy and Chuang 1976, in the limit that can be checked",
        ),
        chuang_case(
            "closing-velocity", "Vertical closing velocity at impact from sinusoidal motions: relative difference", 0.0,
            closing_identity, 1e-9, kind="closed form",
        ),
    ]  # fmt: skip


def _program_cases() -> list[Case]:
    made = [
        chuang_case(
            "cat-rows", "Rows of table 2 that the port of program CAT prints, of 77", 77, program_rows_that_agree, 0,
            "rows",
        ),
        chuang_case(
            "cat-against-method-1", "Program CAT against Method I in SI over table 2: largest difference", 0.0,
            largest_program_difference, 1e-5, "psi", kind="second code",
        ),
    ]  # fmt: skip
    for run, case in (("9", "I"), ("39", "II"), ("218", ""), ("411", "II")):
        row = tables.chosen_rows(MODEL_SLAMS, run=run, case=case)[0]
        label = f"{run} {case}".strip()
        name = f"cat-run-{label.lower().replace(' ', '-')}"
        made.append(
            chuang_case(
                name, f"Pressure of run {label} as program CAT prints it", float(row["calculated_psi"]),
                lambda row=row: tables.printout(row).pnc, 0.006, "psi",
            )
        )  # fmt: skip
    return made


def _statistics_cases() -> list[Case]:
    second = {"kind": "second code", "source": SOURCE("chuang_1975_agreement")}
    return [
        chuang_case(
            "statistics-ratios", "Recorded over calculated in ten sets of table 2, mean and median: largest difference",
            0.0, lambda: largest_statistic_difference("mean_ratio", "median_ratio", "correlation"), 6e-4, **second,
        ),
        chuang_case(
            "statistics-range", "Least and largest ratio and rms error in ten sets of table 2: largest difference",
            0.0, lambda: largest_statistic_difference("least_ratio", "largest_ratio", "rms_error_psi"), 6e-3, **second,
        ),
        chuang_case(
            "statistics-counts", "Slams, slams within a quarter and below 1 in ten sets of table 2: largest difference",
            0.0, lambda: largest_statistic_difference("count", "within_quarter", "below"), 0, **second,
        ),
        chuang_case(
            "mean-agreement", "Mean of recorded over calculated pressure of 81 slams", 1.0,
            lambda: set_agreement("all").mean_ratio, 0.1, kind="trend",
            note='the report calls the agreement "very good"; a single slam may be off by a factor of 2.6',
        ),
        chuang_case(
            "elastic-lower", "Bands of matched impact angle in which the elastic bottom has the lower median k, of 3",
            3, lambda: sum(matched_ratio(band) < 1 for band in (0.25, 0.5, 1.0)), 0, kind="trend",
            note='"generally" lower in the report, with many exceptions and no number; it may be chance (p 0.4)',
        ),
    ]  # fmt: skip


def _ship_cases() -> list[Case]:
    source = {"source": SOURCE("chuang_1975_table_a1")}
    second = {**source, "kind": "second code"}

    def mean_of(case) -> float:
        return tables.slam_agreement(tables.ship_slams(case=case)).mean_ratio

    def pressure_of(event: str, case: str) -> float:
        return float(tables.ship_slams(event=event, case=case).peak_pressure.item() / PSI)

    return [
        chuang_case(
            "hayes-mean-k", "Mean k of twelve slams of USNS HAYES: largest difference", 0.0,
            largest_mean_difference, 0.002, **source,
            note="0.0017 at 16:59:54, where the printed k of case I is damaged",
        ),
        chuang_case(
            "hayes-case-1", "Recorded over calculated of USNS HAYES, case I, mean of 12", 1.15,
            lambda: mean_of(("I", "single")), 0.005, **second,
        ),
        chuang_case(
            "hayes-case-2", "Recorded over calculated of USNS HAYES, case II, mean of 11", 0.92,
            lambda: mean_of("II"), 0.005, **second,
        ),
        chuang_case(
            "hayes-165249", "USNS HAYES 16:52:49 case II, with a roll of 4 degrees", 57,
            lambda: pressure_of("16:52:49", "II"), 0.5, "psi", **source,
        ),
        chuang_case(
            "hayes-214756", "USNS HAYES 21:47:56 case I, with a roll of 3.2 degrees", 171,
            lambda: pressure_of("21:47:56", "I"), 0.5, "psi", **source,
        ),
    ]  # fmt: skip
