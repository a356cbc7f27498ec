"""Transfer functions, sea areas, criteria of motions and added resistance."""

import dataclasses

import numpy as np
import pytest
import xarray as xr

from workbench import quantities
from workbench.added_resistance import (
    ORDER_OF_MAGNITUDE,
    added_resistance,
    mean_added_resistance,
    mean_from_coefficient,
)
from workbench.conventions import GRAVITY, encounter_frequency
from workbench.design import MassProperties
from workbench.encounter import to_encounter
from workbench.errors import InputError
from workbench.motion_criteria import (
    FERRY_CRITERIA,
    SIGNIFICANT_SHARE,
    MotionCriterion,
    assessments,
    exceedance_probability,
)
from workbench.motions import motions
from workbench.sea_areas import SEA_AREAS, modal_frequency, sea_area, two_parameter_spectrum
from workbench.seas import wave_spectrum
from workbench.transfer_functions import (
    acceleration_at,
    added_resistance_coefficient,
    response_of,
    response_variance,
    scaled_frequency,
    sea_response,
    transfer_function,
)

OMEGA = np.linspace(0.3, 3.0, 400)


@pytest.mark.parametrize("kind", ["heave", "pitch", "acceleration"])
def test_transfer_functions_there_and_back(kind):
    met = encounter_frequency(OMEGA, 10.0, np.pi)
    wave = 0.02
    response = response_of(kind, 1.3, OMEGA, met) * wave
    assert transfer_function(kind, response, wave, OMEGA, met) == pytest.approx(1.3)
    rms = transfer_function(kind, response / np.sqrt(2), wave / np.sqrt(2), OMEGA, met)
    assert rms == pytest.approx(1.3)
    with pytest.raises(InputError, match="wave amplitude"):
        transfer_function(kind, response, 0.0, OMEGA, met)


def test_transfer_functions_are_those_of_the_source():
    """Pitch over wave slope; acceleration over omega_e squared."""
    assert transfer_function("pitch", 0.1, 0.5, 2.0, 3.0) == pytest.approx(0.1 / 0.5 * GRAVITY / 4.0)
    assert transfer_function("acceleration", 0.9, 0.5, 2.0, 3.0) == pytest.approx(0.2)


def test_acceleration_at_the_centre_has_the_transfer_function_of_heave():
    heave, pitch, met = 0.8 * np.exp(0.4j), 0.06 * np.exp(-1.2j), 2.5
    at_centre = acceleration_at(heave, pitch, met, 0.0)
    assert transfer_function("acceleration", at_centre, 1.0, 1.1, met) == pytest.approx(
        transfer_function("heave", abs(heave), 1.0, 1.1, met)
    )
    assert acceleration_at(heave, pitch, met, 20.0) == pytest.approx(met**2 * abs(heave - 20 * pitch))
    forward, aft = (acceleration_at(heave, pitch, met, lever) for lever in (20.0, -20.0))
    assert (forward**2 + aft**2) / 2 == pytest.approx(met**4 * (abs(heave) ** 2 + (20 * abs(pitch)) ** 2))


def test_added_resistance_coefficient_by_amplitude_and_rms():
    amplitude = added_resistance_coefficient(12.0, 10.0, 0.02, 1000.0, 0.2, 1.6)
    assert amplitude == pytest.approx(2.0 / (1000 * GRAVITY * 0.02**2 * 0.2**2 / 1.6))
    rms = added_resistance_coefficient(12.0, 10.0, 0.02 / np.sqrt(2), 1000.0, 0.2, 1.6, "rms")
    assert rms == pytest.approx(amplitude)


@pytest.mark.parametrize("kind", ["heave", "pitch", "acceleration"])
def test_variance_over_encounter_is_that_over_wave_frequency(kind):
    sea = wave_spectrum(sea_area("North Sea").sea_state(), OMEGA)
    met, moved = to_encounter(OMEGA, sea, 15.0, np.pi)
    function = 1 / (1 + (met / 3) ** 4)
    known = np.trapezoid(response_of(kind, function, OMEGA, met) ** 2 * sea, OMEGA)
    assert response_variance(kind, function, OMEGA, met, moved) == pytest.approx(known, rel=1e-3)


