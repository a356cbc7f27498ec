"""The tables of Chuang 1975 as data in SI units, and what can be counted in them."""

from functools import cache

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import KNOT
from workbench.impact.design_load import PSI
from workbench.impact.program_cat import Line, cat
from workbench.impact.slam_table import Agreement, agreement, predicted_slams
from workbench.records.gauge_averages import AREAS, BOUNDS, PAIR, SILENT
from workbench.verification import published
from workbench.verification.case import Case

MODEL_SLAMS, SHIP_SLAMS = "chuang_1975_table_2", "chuang_1975_table_a1"
GAUGE_EVENTS, SAMPLE_RATIOS, CONFLICTS = (
    "chuang_1975_table_3",
    "chuang_1975_table_3g",
    "chuang_1975_conflicts",
)

FOOT, POUND = 0.3048, 0.45359237
SLUG_PER_CUBIC_FOOT = POUND * 9.80665 / FOOT / FOOT**3
MODEL_DENSITY, SHIP_DENSITY = 1.94 * SLUG_PER_CUBIC_FOOT, 1.99 * SLUG_PER_CUBIC_FOOT
"""Fresh and sea water of the report [kg/m3]."""

READING = 0.05
"""Resolution of the readings of table 3 [psi]."""

GAUGES = ("P1", "P2", "P3", "P6", "P7", "P8")


def chosen_rows(name: str, **chosen: str) -> list[dict[str, str]]:
    """Rows of a table in which the columns have the given text, or one of several."""
    wanted = {key: (value,) if isinstance(value, str) else tuple(value) for key, value in chosen.items()}
    return [row for row in published.rows(name) if all(row[key] in texts for key, texts in wanted.items())]


def _slams(rows: list[dict[str, str]], **more) -> xr.Dataset:
    """Inputs of Method I of rows of table 2 or A.1 (event), in SI."""

    def column(key: str, factor: float) -> tuple[str, np.ndarray]:
        return "event", factor * np.array([float(row[key] or 0.0) for row in rows])

    return quantities.dataset(
        {"event": np.arange(len(rows))},
        method="published table",
        heave_velocity=column("heave_velocity_fps", FOOT),
        surface_velocity=column("wave_velocity_fps", FOOT),
        pitch_velocity=column("pitch_velocity_fps", FOOT),
        attitude=column("pitch_deg", np.pi / 180),
        wave_slope=column("wave_slope_deg", np.pi / 180),
        recorded_pressure=column("recorded_psi", PSI),
        **{name: column(*value) for name, value in more.items()},
    )


def model_slams(**chosen: str) -> xr.Dataset:
    """Slams of table 2 with Method I (event), such as ``model="rigid"``, ``position="low"``, ``table="a"``."""
    return predicted_slams(_slams(chosen_rows(MODEL_SLAMS, **chosen)), MODEL_DENSITY)


def ship_slams(**chosen: str) -> xr.Dataset:
    """Slams of USNS HAYES, table A.1, with Method I, roll and sea water (event), such as ``case="I"``."""
    rows = chosen_rows(SHIP_SLAMS, **chosen)
    return predicted_slams(_slams(rows, roll_angle=("roll_deg", np.pi / 180)), SHIP_DENSITY)


def ship_means() -> dict[str, tuple[float, float]]:
    """By event of table A.1: impact angle [rad] and mean back-calculated k of its cases [-]."""
    rows, slams = published.rows(SHIP_SLAMS), ship_slams()
    found: dict[str, tuple[float, float]] = {}
    for event in dict.fromkeys(row["event"] for row in rows):
        own = [number for number, row in enumerate(rows) if row["event"] == event]
        angle, constant = slams.impact_angle.values[own], slams.recorded_constant.values[own]
        found[event] = float(angle.mean()), float(constant.mean())
    return found


def ship_mean_slams() -> xr.Dataset:
    """Mean k of the twelve slams of USNS HAYES over their impact angles (event), figure A.1 of the report."""
    angle, constant = np.array(list(ship_means().values())).T
    return quantities.dataset(
        {"event": np.arange(len(angle))},
        method="mean of the cases",
        impact_angle=("event", angle),
        recorded_constant=("event", constant),
    )


def slam_agreement(slams: xr.Dataset) -> Agreement:
    """Recorded against calculated pressures of slams from `model_slams` or `ship_slams` [Pa]."""
    return agreement(slams.recorded_pressure.values, slams.peak_pressure.values)


def printout(row: dict[str, str]) -> Line:
    """Line of program CAT for a row of table 2."""
    names = ("heave_velocity_fps", "wave_velocity_fps", "pitch_velocity_fps", "pitch_deg", "wave_slope_deg")
    return cat(*(float(row[name]) for name in names), float(row["recorded_psi"]))


