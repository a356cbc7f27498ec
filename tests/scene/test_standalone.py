"""The page written for a file plays, tells its numbers and asks nobody for anything."""

import pytest

from workbench.scene.standalone import standalone_html

pytestmark = pytest.mark.browser


class Opened:
    """A page on a file, with everything it asked for and complained of."""

    def __init__(self, browser, path, size=(900, 500), **options):
        self.page = browser.new_page(viewport={"width": size[0], "height": size[1]}, **options)
        self.requests, self.complaints = [], []
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on(
            "console",
            lambda message: message.type in ("error", "warning") and self.complaints.append(message.text),
        )
        self.page.goto(path.as_uri())
        self.page.wait_for_function("window.__sv && window.__sv.frames > 2")

    def probe(self) -> dict:
        return self.page.evaluate("window.__sv")


@pytest.fixture(params=["components", "film"])
def opened(request, chromium, short_scene, film_scene, tmp_path):
    path = tmp_path / "scene.html"
    scene = short_scene if request.param == "components" else film_scene
    path.write_text(standalone_html(scene, "Ship <in> waves"), encoding="utf-8")
    opened = Opened(chromium, path)
    yield opened
    opened.page.close()


def differing_pixels(page) -> int:
    """Number of different colours along the middle of the picture."""
    return page.evaluate(
        """() => {
          const canvas = document.querySelector('.sv-canvas');
          return new Promise((done) => requestAnimationFrame(() => {
            const copy = document.createElement('canvas');
            copy.width = 200; copy.height = 120;
            const c = copy.getContext('2d');
            c.drawImage(canvas, 0, 0, 200, 120);
            const seen = new Set();
            const { data } = c.getImageData(0, 0, 200, 120);
            for (let i = 0; i < data.length; i += 4) {
              seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
            }
            done(seen.size);
          }));
        }"""
    )


def test_film_plays_without_any_request(opened):
    before = opened.probe()
    opened.page.wait_for_timeout(1500)
    after = opened.probe()
    assert after["frames"] - before["frames"] >= 8
    assert after["time"] - before["time"] == pytest.approx(1.5, abs=0.7)
    assert opened.page.title() == "Ship <in> waves"
    assert differing_pixels(opened.page) > 200
    assert [url for url in opened.requests if not url.startswith(("file:", "data:", "blob:"))] == []
    assert opened.complaints == []


def test_keys_and_buttons_drive_the_film(chromium, short_scene, tmp_path):
    path = tmp_path / "scene.html"
    path.write_text(standalone_html(short_scene), encoding="utf-8")
    opened = Opened(chromium, path)
    page = opened.page
    page.get_by_role("button", name="Pause").click()
    page.get_by_label("Ship in waves").focus()
    page.keyboard.press("End")
    page.wait_for_function("window.__sv.time === 15")
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    page.wait_for_function("Math.abs(window.__sv.time - 0.1) < 1e-9")
    page.get_by_role("button", name="Next slam").click()
    page.wait_for_function("window.__sv.time > 1")
    assert page.get_by_label("Time", exact=True).get_attribute("aria-valuetext").endswith("kPa)")
    for name in ("Bow", "Under the deck", "Side", "Quarter"):
        button = page.get_by_role("button", name=name)
        button.click()
        assert button.get_attribute("aria-pressed") == "true"
    page.get_by_label("Deck shows").select_option("pressure")
    assert page.locator(".sv-bar-label").inner_text() == "Impact pressure [kPa]"
    with page.expect_download() as download:
        page.get_by_role("button", name="Save picture").click()
    assert download.value.suggested_filename.endswith(".png")
    assert download.value.path().read_bytes()[:4] == b"\x89PNG"
    page.get_by_label("Ship in waves").focus()
    page.keyboard.press(" ")
    page.wait_for_function("window.__sv.playing")
    assert opened.complaints == []
    page.close()


def test_nothing_overlaps_or_spills_at_any_width(chromium, short_scene, tmp_path):
    path = tmp_path / "scene.html"
    path.write_text(standalone_html(short_scene), encoding="utf-8")
    opened = Opened(chromium, path)
    for size in ((900, 500), (1280, 800), (1800, 900)):
        opened.page.set_viewport_size({"width": size[0], "height": size[1]})
        opened.page.wait_for_timeout(150)
        boxes = opened.page.evaluate(
            """() => ['readout', 'bar', 'plan', 'strip', 'header', 'footer'].map((name) => {
                 const part = document.querySelector('.sv-' + name);
                 const { left, right, top, bottom } = part.getBoundingClientRect();
                 return [name, left, right, top, bottom];
               })"""
        )
        for k, (name, left, right, top, bottom) in enumerate(boxes):
            assert left >= 0
            assert right <= size[0]
            assert bottom <= size[1]
            for other, left2, right2, top2, bottom2 in boxes[k + 1 :]:
                apart = right <= left2 or right2 <= left or bottom <= top2 or bottom2 <= top
                assert apart, f"{name} overlaps {other} at {size}"
    opened.page.close()


def test_reader_who_wants_less_motion_starts_paused(chromium, short_scene, tmp_path):
    path = tmp_path / "scene.html"
    path.write_text(standalone_html(short_scene), encoding="utf-8")
    page = chromium.new_page(viewport={"width": 900, "height": 500}, reduced_motion="reduce")
    page.goto(path.as_uri())
    page.wait_for_function("window.__sv && window.__sv.frames > 0")
    page.wait_for_timeout(300)
    assert page.evaluate("window.__sv.time") == 0
    assert page.get_by_role("button", name="Play").is_visible()
    page.close()


def test_browser_without_webgl_says_so(chromium, short_scene, tmp_path):
    path = tmp_path / "scene.html"
    path.write_text(standalone_html(short_scene), encoding="utf-8")
    page = chromium.new_page(viewport={"width": 900, "height": 500})
    page.add_init_script(
        "const get = HTMLCanvasElement.prototype.getContext;"
        "HTMLCanvasElement.prototype.getContext = function (kind, ...more) {"
        "  return kind.startsWith('webgl') ? null : get.call(this, kind, ...more); };"
    )
    page.goto(path.as_uri())
    page.wait_for_function("window.__sv && window.__sv.frames > 2")
    assert "WebGL is switched off" in page.locator(".sv-message").inner_text()
    assert page.locator(".sv-strip canvas").is_visible()
    page.close()
