import math

import numpy as np
import pytest

from workbench.design import WetDeck
from workbench.errors import InputError
from workbench.geometry.wet_deck import lowest_height, wet_deck_grid, wet_deck_height
from workbench.hulls import library

FLAT = {"aft": -15.0, "fore": 15.0, "width": 8.0, "clearance": 2.0}


def deck(**changes):
    return WetDeck(**FLAT | changes)


def test_a_plain_deck_is_flat_and_its_cells_fill_it():
    grid = wet_deck_grid(deck(), 30, 8)
    np.testing.assert_array_equal(grid.height, 2.0)
    np.testing.assert_array_equal(grid.slope_x, 0.0)
    assert float(grid.area.sum()) == pytest.approx(30.0 * 8.0)
    assert grid.x.values[[0, -1]] == pytest.approx([-14.5, 14.5])
    assert grid.y.values[[0, -1]] == pytest.approx([-3.5, 3.5])
    assert grid.height.attrs["units"] == "m"


@pytest.mark.parametrize(
    ("changes", "x", "y", "height"),
    [
        ({"camber": 0.4}, 0.0, 0.0, 2.4),
        ({"camber": 0.4}, 0.0, 4.0, 2.0),
        ({"camber": 0.4}, 0.0, -2.0, 2.3),
        ({"entry_length": 5.0, "entry_rise": 1.0}, 10.0, 0.0, 2.0),
        ({"entry_length": 5.0, "entry_rise": 1.0}, 15.0, 1.0, 3.0),
        ({"entry_length": 5.0, "entry_rise": 1.0}, 12.5, 1.0, 2.5),
        ({"vee_depth": 0.5, "vee_width": 2.0}, 3.0, 0.0, 1.5),
        ({"vee_depth": 0.5, "vee_width": 2.0}, 3.0, -0.5, 1.75),
        ({"vee_depth": 0.5, "vee_width": 2.0}, 3.0, 1.5, 2.0),
        ({"corner_radius": 1.0}, 0.0, 4.0, 1.0),
        ({"corner_radius": 1.0}, 0.0, 3.0, 2.0),
        ({"corner_radius": 1.0}, 0.0, -4.0 + (1 - math.sqrt(0.5)), 2.0 - (1 - math.sqrt(0.5))),
        ({"centre_bow_length": 10.0, "centre_bow_depth": 1.0, "centre_bow_width": 4.0}, 15.0, 0.0, 1.0),
        ({"centre_bow_length": 10.0, "centre_bow_depth": 1.0, "centre_bow_width": 4.0}, 15.0, 1.0, 1.5),
        ({"centre_bow_length": 10.0, "centre_bow_depth": 1.0, "centre_bow_width": 4.0}, 8.0, 0.0, 1.5),
        ({"centre_bow_length": 10.0, "centre_bow_depth": 1.0, "centre_bow_width": 4.0}, 5.0, 0.0, 2.0),
        ({"centre_bow_length": 10.0, "centre_bow_depth": 1.0, "centre_bow_width": 4.0}, 7.0, 0.0, 2 - 7 / 27),
        ({"trim": 0.05}, 10.0, 0.0, 2.0 - 10.0 * math.tan(0.05)),
    ],
)
def test_every_part_of_the_deck_has_its_height(changes, x, y, height):
    assert wet_deck_height(deck(**changes), x, y) == pytest.approx(height, abs=1e-12)


def test_slopes_are_those_of_the_surface():
    grid = wet_deck_grid(
        deck(entry_length=5.0, entry_rise=1.0, vee_depth=0.5, vee_width=4.0, trim=0.02), 30, 16
    )
    entry = grid.sel(x=grid.x[grid.x > 10.5])
    np.testing.assert_allclose(entry.slope_x, 0.2 - math.tan(0.02))
    pod = grid.sel(y=grid.y[(grid.y > 0.2) & (grid.y < 1.8)])
    np.testing.assert_allclose(pod.slope_y, 0.25)
    np.testing.assert_allclose(grid.slope_y.isel(y=slice(None, None, -1)).values, -grid.slope_y.values)


@pytest.mark.parametrize("name", library.names())
def test_every_wet_deck_of_the_library_is_dry_at_rest(name):
    wet_deck = library.design(name).wet_deck
    if wet_deck is None:
        pytest.skip("no wet deck")
    assert lowest_height(wet_deck) > 0.0
    grid = wet_deck_grid(wet_deck)
    assert grid.height.dims == ("x", "y")
    assert float(grid.height.min()) >= lowest_height(wet_deck) - 1e-9


@pytest.mark.parametrize(("n_x", "n_y"), [(0, 5), (5, 0), ("a", 5), (5, None), (10**6, 5)])
def test_grids_without_sense_are_refused(n_x, n_y):
    with pytest.raises(InputError, match="number of points"):
        wet_deck_grid(deck(), n_x, n_y)
