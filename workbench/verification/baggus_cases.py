"""Wet-deck slams of the heavy-lift model of Baggus 2025: relative motion, and the slam in two waves."""

from collections.abc import Callable
from functools import cache

import numpy as np

from workbench.conventions import wavenumber
from workbench.hulls.library import design
from workbench.repeating_waves import repetition
from workbench.slamming.immersion import immersions
from workbench.verification import baggus_relative_motion as source
from workbench.verification import heavy_lift_slam, published
from workbench.verification.case import Case
from workbench.verification.counting_cases import flat_point

WAVE_HEIGHT = 0.030
"""Amplitude of the regular waves (5.1) [m]."""

STAND_IN = "hull lines and gyradii are not published: a stand-in"

SPREAD = (
    "the water spreads over the stand-in's aft deck more slowly than over the thesis's, which itself prints 14 ms "
    "(6.2) and 11.9 ms (6.5.2) for one slam"
)

SIGNS = (
    "with consistent signs and the radiated waves the stand-in's deck is touched amidships only, by 2 mm; the thesis "
    "prints a pitch term of the mirrored ship and leaves the radiated waves out, which moves the slam aft"
)

TURNS = "the entries near 4.6 and 5.9 s are two short periods apart; the thesis reads the long period off its figure"


def regular_wave(omega: float) -> source.Wave:
    """Regular wave of chapter 5."""
    return source.Wave(WAVE_HEIGHT, omega)


def least_distance(point: int, omega: float, reading: str) -> float:
    """Least relative distance over a period by eq. 5.1 [m]."""
    place = source.table_point(point)
    amplitude = source.distance_amplitude(place, regular_wave(omega), source.table_response(omega), reading)
    return place.gap - abs(amplitude)


@cache
def _largest_distance_difference(reading: str) -> float:
    return max(
        abs(1000 * least_distance(int(row["point"]), float(row["omega"]), reading) - float(row[reading]))
        for row in published.rows("baggus_2025_least_distance")
    )


@cache
def first_immersion(point: int, omega: float, reading: str) -> tuple[float, float, float]:
    """First entry [s], relative velocity there [m/s] and time under water in a period [s] by eqs. 5.1 and 5.3.

    Found by `workbench.slamming.immersion` from the amplitude of eq. 5.1.
    """
    place = source.table_point(point)
    amplitude = source.distance_amplitude(place, regular_wave(omega), source.table_response(omega), reading)
    rise = np.full(
        (1, 1, 1), -amplitude / 1j
    )  # the imaginary part, and the water's rise for the deck's distance
    deck = flat_point(place.gap).assign(area=(("x", "y"), [[1.0]]))
    found = immersions(
        rise, 0 * rise, np.array([omega]), deck, duration=2 * np.pi / omega, periodic=True, time_step=0.002
    )
    entry, wet = float(found.event_time[0]), float(found.immersion_duration[0])
    velocity = source.relative_velocity(
        place, regular_wave(omega), source.table_response(omega), reading, entry
    )
    return entry, float(velocity), wet


def _largest_entry_difference(index: int, column: str, scale: float) -> float:
    rows = [row for row in published.rows("baggus_2025_entries") if _is_given(row, column)]
    return max(
        abs(
            scale * first_immersion(int(row["point"]), float(row["omega"]), row["convention"])[index]
            - float(row[column])
        )
        for row in rows
    )


def _is_given(row: dict[str, str], column: str) -> bool:
    return float(row["wet_ms"]) > 0 if column == "wet_ms" else float(row["entry"]) >= 0


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_reading_cases(), *_window_cases(), *_slam_cases()]


def _case(
    name: str,
    title: str,
    kind: str,
    citation: str,
    known: float,
    computed: Callable,
    tolerance: float,
    **more,
):
    return Case(
        id=f"baggus-{name}",
        title=title,
        kind=kind,
        source=citation,
        published=float(known),
        computed=computed,
        tolerance=tolerance,
        **more,
    )


