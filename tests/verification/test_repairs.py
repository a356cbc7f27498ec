"""Every equation that the source prints damaged is in the table, and the place and the tests it names are there."""

import importlib
import re
from pathlib import Path

import pytest

from workbench.errors import InputError
from workbench.verification.repairs import REPAIRS, Repair, rows

ROOT = Path(__file__).parents[2]
DAMAGED = (
    "A1.56 A1.58 A1.63 A1.65 A1.71 A1.74 A1.86 A1.87 A1.93 A1.95 A1.96 A1.100 A1.101 A1.102 A1.103 A1.104 "
    "2.1 2.2 2.13 2.15 2.18 2.19 2.20 2.32 2.35 2.36 2.45 2.46 2.47 2.48 2.49 2.50 tau 4.1 4.2 4.3 4.8 4.9 4.16 6.4"
).split()


def test_every_damaged_equation_has_exactly_one_row():
    listed = [equation for repair in REPAIRS for equation in repair.equations]
    assert sorted(listed) == sorted(DAMAGED)
    assert [repair.standing for repair in REPAIRS].count("switch") == 3


@pytest.mark.parametrize("repair", REPAIRS, ids=lambda repair: "-".join(repair.equations))
def test_the_place_and_the_tests_are_there(repair):
    assert bool(repair.tests) == bool(repair.where) == (repair.standing != "not used")
    for place in filter(None, repair.where.split("; ")):
        module, _, name = place.partition(":")
        assert hasattr(importlib.import_module(module), name), place
    for test in repair.tests:
        path, _, function = test.partition("::")
        text = (ROOT / path).read_text(encoding="utf-8")
        assert re.search(rf"^def {function}\(", text, re.MULTILINE), test


def test_switches_offer_the_printed_form():
    from workbench.damping.sail_damping import SailDampingSettings
    from workbench.records.point_motion import FORMS

    printed = SailDampingSettings(method="root-mean-square", mean_moment=True, divisor="amplitude")
    assert printed.mean_moment
    assert "printed" in FORMS


def test_rows_are_plain_and_standings_are_checked():
    assert all(isinstance(row["tests"], list) and isinstance(row["repair"], str) for row in rows())
    with pytest.raises(InputError, match="standing of the repair"):
        Repair(equations=("9.9",), repair="", standing="guess", where="", tests=())
