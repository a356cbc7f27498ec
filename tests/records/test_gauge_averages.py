"""Averages of gauges at one instant, their bounds, and what they need."""

import numpy as np
import pytest
from model_slams import SHAPE, instants, slam_record

from workbench.errors import InputError
from workbench.records.gauge_averages import (
    AREAS,
    area_average,
    area_averages,
    bound_notes,
    gauge_samples,
    largest_averages,
    possible_areas,
)
from workbench.records.pressure_pulses import event_record
from workbench.records.reading import record

PRESSURES = {"P1": 8.0, "P2": 4.0, "P3": 2.0, "P6": 1.0, "P7": 3.0, "P8": 6.0, "P9": 0.0}


@pytest.mark.parametrize(
    ("area", "known"),
    [("I", (8 + 4 + 2 + 6 + 0 + 2) / 6), ("II", (8 + 4 + 2 + 2) / 4), ("III", 7.0), ("IV", (8 + 6 + 4 + 2) / 4),
     ("V", 3.0)],
)  # fmt: skip
def test_five_averages(area, known):
    assert area_average(PRESSURES, area) == pytest.approx(known)
    without = {gauge: value for gauge, value in PRESSURES.items() if gauge != "P9"}
    assert area_average(without, area) == pytest.approx(known)
    assert sum(AREAS[area].values()) == pytest.approx(1)


def test_ninth_gauge_counts_where_it_was_recorded():
    assert area_average({**PRESSURES, "P9": 6.0}, "I") == pytest.approx(area_average(PRESSURES, "I") + 1)


@pytest.mark.parametrize(("area", "bound", "alone"), [("I", 6, "P1"), ("II", 4, "P3"), ("I", 6, "P8")])
def test_one_gauge_alone_makes_the_bound(area, bound, alone):
    one = {gauge: 5.0 if gauge == alone else 0.0 for gauge in PRESSURES}
    assert 5.0 / area_average(one, area) == pytest.approx(bound)
    assert not bound_notes(area, bound)
    assert "suction" in bound_notes(area, bound + 0.1)[0]
    assert not bound_notes("III", 9.0)


def test_averages_are_of_one_instant():
    """The delays between gauges keep the average below that of the gauges' own maxima."""
    slam = event_record(slam_record(), float(instants(3)[0]), 0.1)
    found = largest_averages(slam)
    own_maxima = {gauge: values.max() for gauge, values in gauge_samples(slam).items()}
    for area in AREAS:
        largest = float(found.largest_average.sel(gauge_area=area))
        assert 0.7 * area_average(own_maxima, area) < largest < area_average(own_maxima, area)
    averages = area_averages(slam).average_pressure
    assert float(averages.max("time").sel(gauge_area="II")) == float(
        found.largest_average.sel(gauge_area="II")
    )
    ratio = float(found.peak_over_average.sel(gauge_area="V"))
    assert ratio == pytest.approx(own_maxima["P2"] / float(found.largest_average.sel(gauge_area="V")))


def test_suction_above_the_bound_is_warned_of():
    time = np.arange(0, 1, 0.01)
    values = np.zeros((100, 6))
    values[50] = [10e3, -3e3, 0, 0, 0, 0]
    found = largest_averages(record(time, values, list(SHAPE), ["Pa"] * 6))
    assert float(found.peak_over_average.sel(gauge_area="II")) == pytest.approx(10 / 7 * 4)
    assert "average II" in found.attrs["warnings"]


def test_areas_follow_from_the_gauges():
    assert possible_areas(["P1", "P2", "P3", "P6", "P7"]) == ["II", "V"]
    with pytest.raises(InputError, match="P8 are missing"):
        area_average({"P1": 1.0}, "III")
    with pytest.raises(InputError, match="one of I, II"):
        area_average(PRESSURES, "VI")
    time = np.arange(0, 1, 0.01)
    with pytest.raises(InputError, match="gauges of an average"):
        area_averages(record(time, np.zeros((100, 1)), ["P3"], ["Pa"]))
    with pytest.raises(InputError, match="named P1, P2"):
        gauge_samples(record(time, np.zeros((100, 1)), ["pitch"], ["rad"]))
    with pytest.raises(InputError, match="must be in Pa"):
        gauge_samples(record(time, np.zeros((100, 1)), ["P1"], ["m"]))
