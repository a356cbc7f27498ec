"""Pressure over the wet deck: of one slam in time, and of all slams of a record."""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import checked_number
from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.panel_blocks import block_sizes, largest_averages
from workbench.wet_deck_pressure.settings import DeckPressureSettings
from workbench.wet_deck_pressure.steps import Steps, pressure_steps
from workbench.wet_deck_pressure.strips import DeckStrips
from workbench.wet_deck_pressure.windows import WetStretches, wet_stretches

METHOD = "Wagner's wetted intervals along strips of the deck"
SUBSTEPS = 5
"""Steps of the pressure in one step of the record."""

_INSTANTS_AT_ONCE = 1500
_COUNTED = "unsettled_intervals", "jet_roots", "jet_roots_below_3_degrees"


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
    force, moment, at_x, at_y = _resultant(pressure, motion, strips)
    return quantities.dataset(
        {"time": (times[1:] + times[:-1]) / 2, "x": motion.x, "y": motion.y},
        method=METHOD,
        attrs=_attributes(settings, strips, density, step, _counts(parts)),
        warnings=_notes(_counts(parts)),
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
    tally = _Tally(motion, strips, stretches, sizes, substeps)
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
        | {name: sum(part.attrs[name] for part in parts) for name in ("duration", *_COUNTED)},
        warnings=_notes(np.sum([[part.attrs[name] for name in _COUNTED] for part in parts], axis=0)),
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


def _resultant(pressure: np.ndarray, motion: DeckMotion, strips: DeckStrips):
    """Force [N], bow-up moment about the origin [N m] and place of the force [m] of a pressure (time, x, y)."""
    load = pressure * strips.panel_area
    force = load.sum(axis=(1, 2))
    moment = np.einsum("txy,x->t", load, motion.x)
    across = np.einsum("txy,y->t", load, motion.y)
    with np.errstate(divide="ignore", invalid="ignore"):
        inside = np.abs(force) > 1e-9 * np.abs(load).sum(axis=(1, 2)) + 1e-300
        return (
            force,
            moment,
            np.where(inside, moment / force, np.nan),
            np.where(inside, across / force, np.nan),
        )


def _attributes(
    settings: DeckPressureSettings, strips: DeckStrips, density: float, step: float, counts
) -> dict:
    return {
        "strips": strips.direction,
        "frame": settings.frame,
        "pressure_model": settings.pressure,
        "suction": float(settings.suction),
        "reduction": settings.reduction,
        "density": float(density),
        "time_step": float(step),
        "panel_length": float(strips.edges[1] - strips.edges[0]),
        "strip_width": float(strips.width),
        **dict(zip(_COUNTED, (int(count) for count in counts), strict=True)),
    }


def _counts(parts: list[Steps]) -> np.ndarray:
    """Intervals without solution, advancing jet roots, and those at less than 3 degrees."""
    return np.array([(part.unsettled, part.roots, part.fast_roots) for part in parts]).sum(axis=0)


def _notes(counts: np.ndarray) -> tuple[str, ...]:
    unsettled, roots, fast = counts
    found = []
    if unsettled:
        found.append(
            f"{unsettled} wetted intervals had no solution of Wagner's condition and were taken from undisturbed water."
        )
    if fast > 0.01 * roots:
        found.append(
            f"{100 * fast / roots:.0f} % of the jet roots meet the deck at less than 3 degrees: air is trapped there, "
            "and the real pressure is lower than that of a theory without air."
        )
    return tuple(found)


class _Tally:
    """Running results of a record."""

    def __init__(self, motion, strips, stretches: WetStretches, sizes, substeps: int):
        self.motion, self.strips, self.stretches, self.sizes = motion, strips, stretches, sizes
        self.substeps = substeps
        count, shape = len(stretches.is_whole), (len(motion.x), len(motion.y))
        self.panel = np.zeros((count, *shape), np.float32)
        self.blocks = np.zeros((count, len(sizes)))
        self.largest = {name: np.zeros(count) for name in ("force", "area", "root")}
        self.impulse, self.force_x, self.force_y = (
            np.zeros(count),
            np.full(count, np.nan),
            np.full(count, np.nan),
        )
        self.history = np.zeros(max(len(motion.rise) - 1, 0))
        self.counts = np.zeros(3, int)

    def add(self, places: np.ndarray, slam: np.ndarray, steps: Steps) -> None:
        """Take in a batch of steps."""
        kept = slam >= 0
        slam = slam[kept]
        pressure = self.strips.on_grid(steps.pressure)[kept]
        force, _, at_x, at_y = _resultant(pressure, self.motion, self.strips)
        first = np.flatnonzero(np.concatenate([[True], slam[1:] != slam[:-1]]))
        own = slam[first]
        self.panel[own] = np.maximum(self.panel[own], np.maximum.reduceat(pressure, first, axis=0))
        averages = largest_averages(pressure, self.sizes)
        self.blocks[own] = np.maximum(self.blocks[own], np.maximum.reduceat(averages, first, axis=0))
        step = self.motion.time_step / self.substeps
        np.add.at(self.impulse, slam, np.maximum(force, 0.0) * step)
        sample = np.floor(places[:-1][kept] + 1e-9).astype(int)
        np.add.at(self.history, np.minimum(sample, len(self.history) - 1), force / self.substeps)
        for name, values in (
            ("force", force),
            ("area", steps.wetted_area[kept]),
            ("root", steps.root_pressure[kept]),
        ):
            before = self.largest[name][own]
            top = np.maximum.reduceat(values, first)
            if name == "force":
                for index, number in enumerate(own):
                    if top[index] > before[index]:
                        end = first[index + 1] if index + 1 < len(first) else len(force)
                        place = first[index] + int(np.argmax(force[first[index] : end]))
                        self.force_x[number], self.force_y[number] = at_x[place], at_y[place]
            self.largest[name][own] = np.maximum(before, top)
        self.counts += _counts([steps])

    def dataset(self, settings: DeckPressureSettings, density: float) -> xr.Dataset:
        """Return the results."""
        motion, stretches = self.motion, self.stretches
        count = len(stretches.is_whole)
        start, end = np.zeros(count), np.zeros(count)
        np.maximum.at(end, stretches.slam, stretches.last)
        start[stretches.slam[::-1]] = stretches.first[::-1]
        flat = self.panel.reshape(count, len(motion.x) * len(motion.y))
        place = np.unravel_index(flat.argmax(axis=1), self.panel.shape[1:])
        area = self.strips.panel_area
        envelope = self.panel.max(axis=0, initial=0.0)
        return quantities.dataset(
            {
                "slam": np.arange(count),
                "x": motion.x,
                "y": motion.y,
                "time": motion.start + motion.time_step * (np.arange(len(self.history)) + 0.5),
                "block": np.arange(len(self.sizes)),
            },
            method=METHOD,
            attrs=_attributes(settings, self.strips, density, motion.time_step / self.substeps, self.counts)
            | {"duration": float(motion.duration)},
            warnings=_notes(self.counts),
            slam_start=("slam", motion.start + motion.time_step * start),
            slam_duration=("slam", motion.time_step * (end - start)),
            slam_force=("slam", self.largest["force"]),
            slam_impulse=("slam", self.impulse),
            slam_force_x=("slam", self.force_x),
            slam_force_y=("slam", self.force_y),
            slam_pressure=("slam", flat.max(axis=1, initial=0.0)),
            slam_x=("slam", motion.x[place[0]]),
            slam_y=("slam", motion.y[place[1]]),
            slam_wetted_area=("slam", self.largest["area"]),
            slam_root_pressure=("slam", self.largest["root"]),
            slam_is_whole=("slam", stretches.is_whole.astype(np.int8)),
            slam_panel_pressure=(("slam", "x", "y"), self.panel),
            slam_block_pressure=(("slam", "block"), self.blocks),
            pressure_envelope=(("x", "y"), envelope),
            block_area=("block", [along * across * area for along, across in self.sizes]),
            block_pressure=("block", self.blocks.max(axis=0, initial=0.0)),
            deck_force=("time", self.history),
        )
