"""Measured heave and pitch of ships of the library, for the conditions in which there are any.

.. [Veer1998] R. van 't Veer, "Experimental results of motions, hydrodynamic coefficients and
    wave loads on the 372 catamaran model", Delft University of Technology, reports 1129
    and 1130, 1998.
"""

import numpy as np
import xarray as xr

from workbench.conventions import froude_number
from workbench.design import Design
from workbench.theory_comparison import measured_series
from workbench.verification import delft, published

FROUDE_NUMBERS = (0.30, 0.75)
SAME_FROUDE, SAME_HEADING = 0.01, np.radians(1.0)
"""How near a condition must be to a measured one."""
TANK, BASIN = "veer_1998_head_sea_motions", "veer_1998_basin_motions"
BASIN_HEADINGS = (180, 195)


def measured_motions(design: Design, speed: float, wave_direction: float) -> tuple[xr.Dataset, ...]:
    """Measured series of a design within 0.01 of the Froude number and 1 degree of the heading.

    Of the library that is the Delft 372 catamaran at Fn 0.30 and 0.75, in head seas and 15 degrees off
    them, either side [Veer1998]_. The masses of the design do not count: towing tank and basin tested two.
    """
    if design.hull != delft.model().hull:
        return ()
    froude = froude_number(speed, design.hull.length)
    near = [one for one in FROUDE_NUMBERS if abs(one - froude) <= SAME_FROUDE]
    if not near:
        return ()
    found = [_tank(near[0])] if _is_near(wave_direction, np.pi) else []
    for heading in BASIN_HEADINGS:
        if any(_is_near(wave_direction, side * np.radians(heading)) for side in (1, -1)):
            found.append(_basin(near[0], heading))
    return tuple(found)


def _is_near(one: float, other: float) -> bool:
    return abs(np.angle(np.exp(1j * (one - other)))) <= SAME_HEADING * (1 + 1e-9)


def _tank(froude: float) -> xr.Dataset:
    """Return the series of the towing tank."""
    table = published.columns(TANK, froude_number=froude)
    return measured_series(
        f"towing tank, Fn {froude:.2f}",
        table["wavelength_over_length"],
        np.stack([table["heave"], table["pitch"]], axis=1),
        np.radians(np.stack([table["heave_lead_deg"], table["pitch_lead_deg"]], axis=1)),
        published.citation(TANK),
    )


def _basin(froude: float, heading: int) -> xr.Dataset:
    """Return the series of the free-sailing model."""
    table = published.columns(BASIN, froude_number=froude, heading_deg=heading)
    ratios = table["wavelength_over_length"]
    wavenumber = 2 * np.pi / (ratios * delft.LENGTH)
    pitch = np.radians(table["pitch_deg_per_cm"]) * 100 / wavenumber
    return measured_series(
        f"basin, Fn {froude:.2f}, {heading} deg",
        ratios,
        np.stack([table["heave"], pitch], axis=1),
        np.radians(np.stack([table["heave_lead_deg"], table["pitch_deg_per_cm_lead_deg"]], axis=1)),
        published.citation(BASIN),
    )
