"""Lift, added mass and wave force of foils and fins.

[WhickerFehlner1958] L. F. Whicker and L. F. Fehlner, "Free-stream characteristics of a family of
    low-aspect-ratio, all-movable control surfaces for application to ship design", David Taylor Model
    Basin report 933, 1958.
[Helmbold1942] H. B. Helmbold, "Der unverwundene Ellipsenflügel als tragende Fläche", Jahrbuch 1942 der
    deutschen Luftfahrtforschung, I 111-113.
[Pabst1930] W. Pabst, "Theorie des Landestoßes von Seeflugzeugen", Zeitschrift für Flugtechnik und
    Motorluftschiffahrt 21, 1930; NACA TM 624, 1931.
[HoughMoran1969] G. R. Hough and J. P. Moran, "Froude number effects on two-dimensional hydrofoils",
    J. Ship Research 13(1), 53-60, 1969.
"""

from collections.abc import Iterable
from dataclasses import asdict, dataclass

import numpy as np
import xarray as xr

from workbench.appendages import LiftingSurface
from workbench.conventions import encounter_frequency, froude_number
from workbench.damping.normal_flow import force_set, turning_rows, velocity_rows, wave_velocity
from workbench.errors import checked_choice, checked_number

LIFT_SLOPES = ("whicker-fehlner", "helmbold")
SURFACES = ("deep", "high-speed")
STRIPS = 9
"""Strips of a surface along its span."""
HIGH_CHORD_FROUDE_NUMBER = 3.0
"""From here, on the depth, the surface above a foil is taken to act as at infinite speed [-]."""
LARGEST_QUASI_STEADY = 0.3
"""Largest reduced frequency omega_e c / (2 U) not warned of [-]; ours: Theodorsen's function is 0.69 there."""


@dataclass(frozen=True, kw_only=True)
class LiftSettings:
    """Choices for foils and fins.

    Parameters
    ----------
    lift_slope : "whicker-fehlner" (measured on control surfaces) or "helmbold" (lifting-surface theory).
    free_surface : "deep": the surface does not matter; "high-speed": lift of flat foils falls near it.
    """

    lift_slope: str = "whicker-fehlner"
    free_surface: str = "deep"

    def __post_init__(self) -> None:
        checked_choice("lift_slope", self.lift_slope, LIFT_SLOPES)
        checked_choice("free_surface", self.free_surface, SURFACES)

    def as_dict(self) -> dict:
        """Return the settings as plain values."""
        return asdict(self)


def lift_slope(aspect_ratio: float, sweep: float = 0.0, formula: str = "whicker-fehlner") -> float:
    """Lift slope of a surface in a free stream [1/rad].

    Whicker and Fehlner: 1.8 pi a / (cos L sqrt(a**2 / cos(L)**4 + 4) + 1.8), measured for
    aspect ratios a of 0.5 to 3 [WhickerFehlner1958]_. Helmbold: 2 pi a / (2 + sqrt(a**2 + 4)),
    which goes to Jones's pi a / 2 and to 2 pi at its ends; without sweep [Helmbold1942]_.
    """
    if formula == "helmbold":
        return 2 * np.pi * aspect_ratio / (2 + np.hypot(aspect_ratio, 2.0))
    cosine = np.cos(sweep)
    return 1.8 * np.pi * aspect_ratio / (cosine * np.hypot(aspect_ratio / cosine**2, 2.0) + 1.8)


def submergence_factor(depth_over_chord: float) -> float:
    """Lift slope near the surface at high speed over that in deep water [-], (1 + 16 h**2) / (2 + 16 h**2).

    Two-dimensional, at infinite Froude number on the depth; a half at the surface [HoughMoran1969]_.
    """
    squared = 16 * depth_over_chord**2
    return (1 + squared) / (2 + squared)


def plate_added_mass(chord, span, density: float):
    """Added mass of rectangular plates that move broadside in unbounded water [kg], of sides [m] of any common shape.

    rho pi/4 c**2 b (1 + e**2)**-0.5 (1 - 0.425 e / (1 + e**2)), e the shorter side over the
    longer, c the shorter and b the longer [Pabst1930]_.
    """
    short, long = np.minimum(chord, span), np.maximum(chord, span)
    ratio = short / long
    share = (1 - 0.425 * ratio / (1 + ratio**2)) / np.sqrt(1 + ratio**2)
    return density * np.pi / 4 * short**2 * long * share


def surface_lift_slope(surface: LiftingSurface, settings: LiftSettings) -> float:
    """Lift slope of a foil or fin of a ship [1/rad], its own where it is given."""
    slope = surface.lift_slope
    if slope is None:
        slope = lift_slope(surface.aspect_ratio, surface.sweep, settings.lift_slope)
    flat = abs(surface.cant) < np.pi / 4 and surface.images == 1
    if settings.free_surface == "high-speed" and flat:
        slope = slope * submergence_factor(-surface.position[2] / surface.chord)
    return float(slope)


