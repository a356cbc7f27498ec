"""Running results of a record, slam by slam, and what every result of the deck's pressure says of itself."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.panel_blocks import largest_averages
from workbench.wet_deck_pressure.settings import DeckPressureSettings
from workbench.wet_deck_pressure.steps import Steps
from workbench.wet_deck_pressure.strips import DeckStrips
from workbench.wet_deck_pressure.windows import WetStretches

METHOD = "Wagner's wetted intervals along strips of the deck"
COUNTED = "unsettled_intervals", "jet_roots", "jet_roots_below_3_degrees"
"""Attributes of every result: intervals without solution, jet roots that advance, and those at less than 3 degrees."""


def resultant(pressure: np.ndarray, motion: DeckMotion, strips: DeckStrips):
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


def attributes(
    settings: DeckPressureSettings, strips: DeckStrips, density: float, step: float, counts
) -> dict:
    """What a result was made with, for its attributes."""
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
        **dict(zip(COUNTED, (int(count) for count in counts), strict=True)),
    }


def counts_of(parts: list[Steps]) -> np.ndarray:
    """Intervals without solution, advancing jet roots, and those at less than 3 degrees."""
    return np.array([(part.unsettled, part.roots, part.fast_roots) for part in parts]).sum(axis=0)


def notes(counts: np.ndarray) -> tuple[str, ...]:
    """Sentences on what the counts of `counts_of` mean for the result."""
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


class Tally:
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
        force, _, at_x, at_y = resultant(pressure, self.motion, self.strips)
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
        self.counts += counts_of([steps])

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
            attrs=attributes(settings, self.strips, density, motion.time_step / self.substeps, self.counts)
            | {"duration": float(motion.duration)},
            warnings=notes(self.counts),
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
