"""Fitted fronts give back the polynomials they were made of, and say where they cannot."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.verification.spreading_plate import spreading_slam
from workbench.wet_deck_pressure.fitted_front import Front, fitted_front, fitted_fronts, impact_velocity


@pytest.mark.parametrize(
    ("degree", "coefficients"),
    [("linear", [5.0]), ("quadratic", [5.0, -60.0]), ("cubic", [5.0, -60.0, 900.0])],
)
def test_polynomials_come_back_and_start_at_nothing(degree, coefficients):
    time = np.linspace(0.001, 0.02, 15)
    distance = np.power.outer(time, np.arange(1, len(coefficients) + 1)) @ coefficients
    found = fitted_front(time, distance, degree)
    np.testing.assert_allclose(found, coefficients, rtol=1e-9)
    front = Front(tuple(found))
    assert float(front.length(0.0)) == 0.0
    middle, step = 0.01, 1e-6
    slope = (front.length(middle + step) - front.length(middle - step)) / (2 * step)
    assert float(front.rate(middle)) == pytest.approx(float(slope), rel=1e-6)


def test_the_fit_is_that_of_least_squares_through_first_contact():
    time, distance = np.array([0.1, 0.2, 0.4]), np.array([1.0, 1.0, 3.0])
    assert fitted_front(time, distance, "linear")[0] == pytest.approx((time @ distance) / (time @ time))


@pytest.mark.parametrize("degree", ["linear", "quadratic", "cubic"])
def test_both_sides_have_a_front_of_their_own(degree):
    slam = spreading_slam(speed=5.0, length=0.06, panels=30)
    slower = slam.event_x.values < 0
    slam["time_since_contact"] = slam.time_since_contact * np.where(slower, 2.0, 1.0)
    fronts = fitted_fronts(slam, degree)
    assert fronts.fore.coefficients[0] == pytest.approx(5.0)
    assert fronts.aft.coefficients[0] == pytest.approx(2.5)
    np.testing.assert_allclose([*fronts.fore.coefficients[1:], *fronts.aft.coefficients[1:]], 0.0, atol=1e-4)
    assert fronts.duration == pytest.approx(2 * (0.06 - 0.001) / 5)
    assert fronts.fore.reach == pytest.approx(0.06)
    assert fronts.fore.residual < 1e-12


def test_a_fit_that_would_shrink_keeps_its_length():
    front = Front((1.0, -1.0))
    times = np.array([0.0, 0.5, 0.8])
    np.testing.assert_allclose(front.length(times), [0.0, 0.25, 0.25])
    np.testing.assert_allclose(front.rate(times), [1.0, 0.0, 0.0])


def test_a_side_with_few_instants_takes_a_lower_degree_and_says_so():
    slam = spreading_slam(panels=30)
    fore = np.flatnonzero(slam.event_x.values > 0)[:2]
    kept = slam.isel(event=np.sort(np.concatenate([fore, np.flatnonzero(slam.event_x.values < 0)])))
    fronts = fitted_fronts(kept, "cubic")
    assert [len(fronts.fore.coefficients), len(fronts.aft.coefficients)] == [2, 3]
    assert any(
        "fore front has 2 instants only: its fit is quadratic, not cubic" in note for note in fronts.notes
    )
    alone = fitted_fronts(spreading_slam(sides=1), "quadratic")
    assert alone.aft.coefficients == ()


def test_a_front_beyond_its_panels_is_warned_of():
    slam = spreading_slam(panels=30)
    short = slam.isel(event=np.flatnonzero(slam.event_x.values > -0.03))
    notes = fitted_fronts(short, "linear").notes
    assert len(notes) == 1
    assert "aft front ends 0.059 m" in notes[0]
    assert not fitted_fronts(slam, "linear").notes


def test_impact_velocity_is_the_mean_or_a_cubic_along_the_ship():
    slam = spreading_slam(panels=20)
    x = slam.event_x.values
    cubic = 1.0 + 4 * x - 30 * x**2 + 200 * x**3
    slam["entry_velocity"] = ("event", cubic)
    np.testing.assert_allclose(impact_velocity(slam, "mean"), cubic.mean())
    np.testing.assert_allclose(impact_velocity(slam, "cubic"), cubic, rtol=1e-9)
    slam["entry_velocity"] = ("event", np.where(np.abs(x) > 0.05, -1.0, 1.0))
    assert impact_velocity(slam, "cubic").min() == 0.0


def test_what_cannot_be_fitted_is_refused():
    slam = spreading_slam()
    at_once = slam.assign(time_since_contact=("event", np.zeros(slam.sizes["event"])))
    with pytest.raises(InputError, match="one after another"):
        fitted_fronts(at_once)
    with pytest.raises(InputError, match="2 or more distinct instants"):
        fitted_front([0.0, 0.1, 0.1], [0.0, 1.0, 2.0], "quadratic")
    with pytest.raises(InputError, match="fit of the wetted length"):
        fitted_fronts(slam, "quartic")
    with pytest.raises(InputError, match="impact velocity"):
        impact_velocity(slam, "largest")
