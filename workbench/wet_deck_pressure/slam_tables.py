"""Slam loads as rows of the tables of [Amin]_, in their units: tonnes-force, per cent of the waterline, frames.

.. [Amin] W. Amin, M. R. Davis, G. A. Thomas and D. S. Holloway, "Slamming quasi-static analysis of an Incat
    98-m high-speed wave piercing catamaran", University of Tasmania and Australian Maritime College, undated,
    tables 3 and 4.
"""

import xarray as xr

from workbench.conventions import GRAVITY
from workbench.errors import checked_number
from workbench.wet_deck_pressure.load_distribution import Frames
from workbench.wet_deck_pressure.strain_impulse import effective_duration, strain_impulse

TONNE_FORCE = 1000 * GRAVITY
"""Weight of one tonne [N]."""


def load_row(forces: xr.Dataset, displacement: float, frames: Frames) -> dict[str, float]:
    """Row of table 3 of a slam load.

    Parameters
    ----------
    forces : from `workbench.wet_deck_pressure.load_distribution.nodal_forces` or ``deck_forces``.
    displacement : mass of the ship [kg]; frames : its frames.

    Returns
    -------
    ``load_tonne``, ``load_meganewton``, ``load_over_displacement``, ``location_percent`` of the waterline
    from the transom, ``location_from_transom`` [m], ``frame``.
    """
    checked_number("displacement", displacement, "kg", above=0)
    load, x = forces.attrs["total"], forces.attrs["resultant_x"]
    return {
        "load_tonne": load / TONNE_FORCE,
        "load_meganewton": load / 1e6,
        "load_over_displacement": load / (displacement * GRAVITY),
        "location_percent": 100 * float(frames.share_of_length(x)),
        "location_from_transom": float(frames.from_transom(frames.frame(x))),
        "frame": float(frames.frame(x)),
    }


def impulse_row(
    load: float, x: float, gauge_x: float, integral: float, section_stiffness: float, frames: Frames
) -> dict[str, float | str]:
    """Row of table 4 of a slam.

    Parameters
    ----------
    load : [N]; x, gauge_x : places of its resultant and of the gauge from amidships [m].
    integral : of the strain at the gauge over the slam [s]; section_stiffness : EZ there [N m].

    Returns
    -------
    ``load_tonne``, ``location_from_transom`` and ``distance`` from the gauge [m], ``strain_integral`` [s],
    ``impulse_tonne_s``, ``effective_duration`` [s], ``warnings``.
    """
    found = strain_impulse(integral, section_stiffness, x - gauge_x)
    impulse = float(found.slam_impulse)
    return {
        "load_tonne": load / TONNE_FORCE,
        "location_from_transom": float(frames.from_transom(frames.frame(x))),
        "distance": x - gauge_x,
        "strain_integral": integral,
        "impulse_tonne_s": impulse / TONNE_FORCE,
        "effective_duration": effective_duration(impulse, load),
        "warnings": found.attrs["warnings"],
    }
