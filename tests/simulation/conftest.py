"""Ships with their linear response, by each method that gives one."""

import numpy as np
import pytest

from workbench import designs, pipeline
from workbench.simulation.records import ShipInWaves

FROUDE_NUMBER = 0.3
HEADINGS = np.radians([90.0, 150.0, 180.0])


def respond(method: str, design, speed: float, directions, omega=None):
    """Response of a design by one method."""
    return pipeline.response(design, speed, directions, omega)


METHODS = ("potential-flow",)


@pytest.fixture(scope="session", params=METHODS)
def ship(request) -> ShipInWaves:
    """The 3 m Delft 372 catamaran at Fn 0.3."""
    design = designs.named_design("delft-372")
    speed = FROUDE_NUMBER * float(np.sqrt(9.80665 * design.hull.length))
    found = respond(request.param, design, speed, HEADINGS)
    return ShipInWaves(design, found.hydrodynamics, found.motions, found.wave_field)
