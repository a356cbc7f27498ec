"""Tables of slams: predicted, compared with records, and two bottoms at matched angles."""

import numpy as np
import pytest

from workbench import quantities
from workbench.errors import InputError
from workbench.impact import chuang
from workbench.impact.slam_table import agreement, matched_comparison, predicted_slams


def slams(count=3, **more):
    angle = np.radians(np.linspace(-4, -12, count))
    return quantities.dataset(
        {"event": np.arange(count)},
        heave_velocity=("event", np.full(count, 0.6)),
        surface_velocity=("event", np.full(count, -0.2)),
        pitch_velocity=("event", np.full(count, 0.3)),
        attitude=("event", angle),
        wave_slope=("event", np.full(count, 0.01)),
        **more,
    )


def test_prediction_of_a_table_and_k_of_its_records():
    recorded = ("event", np.array([20e3, 15e3, 10e3]))
    found = predicted_slams(slams(recorded_pressure=recorded), 1000.0)
    known = chuang.method_one(0.6, -0.2, 0.3, found.attitude.values, 0.01, 1000.0)
    assert found.peak_pressure.values == pytest.approx(known.total_pressure)
    back = (recorded[1] - known.planing_pressure) / (144 * 1000 * known.normal_velocity**2)
    assert found.recorded_constant.values == pytest.approx(back)
    assert found.peak_pressure.attrs["units"] == "Pa"


def test_roll_and_law_are_passed_on():
    rolled = predicted_slams(slams(roll_angle=("event", np.full(3, 0.1))), 1000.0)
    level = predicted_slams(slams(), 1000.0)
    assert rolled.impact_angle.values == pytest.approx(np.hypot(level.impact_angle.values, 0.1))
    flat = slams().assign(attitude=("event", np.full(3, 0.02)))
    both = [float(predicted_slams(flat, 1000.0, law).pressure_constant[0]) for law in ("program", "text")]
    assert both[0] > both[1]
    with pytest.raises(InputError, match="lacks pitch_velocity"):
        predicted_slams(slams().drop_vars("pitch_velocity"), 1000.0)


def test_agreement_of_three_slams_by_hand():
    found = agreement([2.0, 3.0, 6.0], [2.0, 4.0, 4.0])
    assert (found.count, found.below, found.within_quarter) == (3, 1, 2)
    assert found.mean_ratio == pytest.approx(3.25 / 3)
    assert (found.median_ratio, found.least_ratio, found.largest_ratio) == (1.0, 0.75, 1.5)
    assert found.rms_error == pytest.approx(np.sqrt(5 / 3))
    assert found.correlation == pytest.approx(np.corrcoef([2, 3, 6], [2, 4, 4])[0, 1])
    assert np.isnan(agreement([1.0], [2.0]).correlation)


@pytest.mark.parametrize(("recorded", "calculated"), [([], []), ([1.0], [1.0, 2.0]), ([1.0], [0.0])])
def test_agreement_refuses_what_cannot_be_compared(recorded, calculated):
    with pytest.raises(InputError):
        agreement(recorded, calculated)


def test_matched_slams_of_two_bottoms():
    recorded = 0.8 * predicted_slams(slams(9), 1000.0).peak_pressure.values
    first = predicted_slams(slams(9, recorded_pressure=("event", recorded / 0.8)), 1000.0)
    second = predicted_slams(slams(9, recorded_pressure=("event", recorded)), 1000.0)
    found = matched_comparison(first, second, np.radians(0.1))
    assert (found.pairs, found.matched, found.lower) == (9, 9, 9)
    assert found.median_ratio == pytest.approx(0.8, abs=0.01)
    assert found.probability < 1e-3
    wide = matched_comparison(first, second, np.radians(1.1))
    assert wide.pairs == 9 + 2 * 8
    k = first.recorded_constant.values
    means = [k[max(number - 1, 0) : number + 2].mean() for number in range(9)]
    assert wide.median_ratio == pytest.approx(np.median(second.recorded_constant.values / means))
    apart = second.assign(impact_angle=second.impact_angle + 0.5)
    with pytest.raises(InputError, match="widen the band"):
        matched_comparison(first, apart)
