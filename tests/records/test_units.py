import pytest

from workbench.records.units import split_label


@pytest.mark.parametrize(
    ("label", "name", "unit"),
    [
        ("pitch_rad", "pitch", "rad"),
        ("relative_motion_1_m", "relative_motion_1", "m"),
        ("time_s", "time", "s"),
        ("pitch [deg]", "pitch", "deg"),
        ("alarms", "alarms", ""),
        ("bow_accelerometer", "bow_accelerometer", ""),
    ],
)
def test_units_stand_in_brackets_or_at_the_end_of_the_name(label, name, unit):
    assert split_label(label) == (name, unit)
