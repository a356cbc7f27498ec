"""Fronts of a slam fitted to the instants at which points of the deck got wet, and the velocity of impact.

.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025, 6.3.
"""

from dataclasses import dataclass, field

import numpy as np
import xarray as xr

from workbench.errors import InputError, checked_choice

DEGREES = {"linear": 1, "quadratic": 2, "cubic": 3}
"""Degree of the polynomial of the wetted length by name."""

VELOCITIES = ("mean", "cubic")
"""Velocity of impact: the mean of all points, or a cubic along the ship."""

SIDES = ("fore", "aft")

OVERSHOOT = 1.1
"""A front that ends this many times farther out than the wetted panels is warned of [-]."""


@dataclass(frozen=True, eq=False)
class Front:
    """Wetted length on one side of first contact, c(t) = c_1 t + c_2 t**2 + ..., c(0) = 0.

    Parameters
    ----------
    coefficients : c_1, c_2, ... [m/s, m/s2, ...]; none for a side that stays dry.
    residual : root mean square distance of the points from the fit [m].
    reach : distance of the outer edge of the farthest wetted panel [m].
    """

    coefficients: tuple[float, ...] = ()
    residual: float = 0.0
    reach: float = 0.0

    def length(self, time) -> np.ndarray:
        """Wetted length [m] at times since first contact [s]; a fit that would shrink keeps its length."""
        time = np.asarray(time, float)
        powers = np.arange(1, len(self.coefficients) + 1)
        found = np.power.outer(time, powers) @ np.array(self.coefficients)
        return np.maximum.accumulate(np.maximum(found, 0.0)) if found.ndim else np.maximum(found, 0.0)

    def rate(self, time) -> np.ndarray:
        """Speed of the front [m/s] at times since first contact [s], not below 0."""
        time = np.asarray(time, float)
        powers = np.arange(1, len(self.coefficients) + 1)
        found = np.power.outer(time, powers - 1) @ (powers * np.array(self.coefficients))
        return np.maximum(found, 0.0)


@dataclass(frozen=True, eq=False)
class Fronts:
    """Both fronts, the time to which they hold [s], and sentences about what was doubtful."""

    fore: Front
    aft: Front
    duration: float
    notes: tuple[str, ...] = field(default=())


def fitted_front(time, distance, degree: str) -> np.ndarray:
    """Coefficients of the wetted length by least squares, c(0) = 0 imposed ([Baggus2025]_ 6.3).

    Parameters
    ----------
    time : of wetting since first contact (n) [s]; distance : of the points from it (n) [m].
    degree : one of `DEGREES`. Fewer distinct instants than coefficients are refused.
    """
    order = DEGREES[checked_choice("fit of the wetted length", degree, DEGREES)]
    time, distance = np.asarray(time, float), np.asarray(distance, float)
    distinct = len(np.unique(time[time > 0]))
    if distinct < order:
        raise InputError(
            f"a {degree} fit of the wetted length needs {order} or more distinct instants after first contact, "
            f"got {distinct}; take a fit of lower degree or more points along the deck."
        )
    scale = time.max()
    powers = np.arange(1, order + 1)
    found = np.linalg.lstsq(np.power.outer(time / scale, powers), distance, rcond=None)[0]
    return found / scale**powers


def fitted_fronts(slam: xr.Dataset, degree: str = "linear") -> Fronts:
    """Fronts forward and aft of first contact.

    Parameters
    ----------
    slam : from `workbench.wet_deck_pressure.slam_event.slam_event`.
    degree : "linear", "quadratic" (used by the source) or "cubic".

    Notes
    -----
    The wetted length is where rigid kinematics puts the edge of the water: no pile-up, so von Karman's
    rather than Wagner's. A side with too few instants for the degree takes the highest it can; a side
    without any stays dry.
    """
    checked_choice("fit of the wetted length", degree, DEGREES)
    time, contact = slam.time_since_contact.values, slam.attrs["contact_x"]
    if not np.any(time > 0):
        raise InputError(
            "a slam must wet points one after another for its front to be fitted, got all at one instant; "
            "take more points along the deck."
        )
    found, notes = {}, []
    for side, sign, edge in (("fore", 1.0, slam.panel_fore.values), ("aft", -1.0, slam.panel_aft.values)):
        distance = sign * (slam.event_x.values - contact)
        mine = distance > 0
        distinct = len(np.unique(time[mine & (time > 0)]))
        order = min(DEGREES[degree], distinct)
        if not order:
            found[side] = Front()
            continue
        name = next(word for word, number in DEGREES.items() if number == order)
        if name != degree:
            notes.append(f"The {side} front has {distinct} instants only: its fit is {name}, not {degree}.")
        coefficients = fitted_front(time[mine], distance[mine], name)
        miss = np.power.outer(time[mine], np.arange(1, order + 1)) @ coefficients - distance[mine]
        found[side] = Front(
            tuple(float(one) for one in coefficients),
            float(np.sqrt(np.mean(miss**2))),
            float((sign * (edge[mine] - contact)).max()),
        )
    duration = float(time.max())
    for side, front in found.items():
        end = float(front.length(duration)) if front.coefficients else 0.0
        if end > OVERSHOOT * front.reach > 0:
            notes.append(
                f"The {side} front ends {end:.3g} m from first contact, beyond the wetted panels ({front.reach:.3g} m)."
            )
    return Fronts(found["fore"], found["aft"], duration, tuple(notes))


def impact_velocity(slam: xr.Dataset, law: str = "mean") -> np.ndarray:
    """Velocity of impact of each wetted point, constant in time (event) [m/s] ([Baggus2025]_ 6.3).

    Parameters
    ----------
    slam : from `slam_event`; law : "mean" of all points, or "cubic" in x by least squares (of lower
        degree where there are fewer distinct places), not below 0.
    """
    checked_choice("impact velocity", law, VELOCITIES)
    velocity = slam.entry_velocity.values
    if law == "mean":
        return np.full(len(velocity), float(velocity.mean()))
    along = slam.event_x.values - slam.attrs["contact_x"]
    scale = max(float(np.abs(along).max()), 1e-12)
    degree = min(3, len(np.unique(along)) - 1)
    fitted = np.polynomial.polynomial.polyfit(along / scale, velocity, degree)
    return np.maximum(np.polynomial.polynomial.polyval(along / scale, fitted), 0.0)
