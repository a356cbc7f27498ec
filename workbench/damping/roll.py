"""Roll damping of one hull by friction and lift.

[Kato1957] H. Kato, "On the frictional resistance to the rolling of ships", J. Zosen Kiokai 102, 115-122, 1957.
[Tamiya1972] S. Tamiya and T. Komura, "Topics on ship rolling characteristics with advance speed", J. Society of
    Naval Architects of Japan 132, 159-168, 1972.
[Ikeda1978] Y. Ikeda, Y. Himeno and N. Tanaka, "Components of roll damping of ship at forward speed",
    J. Society of Naval Architects of Japan 143, 113-125, 1978.
[Himeno1981] Y. Himeno, "Prediction of ship roll damping: state of the art", University of Michigan,
    Department of Naval Architecture and Marine Engineering, report 239, 1981.
"""

import numpy as np
import xarray as xr

from workbench.conventions import encounter_frequency
from workbench.damping.normal_flow import force_set
from workbench.design import Hull, MassProperties
from workbench.errors import InputError, checked_number
from workbench.geometry.sections import sections

VISCOSITY = 1.19e-6
"""Kinematic viscosity of sea water at 15 degrees Celsius, ITTC [m2/s]."""


def friction_damping(
    length: float,
    beam: float,
    draught: float,
    block_coefficient: float,
    centre_depth: float,
    frequency,
    speed: float,
    density: float,
    viscosity: float = VISCOSITY,
):
    """Roll damping by friction in laminar flow, with speed [kg m2/s].

    0.787 rho S r**2 sqrt(omega nu) (1 + 4.1 U / (omega L)), with S = L (1.7 T + C_B B) and
    r = ((0.887 + 0.145 C_B) S / L - 2 OG) / pi [Kato1957]_ [Tamiya1972]_ [Himeno1981]_.

    Parameters
    ----------
    centre_depth : OG, of the centre of gravity below still water [m]; negative above.
    frequency : of roll [rad/s].
    """
    surface = length * (1.7 * draught + block_coefficient * beam)
    radius = ((0.887 + 0.145 * block_coefficient) * surface / length - 2 * centre_depth) / np.pi
    omega = np.maximum(np.abs(frequency), 1e-3)
    at_rest = 0.787 * density * surface * radius**2 * np.sqrt(omega * viscosity)
    return at_rest * (1 + 4.1 * speed / (omega * length))


def lift_damping(
    length: float,
    beam: float,
    draught: float,
    midship_coefficient: float,
    centre_depth: float,
    speed: float,
    density: float,
) -> float:
    """Roll damping by the lift of the hull at speed [kg m2/s].

    rho U L T k l0 lR (1 - 1.4 OG / lR + 0.7 OG**2 / (l0 lR)) / 2, with l0 = 0.3 T, lR = 0.5 T and
    k = 2 pi T / L + kappa (4.1 B / L - 0.045), kappa 0, 0.1 or 0.3 for midship coefficients up to
    0.92, up to 0.97, and above [Ikeda1978]_ [Himeno1981]_.
    """
    kappa = 0.0 if midship_coefficient <= 0.92 else 0.1 if midship_coefficient <= 0.97 else 0.3
    slope = 2 * np.pi * draught / length + kappa * (4.1 * beam / length - 0.045)
    low, high = 0.3 * draught, 0.5 * draught
    lever = 1 - 1.4 * centre_depth / high + 0.7 * centre_depth**2 / (low * high)
    return float(0.5 * density * speed * length * draught * slope * low * high * lever)


def hull_roll_damping(
    hull: Hull,
    masses: MassProperties,
    density: float,
    speed: float,
    omega,
    wave_directions,
    viscosity: float = VISCOSITY,
) -> xr.Dataset:
    """Roll damping of a single hull by friction and lift, about the origin.

    Dataset with ``damping`` (omega, wave_direction, influenced_dof, radiating_dof), of a roll about
    the centre of gravity.

    Notes
    -----
    Fitted to conventional single hulls. Eddies and bilge keels are not in it. Hulls side by side roll by
    moving up and down: they are damped by `cross_flow` and by radiation, and are refused here.
    """
    if hull.count != 1:
        raise InputError(
            f"friction and lift damping of roll need a single hull, got {hull.count}; use cross_flow for hulls "
            "side by side."
        )
    checked_number("density of the water", density, "kg/m3", above=0.0)
    part = sections(hull)[0]
    length, beam, draught = np.ptp(part.x), part.beams.max(), part.draughts.max()
    block = np.trapezoid(part.areas, part.x) / (length * beam * draught)
    fullest = int(np.argmax(part.areas))
    midship = part.areas[fullest] / (part.beams[fullest] * part.draughts[fullest])
    omega, directions = np.atleast_1d(omega).astype(float), np.atleast_1d(wave_directions).astype(float)
    met = encounter_frequency(omega[:, None], speed, directions)
    depth = -masses.centre_of_gravity[2]
    about_centre = friction_damping(
        length, beam, draught, block, depth, met, speed, density, viscosity
    ) + lift_damping(length, beam, draught, midship, depth, speed, density)
    y, z = masses.centre_of_gravity[1:]
    # Only roll about the axis through the centre of gravity turns the hull; it is the same rotation in all axes,
    # and a moment without a force, so the matrix about the origin is the same.
    damping = np.zeros((*met.shape, 6, 6))
    damping[..., 3, 3] = about_centre
    return force_set(
        omega, directions, method="roll friction and lift", damping=damping,
        attrs={"speed": float(speed), "density": float(density), "roll_axis": [float(y), float(z)]},
    )  # fmt: skip
