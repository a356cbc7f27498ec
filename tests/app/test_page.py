"""The page without a browser: model, desk and panels together, on a shipped design."""

import threading
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from workbench import potential_flow_stage, radiation_store
from workbench.app import case, desk, main, server, work
from workbench.app.main import app
from workbench.app.method_inputs import PANEL_METHOD_ACTS
from workbench.app.panels.deck_slams import what_it_is
from workbench.app.panels.design import gap_rows
from workbench.app.panels.motions import gap_frequencies, gap_frequency
from workbench.app.panels.slam_view import slam_in_time
from workbench.errors import InputError
from workbench.hulls import library
from workbench.hydrodynamics import strip_theory
from workbench.hydrodynamics.gap_resonance import gap_resonance
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.scene import stills


@pytest.fixture(scope="module")
def page():
    desk.REST_DELAY, desk.PRESSURE_DELAY = 0.1, 0.1
    case.LONGEST_PRESSURES = 0.05
    made = app().page
    assert made.desk.settle(120)
    assert made.desk.error == ""
    return made


def until(condition, timeout=20.0):
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.01)
    return False


def open_tab(page, title):
    page.tabs.selected_index = next(i for i, panel in enumerate(page.panels) if panel.title == title)
    assert page.desk.settle(60)
    return page.panels[page.tabs.selected_index]


def test_first_results(page):
    panel = open_tab(page, "Slamming")
    assert page.desk.is_current
    assert page.head.verdict.startswith("At ")
    assert page.head.tone in ("good", "bad")
    for drawing in panel.drawings:
        assert drawing.view.picture.startswith(b"\x89PNG")
        assert not drawing.view.old
        assert drawing.view.words
    assert panel.plan.notes
    assert panel.share_within() > 0.9


def test_statistics_follow_a_slider(page):
    open_tab(page, "Data")
    times = []
    for clearance in (3.0, 3.1, 3.2, 3.3, 3.4):
        before = page.model.findings
        start = time.perf_counter()
        page.model.change("clearance", clearance)
        while page.model.findings is before and time.perf_counter() - start < 20:
            time.sleep(0.001)
        times.append(time.perf_counter() - start)
        assert page.model.findings.slam.clearance == clearance
        assert page.desk.settle()
    print("statistics:", ", ".join(f"{1e3 * one:.0f} ms" for one in times))


def test_verdict_and_figure_change_with_the_clearance(page):
    panel = open_tab(page, "Slamming")
    page.model.change("clearance", 2.6)
    assert page.desk.settle()
    picture, verdict = panel.plan.picture, page.head.verdict
    page.model.change("clearance", 4.0)
    assert page.desk.settle()
    assert panel.plan.picture != picture
    assert page.head.verdict != verdict


@pytest.mark.parametrize("title", ["Motions", "Pressure", "3-D", "Design", "Data"])
def test_tabs(page, title):
    panel = open_tab(page, title)
    assert page.desk.error == ""
    assert panel.message.value == ""
    assert all(drawing.view.picture for drawing in panel.drawings)
    if title == "3-D":
        assert panel.sea_view.scene["count"] > 10
        assert panel.deck_view.link == panel.sea_view.link != ""
        assert panel.deck_view.facts["count"] == panel.sea_view.scene["count"]


def test_slams_of_the_wet_deck_are_listed_and_looked_at(page):
    panel = open_tab(page, "Pressure")
    found, view = page.model.deck_slams, panel.cards[1].widget
    slams = found.slams
    assert found.realised.realisation.hours == 0.05
    number = int(np.argmax(slams.slam_pressure.values))
    assert view.facts["title"].startswith(
        f"Hardest slam by pressure, {float(slams.slam_start[number]):.1f} s"
    )
    assert f"{float(slams.slam_start[number]):.1f}</td>" in panel.cards[4].widget.value
    history = slam_in_time(found, number, False)
    assert float(history.deck_pressure.max()) == pytest.approx(float(slams.slam_pressure[number]), rel=1e-5)
    assert float(history.deck_force.max()) == pytest.approx(float(slams.slam_force[number]), rel=1e-5)
    view.chosen = {**view.chosen, "rank": "2", "by": "slam_force", "steps": "fine"}
    assert page.desk.settle(60)
    second = int(np.argsort(-slams.slam_force.values)[1])
    assert view.facts["title"].startswith(f"Slam number 2 by force, {float(slams.slam_start[second]):.1f} s")
    assert view.facts["step"] < 0.5 * history.attrs["time_step"]
    view.chosen = {"rank": "no such", "by": 3}
    assert page.desk.settle(60)
    assert view.facts["title"].startswith("Hardest slam by pressure")
    assert "Germanischer Lloyd" in panel.cards[-1].widget.value
    assert any("Each strip of the deck" in note for note in panel.cards[0].widget.notes)


