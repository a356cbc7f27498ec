"""The scene: one Dataset with everything that the 3-D painters draw, and nothing else.

A scene holds the motion of the ship, the water, the hull surface, the wet deck
with its fields, and the slams, all sampled on one uniform time axis. The water
is either a film (``elevation`` on a grid that advances with the ship) or a sum
of long-crested components, with x, y in the advancing frame::

    elevation = sum_j a_j cos(kx_j x + ky_j y - omega_e_j t + phase_j)

where the encounter frequency omega_e is signed.
"""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import MODES
from workbench.errors import InputError, checked_number

DECK_FIELDS = ("relative_motion_history", "clearance_left", "pressure")
"""Fields over the wet deck that may be drawn, each (time, x, y)."""

COMPONENTS = (
    "component_amplitude",
    "component_frequency",
    "component_kx",
    "component_ky",
    "component_phase",
)
"""The wave components of a linear sea, each (component)."""

HISTORIES = ("deck_force", "deck_force_x", "deck_force_y", "wetted_area")
"""Force on the wet deck and its wetted area, each (time)."""

EVENTS = ("event_time", "event_x", "event_y", "entry_velocity", "peak_pressure")
"""The slams, each (event)."""

_DIMS = {
    "time": ("time",),
    "pose": ("time", "dof"),
    "sea_x": ("sea_x",),
    "sea_y": ("sea_y",),
    "elevation": ("time", "sea_x", "sea_y"),
    "hull_vertices": ("vertex", "axis"),
    "hull_faces": ("face", "corner"),
    "x": ("x",),
    "y": ("y",),
    "deck_height": ("x", "y"),
    **{name: ("time", "x", "y") for name in DECK_FIELDS},
    **{name: ("time",) for name in HISTORIES},
    **{name: ("component",) for name in COMPONENTS},
    **{name: ("event",) for name in EVENTS},
}
_COORDINATES = ("time", "sea_x", "sea_y", "x", "y")
_REQUIRED = ("time", "pose", "hull_vertices", "hull_faces", "x", "y", "deck_height")
_FIXED_SIZES = {"dof": 6, "axis": 3, "corner": 4}
_MAY_HAVE_GAPS = ("elevation", *DECK_FIELDS, "deck_force_x", "deck_force_y")


def scene_description(
    *,
    time,
    pose,
    hull_vertices,
    hull_faces,
    x,
    y,
    deck_height,
    water: Mapping,
    fields: Mapping | None = None,
    histories: Mapping | None = None,
    slams: Mapping | None = None,
    title: str = "",
    speed: float = 0.0,
) -> xr.Dataset:
    """Scene made of plain arrays.

    Parameters
    ----------
    time : (n_t,), uniform and rising, at least two samples [s].
    pose : (n_t, 6), motion of the ship's origin: surge, sway, heave [m], roll, pitch, yaw [rad];
        small angles, pitch positive bow down.
    hull_vertices : (n_v, 3), surface of all hulls up to their depth, in ship axes [m].
    hull_faces : (n_f, 4), vertex numbers; a triangle repeats one.
    x, y : (n_x,) and (n_y,), rising, at least two each: centres of the cells of the wet deck [m].
    deck_height : (n_x, n_y), height of the wet deck above still water, ship at rest [m].
    water : ``elevation`` (n_t, n_sea_x, n_sea_y) [m] with ``sea_x``, ``sea_y`` [m]; or
        ``component_amplitude`` [m], ``component_frequency`` [rad/s], ``component_kx``,
        ``component_ky`` [rad/m] and ``component_phase`` [rad], each (n_components,).
        The elevation may be NaN inside the hulls: it is drawn there as still water.
    fields : any of ``relative_motion_history`` [m], ``clearance_left`` [m] and ``pressure`` [Pa],
        each (n_t, n_x, n_y); NaN where there is no value.
    histories : ``deck_force`` [N], ``deck_force_x``, ``deck_force_y`` [m] and ``wetted_area`` [m2], each (n_t,);
        NaN where the force has no place.
    slams : ``event_time`` [s], ``event_x``, ``event_y`` [m], ``entry_velocity`` [m/s] and
        ``peak_pressure`` [Pa], each (n_events,).
    title : words above the picture.
    speed : forward speed [m/s].

    Returns
    -------
    Dataset with these names as variables, checked; ``title`` and ``speed`` in its attributes.
    """
    arrays = {
        "time": time,
        "pose": pose,
        "hull_vertices": hull_vertices,
        "hull_faces": hull_faces,
        "x": x,
        "y": y,
        "deck_height": deck_height,
    }
    for part, allowed in (
        (water, (*COMPONENTS, "sea_x", "sea_y", "elevation")),
        (fields or {}, DECK_FIELDS),
        (histories or {}, HISTORIES),
        (slams or {}, EVENTS),
    ):
        unknown = [str(name) for name in part if name not in allowed]
        if unknown:
            raise InputError(f"A scene has no quantity {', '.join(unknown)}; use {', '.join(allowed)} here.")
        arrays.update(part)
    speed = checked_number("Speed", speed, "m/s")

    values = {name: _numbers(name, value) for name, value in arrays.items()}
    _check_sizes({name: (_DIMS[name], value.shape) for name, value in values.items()})
    coords = {name: values.pop(name) for name in _COORDINATES if name in values}
    coords["dof"] = list(MODES)
    coords["axis"] = ["x", "y", "z"]
    made = quantities.dataset(
        coords,
        attrs={"title": str(title), "speed": speed},
        **{name: (_DIMS[name], value) for name, value in values.items()},
    )
    return checked_scene(made)


