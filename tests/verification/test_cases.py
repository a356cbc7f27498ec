"""Every verification case that is not slow, and the ways in which a case can come out."""

import numpy as np
import pytest

from tests.conftest import VERDICTS
from workbench.errors import InputError
from workbench.verification import report
from workbench.verification.case import Case, outcome

CASES = {case.id: case for group in report.all_cases().values() for case in group}


@pytest.mark.parametrize("name", CASES)
def test_case_agrees_or_misses_as_it_is_known_to(name, request):
    """As the notebook of this session found it, or run here; what fails there is run here too, for its figures."""
    if request.config.stash.get(VERDICTS, {}).get(name, "fails") != "fails":
        return
    found = outcome(CASES[name])
    assert found.verdict != "fails", (found.computed, CASES[name].published, CASES[name].tolerance)


def test_ids_are_distinct_and_most_cases_agree():
    ids = [case.id for group in report.all_cases(slow=True).values() for case in group]
    assert len(ids) == len(set(ids)) > 140
    declared = [name for name in CASES if CASES[name].miss]
    assert len(declared) < 0.3 * len(CASES)


def test_slow_cases_are_left_out_unless_asked_for():
    every = {case.id for group in report.all_cases(slow=True).values() for case in group}
    assert {name for name in every - set(CASES)} == {
        *(f"delft-{mode}-fn{fn}-forward-speed" for mode in ("heave", "pitch") for fn in ("03", "075")),
        *(f"austal-{hull}-{knots}-knots-hs4" for hull in ("longer", "wider-hulls") for knots in (20, 30, 40)),
        *(f"nonlinear-wedge-{degrees}-{name}" for degrees in (12, 37, 52, 75) for name in ("peak", "force")),
        *(
            f"nonlinear-{name}"
            for name in ("start", "march", "parabola-force", "parabola-breadth", "slowing-force")
        ),
    }


def made(number, **changes):
    values = {
        "id": "made-up", "title": "a number", "kind": "closed form", "source": "nowhere",
        "published": 1.0, "computed": lambda: number, "tolerance": 0.1,
    }  # fmt: skip
    return Case(**{**values, **changes})


@pytest.mark.parametrize(
    ("computed", "known", "verdict"),
    [
        (1.05, {}, "agrees"),
        (1.15, {}, "fails"),
        (np.nan, {}, "fails"),
        (1.5, {"miss": "why", "miss_figure": 1.51, "miss_band": 0.02}, "known miss"),
        (1.6, {"miss": "why", "miss_figure": 1.51, "miss_band": 0.02}, "fails"),
        (1.05, {"miss": "why", "miss_figure": 1.51, "miss_band": 0.02}, "agrees"),
    ],
)
def test_verdict(computed, known, verdict):
    assert outcome(made(computed, **known)).verdict == verdict


@pytest.mark.parametrize(
    "changes", [{"kind": "guess"}, {"tolerance": -1.0}, {"miss": "why"}, {"published": np.nan}]
)
def test_cases_that_prove_nothing_are_refused(changes):
    with pytest.raises(InputError, match="made-up"):
        made(1.0, **changes)


def test_report_lists_numbers_reasons_and_counts(monkeypatch):
    chosen = [
        made(1.05, id="close", title="a close one"),
        made(1.5, id="off", title="one that is off", miss="no waves here", miss_figure=1.5, miss_band=0.1),
        made(2.0, id="wrong", title="a wrong one"),
    ]
    monkeypatch.setattr(report, "all_cases", lambda slow=False: {"made": chosen})
    passed, values = report.cases()
    assert not passed
    assert values["counts"] == {"agrees": 1, "known miss": 1, "fails": 1}
    written = report.text(values)
    for words in ("a close one", "1.05", "known miss (1)", "(1) no waves here", "Failing: wrong"):
        assert words in written

    monkeypatch.setattr(report, "all_cases", lambda slow=False: {"made": chosen[:2]})
    assert report.cases()[0]


def test_refused_case_fails_with_its_sentence(monkeypatch):
    def refuse():
        raise InputError("speed must be slower.")

    found = outcome(made(1.0, computed=refuse))
    assert (found.verdict, found.refusal) == ("fails", "speed must be slower.")
    monkeypatch.setattr(report, "all_cases", lambda slow=False: {"made": [made(1.0, computed=refuse)]})
    passed, values = report.cases()
    assert not passed
    assert "made-up was refused: speed must be slower." in report.text(values)
