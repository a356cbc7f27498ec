"""Added mass, damping and wave forces at speed, from the radiation potentials of hulls at rest.

Speed enters as in strip theory, but on three-dimensional potentials: `speed_terms`.
Diffraction forces follow from the radiation potentials by Haskind's relation, so
that waves, headings and speeds cost sums over panels and no matrix::

    F0_jk = -rho omega_e^2 int phi_k n_j,  t_jk = -rho omega_e^2 line integral of phi_k n_j at the transom

with unit-velocity potentials phi_k and outward normals.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from workbench.conventions import GRAVITY, encounter_frequency, wavenumber
from workbench.hydrodynamics.coefficients import coefficient_set
from workbench.hydrodynamics.incident_wave import incident_normal_velocity, incident_potential
from workbench.hydrodynamics.potential_flow import refuse_overtaken_waves
from workbench.hydrodynamics.radiation import SYMMETRIC_MODES, mode_normals
from workbench.hydrodynamics.speed_terms import VENTILATION_FROUDE_NUMBER, force_with_speed, with_speed


class RadiatingBody(NamedTuple):
    """Potentials of one independent set of panels, and where its own origin stands in the ship [m]."""

    radiation: xr.Dataset
    x: float = 0.0
    y: float = 0.0


def at_encounter_frequency(nodes: np.ndarray, values: np.ndarray, frequency: np.ndarray) -> np.ndarray:
    """Values (..., first axis frequency) at other frequencies.

    Parameters
    ----------
    nodes : increasing frequencies [rad/s], the last infinite.
    values : (len(nodes), ...) complex.
    frequency : wanted frequencies [rad/s].

    Notes
    -----
    Cubic splines between the finite nodes, exact at them; constant below the
    first; above the last finite node the approach to the infinite-frequency
    value as 1/frequency**2.
    """
    finite = nodes[:-1]
    inside = np.clip(frequency, finite[0], finite[-1])
    if len(finite) == 1:
        found = np.repeat(values[:1], len(frequency), axis=0)
    elif np.all(np.isin(inside, finite)):
        found = values[np.searchsorted(finite, inside)]
    else:
        found = CubicSpline(finite, values[:-1], axis=0)(inside)
    above = (finite[-1] / np.maximum(frequency, finite[-1])) ** 2
    above = above.reshape(-1, *([1] * (values.ndim - 1)))
    return values[-1] + (found - values[-1]) * above


def transom_draught(body: RadiatingBody) -> float:
    """Depth of the deepest transom panel centre [m]; 0 without a transom."""
    radiation = body.radiation
    depths = -radiation.panel_centre.sel(axis="z").values[radiation.panel_is_transom.values == 1]
    return float(depths.max()) if depths.size else 0.0


def transom_is_dry(body: RadiatingBody, speed: float) -> bool:
    """Whether the flow leaves the transom dry: U/sqrt(g T) above `VENTILATION_FROUDE_NUMBER`."""
    draught = transom_draught(body)
    return draught > 0 and speed > VENTILATION_FROUDE_NUMBER * np.sqrt(GRAVITY * draught)


def body_coefficients(
    body: RadiatingBody, omega: np.ndarray, wave_directions: np.ndarray, speed: float, density: float
) -> dict[str, np.ndarray]:
    """Coefficients and forces of one body about its own origin, for a wave with its crest there.

    Returns arrays over (omega, wave_direction): ``radiation`` complex force per
    unit motion omega_e^2 A + i omega_e B, ``froude_krylov`` and ``diffraction``.
    """
    radiation = body.radiation
    mirrored = bool(radiation.attrs["mirrored"])
    centres, normals = radiation.panel_centre.values, radiation.panel_normal.values
    modes = mode_normals(centres, normals)
    weights = radiation.panel_area.values * (2.0 if mirrored else 1.0)
    shape = (len(omega), len(wave_directions))
    encounter = encounter_frequency(omega[:, None], speed, wave_directions[None, :])
    flat = encounter.ravel()
    distinct, back = np.unique(flat, return_inverse=True)
    potential = at_encounter_frequency(
        radiation.encounter_omega.values, radiation.radiation_potential.values, distinct
    )

    same_parity = np.ones((6, 6))
    if mirrored:
        symmetric = np.isin(range(6), SYMMETRIC_MODES)
        same_parity = (symmetric[:, None] == symmetric[None, :]).astype(float)
    at_rest = np.einsum("fkp,jp->fjk", potential, modes * weights, optimize=True) * same_parity
    girths = _transom_girths(radiation) * (2.0 if mirrored else 1.0) * transom_is_dry(body, speed)
    last = np.flatnonzero(girths)
    line = (
        np.einsum("fkp,jp->fjk", potential[:, :, last], (modes * girths)[:, last], optimize=True)
        * same_parity
    )
    scale = -density * distinct[:, None, None] ** 2
    ratio = speed / (1j * distinct)
    force = with_speed(scale * at_rest, scale * line, ratio)[back].reshape(*shape, 6, 6)

    back = back.reshape(shape)
    froude_krylov = np.zeros((*shape, 6), complex)
    diffraction = np.zeros((*shape, 6), complex)
    weighted_modes = modes * weights
    for i, frequency in enumerate(omega):
        wave, velocity = _waves_by_parity(centres, normals, frequency, wave_directions, mirrored)
        froude_krylov[i] = -1j * density * frequency * np.einsum("jp,jbp->bj", weighted_modes, wave)
        own, met = potential[back[i]], 1j * density * encounter[i, :, None]
        diffracted = met * np.einsum("bjp,jbp->bj", own * weights, velocity)
        end = met * np.einsum("bjp,jbp->bj", own[..., last] * girths[last], velocity[..., last])
        diffraction[i] = force_with_speed(diffracted, end, speed / (1j * encounter[i]))
    return {
        "encounter": encounter,
        "radiation": force,
        "froude_krylov": froude_krylov,
        "diffraction": diffraction,
    }


def _waves_by_parity(
    centres: np.ndarray, normals: np.ndarray, omega: float, wave_directions: np.ndarray, mirrored: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Incident potential and normal velocity (6, wave_direction, panel): the part that each mode feels."""
    wave = incident_potential(centres, omega, wave_directions)
    velocity = incident_normal_velocity(centres, normals, omega, wave_directions)
    if not mirrored:
        return np.broadcast_to(wave, (6, *wave.shape)), np.broadcast_to(velocity, (6, *wave.shape))
    mirror = np.array([1.0, -1.0, 1.0])
    parity = np.where(np.isin(range(6), SYMMETRIC_MODES), 1.0, -1.0)[:, None, None]
    other_wave = incident_potential(centres * mirror, omega, wave_directions)
    other = incident_normal_velocity(centres * mirror, normals * mirror, omega, wave_directions)
    return (wave + parity * other_wave) / 2, (velocity + parity * other) / 2


