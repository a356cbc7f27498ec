"""The hydrodynamics that come with the package, so that the app opens at once."""

from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

import numpy as np

from workbench import cache
from workbench.conventions import GRAVITY
from workbench.hulls import library
from workbench.hydrodynamics.settings import LOW_FROUDE_NUMBER
from workbench.radiation_store import usual_tasks

DESIGNS = ("delft-372", "austal-63", "incat-061")
"""Designs whose hydrodynamics are shipped: at rest with the waves under the deck, and at speed with hulls apart."""


def written_hydrodynamics(names: Sequence[str] = DESIGNS, folder: Path | None = None) -> list[Path]:
    """Compute the radiation potentials of library designs and write them as shipped.

    Parameters
    ----------
    names : library designs; folder : where to; the package's own data folder if None.

    Returns
    -------
    Paths of the files, named by their content keys.

    Notes
    -----
    Complex numbers are kept in single precision. Costs about half a minute a design.
    """
    target = Path(folder) if folder else Path(str(files("workbench"))) / "data" / "hydrodynamics"
    written = []
    for name in names:
        hull = library.design(name).hull
        for froude in (0.0, 2 * LOW_FROUDE_NUMBER):
            for task in usual_tasks(hull, froude * float(np.sqrt(GRAVITY * hull.length))):
                path = target / f"{task.key}.nc"
                solved = task.solved().assign_attrs(cache_key=task.key, design=name)
                cache.save_dataset(solved, path, single_precision=True)
                written.append(path)
    return written
