"""Motions of a sailing multihull: heeled, on two hulls or on one, with or without the damping of its sails.

[Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, Curtin University
    of Technology, 2002, 2.2 and 3.3.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import xarray as xr

from workbench.conventions import MODES
from workbench.damping.additions import additions
from workbench.damping.sail_damping import SailDampingSettings
from workbench.design import Design
from workbench.errors import InputError
from workbench.geometry.heeled import heeled
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.geometry.mesh import wet_hulls
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.hydrodynamics.strip_theory import hydrodynamics
from workbench.motions import motions
from workbench.sails import TrueWind

HORIZONTAL = ("surge", "sway", "yaw")


def sailing_design(design: Design, heel: float) -> Design:
    """Design at a heel [rad], risen or sunk to its displacement; hulls may fly."""
    return replace(design, hull=heeled(design.hull, design.masses.mass, design.density, heel))


def flies(design: Design) -> bool:
    """Whether all its weight is on one of several hulls, which leaves roll without a restoring moment of its own."""
    return design.hull.count > 1 and len(wet_hulls(design.hull)) == 1


def sailing_motions(
    design: Design,
    speed: float,
    omega: Sequence[float],
    wave_directions: Sequence[float],
    *,
    heel: float = 0.0,
    wind: TrueWind | None = None,
    sails: SailDampingSettings | None = None,
    settings: StripSettings | None = None,
) -> xr.Dataset:
    """Heave, roll and pitch per wave amplitude by strip theory, as `motions.motions` returns them.

    Parameters
    ----------
    speed : [m/s]; omega : [rad/s]; wave_directions : [rad].
    heel : [rad], positive starboard side down; the ship rises or sinks to its displacement.
    wind : for the damping of the sails; None leaves them out. sails : choices for it.
    settings : of strip theory; None takes the heave of single hulls, as the source.

    Notes
    -----
    Surge, sway and yaw are locked, and roll too on one hull of several: its response would
    mean nothing there ([Grande2002]_ 3.3.1). A hull that flies counts by its mass alone.
    """
    if not isinstance(design, Design):
        raise InputError(f"design must be a Design, got {design!r}; give one.")
    settings = settings or StripSettings(formulation="heave-only")
    afloat = sailing_design(design, heel)
    found = hydrodynamics(afloat.hull, design.density, np.asarray(omega), wave_directions, speed, settings)
    return motions(
        found,
        design.masses,
        stiffness_matrix(afloat.hull, design.masses, design.density),
        additions=additions(afloat, found, wind=wind, sails=sails),
        locked=(*HORIZONTAL, *(("roll",) if flies(afloat) else ())),
    )


def peak(motion_set: xr.Dataset, mode: str) -> float:
    """Largest amplitude of a mode over the frequencies of the first wave direction [m/m, rad/m]."""
    return float(np.abs(motion_set.motion_rao.values[:, 0, MODES.index(mode)]).max())
