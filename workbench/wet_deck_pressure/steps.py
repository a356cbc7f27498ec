"""Pressure of panels over time steps: what the water gives them from one instant to the next.

While the wetted intervals spread, the mean pressure of a step is the growth of the panels' potential impulse
over the step, whatever happens in between: the impulse is exact for any step, also where water meets a flat
deck at once. Where an end recedes, its singular term must not count, and the mean is that of the pressures
at both instants.
"""

from typing import NamedTuple

import numpy as np

from workbench.conventions import GRAVITY
from workbench.damping.lifting_surfaces import plate_added_mass
from workbench.wet_deck_pressure.deck_motion import DeckMotion
from workbench.wet_deck_pressure.settings import DeckPressureSettings
from workbench.wet_deck_pressure.strip_flow import panel_flow
from workbench.wet_deck_pressure.strip_profiles import StripProfiles, slope_operator
from workbench.wet_deck_pressure.strips import DeckStrips
from workbench.wet_deck_pressure.wetted_interval import WettedIntervals, wetted_intervals


class Steps(NamedTuple):
    """Mean values over the steps between instants (t - 1).

    ``pressure`` (t - 1, strip, panel) mean over each panel, with buoyancy [Pa]; ``wetted_area`` [m2];
    ``root_pressure`` largest pressure at a jet root [Pa]; ``unsettled``: number of intervals for which
    Wagner's condition was not met; ``roots``, ``fast_roots``: advancing jet roots, and those that meet the
    deck at less than 3 degrees.
    """

    pressure: np.ndarray
    wetted_area: np.ndarray
    root_pressure: np.ndarray
    unsettled: int
    roots: int
    fast_roots: int


def pressure_steps(
    motion: DeckMotion, strips: DeckStrips, times: np.ndarray, density: float, settings: DeckPressureSettings
) -> Steps:
    """Mean pressure of every panel over each step between instants.

    Parameters
    ----------
    motion : water against the deck; strips : of the deck.
    times : within the record [s], growing; a step back or of no length stands between two stretches and
        gives nothing.
    density : of the water [kg/m3]; settings : suction and reduction are used.

    Notes
    -----
    Costs some 40 microseconds a strip and instant.
    """
    fields = [strips.by_strip(field) for field in motion.at(times)]
    count, shape = len(times), fields[0].shape[1:]
    wet = (fields[0] > strips.lowest).any(axis=2)
    chosen = np.flatnonzero(wet)
    profiles = _profiles(motion, strips, fields, chosen)
    intervals = wetted_intervals(profiles)
    flow = panel_flow(profiles, intervals, strips.edges, settings.pressure == "logvinovich")
    parts = np.zeros(count * shape[0], int)
    np.add.at(parts, chosen[intervals.row], 1)
    parts = parts.reshape(count, -1)

    def spread_out(values: np.ndarray, dry: float = 0.0) -> np.ndarray:
        full = np.full((count * shape[0], *values.shape[1:]), dry, values.dtype)
        full[chosen] = values
        return full.reshape(count, shape[0], *values.shape[1:])

    impulse, pressure, drift, taken = (
        spread_out(values)
        for values in (flow.potential_impulse, flow.pressure, flow.drift + flow.edges, flow.taken)
    )
    spreading, is_wet = spread_out(flow.is_spreading, True), parts > 0
    if settings.reduction == "pabst":
        share = spread_out(_finite_width(profiles, intervals, strips), 1.0)[..., None]
        impulse, pressure, drift, taken = (share * part for part in (impulse, pressure, drift, taken))
    step = np.where(np.diff(times) > 0, np.diff(times), np.inf)[:, None, None]
    by_impulse = np.diff(impulse, axis=0) / step + (drift[1:] + drift[:-1]) / 2
    grows = spreading[1:] & spreading[:-1] & is_wet[1:] & (parts[1:] >= parts[:-1])
    mean = np.where(grows[..., None], by_impulse, (pressure[1:] + pressure[:-1]) / 2)
    mean -= (taken[1:] + taken[:-1]) / 2
    mean[np.isinf(step[:, 0, 0])] = 0.0
    panel_length = float(strips.edges[1] - strips.edges[0])
    depth = np.maximum(fields[0] - strips.mean, 0.0) * is_wet[..., None]
    total = density * (mean / panel_length + GRAVITY * (depth[1:] + depth[:-1]) / 2)
    total = np.maximum(total, 0.0 - settings.suction) + 0.0  # no negative zeros

    area = np.zeros(len(chosen))
    np.add.at(area, intervals.row, intervals.fore - intervals.aft)
    area = strips.width * spread_out(area).sum(axis=1)
    root = density * spread_out(flow.root_pressure).max(axis=1, initial=0.0)
    return Steps(
        total,
        (area[1:] + area[:-1]) / 2,
        np.maximum(root[1:], root[:-1]),
        int(np.sum(~intervals.settled)),
        flow.roots,
        flow.fast_roots,
    )


def _finite_width(profiles: StripProfiles, intervals: WettedIntervals, strips: DeckStrips) -> np.ndarray:
    """Added mass of a plate as long as the wetted part and as wide as the deck, over that of a strip of it (row)."""
    length = np.full(len(profiles), 1e-9)
    np.add.at(length, intervals.row, intervals.fore - intervals.aft)
    width = strips.width * len(strips.table)
    return plate_added_mass(length, width, 1.0) / (np.pi / 4 * length**2 * width)


def _profiles(
    motion: DeckMotion, strips: DeckStrips, fields: list[np.ndarray], chosen: np.ndarray
) -> StripProfiles:
    """Profiles of the chosen rows (instant and strip)."""
    count = len(strips.nodes)
    rise, velocity, acceleration = (field.reshape(-1, count)[chosen].astype(float) for field in fields)
    strip = chosen % len(strips.table)
    edge_speed = motion.speed if strips.is_lengthwise else 0.0
    if edge_speed:
        # a deck that rises forward closes on the water as it advances; its curvature at steady speed is no slam
        velocity = velocity + edge_speed * (strips.smooth @ slope_operator(strips.nodes).T)[strip]
    return StripProfiles(
        strips.nodes,
        rise - strips.smooth[strip],
        velocity,
        acceleration,
        float(strips.edges[0]),
        float(strips.edges[-1]),
        strips.sharp,
        strip,
        edge_speed,
    )
