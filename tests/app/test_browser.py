"""The page in a real browser, as a new reader opens and uses it."""

import os
import re
import signal
from dataclasses import replace

import pytest

from workbench.files import design_to_toml
from workbench.hulls import library

pytestmark = pytest.mark.browser


def seconds_to_picture(page, name, value, figure):
    """Move a slider and wait for the next picture of a figure, by the browser's own clock [s]."""
    return page.evaluate(
        """([name, value, figure]) => new Promise((resolve, reject) => {
            const image = document.querySelector(`.wb-figure:has(#wb-figure-${figure}) img`);
            const start = performance.now();
            const watch = new MutationObserver(() => {
                watch.disconnect();
                image.decode().then(() => resolve((performance.now() - start) / 1000));
            });
            watch.observe(image, { attributes: true, attributeFilter: ["data-revision"] });
            const slider = document.querySelector(`[data-name=${name}] .wb-slider`);
            slider.value = value;
            slider.dispatchEvent(new Event("input", { bubbles: true }));
            setTimeout(() => reject(new Error("no new picture")), 20000);
        })""",
        [name, value, figure],
    )


def type_in(page, name, text):
    box = page.locator(f"[data-name={name}] .wb-box")
    box.fill(text)
    box.press("Tab")


def test_first_figures_come_and_nothing_leaves_the_machine(new_page):
    print(f"first figures after {new_page.seconds_to_figures:.1f} s")
    assert new_page.wait(lambda: re.search(r"kn in Hs .* this deck slams", new_page.verdict), 60)
    assert new_page.outside == []
    assert new_page.errors == []
    assert new_page.page.evaluate("document.documentElement.lang") == "en"


@pytest.mark.parametrize("size", [(1280, 800), (1920, 1080)])
def test_page_needs_no_horizontal_scrolling(new_page, size):
    new_page.page.set_viewport_size({"width": size[0], "height": size[1]})
    assert new_page.page.evaluate("document.documentElement.scrollWidth") <= size[0]
    wide = new_page.page.evaluate(
        "Math.max(...[...document.querySelectorAll('.wb-figure')].map(f => f.scrollWidth - f.clientWidth))"
    )
    assert wide <= 1


def test_source_is_not_shown(new_page):
    assert "import app" not in new_page.page.content()
    assert new_page.page.locator(".jp-InputArea").count() == 0


def test_slider_changes_verdict_and_figure(new_page):
    page = new_page.page
    new_page.wait_for_figures(4)
    new_page.wait_until_idle()
    times = []
    for value in (3.0, 3.4, 2.8, 3.2):
        sentence = new_page.verdict
        times.append(seconds_to_picture(page, "clearance", value, "slams-on-deck"))
        assert new_page.wait(lambda sentence=sentence: new_page.verdict != sentence)
        page.wait_for_timeout(1000)
        new_page.wait_until_idle()
    print("slider to figure:", ", ".join(f"{one:.2f} s" for one in times))
    assert new_page.page.locator("[data-name=clearance] .wb-box").input_value() == "3.2"


def test_refused_input_is_explained_beside_its_control_and_greys_the_figures(new_page):
    page = new_page.page
    type_in(page, "wave_height", "-2")
    problem = page.locator("[data-name=wave_height] .wb-problem")
    assert new_page.wait(lambda: "must be a finite number > 0" in problem.inner_text())
    assert new_page.wait(lambda: "must be" in new_page.verdict)
    assert new_page.wait(lambda: page.locator(".wb-figure.wb-is-old").count() >= 4)
    type_in(page, "wave_height", "2.5")
    assert new_page.wait(lambda: problem.inner_text() == "")
    assert new_page.wait(lambda: page.locator(".wb-figure.wb-is-old").count() == 0)
    assert new_page.wait(lambda: "Hs 2.5 m" in new_page.verdict)


def test_every_control_has_a_name(new_page):
    unnamed = new_page.page.evaluate(
        """() => [...document.querySelectorAll('.wb-page input, .wb-page select, .wb-page button')]
        .filter(e => !(e.labels?.length || e.getAttribute('aria-label') ||
            e.textContent.trim() || e.title || e.hidden))
        .map(e => e.outerHTML)"""
    )
    assert unnamed == []
    assert new_page.page.locator("[role=progressbar][aria-valuenow]").count() == 1


def test_method_is_closed_at_first_and_says_what_is_recommended(new_page):
    method = new_page.page.locator("details[data-key=method]")
    assert method.get_attribute("open") is None
    assert "high-speed theory" in method.locator("#wb-theory-note").text_content()
    assert method.locator("#wb-theory option").count() == 4
    assert method.locator("#wb-interaction option").count() == 3
    assert new_page.wait(lambda: "by high-speed theory" in new_page.page.locator(".wb-task").inner_text())


