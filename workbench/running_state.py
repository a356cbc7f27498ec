"""How a ship runs, and what acts on it beside its hulls in potential flow."""

from dataclasses import dataclass, replace

import numpy as np

from workbench.damping.lifting_surfaces import LiftSettings
from workbench.damping.sail_damping import SailDampingSettings
from workbench.design import Hull
from workbench.errors import checked_number
from workbench.sails import TrueWind


@dataclass(frozen=True, kw_only=True)
class RunningState:
    """Attitude at speed, sails, appendages, held modes and drag. All off by default.

    Parameters
    ----------
    running_trim : [rad], positive bow down, and running_sinkage : of the centre of gravity [m], positive
        down: measured or estimated attitude at speed, beyond that of the hull at rest.
    wind : for the damping of the sails; sails, lift : choices for sails and appendages.
    locked : modes held at zero at the centre of gravity.
    drag_coefficients : of cross-flow over the hulls, vertical and lateral [-], linearised for waves of
        drag_wave_amplitude [m].
    """

    running_trim: float = 0.0
    running_sinkage: float = 0.0
    wind: TrueWind | None = None
    sails: SailDampingSettings | None = None
    lift: LiftSettings | None = None
    locked: tuple[str, ...] = ()
    drag_coefficients: tuple[float, float] | None = None
    drag_wave_amplitude: float | None = None

    def __post_init__(self):
        checked_number("running trim", self.running_trim, "rad", at_least=-0.2, at_most=0.2)
        checked_number("running sinkage", self.running_sinkage, "m", at_least=-20, at_most=20)

    def running_hull(self, hull: Hull, centre_x: float) -> Hull:
        """Hull in its attitude at speed."""
        if self.running_trim == 0.0 and self.running_sinkage == 0.0:
            return hull
        trim = hull.trim + self.running_trim
        return replace(
            hull,
            trim=trim,
            sinkage=hull.sinkage + self.running_sinkage - centre_x * (np.tan(trim) - np.tan(hull.trim)),
        )
