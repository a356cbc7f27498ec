import numpy as np
import pytest
import xarray as xr
from scenes import demo_scene, elevation, sea

from workbench.errors import InputError
from workbench.scene.description import checked_scene, elevation_at


def test_scene_carries_units_title_and_speed(short_scene):
    assert short_scene["pressure"].attrs["units"] == "Pa"
    assert short_scene["pose"].dims == ("time", "dof")
    assert short_scene.attrs["speed"] == 12.0
    assert short_scene.attrs["title"].startswith("Catamaran")


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"pose": np.zeros((16, 5))}, "pose must have 6 values along dof"),
        ({"pose": np.zeros((9, 6))}, "pose must have 16 values along time, as time has, got 9"),
        ({"hull_vertices": np.zeros((10, 2))}, "hull_vertices must have 3 values along axis"),
        ({"hull_faces": np.array([[0, 1, 2, 99999]])}, "hull_faces must hold vertex numbers"),
        ({"deck_height": np.zeros(30)}, "deck_height must have the dimensions"),
        ({"fields": {"pressure": np.zeros((16, 12, 30))}}, "pressure must have 30 values along x"),
        ({"fields": {"depth": np.zeros((16, 30, 12))}}, "no quantity depth"),
        ({"time": np.arange(16.0) ** 1.5}, "must be uniform"),
        ({"water": {}}, "either an elevation film or wave components, got neither"),
        ({"water": {k: v for k, v in sea().items() if k != "component_ky"}}, "lack component_ky"),
        ({"slams": {"event_time": [1.0]}}, "lack event_x, event_y, entry_velocity, peak_pressure"),
        ({"deck_height": np.full((30, 12), np.nan)}, "not finite"),
        ({"x": np.linspace(30, -30, 30)}, "must rise"),
        ({"speed": float("nan")}, "Speed must be a finite number"),
    ],
)
def test_wrong_scene_is_refused_in_one_sentence(changes, words):
    with pytest.raises(InputError, match=words) as refusal:
        demo_scene(duration=1.5, **changes)
    message = str(refusal.value)
    assert message.endswith(".")
    assert ". " not in message
    assert "\n" not in message


def test_scene_without_hull_is_refused(short_scene):
    with pytest.raises(InputError, match="lacks hull_faces"):
        checked_scene(short_scene.drop_vars("hull_faces"))


def test_dimensions_come_back_in_order(short_scene):
    shuffled = short_scene.transpose(*reversed(list(short_scene.sizes)))
    assert checked_scene(shuffled)["pressure"].dims == ("time", "x", "y")
    xr.testing.assert_equal(checked_scene(shuffled)["pressure"], short_scene["pressure"])


def test_both_kinds_of_water_have_the_same_elevation(short_scene, film_scene):
    x, y = film_scene["sea_x"].values[10:14], film_scene["sea_y"].values[[5, 9, 20, 30]]
    expected = np.diagonal(elevation(sea(), np.array([3.0]), x, y)[0])
    np.testing.assert_allclose(elevation_at(short_scene, 3.0, x, y), expected, atol=1e-9)
    np.testing.assert_allclose(elevation_at(film_scene, 3.0, x, y), expected, atol=1e-9)
