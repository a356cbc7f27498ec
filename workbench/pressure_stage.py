"""Pressure over the wet deck of a ship in a condition: all slams of a realisation, or one of them in time."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.design import WetDeck
from workbench.errors import InputError, checked_number
from workbench.pipeline import Response, Slamming, silent, time_step
from workbench.time_domain import Realisation, relative_amplitudes, wave_components
from workbench.wet_deck_pressure.deck_motion import DeckMotion, motion_of_amplitudes
from workbench.wet_deck_pressure.deck_pressure import history, joined, slams_of_record
from workbench.wet_deck_pressure.settings import DeckPressureSettings
from workbench.wet_deck_pressure.strips import deck_strips
from workbench.wet_deck_pressure.windows import wet_stretches

STRETCH = 1800.0
"""Length of the stretches that a long record is worked through in [s]; its memory is some 0.25 GB for 400 panels."""

_RUN_ON = 120.0
_MARGIN = 4
FINE_STEPS = 20
"""Steps of one slam's history in one step of the record."""

STRIP_NOTE = (
    "Each strip of the deck is a flow in its own plane, and the motions are those without slams: forces over large "
    "areas are upper bounds, pressures over a panel are what the water gives at that entry."
)
MARKING = 0.5
"""Least height of a panel that marks a slam by getting wet, over the standard deviation of relative motion [-];
a lower one is in the water almost a third of the time, and no slam would end by it."""

SLOWING = 0.1
"""Change of the ship's velocity by a slam, over the entry velocity, from which it is said [-]."""


class RealisedDeck:
    """Water against a wet deck in one realisation of a condition.

    Parameters
    ----------
    ship, relative, slam : from `workbench.pipeline`, for one condition.
    wet_deck : the deck that ``slam`` was computed for.
    realisation : of the sea; the same gives the slams that `workbench.pipeline.counted_slams` counts.
    settings : of the pressures.
    """

    def __init__(
        self,
        ship: Response,
        relative: xr.Dataset,
        slam: Slamming,
        wet_deck: WetDeck,
        realisation: Realisation | None = None,
        settings: DeckPressureSettings | None = None,
    ) -> None:
        self.ship, self.slam = ship, slam
        self.settings = settings or DeckPressureSettings()
        self.realisation = realisation or Realisation()
        self.strips = deck_strips(wet_deck, slam.deck, self.settings.direction)
        self.step = self.realisation.time_step or time_step(ship.design.hull.length)
        sea = slam.condition.sea_state
        lowest_parts = self.strips.on_grid(self.strips.lowest)
        self.marking = lowest_parts >= MARKING * slam.moments.relative_motion_std.values
        self.gap = 0.25 * sea.peak_period if self.settings.gap is None else self.settings.gap
        lowest, highest = float(relative.omega.min()), float(relative.omega.max())
        components = wave_components(slam.condition, self.realisation, lowest, highest)
        self._frequency = components.component_frequency.values
        self._rise, self._slope = relative_amplitudes(components, ship.motions, relative)

    @property
    def duration(self) -> float:
        """Length of the record [s]."""
        return 3600 * self.realisation.hours

    def motion(self, start: float, duration: float) -> DeckMotion:
        """Water against the deck from a time on [s]."""
        deck = self.slam.deck
        return motion_of_amplitudes(
            self._rise,
            self._slope,
            self._frequency,
            deck.x.values,
            deck.y.values,
            duration=duration,
            time_step=self.step,
            speed=self.slam.condition.speed,
            frame=self.settings.frame,
            start=start,
        )


def slam_pressures(realised: RealisedDeck, progress: Callable[[float, str], None] = silent) -> xr.Dataset:
    """Pressure, force and impulse of every slam of a realisation, and the envelope over the deck.

    Parameters
    ----------
    realised : ship, deck and sea; progress : called with fraction and sentence, may raise to cancel.

    Returns
    -------
    Dataset of `workbench.wet_deck_pressure.deck_pressure.slams_of_record`, its warnings those of the motions
    too.

    Notes
    -----
    A long record is worked through in stretches that end where the deck is dry. One hour with some 450 slams
    on 400 panels takes about 12 s on two cores.
    """
    density, settings = realised.ship.design.density, realised.settings
    parts, start, end = [], 0.0, realised.duration
    while start < end - 1e-9 or not parts:
        length = min(end - start, STRETCH + _RUN_ON)
        motion = realised.motion(start, length)
        is_last = start + length >= end - 1e-9
        motion = motion if is_last else _until_dry(motion, realised)

        def told(fraction: float, message: str, start=start, length=motion.duration) -> None:
            progress((start + fraction * length) / end, message)

        parts.append(
            slams_of_record(motion, realised.strips, density, settings, realised.gap, realised.marking, told)
        )
        start += motion.duration
    found = joined(parts)
    return _told(found, realised, (*_slowing(found, realised), *_often_wet(realised)))


