"""Measured records: spectra, responses, integration, fits, slams and points, against what is known."""

from functools import cache

import numpy as np
import xarray as xr

from workbench.conventions import GRAVITY, KNOT, encounter_frequency
from workbench.quantities import dataset
from workbench.records import integration
from workbench.records.point_motion import point_motion
from workbench.records.reading import channel, record
from workbench.records.responses import estimated_response
from workbench.records.sine_fit import sine_fit
from workbench.records.slam_signals import RingDown, detection, matched_slams
from workbench.records.spectra import SpectrumSettings, record_spectra
from workbench.records.waves import pressure_gain, true_wave
from workbench.relative_motion import vertical_motion
from workbench.seas import Condition, SeaState
from workbench.time_domain import (
    Realisation,
    complex_amplitudes,
    elevation_amplitudes,
    record_blocks,
    wave_components,
)
from workbench.verification.case import Case, relative_difference

COUSER = "P. R. Couser, PhD thesis, University of Southampton, 1996"
GRANDE = "K. Grande, MSc thesis, Curtin University of Technology, 2002"
SEA = SeaState(significant_wave_height=2.0, peak_period=8.0)
SPEED = 20 * KNOT
STEP = 0.1
HOURS = 1.0
RINGING = RingDown(omega=2 * np.pi * 9.0, damping_ratio=0.04)


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_record_cases(), *_slam_and_point_cases()]


def _rao(encounter) -> np.ndarray:
    """A resonance at 1.5 rad/s with exp(-i omega_e t)."""
    return 1 / (1 - (encounter / 1.5) ** 2 - 0.5j * encounter / 1.5)


@cache
def _trial() -> xr.Dataset:
    """An hour in head seas at 20 kn: wave, heave, accelerometer and bow meter of a ship with a known response."""
    condition = Condition(speed=SPEED, wave_direction=np.pi, sea_state=SEA)
    components = wave_components(condition, Realisation(components=700), 0.4, 1.4)
    frequency = components.component_frequency.values
    wave = complex_amplitudes(components)
    heave = wave * _rao(frequency)
    parts = np.stack([wave, heave, -(frequency**2) * heave, wave - heave], axis=1)
    found = np.concatenate([part for _, part in record_blocks(parts, frequency, 3600 * HOURS, STEP)], axis=1)
    time = STEP * np.arange(found.shape[1])
    names, units = ["wave", "heave", "acceleration", "rise"], ["m", "m", "m/s2", "m"]
    return record(time, found.T.astype(float), names, units)


def _inside(values: np.ndarray) -> np.ndarray:
    edge = round(20 / STEP)
    return values[edge:-edge]


def _scatter(found: np.ndarray, known: np.ndarray) -> float:
    return float(np.std(_inside(found - known)) / np.std(_inside(known)))


def _integrated(second_method: bool) -> float:
    trial = _trial()
    found = integration.displacement(channel(trial, "acceleration"), STEP)
    if second_method:
        return _scatter(integration.displacement_by_steps(channel(trial, "acceleration"), STEP, 0.3), found)
    return _scatter(found, channel(trial, "heave"))


def _estimated() -> float:
    found = estimated_response(_trial(), "wave", SPEED, np.pi, SpectrumSettings(segment=1024))
    one = found.isel(record_omega=found.usable.values == 1).sel(channel="heave")
    return relative_difference(one.response_amplitude.values, np.abs(_rao(one.record_omega.values)))


def _spectral_variance() -> float:
    found = record_spectra(_trial(), SpectrumSettings(segment=1024)).sel(channel="wave")
    return float(np.trapezoid(found.record_spectrum, found.record_omega) / found.record_std**2)


def _met_wave() -> float:
    trial = _trial()
    found = true_wave(channel(trial, "rise") + 3.0, channel(trial, "acceleration") + GRAVITY, STEP, "rise")
    return _scatter(found, channel(trial, "wave"))


def _fitted() -> float:
    time = np.arange(0, 10, 0.01)
    found = sine_fit(time, 1.3 * np.sin(7.3 * time) - 0.7 * np.cos(7.3 * time), line=False)
    return found.sine