def strips(surface: LiftingSurface) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points (n, 3), normals (n, 3) and shares (n,) of the strips of one surface along its span.

    The lift is spread elliptically, a fin's as half of the span doubled by the hull:
    Gauss-Chebyshev points of the second kind, for which this is exact.
    """
    count = STRIPS
    angles = np.arange(1, count + 1) * np.pi / (count + 1)
    along, shares = np.cos(angles) / 2, np.sin(angles) ** 2
    span_vector = surface.span * np.array([0.0, np.cos(surface.cant), np.sin(surface.cant)])
    normal = np.array([0.0, -np.sin(surface.cant), np.cos(surface.cant)])
    points = np.asarray(surface.position) + along[:, None] * span_vector
    return points, np.tile(normal, (count, 1)), shares / shares.sum()


def foil_forces(
    foils: Iterable[LiftingSurface],
    density: float,
    speed: float,
    omega,
    wave_directions,
    settings: LiftSettings | None = None,
) -> xr.Dataset:
    """Forces of foils and fins on the ship: matrices about the origin, and force per wave amplitude.

    With the flow q through the surface (`normal_flow`), the force along its normal is
    -(rho U S C_La / 2) q for lift and -A_n dq/dt for added mass, hence::

        A = A_n g g'    B = L g g' + A_n U g h'    C = L U g h'    F = (L - i omega_e A_n) (n . v) g

    L = rho U S C_La / 2. A flat foil forward takes stiffness from pitch, one aft gives it.

    Parameters
    ----------
    foils : of the ship; density : of the water [kg/m3]; speed : [m/s].
    omega : (omega,) [rad/s]; wave_directions : (wave_direction,) [rad].

    Returns
    -------
    Dataset: ``added_mass``, ``damping``, ``stiffness`` (influenced_dof, radiating_dof) and
    ``excitation_force`` (omega, wave_direction, influenced_dof).

    Notes
    -----
    Quasi-steady and linear: no stall (some 15 degrees), no ventilation, no lag of the wake, no
    downwash of one surface on another; the hull only as a mirror for fins; the waves undisturbed.
    """
    settings = settings or LiftSettings()
    density = checked_number("density of the water", density, "kg/m3", above=0.0)
    speed = checked_number("speed", speed, "m/s", at_least=0.0, at_most=60.0)
    omega, directions = np.atleast_1d(omega).astype(float), np.atleast_1d(wave_directions).astype(float)
    met = encounter_frequency(omega[:, None], speed, directions)
    added, damping, stiffness = np.zeros((6, 6)), np.zeros((6, 6)), np.zeros((6, 6))
    force = np.zeros((len(omega), len(directions), 6), complex)
    given = tuple(foils)
    for surface in (one for foil in given for one in foil.placed()):
        points, normals, shares = strips(surface)
        moved, turned = velocity_rows(points, normals), turning_rows(normals)
        lift = 0.5 * density * speed * surface.area * surface_lift_slope(surface, settings)
        mass = plate_added_mass(surface.chord, surface.images * surface.span, density) / surface.images
        by_velocity = np.einsum("n,nj,nk->jk", shares, moved, moved)
        by_turning = speed * np.einsum("n,nj,nk->jk", shares, moved, turned)
        added += mass * by_velocity
        damping += lift * by_velocity + mass * by_turning
        stiffness += lift * by_turning
        across = wave_velocity(points, normals, omega, directions)
        force += (lift - 1j * met * mass)[..., None] * np.einsum("fbn,n,nj->fbj", across, shares, moved)
    return force_set(
        omega, directions, method="lifting surfaces", excitation_force=force, added_mass=added,
        damping=damping, stiffness=stiffness, warnings=_warnings(given, speed, met, settings),
        attrs={"speed": speed, "density": density, **settings.as_dict()},
    )  # fmt: skip


def _warnings(
    foils: tuple[LiftingSurface, ...], speed: float, met: np.ndarray, settings: LiftSettings
) -> Iterable[str]:
    """Say where the surfaces leave the range of the formulas."""
    for foil in foils:
        reduced = float(np.abs(met).max()) * foil.chord / (2 * speed) if speed else np.inf
        if np.isfinite(reduced) and reduced > LARGEST_QUASI_STEADY:
            yield (
                f"Lift of {foil.name} is quasi-steady; its reduced frequency goes to {reduced:.2f}, where the wake "
                "lags and the lift is smaller."
            )
        depth = -foil.position[2]
        if settings.free_surface == "high-speed" and froude_number(speed, depth) < HIGH_CHORD_FROUDE_NUMBER:
            yield (
                f"Lift of {foil.name} near the surface is that of infinite speed; its Froude number on the depth is "
                f"{froude_number(speed, depth):.1f}."
            )
