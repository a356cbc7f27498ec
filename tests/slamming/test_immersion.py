"""Immersions of deck points: closed form in one wave, against a dense record in many, and at the ends of records."""

import numpy as np
import pytest
import xarray as xr

from workbench import quantities
from workbench.errors import InputError
from workbench.slamming.events import entries
from workbench.slamming.immersion import immersion_map, immersions
from workbench.slamming.level_crossings import cubic_zero, peaks
from workbench.time_domain import records


def deck(height, slope=0.0) -> xr.Dataset:
    height = np.atleast_2d(np.asarray(height, float))
    return quantities.dataset(
        {"x": np.arange(height.shape[0], dtype=float), "y": np.arange(height.shape[1], dtype=float)},
        height=(("x", "y"), height),
        slope_x=(("x", "y"), np.full(height.shape, slope)),
        area=(("x", "y"), np.full(height.shape, 0.3)),
    )


def wave(amplitudes, shape=(1, 1)):
    """The same complex amplitudes at every point."""
    amplitudes = np.asarray(amplitudes, complex)
    return np.tile(amplitudes.reshape(-1, 1, 1), (1, *shape))


OMEGA, AMPLITUDE, HEIGHT = 2.0, 1.5, 0.9


@pytest.mark.parametrize("periodic", [True, False])
def test_one_wave_is_closed_form(periodic):
    """r = a cos(omega t - 2): wet for 2 acos(d/a)/omega, to a - d, entering at omega sqrt(a**2 - d**2)."""
    plan = deck(HEIGHT, slope=0.05)
    rise, slope = wave([AMPLITUDE * np.exp(2j)]), wave([0.2 * np.exp(2.5j)])
    period = 2 * np.pi / OMEGA
    found = immersions(rise, slope, [OMEGA], plan, duration=period, periodic=periodic)
    half = np.arccos(HEIGHT / AMPLITUDE)
    entry = (2 - half) / OMEGA
    assert found.sizes["event"] == 1
    assert float(found.event_time[0]) == pytest.approx(entry, abs=1e-5)
    assert float(found.immersion_duration[0]) == pytest.approx(2 * half / OMEGA, abs=2e-5)
    assert float(found.immersion_depth[0]) == pytest.approx(AMPLITUDE - HEIGHT, abs=1e-5)
    assert float(found.time_of_depth[0]) == pytest.approx(2 / OMEGA, abs=1e-4)
    assert float(found.entry_velocity[0]) == pytest.approx(
        OMEGA * np.sqrt(AMPLITUDE**2 - HEIGHT**2), rel=1e-4
    )
    expected = np.arctan(0.2 * np.cos(OMEGA * entry - 2.5) - 0.05)
    assert float(found.entry_angle[0]) == pytest.approx(expected, abs=1e-4)


def test_entries_are_those_of_the_slams_counted():
    rng = np.random.default_rng(7)
    frequency = rng.uniform(0.5, 2.0, 12)
    rise = rng.normal(size=(12, 3, 2)) + 1j * rng.normal(size=(12, 3, 2))
    plan = deck(np.full((3, 2), 2.0))
    counted = entries(rise, 0 * rise, frequency, plan, duration=200.0, time_step=0.04)
    found = immersions(rise, 0 * rise, frequency, plan, duration=200.0, time_step=0.04)
    entered = found.isel(event=np.flatnonzero(~np.isnan(found.entry_velocity.values)))
    inside = entered.event_time.values > 0.04  # before its second sample the other looks at nothing
    assert counted.sizes["event"] > 60
    np.testing.assert_allclose(entered.event_time.values[inside], counted.event_time, atol=1e-4)
    np.testing.assert_allclose(entered.entry_velocity.values[inside], counted.entry_velocity, rtol=2e-3)


