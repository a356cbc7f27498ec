"""Pulses of gauges: the highest one, and those that are damped or irregular."""

import numpy as np
import pytest
from model_slams import DELAY, SHAPE, instants, pulse, slam_record

from workbench.errors import InputError
from workbench.records.pressure_pulses import PulseSettings, event_record, pressure_pulses
from workbench.records.reading import record

SETTINGS = PulseSettings(least_pressure=3e3)
TIME = np.arange(0, 2, 0.0005)


def one_gauge(values):
    return pressure_pulses(record(TIME, values[:, None], ["P1"], ["Pa"]), SETTINGS)


def test_every_gauge_has_its_own_peak_at_its_own_time():
    found = pressure_pulses(slam_record(), SETTINGS)
    assert found.sizes == {"event": 3, "gauge": 6}
    for gauge, share in SHAPE.items():
        assert found.gauge_peak.sel(gauge=gauge).values == pytest.approx(share * 20e3, rel=0.2)
        late = found.gauge_peak_time.sel(gauge=gauge).values - instants(3)
        assert late == pytest.approx(DELAY[gauge], abs=5e-4)
    assert list(found.peak_gauge.values) == ["P1"] * 3
    assert found.event_time.values == pytest.approx(instants(3), abs=5e-4)
    assert not found.is_excluded.values.any()


def test_shape_of_a_typical_pulse():
    found = one_gauge(10e3 * pulse(TIME, 1.0, rise=0.004, decay=0.02))
    assert float(found.rise_time[0]) == pytest.approx(0.9 * 0.004, rel=0.01)
    assert float(found.pulse_duration[0]) == pytest.approx(0.002 + 0.02 * np.log(2), rel=0.02)
    assert float(found.second_peak_share[0]) == 0
    assert int(found.is_excluded[0]) == 0


def test_damped_pulse_is_excluded():
    slow = 10e3 * np.clip(np.sin(np.pi * (TIME - 0.96) / 0.08), 0, None) * (np.abs(TIME - 1) < 0.04)
    found = one_gauge(slow)
    assert float(found.rise_time[0]) == pytest.approx(0.04 - 0.08 / np.pi * np.arcsin(0.1), rel=0.02)
    assert int(found.is_excluded[0]) == 1


@pytest.mark.parametrize(("second", "excluded"), [(0.7, 1), (0.3, 0)])
def test_irregular_pulse_is_excluded(second, excluded):
    found = one_gauge(10e3 * (pulse(TIME, 1.0) + second * pulse(TIME, 1.06)))
    assert float(found.second_peak_share[0]) == pytest.approx(second, abs=0.02)
    assert int(found.is_excluded[0]) == excluded


def test_highest_gauge_need_not_be_the_first():
    values = np.stack([4e3 * pulse(TIME, 1.0), 9e3 * pulse(TIME, 1.01)], axis=1)
    found = pressure_pulses(record(TIME, values, ["P1", "P8"], ["Pa", "Pa"]), SETTINGS)
    assert found.peak_gauge.values == ["P8"]
    assert float(found.peak_pressure[0]) == pytest.approx(9e3)
    assert found.gauge_peak.values[0] == pytest.approx([4e3, 9e3])


def test_too_slow_sampling_is_warned_of():
    coarse = np.arange(0, 2, 0.01)
    values = 10e3 * (np.abs(coarse - 1) < 0.004)
    found = pressure_pulses(record(coarse, values[:, None], ["P1"], ["Pa"]), SETTINGS)
    assert "sample faster" in found.attrs["warnings"]
    assert "sample faster" not in one_gauge(10e3 * pulse(TIME, 1.0)).attrs["warnings"]


def test_nothing_above_the_threshold():
    assert one_gauge(1e3 * pulse(TIME, 1.0)).sizes["event"] == 0


def test_settings_scale_by_froude():
    ship = SETTINGS.scaled(25.0)
    assert (ship.least_pressure, ship.longest_rise, ship.window) == pytest.approx((75e3, 0.05, 0.5))
    assert ship.largest_second_peak == SETTINGS.largest_second_peak
    for given in ({"longest_rise": 0.2}, {"least_pressure": 0}, {"largest_second_peak": 1.5}):
        with pytest.raises(InputError):
            PulseSettings(**{"least_pressure": 1.0, **given})


def test_part_of_a_record():
    part = event_record(slam_record(), 1.0, 0.1)
    assert part.time.values[0] >= 0.9
    assert part.time.values[-1] <= 1.1
