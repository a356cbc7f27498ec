"""Pictures and films of a scene without a browser, painted by PyVista in a process of its own.

The painter runs apart because an off-screen render without EGL or OSMesa ends
the process that tries it, and because it keeps its memory. Files are written
under a temporary name and appear only when complete.
"""

import ctypes.util
import os
import pickle
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import xarray as xr

from workbench.errors import InputError, checked_choice, checked_number
from workbench.scene.description import DECK_FIELDS, checked_scene

CAMERAS = {
    "quarter": (-0.62, -0.68, 0.58),
    "bow": (0.80, 0.52, 0.46),
    "under": (0.17, -0.60, -0.78),
    "side": (-0.06, -1.0, 0.13),
    "plan": (0.0, 0.0, 1.0),
}
"""Directions from the ship to the camera; ``plan`` looks straight down without perspective."""

_TIME_LIMIT = 600.0


def deck_contour_picture(
    scene: xr.Dataset,
    path: str | Path,
    *,
    time: float | None = None,
    field: str | None = None,
    camera: str = "quarter",
    size: tuple[int, int] = (1280, 720),
) -> Path:
    """Write a PNG of the scene at one instant and return its path.

    Parameters
    ----------
    scene : as made by `workbench.scene.description`.
    path : file to write, ending in ``.png``.
    time : instant [s]; that of the largest value of the field if None.
    field : field of the deck that is drawn; the first that the scene has if None.
    camera : one of `CAMERAS`.
    size : width and height [px].
    """
    scene, field, camera = checked_scene(scene), _checked_field(scene, field), _checked_camera(camera)
    start, end = float(scene["time"][0]), float(scene["time"][-1])
    if time is None:
        time = _telling_instant(scene, field)
    time = checked_number("Time of the picture", time, "s", at_least=start, at_most=end)
    job = {"kind": "picture", "scene": scene, "time": time, "field": field, "camera": camera, "size": size}
    return _painted(job, path, (".png",))


def mesh_picture(
    vertices,
    faces,
    path: str | Path,
    *,
    camera: str = "bow",
    edges: bool = True,
    title: str = "",
    size: tuple[int, int] = (1280, 720),
) -> Path:
    """Write a PNG of a surface mesh and return its path.

    Parameters
    ----------
    vertices : (n_v, 3) [m].
    faces : (n_f, 4), vertex numbers; a triangle repeats one.
    path : file to write, ending in ``.png``.
    camera : one of `CAMERAS`.
    edges : whether the edges of the faces are drawn.
    title : words in the picture.
    size : width and height [px].
    """
    vertices, faces = np.asarray(vertices, float), np.asarray(faces, int)
    if vertices.ndim != 2 or vertices.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 4:
        raise InputError(
            "A mesh has vertices of shape (n, 3) and faces of shape (m, 4), "
            f"got {vertices.shape} and {faces.shape}; repeat a corner of triangles."
        )
    job = {
        "kind": "mesh",
        "vertices": vertices,
        "faces": faces,
        "camera": _checked_camera(camera),
        "edges": bool(edges),
        "title": title,
        "size": size,
    }
    return _painted(job, path, (".png",))


def film(
    scene: xr.Dataset,
    path: str | Path,
    *,
    field: str | None = None,
    camera: str = "quarter",
    start: float | None = None,
    end: float | None = None,
    frames_per_second: int = 20,
    size: tuple[int, int] = (960, 544),
) -> Path:
    """Write a film in real time, ``.mp4`` or ``.gif``, and return its path.

    Parameters are those of `deck_contour_picture`, and:

    start, end : part of the scene that is filmed [s]; all of it if None.
    frames_per_second : 1 to 50.
    size : width and height [px], made multiples of 16 for the sake of players.
    """
    scene, field, camera = checked_scene(scene), _checked_field(scene, field), _checked_camera(camera)
    first, last = float(scene["time"][0]), float(scene["time"][-1])
    start = checked_number(
        "Start of the film", first if start is None else start, "s", at_least=first, below=last
    )
    end = checked_number("End of the film", last if end is None else end, "s", above=start, at_most=last)
    rate = int(checked_number("Frames per second", frames_per_second, at_least=1, at_most=50))
    count = max(2, round((end - start) * rate))
    size = tuple(max(16, 16 * round(length / 16)) for length in size)
    job = {
        "kind": "film",
        "scene": scene,
        "times": start + np.arange(count) / rate,
        "rate": rate,
        "field": field,
        "camera": camera,
        "size": size,
    }
    return _painted(job, path, (".mp4", ".gif"))


def rendering_obstacle() -> str:
    """Sentence that says why nothing can be painted here; empty if it can."""
    if sys.platform != "linux" or os.environ.get("DISPLAY"):
        return ""
    if any(ctypes.util.find_library(name) for name in ("EGL", "OSMesa")):
        return ""
    return (
        "Pictures and films need the EGL or the OSMesa library, and neither is installed; "
        "install libegl1 and libgl1, or look at the animated view instead."
    )


def _painted(job: dict, path: str | Path, endings: tuple[str, ...]) -> Path:
    """Run the job in a process of its own and move its file to `path`."""
    path = Path(path)
    if path.suffix.lower() not in endings:
        raise InputError(f"The file must end in {' or '.join(endings)}, got {path.name!r}; change its name.")
    if not path.parent.is_dir():
        raise InputError(f"The folder {str(path.parent)!r} does not exist; make it first.")
    obstacle = rendering_obstacle()
    if obstacle:
        raise InputError(obstacle)
    environment = dict(os.environ)
    if sys.platform == "linux" and not environment.get("DISPLAY"):
        egl = ctypes.util.find_library("EGL")
        environment["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkEGLRenderWindow" if egl else "vtkOSOpenGLRenderWindow"
    paths = [str(Path(__file__).parents[2]), environment.get("PYTHONPATH", "")]
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, paths))
    # beside its goal, so that the move at the end cannot be half done
    with tempfile.TemporaryDirectory(prefix=".painting-", dir=path.parent) as folder:
        painted = Path(folder) / f"painted{path.suffix.lower()}"
        order = Path(folder) / "order"
        order.write_bytes(pickle.dumps({**job, "path": str(painted)}))
        run = subprocess.run(
            [sys.executable, "-m", "workbench.scene.rendering", str(order)],
            env=environment,
            capture_output=True,
            text=True,
            timeout=_TIME_LIMIT,
            check=False,
        )
        if run.returncode or not painted.exists():
            lines = run.stderr.strip().splitlines()
            reason = lines[-1] if lines else f"the painter ended with code {run.returncode}"
            raise RuntimeError(f"{path.name} could not be painted: {reason}")
        os.replace(painted, path)
    return path


def _checked_field(scene: xr.Dataset, field: str | None) -> str:
    """Return the field to draw; empty if the scene has none."""
    names = [name for name in DECK_FIELDS if name in scene]
    if field is None:
        return names[0] if names else ""
    return checked_choice("The field drawn on the deck", field, names or ["no field at all"])


def _checked_camera(camera: str) -> str:
    return checked_choice("The camera", camera, CAMERAS)


def _telling_instant(scene: xr.Dataset, field: str) -> float:
    """Instant [s] at which the field is at its worst."""
    if not field:
        return float(scene["time"][0])
    values = np.nan_to_num(scene[field].values.reshape(scene.sizes["time"], -1))
    worst = values.min(axis=1).argmin() if field == "clearance_left" else values.max(axis=1).argmax()
    return float(scene["time"][worst])
