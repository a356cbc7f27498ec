"""The theories of the motions beside each other: heave and pitch of one ship in the same waves.

Amplitudes are heave over wave amplitude and pitch over wave slope, phases leads over the wave at the
centre of gravity. Measured series are Datasets of the same names over (point, dof); their ``name``
is in their attributes.
"""

import time
from collections.abc import Callable, Sequence

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from workbench import quantities
from workbench.conventions import GRAVITY
from workbench.design import Design
from workbench.errors import InputError, checked_choice
from workbench.hydrodynamics.recommended import METHODS, THEORY_NAMES, RecommendedSettings
from workbench.motions import lead_over_wave
from workbench.pipeline import response, silent
from workbench.running_state import RunningState

MODES = ("heave", "pitch")
QUICK_THEORIES = ("strip", "high-speed")
WAVELENGTHS = (0.4, 3.0)
"""Shortest and longest wave of the usual comparison, in ship lengths [-]."""
POINTS = 53
LARGE_ENOUGH = 0.25
"""Share of the measured peak above which phases are compared [-]."""


def compared(
    design: Design,
    speed: float,
    wave_direction: float,
    methods: Sequence[str] = QUICK_THEORIES,
    omega: Sequence[float] | None = None,
    measured: Sequence[xr.Dataset] = (),
    *,
    settings: RecommendedSettings | None = None,
    running_state: RunningState | None = None,
    workers: int = 1,
    progress: Callable[[float, str], None] = silent,
) -> xr.Dataset:
    """Heave and pitch by several theories.

    Parameters
    ----------
    speed : [m/s]; wave_direction : [rad].
    methods : of `recommended.METHODS`, without "recommended".
    omega : wave frequencies [rad/s]; None takes waves of 0.4 to 3 ship lengths, and the measured ones.
    measured : series whose wavelengths are among those computed.
    settings : choices within each theory; running_state : as for `pipeline.response`.
    workers : processes for a new hull of the panel method; progress : called with fraction and sentence.

    Returns
    -------
    Dataset (theory, omega, dof): ``motion_ratio``, ``motion_lead`` and, by theory, ``computing_time`` and
    ``theory_name``. The attribute ``left_out`` says, a line each, which theories cannot be used here.
    The panel method is solved at its own frequencies and taken between them by a spline; waves that its
    panels cannot carry have no value.

    Raises
    ------
    InputError where no theory can be used.
    """
    for method in methods:
        checked_choice("theory to compare", method, tuple(name for name in METHODS if name != "recommended"))
    within = settings or RecommendedSettings()
    waves = _waves(design, measured) if omega is None else np.asarray(omega, float)
    found, times, refused, notes = {}, {}, [], []
    for index, method in enumerate(methods):

        def step(fraction: float, message: str, index=index, method=method) -> None:
            progress((index + fraction) / len(methods), f"{THEORY_NAMES[method]}: {message}")

        step(0.0, "begins")
        start = time.perf_counter()
        own = None if method == "potential-flow" else waves
        try:
            moved = response(
                design, speed, [wave_direction], own, within.of(method), running_state=running_state,
                workers=workers, progress=step,
            ).motions  # fmt: skip
        except InputError as error:
            refused.append(f"{THEORY_NAMES[method].capitalize()} left out: {error}")
            continue
        times[method] = time.perf_counter() - start
        found[method] = _steady(moved, waves)
        notes += [f"{THEORY_NAMES[method].capitalize()}: {line}" for line in quantities.warnings_of(moved)]
    if not found:
        raise InputError(" ".join(refused) or "theories to compare must be one at least, got none; name one.")
    values = np.stack(list(found.values()))
    return quantities.dataset(
        {"theory": list(found), "omega": waves, "dof": list(MODES)},
        method=" and ".join(found),
        warnings=notes,
        attrs={
            "speed": float(speed),
            "wave_direction": float(wave_direction),
            "left_out": "\n".join(refused),
        },
        motion_ratio=(("theory", "omega", "dof"), np.abs(values)),
        motion_lead=(("theory", "omega", "dof"), -np.angle(values)),
        wavelength_over_length=("omega", wavelengths(waves, design.hull.length)),
        computing_time=("theory", list(times.values())),
        theory_name=("theory", [THEORY_NAMES[name] for name in found]),
    )


def wavelengths(omega, length: float):
    """Lengths of waves in deep water over the ship's [-]; omega [rad/s], length [m]."""
    return 2 * np.pi * GRAVITY / (np.asarray(omega) ** 2 * length)


