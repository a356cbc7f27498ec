"""The view of the deck in a browser, alone and under a film, driven by a stand-in for the kernel's model."""

import base64
import itertools
import json

import numpy as np
import pytest
from test_deck_view import history

from workbench.scene.deck_view import STATIC, deck_view
from workbench.scene.packing import packed_scene
from workbench.scene.sea_view import BUNDLE

pytestmark = pytest.mark.browser

SHOW = """
async ([name, code, css, state, blocks]) => {
  const bytes = (text) => new DataView(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
  for (const [one, text] of Object.entries(blocks)) state[one] = bytes(text);
  const listeners = {};
  const emit = (event) => (listeners[event] ?? []).forEach((listener) => listener());
  const model = {
    saved: [],
    get: (one) => state[one],
    set(one, value) { state[one] = value; model.saved.push([one, performance.now()]); emit('change:' + one); },
    save_changes() {},
    on: (event, listener) => (listeners[event] ??= []).push(listener),
    off: (event, listener) => (listeners[event] = listeners[event].filter((one) => one !== listener)),
    count: () => Object.values(listeners).flat().length,
  };
  const sheet = document.createElement('style');
  sheet.textContent = css;
  document.head.append(sheet);
  const module = await import(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
  const el = document.createElement('div');
  document.body.append(el);
  model.cleanUp = module.default.render({ model, el });
  window[name] = model;
}
"""
NAMES = ("facts", "revision", "time", "playing", "choices", "chosen", "notes", "link", "message", "old")


def put(page, name, module, state, blocks):
    css = (STATIC / "deck_view.css").read_text(encoding="utf-8")
    encoded = {one: base64.b64encode(block).decode() for one, block in blocks.items()}
    page.evaluate(
        SHOW, [name, module.read_text(encoding="utf-8"), css, json.loads(json.dumps(state)), encoded]
    )


def put_deck(page, view):
    state = {name: getattr(view, name) for name in NAMES}
    put(page, "deck", STATIC / "deck_view.js", state, {"pressure": view.pressure, "curves": view.curves})
    page.wait_for_function("document.querySelector('.dk').dataset.drawn > 0")


def opened(chromium, **options):
    page = chromium.new_page(viewport={"width": 940, "height": 900}, **options)
    page.complaints = []
    page.on("pageerror", lambda error: page.complaints.append(str(error)))
    return page


def test_panels_are_read_out_and_keys_move_in_time(chromium):
    page, view = opened(chromium), deck_view(history())
    put_deck(page, view)
    plan, status, panel = (page.locator(f".dk-{one}") for one in ("plan", "status", "panel"))
    given = history()
    now = given.deck_pressure.sel(time=view.time)
    largest = f"{float(now.max()) / 1e3:.0f} kPa"
    assert f"largest pressure {largest}" in status.inner_text()
    assert page.get_by_label("Time", exact=True).get_attribute("aria-valuetext") == status.inner_text()
    assert status.get_attribute("role") == "status"

    plan.focus()
    page.keyboard.press("ArrowRight")  # the hardest panel so far
    page.keyboard.press("ArrowUp")
    page.wait_for_function("document.querySelector('.dk-panel').textContent.startsWith('Panel')")
    so_far = given.deck_pressure.sel(time=slice(None, view.time)).max("time")
    i, j = np.unravel_index(int(so_far.values.argmax()), so_far.shape)
    words = (
        f"{float(now[i, j + 1]) / 1e3:.3g} kPa now, largest so far {float(so_far[i, j + 1]) / 1e3:.3g} kPa"
    )
    page.wait_for_function(
        "words => document.querySelector('.dk-panel').textContent.includes(words)", arg=words
    )
    assert f"x {float(given.x[i]):.1f}".rstrip("0").rstrip(".") in panel.inner_text()

    page.get_by_label("Time", exact=True).focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function("([time]) => Math.abs(deck.get('time') - time) < 1e-6", arg=[view.time + 0.0025])
    page.keyboard.press("End")
    page.wait_for_function(
        "document.querySelector('.dk-status').textContent.startsWith('0.499 s: the deck is dry')"
    )
    page.keyboard.press("Home")
    page.wait_for_function("document.querySelector('.dk-status').textContent.startsWith('0.001 s')")
    page.keyboard.press(" ")
    page.wait_for_timeout(1300)
    time = float(page.locator(".dk").get_attribute("data-time")) - 30
    assert 0.05 < time < 0.2  # ten times slower
    page.wait_for_timeout(600)
    reports = [when for name, when in page.evaluate("deck.saved.slice(-3)") if name == "time"]
    assert all(later - earlier > 480 for earlier, later in itertools.pairwise(reports))
    page.evaluate("deck.cleanUp()")
    assert page.evaluate("[deck.count(), document.querySelectorAll('.dk').length]") == [0, 0]
    assert page.complaints == []
    page.close()


