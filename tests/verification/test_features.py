"""The table of features: complete, honest about what is missing, and its evidence there."""

import re
from pathlib import Path

import pytest

from workbench.verification import feature_table, published, report

ROOT = Path(__file__).parents[2]
ROWS = feature_table.table_rows()
CASES = {case.id: case for group in report.all_cases().values() for case in group}


def test_every_feature_has_exactly_one_row():
    assert [row["id"] for row in ROWS] == feature_table.expected_ids()
    assert len(ROWS) == 131


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_status_and_evidence_belong_together(row):
    evidence = feature_table.evidence_of(row)
    assert row["status"] in feature_table.STATUSES
    assert row["feature"]
    assert bool(evidence) == bool(row["module"]) == (row["status"] != "missing")
    for name in evidence:
        if not feature_table.is_test(name):
            assert name in CASES, name
            continue
        path, _, function = name.partition("::")
        assert re.search(rf"^def {function}\(", (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE), name
    for module in filter(None, row["module"].split("; ")):
        place = ROOT / module.replace(".", "/")
        assert place.is_dir() or place.with_suffix(".py").is_file(), module


def row(status="works", evidence="some-case"):
    return {"id": "grande-1", "feature": "f", "status": status, "module": "m", "evidence": evidence}


@pytest.mark.parametrize(
    ("given", "passed", "holds"),
    [
        (row(), {"some-case": True}, True),
        (row(), {"some-case": False}, False),
        (
            row(evidence="some-case;tests/a.py::test_b"),
            {"some-case": True, "tests/a.py::test_b": False},
            False,
        ),
        (row(evidence=""), {}, False),
        (row("missing", ""), {}, True),
        (row(evidence="tests/a.py::test_b"), {"tests/a.py::test_b": None}, True),
    ],
)
def test_a_row_holds_with_its_evidence(given, passed, holds):
    assert feature_table._checked_row(given, passed)["passed"] is holds


def test_pytest_says_what_passed(tmp_path):
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "test_some.py").write_text(
        "import pytest\n"
        "def test_good():\n    pass\n"
        "def test_bad():\n    assert False\n"
        "@pytest.mark.parametrize('n', [1, 2])\ndef test_each(n):\n    pass\n"
        "@pytest.mark.skip\ndef test_skipped():\n    pass\n"
    )
    names = [f"tests/test_some.py::test_{name}" for name in ("good", "bad", "each", "skipped", "absent")]
    found = feature_table.tests_passed(tmp_path, [*names, "tests/test_none.py::test_x"])
    assert [found[name] for name in names] == [True, False, True, False, False]
    assert found["tests/test_none.py::test_x"] is False


def test_wheel_says_that_tests_were_not_run(monkeypatch):
    monkeypatch.setattr(published, "checkout_folder", lambda: None)
    monkeypatch.setattr(published, "data_folder", lambda: ROOT / "tests" / "data")
    monkeypatch.setattr(
        feature_table, "table_rows", lambda: (row(evidence="ochi-threshold;tests/a.py::test_b"),)
    )
    passed, values = report.features()
    assert passed
    assert values["note"] == feature_table.WHEEL_NOTE
    assert "1 of 2 hold" in report.text(values)
