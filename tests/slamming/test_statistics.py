import numpy as np
import pytest
from flat_seas import BAND, deck, flat_band, random_sea

from workbench.conventions import GRAVITY
from workbench.impact.pressure import PressureLaw, peak_pressure
from workbench.slamming import criteria, statistics
from workbench.slamming.events import counts, entries, velocity_classes
from workbench.slamming.extremes import largest_entry_velocity, largest_peak_pressure

FOOT = 0.3048


def test_threshold_velocity_is_ochis_twelve_feet_per_second():
    assert statistics.threshold_velocity(520 * FOOT) == pytest.approx(12 * FOOT, rel=0.005)


@pytest.mark.parametrize(
    ("length", "expected"), [(86.6, 2.711), (15.2, 1.136), (35.0, 1.723), (8.0, 0.824), (120.0, 3.191)]
)
def test_threshold_velocities_of_the_vessels_of_grande(length, expected):
    assert statistics.threshold_velocity(length) == pytest.approx(expected, abs=1e-3)


@pytest.mark.parametrize(("closing_speed", "threshold"), [(0.0, 0.0), (0.0, 0.5), (10.0, 1.2), (-20.0, 0.1)])
def test_closed_form_agrees_with_slams_counted_in_a_random_sea(closing_speed, threshold):
    """At rest, at rest, head seas, overtaking the waves: rate, band and mean entry velocity."""
    relative, energy = flat_band(closing_speed)
    moments = statistics.response_moments(relative, energy)
    plate = deck(1.2)
    expected = statistics.slamming_statistics(moments, plate.height, threshold)
    found = entries(
        *random_sea(closing_speed, 1964), plate, duration=100_000.0, time_step=0.1, threshold=threshold
    )
    counted = counts(found, plate)
    for i in range(2):
        rate = float(expected.slams_per_hour[i, 0])
        low, high = float(counted.counted_band_low[i, 0]), float(counted.counted_band_high[i, 0])
        assert low <= rate <= high
        assert high - low < 0.35 * rate or rate < 10
    at_first = found.event_x.values == 0.0
    assert found.entry_velocity.values[at_first].mean() == pytest.approx(
        float(expected.mean_entry_velocity[0, 0]), rel=0.03
    )


def test_band_holds_the_true_rate_in_99_of_100_seas():
    relative, energy = flat_band()
    plate = deck(1.2)
    rate = statistics.slamming_statistics(statistics.response_moments(relative, energy), plate.height)
    held = []
    for seed in range(100):
        found = counts(
            entries(*random_sea(0.0, seed, components=120), plate, duration=3600.0, time_step=0.2), plate
        )
        inside = (found.counted_band_low <= rate.slams_per_hour) & (
            rate.slams_per_hour <= found.counted_band_high
        )
        held.append(bool(inside[0, 0]))
    assert np.mean(held) >= 0.96


def test_moments_of_a_flat_band_are_closed_form():
    relative, energy = flat_band(closing_speed=5.0, n=4001, slope=0.3)
    moments = statistics.response_moments(relative, energy)
    omega = np.linspace(*BAND, 4001)
    met = omega + omega**2 * 5.0 / GRAVITY
    assert float(moments.relative_motion_std[0, 0]) == pytest.approx(1.0, rel=1e-6)
    assert float(moments.relative_velocity_std[1, 0]) == pytest.approx(
        0.5 * np.sqrt(np.mean(met**2)), rel=1e-3
    )
    assert float(moments.velocity_slope_covariance[0, 0]) == pytest.approx(-0.3 * np.mean(met), rel=1e-3)
    assert float(moments.motion_slope_covariance[0, 0]) == pytest.approx(0, abs=1e-9)


def test_ochis_probability_and_hourly_number():
    """exp(-d**2/(2 m0) - v**2/(2 m2)); 3600/(2 pi) sqrt(m2/m0) times it."""
    relative, energy = flat_band()
    moments = statistics.response_moments(relative, energy)
    found = statistics.slamming_statistics(moments, deck(1.5).height, 0.4)
    m0, m2 = 1.0, float(moments.relative_velocity_std[0, 0]) ** 2
    probability = np.exp(-(1.5**2) / (2 * m0) - 0.4**2 / (2 * m2))
    assert float(found.slamming_probability[0, 0]) == pytest.approx(probability, rel=1e-5)
    assert float(found.slams_per_hour[0, 0]) == pytest.approx(
        3600 / 2 / np.pi * np.sqrt(m2) * probability, rel=1e-5
    )
    assert float(found.slams_per_100_encounters[0, 0]) == pytest.approx(100 * probability, rel=1e-5)