def _record_cases() -> list[Case]:
    an_hour = "an hour in head seas at 20 kn, response known"
    rows = (
        ("record-variance", "integral of the spectrum over the variance of the record", "closed form",
         "definition of a spectrum", 1.0, _spectral_variance, 0.02, an_hour),
        ("record-response", "response from spectra, largest difference over the largest", "closed form",
         "the response that made the records", 0.0, _estimated, 0.03, an_hour),
        ("double-integration", "displacement from acceleration, scatter over deviation", "closed form",
         f"{GRANDE}, 3.2: 'very accurate'", 0.0, lambda: _integrated(False), 0.01, "less 20 s at the ends"),
        ("double-integration-by-steps", "integration in the time against the frequency domain", "second method",
         f"{GRANDE}, 3.2: 'very accurate'", 0.0, lambda: _integrated(True), 0.02, "less 20 s at the ends"),
        ("bow-meter-wave", "true wave from relative height and accelerometer, scatter over deviation", "closed form",
         f"{GRANDE}, 3.2", 0.0, _met_wave, 0.01, "the meter's own error of some 10 % is not in it"),
        ("recorder-gain", "pressure head over elevation 10 m down in deep water, 2 rad/s", "closed form",
         "exp(-k d)", float(np.exp(-40 / GRAVITY)), lambda: float(pressure_gain(2.0, 500.0, 10.0)), 1e-9, ""),
        ("couser-sine-fit", "amplitude A1 of 1.3 sin 7.3 x - 0.7 cos 7.3 x", "closed form",
         f"{COUSER}, appendix G with its normal equations derived anew", 1.3, _fitted, 1e-9,
         "the printed equations give 0.65"),
    )  # fmt: skip
    return [
        Case(
            id=name,
            title=title,
            kind=kind,
            source=source,
            published=known,
            computed=computed,
            tolerance=tolerance,
            note=note,
        )
        for name, title, kind, source, known, computed, tolerance, note in rows
    ]


def _share_of_slams() -> float:
    """Slams found less false ones, over those planted in noise of 0.4 of their peak."""
    rng = np.random.default_rng(1964)
    step, time = 0.01, np.arange(0, 600, 0.01)
    blows = np.arange(10.0, 590.0, 10.0) + rng.uniform(0, 5, 58)
    acceleration = rng.normal(0, 0.4, len(time)) + np.sin(1.2 * time)
    for blow in blows:
        start = int(blow / step)
        acceleration[start : start + 500] += RINGING.signal(time[start : start + 500] - blow)
    found = matched_slams(acceleration, step, RINGING, 2 * np.pi * 3.0)
    hits, _, false = detection(found.event_time.values, blows, 0.15)
    return (hits - false) / len(blows)


def _point_difference() -> float:
    """Direct method against the linear closed form, closing velocity of a point of the bow."""
    condition = Condition(
        speed=SPEED, wave_direction=2.5, sea_state=SeaState(significant_wave_height=0.01, peak_period=8.0)
    )
    components = wave_components(condition, Realisation(components=60), 0.4, 1.4)
    omega, frequency = components.component_omega.values, components.component_frequency.values
    wave, k = complex_amplitudes(components), components.component_kx.values
    motion = np.zeros((len(omega), 6), complex)
    motion[:, 2], motion[:, 3], motion[:, 4] = _rao(frequency), 0.3j * k, -0.8j * k
    time = np.arange(0, 120, 0.02)
    phase = np.exp(-1j * np.multiply.outer(frequency, time))
    series = ((wave[:, None] * motion).T @ phase).real.T
    history = dataset({"time": time, "dof": ["surge", "sway", "heave", "roll", "pitch", "yaw"]},
                      motion=(("time", "dof"), series))  # fmt: skip
    point, centre = (30.0, 4.0, 2.5), (1.5, 0.0, 1.0)
    found = point_motion(history, components, [point], centre).closing_velocity.values[:, 0]
    x, y = np.array(point[0]), np.array(point[1])
    rise = elevation_amplitudes(components, x, y) - wave * vertical_motion(motion, centre, x, y)
    slope = 1j * k * elevation_amplitudes(components, x, y) + wave * motion[:, 4]
    known = ((-1j * frequency * rise - SPEED * slope) @ phase).real
    return relative_difference(found, known)


def _slam_and_point_cases() -> list[Case]:
    return [
        Case(
            id="planted-slams",
            title="slams found less false ones, over 58 planted at 0.4 of noise, filter matched to the ringing",
            kind="trend",
            source=f"{GRANDE}, 5.3 names the technique; {COUSER}, 7.5",
            published=1.0,
            computed=_share_of_slams,
            tolerance=0.08,
        ),
        Case(
            id="grande-point-velocity",
            title="closing velocity of a point by 4.5-4.18 against the linear closed form, largest difference",
            kind="second method",
            source=f"{GRANDE}, eqs 4.5-4.18",
            published=0.0,
            computed=_point_difference,
            tolerance=0.002,
            note=f"bow seas at {SPEED:.1f} m/s, encounter up to {encounter_frequency(1.4, SPEED, 2.5):.1f} rad/s",
        ),
    ]
