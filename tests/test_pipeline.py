"""The stages in order: what depends on what, and what is refused or warned of."""

from dataclasses import replace

import numpy as np
import pytest

from workbench import animation, pipeline, quantities, radiation_store, sea_energy
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.hydrodynamics import radiation
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.impact.pressure import PressureLaw
from workbench.seas import Condition, SeaState
from workbench.time_domain import Realisation

SEA = SeaState(significant_wave_height=2.5, peak_period=7.0)
COARSE = PotentialFlowSettings(panels=300)


@pytest.fixture(scope="module")
def ship(twin):
    return pipeline.response(twin, 0.0, np.radians([180.0, 150.0, 210.0]), None, COARSE)


@pytest.fixture(scope="module")
def relative(ship, twin):
    return pipeline.deck_response(ship, twin.wet_deck, (12, 5))


def condition(degrees=180.0, **sea):
    return Condition(speed=0.0, wave_direction=np.radians(degrees), sea_state=replace(SEA, **sea))


def test_changes_of_deck_masses_and_sea_solve_nothing_again(ship, twin, monkeypatch):
    monkeypatch.setattr(radiation, "frequency_solution", None)
    higher = replace(twin, wet_deck=replace(twin.wet_deck, clearance=2.0))
    heavier = replace(higher, masses=replace(twin.masses, pitch_gyradius=11.0))
    again = pipeline.response(heavier, 0.0, ship.motions.wave_direction.values, None, COARSE)
    relative = pipeline.deck_response(again, heavier.wet_deck, (12, 5))
    low = pipeline.slamming(ship, relative, twin.wet_deck, condition())
    high = pipeline.slamming(again, relative, heavier.wet_deck, condition())
    assert float(high.statistics.slams_per_hour.max()) < float(low.statistics.slams_per_hour.max())
    assert not np.allclose(again.motions.motion_rao, ship.motions.motion_rao)


def test_another_spacing_at_speed_solves_nothing_again(twin, monkeypatch):
    speed = 0.4 * np.sqrt(GRAVITY * 40.0)
    pipeline.response(twin, speed, [np.pi], None, COARSE)
    monkeypatch.setattr(radiation, "frequency_solution", None)
    wider = replace(twin, hull=replace(twin.hull, spacing=12.0))
    assert pipeline.response(wider, speed, [np.pi], None, COARSE).speed == speed


def test_waves_from_either_side_are_mirror_images(ship, relative):
    port, starboard = relative.isel(wave_direction=1), relative.isel(wave_direction=2)
    np.testing.assert_allclose(
        np.abs(port.relative_motion.values), np.abs(starboard.relative_motion.values[..., ::-1]), atol=1e-6
    )
    rolls = ship.motions.motion_rao.sel(dof="roll").values
    np.testing.assert_allclose(rolls[:, 1], -rolls[:, 2], atol=1e-9)


def test_scattered_waves_under_the_deck_are_in_at_rest_and_can_be_left_out(ship, twin, relative):
    assert relative.attrs["waves"] == "incident, diffracted and radiated"
    alone = pipeline.response(twin, 0.0, [np.pi], None, replace(COARSE, wave_field="incident"))
    plain = pipeline.deck_response(alone, twin.wet_deck, (12, 5))
    assert plain.attrs["waves"] == "incident"
    both = relative.relative_motion.values[:, 0], plain.relative_motion.values[:, 0]
    assert np.abs(both[0] - both[1]).max() > 0.1
    assert np.abs(both[0] - both[1])[0].max() < 0.01  # long waves are not disturbed


def test_counted_and_closed_form_agree_over_the_deck(ship, twin, relative):
    slam = pipeline.slamming(ship, relative, twin.wet_deck, condition())
    events, counts = pipeline.counted_slams(ship, relative, slam, Realisation(seed=2, hours=2.0))
    rate = slam.statistics.slams_per_hour
    inside = (counts.counted_band_low <= rate) & (rate <= counts.counted_band_high)
    assert float(inside.mean()) > 0.95
    assert float(events.event_time.max()) <= 7200
    row, column = slam.worst_point["x"], slam.worst_point["y"]
    at_worst = (events.event_x == float(relative.x[row])) & (events.event_y == float(relative.y[column]))
    assert int(at_worst.sum()) == round(2 * float(counts.counted_per_hour[row, column]))
    again, _ = pipeline.counted_slams(ship, relative, slam, Realisation(seed=2, hours=2.0))
    np.testing.assert_array_equal(events.event_time, again.event_time)


