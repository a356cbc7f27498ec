"""A stretch of a realisation as a scene: ship, water and deck over time, ready for the 3-D painters."""

from dataclasses import replace

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import KNOT
from workbench.geometry.sections import surface
from workbench.motions import translation_matrix
from workbench.pipeline import Response, Slamming
from workbench.pressure_stage import RealisedDeck
from workbench.scene.description import HISTORIES, scene_description
from workbench.time_domain import (
    Realisation,
    elevation_amplitudes,
    motion_amplitudes,
    record_blocks,
    relative_amplitudes,
    wave_components,
)
from workbench.wet_deck_pressure.deck_pressure import SUBSTEPS, history

FRAMES = 320
ENCOUNTERS = 16.0
"""Peak encounter periods that an animation shows."""

SEA_POINTS = (96, 44)
_SHORTEST_HOLD = 4
MOST_STEPS = 4000
"""Steps of the pressure at most in an animation; they take some 1.5 s on 400 panels."""

_LEAD = 4


def animation_scene(
    ship: Response,
    relative: xr.Dataset,
    slam: Slamming,
    events: xr.Dataset | None = None,
    realisation: Realisation | None = None,
    *,
    realised: RealisedDeck | None = None,
    start: float | None = None,
    frames: int = FRAMES,
) -> xr.Dataset:
    """Scene of a stretch of the realisation in which the slams were counted.

    Parameters
    ----------
    ship, relative, slam : from `workbench.pipeline`.
    events : slams counted in the same realisation; marks come from them, and pressures where ``realised`` is
        left out.
    realisation : the one that ``events`` were counted in.
    realised : the same ship, deck and realisation; with it the pressures are those of the wet-deck theory.
    start : first instant [s]; None starts so that the hardest slam comes at 40 % of the stretch.
    frames : number of pictures.

    Returns
    -------
    Dataset of `workbench.scene.description.scene_description`.

    Notes
    -----
    The deck's pressure by the wet-deck theory is the largest within half a picture before and after, so that
    no slam is lost between two pictures; force and wetted area are so, too. Otherwise it is the peak pressure
    of the latest entry of each point, shown while the point stays in the water and for at least four pictures.
    Costs about 0.5 s, and some 1.5 s for the wet-deck theory.
    """
    realisation = realisation or Realisation()
    condition = slam.condition
    components = wave_components(
        condition, realisation, float(relative.omega.min()), float(relative.omega.max())
    )
    frequency = components.component_frequency.values
    weight = components.component_amplitude.values**2
    mean_frequency = float(np.sum(weight * np.abs(frequency)) / np.sum(weight))
    duration = min(ENCOUNTERS * 2 * np.pi / mean_frequency, 3600 * realisation.hours)
    step = duration / (frames - 1)
    if start is None:
        start = 0.0
        if events is not None and events.sizes["event"]:
            hardest = float(events.event_time[int(np.argmax(events.peak_pressure.values))])
            start = float(np.clip(hardest - 0.4 * duration, 0.0, max(3600 * realisation.hours - duration, 0)))

    centre = np.asarray(ship.motions.attrs["centre_of_gravity"])
    own = motion_amplitudes(components, ship.motions) @ translation_matrix(-centre).T
    rise, _ = relative_amplitudes(components, ship.motions, relative)
    length, beam = ship.design.hull.length, ship.design.hull.beam
    sea_x = np.linspace(-1.3 * length, 1.3 * length, SEA_POINTS[0])
    sea_y = np.linspace(-0.5 * length - beam, 0.5 * length + beam, SEA_POINTS[1])
    water = elevation_amplitudes(components, *np.meshgrid(sea_x, sea_y, indexing="ij"))

    def film(amplitudes: np.ndarray) -> np.ndarray:
        flat = (amplitudes.reshape(len(frequency), -1).T * np.exp(-1j * frequency * start)).T
        parts = [part for _, part in record_blocks(flat, frequency, duration, step)]
        series = np.concatenate(parts, axis=1)[:, :frames].T
        return series.reshape(-1, *amplitudes.shape[1:])

    deck_motion = film(rise)
    times = np.arange(len(deck_motion)) * step
    height = slam.deck.height.values
    fields = {"relative_motion_history": deck_motion, "clearance_left": height - deck_motion}
    slams = None
    if events is not None:
        near = (events.event_time.values >= start) & (events.event_time.values <= start + times[-1])
        shown = events.isel(event=np.flatnonzero(near))
        slams = {
            name: shown[name].values - (start if name == "event_time" else 0.0)
            for name in ("event_time", "event_x", "event_y", "entry_velocity", "peak_pressure")
        }
        if realised is None:
            fields["pressure"] = _pressure_film(slams, times, slam.deck, deck_motion)
    histories, facts = None, {}
    if realised is not None:
        found = deck_pressure_film(realised, start, step, len(times))
        fields["pressure"] = found.deck_pressure.values
        histories = {name: found[name].values for name in HISTORIES}
        facts = {"pressure_step": found.attrs["time_step"], "warnings": found.attrs["warnings"]}
    vertices, faces = surface(ship.design.hull)
    sea = condition.sea_state
    title = (
        f"{ship.design.title or ship.design.name}: {condition.speed / KNOT:.3g} kn, "
        f"heading {np.degrees(condition.wave_direction):.0f}°, Hs {sea.significant_wave_height:g} m, "
        f"Tp {sea.peak_period:.3g} s"
    )
    scene = scene_description(
        time=times,
        pose=film(own),
        hull_vertices=vertices,
        hull_faces=faces,
        x=slam.deck.x.values,
        y=slam.deck.y.values,
        deck_height=height,
        water={"sea_x": sea_x, "sea_y": sea_y, "elevation": film(water)},
        fields=fields,
        histories=histories,
        slams=slams,
        title=title,
        speed=condition.speed,
    )
    scene.attrs |= facts
    return scene