def test_choice_of_the_pressure_and_seed_are_computed_anew_and_old_ones_greyed(page):
    panel = open_tab(page, "Pressure")
    former, view = page.model.deck_slams, panel.cards[1].widget
    page.model.change("deck_reduction", "pabst")
    assert until(lambda: view.old and panel.cards[0].widget.old)
    assert page.desk.settle(60)
    reduced = page.model.deck_slams
    assert not view.old
    assert float(reduced.slams.slam_pressure.max()) < float(former.slams.slam_pressure.max())
    page.model.change("deck_reduction", "none")
    page.model.change("seed", 2)
    assert page.desk.settle(60)
    assert page.model.deck_slams.realised.realisation.seed == 2
    assert page.model.counted.key == page.model.findings.case.counting_key
    assert not any(drawing.view.old for drawing in panel.drawings)
    page.model.change("seed", 1)


def test_slams_of_a_first_part_are_shown_while_the_rest_is_computed(page, monkeypatch):
    panel = open_tab(page, "Pressure")
    monkeypatch.setattr(work, "FIRST_PRESSURES", 0.02)
    seen = []
    page.model.observe(lambda change: seen.append(change.new), names=["deck_slams"])
    page.model.change("seed", 5)
    assert page.desk.settle(60)
    first, whole = seen
    assert (first.is_whole, whole.is_whole) == (False, True)
    assert (first.realised.realisation.hours, whole.realised.realisation.hours) == (0.02, 0.05)
    count = first.slams.sizes["slam"]
    np.testing.assert_allclose(whole.slams.slam_start[: count - 1], first.slams.slam_start[: count - 1])
    assert "More of the record" in what_it_is(first)
    assert "More of the record" not in " ".join(panel.cards[0].widget.notes)
    page.model.unobserve_all("deck_slams")
    page.model.change("seed", 1)
    assert page.desk.settle(60)


def test_pressure_over_the_deck_is_stopped_and_taken_up_again(page, monkeypatch):
    panel = open_tab(page, "Pressure")
    ready = threading.Event()

    def slow(*parts):
        def task(progress):
            while not ready.is_set():
                progress(0.1, "slams of 1 h")
                time.sleep(0.02)
            return deck_slams(*parts)(progress)

        return task

    deck_slams = work.deck_slams
    monkeypatch.setattr(work, "deck_slams", slow)
    page.model.change("seed", 3)
    assert until(lambda: "Pressure over the deck: slams of 1 h" in page.head.task)
    page._head_said({"type": "stop"})
    assert page.desk.settle(20)
    assert "was not computed" in page.head.task
    assert panel.cards[1].widget.old
    ready.set()
    page._head_said({"type": "resume"})
    assert page.desk.settle(60)
    assert not panel.cards[1].widget.old
    page.model.change("seed", 1)


def test_heading_that_is_not_computed_is_a_problem_and_greys(page):
    panel = open_tab(page, "Slamming")
    page.model.change("spreading", "2")
    page.model.change("heading_degrees", 171)
    assert page.desk.settle()
    assert "choose one of these" in page.model.problems["heading_degrees"]
    assert not page.desk.is_current
    assert all(drawing.view.old for drawing in panel.drawings)
    assert page.head.problems
    page.model.change("heading_degrees", 150)
    assert page.desk.settle()
    assert page.desk.is_current
    assert not any(drawing.view.old for drawing in panel.drawings)
    page.model.change("spreading", "")
    page.model.change("heading_degrees", 180)
    assert page.desk.settle()


