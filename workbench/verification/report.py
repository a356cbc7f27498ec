"""The cases together: run, in a table, with the verdict on the whole."""

import time
from collections.abc import Callable, Iterable
from typing import Any

from workbench.verification import (
    amin_cases,
    baggus_cases,
    body_cases,
    chuang_cases,
    chuang_load_cases,
    condition_cases,
    counting_cases,
    delft_cases,
    encounter_cases,
    entry_cases,
    feature_table,
    free_surface_cases,
    high_speed_cases,
    impact_cases,
    model_cases,
    nonlinear_cases,
    parametric_cases,
    pressure_statistics_cases,
    record_cases,
    rule_cases,
    sail_cases,
    sea_cases,
    section_cases,
    ship_cases,
    simulation_cases,
    spreading_plate,
    strip_cases,
    wet_deck_cases,
)
from workbench.verification.case import VERDICTS, Case, Outcome, outcome

GROUPS = {
    "impact pressure": impact_cases,
    "slams of cross structures": chuang_cases,
    "gauges and design load": chuang_load_cases,
    "water entry of sections": entry_cases,
    "pressure over the wet deck": wet_deck_cases,
    "water beside an entering section": free_surface_cases,
    "non-linear water entry": nonlinear_cases,
    "seas and statistics": sea_cases,
    "counting": counting_cases,
    "statistics of slam pressure": pressure_statistics_cases,
    "rule pressures": rule_cases,
    "encounter, sea areas and limits": encounter_cases,
    "measured records": record_cases,
    "bodies of known coefficients": body_cases,
    "sections": section_cases,
    "strip theory": strip_cases,
    "high-speed theory": high_speed_cases,
    "any ship": ship_cases,
    "heavy-lift model": model_cases,
    "wet-deck slam of the heavy-lift model": baggus_cases,
    "spreading plate": spreading_plate,
    "slam loads of the Incat 98 m": amin_cases,
    "sailing multihulls": sail_cases,
    "parametric studies": parametric_cases,
    "studies over conditions": condition_cases,
    "simulation in time": simulation_cases,
    "Delft 372": delft_cases,
}


def all_cases(slow: bool = False) -> dict[str, list[Case]]:
    """Return the cases by group; those that take more than some seconds only if ``slow``."""
    return {
        group: [case for case in module.cases() if slow or not case.slow] for group, module in GROUPS.items()
    }


def outcomes(
    chosen: Iterable[Case], progress: Callable[[float, str], None] = lambda fraction, message: None
) -> list[Outcome]:
    """Run cases in order; ``progress`` is called with the fraction done and the id after each."""
    chosen = list(chosen)
    found = []
    for number, case in enumerate(chosen, start=1):
        found.append(outcome(case))
        progress(number / len(chosen), case.id)
    return found


def cases(slow: bool = False) -> tuple[bool, dict[str, Any]]:
    """Run all cases.

    Parameters
    ----------
    slow : include Capytaine's forward-speed option on the Delft 372 (minutes when not kept from before).

    Returns
    -------
    Whether none fails (a known miss that stays where it was is no failure), and the
    outcomes as plain values: ``cases``, ``counts`` by verdict, ``seconds``.
    """
    start = time.perf_counter()
    rows = []
    for group, chosen in all_cases(slow).items():
        rows += [{"group": group, **found.as_dict()} for found in outcomes(chosen)]
    counts = {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in VERDICTS}
    seconds = round(time.perf_counter() - start, 1)
    return counts["fails"] == 0, {"cases": rows, "counts": counts, "seconds": seconds}


def features() -> tuple[bool, dict[str, Any]]:
    """Check the table of features: every row called works, or partial, must have evidence that passes.

    Returns
    -------
    Whether all do, and the rows as plain values: ``features``, ``counts`` by status,
    ``note`` on evidence that could not be run here.
    """
    by_id = {case.id: case for group in all_cases().values() for case in group}
    return feature_table.checked_features(by_id)


def text(values: dict[str, Any]) -> str:
    """Return the values of `cases` or `features` for reading."""
    return _features_text(values) if "features" in values else _cases_text(values)


def _number(value: float | None) -> str:
    return "not finite" if value is None else f"{value:.5g}"


def _cases_text(values: dict[str, Any]) -> str:
    lines: list[str] = []
    group = ""
    reasons: dict[str, str] = {}
    for row in values["cases"]:
        if row["group"] != group:
            group = row["group"]
            lines += ["", f"{group:<104}{'known':>11}{'computed':>12}{'difference':>13}{'tolerance':>11}"]
        known, computed, difference = (_number(row[name]) for name in ("published", "computed", "difference"))
        unit = "" if row["unit"] == "-" else f" [{row['unit']}]"
        mark = ""
        if row["verdict"] == "known miss":
            mark = f"({reasons.setdefault(row['miss'], str(len(reasons) + 1))})"
        lines.append(
            f"  {row['title'] + unit:<102}{known:>11}{computed:>12}{difference:>13}{row['tolerance']:>11.3g}"
            f"  {row['verdict']} {mark}".rstrip()
        )
    if reasons:
        lines += ["", "Why the known misses miss, as far as we know"]
        lines += [f"  ({number}) {reason}" for reason, number in reasons.items()]
    failing = [row for row in values["cases"] if row["verdict"] == "fails"]
    if failing:
        lines += ["", f"Failing: {', '.join(row['id'] for row in failing)}"]
        lines += [f"  {row['id']} was refused: {row['refusal']}" for row in failing if row["refusal"]]
    counts = ", ".join(f"{number} {verdict}" for verdict, number in values["counts"].items())
    return "\n".join([*lines[1:], "", f"{len(values['cases'])} cases in {values['seconds']:.0f} s: {counts}"])


def _features_text(values: dict[str, Any]) -> str:
    lines = []
    for row in values["features"]:
        verdict = row["verdict"]
        lines.append(f"  {row['id']:<12}{row['status']:<9}{verdict:<22}{row['feature']}")
        lines += [f"{'':14}fails: {name}" for name in row["failed"]]
    counts = ", ".join(f"{number} {status}" for status, number in values["counts"].items())
    lines += ["", f"{len(values['features'])} features: {counts}"]
    if values["note"]:
        lines.append(values["note"])
    return "\n".join(lines)
