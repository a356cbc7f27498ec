"""Hydrostatics of the ship as it floats, and whether its masses balance them."""

from functools import lru_cache

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import GRAVITY, MODES, SEAWATER_DENSITY
from workbench.design import Hull, MassProperties
from workbench.errors import InputError
from workbench.geometry.panels import hull_panels, hull_shape, panels

FINE_COUNT = 12_000
"""Number of panels of the whole ship from which hydrostatics are taken."""

WARNED_MASS_MISMATCH = 0.01
WARNED_CENTRE_MISMATCH = 0.005
REFUSED_MASS_MISMATCH = 0.25


def hydrostatics(
    hull: Hull, density: float = SEAWATER_DENSITY, centre_of_gravity_height: float | None = None
) -> xr.Dataset:
    """Volume, centres, waterplane, wetted surface and metacentric heights of the ship as it floats.

    Parameters
    ----------
    hull : hulls and attitude.
    density : of the water [kg/m3].
    centre_of_gravity_height : z_G above still water [m] for the metacentric heights; where not
        given, these are measured from the waterline.

    Returns
    -------
    Dataset with ``volume`` [m3], ``displacement`` [kg], ``centre_of_buoyancy`` (axis) [m],
    ``centre_of_flotation`` (axis: x, y) [m], ``waterplane_area`` and ``wetted_surface`` (with wetted
    transoms) [m2], ``transverse_metacentric_height`` and ``longitudinal_metacentric_height`` [m],
    ``block_coefficient`` of the (outer) hull on its length, beam and draught, and
    ``hydrostatic_stiffness`` (influenced_dof, radiating_dof) of a ship whose weight balances its
    buoyancy, about the origin.
    """
    height = 0.0 if centre_of_gravity_height is None else float(centre_of_gravity_height)
    moments = _moments(hull)
    volume, centre = moments["volume"], moments["centre_of_buoyancy"]
    area, x_f, y_f = moments["area"], moments["x"], moments["y"]
    transverse = (moments["yy"] - area * y_f**2) / volume + centre[2] - height
    longitudinal = (moments["xx"] - area * x_f**2) / volume + centre[2] - height
    return quantities.dataset(
        coords={
            "axis": ["x", "y", "z"],
            "influenced_dof": list(MODES),
            "radiating_dof": list(MODES),
        },
        method="closed integrals over panels",
        volume=volume,
        displacement=density * volume,
        waterplane_area=area,
        wetted_surface=moments["wetted"],
        centre_of_buoyancy=("axis", centre),
        centre_of_flotation=("axis", np.array([x_f, y_f, 0.0])),
        transverse_metacentric_height=transverse,
        longitudinal_metacentric_height=longitudinal,
        block_coefficient=block_coefficient(hull),
        hydrostatic_stiffness=(
            ("influenced_dof", "radiating_dof"),
            _stiffness(moments, density, density * volume, np.array([*centre[:2], height])),
        ),
    )


def stiffness_matrix(
    hull: Hull, masses: MassProperties, density: float = SEAWATER_DENSITY, fine_count: int = FINE_COUNT
) -> np.ndarray:
    """Hydrostatic stiffness (6, 6) about the origin [N/m, N, N m], in the order of `MODES`.

    C33 = rho g A, C34 = rho g A y_F, C35 = -rho g A x_F, C44 = rho g (I_yy + V z_B) - m g z_G,
    C55 = rho g (I_xx + V z_B) - m g z_G, C45 = -rho g I_xy, C46 = -rho g V x_B + m g x_G and
    C56 = -rho g V y_B + m g y_G, the last two zero when weight balances buoyancy.
    """
    return _stiffness(_moments(hull, fine_count), density, masses.mass, np.array(masses.centre_of_gravity))