def _reading_cases() -> list[Case]:
    made = [
        _case(
            f"least-distance-{reading.replace(' ', '-')}",
            f"Least distance at 10 points and 3 frequencies, equation 5.1 read as {reading}: largest difference",
            "second code",
            published.citation("baggus_2025_least_distance"),
            0.0,
            lambda reading=reading: _largest_distance_difference(reading),
            0.0101,
            unit="mm",
            note="the equation with the printed responses, computed by an independent program",
        )
        for reading in source.READINGS
    ]
    columns = (
        ("entry", 0, "entry", 1.0, 0.0001, "s", "first entry"),
        (
            "entry-velocity",
            1,
            "velocity",
            1.0,
            0.0002,
            "m/s",
            "relative velocity at the first entry, equation 5.3",
        ),
        ("wet-time", 2, "wet_ms", 1000.0, 0.1, "ms", "time under water in a period"),
    )
    return made + [
        _case(
            name,
            f"Points of table 5.1 in waves of 30 mm, {words}: largest difference",
            "second code",
            published.citation("baggus_2025_entries"),
            0.0,
            lambda index=index, column=column, scale=scale: _largest_entry_difference(index, column, scale),
            tolerance,
            unit=unit,
            note="the other program takes the first of 20 000 samples in the water for the entry",
        )
        for name, index, column, scale, tolerance, unit, words in columns
    ]


def _window_cases() -> list[Case]:
    citation = published.citation("baggus_2025_slam")
    rows = (
        ("window-short", "periods of 9.5 rad/s in the window", lambda: repetition((9.5, 4.2)).cycles[0]),
        ("window-long", "periods of 4.2 rad/s in the window", lambda: repetition((9.5, 4.2)).cycles[1]),
    )
    made = []
    for name, label, computed in rows:
        number, tolerance, unit = published.value("baggus_2025_slam", label)
        made.append(_case(name, label, "published", citation, number, computed, tolerance, unit=unit))
    return [
        *made,
        _case(
            "wavelength-of-length",
            "Wavelength at 7.5 rad/s over the length of the model",
            "published",
            published.citation("baggus_2025_table_3_1"),
            1.0,
            lambda: 2 * np.pi / wavenumber(7.5) / design("heavy-lift-198-model").hull.length,
            0.01,
        ),
    ]


def _slam_cases() -> list[Case]:
    citation = published.citation("baggus_2025_slam")
    slam = heavy_lift_slam
    rows = (
        ("slam-start", "slam start", "source", lambda: slam.slam("source").attrs["start"], {}),
        (
            "slam-contact",
            "place of first contact from the centre of gravity",
            "source",
            lambda: slam.contact_from_centre("source"),
            {"tolerance": 0.012},
        ),
        (
            "slam-spread",
            "spread of the slam",
            "source",
            lambda: 1000 * slam.slam("source").attrs["spread"],
            {"miss": SPREAD, "miss_figure": 20.3, "miss_band": 1.5},
        ),
        (
            "slam-interval",
            "interval between immersions",
            "source",
            lambda: slam.shortest_interval("source"),
            {"miss": TURNS, "miss_figure": 1.340, "miss_band": 0.02},
        ),
        (
            "slam-contact-ours",
            "place of first contact from the centre of gravity",
            "ours",
            lambda: slam.contact_from_centre("ours"),
            {"tolerance": 0.012, "miss": SIGNS, "miss_figure": -0.0216, "miss_band": 0.03},
        ),
    )
    words = {
        "source": "diffracted waves and pitch term as printed",
        "ours": "diffracted and radiated waves, consistent signs",
    }
    made = []
    for name, label, kinematics, computed, more in rows:
        number, tolerance, unit = published.value("baggus_2025_slam", label)
        more = {"tolerance": tolerance, **more}
        made.append(
            _case(
                name,
                f"Waves of 9.5 and 4.2 rad/s, {words[kinematics]}: {label}",
                "published",
                citation,
                number,
                computed,
                more.pop("tolerance"),
                unit=unit,
                note=f"{STAND_IN}; kinematics chosen among six by its slam; place within two cells of the deck",
                **more,
            )
        )
    return made
