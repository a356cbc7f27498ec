"""The hydrodynamics stage of the pipeline: any theory behind one call, with its usual waves and headings."""

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np
import xarray as xr

from workbench import potential_flow_stage, quantities
from workbench.conventions import MODES
from workbench.design import Hull
from workbench.hydrodynamics import high_speed, strip_theory
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import RecommendedSettings, TheorySettings, reason, recommended
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.hydrodynamics.strip_wave_field import wave_field
from workbench.radiation_store import USUAL_DIRECTIONS, usual_directions, wave_frequencies

Found = tuple[xr.Dataset, xr.Dataset | None]


def directions_for(settings: TheorySettings, length: float, speed: float) -> np.ndarray:
    """Usual wave directions of a theory [rad]: all round by 15 degrees, where it allows them."""
    if isinstance(settings, StripSettings | RecommendedSettings):
        return np.array(USUAL_DIRECTIONS)
    return usual_directions(length, speed)


def hydrodynamics(
    hull: Hull,
    density: float,
    speed: float,
    wave_directions: Sequence[float],
    omega: Sequence[float] | None,
    settings: TheorySettings,
    *,
    workers: int,
    progress: Callable[[float, str], None],
) -> Found:
    """Hydrodynamics of a hull in its attitude by the theory of ``settings``, and its waves under the deck.

    Parameters
    ----------
    omega : wave frequencies [rad/s]; None takes the usual ones.

    Returns
    -------
    Dataset of `coefficient_set`; Dataset with ``radiated_elevation`` and ``diffracted_elevation``, or None.
    """
    if isinstance(settings, RecommendedSettings):
        return _recommended(hull, density, speed, wave_directions, omega, settings, workers, progress)
    if isinstance(settings, PotentialFlowSettings):
        return potential_flow_stage.hydrodynamics(
            hull, density, speed, wave_directions, omega, settings, workers=workers, progress=progress
        )
    frequencies = wave_frequencies(hull.length) if omega is None else np.asarray(omega, float)
    potential_flow_stage.check_frequencies(frequencies)
    progress(0.1, "Marching along the hulls")
    found = _by_sections(
        hull, density, float(speed), tuple(map(float, wave_directions)), tuple(frequencies.tolist()), settings
    )
    progress(1.0, "Sections solved")
    return tuple(part if part is None else part.copy(deep=True) for part in found)


@lru_cache(maxsize=16)
def _by_sections(
    hull: Hull,
    density: float,
    speed: float,
    directions: tuple[float, ...],
    omega: tuple[float, ...],
    settings: StripSettings | HighSpeedSettings,
) -> Found:
    """Return the hydrodynamics by strips or by the march; kept in memory, as it depends on its arguments alone."""
    if isinstance(settings, HighSpeedSettings):
        return high_speed.solution(hull, density, omega, directions, speed, settings)
    found = strip_theory.hydrodynamics(hull, density, omega, directions, speed, settings)
    if settings.wave_field == "incident" or hull.count == 1:
        return found, None
    return found, wave_field(hull, omega, directions, speed, settings)


def _recommended(
    hull: Hull,
    density: float,
    speed: float,
    wave_directions: Sequence[float],
    omega: Sequence[float] | None,
    settings: RecommendedSettings,
    workers: int,
    progress: Callable[[float, str], None],
) -> Found:
    """Return each heading by the theory that is recommended for it, all in one Dataset."""
    directions = np.asarray(wave_directions, float)
    wanted = wave_frequencies(hull.length) if omega is None else np.asarray(omega, float)
    potential_flow_stage.check_frequencies(wanted)
    chosen = np.array(recommended(hull.length, speed, directions, wanted, settings.quick))
    methods = list(dict.fromkeys(chosen.tolist()))
    parts, field = [], None
    for method in methods:
        own = directions[chosen == method]
        # the panel method may allow fewer frequencies than are usual
        asked = omega if len(methods) == 1 else wanted
        part, field = hydrodynamics(
            hull, density, speed, own, asked, settings.of(method), workers=workers, progress=progress
        )
        parts.append(part)
    note = reason(hull.length, speed, methods)
    if len(parts) == 1:
        found = parts[0]
    else:
        field = None
        found = _side_by_side(parts, directions)
        found.attrs["warnings"] = quantities.joined_warnings(
            list(dict.fromkeys(sentence for part in parts for sentence in quantities.warnings_of(part)))
        )
        for method, part in zip(methods, parts, strict=True):
            found.attrs[f"{method} warnings"] = part.attrs["warnings"]
        found.attrs["method"] = " and ".join(methods)
        found.attrs["solver"] = " and ".join(part.attrs["solver"] for part in parts)
    found.attrs["recommendation"] = note
    return found, field


def _side_by_side(parts: list[xr.Dataset], directions: np.ndarray) -> xr.Dataset:
    """Return headings of several theories in one Dataset, in the order of ``directions``."""
    whole = []
    for part in parts:
        if "stiffness_correction" not in part and any("stiffness_correction" in one for one in parts):
            none = xr.zeros_like(part.added_mass.isel(omega=0, drop=True))
            none.attrs = quantities.attributes("stiffness_correction")
            part = part.assign(stiffness_correction=none)
        whole.append(part)
    joined = xr.concat(
        whole,
        dim="wave_direction",
        data_vars="minimal",
        coords="minimal",
        compat="override",
        combine_attrs="override",
    )
    return joined.sel(wave_direction=directions)


def stiffness_addition(hydrodynamics: xr.Dataset) -> xr.Dataset:
    """What the theory changes in the hydrostatic stiffness, as an addition to the equation of motion."""
    correction = hydrodynamics.stiffness_correction.assign_coords(
        wave_direction=hydrodynamics.wave_direction.values,
        influenced_dof=list(MODES),
        radiating_dof=list(MODES),
    )
    return xr.Dataset({"stiffness": correction}, attrs={"method": "dry transom"})
