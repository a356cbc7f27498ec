"""The shipped hydrodynamics: found by content, and the same as a fresh computation."""

from dataclasses import replace

import numpy as np
import pytest

from workbench import cache, pipeline, shipped
from workbench.conventions import GRAVITY
from workbench.hulls import library
from workbench.radiation_store import usual_tasks


def tasks(name):
    hull = library.design(name).hull
    return [
        task for froude in (0.0, 0.4) for task in usual_tasks(hull, froude * np.sqrt(GRAVITY * hull.length))
    ]


@pytest.mark.parametrize("name", shipped.DESIGNS)
def test_shipped_potentials_are_found_and_are_those_of_a_fresh_run(name):
    for task in tasks(name):
        stored = cache._shipped(task.key)
        assert stored is not None, "run `workbench precompute` after a change of the potentials"
        chosen = [3, 20, 40]
        few = replace(task, nodes=tuple(task.nodes[i] for i in chosen))
        fresh = few.solved()
        kept = stored.isel(encounter_omega=[*chosen, -1])
        for variable in ("radiation_potential", "radiated_elevation", "diffracted_elevation"):
            if variable in fresh:
                scale = np.abs(fresh[variable].values).max()
                np.testing.assert_allclose(
                    kept[variable].values / scale, fresh[variable].values / scale, atol=2e-5
                )


def test_a_shipped_design_needs_no_solver(monkeypatch):
    """The app opens at once: nothing is solved for a shipped design, at rest or at speed."""
    from workbench.hydrodynamics import radiation

    monkeypatch.setattr(radiation, "frequency_solution", None)
    design = library.design("austal-63")
    for speed in (0.0, 15.0):
        ship = pipeline.response(design, speed)
        assert np.isfinite(ship.motions.motion_rao.values).all()


def test_written_anew_they_have_the_same_names(tmp_path, monkeypatch):
    from workbench import radiation_store

    kept = {
        path.name
        for name in shipped.DESIGNS
        for path in [tmp_path / f"{task.key}.nc" for task in tasks(name)]
    }
    monkeypatch.setattr(radiation_store.RadiationTask, "solved", lambda self: cache._shipped(self.key))
    written = shipped.written_hydrodynamics(shipped.DESIGNS, tmp_path)
    assert {path.name for path in written} == kept
    assert len(kept) == 6
