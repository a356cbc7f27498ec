"""The notebook of the app in JupyterLab, in a real browser, from a copy of the notebook."""

import contextlib
import os
import shutil
import signal
import subprocess
import sys
import time
import urllib.request

import pytest

from workbench.app import server

pytestmark = pytest.mark.browser


def answers(address):
    """Whether a server answers there."""
    with contextlib.suppress(OSError):
        return urllib.request.urlopen(address, timeout=2).status == 200
    return False


@pytest.fixture
def lab(tmp_path):
    """Address of a JupyterLab with the notebook in a folder of its own, and with settings of its own."""
    root = tmp_path / "notebooks"
    root.mkdir()
    shutil.copy(server.notebook_path(), root / server.NOTEBOOK)
    port = server.free_port(0)
    own = {
        name: str(tmp_path / name)
        for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR")
    }
    own["JUPYTERLAB_SETTINGS_DIR"] = str(tmp_path / "settings")
    own["JUPYTERLAB_WORKSPACES_DIR"] = str(tmp_path / "workspaces")
    command = [sys.executable, "-m", "jupyterlab", *server.lab_arguments(port, False, root)]
    command += ["--allow-root", "--IdentityProvider.token="]
    log = tmp_path / "lab.log"
    with log.open("w") as stream:
        process = subprocess.Popen(
            command,
            env={**server.lab_environment(), **own},
            stdout=stream,
            stderr=stream,
            start_new_session=True,
        )
    try:
        address = f"http://127.0.0.1:{port}"
        end = time.monotonic() + 60
        while not answers(f"{address}/api") and time.monotonic() < end:
            assert process.poll() is None, log.read_text()
            time.sleep(0.2)
        yield address
    finally:
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait(5)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGTERM)


def until(value, above, timeout=60):
    """Return a value once it is above a limit."""
    end = time.monotonic() + timeout
    while (found := value()) <= above:
        assert time.monotonic() < end, found
        time.sleep(0.1)
    return found


def test_page_works_in_jupyterlab_and_nothing_is_asked_or_fetched(lab, browser):
    context = browser.new_context(viewport={"width": 1600, "height": 1000})
    page = context.new_page()
    outside, errors = [], []

    def asked(request):
        inside = (lab, lab.replace("http", "ws"), "data:", "blob:")
        if not request.url.startswith(inside):
            outside.append(request.url)

    page.on("request", asked)
    page.on("websocket", asked)
    page.on("pageerror", lambda error: errors.append(str(error)))
    start = time.monotonic()
    page.goto(f"{lab}/lab/tree/{server.NOTEBOOK}", wait_until="commit")
    page.locator(".jp-Notebook .jp-Cell").first.wait_for(timeout=60_000)
    page.locator(".jp-NotebookPanel-toolbar [data-status=idle]").first.wait_for(timeout=60_000)
    opened = time.monotonic() - start
    page.locator(".lm-MenuBar-item", has_text="Run").click()
    page.locator(".lm-Menu-item[data-command='runmenu:run-all']").click()
    page.locator(".wb-verdict p", has_text="this deck slams").wait_for(timeout=60_000)
    judged = time.monotonic() - start
    page.locator(".wb-tabs .lm-TabBar-tab", has_text="3-D").click()
    frames = until(lambda: page.evaluate("window.__sv ? window.__sv.frames : 0"), above=3)
    until(lambda: page.evaluate("window.__sv.frames"), above=frames + 3)
    print(f"opened {opened:.1f} s, verdict {judged:.1f} s, moving {time.monotonic() - start:.1f} s")
    assert page.locator(".jp-Dialog").count() == 0
    assert page.locator(".Toastify__toast").count() == 0
    assert errors == []
    assert outside == []
    context.close()
