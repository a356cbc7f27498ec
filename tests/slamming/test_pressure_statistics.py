"""Exceedance of pressures: closed forms against each other and against counting; bands that hold what they say."""

import numpy as np
import pytest
import xarray as xr
from flat_seas import deck, flat_band, random_sea

from workbench import quantities
from workbench.errors import InputError
from workbench.impact.pressure import PressureLaw
from workbench.slamming.events import entries, grouping_dispersion
from workbench.slamming.extremes import largest_peak_pressure
from workbench.slamming.joint_law import ranked_pressures
from workbench.slamming.pressure_statistics import (
    counted_exceedance,
    exponential_exceedance,
    joint_exceedance,
    largest_pressures,
    rate_band,
)
from workbench.slamming.statistics import response_moments, slamming_statistics

PANEL = PressureLaw(name="panel", coefficient=40.8)
LEVELS = np.linspace(0.0, 9e4, 46)


def statistics(slope=0.0, height=0.8, threshold=0.0, velocity="time-derivative"):
    relative, energy = flat_band(slope=slope)
    moments = response_moments(relative, energy)
    plate = deck(height)
    return moments, slamming_statistics(moments, plate.height, threshold, velocity), plate


def panel_record(seed, hours=4.0, slope=0.0, law=PANEL):
    """Entries of a record, and the same as slams with a pressure on each panel."""
    plate = deck(0.8)
    found = entries(
        *random_sea(0.0, seed, slope=slope), plate, duration=3600.0 * hours, time_step=0.1, law=law
    )
    pressure = np.zeros((found.sizes["event"], 2, 1))
    row = (found.event_x.values > 0.5).astype(int)
    pressure[np.arange(len(row)), row, 0] = found.peak_pressure.values
    slams = quantities.dataset(
        {"slam": np.arange(len(row)), "x": plate.x, "y": plate.y},
        method="made of entries",
        attrs={"duration": found.attrs["duration"]},
        slam_panel_pressure=(("slam", "x", "y"), pressure),
        slam_start=("slam", found.event_time.values),
    )
    return found, slams, plate


def test_exponential_law_of_a_fixed_k():
    """N exp(-(p - p_t)/(rho k m2)) above p_t = rho k v_t**2/2, all N below (Ochi 1964)."""
    moments, found, _ = statistics(threshold=0.3)
    curve = exponential_exceedance(moments, found, np.array([0.0, 1000.0, 4e4]), 40.8, 1025.0)
    number = float(found.slams_per_hour[0, 0])
    m2 = float(moments.relative_velocity_std[0, 0]) ** 2
    least = 1025 * 40.8 * 0.3**2 / 2
    expected = number * np.exp(-(4e4 - least) / (1025 * 40.8 * m2))
    np.testing.assert_allclose(
        curve.exceedance_per_hour.values[:, 0, 0], [number, number, expected], rtol=1e-12
    )
    assert curve.exceedance_per_hour.attrs["units"] == "1/h"


def test_joint_law_of_a_fixed_k_is_the_exponential_law():
    moments, found, plate = statistics()
    joint = joint_exceedance(moments, found, plate, LEVELS, PANEL, 1025.0).exceedance_per_hour.values
    exact = exponential_exceedance(moments, found, LEVELS, 40.8, 1025.0).exceedance_per_hour.values
    there = exact > 1e-6
    np.testing.assert_allclose(joint[there], exact[there], rtol=3e-3)
    assert exact.min() < 1e-7
    assert joint[~there].max() < 2e-6


@pytest.mark.parametrize("velocity", ["time-derivative", "material"])
def test_number_above_is_the_inverse_of_the_pressure_exceeded(velocity):
    moments, found, plate = statistics(slope=0.15, velocity=velocity)
    ranked = ranked_pressures(moments, found, plate, PressureLaw(), 1025.0, 1e-4)
    for per_hour in (30.0, 1.0, 0.01):
        pressure = ranked.pressure_exceeded(per_hour)
        for row in (0, 1):
            back = ranked.number_above(pressure[row])[0, row, 0]
            assert back == pytest.approx(per_hour, rel=0.05)


