"""The painting process of `stills`: reads one order, paints with PyVista, writes one file.

Run as ``python -m workbench.scene.rendering order``; the order is a file
written by `stills` a moment before.
"""

import pickle
import sys
from pathlib import Path

import numpy as np
import pyvista
import xarray as xr
from matplotlib.colors import ListedColormap

from workbench.scene.description import elevation_at, has_components
from workbench.scene.packing import BANDS, deck_field
from workbench.scene.stills import CAMERAS

BACKGROUND = "#eaf1f6"
INK = "#1d2b35"
_SEA_POINTS = 180
_SEA = (62, 132, 163)


class ScenePainting:
    """A scene on a PyVista plotter, moved from instant to instant."""

    def __init__(self, scene: xr.Dataset, field: str, camera: str, size: tuple[int, int]) -> None:
        self.scene, self.field = scene, field
        self.plotter = _plotter(size)
        hull = _surface(scene["hull_vertices"].values, scene["hull_faces"].values)
        length = hull.length
        hull = hull.clean(tolerance=1e-6).fill_holes(length)
        self.ship = [
            self.plotter.add_mesh(
                hull.clip("z", origin=(0, 0, 0), invert=below),
                color="#a8483c" if below else "#eef3f6",
                ambient=0.28,
                diffuse=0.78,
                split_sharp_edges=True,
                feature_angle=35,
            )
            for below in (True, False)
        ]
        self.lift = 0.002 * length * np.array(CAMERAS[camera])
        self._add_deck(camera)
        self._lights()
        _aim(self.plotter, camera, [hull, self.deck], title=scene.attrs.get("title", ""))
        self._add_sea(length)

    def _add_deck(self, camera: str) -> None:
        x, y = (_reached(self.scene[name].values) for name in ("x", "y"))
        x, y = np.meshgrid(x, y, indexing="ij")
        self.deck = pyvista.StructuredGrid(x, y, np.pad(self.scene["deck_height"].values, 1, mode="edge"))
        if not self.field:
            self.ship.append(self.plotter.add_mesh(self.deck, color="#c3ccd3", lighting=False))
            return
        facts = deck_field(self.scene[self.field])
        self.factor = facts["factor"]
        self.deck[self.field] = self._deck_values(0.0)
        self.levels = np.linspace(facts["low"], facts["high"], BANDS + 1)[1:-1] * self.factor
        limits = [facts["low"] * self.factor, facts["high"] * self.factor]
        self.ship.append(
            self.plotter.add_mesh(
                self.deck,
                scalars=self.field,
                clim=limits,
                cmap=ListedColormap(facts["colours"]),
                n_colors=BANDS,
                interpolate_before_map=True,
                lighting=False,
                nan_color="#b8b8b8",
                show_scalar_bar=False,
            )
        )
        step = (limits[1] - limits[0]) / 4
        self.plotter.add_scalar_bar(
            title=f"{facts['label']} [{facts['unit']}]\n",
            n_labels=5,
            fmt="%.0f" if abs(step - round(step)) < 1e-9 else "%.2f",
            color=INK if camera == "under" else "white",
            title_font_size=18,
            label_font_size=16,
            width=0.34,
            height=0.11,
            position_x=0.02,
            position_y=0.03,
            mapper=self.ship[-1].mapper,
        )

    def _add_sea(self, length: float) -> None:
        if has_components(self.scene):
            s = np.linspace(-1, 1, _SEA_POINTS)
            xs = ys = length * (0.9 * s + 1.1 * s**3)
        else:
            xs, ys = self.scene["sea_x"].values, self.scene["sea_y"].values
        self.sea_x, self.sea_y = np.meshgrid(xs, ys, indexing="ij")
        self.sea = pyvista.StructuredGrid(self.sea_x, self.sea_y, np.zeros_like(self.sea_x))
        edge = np.maximum(
            np.abs(self.sea_x - xs.mean()) / np.ptp(xs) * 2, np.abs(self.sea_y - ys.mean()) / np.ptp(ys) * 2
        )
        under = self.plotter.camera.position[2] < 0
        opacity = (0.16 if under else 0.94) * np.clip((1 - edge) / 0.3, 0, 1)
        self.sea["colour"] = np.concatenate(
            [np.tile(_SEA, (edge.size, 1)), 255 * opacity.ravel(order="F")[:, None]], axis=1
        ).astype(np.uint8)
        self.plotter.add_mesh(
            self.sea,
            scalars="colour",
            rgba=True,
            smooth_shading=True,
            specular=0.45,
            specular_power=18,
            ambient=0.05,
            diffuse=1.0,
        )

    def _lights(self) -> None:
        self.plotter.remove_all_lights()
        for position, intensity in (((-25, -40, 85), 0.70), ((60, 30, 40), 0.35), ((10, -30, -60), 0.55)):
            self.plotter.add_light(
                pyvista.Light(position=position, intensity=intensity, light_type="scene light")
            )

    def _deck_values(self, index: float) -> np.ndarray:
        before = int(min(index, self.scene.sizes["time"] - 2))
        values = self.scene[self.field].values
        blend = values[before] + (index - before) * (values[before + 1] - values[before])
        return np.pad(blend * self.factor, 1, mode="edge").ravel(order="F")

    def move(self, time: float) -> None:
        """Bring ship, water and deck to this instant [s]."""
        axis = self.scene["time"].values
        pose = np.array([np.interp(time, axis, column) for column in self.scene["pose"].values.T])
        for actor in self.ship:
            actor.user_matrix = _pose_matrix(pose)
        points = self.sea.points.copy()
        points[:, 2] = elevation_at(self.scene, time, self.sea_x, self.sea_y).ravel(order="F")
        self.sea.points = points
        if self.field:
            self.deck[self.field] = self._deck_values((time - axis[0]) / (axis[1] - axis[0]))
            self._draw_isolines(pose)
        _write(self.plotter, f"Time {time:.1f} s", (0.87, 0.93), "time")

    def _draw_isolines(self, pose: np.ndarray) -> None:
        lines = self.deck.contour(self.levels, scalars=self.field)
        if lines.n_points == 0:
            self.plotter.remove_actor("isolines", render=False)
            return
        actor = self.plotter.add_mesh(lines, color="#33414b", line_width=1.5, lighting=False, name="isolines")
        matrix = _pose_matrix(pose)
        matrix[:3, 3] += self.lift  # in front of the deck, not within it
        actor.user_matrix = matrix


