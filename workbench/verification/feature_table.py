"""The table of features of the five source documents, and whether its evidence holds."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from workbench.errors import InputError
from workbench.verification import published
from workbench.verification.case import Case, outcome

STATUSES = ("works", "partial", "missing")
DOCUMENTS = {"grande": 32, "chuang": 20, "couser": 35, "amin": 19, "baggus": 25}
"""Numbered features of each document."""

WHEEL_NOTE = "Tests named as evidence are in the source checkout and were not run; verification cases were."


def expected_ids() -> list[str]:
    """Return the ids of all features, in order."""
    return [f"{name}-{number}" for name, count in DOCUMENTS.items() for number in range(1, count + 1)]


def table_rows() -> tuple[dict[str, str], ...]:
    """Rows of the table: id, feature, status, module, evidence (ids separated by semicolons)."""
    return published.csv_rows(published.data_folder() / "features.csv")[1]


def evidence_of(row: Mapping[str, str]) -> list[str]:
    """Return the ids of the evidence of a row."""
    return [name.strip() for name in row["evidence"].split(";") if name.strip()]


def is_test(name: str) -> bool:
    """Whether a piece of evidence is a test (else it is a verification case)."""
    return name.startswith("tests/")


def checked_features(by_id: Mapping[str, Case]) -> tuple[bool, dict[str, Any]]:
    """Run the evidence of all rows; see `report.features`."""
    rows = table_rows()
    checkout = published.checkout_folder()
    wanted = sorted({name for row in rows for name in evidence_of(row)})
    passed: dict[str, bool | None] = {name: None for name in wanted if is_test(name)}
    if checkout is not None:
        passed |= tests_passed(checkout, passed)
    for name in wanted:
        if not is_test(name):
            passed[name] = name in by_id and outcome(by_id[name]).verdict == "agrees"
    found = [_checked_row(row, passed) for row in rows]
    return all(row["passed"] for row in found), {
        "features": found,
        "counts": {status: sum(row["status"] == status for row in found) for status in STATUSES},
        "note": "" if checkout else WHEEL_NOTE,
    }


def _checked_row(row: Mapping[str, str], passed: Mapping[str, bool | None]) -> dict[str, Any]:
    evidence = evidence_of(row)
    failed = [name for name in evidence if passed[name] is False]
    held = [name for name in evidence if passed[name]]
    unknown = [name for name in evidence if passed[name] is None]
    fits = not failed and (bool(held or unknown) or row["status"] == "missing")
    verdict = "" if row["status"] == "missing" else "no evidence"
    if evidence:
        verdict = f"{len(held)} of {len(evidence)} hold"
    return {**row, "evidence": evidence, "failed": failed, "passed": fits, "verdict": verdict}


def tests_passed(checkout: Path, names: Iterable[str]) -> dict[str, bool]:
    """Run tests by node id, all in one pytest, and say which passed.

    A node id without parameters, or a file, stands for all tests under it, of which
    at least one must exist and none fail.
    """
    names = list(names)
    files = sorted({name.split("::")[0] for name in names})
    existing = [name for name in files if (checkout / name).is_file()]
    if not existing:
        return dict.fromkeys(names, False)
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        chosen = [name for name in names if name.split("::")[0] in existing]
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            "-o",
            "junit_family=xunit1",
        ]
        command += [f"--junitxml={report}", "--continue-on-collection-errors"]
        environment = {**os.environ, "WORKBENCH_FEATURES": "1"}
        run = subprocess.run(  # our own interpreter and our own tests
            [*command, *_known_nodes(checkout, chosen)],
            cwd=checkout,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        if not report.is_file():
            raise InputError(
                f"pytest must be installed to run the evidence, got: {run.stderr.strip()[-300:]}"
            )
        results = _results(report)
    return {name: _holds(name, results) for name in names}


def _known_nodes(checkout: Path, names: list[str]) -> list[str]:
    """Leave out names of functions that their file does not hold, at which pytest would give up."""
    kept = []
    for name in names:
        path, _, inside = name.partition("::")
        function = inside.split("[")[0].split("::")[-1]
        if not function or f"def {function}(" in (checkout / path).read_text(encoding="utf-8"):
            kept.append(name.split("[")[0])
    return sorted(set(kept))


def _results(report: Path) -> dict[str, bool]:
    """Return node id and whether it passed, of every test in a report; skipped tests have not passed."""
    found = {}
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        classname = case.get("classname", "")
        file = case.get("file") or classname.replace(".", "/") + ".py"
        inner = classname.removeprefix(file.removesuffix(".py").replace("/", ".")).strip(".")
        node = "::".join(part for part in (file, inner.replace(".", "::"), case.get("name", "")) if part)
        found[node] = not any(case.find(tag) is not None for tag in ("failure", "error", "skipped"))
    return found


def _holds(name: str, results: Mapping[str, bool]) -> bool:
    under = [ok for node, ok in results.items() if node == name or node.startswith((f"{name}[", f"{name}::"))]
    return bool(under) and all(under)
