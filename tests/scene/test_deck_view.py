"""Pressure over the deck in time: what goes to the browser, and what the view says of it."""

import numpy as np
import pytest

from workbench import quantities
from workbench.errors import InputError
from workbench.scene.deck_packing import HIGHEST, HISTORIES, LARGEST, packed_history
from workbench.scene.deck_view import deck_view, scene_history
from workbench.scene.packing import deck_field
from workbench.scene.sea_view import sea_view

STEP = 0.0025


def history(count=200, shape=(12, 5), *, lowest=0.0, force=2e6, warnings=("Mind the air.",)):
    """A ridge of pressure that runs aft over the deck."""
    time = 30.0 + STEP * (np.arange(count) + 0.5)
    x, y = np.linspace(-20, 24, shape[0]), np.linspace(-5, 5, shape[1])
    ridge = 24 - 40 * np.arange(count) / count
    pressure = 8e5 * np.exp(-(((x - ridge[:, None]) / 3) ** 2))[:, :, None] * np.linspace(1, 0.8, shape[1])
    pressure[pressure < 1e3] = 0
    pressure[-5:] = lowest
    upwards = force * np.sin(np.linspace(0, np.pi, count))
    return quantities.dataset(
        {"time": time, "x": x, "y": y},
        warnings=warnings,
        attrs={"time_step": STEP},
        deck_pressure=(("time", "x", "y"), pressure),
        deck_force=("time", upwards),
        deck_force_x=("time", np.where(upwards > 1e-6, ridge, np.nan)),
        deck_force_y=("time", np.zeros(count)),
        wetted_area=("time", np.linspace(0, 300, count)),
    )


def unpacked(packed):
    """Return the pressures and curves that the browser makes of the blocks."""
    facts = packed["facts"]
    least, most = facts["stored"]
    shape = facts["count"], len(facts["x"]), len(facts["y"])
    stored = np.frombuffer(packed["pressure"], "<u2").reshape(shape)
    curves = np.frombuffer(packed["curves"], "<f4").reshape(len(HISTORIES), facts["count"])
    return least + stored / HIGHEST * (most - least), dict(zip(HISTORIES, curves, strict=True))


@pytest.mark.parametrize("lowest", [0.0, -9e4])
def test_pressures_and_curves_come_back(lowest):
    given = history(lowest=lowest)
    packed = packed_history(given)
    pressure, curves = unpacked(packed)
    span = np.ptp([*packed["facts"]["stored"], 0.0])
    assert np.abs(pressure - given.deck_pressure.values).max() <= 0.51 * span / HIGHEST
    for name in ("deck_force", "deck_force_x", "deck_force_y", "wetted_area"):
        np.testing.assert_allclose(curves[name], given[name].values, rtol=1e-6)
    assert packed["facts"]["start"] == pytest.approx(30 + STEP / 2)
    assert packed["facts"]["step"] == pytest.approx(STEP)


def test_dry_panels_are_told_from_wet_ones_under_suction():
    packed = packed_history(history(lowest=-9e4))
    least, most = packed["facts"]["stored"]
    nought = int(np.floor(-least / (most - least) * HIGHEST + 0.5))  # as the browser rounds
    stored = np.frombuffer(packed["pressure"], "<u2")
    assert np.isin(nought, stored)
    assert 0 < np.mean(stored == nought) < 1


def test_colours_and_limits_are_those_of_the_film():
    given = history()
    field = packed_history(given)["facts"]["field"]
    assert field == deck_field(given.deck_pressure.rename("pressure"))
    assert (field["unit"], field["low"], len(field["colours"])) == ("kPa", 0.0, 12)
    assert field["high"] >= float(given.deck_pressure.max())


def test_a_long_history_is_thinned_and_keeps_its_peaks():
    given = history(6000, (40, 10))
    given.deck_pressure[3001, 7, 3] = 5e6
    given.deck_force[1234] = 9e7
    given.deck_force_x[1234] = 3.25
    packed = packed_history(given)
    facts = packed["facts"]
    assert len(packed["pressure"]) <= LARGEST
    assert facts["every"] == 5
    pressure, curves = unpacked(packed)
    np.testing.assert_allclose(pressure.max(axis=(0)), given.deck_pressure.max("time"), atol=5e6 / HIGHEST)
    peak = int(np.argmax(curves["deck_force"]))
    assert curves["deck_force"][peak] == pytest.approx(9e7)
    assert curves["deck_force_x"][peak] == pytest.approx(3.25)
    moment = facts["start"] + facts["step"] * peak
    assert abs(moment - float(given.time[1234])) <= 2.5 * STEP
    assert facts["start"] + facts["step"] * (facts["count"] - 1) <= float(given.time[-1]) + 3 * STEP


@pytest.mark.parametrize(("force", "unit"), [(2e6, "MN"), (9e5, "kN"), (40.0, "kN")])
def test_force_has_a_unit_that_suits_it(force, unit):
    assert packed_history(history(force=force))["facts"]["force"]["unit"] == unit


def test_what_cannot_be_shown_is_refused():
    given = history()
    with pytest.raises(InputError, match="wetted_area; take it from slam_history"):
        packed_history(given.drop_vars("wetted_area"))
    with pytest.raises(InputError, match="at least 2 times and 2 x 2 panels, got 1 times"):
        packed_history(given.isel(time=[0]))
    with pytest.raises(InputError, match="evenly spaced"):
        packed_history(given.isel(time=[0, 1, 3]))


def test_view_starts_at_the_largest_force_and_says_the_limits():
    view = deck_view(history())
    assert view.time == pytest.approx(30 + STEP * 100, abs=STEP)
    assert view.notes == ["Mind the air."]
    assert view.facts["origin"] == pytest.approx(30.0)
    assert view.facts["title"] == "Slam at 30.0 s of the record"
    assert {"facts", "pressure", "curves", "revision", "chosen", "link", "_esm", "_css"} <= set(
        view.get_state()
    )
    view.message, view.old = "Nothing yet.", True
    view.show(history(300), time=99.0, notes=())
    assert view.time == pytest.approx(30 + 299.5 * STEP)
    assert (view.message, view.old, view.notes) == ("", False, [])


def test_deck_of_a_scene_follows_its_film(short_scene):
    with pytest.raises(InputError, match="no force over the deck"):
        scene_history(short_scene)
    count = short_scene.sizes["time"]
    forces = dict.fromkeys(
        ("deck_force", "deck_force_x", "deck_force_y", "wetted_area"), ("time", np.ones(count))
    )
    scene = short_scene.assign(forces)
    view, film = deck_view(scene), sea_view(scene)
    assert view.facts["count"] == count
    assert view.facts["slow"] == 1
    assert film.link == ""
    view.follow(film)
    assert view.link == film.link != ""
    other = deck_view(scene)
    other.follow(sea_view(scene))
    assert other.link != view.link
