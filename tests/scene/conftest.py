"""A headless Chromium with software WebGL, and scenes to draw."""

import shutil

import pytest
from scenes import demo_scene

from workbench.scene.stills import rendering_obstacle

FLAGS = (
    "--headless=new",
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-extensions",
    "--disable-sync",
    "--no-first-run",
    "--mute-audio",
)


def chromium_path() -> str | None:
    """Path of the system's Chromium, or None."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


@pytest.fixture(scope="module")
def chromium(playwright_driver):
    if chromium_path() is None:
        pytest.skip("needs Chromium")
    browser = playwright_driver.chromium.launch(executable_path=chromium_path(), args=list(FLAGS))
    yield browser
    browser.close()


@pytest.fixture(scope="session")
def short_scene():
    return demo_scene(duration=15.0)


@pytest.fixture(scope="session")
def film_scene():
    return demo_scene(duration=15.0, film=True, grid=(60, 40))


@pytest.fixture
def painter():
    obstacle = rendering_obstacle()
    if obstacle:
        pytest.skip(obstacle)
