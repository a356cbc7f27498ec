"""The potential-flow stage of the pipeline: which panels, frequencies and headings, and what is kept on disk."""

from collections import OrderedDict
from collections.abc import Callable, Sequence

import numpy as np
import xarray as xr

from workbench import cache
from workbench.conventions import GRAVITY, MODES, encounter_frequency, wavenumber
from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.panels import Panels, hull_panels, hull_positions, lid_panels, panels, tunnel_lid
from workbench.hydrodynamics import forward_speed, potential_flow
from workbench.hydrodynamics.forward_speed import RadiatingBody
from workbench.hydrodynamics.radiation import RadiationProblem, radiation
from workbench.hydrodynamics.settings import PotentialFlowSettings, validity_warnings
from workbench import quantities

STAGE_VERSION = 1
FREQUENCIES = 48
LONGEST_WAVE, SHORTEST_WAVE = 100.0, 1 / 8
"""Longest and shortest wave of the usual frequencies, in ship lengths [-]."""

_MOST_NODES = 120
_FIELD_POINTS = (25, 7)
_memo: OrderedDict[str, xr.Dataset] = OrderedDict()
_MEMO_SIZE = 12


def usual_directions(length: float, speed: float) -> np.ndarray:
    """Wave directions 0 to 345 degrees by 15 [rad], less those in which the ship overtakes some of the waves."""
    directions = np.radians(np.arange(0, 360, 15))
    highest = np.sqrt(2 * np.pi * GRAVITY / (SHORTEST_WAVE * length))
    allowed = encounter_frequency(highest, speed, directions) > 0.02 * highest
    return directions[allowed]


def wave_frequencies(length: float, highest: float = np.inf) -> np.ndarray:
    """Usual wave frequencies [rad/s]: evenly spaced from waves of 100 ship lengths to 1/8 (or to ``highest``)."""
    top = min(np.sqrt(2 * np.pi * GRAVITY / (SHORTEST_WAVE * length)), highest)
    bottom = np.sqrt(2 * np.pi * GRAVITY / (LONGEST_WAVE * length))
    return np.linspace(bottom, top, FREQUENCIES)


def encounter_nodes(omega: np.ndarray, highest: float) -> np.ndarray:
    """Encounter frequencies at which the potentials are solved: the wave frequencies, continued to ``highest``."""
    step = omega[-1] - omega[-2]
    more = np.arange(omega[-1] + step, highest, step)
    return np.concatenate([omega, more])


def hydrodynamics(
    hull: Hull,
    density: float,
    speed: float,
    wave_directions: Sequence[float],
    omega: Sequence[float] | None,
    settings: PotentialFlowSettings,
    *,
    workers: int,
    progress: Callable[[float, str], None],
) -> tuple[xr.Dataset, xr.Dataset | None]:
    """Hydrodynamics at speed and, at rest, the scattered waves under the deck, for a hull in its attitude.

    Returns
    -------
    The Dataset of `forward_speed.hydrodynamics`, and a Dataset with
    ``radiated_elevation`` and ``diffracted_elevation`` at its omega, or None.
    """
    together = settings.interacts(hull.count, speed, hull.length)
    wetted = panels(hull, settings.panels)
    highest = potential_flow.highest_resolved_frequency(wetted)
    usual = omega is None
    omega = wave_frequencies(hull.length, highest) if usual else np.asarray(omega, float)
    directions = np.asarray(wave_directions, float)
    _check_frequencies(omega, highest, settings.panels)
    potential_flow.refuse_overtaken_waves(omega, directions, speed)
    notes = list(validity_warnings(settings, hull.count, speed, hull.length))
    met = encounter_frequency(omega[:, None], speed, directions)
    if met.max() > highest * (1 + 1e-9):
        length = 2 * np.pi * GRAVITY / highest**2
        notes.append(
            f"Waves met at more than {highest:.2f} rad/s (shorter than {length:.3g} m on the panels' scale) are given "
            "the infinite-frequency potentials; the motions there are small."
        )

    if settings.speed_treatment == "forward-speed" and speed > 0:
        found = _by_forward_speed_option(hull, density, speed, directions, omega, wetted, notes, settings, progress)
        return found, None

    distinct = np.unique(np.round(np.minimum(met, highest), 12))
    nodes = distinct if not usual and len(distinct) <= _MOST_NODES else encounter_nodes(
        wave_frequencies(hull.length, highest), highest
    )
    at_rest = speed == 0
    with_field = at_rest and together and hull.count > 1 and settings.wave_field != "incident"
    folded = _folded(directions) if wetted.mirrored else directions
    field_directions: Sequence[float] = ()
    if with_field:
        usual_ones = usual_directions(hull.length, 0.0)
        usual_ones = np.unique(_folded(usual_ones)) if wetted.mirrored else usual_ones
        covered = np.all(np.abs(folded[:, None] - usual_ones).min(axis=1) < 1e-6)
        field_directions = usual_ones if usual and covered else np.unique(folded)
    bodies = _bodies(hull, settings, together, wetted, nodes, field_directions, workers, progress)
    found = forward_speed.hydrodynamics(bodies, omega, directions, speed, density, warnings=notes)
    if not with_field:
        if settings.wave_field == "total":
            raise InputError(
                "wave_field must be auto or incident at speed or with interaction off, got total; the scattered "
                "waves under the deck are computed for the ship at rest with hull interaction."
            )
        return found, None
    return found, _field_at(bodies[0].radiation, omega, directions, folded)