def block_coefficient(hull: Hull) -> float:
    """Block coefficient of the (outer) hull, volume / (length beam draught) [-], upright at its draught."""
    shape = hull_shape(hull, 0)
    volume = hull_panels(Hull(shape=shape), 0, FINE_COUNT // 2).volume
    return volume / (shape.length * shape.beam * shape.draught)


def equilibrium(
    hull: Hull, masses: MassProperties, density: float = SEAWATER_DENSITY, *, may_capsize: bool = False
) -> tuple[str, ...]:
    """Sentences of warning where the masses do not balance the hydrostatics; `InputError` where hopeless.

    Warned: weight and displacement differ by more than 1 %, or the longitudinal
    centres of gravity and buoyancy by more than 0.5 % of the length. Refused:
    more than 25 %, or a metacentric height that is not positive (the transverse one may be
    with ``may_capsize``: a ship whose roll is held, such as one that flies a hull).
    """
    floating = hydrostatics(hull, density, masses.centre_of_gravity[2])
    displacement = float(floating.displacement)
    excess = masses.mass / displacement - 1.0
    if abs(excess) > REFUSED_MASS_MISMATCH:
        raise InputError(
            f"mass must be within 25 % of the displacement of the hulls ({displacement:.4g} kg), got "
            f"{masses.mass:.4g} kg; change the mass, the draught or the hull."
        )
    for name in ("longitudinal",) if may_capsize else ("transverse", "longitudinal"):
        metacentric = float(floating[f"{name}_metacentric_height"])
        if metacentric <= 0.0:
            highest = masses.centre_of_gravity[2] + metacentric
            raise InputError(
                f"height of the centre of gravity must be < {highest:.4g} m, the {name} metacentre above "
                f"still water, got {masses.centre_of_gravity[2]:.4g} m; lower it or widen the ship."
            )
    warnings = []
    side = "above" if excess > 0.0 else "below"
    if abs(excess) > WARNED_MASS_MISMATCH:
        warnings.append(
            f"mass {masses.mass:.4g} kg is {100 * abs(excess):.1f} % {side} "
            f"the displacement {displacement:.4g} kg of the hulls; the ship would float at another draught."
        )
    x_g, x_b = masses.centre_of_gravity[0], float(floating.centre_of_buoyancy[0])
    side = "forward" if x_g > x_b else "aft"
    if abs(x_g - x_b) > WARNED_CENTRE_MISMATCH * hull.length:
        warnings.append(
            f"centre of gravity x = {x_g:.4g} m is {abs(x_g - x_b):.3g} m {side} "
            f"of the centre of buoyancy x = {x_b:.4g} m; the ship would float at another trim."
        )
    return tuple(warnings)


@lru_cache(maxsize=16)
def _moments(hull: Hull, fine_count: int = FINE_COUNT) -> dict:
    """Return volume, centre of buoyancy, waterplane area, centre and moments of the whole ship."""
    wetted = panels(hull, fine_count)
    both = 2.0 if wetted.mirrored else 1.0
    along = 0.0 if wetted.mirrored else 1.0  # odd moments in y vanish by symmetry
    volume = wetted.volume
    area = both * wetted.moment(lambda x, y, z: np.ones_like(x))
    return {
        "volume": volume,
        "area": area,
        "x": both * wetted.moment(lambda x, y, z: x) / area,
        "y": along * wetted.moment(lambda x, y, z: y) / area,
        "xx": both * wetted.moment(lambda x, y, z: x * x),
        "yy": both * wetted.moment(lambda x, y, z: y * y),
        "xy": along * wetted.moment(lambda x, y, z: x * y),
        "wetted": both * float(wetted.areas.sum()),
        "centre_of_buoyancy": np.array(
            [
                both * wetted.moment(lambda x, y, z: -z * x) / volume,
                along * wetted.moment(lambda x, y, z: -z * y) / volume,
                both * wetted.moment(lambda x, y, z: -z * z / 2) / volume,
            ]
        ),
    }


def _stiffness(moments: dict, density: float, mass: float, centre_of_gravity: np.ndarray) -> np.ndarray:
    """Return the stiffness matrix of `stiffness_matrix` from the moments of the waterplane."""
    x_b, y_b, z_b = moments["centre_of_buoyancy"]
    x_g, y_g, z_g = centre_of_gravity
    area, volume = moments["area"], moments["volume"]
    stiffness = np.zeros((6, 6))
    stiffness[2, 2] = area
    stiffness[2, 3] = stiffness[3, 2] = area * moments["y"]
    stiffness[2, 4] = stiffness[4, 2] = -area * moments["x"]
    stiffness[3, 4] = stiffness[4, 3] = -moments["xy"]
    stiffness[3, 3] = moments["yy"] + volume * z_b - mass / density * z_g
    stiffness[4, 4] = moments["xx"] + volume * z_b - mass / density * z_g
    stiffness[3, 5] = -volume * x_b + mass / density * x_g
    stiffness[4, 5] = -volume * y_b + mass / density * y_g
    return density * GRAVITY * stiffness


def longitudinal_stiffness_about(stiffness: np.ndarray, x: float) -> np.ndarray:
    """Heave-pitch stiffness (2, 2) about the point (x, 0, 0) from a matrix (6, 6) about the origin.

    Heave at x is xi3 - x xi5, hence C35' = C35 + x C33 and C55' = C55 + 2 x C35 + x**2 C33.
    """
    c33, c35, c55 = stiffness[2, 2], stiffness[2, 4], stiffness[4, 4]
    coupling = c35 + x * c33
    return np.array([[c33, coupling], [coupling, c55 + 2 * x * c35 + x**2 * c33]])
