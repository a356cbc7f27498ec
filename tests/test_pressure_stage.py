"""Pressure over the deck of a ship in a sea, from motions to slams, on the command line and in files."""

import json

import numpy as np
import pytest
import xarray as xr

from tests.test_cli import run
from workbench import animation, pipeline, pressure_stage, pressure_tables
from workbench.cache import load_dataset
from workbench.errors import InputError
from workbench.hulls import library
from workbench.seas import Condition, SeaState
from workbench.time_domain import Realisation
from workbench.wet_deck_pressure.settings import DeckPressureSettings

SEA = ("--hs", "0.12", "--tp", "1.6", "--froude", "0.3", "--hours", "0.02", "--deck-points", "24x4")


@pytest.fixture(scope="module")
def ship():
    design = library.design("austal-63")
    found = pipeline.response(design, 10.0, [np.pi])
    relative = pipeline.deck_response(found, design.wet_deck, (24, 4))
    sea = SeaState(significant_wave_height=3.0, peak_period=8.0)
    condition = Condition(speed=10.0, wave_direction=np.pi, sea_state=sea)
    return design, found, relative, pipeline.slamming(found, relative, design.wet_deck, condition)


def realised(ship, hours=0.05, **settings):
    design, found, relative, slam = ship
    return pressure_stage.RealisedDeck(
        found, relative, slam, design.wet_deck, Realisation(hours=hours), DeckPressureSettings(**settings)
    )


def test_every_counted_entry_lies_in_a_slam_and_panels_that_entered_were_pressed(ship):
    _, found, relative, slam = ship
    events, _ = pipeline.counted_slams(found, relative, slam, Realisation(hours=0.05))
    slams = pressure_stage.slam_pressures(realised(ship))
    starts, ends = slams.slam_start.values, (slams.slam_start + slams.slam_duration).values
    pressed = []
    for time, x, y in zip(
        events.event_time.values, events.event_x.values, events.event_y.values, strict=True
    ):
        inside = np.flatnonzero((starts <= time) & (time <= ends))
        assert inside.size
        pressed.append(float(slams.slam_panel_pressure.isel(slam=inside[0]).sel(x=x, y=y)) > 0)
    fast = events.entry_velocity.values > np.median(events.entry_velocity.values)
    assert np.all(
        np.array(pressed)[fast]
    )  # a slow entry late in a slam may find the suction of the water that leaves
    assert np.mean(pressed) > 0.9


def test_a_long_record_is_the_same_in_stretches(ship, monkeypatch):
    whole = pressure_stage.slam_pressures(realised(ship))
    monkeypatch.setattr(pressure_stage, "STRETCH", 40.0)
    monkeypatch.setattr(pressure_stage, "_RUN_ON", 20.0)
    told = []
    parts = pressure_stage.slam_pressures(realised(ship), lambda share, words: told.append(share))
    assert parts.sizes == whole.sizes
    np.testing.assert_allclose(parts.time, whole.time, atol=1e-9)
    np.testing.assert_allclose(parts.slam_start, whole.slam_start, atol=1e-9)
    np.testing.assert_allclose(parts.slam_impulse, whole.slam_impulse, rtol=1e-3)
    np.testing.assert_allclose(parts.pressure_envelope, whole.pressure_envelope, rtol=0.02, atol=100)
    assert parts.attrs["duration"] == pytest.approx(whole.attrs["duration"])
    assert told == sorted(told)
    assert told[-1] == pytest.approx(1.0)


def test_hardest_slam_in_time_is_the_one_of_the_record(ship):
    deck = realised(ship)
    slams = pressure_stage.slam_pressures(deck)
    rank = pressure_stage.hardest_slams(slams)
    assert float(slams.slam_pressure[rank[0]]) == float(slams.slam_pressure.max())
    by_force = pressure_stage.hardest_slams(slams, by="slam_force")
    assert float(slams.slam_force[by_force[0]]) == float(slams.slam_force.max())
    one = pressure_stage.hardest_slam(deck, slams)
    lifted = float(np.maximum(one.deck_force, 0).sum()) * one.attrs["time_step"]
    assert lifted == pytest.approx(float(slams.slam_impulse[rank[0]]), rel=0.02)
    with pytest.raises(InputError, match="slams are ranked by"):
        pressure_stage.hardest_slams(slams, by="size")