@pytest.mark.parametrize("start", [0.0, 37.3])
def test_map_is_that_of_a_dense_record(start):
    rng = np.random.default_rng(1932)
    frequency = rng.uniform(0.5, 2.0, 9)
    rise = rng.normal(size=(9, 4, 3)) + 1j * rng.normal(size=(9, 4, 3))
    height = rng.uniform(-3.0, 6.0, (4, 3))
    plan, duration = deck(height), 150.0
    # blocks of the record are 4096 samples long: this one has three of them
    found = immersions(rise, 0 * rise, frequency, plan, duration=duration, start=start, time_step=0.015)
    chart = immersion_map(found, plan)
    times = start + np.linspace(0, duration, 150_001)
    depth = records(rise.reshape(9, -1), frequency, times) - height.reshape(-1, 1)
    wet = depth >= 0
    first = [times[1:][up][0] if up.any() else np.nan for up in ~wet[:, :-1] & wet[:, 1:]]
    assert 2 <= wet[:, 0].sum() <= 10  # some start in the water, some do not
    expected = {
        "immersion_count": (~wet[:, :-1] & wet[:, 1:]).sum(axis=1),
        "wetted_duration": wet.mean(axis=1) * duration,
        "immersion_depth": np.maximum(depth.max(axis=1), 0.0),
        "starts_in_water": wet[:, 0],
        "ever_wet": wet.any(axis=1),
        "first_entry_time": np.array(first),
    }
    for name, values in expected.items():
        atol = {"wetted_duration": 0.03, "immersion_depth": 1e-4, "first_entry_time": 2e-3}.get(name, 0)
        np.testing.assert_allclose(chart[name].values.ravel(), values, atol=atol, err_msg=name)
    assert float(chart.area.sum()) == pytest.approx(3.6)


@pytest.mark.parametrize("share", [0.3, 0.9])
def test_an_entry_right_after_the_start_is_found(share):
    step, entry = 0.02, (2 - np.arccos(HEIGHT / AMPLITUDE)) / OMEGA
    rise = wave([AMPLITUDE * np.exp(2j)])
    found = immersions(
        rise, 0 * rise, [OMEGA], deck(HEIGHT), duration=0.5, start=entry - share * step, time_step=step
    )
    assert found.sizes["event"] == 1
    assert float(found.event_time[0]) == pytest.approx(entry, abs=1e-5)


def test_a_record_that_ends_before_the_deepest_has_the_depth_of_its_end():
    entry = (2 - np.arccos(HEIGHT / AMPLITUDE)) / OMEGA
    rise = wave([AMPLITUDE * np.exp(2j)])
    found = immersions(rise, 0 * rise, [OMEGA], deck(HEIGHT), duration=entry + 0.1)
    assert float(found.immersion_depth[0]) == pytest.approx(
        AMPLITUDE * np.cos(OMEGA * (entry + 0.1) - 2) - HEIGHT, abs=1e-5
    )
    assert float(found.time_of_depth[0]) == pytest.approx(entry + 0.1)


@pytest.mark.parametrize("start", [0.0, 2.0, 4.0])
def test_longest_and_deepest_are_of_their_own_immersions(start):
    """The longest immersion of three is not the deepest one."""
    plan = deck(0.2)
    rise = wave([-0.5 - 0.5j, 1.4 - 1.9j, 0.4 - 1.3j])
    found = immersions(rise, 0 * rise, [1.0, 2.0, 5.0], plan, duration=2 * np.pi, start=start, periodic=True)
    lasting, depth = found.immersion_duration.values, found.immersion_depth.values
    np.testing.assert_allclose(np.sort(lasting), [0.561, 1.029, 1.759], atol=2e-3)  # of a dense record
    np.testing.assert_allclose(depth[np.argsort(lasting)], [0.6831, 3.0284, 2.9035], atol=1e-4)
    chart = immersion_map(found, plan).isel(x=0, y=0)
    assert int(chart.immersion_count) == 3
    assert float(chart.longest_immersion) == lasting.max()
    assert float(chart.wetted_duration) == pytest.approx(lasting.sum())
    assert float(chart.immersion_depth) == depth.max()
    for name, of_event in (("entry_velocity", "entry_velocity"), ("deepest_entry_time", "event_time")):
        assert float(chart[name]) == found[of_event].values[np.argmax(depth)]
    assert float(chart.first_entry_time) == found.event_time.values.min()