def test_any_heading_of_a_long_crested_sea_is_computed(page):
    page.model.change("heading_degrees", 171)
    assert page.desk.settle()
    assert page.model.problems == {}
    assert page.desk.is_current
    directions = page.model.findings.ship.motions.wave_direction.values
    assert np.any(np.isclose(directions, np.radians(171)))
    assert len(directions) == 25
    page.model.change("heading_degrees", 180)
    assert page.desk.settle()


def test_new_speed_brings_the_heading_of_the_sea_first_and_then_all(page):
    open_tab(page, "Motions")
    open_tab(page, "Slamming")
    seen, headings = [], []
    speed = page.model.findings.ship.speed

    def found(change):
        headings.append(change.new.ship.motions.sizes["wave_direction"])

    page.desk.hull_job.observe(lambda change: seen.append(change.new), "state")
    page.model.observe(found, "findings")
    page.model.change("speed_knots", 22)
    assert page.desk.settle(60)
    page.model.unobserve(found, "findings")
    assert seen == ["running", "finished"]
    assert headings == [1, 24]
    assert page.model.findings.ship.speed > speed
    assert page.desk.is_current
    assert "by high-speed theory" in page.head.origin
    warned = page.model.findings.ship.motions.attrs["warnings"]
    for notes in (page.panels[0].rao.notes, page.panels[1].plan.notes):
        assert any("tau" in note for note in notes)
        assert not any("Strip theory gives no added mass" in note for note in notes)
    assert "Strip theory gives no added mass" in warned


def test_another_method_greys_until_it_is_computed_and_stands_in_the_address(page):
    open_tab(page, "Motions")
    assert "theory" not in page.head.permalink
    tones, picture = [], page.panels[0].rao.picture
    page.head.observe(lambda change: tones.append(change.new), "tone")
    page.model.change("theory", "strip")
    page.model.change("running_trim_degrees", 0.5)
    assert page.desk.settle(60)
    assert "old" in tones
    assert page.desk.is_current
    ship = page.model.findings.ship
    assert ship.settings == StripSettings()
    assert ship.running_state.running_trim == pytest.approx(np.radians(0.5))
    assert page.head.origin == "by strip theory"
    assert "Computed by strip theory." in page.panels[0].rao.notes
    assert any("Strip theory gives no added mass" in note for note in page.panels[0].rao.notes)
    assert page.panels[0].rao.picture != picture
    assert {"theory=strip", "running_trim_degrees=0.5"} <= set(page.head.permalink.split("&"))
    other = main.Page()
    other._head_said({"type": "hello", "state": "", "query": page.head.permalink})
    assert other.model.case().response_key == page.model.case().response_key
    page.model.change("theory", "recommended")
    page.model.change("running_trim_degrees", 0)
    assert page.desk.settle(60)


def test_theory_that_cannot_be_used_is_said_at_its_control(page):
    speed = page.model.inputs["speed_knots"]
    page.model.change("theory", "high-speed")
    page.model.change("speed_knots", 3)
    assert page.desk.settle(60)
    assert "Froude number must be >= 0.1" in page.model.problems["theory"]
    page.model.change("theory", "recommended")
    page.model.change("speed_knots", speed)
    assert page.desk.settle(60)
    assert page.desk.is_current


def test_attitude_that_drowns_the_hull_is_said_at_its_control(page):
    page.model.change("running_sinkage", 19)
    assert page.desk.settle(60)
    assert "Sinkage must be" in page.model.problems["running_sinkage"]
    page.model.change("running_sinkage", 0)
    assert page.desk.settle(60)
    assert page.desk.is_current