def test_results_say_what_they_are_of_and_how_far_they_hold(ship):
    slams = pressure_stage.slam_pressures(realised(ship))
    assert slams.attrs["design"] == "austal-63"
    assert slams.attrs["strips"] == "lengthwise"
    assert "flow in its own plane" in slams.attrs["warnings"]
    assert "slows the motions" in slams.attrs["warnings"]
    assert "Chuang" not in slams.attrs["warnings"]


def test_panels_low_beside_the_hulls_do_not_keep_a_slam_from_ending(ship):
    design, found, relative, _ = ship
    sea = SeaState(significant_wave_height=3.0, peak_period=8.0)
    condition = Condition(speed=10.0, wave_direction=np.pi, sea_state=sea)
    beside_the_hulls = xr.zeros_like(ship[3].deck.height)
    beside_the_hulls[:, [0, -1]] = 2.55  # the water stands 5 cm below the deck there
    slam = pipeline.slamming(found, relative, design.wet_deck, condition, steady_elevation=beside_the_hulls)
    deck = pressure_stage.RealisedDeck(found, relative, slam, design.wet_deck, Realisation(hours=0.05))
    slams = pressure_stage.slam_pressures(deck)
    usual = pressure_stage.slam_pressures(realised(ship))
    assert slams.sizes["slam"] == pytest.approx(usual.sizes["slam"], abs=4)
    assert "mark no slams of their own" in slams.attrs["warnings"]
    assert "mark no slams" not in usual.attrs["warnings"]


def test_extremes_of_a_longer_time_are_larger_and_lie_in_their_bands(ship):
    slams = pressure_stage.slam_pressures(realised(ship, hours=0.5))
    short, long = (pressure_tables.extremes_table(slams, hours, 0.01) for hours in (0.5, 5.0))
    for name in ("deck", "hardest_panel"):
        low, high = long[name]["most_probable_band"]
        assert low <= long[name]["most_probable_largest"] <= high
        assert long[name]["most_probable_largest"] > short[name]["most_probable_largest"]
        assert short[name]["exceeded_with_risk"] > short[name]["most_probable_largest"]
    assert long["hardest_panel"]["most_probable_largest"] <= long["deck"]["most_probable_band"][1]
    assert short["deck"]["most_probable_largest"] == pytest.approx(float(slams.slam_pressure.max()), rel=0.5)


def test_a_deck_that_never_slams(ship):
    design, found, relative, _ = ship
    calm = Condition(
        speed=10.0, wave_direction=np.pi, sea_state=SeaState(significant_wave_height=0.2, peak_period=8.0)
    )
    slam = pipeline.slamming(found, relative, design.wet_deck, calm)
    deck = pressure_stage.RealisedDeck(found, relative, slam, design.wet_deck, Realisation(hours=0.02))
    slams = pressure_stage.slam_pressures(deck)
    assert slams.sizes["slam"] == 0
    assert pressure_stage.hardest_slam(deck, slams) is None


