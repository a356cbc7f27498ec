"""Rice's rate and Rayleigh's velocities [Rice1944]_ against slams counted in a record.

.. [Rice1944] S. O. Rice, "Mathematical analysis of random noise", Bell System Technical
    Journal 23, 282-332, 1944.
"""

from functools import cache

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import encounter_frequency, wavenumber
from workbench.seas import Condition, SeaState, wave_spectrum
from workbench.slamming import events, statistics
from workbench.time_domain import Realisation, complex_amplitudes, wave_components
from workbench.verification.case import Case

SEA = SeaState(significant_wave_height=3.0, peak_period=8.0)
CLEARANCE, THRESHOLD, SPEED, HOURS = 1.5, 1.0, 10.0, 24.0
"""Of the point whose slams are counted: it keeps its height on a ship at speed [m, m/s, m/s, h]."""

RICE = 'S. O. Rice, "Mathematical analysis of random noise", Bell System Technical Journal 23, 282-332, 1944'


def still_point(omega: np.ndarray, wave_direction: float, speed: float) -> xr.Dataset:
    """Relative motion of a point that keeps its height while the ship advances: the wave itself."""
    encounter = encounter_frequency(omega, speed, wave_direction)[:, None]
    shape = ("omega", "wave_direction", "x", "y")
    rise = np.ones((len(omega), 1, 1, 1), complex)
    return quantities.dataset(
        {"omega": omega, "wave_direction": [wave_direction], "x": [0.0], "y": [0.0]},
        method="a point at rest",
        attrs={"speed": speed, "density": 1025.0, "velocity": "time-derivative"},
        relative_motion=(shape, rise),
        relative_velocity=(shape, -1j * encounter[..., None, None] * rise),
        relative_slope=(
            shape,
            1j * np.cos(wave_direction) * wavenumber(omega)[:, None, None, None] * rise,
        ),
        encounter_frequency=(("omega", "wave_direction"), encounter),
    )


def flat_point(height: float) -> xr.Dataset:
    """Deck of one point at a height."""
    return quantities.dataset(
        {"x": [0.0], "y": [0.0]},
        height=(("x", "y"), [[height]]),
        slope_x=(("x", "y"), [[0.0]]),
    )


@cache
def closed_form(threshold: float) -> tuple[xr.Dataset, xr.Dataset]:
    """Return moments and statistics of the point."""
    omega = np.linspace(0.3, 3.0, 400)
    relative = still_point(omega, np.pi, SPEED)
    energy = xr.DataArray(
        wave_spectrum(SEA, omega)[:, None], coords={"omega": omega, "wave_direction": [np.pi]}
    )
    moments = statistics.response_moments(relative, energy)
    return moments, statistics.slamming_statistics(moments, flat_point(CLEARANCE).height, threshold)


@cache
def counted(threshold: float) -> xr.Dataset:
    """Return the entries of the record."""
    condition = Condition(speed=SPEED, wave_direction=np.pi, sea_state=SEA)
    components = wave_components(condition, Realisation(seed=1964, components=600), 0.3, 3.0)
    amplitudes = complex_amplitudes(components)[:, None, None]
    return events.entries(
        amplitudes,
        0 * amplitudes,
        components.component_frequency.values,
        flat_point(CLEARANCE),
        duration=3600 * HOURS,
        time_step=0.05,
        threshold=threshold,
    )


def _counted_over_expected(threshold: float) -> float:
    expected = float(closed_form(threshold)[1].slams_per_hour.item()) * HOURS
    return counted(threshold).sizes["event"] / expected


def _entry_velocity_ratio(threshold: float) -> float:
    expected = float(closed_form(threshold)[1].mean_entry_velocity.item())
    return float(counted(threshold).entry_velocity.mean()) / expected


def cases() -> list[Case]:
    """Return the cases of this module."""
    made = []
    for threshold in (0.0, THRESHOLD):
        words = "with no threshold" if threshold == 0 else f"faster than {threshold:g} m/s"
        name = "all" if threshold == 0 else "fast"
        made += [
            Case(
                id=f"rice-count-{name}",
                title=f"slams counted in 24 h over the closed form, {words}",
                kind="second method",
                source=RICE,
                published=1.0,
                computed=lambda threshold=threshold: _counted_over_expected(threshold),
                tolerance=0.05,
                note="head sea of 3 m and 8 s at 10 m/s, a point at rest 1.5 m above still water; tolerance: "
                "some two standard deviations of a count of 2000 to 3000",
            ),
            Case(
                id=f"rayleigh-entry-velocity-{name}",
                title=f"mean entry velocity counted in 24 h over the closed form, {words}",
                kind="second method",
                source=RICE,
                published=1.0,
                computed=lambda threshold=threshold: _entry_velocity_ratio(threshold),
                tolerance=0.015,
            ),
        ]
    return made
