"""Pressure of a slam from its fitted fronts: Wagner's outer pressure on the wetted length.

.. [Wagner1932] H. Wagner, "Ueber Stoss- und Gleitvorgaenge an der Oberflaeche von
    Fluessigkeiten", ZAMM 12(4), 193-215, 1932.
.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025, 3.4 and 6.3-6.4.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import checked_choice, checked_number
from workbench.wet_deck_pressure.fitted_front import SIDES, Fronts, fitted_fronts, impact_velocity

FORMS = ("panel average", "panel centre")
"""Average over the panel, or the value at its centre, which is without bound where the front passes it."""

STEPS = 1000
"""Time steps over the wetting of the source [-]."""

LEAST_ANGLE = np.radians(5.0)
"""Below this angle between deck and water the air between them matters [rad] ([Baggus2025]_ 1.1)."""

NO_PILE_UP = (
    "Wetted length by rigid kinematics, without the pile-up of water; plane flow along the ship; impact velocity "
    "constant in time; no load before the fitted front arrives and none after the slam."
)


def average_pressure(near, far, length, rate, velocity, density: float) -> np.ndarray:
    """Pressure averaged over panels on one side of first contact [Pa].

    Parameters
    ----------
    near, far : distances of the panels' edges from first contact, 0 <= near <= far [m].
    length, rate : of the front, c [m] and dc/dt [m/s]; velocity : V [m/s]; density [kg/m3]. All broadcast.

    Notes
    -----
    The integral of rho V c c'/sqrt(c**2 - x**2) ([Wagner1932]_, [Baggus2025]_ 3.15) over the wetted part of the
    panel, rho V c c' [arcsin(x_2/c) - arcsin(x_1/c)], over the length of the panel. Over a whole side
    it is (pi/2) rho V c c' a breadth.
    """
    near, far, length = (np.asarray(part, float) for part in (near, far, length))
    safe = np.where(length > 0, length, 1.0)
    angle = np.arcsin(np.clip(far / safe, 0.0, 1.0)) - np.arcsin(np.clip(near / safe, 0.0, 1.0))
    breadth = np.where(far > near, far - near, 1.0)
    return np.where(length > 0, density * velocity * safe * rate * angle / breadth, 0.0)


def centre_pressure(distance, length, rate, velocity, density: float) -> np.ndarray:
    """Pressure at panel centres [Pa], 0 beyond the front ([Baggus2025]_ 3.15 as printed).

    Parameters
    ----------
    distance : of the centres from first contact, >= 0 [m]; the others as in `average_pressure`.

    Notes
    -----
    A front that falls on a centre to rounding gives any pressure at all, and with it a force and an
    impulse without meaning. Offered to show that; use `average_pressure`.
    """
    distance, length = np.asarray(distance, float), np.asarray(length, float)
    inside = distance < length
    root = np.sqrt(np.where(inside, length * length - distance * distance, 1.0))
    return np.where(inside, density * velocity * length / root * rate, 0.0)


def spreading_impulse(density: float, velocity: float, length: float) -> float:
    """Impulse of one side of a flat impact that has spread to a length, pi/4 rho V c**2 [N s/m]."""
    return np.pi / 4 * density * velocity * length**2


def slam_pressure(
    slam: xr.Dataset,
    density: float,
    *,
    fit: str = "linear",
    velocity: str = "mean",
    form: str = "panel average",
    steps: int = STEPS,
) -> xr.Dataset:
    """Pressure on the wetted panels of a slam in time, with its force and impulse.

    Parameters
    ----------
    slam : from `workbench.wet_deck_pressure.slam_event.slam_event`.
    density : of the water [kg/m3].
    fit : of the wetted length: "linear", "quadratic" or "cubic".
    velocity : of impact: "mean", or "cubic" along the ship. With ``fit`` the four variants of the
        source, and two more.
    form : one of `FORMS`.
    steps : time steps over the wetting.

    Returns
    -------
    Dataset over time since first contact and point: ``deck_pressure`` (time, point), ``deck_force``
    (time) [N], ``running_impulse`` (time) [N s] by the trapezium rule; ``wetted_length_fore`` and
    ``wetted_length_aft`` (time); ``impact_velocity``, ``point_x``, ``point_y``, ``area`` (point).

    Notes
    -----
    The front is the same at all y; panels beside the slam that it does not wet carry no load. Holds
    for flat decks and short slams; plane flow along the ship, so too much load where the wetted part is
    not much wider than long; neglects the deceleration of the impact and the squares of the flow
    velocity. [Baggus2025]_ 6.3-6.4.
    """
    checked_number("density", density, "kg/m3", above=0)
    checked_choice("form of the pressure", form, FORMS)
    steps = int(checked_number("number of time steps", steps, at_least=2, at_most=100_000))
    fronts = fitted_fronts(slam, fit)
    impact = impact_velocity(slam, velocity)
    time = np.arange(steps + 1) * (fronts.duration / steps)
    pressure = _pressure(slam, fronts, impact, time, density, form)
    force = pressure @ slam.area.values
    impulse = np.concatenate([[0.0], np.cumsum((force[1:] + force[:-1]) / 2 * np.diff(time))])
    notes = [*quantities.warnings_of(slam), *fronts.notes, NO_PILE_UP]
    least = float(np.nanmin(np.abs(slam.entry_angle.values)))
    if least < LEAST_ANGLE:
        notes.append(
            f"The water meets the deck at {np.degrees(least):.2g} degrees at least: below "
            f"{np.degrees(LEAST_ANGLE):g} degrees trapped air matters, and the theory leaves it out."
        )
    lengths = {side: getattr(fronts, side).length(time) for side in SIDES}
    return quantities.dataset(
        {"time": time, "point": np.arange(slam.sizes["event"])},
        method=f"Wagner pressure on a {fit} front, {velocity} impact velocity, {form}",
        warnings=notes,
        attrs={
            **{name: slam.attrs[name] for name in ("start", "contact_x", "contact_y")},
            "density": float(density),
        },
        deck_pressure=(("time", "point"), pressure),
        deck_force=("time", force),
        running_impulse=("time", impulse),
        wetted_length_fore=("time", lengths["fore"]),
        wetted_length_aft=("time", lengths["aft"]),
        impact_velocity=("point", impact),
        point_x=("point", slam.event_x.values),
        point_y=("point", slam.event_y.values),
        area=("point", slam.area.values),
    )


def _pressure(
    slam: xr.Dataset, fronts: Fronts, impact: np.ndarray, time: np.ndarray, density: float, form: str
) -> np.ndarray:
    """Pressure (time, point): the sides forward and aft of first contact together."""
    contact = slam.attrs["contact_x"]
    total = np.zeros((len(time), len(impact)))
    panel = slam.panel_fore.values - slam.panel_aft.values
    for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
        front = getattr(fronts, side)
        if not front.coefficients:
            continue
        length, rate = front.length(time)[:, None], front.rate(time)[:, None]
        if form == "panel centre":
            distance = sign * (slam.event_x.values - contact)
            own = centre_pressure(np.abs(distance), length, rate, impact, density)
            total += np.where(distance >= 0 if side == "fore" else distance > 0, own, 0.0)
            continue
        edges = sign * (slam.panel_aft.values - contact), sign * (slam.panel_fore.values - contact)
        near, far = (np.maximum(part, 0.0) for part in (np.minimum(*edges), np.maximum(*edges)))
        share = (far - near) / np.where(panel > 0, panel, 1.0)
        total += share * average_pressure(near, far, length, rate, impact, density)
    return total


def impulse_convergence(
    slam: xr.Dataset,
    density: float,
    steps: Sequence[int] = (50, 100, 200, 500, 1000),
    **variant: str,
) -> xr.Dataset:
    """Impulse of a slam by the number of time steps, the check of the source ([Baggus2025]_ 3.4).

    Parameters
    ----------
    slam, density : as in `slam_pressure`; steps : numbers of time steps.
    **variant : ``fit``, ``velocity``, ``form`` of `slam_pressure`.

    Returns
    -------
    Dataset over steps: ``slam_impulse`` at the end of the wetting [N s].
    """
    ends = [
        slam_pressure(slam, density, steps=count, **variant).running_impulse.values[-1] for count in steps
    ]
    return quantities.dataset(
        {"steps": list(steps)}, method="impulse by number of time steps", slam_impulse=("steps", ends)
    )
