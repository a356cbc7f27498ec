"""Ships with their linear response, by each method that gives one."""

import numpy as np
import pytest

from workbench import designs, pipeline
from workbench.conventions import GRAVITY
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.simulation.records import ShipInWaves

FROUDE_NUMBER = 0.3
HEADINGS = np.radians([90.0, 150.0, 180.0])


SETTINGS = {
    "potential-flow": PotentialFlowSettings(),
    "strip": StripSettings(),
    "high-speed": HighSpeedSettings(),
}


def respond(method: str, design, speed: float, directions) -> ShipInWaves:
    """Linear response of a design by one method."""
    found = pipeline.response(design, speed, directions, None, SETTINGS[method])
    return ShipInWaves(design, found.hydrodynamics, found.motions, found.wave_field, found.additions)


METHODS = tuple(SETTINGS)


@pytest.fixture(scope="session")
def responses() -> dict[str, ShipInWaves]:
    """The 3 m Delft 372 catamaran at Fn 0.3 by each method, as they are asked for."""
    return {}


def delft(method: str, responses: dict[str, ShipInWaves]) -> ShipInWaves:
    if method not in responses:
        design = designs.named_design("delft-372")
        speed = FROUDE_NUMBER * float(np.sqrt(GRAVITY * design.hull.length))
        responses[method] = respond(method, design, speed, HEADINGS)
    return responses[method]


@pytest.fixture(scope="session")
def ship(responses) -> ShipInWaves:
    return delft("potential-flow", responses)


@pytest.fixture(scope="session", params=METHODS)
def any_ship(request, responses) -> ShipInWaves:
    return delft(request.param, responses)
