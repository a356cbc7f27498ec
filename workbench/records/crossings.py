"""Waves of a record between its zero-crossings, their heights and crests, and how often levels are exceeded.

.. [LonguetHiggins1952] M. S. Longuet-Higgins, "On the statistical distribution of the heights of
    sea waves", J. Marine Research 11(3), 245-266, 1952.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError


def zero_upcrossings(time, values, least: float = 0.0) -> np.ndarray:
    """Times at which a record rises through its zero, between samples by a line (crossing) [s].

    Parameters
    ----------
    time : [s]; values : (time).
    least : depth and height that the record must reach before and after a crossing for it
        to count, against noise; in the unit of the record.
    """
    time, values = np.asarray(time, float), np.asarray(values, float)
    before = np.flatnonzero((values[:-1] < 0) & (values[1:] >= 0))
    if least > 0:
        beyond = np.flatnonzero(np.abs(values) > least)
        turned = np.flatnonzero((values[beyond[:-1]] < 0) & (values[beyond[1:]] > 0))
        first = np.searchsorted(before, beyond[turned])
        before = before[first[first < len(before)]]
    share = values[before] / (values[before] - values[before + 1])
    return time[before] + share * (time[before + 1] - time[before])


def waves(time, values) -> xr.Dataset:
    """Waves between zero up-crossings of a record about its mean (event).

    Returns
    -------
    Dataset over event: ``event_time`` of the up-crossing that begins it, ``wave_period``,
    ``crest``, ``trough`` (depth, positive), ``double_amplitude``.
    """
    time, values = np.asarray(time, float), np.asarray(values, float)
    about = values - values.mean()
    rising = np.flatnonzero((about[:-1] < 0) & (about[1:] >= 0)) + 1
    if len(rising) < 2:
        raise InputError("record must rise through its mean at least twice to hold a wave.")
    instants = zero_upcrossings(time, about)
    crest = np.maximum.reduceat(about, rising)[:-1]
    trough = -np.minimum.reduceat(about, rising)[:-1]
    return quantities.dataset(
        {"event": np.arange(len(crest))},
        method="zero up-crossings",
        event_time=("event", instants[:-1]),
        wave_period=("event", np.diff(instants)),
        crest=("event", crest),
        trough=("event", trough),
        double_amplitude=("event", crest + trough),
    )


def significant(values) -> float:
    """Significant single amplitude, 2 sqrt(m0), of a record about its mean."""
    return float(2 * np.std(np.asarray(values, float)))


def rayleigh_exceedance(levels, deviation: float) -> np.ndarray:
    """Share of the crests above levels for a narrow band, exp(-x^2/2 m0) [-] ([LonguetHiggins1952]_)."""
    if not deviation > 0:
        raise InputError(f"deviation must be > 0 for an exceedance, got {deviation:g}.")
    return np.exp(-(np.maximum(np.asarray(levels, float), 0.0) ** 2) / (2 * deviation**2))


def exceedance(time, values, levels) -> xr.Dataset:
    """Share of the crests of a record above levels: counted, and by Rayleigh's law (level).

    Parameters
    ----------
    time : [s]; values : (time), taken about their mean; levels : >= 0, in the unit of the record.

    Notes
    -----
    Rayleigh's law holds for narrow bands and is on the safe side for wider ones.
    """
    found = waves(time, values)
    levels = np.asarray(levels, float)
    counted = np.array([float(np.mean(found.crest.values > level)) for level in levels])
    return quantities.dataset(
        {"level": levels},
        method="zero up-crossings",
        attrs={"waves": found.sizes["event"]},
        exceedance_counted=("level", counted),
        exceedance_rayleigh=("level", rayleigh_exceedance(levels, float(np.std(values)))),
    )
