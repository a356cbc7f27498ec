"""Pressure over the deck in time packed into the few binary blocks that the browser reads."""

import numpy as np
import xarray as xr

from workbench.errors import InputError
from workbench.scene.packing import deck_field

LARGEST = 1e6
"""Size of the pressures that are sent to a browser; longer histories are thinned in time [bytes]."""

HIGHEST = 65535
"""Largest 16-bit integer that a pressure is stored as."""

HISTORIES = ("deck_force", "wetted_area", "deck_force_x", "deck_force_y")
"""Curves over time, in the order of their block; NaN where the force has no place."""

_SCALES = ((1e6, "MN"), (1e3, "kN"))


def packed_history(history: xr.Dataset, *, title: str = "", slow: float = 10.0, origin: float = 0.0) -> dict:
    """Pressure in time as a dict of JSON (``facts``) and binary blocks.

    Parameters
    ----------
    history : over (time, x, y) ``deck_pressure`` [Pa], over time ``deck_force`` [N], ``deck_force_x``,
        ``deck_force_y`` [m] and ``wetted_area`` [m2], as `workbench.pressure_stage.slam_history` gives it; the
        times evenly spaced, at least two.
    title : words above the picture.
    slow : how many seconds one second of the history takes at first.
    origin : time that is shown as 0 [s].

    Returns
    -------
    ``facts``; ``pressure`` uint16 (time, x, y); ``curves`` float32 (curve, time), `HISTORIES`.

    Notes
    -----
    What would be larger than `LARGEST` is thinned: the largest of a few steps stands for them, so that no
    peak is lost. Colours and limits are those of `workbench.scene.packing.deck_field`.
    """
    time, pressure, curves, every = _thinned(history)
    field = deck_field(history.deck_pressure.rename("pressure"))
    least, most = min(float(pressure.min()), 0.0), max(float(pressure.max()), 1e-9)
    stored = np.rint((pressure - least) / (most - least) * HIGHEST).astype("<u2")
    largest = float(np.nanmax(np.abs(curves[0]), initial=0.0))
    scale, unit = next((one for one in _SCALES if largest >= one[0]), _SCALES[-1])
    facts = {
        "title": title,
        "start": float(time[0]),
        "step": float((time[-1] - time[0]) / (len(time) - 1)),
        "count": len(time),
        "origin": float(origin),
        "slow": float(slow),
        "every": every,
        "x": [float(one) for one in history.x],
        "y": [float(one) for one in history.y],
        "stored": [least, most],
        "field": field,
        "force": {"unit": unit, "scale": scale},
    }
    return {
        "facts": facts,
        "pressure": stored.tobytes(),
        "curves": np.ascontiguousarray(curves, dtype="<f4").tobytes(),
    }


def _thinned(history: xr.Dataset) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """Times, pressures (time, x, y), curves (curve, time), and how many steps each of them stands for."""
    missing = [name for name in ("deck_pressure", *HISTORIES) if name not in history]
    if missing:
        raise InputError(
            f"A history of the pressure over the deck needs {', '.join(missing)}; take it from slam_history."
        )
    if history.sizes["time"] < 2 or history.sizes["x"] < 2 or history.sizes["y"] < 2:
        raise InputError(
            "A history of the pressure over the deck needs at least 2 times and 2 x 2 panels, got "
            f"{history.sizes['time']} times and {history.sizes['x']} x {history.sizes['y']} panels."
        )
    pressure = np.nan_to_num(history.deck_pressure.transpose("time", "x", "y").values)
    time = history.time.values
    steps = np.diff(time)
    if np.ptp(steps) > 1e-3 * steps.mean():
        raise InputError("The times of a history of the pressure must be evenly spaced; resample it.")
    curves = [history[name].values for name in HISTORIES]
    every = max(1, int(np.ceil(2 * pressure.size / LARGEST)))
    if every == 1:
        return time, pressure, np.array(curves), 1
    first = np.arange(0, len(time), every)
    force = curves[0]
    hardest = np.array([start + int(np.argmax(force[start : start + every])) for start in first])
    thinned = [np.maximum.reduceat(curve, first) for curve in curves[:2]]
    thinned += [curve[hardest] for curve in curves[2:]]
    middle = (every - 1) / 2 * steps.mean()
    return time[first] + middle, np.maximum.reduceat(pressure, first, axis=0), np.array(thinned), every
