"""Damping by sails: the numbers of the formulas, their signs, and the printed forms."""

import numpy as np
import pytest

from workbench.conventions import MODES
from workbench.damping.additions import additions
from workbench.damping.sail_damping import (
    SailDampingSettings,
    closed_form,
    derivative,
    root_mean_square,
    sail_damping,
)
from workbench.errors import InputError
from workbench.hulls import library
from workbench.sails import SailPlan, TrueWind, tapered_sail_plan

PLAN = tapered_sail_plan(4 * (1 - 1 / 25), 4 * (1 - 20 / 25), 1.0, 20.0, 1.2)
WIND = TrueWind(speed=8.0, direction=np.radians(135.0))  # from 45 degrees off the starboard bow
BOAT = 5.14444
ALONG, ACROSS = WIND.apparent(BOAT, 0.0)


def force(across_velocity, along_velocity, tack=1.0):
    """Moments (roll, pitch) from a force at right angles to the apparent wind, by a sum over many strips."""
    heights = np.linspace(1.0, 20.0, 20001)
    chords = 4 * (1 - heights / 25)
    wind = np.stack(  # of the air against the sail, x forward, y to port
        [-(ALONG + along_velocity * heights), tack * ACROSS + across_velocity * heights, 0 * heights], axis=1
    )
    speed = np.linalg.norm(wind, axis=1)
    lift = np.cross(wind / speed[:, None], [0.0, 0.0, 1.0]) * tack  # to leeward and forward
    per_height = (0.5 * 1.225 * 1.2 * chords * speed**2)[:, None] * lift
    arms = np.stack([0 * heights, 0 * heights, heights], axis=1)
    moments = np.cross(arms, per_height)
    return np.trapezoid(moments, heights, axis=0)[:2]


def test_closed_form_gives_the_numbers_of_the_formulas():
    """Worked case of Grande 2002, 2.33-2.50, repaired: 8 m/s from 45 degrees, 10 knots, chord 4 (1 - z/25)."""
    assert ALONG == pytest.approx(8 * np.cos(np.pi / 4) + BOAT)
    found = closed_form(PLAN, ALONG, ACROSS)
    np.testing.assert_allclose(found, [[15710.37, 68223.14], [46453.33, 15710.37]], rtol=1e-6)


def test_closed_form_is_the_limit_of_the_root_mean_square():
    exact = closed_form(PLAN, ALONG, ACROSS)
    np.testing.assert_allclose(root_mean_square(PLAN, ALONG, ACROSS, 1e-4, 2.0), exact, rtol=1e-7)
    wide = root_mean_square(PLAN, ALONG, ACROSS, 0.05, 2.0)
    np.testing.assert_allclose(wide, exact, rtol=3.5e-3)
    assert np.abs(wide / exact - 1).max() > 1e-4


def test_root_mean_square_is_that_of_the_moments_themselves():
    """The same from the moments of forces at right angles to the apparent wind, by many strips and instants."""
    phase = np.linspace(0.0, 2 * np.pi, 200, endpoint=False)
    rate = 0.05 * 2.0
    for column, which in enumerate(((1.0, 0.0), (0.0, 1.0))):
        moments = np.array([force(rate * which[0] * s, rate * which[1] * s) for s in np.sin(phase)])
        swing = moments - moments.mean(axis=0)
        expected = np.sqrt(2 * np.mean(swing**2, axis=0)) / rate
        found = root_mean_square(PLAN, ALONG, ACROSS, 0.05, 2.0)[:, column]
        np.testing.assert_allclose(found, expected, rtol=1e-6)


@pytest.mark.parametrize("tack", [1.0, -1.0])
def test_signs_are_those_of_forces_at_right_angles_to_the_apparent_wind(tack):
    """Roll is damped, pitch is fed, and the couplings change sign with the tack."""
    step = 1e-4
    expected = -np.stack(
        [
            (force(step, 0, tack) - force(-step, 0, tack)) / (2 * step),
            (force(0, step, tack) - force(0, -step, tack)) / (2 * step),
        ],
        axis=1,
    )
    found = derivative(PLAN, ALONG, tack * ACROSS)
    np.testing.assert_allclose(found, expected, rtol=1e-6)
    assert found[0, 0] > 0 > found[1, 1]
    assert np.sign(found[0, 1]) == tack == -np.sign(found[1, 0])


def test_neither_matrix_takes_energy_out_of_every_motion():
    v = np.hypot(ALONG, ACROSS)
    q = 0.5 * 1.225 * 1.2 * PLAN.moment(2)
    positive = closed_form(PLAN, ALONG, ACROSS)
    least = np.linalg.eigvalsh((positive + positive.T) / 2).min()
    assert least == pytest.approx(q * (ALONG * ACROSS - 1.5 * v**2) / v)
    signed = derivative(PLAN, ALONG, ACROSS)
    assert least < 0 > np.linalg.eigvalsh((signed + signed.T) / 2).min()


