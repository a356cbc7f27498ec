"""Shared fixtures: a private result store and small ships."""

import os
import tempfile
import warnings

os.environ.setdefault("OMP_NUM_THREADS", "2")
os.environ.setdefault("WORKBENCH_CACHE_DIR", tempfile.mkdtemp(prefix="workbench-tests-"))

import numpy as np
import pytest

from workbench.design import Design, Hull, MassProperties, WetDeck
from workbench.geometry.hydrostatics import hydrostatics
from workbench.shapes import Wigley

VERDICTS = pytest.StashKey[dict]()
"""Verdicts of the verification cases by id, where the notebook that runs them all was run in this session."""


def wigley_twin(spacing: float = 10.0, **deck) -> Design:
    """A 40 m twin of Wigley hulls that floats level, with a plain wet deck."""
    hull = Hull(shape=Wigley(length=40.0, beam=4.0, draught=2.0, depth=4.0), count=2, spacing=spacing)
    displacement = float(hydrostatics(hull, 1025.0).displacement)
    return Design(
        name="wigley-twin",
        hull=hull,
        wet_deck=WetDeck(**{"aft": -15.0, "fore": 15.0, "width": spacing - 4.0, "clearance": 1.5, **deck}),
        masses=MassProperties(
            mass=displacement,
            centre_of_gravity=(0.0, 0.0, 1.0),
            roll_gyradius=4.5,
            pitch_gyradius=10.0,
            yaw_gyradius=10.5,
        ),
    )


@pytest.fixture(scope="session")
def twin() -> Design:
    return wigley_twin()


@pytest.fixture(scope="session")
def playwright_driver():
    """Playwright, started once: it runs an event loop of its own, and a process can hold one."""
    sync_api = pytest.importorskip("playwright.sync_api")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResourceWarning)
        with sync_api.sync_playwright() as driver:
            yield driver


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1964)