def test_joint_law_with_angles_agrees_with_counting_within_the_bands():
    """Slope correlated with velocity and random, 28 h: the curve lies in the band of the counted one."""
    law = PressureLaw()
    moments, found, plate = statistics(slope=0.25)
    events, _, _ = panel_record(7, hours=28.0, slope=0.25, law=law)
    levels = np.linspace(0.0, 0.9 * float(events.peak_pressure.max()), 30)
    curve = joint_exceedance(moments, found, plate, levels, law, 1025.0).exceedance_per_hour
    counted = counted_exceedance(events, levels, plate)
    inside = (counted.exceedance_low <= curve) & (curve <= counted.exceedance_high)
    assert inside.isel(pressure_level=slice(1, None)).mean() > 0.97
    assert float(counted.exceedance_per_hour[15, 0, 0]) > 0.3


def test_panels_and_entries_are_counted_alike():
    events, slams, plate = panel_record(3)
    by_events, by_panels = counted_exceedance(events, LEVELS, plate), counted_exceedance(slams, LEVELS)
    for name in ("exceedance_per_hour", "exceedance_low", "exceedance_high"):
        np.testing.assert_array_equal(by_events[name], by_panels[name])
    first = events.peak_pressure.values[events.event_x.values == 0.0]
    assert by_panels.exceedance_per_hour.values[10, 0, 0] == pytest.approx((first > LEVELS[10]).sum() / 4)
    assert (np.diff(by_panels.exceedance_per_hour, axis=0) <= 0).all()


def test_garwoods_band_and_its_widening():
    """chi2(0.005, 2 n)/2 and chi2(0.995, 2 n + 2)/2; n = 10: 3.717 and 21.398 (tables of the Poisson law)."""
    low, high = rate_band(np.array([0.0, 10.0]))
    assert low[1] == pytest.approx(3.7169, abs=1e-3)
    assert high[1] == pytest.approx(21.3978, abs=1e-3)
    assert (low[0], high[0]) == (0.0, pytest.approx(-np.log(0.01)))
    wide = rate_band(40.0, 4.0)
    assert wide[0] == pytest.approx(4 * low[1])
    assert wide[1] == pytest.approx(4 * high[1])


def test_dispersion_is_that_of_the_groups():
    """Poisson slams 1; each of them bringing two more, 3; few slams do not tell, and count as Poisson's."""
    rng = np.random.default_rng(9)
    single = rng.poisson(10.0, (24, 40))
    assert grouping_dispersion(single.astype(float)) == pytest.approx(1.0, abs=0.15)
    assert grouping_dispersion(3.0 * single) == pytest.approx(3.0, abs=0.4)
    assert grouping_dispersion(np.eye(24)[:, :5]) == 1.0


def test_mean_of_counted_curves_is_the_closed_form_and_the_bands_hold_it():
    """40 seeded hours of a Gaussian sea: unbiased at every pressure, and inside the band 99 times in 100."""
    moments, found, _ = statistics()
    exact = exponential_exceedance(moments, found, LEVELS, 40.8, 1025.0).exceedance_per_hour.values[:, 0, 0]
    numbers, held = [], []
    for seed in range(40):
        _, slams, _ = panel_record(seed, hours=1.0)
        counted = counted_exceedance(slams, LEVELS).isel(x=0, y=0)
        numbers.append(counted.exceedance_per_hour.values)
        held.append((counted.exceedance_low.values <= exact) & (exact <= counted.exceedance_high.values))
    mean = np.mean(numbers, axis=0)
    busy = exact * 40 > 100
    assert busy.sum() >= 10
    assert np.all(np.abs(mean - exact)[busy] < 4 * np.sqrt(1.5 * exact[busy] / 40))
    np.testing.assert_allclose(mean[:10], exact[:10], rtol=0.03)
    assert np.mean(held) > 0.97


