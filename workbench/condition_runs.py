"""Slamming of a design in all conditions of a study: motions once for each speed, then one sea after another."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from workbench import pipeline, quantities, sea_energy
from workbench.condition_study import ConditionStudy, DeckPlace
from workbench.conventions import KNOT
from workbench.design import Design
from workbench.errors import InputError
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hydrodynamics.recommended import RecommendedSettings, TheorySettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.running_state import RunningState
from workbench.sailing import HORIZONTAL, flies, sailing_design
from workbench.sails import TrueWind
from workbench.seas import Condition
from workbench.slamming import events
from workbench.slamming.direct_statistics import direct_statistics
from workbench.slamming.pressure_classes import expected_classes
from workbench.slamming.pressure_statistics import rate_band
from workbench.slamming.statistics import HOUR, response_moments, slamming_statistics
from workbench.time_domain import Realisation, relative_amplitudes, wave_components

DIMS = ("place", "forward_speed", "wave_direction", "significant_wave_height", "period")
OF_CONDITION = (
    "slams_per_hour", "mean_entry_velocity", "most_probable_peak_pressure", "worst_x", "worst_y",
    "is_slamming",
)  # fmt: skip
OF_CLASS = ("class_limit", "class_per_hour", "class_mean_velocity", "class_pressure")
COUNTED = ("counted_per_hour", "counted_band_low", "counted_band_high", "counted_mean_velocity")
POINTS = (40, 11)
"""Points of the deck of a study, lengthwise and across: an odd number, so that some are on the centreline."""
LEAST_SLAMS = 1.0
"""Slams in the time of the study from which a condition counts as one with slams."""


def slamming_of_conditions(
    design: Design,
    study: ConditionStudy,
    settings: TheorySettings | None = None,
    *,
    counted: bool = False,
    seed: int = 1,
    points: tuple[int, int] = POINTS,
    responses: Callable[[float], pipeline.Response] | None = None,
    progress: Callable[[float, str], None] = pipeline.silent,
) -> xr.Dataset:
    """Slams, velocities and pressures of a design in every condition of a study.

    Parameters
    ----------
    design : with a wet deck.
    study : conditions and places.
    settings : of the theory of the motions; None takes that of the study.
    counted : also count the slams of a realisation of each condition, at the same point.
    seed : of the first realisation; each condition has its own.
    points : of the deck, lengthwise and across.
    responses : gives the response at a speed [m/s] where it is known already, with the headings of the study.
    progress : called with fraction and sentence.

    Returns
    -------
    Dataset over (place, forward_speed, wave_direction, significant_wave_height, period), at the most exposed point of
    each place: ``slams_per_hour`` and ``mean_entry_velocity`` in closed form, ``most_probable_peak_pressure`` in the
    hours of the study by the k of the place, ``worst_x``, ``worst_y``, and ``is_slamming`` (1 where at least one slam
    is expected in the hours; where counted, where one was counted). Over velocity_class too ``class_limit``,
    ``class_per_hour``, ``class_mean_velocity`` and ``class_pressure``. Counted: ``counted_per_hour`` with its
    99 % band, ``counted_mean_velocity``.

    Notes
    -----
    Motions are computed once for each speed. Costs then about 10 ms a condition and place, counted about 0.2 s
    an hour.
    """
    if design.wet_deck is None:
        raise InputError(
            f"design must have a wet deck, but {design.name} has none; choose a multihull with one."
        )
    shape = (
        len(study.places), len(study.speeds), len(study.wave_directions), len(study.heights),
        len(study.periods),
    )  # fmt: skip
    values = {name: np.zeros(shape) for name in (*OF_CONDITION, *(COUNTED if counted else ()))}
    values |= {name: np.zeros((*shape, events.CLASSES)) for name in OF_CLASS}
    notes: list[str] = []
    done = 0
    for column, speed in enumerate(study.speeds):
        progress(column / shape[1], f"Motions at {speed:.1f} m/s")
        ship = responses(speed) if responses else _ship(design, study, column, settings)
        relative = pipeline.deck_response(ship, design.wet_deck, points)
        deck = _deck(design, ship, study.heels[column], points)
        windows = [_window(deck, place) for place in study.places]
        notes += quantities.warnings_of(ship.motions)
        for direction, height, period in np.ndindex(*shape[2:]):
            condition = study.condition(
                speed, study.wave_directions[direction], study.heights[height], study.periods[period]
            )
            met = relative.isel(wave_direction=[_nearest(relative, condition)])
            energy = sea_energy.wave_energy(condition, met.omega, met.wave_direction)
            moments = response_moments(met, energy)
            found = _statistics(moments, deck, study)
            notes += [*quantities.warnings_of(found), *sea_energy.band_notes(energy, condition)]
            done += 1
            for row, place in enumerate(study.places):
                at = (row, column, direction, height, period)
                worst = _worst(found, moments, deck, windows[row])
                one = _at_worst(worst, found, moments, deck, study, place, ship)
                if counted:
                    one |= _counted(worst, ship, met, deck, condition, study, seed + done)
                for name, value in one.items():
                    values[name][at] = value
    progress(1.0, "All conditions done")
    variables = {name: (DIMS, value) for name, value in values.items() if name not in OF_CLASS}
    variables |= {name: ((*DIMS, "velocity_class"), values[name]) for name in OF_CLASS}
    return quantities.dataset(
        {
            "place": [place.name for place in study.places],
            "forward_speed": list(study.speeds),
            "wave_direction": list(study.wave_directions),
            "significant_wave_height": list(study.heights),
            "period": list(study.periods),
            "velocity_class": np.arange(1, events.CLASSES + 1),
        },
        method=ship.motions.attrs["method"],
        warnings=list(dict.fromkeys(notes)),
        attrs={
            "study": study.name, "design": design.name, "hours": study.hours, "velocity": study.velocity,
            "period_kind": study.period_kind, "coefficients": [place.coefficient for place in study.places],
            "seed": int(seed),
        },
        **variables,
    )  # fmt: skip


def _ship(
    design: Design, study: ConditionStudy, column: int, settings: TheorySettings | None
) -> pipeline.Response:
    """Return the response at one speed and its heel, for all headings."""
    heel = study.heels[column]
    afloat = sailing_design(design, heel) if heel else design
    locked = ("roll",) if flies(afloat) else ()
    if study.theory == "sailing":
        settings, locked = settings or StripSettings(formulation="heave-only"), (*HORIZONTAL, *locked)
    elif settings is None:
        settings = RecommendedSettings()
        settings = settings if study.theory == "recommended" else settings.of(study.theory)
    wind = None if study.wind_speed is None else TrueWind(speed=study.wind_speed)
    return pipeline.response(
        afloat,
        study.speeds[column],
        sorted(study.wave_directions),
        None,
        settings,
        running_state=RunningState(wind=wind, locked=locked),
    )


def _deck(design: Design, ship: pipeline.Response, heel: float, points: tuple[int, int]) -> xr.Dataset:
    """Return the deck with its height above the water in the attitude of the ship."""
    deck = wet_deck_grid(design.wet_deck, *points)
    change = ship.design.hull.sinkage - design.hull.sinkage
    height = (deck.height - change + deck.y * np.tan(heel)).clip(min=1e-3)
    return deck.assign(height=height.transpose("x", "y").assign_attrs(deck.height.attrs))


def _window(deck: xr.Dataset, place: DeckPlace) -> np.ndarray:
    along = (deck.x.values >= place.x[0]) & (deck.x.values <= place.x[1])
    out = np.abs(deck.y.values)
    window = along[:, None] & (out >= place.y[0]) & (out <= place.y[1])
    if not window.any():
        raise InputError(
            f"place {place.name} must hold a point of the deck, got none between x {place.x[0]:g} and "
            f"{place.x[1]:g} m, y {place.y[0]:g} and {place.y[1]:g} m; widen it."
        )
    return window


def _nearest(relative: xr.Dataset, condition: Condition) -> int:
    away = relative.wave_direction.values - condition.wave_direction
    return int(np.argmin(np.abs(np.angle(np.exp(1j * away)))))


def _statistics(moments: xr.Dataset, deck: xr.Dataset, study: ConditionStudy) -> xr.Dataset:
    if study.velocity == "material":
        return direct_statistics(moments, deck.height)
    return slamming_statistics(moments, deck.height, study.threshold)


def _worst(found: xr.Dataset, moments: xr.Dataset, deck: xr.Dataset, window: np.ndarray) -> dict:
    """Return the indices of the most exposed point of a place (where none slams, of that nearest to it)."""
    rate = np.where(window, found.slams_per_hour.values, -1.0)
    if rate.max() <= 0:
        nearness = -deck.height.values / np.maximum(moments.relative_motion_std.values, 1e-12)
        rate = np.where(window, nearness, -np.inf)
    row, column = np.unravel_index(int(np.argmax(rate)), rate.shape)
    return {"x": [int(row)], "y": [int(column)]}


def _at_worst(
    worst: dict, found: xr.Dataset, moments: xr.Dataset, deck: xr.Dataset, study: ConditionStudy,
    place: DeckPlace, ship: pipeline.Response,
) -> dict:  # fmt: skip
    here, point, plate = found.isel(worst), moments.isel(worst), deck.isel(worst)
    crossings = slamming_statistics(point, plate.height, study.threshold, study.velocity)
    classes = expected_classes(point, crossings, plate, place.coefficient, ship.design.density, study.hours)
    slams, of_classes = float(here.slams_per_hour.item()), float(classes.slams_per_hour)
    if of_classes > 0:  # the cells of the joint law miss some hundredths of the slams
        classes["class_per_hour"] = classes.class_per_hour * (slams / of_classes)
    return {
        "slams_per_hour": slams,
        "mean_entry_velocity": float(here.mean_entry_velocity.item()),
        "most_probable_peak_pressure": float(classes.most_probable_peak_pressure),
        "worst_x": float(here.x.item()),
        "worst_y": float(here.y.item()),
        "is_slamming": float(slams * study.hours >= LEAST_SLAMS),
        **{name: classes[name].values for name in OF_CLASS},
    }


def _counted(
    worst: dict, ship: pipeline.Response, relative: xr.Dataset, deck: xr.Dataset, condition: Condition,
    study: ConditionStudy, seed: int,
) -> dict:  # fmt: skip
    """Return slams counted in one realisation at one point, as the closed form counts them."""
    realisation = Realisation(seed=seed, hours=study.hours)
    components = wave_components(
        condition, realisation, float(relative.omega.min()), float(relative.omega.max())
    )
    motions = ship.motions.isel(wave_direction=[_nearest(ship.motions, condition)])
    rise, slope = relative_amplitudes(components, motions, relative.isel(worst))
    material = study.velocity == "material"
    duration = HOUR * study.hours
    found = events.entries(
        rise,
        slope,
        components.component_frequency.values,
        deck.isel(worst),
        duration=duration,
        time_step=pipeline.time_step(ship.design.hull.length),
        threshold=study.threshold,
        drift=ship.speed if material else 0.0,
    )
    kept = found.entry_velocity.values > 0
    velocity, times = found.entry_velocity.values[kept], found.event_time.values[kept]
    parts = np.bincount(events.parts_of_record(times, duration), minlength=events.PARTS)
    low, high = rate_band(len(times), events.grouping_dispersion(parts[:, None].astype(float)))
    return {
        "counted_per_hour": len(times) / study.hours,
        "counted_band_low": float(low) / study.hours,
        "counted_band_high": float(high) / study.hours,
        "counted_mean_velocity": float(velocity.mean()) if velocity.size else 0.0,
        "is_slamming": float(len(times) > 0),
    }


def condition_rows(found: xr.Dataset) -> list[dict]:
    """Results of a study as plain rows, one a place and condition; knots, degrees and kPa at this edge."""
    rows = []
    flat = found.stack(condition=DIMS, create_index=False)
    for index in range(flat.sizes["condition"]):
        one = flat.isel(condition=index)
        row = {
            "place": str(one.place.values),
            "speed_knots": round(float(one.forward_speed) / KNOT, 6),
            "heading_degrees": round(float(np.degrees(one.wave_direction)), 6),
            "significant_wave_height": float(one.significant_wave_height),
            "period": float(one.period),
            "slams_per_hour": float(one.slams_per_hour),
            "mean_entry_velocity": float(one.mean_entry_velocity),
            "most_probable_peak_pressure_kpa": float(one.most_probable_peak_pressure) / 1e3,
            "worst_x": float(one.worst_x),
            "worst_y": float(one.worst_y),
            "is_slamming": bool(one.is_slamming),
            **{name: float(one[name]) for name in COUNTED if name in found},
        }
        for number in range(found.sizes["velocity_class"]):
            row[f"class_{number + 1}_pressure_kpa"] = float(one.class_pressure[number]) / 1e3
            row[f"class_{number + 1}_per_hour"] = float(one.class_per_hour[number])
        rows.append(row)
    return rows