def test_command_gives_envelope_extremes_and_force_history(capsys, tmp_path):
    table, history = tmp_path / "slams.csv", tmp_path / "hardest.nc"
    code, out, _ = run(
        capsys,
        "pressure",
        "delft-372",
        *SEA,
        "--clearance",
        "0.09",
        "--out",
        table,
        "--history",
        history,
        "--json",
    )
    assert code == 0
    values = json.loads(out)
    assert np.array(values["envelope"]).shape == (24, 4)
    assert np.max(values["envelope"]) == pytest.approx(values["hardest"]["slam_pressure"])
    assert values["quantiles"]["1"]["slam_pressure"] == pytest.approx(values["hardest"]["slam_pressure"])
    assert len(values["force_history"]["time"]) == len(values["force_history"]["force"]) > 20
    assert values["slams"] > 3
    assert values["extremes"]["hours"] == 0.02
    low, high = values["extremes"]["deck"]["most_probable_band"]
    assert low <= values["extremes"]["deck"]["most_probable_largest"] <= high
    rules = {row["rule"] for row in values["rule_pressures"]["rules"]}
    assert rules == {"gl-hsc", "abs-hsc", "dnv-hslc", "lr-ssc"}
    rows = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    assert rows[0].startswith("slam_start [s],slam_duration [s],slam_pressure [Pa]")
    assert len(rows) == values["slams"] + 1
    found = load_dataset(history)
    assert found.deck_pressure.dims == ("time", "x", "y")
    assert found.deck_pressure.attrs["units"] == "Pa"
    code, text, err = run(
        capsys, "pressure", "delft-372", *SEA, "--clearance", "0.09", "--reduction", "pabst"
    )
    assert "largest panel pressure" in text
    assert "kPa" in text
    assert "warning:" in err


def test_command_says_that_a_deck_stays_dry(capsys, tmp_path):
    arguments = ("pressure", "delft-372", *SEA, "--clearance", "1.0")
    code, out, _ = run(capsys, *arguments)
    assert code == 0
    assert "stays dry" in out
    code, _, err = run(capsys, *arguments, "--history", tmp_path / "none.csv")
    assert code == 2
    assert "There was no slam" in err


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--strips", "diagonal"), "direction of the strips"),
        (("--frame", "ship"), "frame of the closing velocity"),
        (("--suction", "-1"), "suction must be"),
        (("--reduction", "half"), "reduction for the width"),
        (("--time-step", "0"), "time step of the pressures"),
        (("--out", "slams.xlsx"), "must end in .csv or .nc"),
        (("--out", "nowhere/slams.csv"), "folder that exists"),
    ],
)
def test_command_refuses_in_one_sentence(capsys, options, words):
    code, out, err = run(capsys, "pressure", "delft-372", *SEA, *options)
    assert code == 2
    assert out == ""
    assert err.startswith("workbench: ")
    assert words in err
    assert len(err.strip().splitlines()) == 1


def test_film_shows_the_largest_pressure_about_each_picture(ship):
    deck = realised(ship, time_step=0.01)
    slams = pressure_stage.slam_pressures(deck)
    hardest = slams.isel(slam=int(pressure_stage.hardest_slams(slams, 1)[0]))
    start, step, frames = float(hardest.slam_start), 0.1, 30
    film = animation.deck_pressure_film(deck, start, step, frames)
    assert film.attrs["time_step"] == pytest.approx(0.01)
    np.testing.assert_allclose(film.time, step * np.arange(frames))
    fine = pressure_stage.slam_history(deck, start - step / 2, frames * step)
    for name in ("deck_pressure", "deck_force", "wetted_area"):
        grouped = fine[name].values.reshape(frames, 10, *fine[name].shape[1:]).max(axis=1)
        np.testing.assert_allclose(film[name].values, grouped, rtol=1e-5, atol=1e-3)
    picture = int(film.deck_force.values.argmax())
    moment = int(fine.deck_force.values.argmax())
    assert moment // 10 == picture
    assert float(film.deck_force_x[picture]) == pytest.approx(float(fine.deck_force_x[moment]), rel=1e-5)


def test_animation_takes_the_pressure_of_the_theory(ship):
    _, found, relative, slam = ship
    realisation = Realisation(hours=0.05)
    events, _ = pipeline.counted_slams(found, relative, slam, realisation)
    plain = animation.animation_scene(found, relative, slam, events, realisation, frames=160)
    scene = animation.animation_scene(
        found, relative, slam, events, realisation, realised=realised(ship), frames=160
    )
    assert "deck_force" not in plain
    assert scene.sizes == plain.sizes
    np.testing.assert_allclose(scene.elevation, plain.elevation)
    assert not np.allclose(scene.pressure, plain.pressure)
    pressed = scene.pressure.max(("x", "y")).values > 0
    assert pressed.any()
    assert np.all(scene.wetted_area.values[pressed] > 0)
    assert scene.attrs["pressure_step"] <= 0.02
