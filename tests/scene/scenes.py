"""Synthetic scenes for the painters: a catamaran in irregular head seas, made without any physics module."""

import numpy as np

from workbench.scene.description import scene_description

GRAVITY = 9.80665
LENGTH, SPACING, BEAM, DRAUGHT, DEPTH, CLEARANCE = 80.0, 18.0, 5.0, 2.8, 7.0, 2.6


def hull(n_x: int = 40, n_z: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (nv, 3) and quadrilaterals (nf, 4) of two slender hulls with transoms and flared bows."""
    x = np.linspace(-LENGTH / 2, LENGTH / 2, n_x)
    s = np.linspace(0, 1, n_z)
    ahead = np.clip(x / (LENGTH / 2), 0, 1)[:, None]
    z = (
        -DRAUGHT * (1 - 0.25 * np.clip(-x / (LENGTH / 2), 0, 1)[:, None]) * (1 - s)
        + (DEPTH + 1.5 * ahead**2) * s
    )
    full = np.clip(s / 0.28, 0, 1) ** 0.55
    half_breadth = (
        BEAM / 2 * full * (1 - ahead ** (2.2 + 2.5 * s)) * (0.8 + 0.2 * np.cos(x / LENGTH)[:, None])
    )
    rake = x[:, None] + 4.0 * ahead**4 * s
    index = np.arange(n_x * n_z).reshape(n_x, n_z)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    vertices, faces = [], []
    for centre in (-SPACING / 2, SPACING / 2):
        for side in (-1, 1):
            start = sum(len(one) for one in vertices)
            vertices.append(np.stack([rake, centre + side * half_breadth, z], -1).reshape(-1, 3))
            order = (a, b, c, d) if side < 0 else (d, c, b, a)
            faces.append(np.stack([corner.ravel() for corner in order], -1) + start)
        other = start - n_x * n_z
        low, high = np.arange(n_z - 1), np.arange(1, n_z)
        faces.append(np.stack([start + low, start + high, other + high, other + low], -1))
    return np.concatenate(vertices), np.concatenate(faces)


def sea(n: int = 40, significant_wave_height: float = 4.0, seed: int = 4) -> dict[str, np.ndarray]:
    """Wave components of a head sea of 8.5 s with some spreading, seen at 12 m/s."""
    rng = np.random.default_rng(seed)
    omega = np.linspace(0.4, 1.6, n) + rng.uniform(-0.014, 0.014, n)
    peak = 2 * np.pi / 8.5
    spectrum = omega**-5 * np.exp(-1.25 * (peak / omega) ** 4)
    spectrum *= significant_wave_height**2 / 16 / np.sum(spectrum * 1.2 / n)
    direction = np.pi + rng.normal(0, 0.35, n)
    k = omega**2 / GRAVITY
    return {
        "component_amplitude": np.sqrt(2 * spectrum * 1.2 / n),
        "component_frequency": omega - k * 12.0 * np.cos(direction),
        "component_kx": k * np.cos(direction),
        "component_ky": k * np.sin(direction),
        "component_phase": rng.uniform(0, 2 * np.pi, n),
    }


def elevation(components, time, x, y):
    """Elevation (time, x, y) of the components."""
    amplitude, frequency, kx, ky, phase = components.values()
    along = np.exp(1j * (kx * x[:, None]))
    across = np.exp(1j * (ky * y[:, None]))
    weight = amplitude * np.exp(1j * (phase - frequency * time[:, None]))
    return np.einsum("tc,xc,yc->txy", weight, along, across, optimize=True).real


def demo_scene(
    duration: float = 40.0, step: float = 0.1, film: bool = False, grid: tuple = (90, 60), **changes
):
    """Scene of a catamaran in irregular seas, with three fields on a deck of 30 x 12 points and its slams."""
    time = np.arange(0, duration + step / 2, step)
    components = sea()
    amplitude, frequency, kx, _, phase = components.values()
    pose = np.zeros((time.size, 6))
    gain = 1 / (1 + (kx * LENGTH / 3.2) ** 4)
    angle = phase - frequency * time[:, None]
    pose[:, 2] = np.cos(angle - 0.5) @ (amplitude * gain)
    pose[:, 4] = np.sin(angle - 0.3) @ (amplitude * kx * gain * 0.8)
    pose[:, 3] = 0.012 * np.sin(0.8 * time)
    x, y = np.linspace(-32, 30, 30), np.linspace(-7.2, 7.2, 12)
    height = CLEARANCE + 0.02 * np.clip(x - 10, 0, None)[:, None] ** 1.3 + 0.25 * (1 - (y / 7.2) ** 2)
    vertical = pose[:, 2, None, None] - x[:, None] * pose[:, 4, None, None] + y * pose[:, 3, None, None]
    relative = 1.25 * elevation(components, time, x, y) - vertical
    left = height - relative
    velocity = np.gradient(relative, time, axis=0)
    entering = (left[1:] < 0) & (left[:-1] >= 0) & (velocity[1:] > 1.0)
    at, i, j = np.nonzero(entering)
    peak = 0.5 * 1025 * velocity[at + 1, i, j] ** 2 * 9.0
    pressure = np.zeros_like(relative)
    for t0, a, b, p in zip(at, i, j, peak, strict=True):
        later = time[t0 + 1 :] - time[t0 + 1]
        pressure[t0 + 1 :, a, b] = np.maximum(pressure[t0 + 1 :, a, b], p * np.exp(-later / 0.35))
    pressure[pressure < 200] = 0
    water = components
    if film:
        sea_x, sea_y = np.linspace(-120, 130, grid[0]), np.linspace(-80, 80, grid[1])
        water = {"sea_x": sea_x, "sea_y": sea_y, "elevation": elevation(components, time, sea_x, sea_y)}
    vertices, faces = hull()
    parts = {
        "time": time,
        "pose": pose,
        "hull_vertices": vertices,
        "hull_faces": faces,
        "x": x,
        "y": y,
        "deck_height": height,
        "water": water,
        "fields": {"relative_motion_history": relative, "clearance_left": left, "pressure": pressure},
        "slams": {
            "event_time": time[at + 1],
            "event_x": x[i],
            "event_y": y[j],
            "entry_velocity": velocity[at + 1, i, j],
            "peak_pressure": peak,
        },
        "title": "Catamaran of 80 m in head seas of 4 m at 12 m/s",
        "speed": 12.0,
    }
    return scene_description(**{**parts, **changes})