def test_figures_of_a_response():
    assert sea_response(0.25) == {"rms": 0.5, "significant_amplitude": 1.0, "significant_height": 2.0}
    assert scaled_frequency(8.0, 1.6, 1.6 * 16) == pytest.approx(2.0)


def test_two_parameter_spectrum_has_its_height_and_peak():
    for area in SEA_AREAS:
        omega = np.linspace(0.0, 20.0, 100_001)
        found = two_parameter_spectrum(area.significant_wave_height, area.mean_period, omega)
        assert np.trapezoid(found, omega) == pytest.approx(area.significant_wave_height**2 / 16, rel=1e-3)
        assert omega[np.argmax(found)] == pytest.approx(modal_frequency(area.mean_period), abs=2e-4)
        known = wave_spectrum(area.sea_state(), omega)
        assert found == pytest.approx(known, abs=0.002 * known.max())
    assert modal_frequency(5.9) == pytest.approx(0.8221, abs=1e-4)
    assert modal_frequency(5.2) == pytest.approx(0.9328, abs=1e-4)


def test_areas_take_any_spectrum():
    jonswap = sea_area("Irish Sea").sea_state("jonswap")
    assert jonswap.spectrum == "jonswap"
    with pytest.raises(InputError, match="Irish Sea, North Sea"):
        sea_area("Dead Sea")


def test_criteria_pass_and_fail():
    heave, pitch = assessments({"heave": 0.8**2, "pitch": np.radians(2.0) ** 2})
    assert heave.passes
    assert heave.exceedance == pytest.approx(np.exp(-(2.0**2) / (2 * 0.8**2)))
    assert heave.significant_amplitude == pytest.approx(1.6)
    assert not pitch.passes
    at_limit = assessments({"heave": 1.0})[0]
    assert at_limit.exceedance == pytest.approx(SIGNIFICANT_SHARE)
    assert at_limit.passes
    strict = (dataclasses.replace(FERRY_CRITERIA[0], allowed=0.01),)
    assert not assessments({"heave": 0.8**2}, strict)[0].passes


def test_criteria_of_the_source():
    limits = {one.motion: one.limit for one in FERRY_CRITERIA}
    assert limits["heave"] == 2.0
    assert np.degrees(limits["pitch"]) == pytest.approx(3.0)
    assert limits["vertical acceleration"] == pytest.approx(0.4 * 9.80665)
    assert limits["lateral acceleration"] == pytest.approx(0.2 * 9.80665)


def test_criteria_refuse():
    assert exceedance_probability(1.0, 0.0) == 0.0
    with pytest.raises(InputError, match="one of heave"):
        assessments({"surge": 1.0})
    with pytest.raises(InputError, match="limit of heave"):
        MotionCriterion(motion="heave", limit=0.0, unit="m")
    with pytest.raises(InputError, match="allowed share"):
        MotionCriterion(motion="heave", limit=1.0, unit="m", allowed=1.5)


def made_ship(coupling=0.0, centre=(0.0, 0.0, 0.0), speed=6.0):
    """A ship of given coefficients in head seas, coefficients about the origin."""
    omega = np.linspace(0.4, 1.6, 9)
    added, damping = np.zeros((9, 1, 6, 6)), np.zeros((9, 1, 6, 6))
    added[..., range(6), range(6)] = 2e5
    for mode, size in ((2, 3e5), (4, 3e7)):
        added[..., mode, mode] = size
        damping[..., mode, mode] = size * 0.5
    damping[..., 2, 4] = damping[..., 4, 2] = coupling
    force = np.zeros((9, 1, 6), complex)
    force[..., 2] = 2e6 * np.exp(1j * omega)[:, None]
    force[..., 4] = 3e7j * np.exp(0.5j * omega)[:, None]
    k = omega**2 / GRAVITY
    hydrodynamics = quantities.dataset(
        {
            "omega": omega, "wave_direction": [np.pi],
            "influenced_dof": ["surge", "sway", "heave", "roll", "pitch", "yaw"],
            "radiating_dof": ["surge", "sway", "heave", "roll", "pitch", "yaw"],
        },
        method="given coefficients",
        attrs={"speed": speed, "density": 1025.0},
        added_mass=(("omega", "wave_direction", "influenced_dof", "radiating_dof"), added),
        radiation_damping=(("omega", "wave_direction", "influenced_dof", "radiating_dof"), damping),
        excitation_force=(("omega", "wave_direction", "influenced_dof"), force),
        encounter_frequency=(("omega", "wave_direction"), encounter_frequency(omega, speed, np.pi)[:, None]),
        wavenumber=("omega", k),
    )  # fmt: skip
    masses = MassProperties(
        mass=4e5, centre_of_gravity=centre, roll_gyradius=4.0, pitch_gyradius=10.0, yaw_gyradius=10.0
    )
    stiffness = np.zeros((6, 6))
    stiffness[2, 2], stiffness[3, 3], stiffness[4, 4] = 4e6, 1e8, 4e8
    modes = ["surge", "sway", "heave", "roll", "pitch", "yaw"]
    stiffness = xr.DataArray(stiffness, coords={"a": modes, "b": modes}, dims=("a", "b"))
    return hydrodynamics, motions(hydrodynamics, masses, stiffness)


