"""Simulation in time: its small-wave limit, a heeled box, and what becomes of the pitch peak in higher waves."""

from dataclasses import replace
from functools import cache

import numpy as np
import xarray as xr

from workbench import pipeline
from workbench.conventions import GRAVITY, SEAWATER_DENSITY
from workbench.design import Hull
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.hulls.library import design
from workbench.hydrodynamics import strip_theory
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.motions import interpolated_motions, motions
from workbench.radiation_store import wave_frequencies
from workbench.seas import Condition, SeaState, wave_spectrum
from workbench.shapes import Offsets
from workbench.simulation.hull_grid import hull_surface
from workbench.simulation.incident_pressure import HullInWaves
from workbench.simulation.records import ShipInWaves, simulation
from workbench.time_domain import Realisation, components_from, wave_components
from workbench.verification.case import Case

GRANDE = "K. Grande, Prediction of slamming occurrence of catamarans, MSc thesis, Curtin University of Technology, 2002"
VERTICAL = 2, 4
"""Heave and pitch."""

SMALL = 5e-4
"""Amplitude of small waves over the length of the ship [-]."""

STEEPNESSES = 1 / 150, 1 / 75, 1 / 50, 1 / 35
"""Wave heights over wavelength of the pitch peak [-]."""

HEEL = np.radians(20.0)


@cache
def _delft(method: str) -> ShipInWaves:
    """The Delft 372 catamaran at Fn 0.3, in head and beam seas."""
    ship = design("delft-372")
    speed, headings = 0.3 * float(np.sqrt(GRAVITY * ship.hull.length)), [np.pi / 2, np.pi]
    if method == "potential-flow":
        found = pipeline.response(ship, speed, headings, None, PotentialFlowSettings())
        return ShipInWaves(ship, found.hydrodynamics, found.motions)
    omega = wave_frequencies(ship.hull.length)
    coefficients = strip_theory.hydrodynamics(ship.hull, ship.density, omega, headings, speed)
    stiffness = stiffness_matrix(ship.hull, ship.masses, ship.density)
    return ShipInWaves(ship, coefficients, motions(coefficients, ship.masses, stiffness))


def _amplitude(records: xr.Dataset, mode: int, encounter: float) -> complex:
    """Amplitude X of Re[X exp(-i omega_e t)] in a motion, by least squares."""
    angle = encounter * records.time.values
    columns = np.stack([np.cos(angle), np.sin(angle), np.ones_like(angle)], axis=1)
    cosine, sine, _ = np.linalg.lstsq(columns, records.motion.values[:, mode], rcond=None)[0]
    return cosine + 1j * sine


def _regular_limit(method: str) -> float:
    """Largest difference of heave and pitch from the linear response in small regular waves, over the response."""
    ship = _delft(method)
    length, worst = ship.design.hull.length, 0.0
    for ratio in (1.0, 1.5, 2.5):
        omega = np.sqrt(2 * np.pi * GRAVITY / (ratio * length))
        waves = components_from(omega, SMALL * length, 0.0, np.pi, ship.motions.attrs["speed"])
        encounter = float(waves.component_frequency[0])
        records = simulation(ship, waves, 8 * 2 * np.pi / encounter, pipeline.time_step(length))
        known = interpolated_motions(ship.motions, np.array([omega]))[0, 1]
        for mode in VERTICAL:
            own = _amplitude(records, mode, encounter) / (SMALL * length)
            worst = max(worst, abs(own - known[mode]) / abs(known[mode]))
    return worst


def _irregular_limit(method: str) -> float:
    """Largest difference of responses estimated in a small irregular sea, over the peak, in the energetic band."""
    ship = _delft(method)
    length = ship.design.hull.length
    sea = SeaState(
        significant_wave_height=1e-3 * length, peak_period=float(np.sqrt(3.6 * np.pi * length / GRAVITY))
    )
    condition = Condition(speed=ship.motions.attrs["speed"], wave_direction=np.pi, sea_state=sea)
    waves = wave_components(condition, Realisation(seed=7, components=30), 2.2, 8.0)
    records = simulation(ship, waves, 100.0, pipeline.time_step(length), panels=500)
    angle = np.multiply.outer(records.time.values, waves.component_frequency.values)
    columns = np.concatenate([np.cos(angle), np.sin(angle)], axis=1)
    fitted = np.linalg.lstsq(columns, records.motion.values[:, VERTICAL], rcond=None)[0]
    cosine, sine = np.split(fitted, 2)
    given = waves.component_amplitude.values * np.exp(1j * waves.component_phase.values)
    omega = waves.component_omega.values
    known = interpolated_motions(ship.motions, omega)[:, 1, VERTICAL]
    spectrum = wave_spectrum(sea, omega)
    energetic = spectrum > 0.1 * spectrum.max()
    difference = np.abs((cosine + 1j * sine) / given[:, None] - known)[energetic]
    return float((difference / np.abs(known[energetic]).max(axis=0)).max())