def faked_panel_method(monkeypatch, ready):
    """Let strip theory answer for the panel method, once it may."""

    def answer(hull, density, speed, wave_directions, omega, settings, *, workers, progress):
        while not ready.wait(0.02):
            progress(0.5, "Solving panels")
        omega = radiation_store.wave_frequencies(hull.length) if omega is None else omega
        found = strip_theory.hydrodynamics(hull, density, omega, wave_directions, speed, StripSettings())
        return found.assign_attrs(method="potential-flow"), None

    monkeypatch.setattr(potential_flow_stage, "hydrodynamics", answer)


def test_panel_method_refines_when_asked_and_until_then_the_quick_results_stay(page, monkeypatch):
    ready = threading.Event()
    faked_panel_method(monkeypatch, ready)
    panel = open_tab(page, "Motions")
    speed = page.model.inputs["speed_knots"]
    page.model.change("speed_knots", 0)
    assert page.desk.settle(60)
    assert page.head.origin == "by strip theory; at this speed the panel method is recommended"
    assert page.head.action == "refine"
    assert page.form.values[PANEL_METHOD_ACTS] == "yes"

    page._head_said({"type": "refine"})
    assert until(lambda: page.desk.hull_job.state == "running" and page.head.action == "stop")
    assert page.desk.is_current
    assert not panel.rao.old
    page._head_said({"type": "stop"})
    assert page.desk.settle(20)
    assert page.head.action == "refine"
    assert page.desk.is_current

    page._head_said({"type": "refine"})
    ready.set()
    assert page.desk.settle(60)
    assert page.model.findings.ship.motions.attrs["method"] == "potential-flow"
    assert page.head.origin == "by the panel method"
    assert page.head.action == ""
    assert "Computed by the panel method." in panel.rao.notes
    assert "refined" in page.head.state
    page.model.change("speed_knots", speed)
    assert page.desk.settle(60)
    assert page.form.values[PANEL_METHOD_ACTS] == "no"
    assert "high-speed" in page.head.origin


def test_refused_refinement_leaves_the_quick_results(page, monkeypatch):
    def refusal(*_, **__):
        raise InputError("panels must be more here, got few; ask for more.")

    monkeypatch.setattr(potential_flow_stage, "hydrodynamics", refusal)
    speed = page.model.inputs["speed_knots"]
    page.model.change("speed_knots", 0)
    assert page.desk.settle(60)
    page._head_said({"type": "refine"})
    assert page.desk.settle(60)
    assert "Not refined: Panels must be more" in page.head.remark
    assert page.desk.is_current
    assert page.head.action == "refine"
    page.model.change("speed_knots", speed)
    assert page.desk.settle(60)


def test_theories_are_compared_when_asked(page):
    panel = open_tab(page, "Theories")
    assert "wb-not-yet" in panel.results._dom_classes
    assert "Fn 0.4" in panel.state.value
    panel.button.click()
    assert page.desk.settle(60)
    assert panel.picture.picture.startswith(b"\x89PNG")
    assert "strip theory, high-speed theory" in panel.picture.words
    assert "wb-not-yet" not in panel.results._dom_classes
    assert "<td>high-speed theory</td>" in panel.numbers.value
    assert "Against the" not in panel.numbers.value
    page.model.change("heading_degrees", 150)
    assert page.desk.settle(60)
    assert panel.picture.old
    page.model.change("heading_degrees", 180)
    assert page.desk.settle(60)
    assert not panel.picture.old


def test_comparison_is_stopped(page, monkeypatch):
    ready = threading.Event()
    faked_panel_method(monkeypatch, ready)
    panel = open_tab(page, "Theories")
    panel.panels.value = True
    panel.button.click()
    assert until(lambda: "panel method: Solving panels" in page.head.task)
    page._head_said({"type": "stop"})
    assert page.desk.settle(20)
    assert page.desk.compare_job.state == "cancelled"
    assert page.head.action == ""
    assert page.desk.is_current
    ready.set()
    panel.button.click()
    assert page.desk.settle(60)
    assert "<td>panel method</td>" in panel.numbers.value
    panel.panels.value = False


