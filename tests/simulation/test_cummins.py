"""The equation for the departure from linear motion: in time against frequency, and its limits."""

import numpy as np
import pytest

from workbench import pipeline
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.motions import interpolated_motions, mass_matrix, roll_damping, translation_matrix
from workbench.seas import Condition, SeaState, wave_spectrum
from workbench.simulation.cummins import DepartureEquation, departures, simulated_departure
from workbench.simulation.hull_grid import hull_surface
from workbench.simulation.incident_pressure import HullInWaves
from workbench.simulation.records import ShipInWaves, departure_equation, simulation
from workbench.simulation.retardation import RadiationOperator, radiation_forces
from workbench.time_domain import Realisation, components_from, motion_amplitudes, wave_components

STEP = 0.0111
VERTICAL = [2, 4]
HEAD, OBLIQUE = np.pi, np.radians(150.0)


def amplitude_of(series, times, omega):
    """Complex amplitude X of Re[X exp(-i omega t)] by least squares."""
    columns = np.stack([np.cos(omega * times), np.sin(omega * times), np.ones_like(times)], axis=1)
    cosine, sine, _ = np.linalg.lstsq(columns, series, rcond=None)[0]
    return cosine + 1j * sine


def regular(ship, amplitude, omega, direction=OBLIQUE, periods=8, **others):
    waves = components_from(omega, amplitude, 0.3, direction, ship.motions.attrs["speed"])
    duration = periods * 2 * np.pi / abs(float(waves.component_frequency[0]))
    return waves, simulation(ship, waves, duration, STEP, **others)


def test_harmonic_force_gives_the_response_of_the_operator():
    """Settled motion of one mode with memory, by the frequency response of the same operator."""
    step, omega = 0.05, 1.2
    times = np.arange(6000) * step
    kernel = 4.0 * np.exp(-2.0 * times[:120])[:, None, None]
    operator = RadiationOperator(
        np.full((1, 1), 1.0), np.full((1, 1), 0.3), np.full((1, 1), 0.5), kernel, step
    )
    equation = DepartureEquation((2,), np.full((1, 1), 2.0), np.full((1, 1), 3.0), operator)
    found = departures(equation, lambda i, y: np.array([np.cos(omega * times[i])]), len(times))[:, 0]
    known = 1 / (3.0 - 2.0 * omega**2 - operator.response([omega])[0, 0, 0])
    settled = slice(3000, None)
    assert amplitude_of(found[settled], times[settled], omega) == pytest.approx(known, rel=2e-3)


def test_pulse_in_time_is_the_pulse_by_frequencies(any_ship):
    """Second method: the response to a force by Fourier integral over the coefficients themselves."""
    equation = departure_equation(any_ship, STEP)
    length = any_ship.design.hull.length
    centre, width = 1.0, 0.12
    direction = np.array([100.0, 5.0, 30.0])
    times = np.arange(int(6.0 / STEP)) * STEP
    pulse = np.exp(-(((times - centre) / width) ** 2) / 2)
    in_time = departures(equation, lambda i, y: direction * pulse[i], len(times))

    stiffness = stiffness_matrix(any_ship.design.hull, any_ship.design.masses, any_ship.design.density)
    viscous = roll_damping(any_ship.design.masses, stiffness, any_ship.hydrodynamics.added_mass.values)
    omega, force = radiation_forces(any_ship.hydrodynamics, viscous, any_ship.additions)
    back = np.linalg.inv(translation_matrix(any_ship.design.masses.centre_of_gravity))[:, 2:5]
    dense = np.linspace(1e-3, 12 / np.sqrt(length / GRAVITY), 3000)
    own = (back.T @ force @ back).reshape(len(omega), 9)
    own = np.stack([np.interp(dense, omega, part) for part in own.T], axis=1).reshape(-1, 3, 3)
    system = back.T @ stiffness @ back - dense[:, None, None] ** 2 * (
        back.T @ mass_matrix(any_ship.design.masses) @ back
    )
    system = system - own
    spectrum = width * np.sqrt(2 * np.pi) * np.exp(-((dense * width) ** 2) / 2 + 1j * dense * centre)
    found = np.linalg.solve(system, (direction * spectrum[:, None])[..., None])[..., 0]
    kernel = np.exp(-1j * np.multiply.outer(times, dense))
    by_frequency = np.trapezoid((kernel[:, :, None] * found), dense, axis=1).real / np.pi
    size = np.abs(by_frequency).max(axis=0)
    np.testing.assert_allclose(in_time / size, by_frequency / size, atol=0.04)


@pytest.mark.parametrize("ratio", [1.2, 2.0])
def test_small_regular_wave_gives_the_linear_response(any_ship, ratio):
    omega = np.sqrt(2 * np.pi * GRAVITY / (ratio * any_ship.design.hull.length))
    amplitude = 5e-4 * any_ship.design.hull.length
    waves, found = regular(any_ship, amplitude, omega)
    encounter = float(waves.component_frequency[0])
    rao = interpolated_motions(any_ship.motions, np.array([omega]))[0, 1] * np.exp(0.3j)
    for mode in range(6):
        own = amplitude_of(found.motion.values[:, mode], found.time.values, encounter) / amplitude
        assert abs(own - rao[mode]) < 0.02 * abs(rao[mode])


