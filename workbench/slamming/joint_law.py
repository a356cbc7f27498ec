"""The joint law of velocity and angle at an entry, as cells in order of their pressure.

At an entry the velocity is Rayleigh distributed ([Ochi1964]_), and the slope of the water against the deck
is Gaussian about its regression on relative motion and velocity. The law is laid on cells of velocity and angle, each
with its pressure and its number of slams per hour; put in order of pressure they answer both questions:
which pressure is exceeded so often, and how often a pressure is exceeded.

.. [Ochi1964] M. K. Ochi, "Prediction of occurrence and severity of ship slamming
    at sea", 5th Symp. on Naval Hydrodynamics, Bergen, 1964, pp. 545-596.
"""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench.impact.pressure import PressureLaw, peak_pressure

_VELOCITY_STEPS = 36
_ANGLE_STEPS = 21
_ANGLE_REACH = 4.0


@dataclass(frozen=True, eq=False)
class RankedPressures:
    """Cells of the joint law in falling order of pressure.

    Parameters
    ----------
    pressure : (cell, x, y) [Pa].
    number : slams per hour in each cell (cell, x, y) [1/h].
    """

    pressure: np.ndarray
    number: np.ndarray

    def pressure_exceeded(self, per_hour: float) -> np.ndarray:
        """Pressure exceeded so often (x, y) [Pa], 0 where there are no more slams than that.

        Read between two cells in the logarithm of the number.
        """
        above = np.cumsum(self.number, axis=0) - self.number / 2
        second = np.maximum(np.argmax(above >= per_hour, axis=0), 1)[None]
        fewer, more = (np.take_along_axis(above, index, axis=0)[0] for index in (second - 1, second))
        higher, lower = (
            np.take_along_axis(self.pressure, index, axis=0)[0] for index in (second - 1, second)
        )
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            between = np.log(per_hour / fewer) / np.log(more / fewer)
        return higher + np.clip(np.nan_to_num(between), 0.0, 1.0) * (lower - higher)

    def number_above(self, levels: np.ndarray) -> np.ndarray:
        """Slams per hour with a pressure above each level (level, x, y) [1/h], 0 above the highest cell.

        Cells of one pressure count as one, at the middle of their number; between them the logarithm
        of the number is straight.
        """
        through = np.cumsum(self.number, axis=0)
        before = through - self.number
        first = np.ones(self.pressure.shape, bool)
        first[1:] = self.pressure[1:] != self.pressure[:-1]
        last = np.ones(self.pressure.shape, bool)
        last[:-1] = first[1:]
        start = np.maximum.accumulate(np.where(first, before, 0.0), axis=0)
        end = np.flip(np.minimum.accumulate(np.flip(np.where(last, through, np.inf), 0), axis=0), 0)
        middle = (start + end) / 2
        cells, levels = len(self.pressure), np.asarray(levels, float)
        below = np.stack([(self.pressure > level).sum(axis=0) for level in levels])
        pair = np.clip(below - 1, 0, cells - 1), np.clip(below, 0, cells - 1)
        higher, lower = (np.take_along_axis(self.pressure, index, axis=0) for index in pair)
        fewer, more = (np.take_along_axis(middle, index, axis=0) for index in pair)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            share = np.nan_to_num((higher - levels.reshape(-1, *[1] * (below.ndim - 1))) / (higher - lower))
            between = fewer * np.exp(np.nan_to_num(share * np.log(more / fewer)))
        return np.where(below == 0, 0.0, np.where(below == cells, through[-1], between))


def ranked_pressures(
    moments: xr.Dataset,
    statistics: xr.Dataset,
    deck: xr.Dataset,
    law: PressureLaw,
    density: float,
    least_per_hour: float,
) -> RankedPressures:
    """Cells of the joint law of velocity and angle at every deck point, ordered by pressure.

    Parameters
    ----------
    moments, statistics : from `workbench.slamming.statistics`.
    deck : with ``height`` and ``slope_x`` (x, y).
    law : pressure law; density : of the water [kg/m3].
    least_per_hour : smallest number per hour that will be asked for [1/h]; the cells reach four
        logarithms further.

    Notes
    -----
    36 velocities by 21 angles over four deviations. The kind of velocity is that of ``statistics``; of the
    material one, what lies below 0 is 0. Costs some 20 ms for 400 points.
    """
    expected = statistics.slams_per_hour.values
    threshold = statistics.attrs["threshold_velocity"]
    motion_std = np.maximum(moments.relative_motion_std.values, 1e-12)
    velocity_std = np.maximum(moments.relative_velocity_std.values, 1e-12)

    deepest = np.log(np.maximum(expected / least_per_hour, 1.0)) + 4.0
    edges = np.linspace(0.0, 1.0, _VELOCITY_STEPS + 1)[:, None, None] * np.sqrt(deepest)
    exceeded = np.exp(-(edges**2))
    share = exceeded[:-1] - exceeded[1:]
    middle = -np.log((exceeded[:-1] + exceeded[1:]) / 2)
    velocity = np.sqrt(threshold**2 + 2 * velocity_std**2 * middle)

    on_motion = moments.motion_slope_covariance.values / motion_std**2
    on_velocity = moments.velocity_slope_covariance.values / velocity_std**2
    left = (
        moments.relative_slope_std.values**2
        - moments.motion_slope_covariance.values**2 / motion_std**2
        - moments.velocity_slope_covariance.values**2 / velocity_std**2
    )
    nodes = np.linspace(-_ANGLE_REACH, _ANGLE_REACH, _ANGLE_STEPS)
    node_weights = np.exp(-(nodes**2) / 2)
    node_weights = node_weights / node_weights.sum()
    mean_slope = on_motion * deck.height.values + on_velocity * velocity
    slope = mean_slope + np.sqrt(np.maximum(left, 0.0)) * nodes[:, None, None, None]
    if statistics.attrs["velocity"] == "material":
        velocity = np.maximum(velocity - moments.attrs["speed"] * slope, 0.0)
    pressure = peak_pressure(law, velocity, np.arctan(slope - deck.slope_x.values), density)

    number = expected * share * node_weights[:, None, None, None]
    shape = (-1, *expected.shape)
    pressure = pressure.reshape(shape)
    number = np.broadcast_to(number, (_ANGLE_STEPS, *share.shape)).reshape(shape)
    order = np.argsort(-pressure, axis=0)
    return RankedPressures(
        np.take_along_axis(pressure, order, axis=0), np.take_along_axis(number, order, axis=0)
    )
