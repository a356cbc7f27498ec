"""Many slams at once: predicted, compared with what was recorded, and one kind of bottom with another.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975.
"""

from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.stats import mannwhitneyu

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.impact import chuang
from workbench.impact.stavovy_chuang import PREDICTED

INPUTS = ("heave_velocity", "surface_velocity", "pitch_velocity", "attitude", "wave_slope")
"""What a table of slams must have; ``roll_angle`` and ``recorded_pressure`` may be there."""

MATCH = np.radians(0.5)
"""Usual difference of impact angle within which slams are compared [rad]."""


def predicted_slams(slams: xr.Dataset, density: float, small_angle_law: str = "program") -> xr.Dataset:
    """Add Chuang's Method I to a table of slams (event).

    Parameters
    ----------
    slams : with the `INPUTS` over event [m/s, rad], such as from
        `workbench.records.slam_reduction.reduced_slams`.
    density : [kg/m3].

    Returns
    -------
    The table with ``normal_velocity``, ``tangential_velocity``, ``impact_angle``, ``pressure_constant``,
    ``impact_pressure``, ``planing_pressure``, ``peak_pressure`` and, where a pressure was
    recorded, ``recorded_constant``, the k that it implies.
    """
    missing = [name for name in INPUTS if name not in slams]
    if missing:
        raise InputError(f"table of slams must have {', '.join(INPUTS)}; it lacks {', '.join(missing)}.")
    checked_number("density", density, "kg/m3", above=0)
    roll = slams.roll_angle.values if "roll_angle" in slams else 0.0
    given = (slams[name].values for name in INPUTS)
    found = chuang.method_one(*given, density, roll=roll, small_angle_law=small_angle_law)
    made = {name: ("event", values) for name, values in zip(PREDICTED, found, strict=True)}
    if "recorded_pressure" in slams:
        back = chuang.back_calculated_coefficient(slams.recorded_pressure.values, found, density)
        made["recorded_constant"] = ("event", back)
    attrs = {**slams.attrs, "method": "Chuang, Method I", "density": float(density)}
    return quantities.labelled(slams.assign(made).assign_attrs(attrs))


class Agreement(NamedTuple):
    """Recorded against calculated pressures.

    ``ratio`` is recorded over calculated; ``within_quarter`` counts ratios of 0.75 to 1.25,
    ``below`` those under 1; ``rms_error`` [Pa]; ``correlation`` of the pressures, NaN for fewer than three.
    """

    count: int
    mean_ratio: float
    median_ratio: float
    least_ratio: float
    largest_ratio: float
    rms_error: float
    correlation: float
    within_quarter: int
    below: int


def agreement(recorded, calculated) -> Agreement:
    """Statistics of recorded against calculated pressures (event) [Pa]."""
    recorded, calculated = np.asarray(recorded, float), np.asarray(calculated, float)
    if recorded.shape != calculated.shape or recorded.ndim != 1 or not len(recorded):
        raise InputError(
            "recorded and calculated pressures must be two lists of one length, of one slam or more."
        )
    if not np.all(calculated > 0):
        raise InputError("calculated pressures must be > 0 Pa to be compared with.")
    ratio = recorded / calculated
    correlation = np.nan
    if len(ratio) > 2:
        correlation = float(np.corrcoef(recorded, calculated)[0, 1])
    return Agreement(
        count=len(ratio),
        mean_ratio=float(ratio.mean()),
        median_ratio=float(np.median(ratio)),
        least_ratio=float(ratio.min()),
        largest_ratio=float(ratio.max()),
        rms_error=float(np.sqrt(np.mean((recorded - calculated) ** 2))),
        correlation=correlation,
        within_quarter=int(np.sum(np.abs(ratio - 1) <= 0.25)),
        below=int(np.sum(ratio < 1)),
    )


class MatchedComparison(NamedTuple):
    """Slams of one kind of bottom against those of another at the same impact angle.

    ``pairs`` : pairs within the band; ``matched`` : slams of the second kind with a partner.
    ``median_ratio`` : over the second kind's slams, of their k over the mean k of their partners.
    ``lower`` : how many of them have the lower k. ``probability`` : two-sided
    Mann-Whitney probability that the ratios of k to the prediction differ as much by chance,
    over all slams of the two kinds.
    """

    pairs: int
    matched: int
    median_ratio: float
    lower: int
    probability: float


def matched_comparison(first: xr.Dataset, second: xr.Dataset, band: float = MATCH) -> MatchedComparison:
    """Compare back-calculated k of two tables of slams at matched impact angles.

    Parameters
    ----------
    first, second : from `predicted_slams`, with ``recorded_constant``; such as rigid and elastic.
    band : largest difference of impact angle [rad].

    Notes
    -----
    The bottoms of [Chuang1975]_ were tested in separate runs, so that no two slams are the
    same; pairs share slams and are not independent.
    """
    checked_number("band of impact angles", band, "rad", above=0)
    near = np.abs(second.impact_angle.values[:, None] - first.impact_angle.values) <= band
    has = near.any(axis=1)
    if not has.any():
        raise InputError(f"no slams have impact angles within {np.degrees(band):g} degrees; widen the band.")
    partner = (near[has] @ first.recorded_constant.values) / near[has].sum(axis=1)
    ratio = second.recorded_constant.values[has] / partner
    scatter = [(one.recorded_constant / one.pressure_constant).values for one in (first, second)]
    return MatchedComparison(
        pairs=int(near.sum()),
        matched=int(has.sum()),
        median_ratio=float(np.median(ratio)),
        lower=int(np.sum(ratio < 1)),
        probability=float(mannwhitneyu(*scatter).pvalue),
    )
