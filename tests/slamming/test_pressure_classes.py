"""Grande's classes: sums, means and pressures; the closed form against the classes of a long record."""

import numpy as np
import pytest
from flat_seas import deck, flat_band, random_sea

from workbench.errors import InputError
from workbench.impact.pressure import PressureLaw
from workbench.slamming.events import entries
from workbench.slamming.pressure_classes import entries_at, expected_classes, pressure_classes
from workbench.slamming.statistics import response_moments, slamming_statistics

K = 113.7


@pytest.mark.parametrize(("slope", "drift"), [(0.0, 0.0), (0.12, 3.0)])
def test_closed_form_agrees_with_a_long_record(slope, drift):
    relative, energy = flat_band(slope=slope)
    moments, plate = response_moments(relative, energy), deck(0.8)
    kind = "material" if drift else "time-derivative"
    found = slamming_statistics(moments, plate.height, velocity=kind)
    hours = 40.0
    events = entries(
        *random_sea(0.0, 12, slope=slope), plate, duration=3600 * hours, time_step=0.1, drift=drift,
        law=PressureLaw(name="panel", coefficient=K),
    )  # fmt: skip
    first = {"x": [0], "y": [0]}
    expected = expected_classes(
        moments.isel(first), found.isel(first), plate.isel(first), K, 1025.0, hours=hours
    )
    counted = entries_at(events, 0.0, 0.0)
    squares = counted.entry_velocity.values**2
    limits = np.concatenate([[0.0], expected.class_limit.values])
    number, _ = np.histogram(squares[squares > 0], bins=[*limits[:-1], np.inf])
    per_hour = expected.class_per_hour.values
    assert np.all(np.abs(number / hours - per_hour) < 4 * np.sqrt(2 * np.maximum(per_hour, 0.05) / hours))
    mean = counted.entry_velocity.values[squares > 0].mean()
    assert float(expected.mean_entry_velocity) == pytest.approx(mean, rel=0.03)
    assert float(expected.slams_per_hour) == pytest.approx((squares > 0).sum() / hours, rel=0.05)
    of_class = counted.entry_velocity.values[(squares > 0) & (squares <= limits[1])].mean()
    assert float(expected.class_mean_velocity[0]) == pytest.approx(of_class, rel=0.03)


def test_classes_of_a_record_by_hand():
    plate = deck(0.5)
    events = entries(*random_sea(0.0, 3), plate, duration=20_000.0, time_step=0.1)
    one = entries_at(events, 0.0, 0.0)
    classes = pressure_classes(one, K, 1025.0)
    velocity = one.entry_velocity.values
    top = velocity.max() ** 2
    chosen = velocity[(velocity**2 >= 0.2 * top) & (velocity**2 < 0.4 * top)]
    second = classes.isel(velocity_class=1)
    assert int(second.class_count) == len(chosen)
    assert float(second.class_per_hour) == pytest.approx(len(chosen) / (20_000 / 3600))
    assert float(second.class_mean_velocity) == pytest.approx(chosen.mean())
    assert float(second.class_pressure) == pytest.approx(1025 * K * np.mean(chosen**2) / 2)
    assert float(classes.mean_entry_velocity) == pytest.approx(velocity.mean())
    assert float(classes.slams_per_hour) == pytest.approx(len(velocity) / (20_000 / 3600))
    weighed = float((classes.class_pressure * classes.class_count).sum() / classes.class_count.sum())
    assert weighed == pytest.approx(1025 * K * np.mean(velocity**2) / 2)


def test_exponential_law_of_the_classes():
    """Share of a class exp(-v1**2/(2 m2)) - exp(-v2**2/(2 m2)), its five limits up to the most probable largest."""
    relative, energy = flat_band()
    moments, plate = response_moments(relative, energy), deck(0.8)
    found = slamming_statistics(moments, plate.height)
    first = {"x": [0], "y": [0]}
    classes = expected_classes(moments.isel(first), found.isel(first), plate.isel(first), K, 1025.0)
    m2, number = float(moments.relative_velocity_std[0, 0]) ** 2, float(found.slams_per_hour[0, 0])
    limits = np.concatenate([[0.0], classes.class_limit.values])
    above = number * np.exp(-(limits**1) / (2 * m2))
    above[-1] = 0.0
    np.testing.assert_allclose(classes.class_per_hour, above[:-1] - above[1:], rtol=2e-3)
    assert limits[-1] == pytest.approx(2 * m2 * np.log(number), rel=0.01)
    assert float(classes.most_probable_peak_pressure) == pytest.approx(1025 * K * limits[-1] / 2)


def test_no_slams_no_classes():
    plate = deck(9.0)
    none = entries(*random_sea(0.0, 3), plate, duration=3600.0, time_step=0.1)
    classes = pressure_classes(none, K, 1025.0)
    assert float(classes.slams_per_hour) == float(classes.mean_entry_velocity) == 0.0
    relative, energy = flat_band()
    moments = response_moments(relative, energy)
    found = slamming_statistics(moments, plate.height)
    first = {"x": [0], "y": [0]}
    expected = expected_classes(moments.isel(first), found.isel(first), plate.isel(first), K, 1025.0)
    assert float(expected.slams_per_hour) == pytest.approx(0.0, abs=1e-9)
    assert float(expected.most_probable_peak_pressure) == 0.0
    with pytest.raises(InputError, match="classes are those of one point"):
        expected_classes(moments, found, plate, K, 1025.0)
    with pytest.raises(InputError, match="coefficient must be"):
        pressure_classes(none, 0.0, 1025.0)