def _folded(directions: np.ndarray) -> np.ndarray:
    """Directions of a ship that is alike on both sides, mirrored into 0 to pi [rad]."""
    return np.round(np.abs(np.angle(np.exp(1j * directions))), 12)


def _field_at(
    solved: xr.Dataset, omega: np.ndarray, directions: np.ndarray, folded: np.ndarray
) -> xr.Dataset:
    """Return the scattered waves at the wanted frequencies and directions, mirrored where the direction was."""
    rows = [int(np.argmin(np.abs(solved.encounter_omega.values[:-1] - value))) for value in omega]
    columns = [int(np.argmin(np.abs(solved.wave_direction.values - value))) for value in folded]
    field = solved[["radiated_elevation", "diffracted_elevation"]].isel(
        encounter_omega=rows, wave_direction=columns
    )
    turned = np.sin(directions) < -1e-9
    mirrored = bool(solved.attrs["mirrored"]) & turned
    diffracted = field.diffracted_elevation.values.copy()
    diffracted[:, mirrored] = diffracted[:, mirrored][..., ::-1]
    field["diffracted_elevation"] = (field.diffracted_elevation.dims, diffracted)
    return field.assign_coords(wave_direction=directions)


def _check_frequencies(omega: np.ndarray, highest: float, count: int) -> None:
    """Refuse frequencies that are no frequencies, or whose waves the panels cannot carry."""
    if omega.ndim != 1 or omega.size == 0 or not np.all(np.isfinite(omega)) or np.any(omega <= 0):
        raise InputError("omega must be one or more finite wave frequencies > 0 rad/s; check the range asked for.")
    if np.any(np.diff(omega) <= 0):
        raise InputError("omega must be increasing; sort the frequencies and leave out doubles.")
    if omega.max() > highest * (1 + 1e-9):
        raise InputError(
            f"omega must be <= {highest:.3g} rad/s for {count} panels (a wave must be eight panel radii long), got "
            f"{omega.max():.3g} rad/s; lower the highest frequency or ask for more panels."
        )


def _problem(
    hull: Hull, settings: PotentialFlowSettings, wetted: Panels, index: int | None, with_field: bool
) -> RadiationProblem:
    """Return what is solved for the whole ship (index None) or for one hull alone."""
    field_x: tuple[float, ...] = ()
    field_y: tuple[float, ...] = ()
    if with_field:
        reach = 0.55 * hull.length
        field_x = tuple(np.linspace(-reach, reach, _FIELD_POINTS[0]).tolist())
        half = 0.9 * (hull.spacing - hull.shape.beam) / 2
        field_y = tuple(np.linspace(-half, half, _FIELD_POINTS[1]).round(9).tolist())
    lid = lid_panels(hull, index) if settings.lid else None
    damping = settings.tunnel_damping if index is None and hull.count > 1 else 0.0
    return RadiationProblem(
        panels=wetted,
        lid=lid,
        tunnel_lid=tunnel_lid(hull) if damping > 0 else None,
        tunnel_damping=damping,
        field_x=field_x,
        field_y=field_y,
    )


