"""Radiation forces in time: retardation functions that reproduce given added mass and damping.

The force of a motion is ``-A x'' - B x' - C x - int_0^T K(s) x'(t - s) ds``
[Cummins1962]_, whose frequency response (exp(-i omega t), per unit motion) is
``omega^2 A + i omega (B + K(omega)) - C`` with ``K(omega) = int K(t) exp(i omega t) dt``
[Ogilvie1964]_. The coefficients of a ship at speed carry terms such as
``U/omega^2 B33`` and ``U^2/omega^2 A33``, whose limits are a constant damping and
a constant stiffness. A kernel taken from the damping alone by the cosine transform
misses what lies beyond the computed frequencies, and does not know these limits.
Here constants and kernel are found together, by least squares on added mass *and*
damping; the kernel begins at t = 0, so that what is found is causal.

.. [Cummins1962] W. E. Cummins, "The impulse response function and ship motions",
    Schiffstechnik 9, 101-109, 1962.
.. [Ogilvie1964] T. F. Ogilvie, "Recent progress toward the understanding and prediction of
    ship motions", 5th Symp. on Naval Hydrodynamics, Bergen, 1964.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr

from workbench.conventions import GRAVITY
from workbench.errors import InputError

MEMORY = 8.0
"""Length of the memory in units of sqrt(L/g) [-]: 21 s for a ship of 70 m."""

KNOTS = 80
HIGHEST = 20.0
"""Highest encounter frequency that is fitted, times sqrt(L/g) [-]."""

_RESTORING = 3.0
"""Frequency, times sqrt(L/g), below which forces are weighed as a stiffness, above as a mass [-]."""

_SMOOTHNESS, _SIZE = 1e-2, 1e-2


@dataclass(frozen=True, eq=False)
class RadiationOperator:
    """Radiation force of n motions in time.

    Parameters
    ----------
    added_mass, damping, stiffness : (n, n), constant.
    kernel : (times, n, n) retardation functions at multiples of the time step.
    time_step : [s].
    """

    added_mass: np.ndarray
    damping: np.ndarray
    stiffness: np.ndarray
    kernel: np.ndarray
    time_step: float

    def response(self, omega) -> np.ndarray:
        """Force per unit motion at encounter frequencies [rad/s], (len(omega), n, n) complex."""
        omega = np.asarray(omega, float)
        memory = np.tensordot(_transform(omega, len(self.kernel), self.time_step), self.kernel, axes=1)
        along = omega[:, None, None]
        return along**2 * self.added_mass + 1j * along * (self.damping + memory) - self.stiffness


def _transform(omega: np.ndarray, count: int, time_step: float) -> np.ndarray:
    """Factors (len(omega), count) of the trapezoidal rule for int K(t) exp(i omega t) dt."""
    factors = time_step * np.exp(1j * omega[:, None] * time_step * np.arange(count))
    factors[:, 0] /= 2
    return factors


def radiation_forces(
    hydrodynamics: xr.Dataset, extra_damping: np.ndarray | float = 0.0, additions: Sequence[xr.Dataset] = ()
) -> tuple[np.ndarray, np.ndarray]:
    """Encounter frequencies (f,) and force per unit motion (f, 6, 6) of a coefficient set, about the origin.

    Each frequency once, in rising order, from all headings.

    Parameters
    ----------
    hydrodynamics : from any method.
    extra_damping : (omega, wave_direction, 6, 6), added to the radiation damping.
    additions : Datasets with any of ``added_mass``, ``damping`` and ``stiffness``, for the same waves
        where they depend on them.
    """
    encounter = hydrodynamics.encounter_frequency.values
    along = encounter[..., None, None]
    force = along**2 * hydrodynamics.added_mass.values
    force = force + 1j * along * (hydrodynamics.radiation_damping.values + extra_damping)
    for one in additions:
        for name, factor in (("added_mass", along**2), ("damping", 1j * along), ("stiffness", -1.0)):
            if name in one:
                part, _ = xr.broadcast(one[name], hydrodynamics.added_mass)
                force = force + factor * part.transpose(*hydrodynamics.added_mass.dims).values
    _, first = np.unique(np.round(encounter.ravel(), 9), return_index=True)
    return encounter.ravel()[first], force.reshape(-1, 6, 6)[first]


def fitted_operator(
    omega: np.ndarray, force: np.ndarray, length: float, time_step: float, at_rest: bool
) -> RadiationOperator:
    """Constants and retardation functions that reproduce radiation forces over frequency.

    Parameters
    ----------
    omega : encounter frequencies [rad/s], > 0, rising.
    force : (len(omega), n, n) complex, per unit motion: omega^2 A + i omega B.
    length : of the ship [m], for the time scale sqrt(L/g).
    time_step : of the simulation [s].
    at_rest : whether the ship has no speed and no other additions; then there is no constant damping or stiffness.

    Notes
    -----
    The kernel is piecewise linear between `KNOTS` knots over `MEMORY` sqrt(L/g) and
    ends in zero; its curvature and size are penalised where the data leave them free.
    """
    scale = float(np.sqrt(length / GRAVITY))
    kept = (omega > 0) & (omega * scale <= HIGHEST)
    omega, force = omega[kept], force[kept]
    times = _times(MEMORY * scale, time_step)
    knots = np.linspace(0.0, MEMORY * scale, KNOTS + 1)
    hats = np.stack([np.interp(times, knots, row) for row in np.eye(KNOTS + 1)[:-1]], axis=1)
    memory = 1j * omega[:, None] * (_transform(omega, len(times), time_step) @ hats)
    constants = _constants(omega, scale, 1 if at_rest else 3)
    bend = np.diff(np.eye(KNOTS + 1), 2, axis=0)[:, :-1]
    held = np.concatenate([_SMOOTHNESS * bend, _SIZE * np.eye(KNOTS)])
    held = np.concatenate([np.zeros((len(held), constants.shape[1])), held], axis=1)
    found = _least_squares(np.concatenate([constants, memory], axis=1), force, omega * scale, held)
    parts = _scaled(found[: constants.shape[1]], scale)
    kernel = np.tensordot(hats, found[constants.shape[1] :], axes=1)
    return RadiationOperator(*parts, kernel=kernel, time_step=float(time_step))


def passive_operator(
    omega: np.ndarray, force: np.ndarray, length: float, time_step: float, at_rest: bool
) -> RadiationOperator:
    """Constants and retardation functions that never feed energy into a motion.

    For coefficients that ring longer than the memory, such as those of twin hulls at
    rest with undamped resonance of the water between them. The kernel is the cosine
    transform of the symmetric part of the damping, without negative eigenvalues, under
    a triangular window over twice `MEMORY`: its spectrum is the damping smoothed by
    Fejer's positive kernel. Added mass, and at speed a gyroscopic damping and a
    stiffness, are constants found by least squares. Parameters as `fitted_operator`.
    """
    scale = float(np.sqrt(length / GRAVITY))
    kept = (omega > 0) & (omega * scale <= HIGHEST)
    omega, force = omega[kept], force[kept]
    damping = force.imag / omega[:, None, None]
    size, axes = np.linalg.eigh((damping + np.swapaxes(damping, 1, 2)) / 2)
    damping = np.einsum("fij,fj,fkj->fik", axes, np.maximum(size, 0.0), axes)
    times = _times(2 * MEMORY * scale, time_step)
    dense = np.linspace(0.0, 2 * omega[-1], 2000)
    beyond = np.minimum(1.0, np.maximum(omega[-1], 1e-9) / np.maximum(dense, omega[-1])) ** 3
    own = np.stack([np.interp(dense, omega, column) for column in damping.reshape(len(omega), -1).T], axis=1)
    own = own * (np.minimum(1.0, dense / omega[0]) * beyond)[:, None]
    step = dense[1] - dense[0]
    kernel = 2 / np.pi * step * np.cos(np.multiply.outer(times, dense)) @ own
    kernel = (kernel * (1 - times / times[-1])[:, None]).reshape(-1, *damping.shape[1:])
    memory = np.tensordot(_transform(omega, len(times), time_step), kernel, axes=1)
    left = force - 1j * omega[:, None, None] * memory
    constants = _constants(omega, scale, 1 if at_rest else 3)
    held = np.zeros((0, constants.shape[1]))
    added, gyroscopic, stiffness = _scaled(_least_squares(constants, left, omega * scale, held), scale)
    gyroscopic = (gyroscopic - gyroscopic.T) / 2
    return RadiationOperator(added, gyroscopic, stiffness, kernel=kernel, time_step=float(time_step))


def unstable_motions(operator: RadiationOperator, mass: np.ndarray, stiffness: np.ndarray) -> int:
    """Number of growing free motions of a mass on springs with this radiation force.

    By the winding of the determinant of the equation of motion over frequency, which
    turns by -pi for each stable degree of freedom.

    Parameters
    ----------
    mass, stiffness : (n, n) of the free ship, without the operator's own.
    """
    natural = np.sqrt(np.diag(stiffness) / np.diag(mass))
    top = min(np.pi / operator.time_step, 60 * float(natural.max()))
    omega = np.geomspace(1e-3 * float(natural.min()), top, 4000)
    norm = np.sqrt(np.diag(mass))
    system = (stiffness - omega[:, None, None] ** 2 * mass - operator.response(omega)) / np.multiply.outer(
        norm, norm
    )
    turned = np.unwrap(np.angle(np.linalg.slogdet(system)[0]))
    return round((turned[-1] - turned[0]) / np.pi + len(mass))


def stable_operator(
    omega: np.ndarray,
    force: np.ndarray,
    length: float,
    time_step: float,
    at_rest: bool,
    mass: np.ndarray,
    stiffness: np.ndarray,
) -> RadiationOperator:
    """The fitted operator where the ship is stable with it, else the passive one.

    Parameters as `fitted_operator` and `unstable_motions`.
    """
    for maker in (fitted_operator, passive_operator):
        made = maker(omega, force, length, time_step, at_rest)
        if not unstable_motions(made, mass, stiffness):
            return made
    raise InputError(
        "free motions of the ship must die out, with these coefficients they grow; choose another method, a "
        "lower speed, or the linear simulation."
    )


def _times(memory: float, time_step: float) -> np.ndarray:
    """Times of a kernel from 0 to the end of the memory [s]."""
    return np.arange(int(np.ceil(memory / time_step)) + 1) * time_step


def _constants(omega: np.ndarray, scale: float, count: int) -> np.ndarray:
    """Columns of added mass, damping and stiffness, (len(omega), count)."""
    ratio = omega * scale
    return np.stack([ratio**2 + 0j, 1j * ratio, -np.ones(len(omega), complex)][:count], axis=1)


def _scaled(found: np.ndarray, scale: float) -> list[np.ndarray]:
    """Added mass, damping and stiffness from the factors of `_constants`; zero where left out."""
    powers = (scale**2, scale, 1.0)
    return [found[i] * powers[i] if i < len(found) else np.zeros_like(found[0]) for i in range(3)]


def _least_squares(columns: np.ndarray, force: np.ndarray, ratio: np.ndarray, held: np.ndarray) -> np.ndarray:
    """Real factors (:, n, n) of the columns that give the force; rows ``held`` are kept near zero."""
    weight = 1.0 / (ratio**2 + _RESTORING**2)
    columns = columns * weight[:, None]
    wanted = (force * weight[:, None, None]).reshape(len(ratio), -1)
    system = np.concatenate([columns.real, columns.imag, held])
    right = np.concatenate([wanted.real, wanted.imag, np.zeros((len(held), wanted.shape[1]))])
    return np.linalg.lstsq(system, right, rcond=None)[0].reshape(-1, *force.shape[1:])