def paint(order: dict) -> None:
    """Carry out one order of `stills`."""
    if order["kind"] == "mesh":
        _paint_mesh(order)
        return
    painting = ScenePainting(order["scene"], order["field"], order["camera"], order["size"])
    if order["kind"] == "picture":
        painting.move(order["time"])
        painting.plotter.screenshot(order["path"])
        return
    if order["path"].endswith(".gif"):
        painting.plotter.open_gif(order["path"], fps=order["rate"], loop=0)
    else:
        painting.plotter.open_movie(order["path"], framerate=order["rate"], quality=7)
    for time in order["times"]:
        painting.move(float(time))
        painting.plotter.write_frame()
    painting.plotter.close()


def _paint_mesh(order: dict) -> None:
    plotter = _plotter(order["size"])
    mesh = _surface(order["vertices"], order["faces"])
    plotter.add_mesh(
        mesh,
        color="#dbe7ee",
        ambient=0.35,
        diffuse=0.7,
        show_edges=order["edges"],
        edge_color="#37474f",
        line_width=1,
    )
    _aim(plotter, order["camera"], [mesh], title=order["title"])
    plotter.screenshot(order["path"])


def _plotter(size: tuple[int, int]) -> pyvista.Plotter:
    plotter = pyvista.Plotter(off_screen=True, window_size=list(size), lighting="three lights")
    plotter.set_background(BACKGROUND)
    plotter.enable_anti_aliasing("msaa", multi_samples=4)
    return plotter


def _reached(values: np.ndarray) -> np.ndarray:
    """Centres of cells with the outer edges of the first and the last one."""
    return np.r_[1.5 * values[0] - 0.5 * values[1], values, 1.5 * values[-1] - 0.5 * values[-2]]


def _surface(vertices: np.ndarray, faces: np.ndarray) -> pyvista.PolyData:
    """Surface of quadrilaterals, of which some repeat a corner."""
    cells = []
    for face in faces:
        corners = list(dict.fromkeys(int(corner) for corner in face))
        if len(corners) > 2:
            cells.append([len(corners), *corners])
    return pyvista.PolyData(np.asarray(vertices, float), np.concatenate(cells))


def _write(plotter: pyvista.Plotter, words: str, place: tuple[float, float], name: str) -> None:
    """Write words on a light ground, so that they can be read over sea and sky."""
    actor = plotter.add_text(words, position=place, viewport=True, font_size=12, color=INK, name=name)
    actor.prop.background_color = "white"
    actor.prop.background_opacity = 0.8


def _pose_matrix(pose: np.ndarray) -> np.ndarray:
    """Matrix (4, 4) of the motions: roll, then pitch, then yaw, then the displacement."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(pose[3:]), np.sin(pose[3:])
    roll = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    pitch = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    yaw = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    matrix = np.eye(4)
    matrix[:3, :3] = yaw @ pitch @ roll
    matrix[:3, 3] = pose[:3]
    return matrix


def _aim(plotter: pyvista.Plotter, camera: str, meshes: list, title: str) -> None:
    """Direct the camera so that the meshes fill the picture, with the title above."""
    bounds = np.array([mesh.bounds for mesh in meshes])
    box = np.stack([bounds[:, 0::2].min(axis=0), bounds[:, 1::2].max(axis=0)])
    centre, length = box.mean(axis=0), np.ptp(box[:, 0])
    away = np.array(CAMERAS[camera]) / np.linalg.norm(CAMERAS[camera])
    plotter.camera.focal_point = centre
    plotter.camera.up = (0, 1, 0) if camera == "plan" else (0, 0, 1)
    width, height = plotter.window_size
    if camera == "plan":
        plotter.camera.position = centre + away * 10 * length
        plotter.enable_parallel_projection()
        plotter.camera.parallel_scale = max(0.54 * length * height / width, 0.7 * np.ptp(box[:, 1]))
    else:
        plotter.camera.view_angle = 28
        half = np.tan(np.radians(14))
        points = np.concatenate([mesh.points for mesh in meshes])
        right = np.cross(-away, (0, 0, 1))
        right /= np.linalg.norm(right)
        up = np.cross(right, -away)
        distance = 2 * length
        for _ in range(12):  # centre the picture of the ship, then come as near as it allows
            relative = points - centre
            depth = distance - relative @ away
            across, high = (relative @ right) / depth, (relative @ up) / depth
            centre = centre + distance * (np.mean([across.min(), across.max()]) * right)
            centre = centre + distance * (np.mean([high.min(), high.max()]) * up)
            distance *= max(
                np.ptp(across) / (2 * half * width / height * 0.90), np.ptp(high) / (2 * half * 0.66)
            )
        plotter.camera.focal_point = centre
        plotter.camera.position = centre + away * distance
        plotter.camera.clipping_range = (distance / 50, distance * 12)
    if title:
        _write(plotter, title, (0.02, 0.93), "title")


if __name__ == "__main__":
    paint(pickle.loads(Path(sys.argv[1]).read_bytes()))