def test_printed_forms_grow_without_limit_or_with_frequency():
    with_mean = [
        root_mean_square(PLAN, ALONG, ACROSS, amplitude, 2.0, mean_moment=True) for amplitude in (1e-3, 1e-4)
    ]
    np.testing.assert_allclose(with_mean[1] / with_mean[0], 10.0, rtol=1e-3)
    by_amplitude = root_mean_square(PLAN, ALONG, ACROSS, 0.05, 2.0, divisor="amplitude")
    np.testing.assert_allclose(by_amplitude, 2.0 * root_mean_square(PLAN, ALONG, ACROSS, 0.05, 2.0))


def test_moments_of_a_plan_are_exact():
    assert PLAN.area == pytest.approx(4 * (19 - (400 - 1) / 50))
    assert PLAN.moment(2) == pytest.approx(4 * ((20**3 - 1) / 3 - (20**4 - 1) / 100), rel=1e-12)
    low = SailPlan(heights=(1.0, 3.0), chords=(2.0, 2.0), lift_coefficient=1.0)
    assert low.centre_height == pytest.approx(2.0)
    assert low.scaled(2.0).area == pytest.approx(4 * low.area)


def test_damping_stands_at_roll_and_pitch_for_every_wave():
    found = sail_damping(PLAN, WIND, BOAT, [0.5, 1.0], [np.pi, 2.0, 1.0])
    assert found.damping.dims == ("omega", "wave_direction", "influenced_dof", "radiating_dof")
    values = found.damping.values
    np.testing.assert_allclose(values[1, 2][3:5, 3:5], closed_form(PLAN, ALONG, ACROSS))
    assert list(found.influenced_dof.values) == list(MODES)
    values[..., 3:5, 3:5] = 0.0
    assert not values.any()
    assert "root mean square of the source" in found.attrs["warnings"]


def test_wind_without_a_direction_goes_with_the_waves():
    """Out of beam waves, and none where the apparent wind comes from abaft the beam."""
    found = sail_damping(PLAN, TrueWind(speed=8.0), BOAT, [1.0], [np.pi / 2, np.pi, 0.0])
    np.testing.assert_allclose(found.damping.values[0, 0, 3:5, 3:5], closed_form(PLAN, BOAT, 8.0))
    assert found.damping.values[0, 1, 3, 3] == pytest.approx(0.0, abs=1e-6)
    assert not found.damping.values[0, 2].any()
    assert "abaft the beam" in found.attrs["warnings"]
    assert "would luff" in found.attrs["warnings"]


def test_root_mean_square_follows_the_encounter_frequency():
    settings = SailDampingSettings(method="root-mean-square", amplitude=0.1, divisor="amplitude")
    found = sail_damping(PLAN, WIND, 0.0, [0.5, 1.0], [np.pi], settings)
    for i, omega in enumerate((0.5, 1.0)):
        expected = root_mean_square(PLAN, *WIND.apparent(0.0, 0.0), 0.1, omega, divisor="amplitude")
        np.testing.assert_allclose(found.damping.values[i, 0, 3:5, 3:5], expected)
    assert "not a damping" in found.attrs["warnings"]
    at_rest = root_mean_square(PLAN, ALONG, ACROSS, 0.05, 0.0)
    np.testing.assert_allclose(at_rest, closed_form(PLAN, ALONG, ACROSS), rtol=1e-6)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: SailDampingSettings(method="guess"), "method of sail damping must be one of"),
        (
            lambda: SailDampingSettings(method="root-mean-square", sign="derivative"),
            "which has no sign",
        ),
        (lambda: SailDampingSettings(mean_moment=True), "belong to the root mean square"),
        (lambda: SailDampingSettings(method="root-mean-square", mean_moment=1), "mean_moment must be"),
        (lambda: SailDampingSettings(amplitude=0.0), "amplitude of sail damping must be"),
        (lambda: TrueWind(speed=-1.0), "wind speed must be"),
        (lambda: SailPlan(heights=(1, 2), chords=(1,), lift_coefficient=1), "must be as many"),
        (lambda: SailPlan(heights=(2, 1), chords=(1, 1), lift_coefficient=1), "must rise"),
        (lambda: SailPlan(heights=(1, 2), chords=(0, 0), lift_coefficient=1), "must not all be 0"),
        (lambda: SailPlan(heights=3.0, chords=(0, 0), lift_coefficient=1), "must be a list"),
        (lambda: SailPlan(heights=(1, 2), chords=(1, 1), lift_coefficient=0), "lift coefficient of the"),
        (
            lambda: additions(
                library.design("delft-372"),
                sail_damping(PLAN, WIND, 1.0, [1.0], [3.0]).assign_attrs(density=1000.0),
                wind=WIND,
            ),
            "has no sail plan",
        ),
    ],
)
def test_what_cannot_be_is_refused_with_one_sentence(make, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        make()
    assert "\n" not in str(caught.value)


def test_designs_of_the_library_carry_the_published_sail_area():
    for name in ("catamaran-35", "trimaran-35"):
        assert library.design(name).sail_plan.area == pytest.approx(577.0)
    assert library.design("crowther-318").sail_plan.area == pytest.approx(130.0, rel=0.01)
