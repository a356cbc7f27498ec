"""Wagner's pressure on fitted fronts: closed forms of force and impulse, panel averages, and the pitfall of centres."""

import numpy as np
import pytest
from scipy.integrate import quad

from workbench import quantities
from workbench.errors import InputError
from workbench.verification.spreading_plate import (
    DENSITY,
    IMPULSE,
    SPEED,
    VELOCITY,
    pitfall,
    spreading_slam,
)
from workbench.wet_deck_pressure.fitted_pressure import (
    average_pressure,
    centre_pressure,
    impulse_convergence,
    slam_pressure,
    spreading_impulse,
)


@pytest.mark.parametrize(("near", "far"), [(0.0, 0.2), (0.3, 0.5), (0.6, 1.0), (0.8, 1.3), (1.1, 1.2)])
def test_average_is_the_integral_of_the_pressure(near, far):
    length, rate = 1.0, 7.0
    average = average_pressure(near, far, length, rate, VELOCITY, DENSITY)
    edge = min(far, length)
    total = 0.0
    if near < edge:  # with x = c sin(angle) the root goes away
        total, _ = quad(
            lambda angle: (
                centre_pressure(length * np.sin(angle), length, rate, VELOCITY, DENSITY)
                * length
                * np.cos(angle)
            ),
            np.arcsin(near),
            np.arcsin(edge) * (1 - 1e-9),
        )
    assert float(average) == pytest.approx(total / (far - near), rel=1e-6, abs=1e-9)


def test_a_whole_side_has_half_pi_rho_v_c_rate():
    assert float(average_pressure(0.0, 0.3, 0.3, SPEED, VELOCITY, DENSITY)) * 0.3 == pytest.approx(
        np.pi / 2 * DENSITY * VELOCITY * 0.3 * SPEED
    )
    assert float(average_pressure(0.0, 0.3, 0.0, SPEED, VELOCITY, DENSITY)) == 0.0
    assert float(centre_pressure(0.0, 0.3, SPEED, VELOCITY, DENSITY)) == pytest.approx(
        DENSITY * VELOCITY * SPEED
    )


@pytest.mark.parametrize("sides", [1, 2])
@pytest.mark.parametrize("steps", [2, 10, 1000])
def test_impulse_of_a_spreading_plate_is_closed_form(sides, steps):
    found = slam_pressure(spreading_slam(sides=sides, breadth=2.0), DENSITY, steps=steps)
    length = float(found.wetted_length_fore[-1])
    expected = 2.0 * sides * spreading_impulse(DENSITY, VELOCITY, length)
    assert float(found.running_impulse[-1]) == pytest.approx(expected, rel=1e-9)
    force = 2.0 * sides * np.pi / 2 * DENSITY * VELOCITY * length * SPEED
    assert float(found.deck_force[-1]) == pytest.approx(force, rel=1e-9)
    np.testing.assert_allclose(found.deck_force, found.deck_pressure @ found.area)
    assert float(found.deck_force[0]) == 0.0


def test_a_front_that_slows_down_has_the_impulse_of_its_length():
    slam = spreading_slam(curvature=0.5, panels=400)
    found = slam_pressure(slam, DENSITY, fit="quadratic")
    length = float(found.wetted_length_fore[-1])
    closed = 2 * spreading_impulse(DENSITY, VELOCITY, length)
    assert float(found.running_impulse[-1]) == pytest.approx(closed, rel=1e-5)
    straight = slam_pressure(slam, DENSITY, fit="linear")
    early = 300
    assert float(straight.wetted_length_fore[early]) < float(found.wetted_length_fore[early])


def test_contact_within_a_panel_divides_it_between_the_sides():
    step = 0.002
    slam = spreading_slam(panels=30, length=30 * step)
    moved = slam.assign(
        event_x=slam.event_x - step / 2,
        panel_aft=slam.panel_aft - step / 2,
        panel_fore=slam.panel_fore - step / 2,
    )
    moved["time_since_contact"] = np.abs(moved.event_x) / SPEED
    found = slam_pressure(moved, DENSITY)
    early = 200  # both fronts are still on panels
    length = float(found.wetted_length_fore[early])
    assert length == pytest.approx(float(found.wetted_length_aft[early]), rel=1e-9)
    assert float(found.deck_force[early]) == pytest.approx(
        np.pi * DENSITY * VELOCITY * length * SPEED, rel=1e-9
    )