def test_resonance_between_the_hulls_is_shown(page):
    panel = open_tab(page, "Design")
    ship = page.model.findings.ship
    piston = gap_frequencies(ship).piston
    assert f"{piston:.3g} rad/s, waves of {2 * np.pi / piston:.3g} s" in panel.afloat.value
    assert len(gap_rows(ship)) == 2
    single = SimpleNamespace(design=SimpleNamespace(hull=SimpleNamespace(count=1)))
    assert gap_rows(single) == []


@pytest.mark.parametrize(
    ("count", "speed", "settings", "marked"),
    [
        (2, 0, PotentialFlowSettings(), True), (2, 1, PotentialFlowSettings(), False),
        (2, 0, PotentialFlowSettings(interaction="off"), False), (1, 0, PotentialFlowSettings(), False),
        (2, 0, RecommendedSettings(quick=True), True), (2, 0, StripSettings(interaction="off"), False),
    ],
)  # fmt: skip
def test_resonance_is_marked_where_the_hulls_are_solved_together_at_rest(count, speed, settings, marked):
    shape = SimpleNamespace(beam=4.0)
    ship = SimpleNamespace(
        design=SimpleNamespace(hull=SimpleNamespace(count=count, length=40.0, spacing=12.0, shape=shape)),
        speed=speed, settings=settings, hydrostatics=xr.Dataset({"volume": 500.0, "waterplane_area": 250.0}),
    )  # fmt: skip
    assert gap_frequency(ship) == (gap_resonance(8.0, 4.0, 2.0).piston if marked else None)


def test_design_out_of_equilibrium_is_said_and_cured(page):
    mass = page.model.inputs["mass"]
    page.model.change("mass", 0.6 * mass)
    assert page.desk.settle(60)
    assert "Mass must be within 25 %" in page.model.problems["mass"]
    assert page.head.problems
    assert not page.desk.is_current
    page.model.change("mass", mass)
    assert page.desk.settle(60)
    assert page.desk.is_current
    assert page.head.task == ""


def test_stop_leaves_old_results_and_resume_computes(page):
    spacing = page.model.inputs["spacing"]
    page.model.change("spacing", spacing + 1)
    end = time.monotonic() + 20
    while page.desk.hull_job.state != "running" and time.monotonic() < end:
        time.sleep(0.01)
    page._head_said({"type": "stop"})
    assert page.desk.settle(20)
    assert page.desk.hull_job.state == "cancelled"
    assert page.head.action == "resume"
    assert page.head.tone == "old"
    page.model.change("spacing", spacing)
    assert page.desk.settle(60)
    assert page.desk.is_current
    assert page.head.action == ""


def test_saved_files(page, monkeypatch):
    sent = {}
    panel = open_tab(page, "Data")
    monkeypatch.setattr(panel, "send_file", lambda name, mime, content: sent.update({name: content}))
    for action in (
        panel._design, panel._inputs, panel._motions_csv, panel._motions_netcdf, panel._slamming_csv,
        panel._slamming_netcdf,
    ):  # fmt: skip
        assert "was saved" in action()
    panel._animation()
    assert page.desk.settle(60)
    assert "was saved" in panel._animation()
    assert "was saved" in panel._events_csv()
    text = sent["austal-63-slamming.csv"].decode()
    head = [line for line in text.splitlines() if line.startswith("#")]
    assert any("slams_per_hour [1/h]" in line for line in head)
    rows = [line for line in text.splitlines() if not line.startswith("#")]
    assert len(rows) == 401
    columns = rows[0].split(",")
    rate = np.array([float(row.split(",")[columns.index("slams_per_hour")]) for row in rows[1:]])
    exact = page.model.findings.slam.statistics.slams_per_hour.values
    np.testing.assert_allclose(rate, exact.ravel(), rtol=1e-6)
    assert b"<html" in sent["austal-63-animation.html"]