def test_mean_entry_velocity_of_a_truncated_rayleigh():
    relative, energy = flat_band()
    moments = statistics.response_moments(relative, energy)
    deviation = float(moments.relative_velocity_std[0, 0])
    free = statistics.slamming_statistics(moments, deck(1.0).height, 0.0)
    assert float(free.mean_entry_velocity[0, 0]) == pytest.approx(np.sqrt(np.pi / 2) * deviation, rel=1e-6)
    velocity = np.linspace(0.9, 12, 200_001)
    density = velocity / deviation**2 * np.exp(-(velocity**2) / (2 * deviation**2))
    expected = np.trapezoid(velocity * density, velocity) / np.trapezoid(density, velocity)
    cut = statistics.slamming_statistics(moments, deck(1.0).height, 0.9)
    assert float(cut.mean_entry_velocity[0, 0]) == pytest.approx(expected, rel=1e-4)


def test_least_clearance_meets_the_criterion_exactly():
    relative, energy = flat_band()
    moments = statistics.response_moments(relative, energy)
    plate = deck(0.8)
    for threshold in (0.0, 0.3):
        least = criteria.least_clearance(moments, plate.height, 0.8, 20.0, threshold)
        rate = statistics.slamming_statistics(moments, plate.height + (least - 0.8), threshold).slams_per_hour
        assert float(rate.max()) == pytest.approx(20.0, rel=1e-6)
    curve = criteria.clearance_curve(moments, plate.height, 0.8, np.array([0.8, least]), 0.3)
    assert curve.slams_per_hour.values[1] == pytest.approx(20.0, rel=1e-6)
    assert criteria.least_clearance(moments, plate.height, 0.8, 3000.0) == 0.0


def test_largest_entry_velocity_is_the_one_exceeded_once():
    """v = sqrt(2 m2 ln N); N slams, one of them harder ([Ochi 1964], threshold cancels)."""
    relative, energy = flat_band()
    moments = statistics.response_moments(relative, energy)
    found = statistics.slamming_statistics(moments, deck(0.5).height, 0.2)
    velocity = float(largest_entry_velocity(moments, found, 3.0)[0, 0])
    count = 3 * float(found.slams_per_hour[0, 0])
    m2 = float(moments.relative_velocity_std[0, 0]) ** 2
    assert count * np.exp(-(velocity**2 - 0.2**2) / (2 * m2)) == pytest.approx(1.0, rel=1e-6)


def test_largest_pressure_of_a_panel_coefficient_is_closed_form():
    """p = rho k m2 (ln(T/(2 pi) sqrt(m2/m0)) - d**2/(2 m0)) [Ochi 1964]."""
    relative, energy = flat_band()
    moments = statistics.response_moments(relative, energy)
    plate = deck(0.8)
    found = statistics.slamming_statistics(moments, plate.height)
    law = PressureLaw(name="panel", coefficient=40.8)
    pressure = float(largest_peak_pressure(moments, found, plate, law, 1025.0, 10.0)[0, 0])
    m2 = float(moments.relative_velocity_std[0, 0]) ** 2
    expected = 1025 * 40.8 * m2 * (np.log(36_000 / 2 / np.pi * np.sqrt(m2)) - 0.8**2 / 2)
    assert pressure == pytest.approx(expected, rel=0.01)


def test_largest_pressure_with_angles_agrees_with_counted_events():
    """Slope correlated with velocity and random: the closed form against the ordered pressures of a long record."""
    relative, energy = flat_band(slope=0.25)
    moments = statistics.response_moments(relative, energy)
    plate = deck(0.8)
    law = PressureLaw(name="chuang")
    found = statistics.slamming_statistics(moments, plate.height)
    pressures = []
    for seed in range(8):
        rise, slope, met = random_sea(0.0, seed, slope=0.25)
        events = entries(rise, slope, met, plate, duration=100_000.0, time_step=0.1, law=law)
        pressures.append(events.peak_pressure.values[events.event_x.values == 0.0])
    ordered = np.sort(np.concatenate(pressures))[::-1]
    hours = 8 * 100_000 / 3600
    for rank in (30, 300, 3000):
        pressure = float(
            largest_peak_pressure(moments, found, plate, law, 1025.0, hours, exceedance=rank)[0, 0]
        )
        assert pressure == pytest.approx(ordered[rank - 1], rel=0.1), rank


