import numpy as np
import pytest

from workbench.errors import InputError
from workbench.scene import packing
from workbench.scene.packing import (
    deck_field,
    packed_scene,
    quantised_bytes,
    quantised_film,
    values_of_bytes,
    worst_point,
)


def test_film_comes_back_within_half_a_unit(rng):
    elevation = rng.normal(0, 2, (20, 30, 10))
    quantised, unit = quantised_film(elevation)
    assert quantised.dtype == np.dtype("<i2")
    assert np.abs(quantised * unit - elevation).max() <= unit / 2 * (1 + 1e-9)
    assert unit <= np.abs(elevation).max() / 32767 * (1 + 1e-12)


def test_film_inside_the_hulls_is_still_water():
    quantised, _ = quantised_film(np.array([[np.nan, 1.0]]))
    assert quantised.tolist() == [[0, 32767]]


def test_deck_field_comes_back_within_its_bound(rng):
    values = rng.uniform(-2, 5, (10, 8, 6))
    values[0, 0, 0] = np.nan
    back = values_of_bytes(quantised_bytes(values, -3.0, 6.0), -3.0, 6.0)
    assert np.isnan(back[0, 0, 0])
    assert np.isfinite(back).sum() == values.size - 1
    assert np.nanmax(np.abs(back - values)) <= 9.0 / 508 * (1 + 1e-9)


@pytest.mark.parametrize("name", ["relative_motion_history", "clearance_left", "pressure"])
def test_limits_hold_the_whole_film_on_round_bands(short_scene, name):
    field = short_scene[name]
    facts = deck_field(field)
    assert facts["low"] <= field.min()
    assert field.max() <= facts["high"]
    band = (facts["high"] - facts["low"]) * facts["factor"] / packing.BANDS
    assert float(f"{band:.2g}") == pytest.approx(band)
    assert (facts["low"] * facts["factor"] / band) == pytest.approx(
        round(facts["low"] * facts["factor"] / band)
    )
    assert len(set(facts["colours"])) == packing.BANDS


def test_relative_motion_is_centred_on_nought_and_pressure_starts_there(short_scene):
    motion, pressure = deck_field(short_scene["relative_motion_history"]), deck_field(short_scene["pressure"])
    assert motion["low"] == -motion["high"]
    assert pressure["low"] == 0
    assert pressure["unit"] == "kPa"


def test_worst_point_has_the_least_clearance(short_scene):
    i, j = worst_point(short_scene)
    assert short_scene["clearance_left"].isel(x=i, y=j).min() == short_scene["clearance_left"].min()
    without = short_scene.drop_vars("clearance_left")
    assert worst_point(without) == (i, j)


def test_blocks_have_the_sizes_that_the_browser_expects(short_scene):
    blocks = packed_scene(short_scene)
    n_t, n_x, n_y = (short_scene.sizes[dim] for dim in ("time", "x", "y"))
    assert len(blocks["pose"]) == 4 * 6 * n_t
    assert len(blocks["water"]) == 4 * 5 * 40
    assert len(blocks["deck"]) == 4 * (n_x + n_y + n_x * n_y)
    assert len(blocks["pressure"]) == n_t * n_x * n_y
    assert len(blocks["slams"]) == 4 * 5 * short_scene.sizes["event"]
    assert len(blocks["curves"]) == 4 * n_t * len(blocks["scene"]["curves"])
    triangles = np.frombuffer(blocks["hull_faces"], "<u4").reshape(-1, 3)
    assert all(len(set(corners)) == 3 for corners in triangles.tolist())


def test_curves_are_in_the_units_of_their_labels(short_scene):
    blocks = packed_scene(short_scene)
    curves = np.frombuffer(blocks["curves"], "<f4").reshape(-1, short_scene.sizes["time"])
    rows = {curve["key"]: (curve["unit"], curves[k]) for k, curve in enumerate(blocks["scene"]["curves"])}
    assert rows["pitch"][0] == "deg"
    np.testing.assert_allclose(rows["pitch"][1], np.degrees(short_scene["pose"][:, 4]), atol=1e-5)
    assert rows["largest_pressure"][1].max() == pytest.approx(float(short_scene["pressure"].max()) / 1000)


def test_film_that_is_too_large_is_refused(film_scene, monkeypatch):
    monkeypatch.setattr(packing, "FILM_LIMIT", 1e4)
    with pytest.raises(InputError, match="use a shorter time"):
        packed_scene(film_scene)