def test_short_crested_seas_share_the_energy_over_the_headings(twin):
    spread = Condition(speed=0.0, wave_direction=np.pi, sea_state=replace(SEA, spreading_exponent=2))
    found = pipeline.response(twin, 0.0, sea_energy.directions_for(spread), None, COARSE)
    relative = pipeline.deck_response(found, twin.wet_deck, (8, 3))
    short = pipeline.slamming(found, relative, twin.wet_deck, spread)
    long = pipeline.slamming(found, relative, twin.wet_deck, condition())
    assert float(short.motion_statistics.motion_std.sel(dof="roll")) > 1e-4
    assert float(long.motion_statistics.motion_std.sel(dof="roll")) < 1e-9
    assert float(short.motion_statistics.motion_std.sel(dof="pitch")) < float(
        long.motion_statistics.motion_std.sel(dof="pitch")
    )
    _, counts = pipeline.counted_slams(found, relative, short, Realisation(seed=1, components=800))
    worst = short.worst_point
    here = counts.isel(worst)
    rate = float(short.statistics.slams_per_hour.isel(worst))
    assert float(here.counted_band_low) <= rate <= float(here.counted_band_high)


def test_pressure_laws_take_the_velocity_they_need(ship, twin, relative):
    for law, kind in ((PressureLaw(), "time-derivative"), (PressureLaw(name="wagner"), "material")):
        slam = pipeline.slamming(ship, relative, twin.wet_deck, condition(), law=law)
        assert slam.statistics.attrs["velocity"] == kind
        assert any("pressure" in line for line in quantities.warnings_of(slam.statistics))


def test_own_waves_of_the_ship_lower_the_deck(ship, twin, relative):
    plain = pipeline.slamming(ship, relative, twin.wet_deck, condition())
    risen = pipeline.slamming(ship, relative, twin.wet_deck, condition(), steady_elevation=0.2)
    lower = replace(twin.wet_deck, clearance=twin.wet_deck.clearance - 0.2)
    lowered = pipeline.slamming(ship, relative, lower, condition())
    np.testing.assert_allclose(risen.statistics.slams_per_hour, lowered.statistics.slams_per_hour)
    assert float(risen.statistics.slams_per_hour.max()) > float(plain.statistics.slams_per_hour.max())
    assert risen.least_clearance == pytest.approx(plain.least_clearance + 0.2)
    with pytest.raises(InputError, match="steady_elevation"):
        pipeline.slamming(ship, relative, twin.wet_deck, condition(), steady_elevation=5.0)


def test_animation_holds_what_was_counted(ship, twin, relative):
    slam = pipeline.slamming(ship, relative, twin.wet_deck, condition())
    realisation = Realisation(seed=4)
    events, _ = pipeline.counted_slams(ship, relative, slam, realisation)
    scene = animation.animation_scene(ship, relative, slam, events, realisation, frames=120)
    assert scene.sizes["time"] == 120
    assert scene.sizes["event"] > 0
    assert float(scene.clearance_left.min()) < 0 < float(scene.pressure.max())
    np.testing.assert_allclose(
        scene.clearance_left + scene.relative_motion_history, scene.deck_height.values[None] + 0 * scene.clearance_left,
        atol=1e-5,
    )  # fmt: skip
    assert float(np.abs(scene.elevation).max()) < 2 * SEA.significant_wave_height
    shown, all_of_them = scene.event_time.values, events.event_time.values
    first = [i for i in range(len(all_of_them) - len(shown) + 1)
             if np.allclose(np.diff(all_of_them[i : i + len(shown)]), np.diff(shown), atol=1e-6)]  # fmt: skip
    hardest = int(np.argmax(events.peak_pressure.values))
    assert any(i <= hardest < i + len(shown) for i in first)


def test_usual_headings_leave_out_what_the_ship_overtakes():
    at_rest = radiation_store.usual_directions(40.0, 0.0)
    fast = radiation_store.usual_directions(40.0, 12.0)
    assert len(at_rest) == 24
    assert np.cos(fast).max() < 0.1
    assert np.any(np.isclose(fast, np.pi))


