"""Immersions grouped into slams, in place, in time and around a period; the deepest slam by itself."""

import numpy as np
import pytest

from workbench import quantities
from workbench.errors import InputError
from workbench.wet_deck_pressure.slam_event import cell_edges, isolation_window, slam_event, slams

PERIOD = 6.0
DECK = quantities.dataset(
    {"x": 0.1 * np.arange(20) - 1.0, "y": np.array([-0.2, 0.0, 0.2])},
    height=(("x", "y"), np.ones((20, 3))),
    slope_x=(("x", "y"), np.zeros((20, 3))),
    area=(("x", "y"), np.full((20, 3), 0.02)),
)


def dips(rows, periodic=True):
    """Immersions from (row, column, time, depth, velocity)."""
    rows = sorted(rows, key=lambda row: row[2])
    row, column, time, depth, velocity = (np.array(part) for part in zip(*rows, strict=True))
    return quantities.dataset(
        {"event": np.arange(len(rows))},
        attrs={"start": 0.0, "duration": PERIOD, "periodic": int(periodic), "time_step": 0.01},
        event_time=("event", time.astype(float)),
        event_x=("event", DECK.x.values[row]),
        event_y=("event", DECK.y.values[column]),
        entry_velocity=("event", velocity.astype(float)),
        entry_angle=("event", np.full(len(rows), 0.1)),
        immersion_duration=("event", np.full(len(rows), 0.05)),
        immersion_depth=("event", depth.astype(float)),
        time_of_depth=("event", time + 0.02),
    )


AFT = [(2, 1, 1.00, 0.010, 0.5), (3, 1, 1.05, 0.020, 0.7), (3, 2, 1.10, 0.015, 0.4), (4, 0, 1.12, 0.001, 0.1)]
FORE = [(15, 1, 1.02, 0.005, 0.9), (14, 1, 1.08, 0.004, 0.3)]
LATER = [(2, 1, 3.0, 0.002, 0.2)]


def test_slams_are_apart_in_place_or_in_time():
    found = slams(dips(AFT[:3] + FORE + LATER), DECK, window=0.2)
    assert found.sizes["slam"] == 3
    np.testing.assert_allclose(found.slam_start, [1.0, 1.02, 3.0])
    np.testing.assert_allclose(found.slam_spread, [0.1, 0.06, 0.0], atol=1e-12)
    assert found.slam_points.values.tolist() == [3, 2, 1]
    np.testing.assert_allclose(found.contact_x, DECK.x.values[[2, 15, 2]])
    np.testing.assert_allclose(found.immersion_depth, [0.020, 0.005, 0.002])
    np.testing.assert_allclose(found.entry_velocity, [0.7, 0.9, 0.2])
    assert found.slam_number.values.tolist() == [0, 1, 0, 1, 0, 2]


def test_neighbours_touch_by_their_corners_and_not_across_a_gap():
    corners = [(5, 0, 1.0, 0.1, 0.1), (6, 1, 1.1, 0.1, 0.1)]
    assert slams(dips(corners), DECK).sizes["slam"] == 1
    assert slams(dips([(5, 0, 1.0, 0.1, 0.1), (7, 0, 1.1, 0.1, 0.1)]), DECK).sizes["slam"] == 2
    assert slams(dips([(5, 0, 1.0, 0.1, 0.1), (5, 2, 1.0, 0.1, 0.1)]), DECK).sizes["slam"] == 2
    assert slams(dips(corners), DECK, window=0.05).sizes["slam"] == 2
    # the last row and the first are no neighbours, in waves that repeat either
    assert slams(dips([(0, 1, 1.0, 0.1, 0.1), (19, 1, 1.0, 0.1, 0.1)]), DECK).sizes["slam"] == 2


