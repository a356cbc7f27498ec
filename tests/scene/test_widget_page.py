"""The module for notebooks, driven by a stand-in for the kernel's model."""

import base64
import itertools
import json

import pytest

from workbench.scene.packing import packed_scene
from workbench.scene.sea_view import BUNDLE

pytestmark = pytest.mark.browser

MODEL = """
async ([code, scene, blocks]) => {
  const bytes = (text) => new DataView(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
  const state = {
    scene, time: 0, playing: true, field: 'pressure', camera: 'quarter', height: 460, status: '', revision: 1,
  };
  for (const [name, text] of Object.entries(blocks)) state[name] = bytes(text);
  const listeners = {};
  window.saved = [];
  window.emit = (event) => (listeners[event] ?? []).forEach((listener) => listener());
  window.kernelSets = (changes) => {
    Object.assign(state, changes);
    Object.keys(changes).forEach((name) => emit('change:' + name));
  };
  window.modelState = state;
  const model = {
    get: (name) => state[name],
    set(name, value) {
      state[name] = value;
      window.saved.push([name, value, performance.now()]);
      emit('change:' + name);
    },
    save_changes() {},
    on: (event, listener) => (listeners[event] ??= []).push(listener),
    off: (event, listener) => (listeners[event] = listeners[event].filter((one) => one !== listener)),
  };
  const url = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  const module = await import(url);
  const el = document.createElement('div');
  document.body.append(el);
  window.cleanUp = module.default.render({ model, el });
  window.listenerCount = () => Object.values(listeners).flat().length;
}
"""


@pytest.fixture
def widget(chromium, short_scene):
    page = chromium.new_page(viewport={"width": 940, "height": 560})
    page.complaints = []
    page.on("pageerror", lambda error: page.complaints.append(str(error)))
    blocks = packed_scene(short_scene)
    facts = blocks.pop("scene")
    encoded = {name: base64.b64encode(block).decode() for name, block in blocks.items()}
    page.evaluate(MODEL, [BUNDLE.read_text(encoding="utf-8"), json.loads(json.dumps(facts)), encoded])
    page.wait_for_function("window.__sv.frames > 2")
    yield page
    assert page.complaints == []
    page.close()


def test_time_is_reported_at_most_twice_a_second(widget):
    assert widget.evaluate("modelState.status") == "ready-software"
    widget.wait_for_timeout(1600)
    times = [when for name, _, when in widget.evaluate("saved") if name == "time"]
    assert 2 <= len(times) <= 5
    assert min(later - earlier for earlier, later in itertools.pairwise(times)) >= 480


def test_kernel_sets_time_field_and_camera(widget):
    widget.evaluate("kernelSets({ playing: false })")
    widget.wait_for_function("!window.__sv.playing")
    widget.evaluate("kernelSets({ time: 7.5, field: 'clearance_left', camera: 'under' })")
    widget.wait_for_function("window.__sv.time === 7.5")
    assert widget.locator(".sv-bar-label").inner_text() == "Clearance left [m]"
    assert widget.get_by_role("button", name="Under the deck").get_attribute("aria-pressed") == "true"


def test_new_scene_is_read_in_place(widget):
    widget.evaluate(
        """() => kernelSets({ scene: { ...modelState.scene, title: 'Another ship', count: 50 },
                             revision: modelState.revision + 1 })"""
    )
    widget.wait_for_function("document.querySelector('.sv-title').textContent === 'Another ship'")
    assert widget.locator(".sv-canvas").count() == 1
    assert float(widget.get_by_label("Time", exact=True).get_attribute("max")) == pytest.approx(4.9)


def test_stopped_kernel_is_announced(widget):
    banner = widget.get_by_role("alert")
    assert not banner.is_visible()
    widget.evaluate("emit('comm_live_update')")
    assert "The calculation engine has stopped" in banner.inner_text()
    assert widget.get_by_role("button", name="Reload the page").is_visible()


def test_disposal_leaves_nothing_behind(widget):
    widget.evaluate("cleanUp()")
    assert widget.evaluate("[listenerCount(), document.querySelectorAll('canvas').length]") == [0, 0]
    assert widget.evaluate("window.__sv === undefined")
