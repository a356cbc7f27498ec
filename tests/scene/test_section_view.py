"""The view of a section that enters the water: what is sent, and what the page makes of it."""

import base64
import json

import numpy as np
import pytest
from traitlets import TraitError

from workbench.errors import InputError
from workbench.impact.entry_case import THEORIES, EntryCase, compared_entries
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.scene.section_scene import section_scene
from workbench.scene.section_view import STATIC, SectionView, section_view
from workbench.theory_lines import THEORY_LINES

METHODS = ("von-karman", "wagner", "logvinovich", "generalised-wagner", "similarity", "chuang")


@pytest.fixture(scope="module")
def case():
    return EntryCase(section=Wedge(np.radians(20)), velocity=2.0, penetration=0.5, panel=(0.5, 1.0))


@pytest.fixture(scope="module")
def compared(case):
    return compared_entries(case, METHODS, 5)


@pytest.fixture(scope="module")
def scene(case, compared):
    return section_scene(case, compared, {"nonlinear": "Press the button."})


def test_every_theory_has_words_and_a_line_of_its_own():
    assert set(THEORY_LINES) == set(THEORIES)
    assert len({line.dash for line in THEORY_LINES.values()}) == len(THEORIES)
    assert len({line.colour for line in THEORY_LINES.values()}) == len(THEORIES)


def test_facts_are_plain_values_and_theories_stand_in_order(scene):
    facts, _ = scene
    assert json.loads(json.dumps(facts, allow_nan=False)) == facts
    assert [one["name"] for one in facts["theories"]] == list(THEORIES)
    states = {one["name"]: one["status"] for one in facts["theories"]}
    assert states.pop("nonlinear") == "waiting"
    assert set(states.values()) == {"ready"}
    assert facts["motion"]["penetration"][-1] == pytest.approx(0.5)


def test_block_holds_pressure_and_water_of_every_instant(scene, compared):
    facts, block = scene
    numbers = np.frombuffer(block, "<f4")
    for theory in facts["theories"]:
        if not theory.get("points"):
            continue
        found = compared.found[theory["name"]]
        width = 2 * (theory["points"] + theory["surface_points"])
        rows = numbers[theory["offset"] :][: 5 * width].reshape(5, width)
        assert rows[:, :201] == pytest.approx(found.pressure_position.values, rel=1e-6)
        assert rows[:, 201:402] == pytest.approx(found.section_pressure.values, rel=1e-6)
        y, z = rows[:, 402 : 402 + theory["surface_points"]], rows[:, 402 + theory["surface_points"] :]
        on_section = y[:, 0] * np.tan(np.radians(20)) - found.penetration.values
        assert z[:, 0] == pytest.approx(0.0 if theory["name"] == "von-karman" else on_section, abs=1e-6)


def test_histories_and_marks_are_those_of_the_entries(scene, compared):
    facts, _ = scene
    wagner = next(one for one in facts["theories"] if one["name"] == "wagner")
    found = compared.found["wagner"]
    assert wagner["histories"]["force"] == pytest.approx(found.section_force.values)
    assert wagner["histories"]["panel"] == pytest.approx(found.panel_pressure.values[:, 0])
    assert wagner["histories"]["peak_place"] == pytest.approx(found.wetted_half_breadth.values, rel=1e-3)
    karman = next(one for one in facts["theories"] if one["name"] == "von-karman")
    assert karman["histories"]["peak"] == [None] * 5
    assert "no pile-up" in karman["warnings"][0]


@pytest.mark.parametrize(
    "section",
    [Circle(1.0), Parabola(5.0), TableSection(((0.0, 0.0), (1.0, 0.0), (2.0, 0.5)))],
    ids=lambda one: one.kind,
)
def test_any_section_is_drawn_as_far_as_it_goes(section):
    case = EntryCase(section=section, velocity=2.0, penetration=0.1)
    facts, _ = section_scene(case, compared_entries(case, ("wagner", "similarity"), 4))
    y, z = np.array(facts["outline"]["y"]), np.array(facts["outline"]["z"])
    assert y[-1] <= section.reach
    assert z == pytest.approx(section.height(y))
    assert facts["panel"] is None
    refused = next(one for one in facts["theories"] if one["name"] == "similarity")
    assert refused["status"] == "refused"
    assert "wedges only" in refused["sentence"]


def test_motion_is_that_of_the_entries():
    case = EntryCase(section=Parabola(5.0), velocity=3.0, penetration=0.25, deceleration=6.0)
    compared = compared_entries(case, ("wagner",), 4)
    facts, _ = section_scene(case, compared)
    found = compared.found["wagner"]
    assert facts["motion"]["penetration"] == pytest.approx(found.penetration.values)
    assert facts["motion"]["velocity"] == pytest.approx(found.entry_velocity.values)


def test_scene_without_an_answer_can_be_drawn(case):
    facts, block = section_scene(case, compared_entries(case, (), 5))
    assert facts["theories"] == []
    assert block == b""


def test_another_entry_keeps_the_share_of_the_film(case, compared):
    view = SectionView()
    view.show(case, compared)
    assert view.time == pytest.approx(case.duration)
    view.time = case.duration / 2
    slower = EntryCase(section=case.section, velocity=1.0, penetration=0.5)
    view.show(slower, compared_entries(slower, METHODS[:2], 5))
    assert view.time == pytest.approx(slower.duration / 2)
    assert view.revision == 2


