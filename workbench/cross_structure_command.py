"""Command of Chuang's prediction for a cross structure: ``workbench cross-structure``."""

import json
from typing import Annotated

import numpy as np
import typer

from workbench import designs, pipeline
from workbench.command_inputs import (
    DesignArgument,
    FroudeOption,
    JsonOption,
    MethodOption,
    SpeedOption,
    speed_of,
    theory_of,
)
from workbench.cross_structure import cross_structure
from workbench.cross_structure_report import report_text, report_values
from workbench.hydrodynamics.settings import PotentialFlowSettings


def slam(
    design: DesignArgument,
    wave_height: Annotated[float, typer.Option(help="From trough to crest [m].")],
    wave_period: Annotated[float, typer.Option(help="Period of the wave [s].")],
    speed_knots: SpeedOption = None,
    froude: FroudeOption = None,
    method: MethodOption = "recommended",
    as_json: JsonOption = False,
) -> None:
    """Print Chuang's prediction of a slam on the cross structure in a regular head wave, and its design load."""
    ship = designs.design(design)
    speed = speed_of(ship, speed_knots, froude)
    response = pipeline.response(ship, speed, [np.pi], settings=theory_of(method, PotentialFlowSettings()))
    found = cross_structure(response, wave_period, wave_height)
    if as_json:
        print(json.dumps(report_values(found), allow_nan=False))
        return
    print(report_text(found))
