"""The potential-flow stage of the pipeline: hydrodynamics at speed, and the waves under the deck at rest."""

from collections.abc import Callable, Sequence

import numpy as np
import xarray as xr

from workbench import cache, quantities
from workbench.conventions import GRAVITY, encounter_frequency
from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.faceted import Panels
from workbench.geometry.panels import lid_panels, panels
from workbench.hydrodynamics import forward_speed, potential_flow
from workbench.hydrodynamics.coefficients import coefficient_set
from workbench.hydrodynamics.forward_speed import RadiatingBody
from workbench.hydrodynamics.gap_resonance import gap_resonance
from workbench.hydrodynamics.incident_wave import folded
from workbench.hydrodynamics.settings import PotentialFlowSettings, validity_warnings
from workbench.radiation_store import (
    STAGE_VERSION,
    encounter_nodes,
    radiation_tasks,
    usual_field_directions,
    wave_frequencies,
)

_MOST_NODES = 120


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
    check_frequencies(omega)
    _check_resolved(omega, highest, settings.panels)
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
        found = _by_forward_speed_option(
            hull, density, speed, directions, omega, wetted, notes, settings, progress
        )
        return found, None

    distinct = np.unique(np.round(np.minimum(met, highest), 12))
    nodes = (
        distinct
        if not usual and len(distinct) <= _MOST_NODES
        else encounter_nodes(wave_frequencies(hull.length, highest), highest)
    )
    at_rest = speed == 0
    with_field = at_rest and together and hull.count > 1 and settings.wave_field != "incident"
    sides = folded(directions) if wetted.mirrored else directions
    field_directions: Sequence[float] = ()
    if with_field:
        usual_ones = usual_field_directions(hull.length, wetted.mirrored)
        covered = np.all(np.abs(sides[:, None] - usual_ones).min(axis=1) < 1e-6)
        field_directions = usual_ones if usual and covered else np.unique(sides)
    tasks = radiation_tasks(hull, settings, together, nodes, field_directions)
    bodies = [RadiatingBody(task.stored(workers, progress), x, y) for task, x, y in tasks]
    found = forward_speed.hydrodynamics(bodies, omega, directions, speed, density, warnings=notes)
    if hull.count == 2:
        found.attrs |= _gap_attributes(hull, wetted)
    if hull.count == 2 and together and settings.tunnel_damping == 0:
        found.attrs["warnings"] = quantities.joined_warnings([*notes, _gap_note(found, omega)])
    if not with_field:
        if settings.wave_field == "total":
            raise InputError(
                "wave_field must be auto or incident at speed or with interaction off, got total; the scattered "
                "waves under the deck are computed for the ship at rest with hull interaction."
            )
        return found, None
    return found, _field_at(bodies[0].radiation, omega, directions, sides)


def _gap_attributes(hull: Hull, wetted: Panels) -> dict[str, float]:
    """Return the estimated resonances of the water between two hulls."""
    both = 2.0 if wetted.mirrored else 1.0
    waterplane = both * wetted.moment(lambda x, y, z: np.ones_like(x))
    estimate = gap_resonance(hull.spacing - hull.shape.beam, hull.shape.beam, wetted.volume / waterplane)
    return {"gap_piston_frequency": estimate.piston, "gap_sloshing_frequency": estimate.sloshing}


def _gap_note(found: xr.Dataset, omega: np.ndarray) -> str:
    """Say where the water between the hulls resonates, if that is among the frequencies."""
    piston = found.attrs["gap_piston_frequency"]
    if not omega[0] < piston < omega[-1]:
        return ""
    return (
        f"The water between the hulls resonates near {piston:.3g} rad/s (piston mode, estimated) and near "
        f"{found.attrs['gap_sloshing_frequency']:.3g} rad/s (sloshing); potential flow leaves it undamped: a tunnel "
        "damping of 0.02 to 0.05 tames it."
    )


def _field_at(solved: xr.Dataset, omega: np.ndarray, directions: np.ndarray, sides: np.ndarray) -> xr.Dataset:
    """Return the scattered waves at the wanted frequencies and directions, mirrored where the direction was."""
    rows = [int(np.argmin(np.abs(solved.encounter_omega.values[:-1] - value))) for value in omega]
    columns = [int(np.argmin(np.abs(solved.wave_direction.values - value))) for value in sides]
    field = solved[["radiated_elevation", "diffracted_elevation"]].isel(
        encounter_omega=rows, wave_direction=columns
    )
    turned = np.sin(directions) < -1e-9
    mirrored = bool(solved.attrs["mirrored"]) & turned
    diffracted = field.diffracted_elevation.values.copy()
    diffracted[:, mirrored] = diffracted[:, mirrored][..., ::-1]
    field["diffracted_elevation"] = (field.diffracted_elevation.dims, diffracted)
    return field.assign_coords(wave_direction=directions)


def check_frequencies(omega: np.ndarray) -> None:
    """Refuse frequencies that are no frequencies."""
    if omega.ndim != 1 or omega.size == 0 or not np.all(np.isfinite(omega)) or np.any(omega <= 0):
        raise InputError(
            "omega must be one or more finite wave frequencies > 0 rad/s; check the range asked for."
        )
    if np.any(np.diff(omega) <= 0):
        raise InputError("omega must be increasing; sort the frequencies and leave out doubles.")


def _check_resolved(omega: np.ndarray, highest: float, count: int) -> None:
    """Refuse frequencies whose waves the panels cannot carry."""
    if omega.max() > highest * (1 + 1e-9):
        raise InputError(
            f"omega must be <= {highest:.3g} rad/s for {count} panels (a wave must be eight panel radii long), got "
            f"{omega.max():.3g} rad/s; lower the highest frequency or ask for more panels."
        )


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
        return coefficient_set(
            omega, directions, speed, density, **parts, solver=potential_flow.SOLVER_VERSION
        )

    found = cache.cached(key, solved)
    found.attrs["warnings"] = quantities.joined_warnings(notes)
    return found