def test_heeled_and_trimmed_ships_are_solved_whole(twin):
    heeled = replace(twin, hull=replace(twin.hull, heel=np.radians(2.0), trim=np.radians(0.5)))
    found = pipeline.response(heeled, 0.0, [np.pi], [0.9], PotentialFlowSettings(panels=200))
    roll = np.abs(found.motions.motion_rao.sel(dof="roll").values)
    assert roll.max() > 1e-4  # an asymmetric ship rolls in head seas
    upright = pipeline.response(twin, 0.0, [np.pi], [0.9], PotentialFlowSettings(panels=200))
    assert np.abs(upright.motions.motion_rao.sel(dof="roll").values).max() < 1e-9


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"omega": [0.5, 0.4]}, "increasing"),
        ({"omega": [np.nan]}, "finite"),
        ({"omega": [9.0]}, "panels"),
        ({"speed": -1.0}, "speed"),
        ({"speed": 10.0, "wave_directions": [0.0], "omega": [1.0]}, "overtakes"),
        ({"settings": replace(COARSE, wave_field="total"), "speed": 10.0}, "wave_field"),
    ],
)
def test_refusals(twin, arguments, words):
    given = {"speed": 0.0, "wave_directions": [np.pi], "omega": [0.6], "settings": COARSE, **arguments}
    with pytest.raises(InputError, match=words):
        pipeline.response(twin, **given)


def test_a_condition_must_be_the_computed_one(ship, twin, relative):
    with pytest.raises(InputError, match="compute that heading"):
        pipeline.slamming(ship, relative, twin.wet_deck, condition(120.0))
    other = Condition(speed=5.0, wave_direction=np.pi, sea_state=SEA)
    with pytest.raises(InputError, match="speed of the condition"):
        pipeline.slamming(ship, relative, twin.wet_deck, other)


def test_limits_travel_with_the_result(twin):
    fast = pipeline.response(twin, 12.0, [np.pi], None, COARSE)
    relative = pipeline.deck_response(fast, twin.wet_deck, (6, 3))
    moving = Condition(speed=12.0, wave_direction=np.pi, sea_state=SEA)
    notes = quantities.warnings_of(pipeline.slamming(fast, relative, twin.wet_deck, moving).statistics)
    assert any("rough guide" in line for line in notes)
    assert any("solved alone" in line for line in notes)
    assert any("incident wave" in line for line in notes)
    ripple = Condition(
        speed=12.0, wave_direction=np.pi, sea_state=SeaState(significant_wave_height=0.3, peak_period=2.0)
    )
    notes = quantities.warnings_of(pipeline.slamming(fast, relative, twin.wet_deck, ripple).statistics)
    assert any("of the energy of this sea" in line for line in notes)


def test_progress_is_told_and_can_cancel(twin):
    class Stopped(Exception):  # noqa: N818
        pass

    told = []

    def progress(fraction, message):
        told.append(fraction)
        if fraction > 0.4:
            raise Stopped

    with pytest.raises(Stopped):
        pipeline.response(twin, 0.0, [np.pi], np.linspace(0.5, 1.5, 7), COARSE, progress=progress)
    assert told == sorted(told)
    assert 0 < told[0] < 0.4 < told[-1]


def test_worker_processes_give_the_same(twin):
    omega = [0.77, 1.07]
    alone = pipeline.response(twin, 0.0, [np.pi], omega, replace(COARSE, panels=310))
    radiation_store._memo.clear()
    import os
    import tempfile

    with tempfile.TemporaryDirectory() as folder, pytest.MonkeyPatch.context() as patch:
        patch.setitem(os.environ, "WORKBENCH_CACHE_DIR", folder)
        shared = pipeline.response(twin, 0.0, [np.pi], omega, replace(COARSE, panels=310), workers=2)
    np.testing.assert_allclose(shared.motions.motion_rao, alone.motions.motion_rao)


def test_forward_speed_option_of_the_solver_is_offered_and_told_of(twin):
    """At low speed the two treatments of speed are near each other; the option takes the whole ship."""
    omega, speed = [0.7], 1.0
    settings = replace(COARSE, interaction="on")
    ours = pipeline.response(twin, speed, [np.pi], omega, settings)
    option = pipeline.response(
        twin, speed, [np.pi], omega, replace(settings, speed_treatment="forward-speed")
    )
    for mode in ("heave", "pitch"):
        first, second = (
            abs(complex(found.motions.motion_rao.sel(dof=mode)[0, 0])) for found in (ours, option)
        )
        assert second == pytest.approx(first, rel=0.1)
        assert second != first
    notes = quantities.warnings_of(option.motions)
    assert any("forward-speed option" in line for line in notes)
    assert not any("solved alone" in line for line in notes)


def test_limits_of_the_pressure_are_told_apart(ship, twin, relative):
    slam = pipeline.slamming(ship, relative, twin.wet_deck, condition())
    of_pressure = slam.statistics.attrs["pressure_warnings"].split("\n")
    assert any("Chuang" in line for line in of_pressure)
    assert set(of_pressure) < set(quantities.warnings_of(slam.statistics))