def measured_series(
    name: str, wavelength_over_length, ratio: np.ndarray, lead: np.ndarray, source: str
) -> xr.Dataset:
    """Measured heave and pitch as a Dataset over (point, dof).

    Parameters
    ----------
    name : of the series; wavelength_over_length : (point).
    ratio, lead : (point, 2) of heave over amplitude and pitch over slope [-], and of their leads [rad].
    source : citation.
    """
    order = np.argsort(wavelength_over_length)
    return quantities.dataset(
        {"dof": list(MODES)},
        method="measured",
        attrs={"name": name, "source": source},
        wavelength_over_length=("point", np.asarray(wavelength_over_length, float)[order]),
        motion_ratio=(("point", "dof"), np.asarray(ratio, float)[order]),
        motion_lead=(("point", "dof"), np.asarray(lead, float)[order]),
    )


def summary(motions: xr.Dataset, measured: Sequence[xr.Dataset] = ()) -> xr.Dataset:
    """Peaks of the theories, and their mean differences from measured series.

    Returns
    -------
    Dataset: ``peak_ratio``, ``peak_wavelength`` (theory, dof); ``mean_difference`` over the measured peak and
    ``lead_difference`` where the measured motion is above a quarter of its peak (theory, series, dof), over the
    measured waves that were computed; ``computing_time`` (theory).
    """
    ratio = motions.motion_ratio
    at = ratio.fillna(-1.0).argmax("omega")
    values = {
        "peak_ratio": (("theory", "dof"), ratio.max("omega").values),
        "peak_wavelength": (("theory", "dof"), motions.wavelength_over_length.values[at.values]),
        "computing_time": ("theory", motions.computing_time.values),
        "theory_name": ("theory", motions.theory_name.values),
    }
    coords = {"theory": motions.theory.values, "dof": list(MODES)}
    if measured:
        away = np.array([[_differences(one, series) for series in measured] for one in _each(motions)])
        coords["series"] = [series.attrs["name"] for series in measured]
        values["mean_difference"] = (("theory", "series", "dof"), away[:, :, 0])
        values["lead_difference"] = (("theory", "series", "dof"), away[:, :, 1])
    return quantities.dataset(coords, method=motions.attrs["method"], **values)


def _waves(design: Design, measured: Sequence[xr.Dataset]) -> np.ndarray:
    """Return the usual wave frequencies of a comparison, with the measured ones [rad/s]."""
    own = [series.wavelength_over_length.values for series in measured]
    ratios = np.concatenate([np.linspace(*WAVELENGTHS, POINTS), *own])
    return np.unique(np.round(np.sqrt(2 * np.pi * GRAVITY / (ratios * design.hull.length)), 9))


def _steady(moved: xr.Dataset, omega: np.ndarray) -> np.ndarray:
    """Return heave over amplitude and pitch over slope, against the wave at the centre of gravity (omega, 2)."""
    phase = np.exp(-1j * lead_over_wave(moved).sel(dof=list(MODES)).values[:, 0])
    values = np.abs(moved.motion_rao.sel(dof=list(MODES)).values[:, 0]) * phase
    values[:, 1] /= moved.wavenumber.values
    nodes = moved.omega.values
    if np.array_equal(nodes, omega):
        return values
    between = CubicSpline(nodes, values)(omega)
    return np.where(((omega >= nodes[0]) & (omega <= nodes[-1]))[:, None], between, np.nan)


def _each(motions: xr.Dataset) -> list[xr.Dataset]:
    return [motions.isel(theory=index) for index in range(motions.sizes["theory"])]


def _differences(one: xr.Dataset, series: xr.Dataset) -> np.ndarray:
    """Return mean difference and mean difference of phase of heave and pitch (2, 2)."""
    along, at = one.wavelength_over_length.values[::-1], series.wavelength_over_length.values
    steady = (one.motion_ratio * np.exp(-1j * one.motion_lead)).values[::-1]
    inside = (at >= along[0]) & (at <= along[-1])
    result = np.full((2, 2), np.nan)
    for column in range(2):
        there = np.interp(at, along, steady[:, column].real) + 1j * np.interp(
            at, along, steady[:, column].imag
        )
        kept = inside & np.isfinite(there)
        if not kept.any():
            continue
        ratio, lead = series.motion_ratio.values[kept, column], series.motion_lead.values[kept, column]
        peak = series.motion_ratio.values[:, column].max()
        result[0, column] = np.abs(np.abs(there[kept]) - ratio).mean() / peak
        large = ratio > LARGE_ENOUGH * peak
        if large.any():
            turned = np.angle(np.exp(1j * (-np.angle(there[kept][large]) - lead[large])))
            result[1, column] = turned.mean()
    return result
