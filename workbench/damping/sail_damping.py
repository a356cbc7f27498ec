"""Roll and pitch damping by sails, close-hauled, quasi-steady ([Grande2002]_ 2.33-2.50).

A piece of sail at the height z moves aft-wards through the air with V1 = U - V0 cos(d) + z xi5' and
feels V2 = V0 sin(d) + z xi4' across (V0, d: true wind; xi4', xi5': roll and pitch velocity about the
origin). With a constant lift coefficient at right angles to the apparent wind V = (V1**2 + V2**2)**0.5,
its side force and drive per area are rho C_L V V1 / 2 and rho C_L V V2 / 2, which times z are its
rolling and pitching moments.

What sign. The source takes the root mean square of the moment over a cycle for damping. A root mean
square has no sign: all four coefficients come out positive. The derivatives of the moments have signs:
damping in roll, **negative** damping in pitch (a masthead that moves forward meets more wind, which
drives it further), and couplings of opposite signs that change with the tack. Neither matrix takes
energy out of every motion: the symmetric part of each has a negative eigenvalue, that of the source's
Q (V1 V2 - 1.5 V**2) / V, Q as in `closed_form`. ``sign`` of the settings chooses.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, Curtin University
    of Technology, 2002.
"""

from collections.abc import Iterator
from dataclasses import asdict, dataclass

import numpy as np
import xarray as xr

from workbench.conventions import encounter_frequency
from workbench.damping.normal_flow import force_set
from workbench.errors import InputError, checked_choice, checked_number
from workbench.sails import SailPlan, TrueWind

METHODS = ("closed-form", "root-mean-square")
SIGNS = ("source", "derivative")
DIVISORS = ("velocity", "amplitude")
INSTANTS = 64
"""Instants of a cycle at which the moments are taken; a smooth periodic integrand converges fast."""
LEAST_VELOCITY = 1e-6
"""Velocity amplitude below which the root mean square is taken at this one [rad/s]."""
LUFFING = np.radians(15.0)
"""Apparent wind angle below which no sail draws, ours [rad]."""
ROLL_PITCH = np.ix_((3, 4), (3, 4))


@dataclass(frozen=True, kw_only=True)
class SailDampingSettings:
    """Choices for the damping by sails.

    Parameters
    ----------
    method : "closed-form" (limit of small motions) or "root-mean-square" (over a cycle of given amplitude).
    sign : "source" (all coefficients positive, as by the source) or "derivative" (signs of the derivatives of
        the moments; closed form only).
    amplitude : of roll or pitch, for the root mean square [rad].
    mean_moment : keep the mean moment in the root mean square, as printed: the damping then grows
        without limit as the motion goes to zero. Without it, only the fluctuation counts.
    divisor : "velocity": moment over velocity amplitude, a damping; "amplitude": over motion
        amplitude, as printed, which is a damping times the encounter frequency.
    """

    method: str = "closed-form"
    sign: str = "source"
    amplitude: float = 0.05
    mean_moment: bool = False
    divisor: str = "velocity"

    def __post_init__(self) -> None:
        checked_choice("method of sail damping", self.method, METHODS)
        checked_choice("sign of sail damping", self.sign, SIGNS)
        checked_choice("divisor of sail damping", self.divisor, DIVISORS)
        checked_number("amplitude of sail damping", self.amplitude, "rad", above=0.0, at_most=0.8)
        if not isinstance(self.mean_moment, bool):
            raise InputError(
                f"mean_moment must be true or false, got {self.mean_moment!r}; give one of them."
            )
        if self.method == "root-mean-square" and self.sign == "derivative":
            raise InputError(
                "sign of sail damping must be source for the root mean square, which has no sign, got "
                "'derivative'; take the closed form."
            )
        if self.method == "closed-form" and (self.mean_moment or self.divisor != "velocity"):
            raise InputError(
                "mean_moment and divisor of sail damping belong to the root mean square, got the closed form; "
                "leave them out or change the method."
            )

    def as_dict(self) -> dict:
        """Return the settings as plain values."""
        return asdict(self)


def closed_form(plan: SailPlan, along, across) -> np.ndarray:
    """Damping of small motions, all positive, (..., 2, 2) for roll and pitch [N m s/rad].

    With V1 = ``along``, V2 = |``across``| and Q = rho C_L / 2 times the integral of c z**2::

        B44 = B55 = Q V1 V2 / V    B45 = Q (V1**2 + V**2) / V    B54 = Q (V2**2 + V**2) / V

    It follows from [Grande2002]_ 2.33-2.50 with the mean moment taken off and moments divided by
    velocity amplitudes, in the limit of small motions; it is not printed there.
    """
    v1, v2 = np.asarray(along, float), np.abs(np.asarray(across, float))
    moment = 0.5 * plan.air_density * plan.lift_coefficient * plan.moment(2)
    v = np.maximum(np.hypot(v1, v2), 1e-12)
    own, by_pitch, by_roll = v1 * v2 / v, (v1**2 + v**2) / v, (v2**2 + v**2) / v
    return moment * np.stack([np.stack([own, by_pitch], -1), np.stack([by_roll, own], -1)], -2)