def test_largest_of_some_hours():
    """exp(-hours N): mode at N = 1/hours, risk at -ln(1 - risk)/hours, range of 99 %."""
    moments, found, plate = statistics()
    curve = exponential_exceedance(moments, found, np.linspace(0.0, 3e5, 200), 40.8, 1025.0)
    largest = largest_pressures(curve, 10.0, risk=0.05)
    number = 10 * float(found.slams_per_hour[0, 0])
    scale = 1025 * 40.8 * float(moments.relative_velocity_std[0, 0]) ** 2
    for name, expected in (
        ("most_probable_peak_pressure", 1.0),
        ("extreme_pressure", -np.log(0.95)),
        ("largest_low", -np.log(0.005)),
        ("largest_high", -np.log(0.995)),
    ):
        assert float(largest[name][0, 0]) == pytest.approx(scale * np.log(number / expected), rel=1e-9), name
    direct = largest_peak_pressure(moments, found, plate, PANEL, 1025.0, 10.0)
    assert float(largest.most_probable_peak_pressure[0, 0]) == pytest.approx(float(direct[0, 0]), rel=0.01)


def test_largest_pressures_of_many_draws_are_in_the_range():
    """Largest of so many Poisson slams of exponential pressure, drawn 4000 times."""
    rng = np.random.default_rng(8)
    levels = np.linspace(0.0, 30.0, 300)
    curve = xr.Dataset(
        {"exceedance_per_hour": ("pressure_level", 5.0 * np.exp(-levels))},
        coords={"pressure_level": levels},
        attrs={"method": "made up"},
    )
    found = largest_pressures(curve, 20.0, risk=0.1)
    largest = np.array([rng.exponential(size=max(n, 1)).max() for n in rng.poisson(100.0, 4000)])
    inside = (largest >= float(found.largest_low)) & (largest <= float(found.largest_high))
    assert inside.mean() == pytest.approx(0.99, abs=0.005)
    assert (largest > float(found.extreme_pressure)).mean() == pytest.approx(0.1, abs=0.02)
    counts, edges = np.histogram(largest, bins=30)
    mode = edges[np.argmax(counts)]
    assert float(found.most_probable_peak_pressure) == pytest.approx(mode, abs=0.6)


def test_levels_that_end_too_low_are_told_and_dry_panels_are_zero():
    moments, found, _ = statistics(height=0.8)
    curve = exponential_exceedance(moments, found, np.linspace(0.0, 1e3, 5), 40.8, 1025.0)
    short = largest_pressures(curve, 10.0)
    assert np.isnan(short.extreme_pressure[0, 0])
    assert "end at 1 kPa" in short.attrs["warnings"]
    moments, found, _ = statistics(height=9.0)
    dry = largest_pressures(exponential_exceedance(moments, found, LEVELS, 40.8, 1025.0), 1.0)
    assert float(dry.extreme_pressure.max()) == 0.0
    assert dry.attrs["warnings"] == ""


def test_a_record_without_slams_has_an_upper_band():
    events, slams, plate = panel_record(1)
    none = counted_exceedance(slams.isel(slam=slice(0, 0)), LEVELS)
    assert float(none.exceedance_per_hour.max()) == 0
    np.testing.assert_allclose(none.exceedance_high, -np.log(0.01) / 4)
    none = counted_exceedance(events.isel(event=slice(0, 0)), LEVELS, plate)
    assert float(none.exceedance_per_hour.max()) == 0


def test_what_cannot_be_counted_is_refused():
    moments, found, _ = statistics(velocity="material")
    with pytest.raises(InputError, match="take joint_exceedance"):
        exponential_exceedance(moments, found, LEVELS, 40.8, 1025.0)
    events, slams, _ = panel_record(1)
    with pytest.raises(InputError, match="deck must be given"):
        counted_exceedance(events, LEVELS)
    with pytest.raises(InputError, match="must grow"):
        counted_exceedance(slams, LEVELS[::-1])
    with pytest.raises(InputError, match="at least 2 finite"):
        counted_exceedance(slams, [1.0])
    with pytest.raises(InputError, match="duration of the record"):
        counted_exceedance(slams.drop_attrs(), LEVELS)
    with pytest.raises(InputError, match="coefficient must be"):
        exponential_exceedance(moments, found, LEVELS, -1.0, 1025.0)
    with pytest.raises(InputError, match="risk must be"):
        largest_pressures(counted_exceedance(slams, LEVELS), 1.0, risk=1.0)