def _bodies(
    hull: Hull,
    settings: PotentialFlowSettings,
    together: bool,
    wetted: Panels,
    nodes: np.ndarray,
    field_directions: Sequence[float],
    workers: int,
    progress: Callable[[float, str], None],
) -> list[RadiatingBody]:
    """Return the radiating bodies of a hull: all hulls as one, or each alone (alike ones solved once)."""
    if together:
        solved = _stored_radiation(hull, settings, wetted, None, nodes, field_directions, workers, progress)
        return [RadiatingBody(solved)]
    upright = hull.heel == 0
    bodies: list[RadiatingBody] = []
    by_shape: dict[object, xr.Dataset] = {}
    for index, (x, y) in enumerate(hull_positions(hull)):
        is_centre = hull.count == 3 and abs(y) < 1e-9
        alike: object = (is_centre,) if upright else index
        if alike not in by_shape:
            own = hull_panels(hull, index, max(50, settings.panels // hull.count))
            by_shape[alike] = _stored_radiation(hull, settings, own, index, nodes, (), workers, progress)
        bodies.append(RadiatingBody(by_shape[alike], x, y))
    return bodies


def _stored_radiation(
    hull: Hull,
    settings: PotentialFlowSettings,
    wetted: Panels,
    index: int | None,
    nodes: np.ndarray,
    field_directions: Sequence[float],
    workers: int,
    progress: Callable[[float, str], None],
) -> xr.Dataset:
    """Return the radiation potentials: from memory, from disk, or solved."""
    key = cache.content_key(
        "radiation",
        STAGE_VERSION,
        solver=potential_flow.SOLVER_VERSION.split(".")[0],
        hull=hull.as_dict(),
        index=index,
        panels=settings.panels,
        lid=settings.lid,
        tunnel_damping=settings.tunnel_damping,
        encounter_omega=np.round(nodes, 12),
        field_directions=np.round(field_directions, 9),
    )
    if key in _memo:
        _memo.move_to_end(key)
        return _memo[key]
    problem = _problem(hull, settings, wetted, index, len(field_directions) > 0)

    def solved() -> xr.Dataset:
        return radiation(problem, nodes, field_directions, workers=workers, progress=progress)

    _memo[key] = cache.cached(key, solved)
    while len(_memo) > _MEMO_SIZE:
        _memo.popitem(last=False)
    return _memo[key]


def _by_forward_speed_option(
    hull: Hull,
    density: float,
    speed: float,
    directions: np.ndarray,
    omega: np.ndarray,
    wetted: Panels,
    notes: Sequence[str],
    settings: PotentialFlowSettings,
    progress: Callable[[float, str], None],
) -> xr.Dataset:
    """Return the hydrodynamics by Capytaine's own option, kept on disk."""
    key = cache.content_key(
        "forward speed option",
        STAGE_VERSION,
        solver=potential_flow.SOLVER_VERSION,
        hull=hull.as_dict(),
        settings=settings.as_dict(),
        density=density,
        speed=speed,
        directions=directions,
        omega=omega,
    )

    def solved() -> xr.Dataset:
        lid = lid_panels(hull) if settings.lid else None
        parts = potential_flow.forward_speed_coefficients(
            wetted, lid, omega, directions, speed, density, progress
        )
        matrix = ("omega", "wave_direction", "influenced_dof", "radiating_dof")
        return quantities.dataset(
            {
                "omega": omega,
                "wave_direction": directions,
                "influenced_dof": list(MODES),
                "radiating_dof": list(MODES),
            },
            method="potential-flow",
            attrs={"speed": float(speed), "density": float(density), "solver": potential_flow.SOLVER_VERSION},
            added_mass=(matrix, parts["added_mass"]),
            radiation_damping=(matrix, parts["radiation_damping"]),
            froude_krylov_force=(matrix[:3], parts["froude_krylov_force"]),
            diffraction_force=(matrix[:3], parts["diffraction_force"]),
            excitation_force=(matrix[:3], parts["froude_krylov_force"] + parts["diffraction_force"]),
            encounter_frequency=(matrix[:2], encounter_frequency(omega[:, None], speed, directions)),
            wavenumber=("omega", wavenumber(omega)),
        )

    found = cache.cached(key, solved)
    found.attrs["warnings"] = "\n".join(notes)
    return found