def _transom_girths(radiation: xr.Dataset) -> np.ndarray:
    """Girth [m] that each wetted panel next to the transom covers of its edge; 0 for all other panels."""
    x = radiation.panel_centre.sel(axis="x").values
    hull = radiation.panel_is_transom.values == 0
    nearest = x[hull].min()
    half_length = nearest - radiation.attrs["transom_end"]
    last = hull & (x < nearest + 0.5 * half_length)
    across = np.hypot(*radiation.panel_normal.values[:, 1:].T)
    return np.where(last, radiation.panel_area.values * across / (2 * half_length), 0.0)


def hydrodynamics(
    bodies: Sequence[RadiatingBody],
    omega: Sequence[float],
    wave_directions: Sequence[float],
    speed: float,
    density: float,
    *,
    method: str = "potential-flow",
    warnings: Sequence[str] = (),
) -> xr.Dataset:
    """Added mass, damping and wave forces of a ship at speed, about the origin.

    Parameters
    ----------
    bodies : one body (all hulls together, with interaction) or several (hulls
        that do not feel each other).
    omega : wave frequencies [rad/s]; wave_directions : [rad]; speed : [m/s]; density : [kg/m3].
    method, warnings : go into the attributes of the result.

    Returns
    -------
    Dataset over (omega, wave_direction): ``added_mass``, ``radiation_damping``
    (influenced_dof, radiating_dof), ``excitation_force`` with its parts
    ``froude_krylov_force`` and ``diffraction_force``, ``encounter_frequency``,
    ``wavenumber``.

    Raises
    ------
    InputError where the ship overtakes the waves.

    Notes
    -----
    Valid for slender hulls and Fn below about 0.2, a rough guide above. Costs
    some milliseconds per hundred waves and hull.
    """
    omega = np.asarray(omega, float)
    directions = np.asarray(wave_directions, float)
    refuse_overtaken_waves(omega, directions, speed)
    encounter = encounter_frequency(omega[:, None], speed, directions[None, :])
    radiation = np.zeros((len(omega), len(directions), 6, 6), complex)
    froude_krylov = np.zeros((len(omega), len(directions), 6), complex)
    diffraction = np.zeros_like(froude_krylov)
    k = wavenumber(omega)[:, None]
    computed: dict[int, dict[str, np.ndarray]] = {}
    for body in bodies:
        key = id(body.radiation)
        if key not in computed:
            computed[key] = body_coefficients(body, omega, directions, speed, density)
        own = computed[key]
        shift = np.eye(6)  # motions of the body's origin from motions of the ship's
        shift[1, 5], shift[2, 4], shift[0, 5], shift[2, 3] = body.x, -body.x, -body.y, body.y
        phase = np.exp(1j * k * (body.x * np.cos(directions) + body.y * np.sin(directions)))[..., None]
        radiation += np.einsum("ja,fbjk,kc->fbac", shift, own["radiation"], shift)
        froude_krylov += phase * (own["froude_krylov"] @ shift)
        diffraction += phase * (own["diffraction"] @ shift)

    return coefficient_set(
        omega,
        directions,
        speed,
        density,
        added_mass=radiation.real / encounter[..., None, None] ** 2,
        radiation_damping=radiation.imag / encounter[..., None, None],
        froude_krylov_force=froude_krylov,
        diffraction_force=diffraction,
        solver=bodies[0].radiation.attrs["solver"],
        method=method,
        warnings=warnings,
    )
