"""Limits of motions: how often they are exceeded in a sea, and whether a ship passes.

.. [Couser1996] P. R. Couser, "An investigation into the performance of high-speed catamarans in
    calm water and waves", PhD thesis, University of Southampton, 1996, 9.1 and table 9.3.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY
from workbench.errors import InputError, checked_number

SIGNIFICANT_SHARE = float(np.exp(-2.0))
"""Share of the peaks above the significant amplitude, exp(-2) = 0.135 [-]."""


@dataclass(frozen=True, kw_only=True)
class MotionCriterion:
    """A limit of a motion.

    Parameters
    ----------
    motion : name of what is limited; limit : of its amplitude, in ``unit`` (SI).
    allowed : share of the peaks that may exceed it, 0 to 1; exp(-2) if left out: the
        significant amplitude must stay below the limit.
    """

    motion: str
    limit: float
    unit: str
    allowed: float = SIGNIFICANT_SHARE

    def __post_init__(self):
        if not self.motion:
            raise InputError("motion of a criterion must have a name.")
        checked_number(f"limit of {self.motion}", self.limit, self.unit, above=0)
        checked_number(f"allowed share of {self.motion}", self.allowed, above=0, below=1)


@dataclass(frozen=True, kw_only=True)
class Assessment:
    """A criterion held against a deviation: share of peaks beyond, significant amplitude, and whether it is met."""

    criterion: MotionCriterion
    deviation: float
    exceedance: float
    significant_amplitude: float
    passes: bool


FERRY_CRITERIA = (
    MotionCriterion(motion="heave", limit=2.0, unit="m"),
    MotionCriterion(motion="pitch", limit=float(np.radians(3.0)), unit="rad"),
    MotionCriterion(motion="vertical acceleration", limit=0.4 * GRAVITY, unit="m/s2"),
    MotionCriterion(motion="lateral acceleration", limit=0.2 * GRAVITY, unit="m/s2"),
)
"""Limits of [Couser1996]_ table 9.3; which share of the peaks may exceed them is not stated there."""


def exceedance_probability(limit: float, variance: float) -> float:
    """Share of the peaks above a limit by Rayleigh's law, exp(-x^2/2 m0) [-] ([Couser1996]_ 9.1)."""
    checked_number("limit", limit, at_least=0)
    if checked_number("variance", variance, at_least=0) == 0:
        return 0.0
    return float(np.exp(-(limit**2) / (2 * variance)))


def assessments(
    variances: Mapping[str, float], criteria: Sequence[MotionCriterion] = FERRY_CRITERIA
) -> tuple[Assessment, ...]:
    """Hold motions against criteria; criteria of motions that are not given are left out.

    Parameters
    ----------
    variances : m0 of each motion by name, in SI units squared; criteria : limits.

    Raises
    ------
    InputError if none of the motions has a criterion.
    """
    known = [one for one in criteria if one.motion in variances]
    if not known:
        names = ", ".join(one.motion for one in criteria)
        raise InputError(f"variances must hold one of {names}, got {', '.join(variances) or 'none'}.")
    found = []
    for criterion in known:
        variance = checked_number(f"variance of {criterion.motion}", variances[criterion.motion], at_least=0)
        share = exceedance_probability(criterion.limit, variance)
        deviation = float(np.sqrt(variance))
        found.append(
            Assessment(
                criterion=criterion,
                deviation=deviation,
                exceedance=share,
                significant_amplitude=2 * deviation,
                passes=share <= criterion.allowed,
            )
        )
    return tuple(found)