def test_film_is_painted_beside_the_page_and_an_obstacle_is_said(page, monkeypatch):
    panel = open_tab(page, "Data")
    page._want_scene()
    assert page.desk.settle(60)
    sent, asked = {}, {}
    monkeypatch.setattr(panel, "send_file", lambda name, mime, content: sent.update({name: content}))

    def film(scene, path, **others):
        asked.update(others)
        path.write_bytes(b"film")
        return path

    def said(words):
        end = time.monotonic() + 20
        while words not in panel.answer.value and time.monotonic() < end:
            time.sleep(0.02)
        return words in panel.answer.value

    monkeypatch.setattr(stills, "film", film)
    monkeypatch.setattr(stills, "rendering_obstacle", lambda: "Films need the EGL library.")
    assert panel._film() == "Films need the EGL library."
    monkeypatch.setattr(stills, "rendering_obstacle", lambda: "")
    assert "being painted" in panel._film()
    assert said("austal-63-film.mp4 was saved")
    assert sent == {"austal-63-film.mp4": b"film"}
    scene = page.model.scene
    hardest = float(scene.time[int(np.argmax(scene.pressure.max(("x", "y")).values))])
    assert asked["start"] < hardest < asked["end"]
    assert asked["end"] - asked["start"] == pytest.approx(12.0)

    def broken(scene, path, **others):
        raise RuntimeError("the painter ended with code 139")

    monkeypatch.setattr(stills, "film", broken)
    panel._film()
    assert said("could not be made: the painter ended with code 139")


def test_state_is_what_the_browser_keeps(page):
    other = main.Page()
    other._head_said({"type": "hello", "state": page.head.state, "query": ""})
    assert other.model.inputs == page.model.inputs
    query = "design=delft-372&clearance=0.09&law=no"
    other._head_said({"type": "hello", "state": "{rubbish", "query": query})
    assert other.model.design_name == "delft-372"
    assert float(other.model.inputs["clearance"]) == 0.09
    assert "law" in other.head.remark


def test_page_that_cannot_be_made_is_a_readable_account(monkeypatch):
    def broken():
        raise RuntimeError("no <ship>")

    monkeypatch.setattr(main, "Page", broken)
    shown = main.app()
    assert "could not start" in shown.value
    assert "no &lt;ship&gt;" in shown.value


def test_voila_arguments_are_settings_that_voila_knows():
    arguments = server.voila_arguments(8000, False)
    assert arguments[0].endswith("workbench.ipynb")
    text = " ".join(arguments)
    assert "widgets-manager8" in text
    assert "allow_template_override=NO" in text
    assert (server.TEMPLATE_FOLDER / "voila/templates/workbench/index.html.j2").exists()
    assert str(server.TEMPLATE_FOLDER) in server.environment()["JUPYTER_PATH"]


def test_app_listens_where_it_is_told(monkeypatch):
    asked = []
    monkeypatch.setattr(server, "_run", asked.extend)
    server.run_app(0, False, address="0.0.0.0")
    assert "--Voila.ip=0.0.0.0" in asked
    asked.clear()
    server.run_app(0, False)
    assert "--Voila.ip=127.0.0.1" in asked
    for address in ("everywhere", "::1", "192.0.2.1"):
        with pytest.raises(InputError, match="address must be"):
            server.run_app(0, False, address=address)
    with pytest.raises(InputError, match="port must be"):
        server.run_app(70000, False)


def test_notebooks_ask_for_no_news_and_no_updates():
    arguments = server.lab_arguments(8000, False)
    assert "--LabApp.news_url=None" in arguments
    assert "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate" in arguments
    assert server.lab_environment()["JUPYTER_CONFIG_PATH"].startswith(str(server.LAB_CONFIG_FOLDER))
    assert str(server.LAB_CONFIG_FOLDER) not in server.environment().get("JUPYTER_CONFIG_PATH", "")
    root = next(one for one in arguments if "root_dir" in one).split("=")[1]
    assert (Path(root) / server.NOTEBOOK).exists()


def test_ship_without_wet_deck_shows_its_motions(page):
    names = library.names()
    assert "cofea" in names
    page.model.choose("cofea")
    panel = page.panels[1]
    page.tabs.selected_index = 1
    end = time.monotonic() + 10
    while "no wet deck" not in panel.message.value and time.monotonic() < end:
        time.sleep(0.05)
    assert "no wet deck" in panel.message.value
    page._head_said({"type": "stop"})
    page.model.choose("austal-63")
    assert page.desk.settle(60)
