"""Slam loads of a given shape: values point by point, resultants, and the frames of the ship."""

import numpy as np
import pytest

from workbench import quantities
from workbench.errors import InputError
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hulls.library import design
from workbench.wet_deck_pressure.load_distribution import (
    INCAT_061,
    SHAPES,
    Frames,
    SlamDistribution,
    deck_forces,
    nodal_forces,
)


def load(shape=SHAPES[0], **changes) -> SlamDistribution:
    given = {"x": 30.0, "fore_length": 6.0, "aft_length": 12.0, "y": 5.0, "half_width": 2.0, "shape": shape}
    return SlamDistribution(**{**given, **changes})


@pytest.mark.parametrize(
    ("shape", "along", "across"),
    [
        (SHAPES[0], [0, 0.5, 1, 0.5, 0], [0.75, 1, 0.75, 0]),
        (SHAPES[1], [0, 0.75, 1, 0.75, 0], [0.5, 1, 0.5, 0]),
    ],
)
def test_shares_fall_as_they_are_said_to(shape, along, across):
    np.testing.assert_allclose(load(shape).along([18.0, 24.0, 30.0, 33.0, 36.0]), along)
    np.testing.assert_allclose(load(shape).across([4.0, 5.0, -6.0, 9.0]), across)


@pytest.mark.parametrize("shape", SHAPES)
def test_largest_force_or_total_lead_to_the_same_load(shape):
    rng = np.random.default_rng(98)
    x, y = rng.uniform(15, 40, 300), rng.uniform(-8, 8, 300)
    first = nodal_forces(load(shape), x, y, largest=2e5)
    again = nodal_forces(load(shape), x, y, total=first.attrs["total"])
    np.testing.assert_allclose(first.nodal_force, again.nodal_force)
    np.testing.assert_allclose(first.nodal_force, 2e5 * first.lengthwise_share * first.transverse_share)
    assert first.attrs["total"] == pytest.approx(float(first.nodal_force.sum()))
    for axis, place in (("x", x), ("y", y)):
        expected = np.sum(first.nodal_force.values * place) / first.attrs["total"]
        assert first.attrs[f"resultant_{axis}"] == pytest.approx(expected)


def test_resultant_of_a_longer_aft_part_lies_aft_of_the_largest_load():
    """Linear 6 m forward, 12 m aft: (36 - 144)/6 over 9 m."""
    x = np.linspace(15, 40, 5001)
    found = nodal_forces(load(), x, np.full(x.shape, 5.0), largest=1.0)
    assert found.attrs["resultant_x"] == pytest.approx(30 - 18 / 9, abs=1e-3)
    assert "provisional" in quantities.warnings_of(found)[0]


def test_forces_on_a_deck_go_with_its_cells():
    deck = wet_deck_grid(design("incat-061").wet_deck, 60, 20)
    shape = load(x=20.0, y=3.0)
    coarse = deck_forces(shape, deck, total=3e7)
    fine = deck_forces(shape, wet_deck_grid(design("incat-061").wet_deck, 240, 40), total=3e7)
    assert coarse.attrs["total"] == pytest.approx(3e7)
    assert coarse.attrs["resultant_x"] == pytest.approx(fine.attrs["resultant_x"], abs=0.05)
    assert coarse.attrs["resultant_y"] == pytest.approx(0.0, abs=1e-9)
    x, y = np.array([30.0, 30.0]), np.array([5.0, -5.0])
    weighed = nodal_forces(load(), x, y, largest=4.0, area=[2.0, 0.5])
    np.testing.assert_allclose(weighed.nodal_force, [4.0, 1.0])


def test_frames_and_shares_of_the_length_lead_there_and_back():
    assert float(INCAT_061.x(0)) == -46.2
    assert float(INCAT_061.from_transom(64)) == pytest.approx(76.8)
    assert float(INCAT_061.share_of_length(INCAT_061.x(64))) == pytest.approx(0.831, abs=5e-4)
    for x in (-46.2, 0.0, 30.3):
        assert float(INCAT_061.x(INCAT_061.frame(x))) == pytest.approx(x)
        assert float(INCAT_061.at_share(INCAT_061.share_of_length(x))) == pytest.approx(x)


def test_bad_loads_are_refused():
    with pytest.raises(InputError, match="one of both"):
        nodal_forces(load(), [30.0], [5.0])
    with pytest.raises(InputError, match="one of both"):
        nodal_forces(load(), [30.0], [5.0], largest=1.0, total=1.0)
    with pytest.raises(InputError, match="at least one of the 2 nodes"):
        nodal_forces(load(), [0.0, 1.0], [5.0, 5.0], largest=1.0)
    for changes in ({"fore_length": 0.0}, {"half_width": -1.0}, {"y": -1.0}, {"shape": "cubic"}):
        with pytest.raises(InputError):
            load(**changes)
    with pytest.raises(InputError):
        Frames(spacing=0.0, length=10.0)
