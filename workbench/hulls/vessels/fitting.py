"""Figures that make a ship float as it should: draughts, block coefficients and masses."""

from workbench.design import MassProperties


def block_coefficient(
    mass: float, length: float, beam: float, draught: float, hulls: int, density: float
) -> float:
    """Block coefficient [-] at which so many hulls carry the mass [kg]."""
    return mass / (density * hulls * length * beam * draught)


def draught(
    mass: float, length: float, beam: float, block_coefficient: float, hulls: int, density: float
) -> float:
    """Draught [m] at which so many hulls carry the mass [kg]."""
    return mass / (density * hulls * length * beam * block_coefficient)


def balanced_masses(
    mass: float, x: float, z: float, *, gyradii: tuple[float, float, float], roll_damping_ratio: float = 0.05
) -> MassProperties:
    """Masses with the centre of gravity at (x, 0, z) [m] and gyradii (roll, pitch, yaw) [m]."""
    roll, pitch, yaw = gyradii
    return MassProperties(
        mass=mass,
        centre_of_gravity=(x, 0.0, z),
        roll_gyradius=roll,
        pitch_gyradius=pitch,
        yaw_gyradius=yaw,
        roll_damping_ratio=roll_damping_ratio,
    )
