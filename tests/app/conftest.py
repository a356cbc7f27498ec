"""A Voila server, a browser, and a page as a new reader sees it; closed with their module: pages go on playing."""

import contextlib
import os
import signal
import subprocess
import sys
import time
import urllib.request
from dataclasses import dataclass, field
from pathlib import Path

import pytest

CHROMIUM = Path("/usr/bin/chromium")
FLAGS = [
    "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--no-first-run", "--no-default-browser-check", "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync", "--disable-default-apps", "--disable-extensions", "--mute-audio",
    "--disable-domain-reliability",
    "--disable-client-side-phishing-detection",
]  # fmt: skip
HARMLESS = ("Unsatisfied version", "No satisfying version")  # notices of Voila's own JupyterLab


@dataclass
class Watched:
    """A page with everything it asked for and complained of."""

    page: object
    seconds_to_figures: float
    outside: list = field(default_factory=list)
    errors: list = field(default_factory=list)

    def texts(self, selector):
        return self.page.locator(selector).all_inner_texts()

    @property
    def verdict(self):
        return self.page.locator(".wb-verdict p").inner_text()

    def revision(self, name):
        """How often the picture of a figure has been replaced."""
        picture = self.page.locator(f".wb-figure:has(#wb-figure-{name}) img")
        return int(picture.get_attribute("data-revision"))

    def open_tab(self, title):
        self.page.locator(".wb-tabs .lm-TabBar-tab", has_text=title).click()

    def wait_for_figures(self, count=2, timeout=120):
        self.page.wait_for_function(
            "n => [...document.querySelectorAll('.wb-picture img')].filter(i => i.naturalWidth > "
            "0).length >= n",
            arg=count, timeout=1000 * timeout,
        )  # fmt: skip

    def wait_until_idle(self):
        assert self.wait(lambda: self.page.locator(".wb-progress").is_hidden(), 60)

    def kernel_process(self):
        """Number of the process that is the kernel of this page."""
        script = "JSON.parse(document.getElementById('jupyter-config-data').textContent).kernelId"
        kernel = self.page.evaluate(script)
        for folder in Path("/proc").iterdir():
            if folder.name.isdigit() and folder.name != str(os.getpid()):
                with contextlib.suppress(OSError):
                    if f"{kernel}.json" in (folder / "cmdline").read_text():
                        return int(folder.name)
        raise LookupError(kernel)

    def wait(self, condition, timeout=20.0):
        """Wait until a Python condition holds."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            if condition():
                return True
            self.page.wait_for_timeout(40)
        return False


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    from workbench.app import server as settings

    port = settings.free_port(0)
    log = tmp_path_factory.mktemp("voila") / "voila.log"
    command = [sys.executable, "-m", "voila", *settings.voila_arguments(port, False, pool_size=2)]
    with log.open("w") as stream:
        process = subprocess.Popen(command, env=settings.environment(), stdout=stream, stderr=stream)
    try:
        end = time.monotonic() + 60
        while "is filled" not in log.read_text() and time.monotonic() < end:
            assert process.poll() is None, log.read_text()
            time.sleep(0.2)
        with contextlib.suppress(OSError):
            urllib.request.urlopen(f"http://127.0.0.1:{port}/voila/static/none", timeout=2)
        yield f"http://127.0.0.1:{port}/"
    finally:
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(15)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait(5)


@pytest.fixture(scope="module")
def browser(playwright_driver):
    if not CHROMIUM.exists():
        pytest.skip("needs Debian's chromium")
    opened = playwright_driver.chromium.launch(executable_path=str(CHROMIUM), args=FLAGS)
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def open_page(server, browser):
    def opened(query="", context=None):
        size = {"width": 1280, "height": 800}
        context = context or browser.new_context(viewport=size, accept_downloads=True)
        page = context.new_page()
        watched = Watched(page, 0.0)

        def asked(request):
            if not request.url.startswith((server, "data:", "blob:", server.replace("http", "ws"))):
                watched.outside.append(request.url)

        def said(message):
            if message.type == "error" and not any(words in message.text for words in HARMLESS):
                watched.errors.append(message.text)

        page.on("request", asked)
        page.on("websocket", asked)
        page.on("console", said)
        page.on("pageerror", lambda error: watched.errors.append(str(error)))
        start = time.monotonic()
        page.goto(server + query, wait_until="commit")
        watched.wait_for_figures()
        watched.seconds_to_figures = time.monotonic() - start
        return watched

    return opened


@pytest.fixture(scope="module")
def new_page(open_page):
    """A page shared by the tests that leave it usable; of few hours, so that its slams are soon computed."""
    return open_page("?hours=0.2")