def slam_history(realised: RealisedDeck, start: float, duration: float) -> xr.Dataset:
    """Pressure over the deck and force in time, during one slam.

    Parameters
    ----------
    realised : ship, deck and sea.
    start, duration : of the slam, as `slam_pressures` gives them [s].

    Returns
    -------
    Dataset of `workbench.wet_deck_pressure.deck_pressure.history`; its step is a twentieth of the record's
    unless the settings name one. Takes some 0.3 s.
    """
    checked_number("start of the slam", start, "s", at_least=0, at_most=realised.duration)
    checked_number("duration of the slam", duration, "s", above=0, at_most=600)
    lead = _MARGIN * realised.step
    first = max(start - lead, 0.0)
    motion = realised.motion(first, start + duration + lead - first)
    settings = realised.settings
    if settings.time_step is None:
        settings = replace(settings, time_step=realised.step / FINE_STEPS)
    density = realised.ship.design.density
    found = history(
        motion, realised.strips, density, settings, start, min(start + duration, first + motion.duration)
    )
    return _told(found, realised)


def hardest_slam(realised: RealisedDeck, slams: xr.Dataset) -> xr.Dataset | None:
    """History of the slam with the largest panel pressure, or None where there was no slam."""
    if not slams.sizes["slam"]:
        return None
    one = slams.isel(slam=int(hardest_slams(slams, 1)[0]))
    return slam_history(realised, float(one.slam_start), float(one.slam_duration))


def hardest_slams(slams: xr.Dataset, count: int = 5, by: str = "slam_pressure") -> np.ndarray:
    """Numbers of the hardest slams, hardest first, by largest panel pressure, force or impulse."""
    if by not in ("slam_pressure", "slam_force", "slam_impulse"):
        raise InputError(f"slams are ranked by slam_pressure, slam_force or slam_impulse, got {by!r}.")
    return np.argsort(-slams[by].values, kind="stable")[:count]


def _until_dry(motion: DeckMotion, realised: RealisedDeck) -> DeckMotion:
    """The motion up to the first slam that begins after the stretch, so that none is cut."""
    found = wet_stretches(motion, realised.strips, realised.gap, realised.marking)
    later = found.first * motion.time_step > STRETCH
    begins = np.concatenate([[True], found.slam[1:] != found.slam[:-1]]) if found.slam.size else later
    after = found.first[later & begins]
    last = int(after[0]) if after.size else len(motion.rise) - 1
    fields = (field[: last + 1] for field in (motion.rise, motion.velocity, motion.acceleration))
    return DeckMotion(motion.x, motion.y, motion.time_step, *fields, motion.speed, motion.start)


def _slowing(slams: xr.Dataset, realised: RealisedDeck) -> tuple[str, ...]:
    """Say so where the hardest slam would slow the motions that it was computed from.

    A free ship of mass M that meets an added mass A at a velocity W takes M/(M + A) of the impulse A W of a held one.
    """
    if not slams.sizes["slam"]:
        return ()
    change = float(slams.slam_impulse.max()) / realised.ship.design.masses.mass
    typical = float(realised.slam.statistics.mean_entry_velocity.max())
    if change < SLOWING * typical:
        return ()
    return (
        f"The impulse of the hardest slam would change the ship's vertical velocity by {change:.2g} m/s where the "
        f"water closes at some {typical:.2g} m/s: such a slam slows the motions, which is not allowed "
        f"for; of such a momentum a free ship takes about {100 / (1 + change / typical):.0f} %.",
    )


def _often_wet(realised: RealisedDeck) -> tuple[str, ...]:
    """Say so where parts of the deck are in the water so often that they mark no slams."""
    often = int(np.sum(~realised.marking))
    if not often:
        return ()
    return (
        f"{often} of {realised.marking.size} panels are in the water almost a third of the time or more; they mark "
        "no slams of their own.",
    )


def _told(found: xr.Dataset, realised: RealisedDeck, notes: tuple[str, ...] = ()) -> xr.Dataset:
    """Return the result with what it was made of, and the limits of the motions and of the pressures."""
    statistics = realised.slam.statistics
    peaks = statistics.attrs["pressure_warnings"].split("\n")
    of_motions = (line for line in quantities.warnings_of(statistics) if line not in peaks)
    own = quantities.warnings_of(found)
    found.attrs |= _about(realised)
    found.attrs["warnings"] = quantities.joined_warnings((*of_motions, STRIP_NOTE, *notes, *own))
    return found


def _about(realised: RealisedDeck) -> dict:
    ship, condition = realised.ship, realised.slam.condition
    sea = condition.sea_state
    return {
        "design": ship.design.name,
        "motions": ship.motions.attrs["method"],
        "speed": ship.speed,
        "wave_direction": condition.wave_direction,
        "significant_wave_height": sea.significant_wave_height,
        "peak_period": sea.peak_period,
        "clearance": realised.slam.clearance,
        "seed": int(realised.realisation.seed),
    }