def test_controls_of_the_panel_method_show_where_it_is_chosen(new_page):
    page = new_page.page
    page.locator("details[data-key=method] summary").click()
    hidden = [page.locator(f"[data-name={name}]") for name in ("panels", "tunnel_damping", "wave_field")]
    assert not any(control.is_visible() for control in hidden)
    page.locator("#wb-theory").select_option("potential-flow")
    assert new_page.wait(lambda: all(control.is_visible() for control in hidden))
    page.locator("#wb-theory").select_option("strip")
    assert new_page.wait(lambda: not any(control.is_visible() for control in hidden))
    assert new_page.wait(lambda: "by strip theory" in page.locator(".wb-task").inner_text(), 40)
    page.locator("#wb-theory").select_option("recommended")
    assert new_page.wait(lambda: "by high-speed theory" in page.locator(".wb-task").inner_text(), 40)
    page.locator("details[data-key=method] summary").click()


def test_refinement_is_offered_at_rest(open_page):
    other = open_page("?design=cofea&speed_knots=0")
    button = other.page.get_by_role("button", name="Refine with the panel method")
    button.wait_for(state="visible", timeout=60000)
    assert "by strip theory" in other.page.locator(".wb-task").inner_text()
    other.page.close()


def test_theories_are_compared(new_page):
    new_page.open_tab("Theories")
    page = new_page.page
    button = page.get_by_role("button", name="Compare theories")
    button.wait_for(state="visible", timeout=20000)
    assert not page.locator(".wb-figure:has(#wb-figure-theories)").is_visible()
    button.click()
    page.wait_for_function(
        "document.querySelector('.wb-figure:has(#wb-figure-theories) img').naturalWidth > 0", timeout=60000
    )
    assert page.locator(".wb-table", has_text="high-speed theory").is_visible()
    new_page.open_tab("Slamming")


def test_animation_plays(new_page):
    new_page.open_tab("3-D")
    page = new_page.page
    page.wait_for_function("window.__sv && window.__sv.frames > 3", timeout=30000)
    first = page.evaluate("window.__sv.frames")
    assert new_page.wait(lambda: page.evaluate("window.__sv.frames") > first + 3, 15)
    new_page.open_tab("Slamming")


def test_deck_keeps_step_with_the_animation(new_page):
    new_page.open_tab("3-D")
    page = new_page.page
    page.wait_for_function(
        "window.__sv && [...document.querySelectorAll('.dk')].some(one => one.offsetParent && "
        "Math.abs(window.__sv.time - Number(one.dataset.time)) < 0.5 && one.dataset.drawn > 2)",
        timeout=30000,
    )
    new_page.open_tab("Slamming")


def test_a_slam_is_looked_at(new_page):
    new_page.open_tab("Pressure")
    page = new_page.page
    deck = page.locator(".dk:visible")
    assert new_page.wait(lambda: "Hardest slam by pressure" in deck.locator("h2").inner_text(), 60)
    deck.get_by_label("Slam shown").select_option("2")
    assert new_page.wait(lambda: "Slam number 2 by pressure" in deck.locator("h2").inner_text(), 20)
    deck.get_by_label("Time", exact=True).focus()
    page.keyboard.press("End")
    assert new_page.wait(lambda: "kPa" in deck.locator(".dk-status").inner_text())
    deck.locator(".dk-plan").hover(position={"x": 300, "y": 60})
    assert new_page.wait(lambda: "largest so far" in deck.locator(".dk-panel").inner_text())
    assert page.evaluate("document.documentElement.scrollWidth") <= page.viewport_size["width"]


def test_section_enters_the_water_by_every_theory(new_page):
    new_page.open_tab("Section")
    page = new_page.page
    page.wait_for_function("document.querySelector('.sec')?.dataset.drawn > 0", timeout=30000)
    row = page.locator(".sec tr[data-theory=similarity]")
    assert new_page.wait(lambda: row.locator("td").count() == 6)
    assert row.locator("td").first.inner_text() == "17.7"
    picture = page.evaluate("document.querySelector('.sec-main').toDataURL()")
    page.locator(".sec-main").focus()
    page.keyboard.press("Home")
    assert new_page.wait(
        lambda: (
            page.evaluate("document.querySelector('.sec-main').toDataURL()") != picture
            and "7.8 ms after" in page.locator(".sec-instant").inner_text()
        )
    )
    page.locator("#wb-section_kind").select_option("parabola")
    assert new_page.wait(lambda: "wedges only" in row.inner_text())
    assert "Parabola of 5 m radius" in page.locator(".sec-title").inner_text()
    type_in(page, "section_velocity", "0")
    problem = page.locator("[data-name=section_velocity] .wb-problem")
    assert new_page.wait(lambda: "must be a finite number > 0" in problem.inner_text())
    type_in(page, "section_velocity", "2")
    assert new_page.wait(lambda: problem.inner_text() == "")
    page.locator("#wb-section_kind").select_option("wedge")
    assert new_page.errors == []
    assert new_page.outside == []
    new_page.open_tab("Slamming")