def test_both_forms_of_the_added_resistance_are_the_radiated_energy():
    hydrodynamics, moved = made_ship()
    by_force = added_resistance(hydrodynamics, moved)
    by_damping = added_resistance(hydrodynamics, moved, "damping")
    assert by_force.added_resistance.values == pytest.approx(by_damping.added_resistance.values, rel=1e-9)
    assert np.all(by_force.added_resistance.values > 0)
    assert ORDER_OF_MAGNITUDE in by_force.attrs["warnings"]


def test_coupling_is_in_the_first_form_only():
    hydrodynamics, moved = made_ship(coupling=2e6)
    by_force = added_resistance(hydrodynamics, moved).added_resistance.values
    motion = moved.motion_rao.values
    damping = hydrodynamics.radiation_damping.values
    whole = np.einsum("fbi,fbij,fbj->fb", np.conj(motion), damping, motion).real
    encounter, k = hydrodynamics.encounter_frequency.values, hydrodynamics.wavenumber.values[:, None]
    assert by_force == pytest.approx(k * encounter / 2 * whole, rel=1e-9)
    assert by_force != pytest.approx(
        added_resistance(hydrodynamics, moved, "damping").added_resistance.values, rel=1e-3
    )


def test_moved_centre_of_gravity_keeps_the_energy():
    hydrodynamics, moved = made_ship(centre=(1.0, 0.0, 0.0))
    by_force = added_resistance(hydrodynamics, moved).added_resistance.values
    at_origin = moved.motion_rao.values @ np.linalg.inv(np.array(
        [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 1], [0, 0, 1, 0, -1, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0],
         [0, 0, 0, 0, 0, 1]])).T  # fmt: skip
    damping = hydrodynamics.radiation_damping.values
    whole = np.einsum("fbi,fbij,fbj->fb", np.conj(at_origin), damping, at_origin).real
    encounter, k = hydrodynamics.encounter_frequency.values, hydrodynamics.wavenumber.values[:, None]
    assert by_force == pytest.approx(k * encounter / 2 * whole, rel=1e-9)


def test_mean_added_resistance_goes_with_the_square_of_the_sea():
    omega = np.linspace(0.3, 3.0, 500)
    sea = two_parameter_spectrum(2.0, 6.0, omega)
    constant = mean_added_resistance(np.full(500, 300.0), sea, omega)
    assert constant == pytest.approx(2 * 300.0 * np.trapezoid(sea, omega))
    double = mean_added_resistance(np.full(500, 300.0), two_parameter_spectrum(4.0, 6.0, omega), omega)
    assert double == pytest.approx(4 * constant)
    unit = 1000 * GRAVITY * 4.0**2 / 70.0
    assert mean_from_coefficient(np.ones(500), sea, omega, 1000.0, 4.0, 70.0) == pytest.approx(
        mean_added_resistance(np.full(500, unit), sea, omega)
    )
    with pytest.raises(InputError, match="increase"):
        mean_added_resistance(np.ones(500), sea, omega[::-1])


def test_form_is_checked():
    with pytest.raises(InputError, match="form must be"):
        added_resistance(*made_ship(), "maruo")
