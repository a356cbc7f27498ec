"""What the direct method of [Grande2002]_ 4.2 counts, in closed form for a linear, Gaussian relative motion.

It takes for a slam a crossing of the deck by the water at which the hull surface also comes down on the water
*particles*: by its velocity past them (4.18), not by the rate at which the gap closes. At speed some crossings
have the one without the other, so that there are fewer slams than crossings, the fewer the faster the ship.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

import numpy as np
import xarray as xr
from scipy.special import ndtr

from workbench import quantities
from workbench.slamming.statistics import HOUR

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(96)
_FASTEST = 8.0
"""Velocity up to which the Rayleigh distribution is integrated, in deviations [-]."""


def direct_statistics(moments: xr.Dataset, height: xr.DataArray) -> xr.Dataset:
    """Slams per hour and mean entry velocity as the direct method has them, at every deck point.

    Parameters
    ----------
    moments : from `statistics.response_moments`; height : of the deck above still water (x, y) [m].

    Returns
    -------
    Dataset over (x, y): ``slams_per_hour``, ``mean_entry_velocity`` past the water.

    Notes
    -----
    At a crossing the rate of the gap v is Rayleigh distributed ([Rice1944]_), and the slope s of the
    water against the deck is normal about a line in height and v. The velocity past the water is v - U s:
    its share above zero is the share of crossings that count. No threshold beyond that, as in the source.

    .. [Rice1944] S. O. Rice, "Mathematical analysis of random noise", Bell System Technical
        Journal 23, 282-332, 1944.
    """
    motion, rate, slope = (
        np.maximum(moments[f"relative_{name}_std"].values, 1e-12) for name in ("motion", "velocity", "slope")
    )
    speed = float(moments.attrs["speed"])
    on_motion = moments.motion_slope_covariance.values / motion**2
    on_rate = moments.velocity_slope_covariance.values / rate**2
    scatter = np.sqrt(np.maximum(slope**2 - (on_motion * motion) ** 2 - (on_rate * rate) ** 2, 0.0))
    scatter = np.maximum(speed * scatter, 1e-9 * rate)
    share, velocity = np.zeros_like(motion), np.zeros_like(motion)
    for node, weight in zip(_NODES, _WEIGHTS, strict=True):
        fast = _FASTEST / 2 * (node + 1)
        density = weight * _FASTEST / 2 * fast * np.exp(-(fast**2) / 2)
        mean = (1 - speed * on_rate) * fast * rate - speed * on_motion * height.values
        above = ndtr(mean / scatter)
        share += density * above
        hill = np.exp(-((mean / scatter) ** 2) / 2) / np.sqrt(2 * np.pi)
        velocity += density * (mean * above + scatter * hill)
    crossings = moments.upcrossing_rate.values * np.exp(-(height.values**2) / (2 * motion**2))
    dims = ("x", "y")
    return quantities.dataset(
        {"x": moments.x, "y": moments.y},
        method=moments.attrs["method"],
        warnings=quantities.warnings_of(moments),
        attrs={"threshold_velocity": 0.0, "velocity": "material"},
        slams_per_hour=(dims, HOUR * crossings * share),
        mean_entry_velocity=(dims, velocity / np.maximum(share, 1e-300)),
    )
