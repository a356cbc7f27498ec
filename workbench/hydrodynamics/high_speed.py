"""High-speed (2 1/2-D) theory of ships of one to three hulls, upright or heeled.

The ship passes through cross-planes of water at rest: waves go sideways and aft and none
ahead ([Grande2002]_ A1.100-A1.106 after [FaltinsenZhao1991]_, in axes x forward). One march
from bow to stern per problem (`cross_plane`) serves all frequencies, modes and headings.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
.. [FaltinsenZhao1991] O. M. Faltinsen and R. Zhao, "Numerical predictions of ship motions at
    high forward speed", Phil. Trans. R. Soc. Lond. A 334, 241-252, 1991.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr
from threadpoolctl import threadpool_limits

from workbench import __version__, quantities
from workbench.conventions import GRAVITY, encounter_frequency
from workbench.design import Hull
from workbench.errors import checked_number
from workbench.geometry.lines import is_symmetric
from workbench.hydrodynamics.coefficients import coefficient_set
from workbench.hydrodynamics.high_speed_forces import (
    ends,
    forces,
    froude_krylov,
    joined,
    lost_stiffness,
    ship_sectional,
)
from workbench.hydrodynamics.high_speed_hulls import Stations, all_together, hull_alone, stationed
from workbench.hydrodynamics.high_speed_march import Sectional, Waves, sectional
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings, check_speed, tau, validity_warnings
from workbench.hydrodynamics.incident_wave import folded
from workbench.hydrodynamics.potential_flow import refuse_overtaken_waves
from workbench.hydrodynamics.strip_forces import between_nodes
from workbench.hydrodynamics.strip_wave_field import tunnel_grid
from workbench.hydrodynamics.wave_fields import elevation_set

SOLVER_VERSION = f"workbench high speed {__version__}"
FIELD_POINTS = (61, 5)
"""Points lengthwise and across at which the waves between the hulls are given."""
_MOST_NODES = 60
_SPLINE_NODES = 48
_PHASE_PER_STATION = 0.35


def hydrodynamics(
    hull: Hull,
    density: float,
    omega: Sequence[float],
    wave_directions: Sequence[float],
    speed: float,
    settings: HighSpeedSettings | None = None,
    *,
    warnings: Sequence[str] = (),
) -> xr.Dataset:
    """Added mass, damping and wave forces of a ship at high speed: the first part of `solution`."""
    return solution(hull, density, omega, wave_directions, speed, settings, warnings=warnings)[0]


def solution(
    hull: Hull,
    density: float,
    omega: Sequence[float],
    wave_directions: Sequence[float],
    speed: float,
    settings: HighSpeedSettings | None = None,
    *,
    warnings: Sequence[str] = (),
) -> tuple[xr.Dataset, xr.Dataset | None]:
    """Added mass, damping and wave forces of a ship at high speed, about the origin, and its waves between the hulls.

    Parameters
    ----------
    hull : in the attitude in which it runs; density : [kg/m3].
    omega : wave frequencies [rad/s]; wave_directions : [rad]; speed : [m/s].
    settings : choices of the theory; None takes the usual ones.
    warnings : go before the method's own in the attributes of the result.

    Returns
    -------
    Dataset of `coefficient_set`, method "high-speed", and ``stiffness_correction``: what a dry transom takes
    from the hydrostatic stiffness. With ``wave_field="total"`` and several hulls also the Dataset of
    `wave_fields.elevation_set` between the hulls, else None.

    Raises
    ------
    InputError below Fn 0.1 and where the ship overtakes the waves.

    Notes
    -----
    Slender hulls, Fn above about 0.25 and tau = U omega_e/g above 1/4. No added mass, damping and diffraction
    in surge. Costs about a second for 40 waves, and far less than in proportion for more.
    """
    settings = settings or HighSpeedSettings()
    omega = np.asarray(omega, float)
    directions = np.asarray(wave_directions, float)
    checked_number("speed", speed, "m/s", at_least=0, at_most=60)
    check_speed(speed, hull.length)
    refuse_overtaken_waves(omega, directions, speed)
    lowest = float(tau(omega, directions, speed).min())
    notes = [*warnings, *validity_warnings(settings, hull.count, speed, hull.length, lowest)]
    sides, where = _sides(hull, directions)
    waves = _met_waves(omega, sides, speed)
    nodes = _nodes(waves.encounter)
    stations = stationed(hull, _station_count(settings, hull.length, speed, nodes[-1]), settings.panels)
    with_field = settings.wave_field == "total" and hull.count > 1
    field_x, field_y = tunnel_grid(hull, FIELD_POINTS) if with_field else (np.zeros(0), np.zeros(0))
    # small matrices: threads gain nothing, and wait for each other on a busy machine
    with threadpool_limits(1, user_api="blas"):
        potentials = _potentials(hull, stations, settings, speed, nodes, waves, field_y)
    family_ends = [
        ends(stations, stations.hulls[numbers[0]], speed, settings.transom == "released")
        for numbers in stations.families
    ]
    radiation, diffraction = forces(potentials, stations, family_ends, speed, density, nodes, waves)
    incident = froude_krylov(stations, family_ends, density, waves)
    radiation = between_nodes(nodes, radiation, waves.encounter)
    shape = (len(omega), len(sides))
    mirror = np.where(np.sin(directions) < -1e-9, -1.0, 1.0) if is_symmetric(hull) else None
    radiation = np.conj(radiation).reshape(*shape, 6, 6)[:, where]  # to exp(-i omega t)
    incident = _turned(np.conj(incident).reshape(*shape, 6)[:, where], mirror)
    diffraction = _turned(np.conj(diffraction).reshape(*shape, 6)[:, where], mirror)
    encounter = waves.encounter.reshape(shape)[:, where, None, None]
    found = coefficient_set(
        omega,
        directions,
        speed,
        density,
        added_mass=radiation.real / encounter**2,
        radiation_damping=radiation.imag / encounter,
        froude_krylov_force=incident,
        diffraction_force=diffraction,
        solver=SOLVER_VERSION,
        method="high-speed",
        warnings=notes,
    )
    matrix = ("wave_direction", "influenced_dof", "radiating_dof")
    lost = np.broadcast_to(lost_stiffness(stations, family_ends, density), (len(directions), 6, 6))
    found["stiffness_correction"] = xr.DataArray(lost, dims=matrix).assign_attrs(
        quantities.attributes("stiffness_correction")
    )
    found.attrs["lowest_tau"] = lowest
    if not with_field:
        return found, None
    radiated, diffracted = _on_grid(stations, potentials, field_x, nodes, waves)
    radiated = np.conj(radiated).reshape(*shape, 5, *radiated.shape[2:])[:, where]
    diffracted = np.conj(diffracted).reshape(*shape, *diffracted.shape[1:])[:, where]
    if mirror is not None:
        diffracted = np.where((mirror < 0)[:, None, None], diffracted[..., ::-1], diffracted)
    radiated = np.insert(radiated, 0, 0.0, axis=2)
    return found, elevation_set(
        omega,
        directions,
        field_x,
        field_y,
        radiated=radiated,
        diffracted=diffracted,
        speed=speed,
        method="high-speed",
    )


def _on_grid(
    stations: Stations, potentials: Sectional, field_x: np.ndarray, nodes: np.ndarray, waves: Waves
) -> tuple[np.ndarray, np.ndarray]:
    """Return radiated (waves, 5, x, y) and diffracted (waves, x, y) elevations."""
    place = np.interp(-field_x, -stations.x, np.arange(len(stations.x)))
    before = np.minimum(place.astype(int), len(stations.x) - 2)
    share = place - before

    def at(values):
        weight = share.reshape(-1, *[1] * (values.ndim - 1))
        return (1 - weight) * values[before] + weight * values[before + 1]

    radiated = np.moveaxis(at(potentials.radiated_elevation), (3, 2), (0, 1))
    return between_nodes(nodes, radiated, waves.encounter), np.moveaxis(
        at(potentials.diffracted_elevation), -1, 0
    )


def _sides(hull: Hull, directions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the directions to compute and, for each wanted one, which of them: mirrored ones are computed once."""
    if not is_symmetric(hull):
        return directions, np.arange(len(directions))
    return np.unique(folded(directions), return_inverse=True)


