"""Times of the app in a real browser: opening, a slider, the animation."""

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.app.conftest import CHROMIUM, FLAGS
from workbench.app import server

FIGURES = "n => [...document.querySelectorAll('.wb-picture img')].filter(i => i.naturalWidth > 0).length >= n"


@contextmanager
def warm_server() -> Iterator[str]:
    """A Voila server with warm kernels; gives its address."""
    port = server.free_port(0)
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "voila.log"
        with log.open("w") as stream:
            process = subprocess.Popen(
                [sys.executable, "-m", "voila", *server.voila_arguments(port, False)],
                env=server.environment(), stdout=stream, stderr=stream,
            )  # fmt: skip
        try:
            end = time.monotonic() + 90
            while "is filled" not in log.read_text() and time.monotonic() < end:
                time.sleep(0.2)
            time.sleep(8)  # the pool's kernels have run the notebook's imports
            yield f"http://127.0.0.1:{port}/"
        finally:
            process.terminate()
            process.wait(20)


def page() -> list[tuple[str, str, str]]:
    """From opening the page to its first figures, from a slider to a changed figure, frames a second."""
    from playwright.sync_api import sync_playwright

    if not CHROMIUM.exists():
        return [("app in a browser", "not measured: no Chromium", "")]
    opening, sliding, rates = [], [], []
    with warm_server() as address, sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=str(CHROMIUM), args=FLAGS)
        for _ in range(3):
            context = browser.new_context(viewport={"width": 1280, "height": 800})
            tab = context.new_page()
            start = time.perf_counter()
            tab.goto(address, wait_until="commit")
            tab.wait_for_function(FIGURES, arg=2, timeout=90_000)
            opening.append(time.perf_counter() - start)
            tab.wait_for_timeout(8000)
            picture = ".wb-figure:has(#wb-figure-slams-on-deck) img"
            for value in ("3.0", "3.4", "2.8"):
                before = tab.locator(picture).get_attribute("data-revision")
                start = time.perf_counter()
                tab.locator("[data-name=clearance] .wb-slider").evaluate(
                    "(slider, value) => { slider.value = value; "
                    "slider.dispatchEvent(new Event('input', { bubbles: true })); }",
                    value,
                )
                tab.wait_for_function(
                    "([where, before]) => document.querySelector(where).dataset.revision !== before",
                    arg=[".wb-figure:has(#wb-figure-slams-on-deck) img", before],
                    polling=20,
                )
                sliding.append(time.perf_counter() - start)
                tab.wait_for_timeout(6000)
            tab.set_viewport_size({"width": 1340, "height": 800})
            tab.locator(".wb-tabs .lm-TabBar-tab", has_text="3-D").click()
            tab.wait_for_function("window.__sv && window.__sv.frames > 5", timeout=60_000)
            tab.wait_for_timeout(3000)
            first, start = tab.evaluate("window.__sv.frames"), time.perf_counter()
            tab.wait_for_timeout(5000)
            rates.append((tab.evaluate("window.__sv.frames") - first) / (time.perf_counter() - start))
            size = tab.evaluate(
                "(() => { const c = document.querySelector('canvas').getBoundingClientRect();"
                " return `${Math.round(c.width)} x ${Math.round(c.height)}` })()"
            )
            context.close()
        browser.close()
    return [
        ("app: opening to first figures, warm server", f"{statistics.median(opening):.1f} s", "at most 10 s"),
        (
            "app: slider to changed figure in the browser",
            f"{statistics.median(sliding):.2f} s",
            "at most 0.5 s",
        ),
        (
            f"app: animation, software rendering, canvas {size}",
            f"{statistics.median(rates):.0f} frames/s",
            "at least 20",
        ),
    ]