def test_theories_shown_are_checked(case):
    view = section_view(case, ("wagner", "chuang"))
    assert view.shown == ["wagner"]
    with pytest.raises((InputError, TraitError), match="must be one of"):
        view.shown = ["froude"]


MODEL = """
async ([code, css, state, curves]) => {
  document.head.append(Object.assign(document.createElement('style'), { textContent: css }));
  state.curves = new DataView(Uint8Array.from(atob(curves), (c) => c.charCodeAt(0)).buffer);
  const listeners = {};
  window.modelState = state;
  window.kernelSets = (changes) => {
    Object.assign(state, changes);
    Object.keys(changes).forEach((name) => (listeners['change:' + name] ?? []).forEach((one) => one()));
  };
  const model = {
    get: (name) => state[name],
    set(name, value) { kernelSets({ [name]: value }); },
    save_changes() {},
    on: (event, listener) => (listeners[event] ??= []).push(listener),
    off: (event, listener) => (listeners[event] = listeners[event].filter((one) => one !== listener)),
  };
  const module = await import(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
  const el = document.createElement('div');
  document.body.append(el);
  window.cleanUp = module.default.render({ model, el });
  window.listenerCount = () => Object.values(listeners).flat().length;
  window.drawing = () => document.querySelector('.sec-main').toDataURL();
}
"""


@pytest.fixture
def widget(chromium, case, compared):
    page = chromium.new_page(viewport={"width": 900, "height": 900})
    complaints = []
    page.on("pageerror", lambda error: complaints.append(str(error)))
    view = SectionView()
    view.show(case, compared, {"nonlinear": "Press the button."})
    names = ("scene", "revision", "time", "playing", "shown", "old")
    state = json.loads(json.dumps({name: getattr(view, name) for name in names}))
    code, css = ((STATIC / f"section_view.{kind}").read_text(encoding="utf-8") for kind in ("js", "css"))
    page.evaluate(MODEL, [code, css, state, base64.b64encode(view.curves).decode()])
    page.wait_for_function("document.querySelector('.sec').dataset.drawn > 0")
    yield page
    assert complaints == []
    page.close()


def changes_drawing(page, act) -> bool:
    page.evaluate("() => { window.before = drawing(); }")
    act()
    page.wait_for_function("drawing() !== window.before", polling=100, timeout=10_000)
    return True


@pytest.mark.browser
def test_scrub_keys_and_legend_change_the_drawing(widget):
    time = widget.get_by_label("Time", exact=True)
    assert changes_drawing(
        widget, lambda: time.evaluate("e => { e.value = 0.1; e.dispatchEvent(new Event('input')); }")
    )
    assert "100 ms after first contact, 0.200 m deep" in time.get_attribute("aria-valuetext")
    assert changes_drawing(
        widget, lambda: (widget.locator(".sec-main").focus(), widget.keyboard.press("Home"))
    )
    assert widget.evaluate("modelState.time") == pytest.approx(0.05)
    assert changes_drawing(widget, lambda: widget.keyboard.press("ArrowRight"))
    assert widget.evaluate("modelState.time") == pytest.approx(0.1)
    widget.keyboard.press("End")
    assert changes_drawing(widget, lambda: widget.get_by_role("checkbox", name="exact wedge").click())
    assert "similarity" not in widget.evaluate("modelState.shown")
    assert widget.get_by_role("checkbox", name="fully non-linear").is_disabled()
    assert changes_drawing(widget, lambda: widget.get_by_role("button", name="spray root").click())


@pytest.mark.browser
def test_film_plays_and_stops(widget):
    widget.locator(".sec-main").focus()
    widget.keyboard.press(" ")
    widget.wait_for_function("modelState.playing")
    widget.wait_for_timeout(700)
    widget.get_by_role("button", name="Pause").click()
    stopped = widget.evaluate("modelState.time")
    assert 0.05 <= stopped < 0.25
    widget.wait_for_timeout(200)
    assert widget.evaluate("modelState.time") == stopped


@pytest.mark.browser
def test_table_holds_the_figures_of_the_instant(widget):
    row = widget.locator("tr[data-theory=wagner] td").all_inner_texts()
    assert row[:4] == ["18.6", "0.571", "58.5", "4.32"]
    assert "infinite at its edge" in row[5]
    assert widget.locator("tr[data-theory=nonlinear] td").inner_text() == "Press the button."


@pytest.mark.browser
def test_pointer_reads_the_pressure(widget):
    box = widget.locator(".sec-main").bounding_box()
    widget.mouse.move(box["x"] + 58 + (box["width"] - 72) / 2, box["y"] + 100)
    widget.wait_for_function("document.querySelector('.sec-tip').textContent")
    said = widget.locator(".sec-tip").inner_text()
    assert "y = " in said
    assert "Wagner 17.7 kPa" in said.replace("\n", "")


@pytest.mark.browser
def test_kernel_sets_time_and_disposal_leaves_nothing(widget):
    assert changes_drawing(widget, lambda: widget.evaluate("kernelSets({ time: 0.12 })"))
    assert float(widget.locator(".sec").get_attribute("data-time")) == pytest.approx(0.12)
    widget.evaluate("cleanUp()")
    assert widget.evaluate("[listenerCount(), document.querySelectorAll('canvas').length]") == [0, 0]