@pytest.mark.parametrize(("periodic", "count"), [(True, 1), (False, 2)])
def test_a_slam_across_the_end_of_the_period_is_one(periodic, count):
    rows = [
        (5, 1, 5.95, 0.01, 0.3),
        (6, 1, 5.98, 0.02, 0.3),
        (7, 1, 0.04, 0.03, 0.3),
        (8, 1, 0.06, 0.01, 0.3),
    ]
    given = dips(rows, periodic)
    found = slams(given, DECK)
    assert found.sizes["slam"] == count
    event = slam_event(given, DECK)
    if periodic:
        assert event.attrs["start"] == pytest.approx(5.95)
        assert event.attrs["contact_x"] == pytest.approx(DECK.x.values[5])
        np.testing.assert_allclose(event.time_since_contact, [0.0, 0.03, 0.09, 0.11], atol=1e-12)
        np.testing.assert_allclose(event.event_x, DECK.x.values[5:9])
    else:
        assert event.attrs["start"] == pytest.approx(0.04)  # of the deepest
        assert event.sizes["event"] == 2


def test_points_in_the_water_at_the_start_belong_to_no_slam():
    given = dips([(2, 1, 0.0, 0.5, np.nan), *AFT])
    found = slams(given, DECK)
    assert found.slam_number.values[0] == -1
    assert slam_event(given, DECK).attrs["start"] == 1.0


def test_the_deepest_slam_is_taken_and_cut_to_its_window():
    given = dips(AFT + FORE + LATER)
    event = slam_event(given, DECK, window=0.11)
    assert dict(event.sizes) == {"event": 3}  # what comes 0.12 s after first contact is left out
    assert event.attrs["spread"] == pytest.approx(0.1)
    np.testing.assert_allclose(event.time_since_contact, [0.0, 0.05, 0.10], atol=1e-12)
    np.testing.assert_allclose(event.entry_velocity, [0.5, 0.7, 0.4])
    np.testing.assert_allclose(event.immersion_depth, [0.010, 0.020, 0.015])
    np.testing.assert_allclose(event.area, 0.02)
    np.testing.assert_allclose(event.panel_fore - event.panel_aft, 0.1)
    np.testing.assert_allclose((event.panel_fore + event.panel_aft) / 2, event.event_x)
    assert slam_event(given, DECK, number=1).attrs["contact_x"] == pytest.approx(DECK.x.values[15])


def test_only_the_first_wetting_of_a_point_counts():
    again = [*AFT, (2, 1, 1.15, 0.9, 0.9)]
    event = slam_event(dips(again), DECK)
    assert event.sizes["event"] == 4
    assert float(event.immersion_depth[0]) == 0.010


def test_first_contact_of_several_points_together_is_their_mean():
    rows = [(4, 0, 1.0, 0.1, 0.1), (4, 1, 1.0, 0.1, 0.1), (5, 1, 1.0, 0.1, 0.1), (6, 1, 1.1, 0.1, 0.1)]
    event = slam_event(dips(rows), DECK)
    assert event.attrs["contact_x"] == pytest.approx(DECK.x.values[[4, 4, 5]].mean())
    assert event.attrs["contact_y"] == pytest.approx(-0.2 / 3)


def test_a_dry_deck_and_bad_choices_are_refused():
    dry = dips(AFT).isel(event=slice(0, 0))
    assert slams(dry, DECK).sizes["slam"] == 0
    with pytest.raises(InputError, match="enters the water"):
        slam_event(dry, DECK)
    with pytest.raises(InputError, match="number of the slam"):
        slam_event(dips(AFT), DECK, number=5)
    with pytest.raises(InputError, match="window"):
        slams(dips(AFT), DECK, window=0.0)


def test_window_scales_by_froude():
    assert isolation_window(1.1) == pytest.approx(0.2)
    assert isolation_window(198.0) == pytest.approx(0.2 * np.sqrt(180))


def test_edges_of_cells():
    np.testing.assert_allclose(cell_edges([0.0, 1.0, 3.0]), [-0.5, 0.5, 2.0, 4.0])
    np.testing.assert_allclose(cell_edges([2.0]), [2.0, 2.0])
