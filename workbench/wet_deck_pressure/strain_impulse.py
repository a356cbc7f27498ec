"""Impulse of a slam from a strain record, and from a model test.

.. [Amin] W. Amin, M. R. Davis, G. A. Thomas and D. S. Holloway, "Slamming quasi-static analysis of an Incat
    98-m high-speed wave piercing catamaran", University of Tasmania and Australian Maritime College, undated,
    section 7.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.wet_deck_pressure.load_distribution import QUASI_STATIC

PLACE_ERROR = 0.6
"""Doubt about the place of the load: half a frame of 1.2 m [m]."""

LEAST_LEVER = 10.0
"""Levers shorter than this many times the doubt are warned of: the impulse is then 10 % or more in doubt [-]."""


def strain_integral(strain, time_step: float = 0.01) -> float:
    """Integral of a strain record over the slam by the trapezium rule [s].

    Parameters
    ----------
    strain : evenly spaced, from the start to the end of the slam [-], not in microstrain; time_step :
        [s], 0.01 s in the source.
    """
    strain = np.asarray(strain, float)
    checked_number("time_step", time_step, "s", above=0)
    if strain.ndim != 1 or len(strain) < 2 or not np.all(np.isfinite(strain)):
        raise InputError("a strain record must be two or more finite values in a row.")
    if np.abs(strain).max() > 0.05:
        raise InputError(
            f"a strain must be below 0.05, got {np.abs(strain).max():g}; give strains, not microstrains."
        )
    return float(np.trapezoid(strain, dx=time_step))


def strain_impulse(integral: float, section_stiffness: float, lever: float) -> xr.Dataset:
    """Impulse of a slam from the strain that it makes at a gauge, EZ/x times the integral [N s] ([Amin]_ eq. 3).

    Parameters
    ----------
    integral : of the strain over the slam, from `strain_integral` [s].
    section_stiffness : modulus of elasticity times section modulus at the gauge, EZ [N m].
    lever : distance of the load's resultant forward of the gauge, x [m].

    Returns
    -------
    Dataset with ``slam_impulse`` [N s]; sentences where the lever makes it doubtful are in its ``warnings``.

    Notes
    -----
    Quasi-static: waves, added mass, inertia and weight are left out, so that the bending moment at the gauge
    is load times lever.
    """
    checked_number("integral of the strain", integral, "s")
    checked_number("section stiffness", section_stiffness, "N m", above=0)
    lever = checked_number("lever of the slam", lever, "m")
    if lever == 0:
        raise InputError(
            "lever of the slam must not be 0 m; take a gauge that is not at the place of the load."
        )
    notes = ()
    if lever < 0:
        notes = (
            f"The load lies {-lever:.3g} m aft of the gauge: the moment of a load forward of the gauge is "
            "assumed, so this impulse means nothing; take a gauge farther aft.",
        )
    elif lever < LEAST_LEVER * PLACE_ERROR:
        notes = (
            f"The lever of {lever:.3g} m is short: half a frame more or less changes the impulse by "
            f"{100 * PLACE_ERROR / lever:.0f} %; take a gauge farther aft.",
        )
    return quantities.dataset(
        method="quasi-static impulse from strain",
        warnings=[*notes, QUASI_STATIC],
        attrs={"lever": lever},
        slam_impulse=((), section_stiffness * integral / lever),
    )


def effective_duration(impulse: float, load: float) -> float:
    """Impulse over load [s] ([Amin]_ section 7)."""
    return impulse / checked_number("slam load", load, "N", above=0)


def scaled_impulse(
    model_impulse: float, speed_ratio: float, length_ratio: float, density_ratio: float = 1.0
) -> float:
    """Impulse of the ship from that of a model, I V_s/V_m (L_s/L_m)**3 rho_s/rho_m [N s] ([Amin]_ eq. 4).

    Parameters
    ----------
    model_impulse : [N s]; speed_ratio, length_ratio : ship over model [-]; density_ratio : of the water,
        1 in the source, 1.025 from a tank of fresh water to the sea [-].
    """
    checked_number("speed ratio", speed_ratio, above=0)
    checked_number("length ratio", length_ratio, above=0)
    checked_number("density ratio", density_ratio, above=0)
    return model_impulse * speed_ratio * length_ratio**3 * density_ratio