def _departure_order() -> float:
    """Power of the wave height with which motions depart from the linear ones, in a small irregular sea."""
    ship = _delft("potential-flow")
    length = ship.design.hull.length
    sizes = []
    for share in (1 / 1000, 1 / 500):
        sea = SeaState(significant_wave_height=share * length, peak_period=1.8)
        condition = Condition(speed=ship.motions.attrs["speed"], wave_direction=np.pi, sea_state=sea)
        waves = wave_components(condition, Realisation(seed=3, components=60), 2.0, 8.0)
        records = simulation(ship, waves, 40.0, pipeline.time_step(length), panels=500)
        sizes.append(float((records.motion - records.linear_motion).sel(dof="heave").std()))
    return float(np.log2(sizes[1] / sizes[0]))


@cache
def _pitch_peaks() -> tuple[float, ...]:
    """Pitch of the Crowther 318 at its linear peak in head seas, over the linear one, for rising `STEEPNESSES`."""
    ship = design("crowther-318")
    speed = 10 * 1852 / 3600
    found = pipeline.response(ship, speed, [np.pi / 2, np.pi], None, PotentialFlowSettings(panels=400))
    own = ShipInWaves(ship, found.hydrodynamics, found.motions)
    rao = np.abs(found.motions.motion_rao.values[:, 1, 4])
    omega = float(found.motions.omega[int(np.argmax(rao))])
    ratios = []
    for steepness in STEEPNESSES:
        amplitude = steepness * np.pi * GRAVITY / omega**2
        waves = components_from(omega, amplitude, 0.0, np.pi, speed)
        encounter = float(waves.component_frequency[0])
        step = pipeline.time_step(ship.hull.length)
        records = simulation(own, waves, 12 * 2 * np.pi / encounter, step, panels=600)
        ratios.append(abs(_amplitude(records, 4, encounter)) / amplitude / rao.max())
    return tuple(ratios)


def _peaks_not_lower() -> float:
    """Number of wave heights at which the pitch peak per wave height is not below the linear one."""
    return float(np.count_nonzero(np.array(_pitch_peaks()) >= 1.0))


def _box_righting_arm() -> float:
    """Righting arm of a heeled wall-sided box, by pressure on its wetted surface [m]."""
    section = ((0.0, 0.0), (0.0, 1.0), (2.5, 1.0))
    shape = Offsets(
        stations=tuple((x, section) for x in (-5.0, -2.5, 0.0, 2.5, 5.0)), draught=1.0, length=10.0
    )
    hull = Hull(shape=shape)
    waves = components_from(1.0, 1.0, 0.0, np.pi, 0.0)
    ship = HullInWaves(hull_surface(hull, (0.0, 0.0, 0.0)), np.zeros(3), waves, SEAWATER_DENSITY)
    force = ship.force(np.array([0, 0, 0, HEEL, 0, 0]), np.zeros(2 * len(ship.heights)))
    return float(-force[3] / force[2])


def cases() -> list[Case]:
    """Return the cases of this module."""
    made = [
        Case(
            id="simulation-heeled-box",
            title="righting arm of a box, beam 2 draught 1, heeled 20 degrees, by pressure on its wetted surface",
            kind="closed form",
            source="formula of the wall-sided ship, GZ = sin(phi) (GM + BM tan(phi)^2 / 2)",
            published=float(np.sin(HEEL) * (1 / 3 - 0.5 + np.tan(HEEL) ** 2 / 6)),
            computed=_box_righting_arm,
            tolerance=2e-4,
            unit="m",
        )
    ]
    limit = Case(
        id="simulation-regular-limit",
        title="non-linear heave and pitch in small regular waves against the linear response, worst difference",
        kind="second method",
        source=f"{GRANDE}, 3.1.3: what must hold, and did not there",
        published=0.0,
        computed=lambda: _regular_limit("potential-flow"),
        tolerance=0.02,
        note="Delft 372 at Fn 0.3, head seas, amplitude L/2000, wavelengths of 1, 1.5 and 2.5 L",
    )
    made += [
        limit,
        replace(
            limit,
            id="simulation-regular-limit-strip",
            title="the same with the coefficients of strip theory",
            computed=lambda: _regular_limit("strip"),
        ),
        replace(
            limit,
            id="simulation-irregular-limit",
            title="responses estimated in a small irregular sea, non-linear, against the linear ones",
            computed=lambda: _irregular_limit("potential-flow"),
            note="Delft 372 at Fn 0.3, head seas, Hs L/1000; share of the peak, over the energetic band",
        ),
        Case(
            id="simulation-departure-order",
            title="power of the wave height with which heave departs from linear motion, small irregular seas",
            kind="trend",
            source=f"{GRANDE}, 3.1.1 and 3.1.3: non-linear tends to linear as the waves get small",
            published=2.0,
            computed=_departure_order,
            tolerance=0.3,
            note="what is left out of linear theory is of second order",
        ),
        Case(
            id="simulation-pitch-peak-lower",
            title="Crowther 318 in head seas: wave heights at which the pitch peak is not below the linear one",
            kind="trend",
            source=f"{GRANDE}, 3.1.1: the peak of non-linear pitch is lower",
            published=0.0,
            computed=_peaks_not_lower,
            tolerance=0.0,
            note="10 knots; heights of 1/150, 1/75, 1/50, 1/35 of the wavelength: 0.99, 0.99, 0.87, 0.63 of it",
        ),
    ]
    return made