def test_small_irregular_sea_gives_the_linear_response(any_ship):
    """Response estimated at each wave component of a random sea, over the energetic band."""
    length = any_ship.design.hull.length
    sea = SeaState(
        significant_wave_height=1e-3 * length, peak_period=float(np.sqrt(2 * np.pi * 1.8 * length / GRAVITY))
    )
    condition = Condition(speed=any_ship.motions.attrs["speed"], wave_direction=HEAD, sea_state=sea)
    waves = wave_components(condition, Realisation(seed=7, components=30), 2.2, 8.0)
    found = simulation(any_ship, waves, 100.0, STEP, panels=400)
    encounter, times = waves.component_frequency.values, found.time.values
    angle = np.multiply.outer(times, encounter)
    columns = np.concatenate([np.cos(angle), np.sin(angle)], axis=1)
    cosine, sine = np.split(np.linalg.lstsq(columns, found.motion.values[:, (2, 4)], rcond=None)[0], 2)
    given = waves.component_amplitude.values * np.exp(1j * waves.component_phase.values)
    estimated = (cosine + 1j * sine) / given[:, None]
    omega = waves.component_omega.values
    rao = interpolated_motions(any_ship.motions, omega)[:, 2][:, (2, 4)]
    spectrum = wave_spectrum(sea, omega)
    energetic = spectrum > 0.1 * spectrum.max()
    assert energetic.sum() > 8
    size = np.abs(rao[energetic]).max(axis=0)
    assert (np.abs(estimated - rao)[energetic] / size).max() < 0.02


def test_departure_is_of_second_order_in_the_waves(any_ship):
    omega = np.sqrt(2 * np.pi * GRAVITY / (1.5 * any_ship.design.hull.length))
    sizes = []
    for amplitude in (2e-4, 4e-4):
        _, found = regular(any_ship, amplitude * any_ship.design.hull.length, omega, panels=400)
        sizes.append(float((found.motion - found.linear_motion).sel(dof="heave").std()))
    assert sizes[1] / sizes[0] == pytest.approx(4.0, abs=1.5)
    assert sizes[0] > 0


def test_departure_is_at_its_time_whatever_the_lead_in(ship):
    """A longer lead-in changes nothing that has settled: departure and linear motion share their clock."""
    speed, centre = ship.motions.attrs["speed"], np.array(ship.design.masses.centre_of_gravity)
    waves = components_from(4.0, 0.008, 0.3, HEAD, speed)
    surface = hull_surface(ship.design.hull, centre, 300)
    in_waves = HullInWaves(surface, centre, waves, ship.design.density)
    own, equation = motion_amplitudes(waves, ship.motions), departure_equation(ship, STEP)
    short, long = (
        simulated_departure(equation, in_waves, own, steps=400, lead_in=lead_in).departure[:, VERTICAL]
        for lead_in in (700, 1300)
    )
    size = np.abs(long).max(axis=0)
    np.testing.assert_allclose(short / size, long / size, atol=0.02)


def test_modes_without_restoring_keep_to_the_linear_solution(ship):
    _, found = regular(ship, 0.04, 4.0, panels=400)
    for mode in ("surge", "sway", "yaw"):
        np.testing.assert_array_equal(found.motion.sel(dof=mode), found.linear_motion.sel(dof=mode))
    assert float(np.abs(found.motion - found.linear_motion).sel(dof="pitch").max()) > 1e-4


def test_locked_modes_stay_locked(ship):
    held = ship.motions.copy()
    held["motion_rao"] = held.motion_rao * (held.dof != "roll")
    held.attrs["locked"] = "roll"
    _, found = regular(
        ShipInWaves(ship.design, ship.hydrodynamics, held, None), 0.04, 4.0, panels=400, periods=3
    )
    assert not found.motion.sel(dof="roll").any()
    assert departure_equation(ship, STEP).modes == (2, 3, 4)


def test_finer_steps_change_nothing_much(ship):
    waves = components_from(4.0, 0.03, 0.3, OBLIQUE, ship.motions.attrs["speed"])
    coarse = simulation(ship, waves, 6.0, 0.02, panels=400)
    fine = simulation(ship, waves, 6.0, 0.005, panels=400)
    for mode in ("heave", "roll", "pitch"):
        own, known = (
            coarse.motion.sel(dof=mode).values,
            fine.motion.sel(dof=mode).values[::4][: coarse.sizes["time"]],
        )
        assert np.abs(own - known).max() < 0.02 * np.abs(known).max()


def test_ship_at_rest_with_resonant_water_between_its_hulls(twin):
    """The radiation forces ring longer than any memory; the limit holds all the same, and nothing grows."""
    from workbench.hydrodynamics.settings import PotentialFlowSettings

    omega = np.linspace(0.4, 1.7, 12)
    found = pipeline.response(twin, 0.0, [np.pi / 2, np.pi], omega, PotentialFlowSettings(panels=200))
    own = ShipInWaves(twin, found.hydrodynamics, found.motions, found.wave_field)
    waves = components_from(1.1, 0.02, 0.0, np.pi / 2, 0.0)
    records = simulation(own, waves, 60.0, 0.05, panels=400)
    rao = interpolated_motions(found.motions, np.array([1.1]))[0, 0]
    for mode in (2, 3):
        heard = amplitude_of(records.motion.values[:, mode], records.time.values, 1.1) / 0.02
        assert abs(heard - rao[mode]) < 0.02 * abs(rao[mode])


def test_waves_that_no_ship_survives_are_refused_in_a_sentence(ship):
    steep = components_from(3.2, 0.9, 0.0, HEAD, ship.motions.attrs["speed"])
    with pytest.raises(InputError, match=r"(leaves the water|pitches|rolls).*lower the waves"):
        simulation(ship, steep, 10.0, STEP, panels=400)


def test_coarse_steps_are_refused(ship):
    waves = components_from(4.0, 0.01, 0.0, HEAD, ship.motions.attrs["speed"])
    with pytest.raises(InputError, match="time_step must be <="):
        simulation(ship, waves, 10.0, 0.2)