def _turned(force: np.ndarray, mirror: np.ndarray | None) -> np.ndarray:
    """Return forces of waves from the other side: sway, roll and yaw change sign."""
    if mirror is None:
        return force
    signs = np.ones((len(mirror), 6))
    signs[:, [1, 3, 5]] = mirror[:, None]
    return force * signs


def _met_waves(omega: np.ndarray, directions: np.ndarray, speed: float) -> Waves:
    """Return every frequency with every direction, omega first."""
    frequency, direction = (part.ravel() for part in np.meshgrid(omega, directions, indexing="ij"))
    return Waves(frequency, direction, encounter_frequency(frequency, speed, direction))


def _nodes(encounter: np.ndarray) -> np.ndarray:
    """Return the encounter frequencies at which motions are marched: all, or enough for a spline."""
    distinct = np.unique(encounter)
    if len(distinct) <= _MOST_NODES:
        return distinct
    return np.linspace(distinct[0], distinct[-1], _SPLINE_NODES)


def _station_count(settings: HighSpeedSettings, length: float, speed: float, highest: float) -> int:
    """Return how many stations keep the phase between neighbours small and the march stable."""
    by_phase = highest * length / speed / _PHASE_PER_STATION
    spacing = _grid(length)
    by_stability = np.sqrt(np.pi * GRAVITY / spacing) * length / speed / 1.5
    return int(min(max(settings.stations, by_phase, by_stability), 1000))


def _grid(length: float) -> float:
    """Return the distance of points on the water [m]."""
    return length / 150


def _potentials(
    hull: Hull,
    stations: Stations,
    settings: HighSpeedSettings,
    speed: float,
    nodes: np.ndarray,
    waves: Waves,
    field_y: np.ndarray,
) -> Sectional:
    """Return the sectional potentials of the whole ship, with the interaction that was asked for."""
    spacing = _grid(hull.length)
    several = len(stations.hulls) > 1
    apart = together = None
    if not several or settings.interaction != "on":
        solved = {}
        for numbers in stations.families:
            problem = hull_alone(stations, numbers[0])
            beside = np.concatenate([field_y - stations.hulls[number].y for number in numbers])
            solved[numbers[0]] = sectional(
                problem, stations, speed, nodes, waves, hull.length, spacing, beside
            )
        apart = ship_sectional(stations, solved, waves, len(field_y))
    if several and settings.interaction != "off":
        half_width = hull.length + hull.spacing / 2
        problem = all_together(stations)
        together = sectional(problem, stations, speed, nodes, waves, half_width, spacing, field_y)
    if apart is None:
        return together
    if together is None:
        return apart
    return joined(stations, apart, together, speed, nodes, waves)