def test_pressure_comes_with_the_front():
    found = slam_pressure(spreading_slam(panels=20), DENSITY, steps=400)
    wet = found.deck_pressure.values > 0
    inner = np.abs(found.point_x.values) - 0.0015
    for side, chosen in (("fore", found.point_x.values > 0), ("aft", found.point_x.values < 0)):
        front = found[f"wetted_length_{side}"].values[:, None]
        np.testing.assert_array_equal(wet[:, chosen], front > inner[chosen] + 1e-12)


def test_variants_of_the_source_differ_in_what_they_vary():
    slam = spreading_slam(curvature=0.4, panels=40)
    slam["entry_velocity"] = VELOCITY * (1 + 3 * slam.event_x)
    made = {
        (fit, velocity): slam_pressure(slam, DENSITY, fit=fit, velocity=velocity, steps=200)
        for fit in ("linear", "quadratic", "cubic")
        for velocity in ("mean", "cubic")
    }
    for (fit, velocity), found in made.items():
        assert f"{fit} front, {velocity} impact velocity" in found.attrs["method"]
        fore = found.deck_pressure.values[-1, found.point_x.values > 0].sum()
        aft = found.deck_pressure.values[-1, found.point_x.values < 0].sum()
        assert fore > 1.1 * aft if velocity == "cubic" else fore == pytest.approx(aft)
    np.testing.assert_allclose(
        made["cubic", "mean"].running_impulse[-1], made["quadratic", "mean"].running_impulse[-1], rtol=1e-6
    )
    assert float(made["linear", "mean"].running_impulse[-1]) > 1.1 * float(
        made["quadratic", "mean"].running_impulse[-1]
    )


def test_averages_converge_where_centres_do_not():
    slam = spreading_slam()
    steps = (50, 100, 200, 1000)
    average = impulse_convergence(slam, DENSITY, steps).slam_impulse.values
    centre = impulse_convergence(slam, DENSITY, steps, form="panel centre").slam_impulse.values
    np.testing.assert_allclose(average, average[-1], rtol=1e-9)
    assert np.ptp(centre) > 1e-3 * average[-1]


def test_centres_have_the_pressure_of_their_own_side():
    slam = spreading_slam(panels=20)
    slam["time_since_contact"] = slam.time_since_contact * np.where(slam.event_x.values < 0, 2.0, 1.0)
    found = slam_pressure(slam, DENSITY, form="panel centre", steps=100)
    time = float(found.time[61])
    speed = np.where(found.point_x.values < 0, SPEED / 2, SPEED)
    expected = centre_pressure(np.abs(found.point_x.values), speed * time, speed, VELOCITY, DENSITY)
    np.testing.assert_allclose(found.deck_pressure.values[61], expected, rtol=1e-6)


def test_a_front_on_a_panel_centre_ruins_the_sum():
    assert pitfall(1000) == pytest.approx(IMPULSE, rel=0.02)
    assert pitfall(2000) > 1000 * IMPULSE
    assert pitfall(2000, "panel average") == pytest.approx(IMPULSE, rel=1e-3)


def test_limits_are_said():
    slam = spreading_slam()
    for steep in (slam, slam.assign(entry_angle=-slam.entry_angle)):
        assert "5 degrees" not in slam_pressure(steep, DENSITY).attrs["warnings"]
    flat = slam.assign(entry_angle=("event", np.full(slam.sizes["event"], -0.05)))
    notes = quantities.warnings_of(slam_pressure(flat, DENSITY))
    assert any("2.9 degrees at least: below 5 degrees" in note for note in notes)
    assert any("without the pile-up" in note for note in notes)


@pytest.mark.parametrize(
    "given", [{"density": 0.0}, {"fit": "none"}, {"velocity": "peak"}, {"form": "corner"}, {"steps": 1}]
)
def test_bad_choices_are_refused(given):
    with pytest.raises(InputError):
        slam_pressure(spreading_slam(), **{"density": DENSITY, **given})
