"""Random seas as sums of sines, whose spectrum, derivatives and responses are known."""

from dataclasses import dataclass

import numpy as np

from workbench.records.reading import record
from workbench.seas import SeaState, wave_spectrum


@dataclass(frozen=True, eq=False)
class Sines:
    """Sum of a_j cos(phase_j - omega_j t): zeta of this package at the origin."""

    omega: np.ndarray
    amplitude: np.ndarray
    phase: np.ndarray

    def at(self, time, factor=1.0):
        """Record at even times, each component times a complex factor: Re sum a f exp(i(phase - omega t))."""
        parts = self.amplitude * np.exp(1j * self.phase) * factor
        step = time[1] - time[0]
        table = np.exp(-1j * np.multiply.outer(self.omega, step * np.arange(min(len(time), 2048))))
        starts = time[:: table.shape[1]]
        turned = parts * np.exp(-1j * np.multiply.outer(starts, self.omega))
        return (turned @ table).real.ravel()[: len(time)]


def sines(height=2.0, peak_period=8.0, count=300, low=0.3, high=3.0, seed=1964):
    rng = np.random.default_rng(seed)
    width = (high - low) / count
    omega = low + width * (np.arange(count) + rng.uniform(size=count))
    sea = SeaState(significant_wave_height=height, peak_period=peak_period)
    return Sines(omega, np.sqrt(2 * wave_spectrum(sea, omega) * width), rng.uniform(0, 2 * np.pi, count))


def made_record(time, **channels):
    """Record of named channels, unit after a double underscore: wave__m."""
    names = [name.split("__")[0] for name in channels]
    units = [name.split("__")[1].replace("_per_", "/") for name in channels]
    return record(time, np.stack(list(channels.values()), axis=1), names, units)
