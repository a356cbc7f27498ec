"""The tab of the section that enters the water, without a browser: model, desk and panel together."""

import time
from types import SimpleNamespace

import numpy as np
import pytest

from workbench.app import section_inputs, work
from workbench.app.main import app
from workbench.app.model import Model
from workbench.app.reading import Problems
from workbench.app.section_inputs import SECTION_DEFAULTS, entry_case, kinds_for, points_of, section_of
from workbench.errors import InputError
from workbench.hulls import library
from workbench.impact.entry_case import THEORIES, EntryCase
from workbench.impact.section import Circle, Wedge


@pytest.fixture(scope="module")
def page():
    """A page that shows the section; the ship's own work is stopped."""
    made = app().page
    made.tabs.selected_index = next(i for i, one in enumerate(made.panels) if one.title == "Section")
    end = time.monotonic() + 30
    while not any(job.state == "running" for job in made.desk.jobs) and time.monotonic() < end:
        time.sleep(0.01)
    made.desk.stop()
    assert made.desk.settle(60)
    return made


@pytest.fixture
def panel(page):
    page.model.section_inputs = dict(SECTION_DEFAULTS)
    assert page.desk.settle(60)
    return page.panels[page.tabs.selected_index]


def theories(panel):
    return {one["name"]: one for one in panel.view.scene["theories"]}


def inputs(**changes):
    return SECTION_DEFAULTS | changes


def test_wedge_is_shown_by_every_quick_theory(page, panel):
    states = {name: one["status"] for name, one in theories(panel).items()}
    assert states.pop("nonlinear") == "waiting"
    assert set(states) == set(THEORIES) - {"nonlinear"}
    assert set(states.values()) == {"ready"}
    assert panel.view.scene["title"] == "Wedge of 20 degrees deadrise enters calm water"
    assert page.desk.error == ""


def test_quick_theories_follow_a_slider_first(page, panel):
    times = []
    for degrees in (21.0, 22.0, 23.0):
        revision = panel.view.revision
        start = time.perf_counter()
        page.model.change_section("section_deadrise", degrees)
        while panel.view.revision == revision and time.perf_counter() - start < 20:
            time.sleep(0.002)
        times.append(time.perf_counter() - start)
        assert page.desk.settle(60)
        assert theories(panel)["similarity"]["status"] == "ready"
    print("section:", ", ".join(f"{1e3 * one:.0f} ms" for one in times))
    assert panel.form.values["section_deadrise"] == 23.0


@pytest.mark.parametrize(
    ("name", "value", "control", "words"),
    [
        ("section_deadrise", "x", "section_deadrise", "must be a number"),
        ("section_deadrise", 90, "section_deadrise", "<= 85 degrees"),
        ("section_velocity", 0, "section_velocity", "> 0"),
        ("section_deceleration", 50, "section_deceleration", "stops before"),
        ("section_penetration", -1, "section_penetration", "> 0"),
        ("section_panel_outer", 0.1, "section_panel_outer", "outer edge of the panel"),
    ],
)
def test_refused_input_is_a_sentence_at_its_control(page, panel, name, value, control, words):
    page.model.change_section(name, value)
    assert page.desk.settle(30)
    assert list(panel.form.problems) == [control]
    assert words.lower() in panel.form.problems[control].lower()
    assert panel.view.old
    page.model.change_section(name, SECTION_DEFAULTS[name])
    assert page.desk.settle(30)
    assert panel.form.problems == {}
    assert not panel.view.old


def test_theory_that_refuses_says_why(page, panel):
    page.model.change_section("section_kind", "circle")
    assert page.desk.settle(60)
    found = theories(panel)
    assert found["similarity"]["status"] == "refused"
    assert "wedges only" in found["similarity"]["sentence"]
    assert found["generalised-wagner"]["status"] == "ready"
    assert page.model.section_inputs["section_penetration"] == 0.25


def test_slow_theory_is_solved_on_request_and_its_refusal_is_shown(page, panel, monkeypatch):
    def refused(case, method):
        assert (case.velocity, method) == (2.0, "nonlinear")
        return lambda progress: "Too deep for this test; choose less."

    monkeypatch.setattr(work, "entry_by", refused)
    panel.button.click()
    assert page.desk.settle(30)
    found = theories(panel)["nonlinear"]
    assert (found["status"], found["sentence"]) == ("refused", "Too deep for this test; choose less.")
    assert "Too deep" in panel.state.value