def test_nothing_spills_and_colours_reach_where_they_are_told(chromium):
    page, view = opened(chromium), deck_view(history())
    view.choices, view.chosen = (
        [["rank", "Slam shown", [["1", "the hardest slam"], ["2", "number 2"]]]],
        {"rank": "1"},
    )
    put_deck(page, view)
    page.get_by_label("Slam shown").select_option("2")
    assert page.evaluate("deck.get('chosen')") == {"rank": "2"}
    for width in (560, 940, 1500):
        page.set_viewport_size({"width": width, "height": 900})
        page.wait_for_timeout(120)
        assert page.evaluate("document.documentElement.scrollWidth") <= width
    middle = """() => { const canvas = document.querySelector('.dk-plan'), c = canvas.getContext('2d');
        const seen = new Set(), { data } = c.getImageData(0, 0, canvas.width, canvas.height);
        for (let i = 0; i < data.length; i += 4) seen.add([data[i], data[i + 1], data[i + 2]].join());
        return [...seen].filter((one) => one === '246,221,63').length; }"""
    before = page.evaluate(middle)
    page.get_by_label("Pressure that the colours reach to").select_option("0.1")
    page.wait_for_timeout(120)
    assert page.evaluate(middle) >= before
    page.evaluate("deck.set('message', 'The deck stays dry.')")
    assert page.locator(".dk-message").inner_text() == "The deck stays dry."
    assert not page.locator(".dk-plan").is_visible()
    assert page.complaints == []
    page.close()


def test_deck_and_film_keep_the_same_time_without_the_kernel(chromium, short_scene):
    count = short_scene.sizes["time"]
    names = ("deck_force", "deck_force_x", "deck_force_y", "wetted_area")
    scene = short_scene.assign(dict.fromkeys(names, ("time", np.linspace(0, 1e6, count))))
    page, view = opened(chromium), deck_view(scene)
    view.link = "film-1"
    blocks = packed_scene(scene)
    facts = {"scene": blocks.pop("scene"), "time": 0, "playing": True, "field": "pressure", "camera": "quarter",
             "height": 420, "status": "", "revision": 1, "link": "film-1"}  # fmt: skip
    put(page, "sea", BUNDLE, facts, blocks)
    page.wait_for_function("window.__sv.frames > 2")
    put_deck(page, view)
    apart = "Math.abs(window.__sv.time - Number(document.querySelector('.dk').dataset.time))"
    for _ in range(2):
        page.wait_for_timeout(400)
        assert page.evaluate(apart) < 0.3
    assert page.locator(".dk-play").inner_text().endswith("Pause")
    page.locator(".dk-play").click()
    page.wait_for_function(
        "!window.__sv.playing && document.querySelector('.dk-play').textContent.endsWith('Play')"
    )
    page.locator(".dk-range").focus()
    page.keyboard.press("End")
    page.wait_for_function("window.__sv.time === 15")
    page.locator(".dk-plots").click(position={"x": 400, "y": 60})
    page.wait_for_function(f"window.__sv.time < 14 && window.__sv.time > 1 && {apart} < 1e-9")
    page.get_by_label("Ship in waves").focus()
    page.keyboard.press("Home")
    page.wait_for_function("document.querySelector('.dk').dataset.time === '0'")
    assert not any(name == "time" for name, _ in page.evaluate("deck.saved"))
    assert page.complaints == []
    page.close()