def checked_scene(scene: xr.Dataset) -> xr.Dataset:
    """Return the scene, its variables in the order of dimensions above, or raise `InputError`."""
    missing = [name for name in _REQUIRED if name not in scene]
    if missing:
        raise InputError(f"The scene lacks {', '.join(missing)}; make it with scene_description.")
    known = [name for name in _DIMS if name in scene]
    _check_sizes({name: (scene[name].dims, scene[name].shape) for name in known})
    scene = scene.assign({name: scene[name].transpose(*_DIMS[name]) for name in known})
    _check_water(scene)
    _check_complete(scene, EVENTS, "slams")
    _check_complete(scene, HISTORIES, "force on the deck")
    for name in known:
        if name not in _MAY_HAVE_GAPS and not np.isfinite(scene[name].values).all():
            raise InputError(f"The scene's {name} holds values that are not finite; leave those points out.")
    for name in _COORDINATES:
        if name in scene and (np.diff(scene[name].values) <= 0).any():
            raise InputError(f"The scene's {name} must rise from each value to the next; sort it.")
    for name in ("x", "y"):
        if scene.sizes[name] < 2:
            raise InputError(
                f"The wet deck of a scene needs at least 2 points along {name}, got 1; add points."
            )
    _check_time(scene["time"].values)
    faces = scene["hull_faces"].values
    if faces.size and (faces.min() < 0 or faces.max() >= scene.sizes["vertex"]):
        raise InputError(
            f"hull_faces must hold vertex numbers from 0 to {scene.sizes['vertex'] - 1}, "
            f"got {faces.min():.0f} to {faces.max():.0f}; count vertices from 0."
        )
    return scene


def has_components(scene: xr.Dataset) -> bool:
    """Whether the water is a sum of components (else it is a film)."""
    return "component_amplitude" in scene


def elevation_at(scene: xr.Dataset, time: float, x, y) -> np.ndarray:
    """Elevation of the water as drawn [m].

    Parameters
    ----------
    time : one instant within the scene [s].
    x, y : arrays of one shape in the advancing frame [m]; a film gives the value at the
        nearest point of its grid, NaN drawn as still water.
    """
    x, y = np.asarray(x, float), np.asarray(y, float)
    if has_components(scene):
        amplitude, frequency, kx, ky, phase = (scene[name].values for name in COMPONENTS)
        angle = x[..., None] * kx + y[..., None] * ky - frequency * time + phase
        return np.cos(angle) @ amplitude
    film = scene["elevation"]
    instant = film.interp(time=time) if film.sizes["time"] > 1 else film.isel(time=0)
    near = instant.sel(sea_x=xr.DataArray(x), sea_y=xr.DataArray(y), method="nearest")
    return np.nan_to_num(near.values)


def _numbers(name: str, value) -> np.ndarray:
    """Return `value` as a real array of the rank that the quantity has."""
    try:
        array = np.asarray(value, dtype=np.int64 if name == "hull_faces" else float)
    except (TypeError, ValueError):
        raise InputError(f"{name} must be an array of real numbers, got {type(value).__name__}.") from None
    if array.ndim != len(_DIMS[name]):
        raise InputError(
            f"{name} must have the dimensions ({', '.join(_DIMS[name])}), got shape {array.shape}."
        )
    return array


def _check_sizes(arrays: Mapping) -> None:
    """Raise unless dimensions are as named and each has one size throughout."""
    sizes: dict[str, tuple[int, str]] = {dim: (size, "a scene") for dim, size in _FIXED_SIZES.items()}
    for name, (dims, shape) in arrays.items():
        if set(dims) != set(_DIMS[name]):
            raise InputError(
                f"{name} must have the dimensions ({', '.join(_DIMS[name])}), got {tuple(dims)}."
            )
        for dim, size in zip(dims, shape, strict=True):
            expected, owner = sizes.setdefault(dim, (size, name))
            if size != expected:
                raise InputError(
                    f"{name} must have {expected} values along {dim}, as {owner} has, got {size}; "
                    "sample all parts of a scene alike."
                )


def _check_complete(scene: xr.Dataset, names: tuple[str, ...], what: str) -> None:
    """Raise if only some of `names` are there."""
    lacking = [name for name in names if name not in scene]
    if lacking and len(lacking) < len(names):
        raise InputError(f"The scene's {what} lack {', '.join(lacking)}; give all of {', '.join(names)}.")


def _check_water(scene: xr.Dataset) -> None:
    """Raise unless the water is given in exactly one complete way."""
    film, components = "elevation" in scene, any(name in scene for name in COMPONENTS)
    if film == components:
        got = "both" if film else "neither"
        raise InputError(
            f"The water of a scene is either an elevation film or wave components, got {got}; give one."
        )
    if components:
        _check_complete(scene, COMPONENTS, "wave components")
    elif "sea_x" not in scene.coords or "sea_y" not in scene.coords:
        raise InputError("An elevation film needs the coordinates sea_x and sea_y of its grid; give both.")


def _check_time(time: np.ndarray) -> None:
    """Raise unless the time axis is uniform with two samples or more."""
    if time.size < 2:
        raise InputError(f"A scene needs at least 2 instants, got {time.size}; sample it more often.")
    steps = np.diff(time)
    if np.ptp(steps) > 1e-3 * steps.mean():
        raise InputError(
            f"The time of a scene must be uniform, got steps from {steps.min():g} to {steps.max():g} s; "
            "resample it."
        )