def test_slow_theory_can_be_stopped(page, panel, monkeypatch):
    def endless(case, method):
        def task(progress):
            while True:
                progress(0.0, "marching")
                time.sleep(0.01)

        return task

    monkeypatch.setattr(work, "entry_by", endless)
    page.model.change_section("section_velocity", 2.6)
    assert page.desk.settle(30)
    panel.button.click()
    assert page.desk.section_job.state == "running"
    page.head._on_message({"type": "stop"})
    assert page.desk.section_job.state == "cancelled"
    assert theories(panel)["nonlinear"]["status"] == "waiting"


def test_entry_in_a_process_of_its_own_answers_refuses_and_ends():
    case = EntryCase(section=Circle(1.0), velocity=2.0, penetration=0.05)
    found = work.entry_by(case, "wagner")(lambda *_: None)
    assert float(found.penetration[-1]) == pytest.approx(0.05)
    answers = []
    work._entry(SimpleNamespace(send=answers.append), case, "similarity")
    assert "wedges only" in answers[0]

    class UnwantedError(Exception):
        pass

    def unwanted(*_):
        raise UnwantedError

    with pytest.raises(UnwantedError):
        work.entry_by(case, "generalised-wagner")(unwanted)


def test_theories_ticked_are_kept_with_the_page(page, panel):
    panel.view.shown = ["wagner", "similarity"]
    assert page.model.section_inputs["section_shown"] == "wagner,similarity"
    page.model.change_section("section_shown", "wagner")
    assert panel.view.shown == ["wagner"]


def test_state_and_permalink_hold_the_section(page, panel):
    page.model.change_section("section_kind", "parabola")
    page.model.change_section("section_radius", "4,5")
    assert "section_kind=parabola" in page.head.permalink
    other = Model()
    assert other.restore(page.model.state()) == []
    assert other.section_inputs == page.model.section_inputs
    third = Model()
    query = {"section_kind": "parabola", "section_radius": "3", "section_shown": "froude", "section_x": "1"}
    ignored = third.restore({"design": "austal-63", "inputs": query})
    assert third.section_inputs["section_radius"] == 3.0
    assert len(ignored) == 2


def test_points_are_read_as_pasted_and_refused_by_line():
    assert points_of("y [m]; z [m]\n0; 0\n# bilge\n1\t0.1\n 2, 0.5 # chine\n") == ((0, 0), (1, 0.1), (2, 0.5))
    with pytest.raises(InputError, match="Line 2 of the points must hold two numbers"):
        points_of("0, 0\n1, 2, 3")
    with pytest.raises(InputError, match="Line 1"):
        points_of("0, zero")
    with pytest.raises(InputError, match="give fewer"):
        points_of("0 0\n" * 10_000)
    with pytest.raises(InputError, match="may have 200 points"):
        points_of("0 0\n" * 300)
    design = library.design("austal-63")
    with pytest.raises(Problems, match="concave") as refused:
        entry_case(inputs(section_kind="points", section_points="0 0\n1 1\n2 1.5"), design, None)
    assert list(refused.value.sentences) == ["section_points"]


def test_decks_own_sections():
    vees = [name for name in library.names() if (d := library.design(name).wet_deck) and d.vee_depth > 0]
    model = Model(vees[0])
    deck = model.base.wet_deck
    section, title, words = section_of(inputs(section_kind="pod"), model.base, model.case())
    assert section == Wedge(float(np.arctan(2 * deck.vee_depth / deck.vee_width)))
    assert "V of the pod" in title
    assert "flat from y" in words
    section, title, words = section_of(inputs(section_kind="crest"), model.base, model.case())
    sea = model.case().condition.sea_state
    wavenumber = (2 * np.pi / sea.peak_period) ** 2 / 9.80665
    assert section.radius == pytest.approx(1 / (wavenumber**2 * sea.significant_wave_height / 2))
    with pytest.raises(InputError, match="sea of the page"):
        section_of(inputs(section_kind="crest"), model.base, None)
    with pytest.raises(InputError, match="no depth in the present design"):
        section_of(inputs(section_kind="bow"), model.base, None)


def test_kind_that_another_design_has_not_falls_back_to_the_wedge():
    vees = [name for name in library.names() if "pod" in kinds_for(library.design(name))]
    model = Model(vees[0])
    model.change_section("section_kind", "pod")
    assert model.section_inputs["section_kind"] == "pod"
    model.choose("austal-63")
    assert model.section_inputs["section_kind"] == "wedge"


def test_crest_comes_with_a_penetration_of_few_degrees():
    model = Model()
    model.change_section("section_kind", "crest")
    case, _ = entry_case(model.section_inputs, model.base, model.case())
    edge = 2 * np.sqrt(case.section.radius * case.penetration)
    assert np.degrees(edge / case.section.radius) == pytest.approx(3.4, abs=0.2)
    assert case.density == model.base.density
    assert section_inputs.unusual_section(model.section_inputs)["section_kind"] == "crest"
