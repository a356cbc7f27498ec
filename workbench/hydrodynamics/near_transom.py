"""Loss of pressure ahead of a dry transom.

A march from the bow does not know that the pressure must be that of the air at the
edge of a dry transom. [Garme2005]_ lets all vertical pressure forces, static and
dynamic, fall to nothing there by the factor::

    tanh(2.5 (x - x_T) / (0.34 B C_V))       C_V = U / sqrt(g B)

with B the greatest beam of the hull, found from model tests of planing craft.

.. [Garme2005] K. Garme, "Improved time domain simulation of planing hulls in waves by
    correction of the near-transom lift", International Shipbuilding Progress 52(3),
    201-230, 2005.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import GRAVITY

SHARE_OF_BEAM = 0.34


def relaxation_length(beam: float, speed: float) -> float:
    """Length 0.34 B C_V / 2.5 over which the pressure comes back ahead of a dry transom [m]."""
    return SHARE_OF_BEAM * beam * speed / np.sqrt(GRAVITY * beam) / 2.5


@dataclass(frozen=True, eq=False)
class TransomWeights:
    """Integrals over each cell between stations of the pressure factor c and of its slope.

    Parameters
    ----------
    whole : int c dx (cells,) [m]; slope : int dc/dx dx (cells,) [-]; last : c at the end of the hull [-].
    """

    whole: np.ndarray
    slope: np.ndarray
    last: float


def transom_weights(edges: np.ndarray, transom: float, length: float | None) -> TransomWeights:
    """Weights of the cells between ``edges`` (falling x) [m] for a hull that ends at ``transom`` [m].

    Parameters
    ----------
    length : `relaxation_length` [m]; None leaves the pressure as it is (factor 1).
    """
    ahead = np.clip(edges - transom, 0.0, None)
    if length is None:
        return TransomWeights(-np.diff(ahead), np.zeros(len(edges) - 1), 1.0)
    log_cosh = length * (ahead / length + np.log1p(np.exp(-2 * ahead / length)) - np.log(2.0))
    factor = np.tanh(ahead / length)
    return TransomWeights(-np.diff(log_cosh), -np.diff(factor), 0.0)
