"""Pressure over the wet deck: of one slam in time, and of all slams of a record."""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import checked_number
from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.panel_blocks import block_sizes
from workbench.wet_deck_pressure.record_tally import (
    COUNTED,
    METHOD,
    Tally,
    attributes,
    counts_of,
    notes,
    resultant,
)
from workbench.wet_deck_pressure.settings import DeckPressureSettings
from workbench.wet_deck_pressure.steps import Steps, pressure_steps
from workbench.wet_deck_pressure.strips import DeckStrips
from workbench.wet_deck_pressure.windows import WetStretches, wet_stretches

SUBSTEPS = 5
"""Steps of the pressure in one step of the record."""

_INSTANTS_AT_ONCE = 1500


def history(
    motion: DeckMotion,
    strips: DeckStrips,
    density: float,
    settings: DeckPressureSettings,
    start: float,
    end: float,
) -> xr.Dataset:
    """Pressure over the deck against time between two instants.

    Parameters
    ----------
    motion : water against the deck; strips : of the deck; density : [kg/m3].
    start, end : within the record [s].

    Returns
    -------
    Dataset over (time, x, y): ``deck_pressure``, mean over panel and step; over time ``deck_force``, upwards,
    ``deck_pitch_moment`` about the origin (bow up positive, as a force forward lifts the bow),
    ``deck_force_x``, ``deck_force_y``, ``wetted_area``, ``root_pressure``. The times are the middles of the
    steps.

    Notes
    -----
    One second at 2 ms on 400 panels costs about 0.2 s.
    """
    step = settings.time_step or motion.time_step / SUBSTEPS
    _check_within(motion, start, end)
    count = max(1, int(np.ceil((end - start) / step - 1e-9)))
    times, step = np.linspace(start, end, count + 1, retstep=True)
    parts = [
        pressure_steps(motion, strips, times[i : i + _INSTANTS_AT_ONCE + 1], density, settings)
        for i in range(0, count, _INSTANTS_AT_ONCE)
    ]
    pressure = strips.on_grid(np.concatenate([part.pressure for part in parts]))
    force, moment, at_x, at_y = resultant(pressure, motion, strips)
    return quantities.dataset(
        {"time": (times[1:] + times[:-1]) / 2, "x": motion.x, "y": motion.y},
        method=METHOD,
        attrs=attributes(settings, strips, density, step, counts_of(parts)),
        warnings=notes(counts_of(parts)),
        deck_pressure=(("time", "x", "y"), pressure),
        deck_force=("time", force),
        deck_pitch_moment=("time", moment),
        deck_force_x=("time", at_x),
        deck_force_y=("time", at_y),
        wetted_area=("time", np.concatenate([part.wetted_area for part in parts])),
        root_pressure=("time", np.concatenate([part.root_pressure for part in parts])),
    )


def slams_of_record(
    motion: DeckMotion,
    strips: DeckStrips,
    density: float,
    settings: DeckPressureSettings,
    gap: float,
    marking: np.ndarray | None = None,
    progress: Callable[[float, str], None] = lambda fraction, message: None,
) -> xr.Dataset:
    """Pressure, force and impulse of all slams of a record.

    Parameters
    ----------
    motion : water against the deck; strips : of the deck; density : [kg/m3].
    gap : dry time up to which two contacts are one slam [s].
    marking : (x, y) whether a panel that gets wet marks a slam, as for `wet_stretches`.
    progress : called with the fraction done and a sentence; may raise to cancel.

    Returns
    -------
    Dataset; over slam: ``slam_start``, ``slam_duration``, ``slam_force`` largest upward, ``slam_impulse`` of
    the upward force, ``slam_force_x``, ``slam_force_y`` at the largest force, ``slam_pressure`` largest of a
    panel, ``slam_x``, ``slam_y`` where, ``slam_wetted_area``, ``slam_is_whole``; over (slam, x, y)
    ``slam_panel_pressure``; over (x, y) ``pressure_envelope``; over block ``block_area``,
    ``block_pressure``; over time ``deck_force``, mean over the record's steps.

    Notes
    -----
    A slam that the record cuts at its beginning or end is in the envelope, and is marked. One hour on 400
    panels with several hundred slams takes about 10 s on two cores.
    """
    step = checked_number(
        "time step of the pressures",
        settings.time_step or motion.time_step / SUBSTEPS,
        "s",
        above=0,
        at_most=motion.time_step * (1 + 1e-9),
        cure="the record's own step is the coarsest",
    )
    substeps = round(motion.time_step / step)
    stretches = wet_stretches(motion, strips, gap, marking)
    sizes = block_sizes(len(motion.x), len(motion.y))
    tally = Tally(motion, strips, stretches, sizes, substeps)
    batches = list(_batches(stretches, substeps))

    def computed(batch) -> Steps:
        times = motion.start + motion.time_step * batch[0]
        return pressure_steps(motion, strips, times, density, settings)

    with ThreadPoolExecutor(2) as pool:
        for done, (batch, steps) in enumerate(zip(batches, pool.map(computed, batches), strict=True), 1):
            tally.add(*batch, steps)
            progress(done / len(batches), "pressure over the deck")
    return tally.dataset(settings, density)


def joined(parts: list[xr.Dataset]) -> xr.Dataset:
    """Join the results of stretches of one record that follow each other, as `slams_of_record` gives them."""
    if len(parts) == 1:
        return parts[0]
    over = {"slam": "slam", "deck_force": "time"}
    variables = {}
    for name, first in parts[0].data_vars.items():
        dim = over.get(str(name), "slam" if "slam" in first.dims else "")
        values = [part[name].values for part in parts]
        if dim:
            variables[name] = (first.dims, np.concatenate(values, axis=first.dims.index(dim)))
        else:
            variables[name] = (first.dims, np.maximum.reduce(values))
    count = sum(part.sizes["slam"] for part in parts)
    return quantities.dataset(
        {
            "slam": np.arange(count),
            "x": parts[0].x,
            "y": parts[0].y,
            "time": np.concatenate([part.time.values for part in parts]),
            "block": parts[0].block,
        },
        method=parts[0].attrs["method"],
        attrs=parts[0].attrs
        | {name: sum(part.attrs[name] for part in parts) for name in ("duration", *COUNTED)},
        warnings=notes(np.sum([[part.attrs[name] for name in COUNTED] for part in parts], axis=0)),
        **variables,
    )


def _check_within(motion: DeckMotion, start: float, end: float) -> None:
    last = motion.start + motion.duration
    checked_number("start of the pressure history", start, "s", at_least=motion.start, below=last)
    checked_number("end of the pressure history", end, "s", above=start, at_most=last * (1 + 1e-12))


def _batches(stretches: WetStretches, substeps: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Instants in samples of the record and the slam of each step between them (-1 between stretches)."""
    places, slams, size = [], [], 0
    for first, last, slam in zip(stretches.first, stretches.last, stretches.slam, strict=True):
        for begin in range(first, last, max(_INSTANTS_AT_ONCE // substeps, 1)):
            end = min(begin + max(_INSTANTS_AT_ONCE // substeps, 1), last)
            own = np.linspace(begin, end, (end - begin) * substeps + 1)
            places.append(own)
            slams.append(np.concatenate([np.full(len(own) - 1, slam), [-1]]))
            size += len(own)
            if size >= _INSTANTS_AT_ONCE:
                yield np.concatenate(places), np.concatenate(slams)[:-1]
                places, slams, size = [], [], 0
    if places:
        yield np.concatenate(places), np.concatenate(slams)[:-1]
