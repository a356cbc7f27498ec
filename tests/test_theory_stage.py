"""Theories behind one call: usual headings, headings side by side, long waves, lost stiffness."""

import numpy as np
import pytest

from workbench import designs, pipeline, theory_stage
from workbench.conventions import GRAVITY, encounter_frequency
from workbench.errors import InputError
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.quantities import warnings_of

SHIP = designs.named_design("delft-372")
MARCH = HighSpeedSettings(stations=40, panels=12)
STRIPS = StripSettings(stations=15, panels=16, interaction="off")
MIXED = RecommendedSettings(quick=True, strip=STRIPS, high_speed=MARCH)
SPEED = 0.5 * np.sqrt(GRAVITY * SHIP.hull.length)
OMEGA = [2.5, 3.5, 4.5]
NAMES = ("added_mass", "radiation_damping", "froude_krylov_force", "diffraction_force", "encounter_frequency")


def found(settings, degrees, omega=OMEGA):
    return theory_stage.hydrodynamics(
        SHIP.hull,
        SHIP.density,
        SPEED,
        np.radians(degrees),
        omega,
        settings,
        workers=1,
        progress=pipeline.silent,
    )[0]


def test_mixed_headings_keep_their_order_and_their_theory():
    degrees = [0.0, 180.0, 20.0, 135.0]
    together = found(MIXED, degrees)
    np.testing.assert_allclose(np.degrees(together.wave_direction), degrees)
    for column, angle in enumerate(degrees):
        alone = found(MARCH if angle > 90 else STRIPS, [angle])
        for name in NAMES:
            known = alone[name].values[:, 0]
            np.testing.assert_allclose(
                together[name].values[:, column], known, rtol=1e-9, atol=1e-12 * np.abs(known).max()
            )
        correction = together.stiffness_correction.values[column]
        assert correction.any() == (angle > 90)
    assert together.attrs["method"] == "strip and high-speed"
    assert together.attrs["recommendation"].endswith("strip theory and high-speed theory, by heading.")
    assert len(warnings_of(together)) == len(set(warnings_of(together)))


def test_one_theory_alone_says_so():
    head = found(MIXED, [180.0])
    assert head.attrs["method"] == "high-speed"
    assert head.attrs["recommendation"] == "Recommended at Fn 0.50: high-speed theory."


def test_motions_take_the_stiffness_of_their_own_heading():
    mixed = pipeline.response(SHIP, SPEED, np.radians([0.0, 180.0]), OMEGA, MIXED).motions.motion_rao.values
    for column, (angle, settings) in enumerate(((0.0, STRIPS), (180.0, MARCH))):
        alone = pipeline.response(SHIP, SPEED, np.radians([angle]), OMEGA, settings).motions.motion_rao.values
        np.testing.assert_allclose(mixed[:, column, 2:5:2], alone[:, 0, 2:5:2], rtol=1e-6)
    kept = pipeline.response(
        SHIP, SPEED, [np.pi], OMEGA, HighSpeedSettings(stations=40, panels=12, transom="none")
    )
    lost = pipeline.response(SHIP, SPEED, [np.pi], OMEGA, MARCH)
    assert not kept.hydrodynamics.stiffness_correction.values.any()
    assert lost.hydrodynamics.stiffness_correction.values[0, 2, 2] < 0


def test_long_waves_carry_the_ship():
    """Heave of one, pitch of the slope, where speed and transom no longer matter."""
    omega = np.array([0.25])
    settings = HighSpeedSettings(stations=40, panels=12, transom="none")
    moved = pipeline.response(SHIP, SPEED, [np.pi], omega, settings).motions
    heave, pitch = (np.abs(moved.motion_rao.values[0, 0, mode]) for mode in (2, 4))
    assert heave == pytest.approx(1.0, abs=0.03)
    assert pitch / moved.wavenumber.values[0] == pytest.approx(1.0, abs=0.06)


def test_results_are_not_shared():
    first = found(MARCH, [180.0])
    first.added_mass.values[:] = 0.0
    assert found(MARCH, [180.0]).added_mass.values.any()


def test_usual_headings_are_those_that_the_theory_can_do():
    assert len(theory_stage.directions_for(STRIPS, 3.0, SPEED)) == 24
    assert len(theory_stage.directions_for(MIXED, 3.0, SPEED)) == 24
    march = theory_stage.directions_for(MARCH, 3.0, SPEED)
    assert len(march) < 24
    shortest = theory_stage.wave_frequencies(3.0).max()
    assert np.all(encounter_frequency(shortest, SPEED, march) > 0)
    left_out = np.setdiff1d(theory_stage.USUAL_DIRECTIONS, march)
    assert np.cos(left_out).min() > np.cos(march).max()


@pytest.mark.parametrize("omega", [[], [1.0, np.nan], [-1.0], [2.0, 1.0], [[1.0]]])
def test_frequencies_that_are_none_are_refused(omega):
    with pytest.raises(InputError, match="omega"):
        found(MARCH, [180.0], omega)
