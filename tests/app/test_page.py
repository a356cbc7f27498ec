"""The page without a browser: model, desk and panels together, on a shipped design."""

import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from workbench.app import main, server
from workbench.app.main import app
from workbench.app.panels.design import gap_rows
from workbench.app.panels.motions import gap_frequency
from workbench.errors import InputError
from workbench.hulls import library
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.scene import stills


@pytest.fixture(scope="module")
def page():
    made = app().page
    assert made.desk.settle(120)
    assert made.desk.error == ""
    return made


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


def test_heading_that_is_not_computed_is_a_problem_and_greys(page):
    panel = open_tab(page, "Slamming")
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
    page.model.change("heading_degrees", 180)
    assert page.desk.settle()


def test_new_speed_goes_through_the_job_and_greys_until_then(page):
    seen = []
    page.desk.hull_job.observe(lambda change: seen.append(change.new), "state")
    speed = page.model.findings.ship.speed
    page.model.change("speed_knots", 22)
    assert page.desk.settle(60)
    assert seen == ["running", "finished"]
    assert page.model.findings.ship.speed > speed
    assert page.desk.is_current


def test_another_method_greys_until_it_is_computed_and_stands_in_the_address(page):
    open_tab(page, "Motions")
    assert "panels" not in page.head.permalink
    tones, pictures = [], page.panels[0].rao.picture
    page.head.observe(lambda change: tones.append(change.new), "tone")
    page.model.change("panels", 300)
    page.model.change("tunnel_damping", 0.05)
    assert page.desk.settle(60)
    assert "old" in tones
    assert page.desk.is_current
    assert page.model.findings.ship.settings.panels == 300
    assert page.panels[0].rao.picture != pictures
    assert {"panels=300", "tunnel_damping=0.05"} <= set(page.head.permalink.split("&"))
    other = main.Page()
    other._head_said({"type": "hello", "state": "", "query": page.head.permalink})
    assert other.model.case().settings == page.model.case().settings
    page.model.change("panels", 1000)
    page.model.change("tunnel_damping", 0)
    assert page.desk.settle(60)


def test_resonance_between_the_hulls_is_shown(page):
    panel = open_tab(page, "Design")
    attributes = page.model.findings.ship.hydrodynamics.attrs
    piston = attributes["gap_piston_frequency"]
    assert f"{piston:.3g} rad/s, waves of {2 * np.pi / piston:.3g} s" in panel.afloat.value
    assert len(gap_rows(attributes)) == 2
    assert gap_rows({}) == []


@pytest.mark.parametrize(
    ("count", "speed", "interaction", "marked"),
    [(2, 0, "auto", True), (2, 1, "auto", False), (2, 0, "off", False), (1, 0, "auto", False)],
)
def test_resonance_is_marked_where_the_hulls_are_solved_together_at_rest(count, speed, interaction, marked):
    hull = SimpleNamespace(count=count, length=40.0)
    ship = SimpleNamespace(
        design=SimpleNamespace(hull=hull), speed=speed,
        settings=PotentialFlowSettings(interaction=interaction),
        hydrodynamics=SimpleNamespace(attrs={"gap_piston_frequency": 1.3}),
    )  # fmt: skip
    assert gap_frequency(ship) == (1.3 if marked else None)


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