def test_window_of_a_period_wraps():
    """An immersion across the end of the period is one, wherever the window starts."""
    plan, period = deck(HEIGHT), 2 * np.pi / OMEGA
    rise = wave([AMPLITUDE])  # deepest at t = 0
    for start in (0.0, 0.4 * period):
        found = immersions(rise, 0 * rise, [OMEGA], plan, duration=period, start=start, periodic=True)
        assert found.sizes["event"] == 1
        assert float(found.immersion_duration[0]) == pytest.approx(2 * np.arccos(0.6) / OMEGA, abs=2e-5)
    cut = immersions(rise, 0 * rise, [OMEGA], plan, duration=period)
    assert cut.sizes["event"] == 2  # a record that is not periodic starts in the water and ends in it
    assert np.isnan(cut.entry_velocity.values).tolist() == [True, False]
    np.testing.assert_allclose(cut.immersion_duration, np.arccos(0.6) / OMEGA, atol=2e-5)
    np.testing.assert_allclose(cut.immersion_depth, AMPLITUDE - HEIGHT, atol=1e-5)
    chart = immersion_map(cut, plan).isel(x=0, y=0)
    assert (int(chart.immersion_count), bool(chart.starts_in_water), bool(chart.always_wet)) == (
        1,
        True,
        False,
    )


@pytest.mark.parametrize("periodic", [True, False])
def test_dry_and_drowned_points_are_flagged(periodic):
    plan = deck([[2.0, HEIGHT, -2.0]])
    rise = wave([AMPLITUDE * np.exp(2j)], (1, 3))
    period = 2 * np.pi / OMEGA
    chart = immersion_map(
        immersions(rise, 0 * rise, [OMEGA], plan, duration=period, periodic=periodic), plan
    ).isel(x=0)
    assert chart.ever_wet.values.tolist() == [False, True, True]
    assert chart.always_wet.values.tolist() == [False, False, True]
    assert chart.starts_in_water.values.tolist() == [False, False, True]
    assert chart.immersion_count.values.tolist() == [0, 1, 0]
    np.testing.assert_allclose(chart.wetted_duration[[0, 2]], [0.0, period])
    np.testing.assert_allclose(chart.immersion_depth, [0.0, 0.6, 3.5], atol=1e-4)
    for name in ("first_entry_time", "deepest_entry_time", "entry_velocity", "immersion_angle"):
        assert np.isnan(chart[name].values).tolist() == [True, False, True], name


def test_nothing_wet_gives_an_empty_list_and_a_dry_map():
    plan = deck(np.full((2, 2), 9.0))
    found = immersions(wave([1.0], (2, 2)), wave([0.0], (2, 2)), [1.0], plan, duration=10.0)
    assert found.sizes["event"] == 0
    assert not immersion_map(found, plan).ever_wet.any()


def test_peak_and_crossing_of_polynomials_are_exact():
    """Parabola and cubic have the values they were sampled from."""
    t = np.arange(-1.0, 4.0)
    top = peaks(np.atleast_2d(3 - (t - 0.3) ** 2), np.array([[0.0]]))
    assert (int(top.sample[0]) - 1 + top.share[0], top.height[0]) == pytest.approx((0.3, 3.0))
    samples = [(s - 0.4) * (1 + 0.1 * s**2) for s in (-1.0, 0.0, 1.0, 2.0)]
    share, slope = cubic_zero(np.array(samples))
    assert (share, slope) == pytest.approx((0.4, 1 + 0.1 * 0.16))


@pytest.mark.parametrize(
    "given", [{"duration": 0.0}, {"duration": 5.0, "start": -1.0}, {"duration": 5.0, "time_step": 0.0}]
)
def test_bad_records_are_refused(given):
    with pytest.raises(InputError):
        immersions(wave([1.0]), wave([0.0]), [1.0], deck(0.5), **given)
