"""What a design brings to the equation of motion beside its hulls, gathered."""

import xarray as xr

from workbench.damping.lifting_surfaces import LiftSettings, foil_forces
from workbench.damping.sail_damping import SailDampingSettings, sail_damping
from workbench.design import Design
from workbench.errors import InputError
from workbench.sails import TrueWind


def additions(
    design: Design,
    hydrodynamics: xr.Dataset,
    *,
    wind: TrueWind | None = None,
    sails: SailDampingSettings | None = None,
    lift: LiftSettings | None = None,
) -> tuple[xr.Dataset, ...]:
    """Forces of the appendages, and of the sails in a wind, for the waves and speed of the hydrodynamics.

    Parameters
    ----------
    hydrodynamics : gives omega, wave directions, speed and density.
    wind : None leaves the sails out; a design without a sail plan is refused a wind.
    sails, lift : choices of the methods.

    Returns
    -------
    Datasets for the ``additions`` of `motions.motions`; none for a bare hull.
    """
    speed, density = hydrodynamics.attrs["speed"], hydrodynamics.attrs["density"]
    omega, directions = hydrodynamics.omega.values, hydrodynamics.wave_direction.values
    found = []
    if design.appendages:
        found.append(foil_forces(design.appendages, density, speed, omega, directions, lift))
    if wind is not None:
        if design.sail_plan is None:
            raise InputError(
                f"{design.name} has no sail plan for a wind to act on; add one or leave out the wind."
            )
        found.append(sail_damping(design.sail_plan, wind, speed, omega, directions, sails))
    return tuple(found)