def wave_of(row: dict[str, str]) -> tuple[float, float]:
    """Period [s] and ship speed [m/s] of a row of table 2."""
    return float(row["wave_period_s"]), KNOT * float(row["speed_kn"])


def gauge_events(**chosen: str) -> dict[str, np.ndarray]:
    """Largest pressures of the gauges and averages of table 3 by name (event) [psi], NaN where there is none."""
    return _gauge_columns(tuple((key, value) for key, value in sorted(chosen.items())))


@cache
def _gauge_columns(chosen: tuple[tuple[str, str], ...]) -> dict[str, np.ndarray]:
    rows = chosen_rows(GAUGE_EVENTS, **dict(chosen))
    names = {gauge: f"{gauge.lower()}_psi" for gauge in GAUGES}
    names |= {f"average {area}": f"average_{area.lower()}_psi" for area in AREAS}
    return {
        label: np.array([float(row[key]) if row[key] else np.nan for row in rows])
        for label, key in names.items()
    }


def highest_gauge_counts(table: str) -> dict[str, int]:
    """How often each gauge reads the highest pressure of an event of table 3 a to f; ties count for both."""
    events = gauge_events(table=table)
    readings = np.stack([events[gauge] for gauge in GAUGES])
    highest = readings == np.nanmax(readings, axis=0)
    return {gauge: int(row.sum()) for gauge, row in zip(GAUGES, highest, strict=True) if row.any()}


def bound_of_average(events: dict[str, np.ndarray], area: str) -> np.ndarray:
    """Average of the gauges' own maxima (event) [psi]: no simultaneous average can exceed it without suction."""
    shares = {gauge: share for gauge, share in AREAS[area].items() if gauge not in SILENT}
    return np.sum([share * np.nan_to_num(events[gauge]) for gauge, share in shares.items()], axis=0)


def events_above_bound() -> list[tuple[str, str, str]]:
    """Table, run and event of table 3 in which a printed average exceeds that of the gauges' maxima."""
    events, rows = gauge_events(), published.rows(GAUGE_EVENTS)
    above = np.zeros(len(rows), bool)
    for area in AREAS:
        printed = events[f"average {area}"]
        has_gauges = ~(np.isnan(events["P8"]) & (area in ("I", "III", "IV")))
        with np.errstate(invalid="ignore"):
            above |= has_gauges & (printed > bound_of_average(events, area) + READING)
    return [(row["table"], row["run"], row["event"]) for row, one in zip(rows, above, strict=True) if one]


def peak_ratios(area: str, own_gauges: bool = True, **chosen: str) -> np.ndarray:
    """Largest gauge over the printed average of an area, by event with such an average [-].

    ``own_gauges`` : the largest among the gauges of the area, else among all.
    """
    events = gauge_events(**chosen)
    gauges = [gauge for gauge in GAUGES if gauge in AREAS[area] or not own_gauges]
    average = events[f"average {area}"]
    has = np.isfinite(average)
    largest = np.nanmax(np.stack([events[gauge][has] for gauge in gauges]), axis=0)
    return largest / average[has]


def events_over_ratio_bound(area: str) -> int:
    """Slams of table 3 whose peak over average I or II exceeds 6 or 4 by more than the rounding of the readings.

    Without suction that cannot be: the average at the instant of the peak is at least the
    peak by the bound. The report remarks on suction, but prints few negative readings.
    """
    events = gauge_events()
    average = events[f"average {area}"]
    has = np.isfinite(average)
    alone = [gauge for gauge in GAUGES if gauge in AREAS[area] and gauge not in PAIR]
    largest = np.nanmax(np.stack([events[gauge][has] for gauge in alone]), axis=0)
    return int(np.sum((largest - READING / 2) / (average[has] + READING / 2) > BOUNDS[area]))


def contradictions(**chosen: str) -> list[dict[str, str]]:
    """Rows of the tables that contradict themselves or were repaired by a guess, as data."""
    return chosen_rows(CONFLICTS, **chosen)


def chuang_case(
    name: str, title: str, known: float, computed, tolerance: float, unit: str = "-", **more
) -> Case:
    """Return a case whose id begins with chuang-, of the report's table 2 unless said otherwise."""
    return Case(
        **{
            "id": f"chuang-{name}",
            "title": title,
            "kind": "published",
            "source": published.citation(MODEL_SLAMS),
            "published": known,
            "computed": computed,
            "tolerance": tolerance,
            "unit": unit,
            **more,
        }
    )
