"""One hour of non-linear simulation, and one evaluation of the wet hull's force against cutting the mesh anew."""

import statistics
import time

import numpy as np

from workbench import pipeline
from workbench.conventions import GRAVITY
from workbench.geometry.faceted import Panels
from workbench.hulls import library
from workbench.hulls.surface_mesh import below_water
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.seas import Condition, SeaState
from workbench.simulation.hull_grid import hull_surface
from workbench.simulation.incident_pressure import HullInWaves
from workbench.simulation.records import ShipInWaves, simulation
from workbench.time_domain import Realisation, wave_components

SPEED = 15.4333


def hour() -> list[tuple[str, str, str]]:
    """The 76 m catamaran at 30 knots in head seas, 20 Hz; the force against the mesh cut at the water each time."""
    design = library.design("austal-63")
    found = pipeline.response(design, SPEED, [np.pi / 2, np.pi], None, PotentialFlowSettings())
    ship = ShipInWaves(design, found.hydrodynamics, found.motions)
    sea = SeaState(significant_wave_height=2.0, peak_period=8.0)
    condition = Condition(speed=SPEED, wave_direction=np.pi, sea_state=sea)
    waves = wave_components(condition, Realisation(), 0.1, 2.1)
    start = time.perf_counter()
    simulation(ship, waves, 3600.0, 0.05, points=[(25.0, 0.0)])
    seconds = time.perf_counter() - start
    centre = np.array(design.masses.centre_of_gravity)
    surface = hull_surface(design.hull, centre)
    own = HullInWaves(surface, centre, waves, design.density)
    records = own.amplitudes()[0].real * 0.3
    pose = np.array([0.0, 0.0, 0.3, 0.02, 0.03, 0.0])
    corners = np.concatenate([surface.triangles, surface.triangles[:, 2:]], axis=1)

    def ours() -> float:
        return own.force(pose, records)[2]

    def rival() -> float:
        """Cut at the water, one pressure a panel (the level of the water stands for the height of a vertex)."""
        up = np.array(
            [-np.sin(pose[4]), np.cos(pose[4]) * np.sin(pose[3]), np.cos(pose[4]) * np.cos(pose[3])]
        )
        height = surface.vertices @ up + centre[2] + pose[2] - records[: len(surface.vertices)]
        placed = np.column_stack([surface.vertices[:, :2], height])
        points, faces = below_water(placed, corners)
        wet = Panels(points, faces, np.zeros(len(faces), bool), False)
        return -design.density * GRAVITY * wet.moment(lambda x, y, z: z)

    np.testing.assert_allclose(rival(), ours(), rtol=0.1)
    times: dict = {ours: [], rival: []}
    for _ in range(9):
        for action, repeats in ((ours, 50), (rival, 3)):
            start = time.perf_counter()
            for _ in range(repeats):
                action()
            times[action].append((time.perf_counter() - start) / repeats)
    one, other = (statistics.median(found) for found in times.values())
    return [
        (
            f"one hour of non-linear simulation at 20 Hz, {len(surface.triangles)} triangles",
            f"{seconds:.0f} s",
            "at most 60 s",
        ),
        (
            "force on the wet hull: mesh cut anew (surface_mesh.below_water) / ours",
            f"{other / one:.0f} ({1e3 * other:.1f} ms / {1e3 * one:.2f} ms)",
            "at least 5",
        ),
    ]
