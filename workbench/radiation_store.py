"""Radiation potentials of a ship: which ones a speed needs, solved once and kept in memory and on disk."""

from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import xarray as xr

from workbench import cache
from workbench.conventions import GRAVITY, encounter_frequency
from workbench.design import Hull
from workbench.geometry.lines import hull_shape
from workbench.geometry.panels import Panels, hull_panels, hull_positions, lid_panels, panels, tunnel_lid
from workbench.hydrodynamics import potential_flow
from workbench.hydrodynamics.incident_wave import folded
from workbench.hydrodynamics.radiation import RadiationProblem, radiation
from workbench.hydrodynamics.settings import PotentialFlowSettings

STAGE_VERSION = 1
USUAL_DIRECTIONS = tuple(np.radians(np.arange(0, 360, 15)).tolist())
"""Wave directions all round by 15 degrees [rad]."""
FREQUENCIES = 48
LONGEST_WAVE, SHORTEST_WAVE = 100.0, 1 / 8
"""Longest and shortest wave of the usual frequencies, in ship lengths [-]."""

_FIELD_POINTS = (25, 7)
_memo: OrderedDict[str, xr.Dataset] = OrderedDict()
_MEMO_SIZE = 12
"""Potentials kept in memory: results of their keys alone, so that sessions cannot mix."""


def usual_directions(length: float, speed: float) -> np.ndarray:
    """Wave directions 0 to 345 degrees by 15 [rad], less those in which the ship overtakes some of the waves."""
    directions = np.array(USUAL_DIRECTIONS)
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


@dataclass(frozen=True)
class RadiationTask:
    """One set of potentials to have: of all hulls together (index None), or of one hull in its own axes."""

    hull: Hull
    index: int | None
    settings: PotentialFlowSettings
    nodes: tuple[float, ...]
    field_directions: tuple[float, ...] = ()

    @property
    def key(self) -> str:
        """Content key: everything the potentials depend on."""
        return cache.content_key(
            "radiation",
            STAGE_VERSION,
            solver=potential_flow.SOLVER_VERSION.split(".")[0],
            hull=self.hull.as_dict(),
            index=self.index,
            panels=self.settings.panels,
            lid=self.settings.lid,
            tunnel_damping=self.settings.tunnel_damping,
            encounter_omega=np.round(self.nodes, 12),
            field_directions=np.round(self.field_directions, 9),
        )

    def solved(
        self, workers: int = 1, progress: Callable[[float, str], None] = lambda f, m: None
    ) -> xr.Dataset:
        """Solve, without looking for a stored result."""
        hull, settings = self.hull, self.settings
        if self.index is None:
            wetted = panels(hull, settings.panels)
        else:
            wetted = hull_panels(hull, self.index, max(50, settings.panels))
        problem = _problem(hull, settings, wetted, self.index, len(self.field_directions) > 0)
        return radiation(problem, self.nodes, self.field_directions, workers=workers, progress=progress)

    def stored(self, workers: int, progress: Callable[[float, str], None]) -> xr.Dataset:
        """Return the potentials: from memory, from disk, or solved."""
        key = self.key
        if key not in _memo:
            _memo[key] = cache.cached(key, lambda: self.solved(workers, progress))
        _memo.move_to_end(key)
        while len(_memo) > _MEMO_SIZE:
            _memo.popitem(last=False)
        return _memo[key]


def radiation_tasks(
    hull: Hull,
    settings: PotentialFlowSettings,
    together: bool,
    nodes: np.ndarray,
    field_directions: Sequence[float],
) -> list[tuple[RadiationTask, float, float]]:
    """Return the tasks of a ship, each with the place (x, y) of its body; alike hulls share one task.

    A hull that is upright and does not lean on the ship's trim is keyed by its own
    shape alone: another spacing then costs nothing.
    """
    frequencies = tuple(np.asarray(nodes, float).tolist())
    if together:
        directions = tuple(np.asarray(field_directions, float).tolist())
        return [(RadiationTask(hull, None, settings, frequencies, directions), 0.0, 0.0)]
    own = replace(settings, panels=max(100, settings.panels // hull.count), tunnel_damping=0.0)
    tasks = []
    for index, (x, y) in enumerate(hull_positions(hull)):
        if hull.heel == 0 and (hull.trim == 0 or x == 0):
            alone = Hull(shape=hull_shape(hull, index), trim=hull.trim, sinkage=hull.sinkage)
            tasks.append((RadiationTask(alone, 0, own, frequencies), x, y))
        else:
            tasks.append((RadiationTask(hull, index, own, frequencies), x, y))
    return tasks


def usual_tasks(
    hull: Hull, speed: float, settings: PotentialFlowSettings | None = None
) -> list[RadiationTask]:
    """Return what a ship needs at a speed with all the usual frequencies and headings, alike tasks once."""
    settings = settings or PotentialFlowSettings()
    wetted = panels(hull, settings.panels)
    highest = potential_flow.highest_resolved_frequency(wetted)
    nodes = encounter_nodes(wave_frequencies(hull.length, highest), highest)
    together = settings.interacts(hull.count, speed, hull.length)
    directions: Sequence[float] = ()
    if speed == 0 and together and hull.count > 1 and settings.wave_field != "incident":
        directions = usual_field_directions(hull.length, wetted.mirrored)
    tasks = radiation_tasks(hull, settings, together, nodes, directions)
    return list(dict.fromkeys(task for task, _, _ in tasks))


def usual_field_directions(length: float, mirrored: bool) -> np.ndarray:
    """Directions for which the scattered waves at rest are kept [rad]."""
    usual = usual_directions(length, 0.0)
    return np.unique(folded(usual)) if mirrored else usual


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
