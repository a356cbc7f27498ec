"""A flat impact that spreads at a constant speed from a line, cell by cell: its pressure has a closed form."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.verification.case import Case
from workbench.wet_deck_pressure import fitted_pressure

DENSITY, VELOCITY, SPEED, LENGTH, PANELS = 1000.0, 0.4, 5.0, 0.06, 40
"""Of the pitfall: density [kg/m3], impact velocity and speed of the front [m/s], length [m], number of panels."""

IMPULSE = fitted_pressure.spreading_impulse(DENSITY, VELOCITY, LENGTH)
"""Of one side [N s/m]."""


def spreading_slam(
    velocity: float = VELOCITY,
    speed: float = SPEED,
    length: float = LENGTH,
    panels: int = PANELS,
    sides: int = 2,
    curvature: float = 0.0,
    breadth: float = 1.0,
) -> xr.Dataset:
    """A slam as `workbench.wet_deck_pressure.slam_event.slam_event` gives it.

    Parameters
    ----------
    velocity : at entry [m/s]; speed : of the front at first contact [m/s], which falls by a share
        ``curvature`` over ``length`` [m].
    panels : a side; sides : 1 (fore) or 2; breadth : of the panels across [m].
    """
    step = length / panels
    x = step * (np.arange(-panels if sides == 2 else 0, panels) + 0.5)
    whole = 2 * length / (speed * (1 + np.sqrt(1 - curvature)))
    bend = speed * curvature / (2 * whole) if curvature else 0.0  # c = speed t - bend t**2
    distance = np.abs(x)
    time = 2 * distance / (speed + np.sqrt(speed**2 - 4 * bend * distance))
    order = np.argsort(time, kind="stable")
    count = len(x)
    return quantities.dataset(
        {"event": np.arange(count)},
        method="a flat impact that spreads",
        attrs={"start": 0.0, "contact_x": 0.0, "contact_y": 0.0, "spread": float(time.max())},
        time_since_contact=("event", time[order]),
        event_x=("event", x[order]),
        event_y=("event", np.zeros(count)),
        entry_velocity=("event", np.full(count, velocity)),
        entry_angle=("event", np.full(count, 0.2)),
        immersion_depth=("event", np.full(count, 0.01)),
        area=("event", np.full(count, step * breadth)),
        panel_aft=("event", x[order] - step / 2),
        panel_fore=("event", x[order] + step / 2),
    )


def pitfall(steps: int, form: str = "panel centre") -> float:
    """Impulse of one side [N s/m], the sum of force times step, with pressures at panel centres or averaged."""
    step = LENGTH / PANELS
    time_step = LENGTH / SPEED / steps
    front = SPEED * (np.arange(1, steps + 1) * time_step)[:, None]
    centres = (np.arange(PANELS) + 0.5) * LENGTH / PANELS
    if form == "panel centre":
        pressure = fitted_pressure.centre_pressure(centres, front, SPEED, VELOCITY, DENSITY)
    else:
        edges = centres - step / 2, centres + step / 2
        pressure = fitted_pressure.average_pressure(*edges, front, SPEED, VELOCITY, DENSITY)
    return float(pressure.sum() * step * time_step)


PITFALL = (
    (50, 1.122),
    (100, 1.114),
    (200, 1.108),
    (500, 1.121),
    (1000, 1.1196),
    (2000, 14592.0),
    (5000, 1.1259),
)
"""Impulse with pressures at panel centres by number of time steps [N s/m], of an independent program."""

PITFALL_ROUNDING = {1000: 0.0001, 2000: 0.5}
SPIKE = "exact 1.13097; a front falls on a panel centre to rounding, and the sum has no meaning"


def cases() -> list[Case]:
    """Return the cases of this module."""
    wagner = "H. Wagner, ZAMM 12, 193-215, 1932"
    made = [
        Case(
            id=f"spreading-centres-{steps}",
            title=f"Impulse of a spreading plate, pressures at panel centres, {steps} time steps",
            kind="second code",
            source="pressures at panel centres, numbers of an independent program",
            published=known,
            computed=lambda steps=steps: pitfall(steps),
            tolerance=PITFALL_ROUNDING.get(steps, 0.0006),
            unit="N s/m",
            note=SPIKE if steps == 2000 else "",
        )
        for steps, known in PITFALL
    ]
    made += [
        Case(
            id=f"spreading-averages-{steps}",
            title=f"Impulse of a spreading plate, pressures averaged over panels, {steps} time steps",
            kind="closed form",
            source=wagner,
            published=IMPULSE * (1 + 1 / steps),
            computed=lambda steps=steps: pitfall(steps, "panel average"),
            tolerance=1e-9,
            unit="N s/m",
            note="pi/4 rho V c**2, times 1 + 1/n for the sum over n steps",
        )
        for steps in (50, 2000)
    ]
    return [
        *made,
        Case(
            id="spreading-two-sides",
            title="Impulse of a plate that spreads both ways, over pi/2 rho V c**2",
            kind="closed form",
            source=wagner,
            published=1.0,
            computed=_two_sides,
            tolerance=1e-6,
        ),
    ]


def _two_sides() -> float:
    found = fitted_pressure.slam_pressure(spreading_slam(), DENSITY)
    length = float(found.wetted_length_fore[-1])
    closed = 2 * fitted_pressure.spreading_impulse(DENSITY, VELOCITY, length)
    return float(found.running_impulse[-1]) / closed