def derivative(plan: SailPlan, along, across) -> np.ndarray:
    """Damping of small motions with the signs of the derivatives, (..., 2, 2) for roll and pitch [N m s/rad].

    Minus the derivatives of the moments to the velocities: [[B44, s B45], [-s B54, -B55]] of
    `closed_form`, s = 1 with the wind from starboard and -1 from port.
    """
    tack = np.where(np.asarray(across) < 0.0, -1.0, 1.0)[..., None, None]
    signs = np.where(np.array([[False, True], [True, False]]), tack, 1.0) * np.array([[1.0], [-1.0]])
    return signs * closed_form(plan, along, across)


def root_mean_square(
    plan: SailPlan,
    along,
    across,
    amplitude: float,
    frequency,
    mean_moment: bool = False,
    divisor: str = "velocity",
) -> np.ndarray:
    """Damping by the root mean square of the moments over a cycle, (..., 2, 2) [N m s/rad].

    sqrt(integral of M**2 / pi) over the velocity amplitude, M the moment less its mean, for roll
    alone (first column) and pitch alone (second) ([Grande2002]_ 2.43-2.50). See `SailDampingSettings`
    for ``mean_moment`` and ``divisor``, the printed forms.

    Parameters
    ----------
    along, across : V1, V2 [m/s]; amplitude : [rad]; frequency : omega_e [rad/s]; all broadcast.
    """
    v1, v2, met = np.broadcast_arrays(*np.atleast_1d(along, np.abs(across), np.abs(frequency)))
    rate = np.maximum(met * amplitude, LEAST_VELOCITY)
    heights, areas = plan.quadrature()
    swing = np.sin(2 * np.pi * np.arange(INSTANTS) / INSTANTS)
    motion = rate[..., None, None] * swing[:, None] * heights
    found = np.empty((*v1.shape, 2, 2))
    for column, (roll, pitch) in enumerate(((motion, 0.0), (0.0, motion))):
        w1, w2 = v1[..., None, None] + pitch, v2[..., None, None] + roll
        pressure = 0.5 * plan.air_density * plan.lift_coefficient * np.hypot(w1, w2)
        for row, part in enumerate((w1, w2)):
            moments = np.sum(pressure * part * heights * areas, axis=-1)
            if not mean_moment:
                moments = moments - moments.mean(axis=-1, keepdims=True)
            found[..., row, column] = np.sqrt(2 * np.mean(moments**2, axis=-1)) / rate
    if divisor == "amplitude":
        found *= met[..., None, None]
    return found[0] if np.ndim(along) == np.ndim(across) == np.ndim(frequency) == 0 else found


def sail_damping(
    plan: SailPlan,
    wind: TrueWind,
    speed: float,
    omega,
    wave_directions,
    settings: SailDampingSettings | None = None,
) -> xr.Dataset:
    """Roll and pitch damping by the sails, about the origin.

    Parameters
    ----------
    speed : of the ship [m/s]; omega : (omega,) [rad/s]; wave_directions : (wave_direction,) [rad].

    Returns
    -------
    Dataset: ``damping`` (omega, wave_direction, influenced_dof, radiating_dof), zero but for roll and
    pitch; zero also where the apparent wind comes from abaft the beam.

    Notes
    -----
    Assumes a ship that sails upwind, small heel, unsteady drag much smaller than unsteady lift,
    attached quasi-steady flow and stiff sails; surge and sway by the sails are left out
    ([Grande2002]_ 2.2.2). The steady forces of the sails are not in it.
    """
    settings = settings or SailDampingSettings()
    speed = checked_number("speed", speed, "m/s", at_least=0.0, at_most=60.0)
    omega, directions = np.atleast_1d(omega).astype(float), np.atleast_1d(wave_directions).astype(float)
    along, across = wind.apparent(speed, directions)
    met = encounter_frequency(omega[:, None], speed, directions)
    if settings.method == "root-mean-square":
        found = root_mean_square(
            plan, along, across, settings.amplitude, met, settings.mean_moment, settings.divisor
        )
    else:
        formula = derivative if settings.sign == "derivative" else closed_form
        found = np.broadcast_to(formula(plan, along, across), (*met.shape, 2, 2))
    drawing = along > 0.0
    damping = np.zeros((*met.shape, 6, 6))
    damping[(..., *ROLL_PITCH)] = found * drawing[:, None, None]
    return force_set(
        omega, directions, method="sails", damping=damping,
        warnings=_warnings(settings, along, across),
        attrs={
            "speed": speed, "wind_speed": wind.speed,
            **{f"sail_{name}": str(value) for name, value in settings.as_dict().items()},
        },
    )  # fmt: skip


def _warnings(settings: SailDampingSettings, along: np.ndarray, across: np.ndarray) -> Iterator[str]:
    """Say what the signs are, and where the sails are not close-hauled."""
    if settings.sign == "source":
        yield (
            "Sail damping is the root mean square of the source: all positive, though with a constant lift "
            "coefficient sails feed pitch; it may put energy into motions that couple roll and pitch."
        )
    else:
        yield (
            "Sail damping has the signs of the derivatives: it damps roll and feeds pitch, and its couplings "
            "change sign with the tack."
        )
    if settings.mean_moment:
        yield "Sail damping holds the mean moment, as printed: it grows without limit as the motion vanishes."
    if settings.divisor == "amplitude":
        yield "Sail damping is moment over amplitude, as printed: not a damping but one times the frequency."
    angle = np.arctan2(np.abs(across), along)
    if bool((along <= 0.0).any()):
        yield "Sails are left out where the apparent wind comes from abaft the beam."
    if bool((angle[along > 0.0] < LUFFING).any()):
        yield "Sails would luff where the apparent wind is within 15 degrees of the bow; their lift is kept there."