def test_points_of_a_section_are_loaded_from_a_file(new_page, tmp_path):
    new_page.open_tab("Section")
    page = new_page.page
    page.locator("#wb-section_kind").select_option("points")
    own = tmp_path / "own.csv"
    own.write_text("y,z\n0,0\n1,0.2\n2,1\n")
    page.locator("[data-name=section_points] input[type=file]").set_input_files(own)
    assert new_page.wait(lambda: "Section of 3 points" in page.locator(".sec-title").inner_text())
    page.locator("#wb-section_kind").select_option("wedge")
    new_page.open_tab("Slamming")


@pytest.mark.parametrize("title", ["Motions", "Pressure", "Design"])
def test_each_tab_shows_its_figures(new_page, title):
    new_page.open_tab(title)
    assert new_page.wait(
        lambda: new_page.page.evaluate(
            "[...document.querySelectorAll('.wb-picture')].filter(p => p.offsetParent).every(p => "
            "p.querySelector('img').naturalWidth > 0 && !p.closest('.wb-is-old'))"
            " && [...document.querySelectorAll('.wb-picture')].some(p => p.offsetParent)"
        )
    )
    assert new_page.errors == []


@pytest.mark.parametrize(
    ("label", "ending", "start"),
    [
        ("Design (TOML)", ".toml", b"name ="),
        ("Slamming (CSV)", "-slamming.csv", b"# workbench"),
        ("Motions (netCDF)", "-motions.nc", b"\x89HDF"),
    ],
)
def test_files_are_saved(new_page, label, ending, start):
    new_page.open_tab("Data")
    new_page.wait_until_idle()
    with new_page.page.expect_download(timeout=40000) as download:
        new_page.page.get_by_role("button", name=label).click()
    assert download.value.suggested_filename.endswith(ending)
    with open(download.value.path(), "rb") as stream:
        assert stream.read(20).startswith(start)


def test_figure_is_saved_as_svg(new_page):
    new_page.open_tab("Slamming")
    with new_page.page.expect_download(timeout=40000) as download:
        new_page.page.get_by_role("button", name="Save as SVG: Where the deck slams").click()
    with open(download.value.path()) as stream:
        assert "<svg" in stream.read(600)


def test_design_file_is_loaded_and_a_broken_one_is_explained(new_page, tmp_path):
    page = new_page.page
    broken, own = tmp_path / "broken.toml", tmp_path / "own.toml"
    broken.write_text("name = [")
    own.write_text(design_to_toml(replace(library.design("austal-63"), title="Ferry of my own")))
    chooser = page.locator("input[type=file][aria-label='Design file']")
    chooser.set_input_files(broken)
    problem = page.locator("#wb-design-problem")
    assert new_page.wait(lambda: "must be valid TOML" in problem.inner_text())
    chooser.set_input_files(own)
    assert new_page.wait(lambda: problem.inner_text() == "")
    assert new_page.wait(lambda: "Ferry of my own" in page.locator("#wb-design option:checked").inner_text())
    assert new_page.wait(lambda: page.locator(".wb-figure.wb-is-old").count() == 0)
    page.locator("#wb-design").select_option("austal-63")


def test_permalink_opens_the_same_inputs_and_two_pages_do_not_mix(new_page, open_page):
    other = open_page("?design=austal-63&clearance=3.9&heading_degrees=150&law=nonsense")
    assert other.page.locator("[data-name=clearance] .wb-box").input_value() == "3.9"
    assert other.wait(lambda: "bow seas" in other.verdict)
    assert other.wait(lambda: "law" in other.page.locator(".wb-task").inner_text())
    assert "clearance=3.9" in other.page.url
    assert new_page.page.locator("[data-name=clearance] .wb-box").input_value() != "3.9"
    other.page.close()


def test_reload_keeps_a_changed_design_and_a_killed_kernel_says_so(open_page):
    one = open_page()
    page = one.page
    page.locator("summary", has_text="More of the wet deck").click()
    type_in(page, "camber", "0.4")
    type_in(page, "clearance", "3.3")
    assert one.wait(lambda: "clearance=3.3" in page.url)
    page.wait_for_timeout(500)
    os.kill(one.kernel_process(), signal.SIGKILL)
    banner = page.get_by_role("button", name="Reload with the same inputs")
    banner.wait_for(state="visible", timeout=30000)
    banner.click()
    page.wait_for_timeout(1000)
    one.wait_for_figures()
    assert one.wait(lambda: page.locator("[data-name=clearance] .wb-box").input_value() == "3.3")
    assert page.locator("[data-name=camber] .wb-box").input_value() == "0.4"
    page.close()


def test_shared_page_stayed_clean(new_page):
    assert new_page.outside == []
    assert new_page.errors == []