def test_material_entry_velocity_agrees_with_counted_events():
    """Closing velocity less drift over the slope of the water (Grande 2002, 4.18), at its entries."""
    relative, energy = flat_band(slope=0.1)
    moments = statistics.response_moments(relative, energy)
    plate = deck(0.8)
    found = statistics.slamming_statistics(moments, plate.height, velocity="material")
    rise, slope, met = random_sea(0.0, 5, slope=0.1)
    law = PressureLaw(name="panel", coefficient=10.0)
    events = entries(rise, slope, met, plate, duration=200_000.0, time_step=0.1, drift=3.0, law=law)
    first = events.event_x.values == 0.0
    assert float(found.mean_entry_velocity[0, 0]) == pytest.approx(
        events.entry_velocity.values[first].mean(), rel=0.03
    )
    plain = statistics.slamming_statistics(moments, plate.height)
    assert float(found.mean_entry_velocity[0, 0]) > 1.3 * float(plain.mean_entry_velocity[0, 0])
    hours = 200_000 / 3600
    ordered = np.sort(events.peak_pressure.values[first])[::-1]
    expected = largest_peak_pressure(moments, found, plate, law, 1025.0, hours, exceedance=100)
    assert float(expected[0, 0]) == pytest.approx(ordered[99], rel=0.06)


def test_classes_of_velocity_squared_hold_all_slams():
    plate = deck(0.5)
    found = entries(*random_sea(0.0, 3), plate, duration=20_000.0, time_step=0.1)
    classes = velocity_classes(found)
    assert classes.sizes["velocity_class"] == 5
    assert int(classes.class_count.sum()) == found.sizes["event"]
    limits = classes.class_limit.values
    np.testing.assert_allclose(np.diff(limits), limits[0])
    assert limits[-1] == pytest.approx(found.entry_velocity.values.max() ** 2)
    first = np.sum(found.entry_velocity.values**2 <= limits[0])
    assert int(classes.class_count[0]) == first


def test_no_slams_give_an_upper_band_and_no_pressure():
    relative, energy = flat_band()
    plate = deck(9.0)
    moments = statistics.response_moments(relative, energy)
    found = statistics.slamming_statistics(moments, plate.height)
    assert float(largest_peak_pressure(moments, found, plate, PressureLaw(), 1025.0, 1.0).max()) == 0
    events = entries(*random_sea(0.0, 1), plate, duration=3600.0, time_step=0.2)
    assert events.sizes["event"] == 0
    counted = counts(events, plate)
    assert float(counted.counted_band_high[0, 0]) == pytest.approx(-np.log(0.01))


def test_entries_of_a_regular_wave_are_found_to_the_instant():
    """r = a cos(omega t): up-crossing of d at -acos(d/a)/omega, with velocity omega sqrt(a**2 - d**2)."""
    amplitude, omega, height, slope = 1.5, 0.7, 0.9, 0.1
    plate = deck(height)
    rise = np.full((1, 2, 1), amplitude, complex)
    found = entries(rise, 1j * slope * rise, np.array([omega]), plate, duration=100.0, time_step=0.2)
    period = 2 * np.pi / omega
    first = period - np.arccos(height / amplitude) / omega
    times = found.event_time.values[found.event_x.values == 0]
    np.testing.assert_allclose(times, first + period * np.arange(len(times)), atol=1e-4)
    np.testing.assert_allclose(found.entry_velocity, omega * np.sqrt(amplitude**2 - height**2), rtol=1e-3)
    water = slope * amplitude * np.sin(omega * first)
    np.testing.assert_allclose(found.entry_angle, np.arctan(water), atol=2e-3)
    expected = peak_pressure(PressureLaw(), found.entry_velocity.values, found.entry_angle.values, 1025.0)
    np.testing.assert_allclose(found.peak_pressure, expected)


@pytest.mark.parametrize("share", [1e-2, 1e-4, 0.0])
def test_a_calm_is_calm_without_a_warning(share):
    relative, energy = flat_band(slope=0.2)
    moments = statistics.response_moments(relative, energy * share)
    plate = deck(2.0)
    found = statistics.slamming_statistics(moments, plate.height)
    assert float(found.slams_per_hour.max()) < 1e-80
    assert float(largest_peak_pressure(moments, found, plate, PressureLaw(), 1025.0, 1.0).max()) == 0
    assert criteria.least_clearance(moments, plate.height, 2.0, 20.0) == pytest.approx(
        2.3926714 * np.sqrt(share), rel=1e-5
    )