def deck_pressure_film(realised: RealisedDeck, start: float, step: float, frames: int) -> xr.Dataset:
    """Pressure over the deck by the wet-deck theory for the pictures of a film.

    Parameters
    ----------
    realised : ship, deck and sea; start : time of the first picture [s]; step : between pictures [s]; frames :
        number of pictures.

    Returns
    -------
    Dataset over (time, x, y) and over time like that of `workbench.wet_deck_pressure.deck_pressure.history`, the
    times those of the pictures from 0: largest pressure, force and wetted area within half a step before and
    after each, and the place of that largest force. Its attribute ``time_step`` is what pressures are averaged
    over [s].
    """
    settings = realised.settings
    wanted = settings.time_step or realised.step / SUBSTEPS
    parts = max(1, min(int(np.ceil(step / wanted - 1e-9)), MOST_STEPS // frames))
    first, last = start - step / 2, start + (frames - 0.5) * step
    lead = _LEAD * realised.step
    motion = realised.motion(first - lead, last - first + 2 * lead)
    fine = replace(settings, time_step=step / parts)
    found = history(motion, realised.strips, realised.ship.design.density, fine, first, last)
    by_picture = {name: found[name].values.reshape(frames, parts) for name in HISTORIES}
    hardest = np.arange(frames), by_picture["deck_force"].argmax(axis=1)
    pressure = found.deck_pressure.values.reshape(frames, parts, *found.deck_pressure.shape[1:])
    return quantities.dataset(
        {"time": step * np.arange(frames), "x": found.x, "y": found.y},
        method=found.attrs["method"],
        attrs=found.attrs,
        warnings=quantities.warnings_of(found),
        deck_pressure=(("time", "x", "y"), pressure.max(axis=1)),
        deck_force=("time", by_picture["deck_force"][hardest]),
        deck_force_x=("time", by_picture["deck_force_x"][hardest]),
        deck_force_y=("time", by_picture["deck_force_y"][hardest]),
        wetted_area=("time", by_picture["wetted_area"].max(axis=1)),
    )


def _pressure_film(slams: dict, times: np.ndarray, deck: xr.Dataset, deck_motion: np.ndarray) -> np.ndarray:
    """Peak pressure of the latest entry of each point while it stays in the water (time, x, y) [Pa]."""
    film = np.zeros(deck_motion.shape)
    wet = deck_motion >= deck.height.values
    rows = np.searchsorted(deck.x.values, slams["event_x"])
    columns = np.searchsorted(deck.y.values, slams["event_y"])
    first = np.searchsorted(times, slams["event_time"])
    for frame, row, column, pressure in zip(first, rows, columns, slams["peak_pressure"], strict=True):
        dry = np.flatnonzero(~wet[frame:, row, column])
        last = frame + max(int(dry[0]) if dry.size else len(times), _SHORTEST_HOLD)
        film[frame:last, row, column] = pressure
    return film
