import numpy as np
import pytest

from workbench.errors import InputError
from workbench.repeating_waves import repetition


def test_two_waves_of_the_source_repeat_nearly():
    found = repetition([9.5, 4.2])
    assert found.cycles == (9, 4)
    assert found.period == pytest.approx(9 * 2 * np.pi / 9.5)
    assert found.mismatch == pytest.approx(1 - 4.2 / (9.5 * 4 / 9), rel=1e-9)
    assert "only nearly" in found.sentence
    assert "-7.6 degrees" in found.sentence  # 360 (4 - 9 4.2/9.5)
    assert repetition([4.163, 7.499]).cycles == (5, 9)


@pytest.mark.parametrize(
    ("frequency", "cycles", "period"),
    [([4.0, 7.0], (4, 7), 2 * np.pi), ([2.0], (1,), np.pi), ([-3.0, 2.0, 1.0], (3, 2, 1), 2 * np.pi)],
)
def test_whole_ratios_are_found_and_leave_nothing_to_say(frequency, cycles, period):
    found = repetition(frequency, tolerance=1e-9)
    assert (found.cycles, found.sentence) == (cycles, "")
    assert found.period == pytest.approx(period)
    for omega, count in zip(frequency, found.cycles, strict=True):
        assert abs(omega) * found.period == pytest.approx(2 * np.pi * count)


def test_waves_that_do_not_repeat_are_refused():
    with pytest.raises(InputError, match="whole ratios within 1e-09 and 200 periods"):
        repetition([1.0, np.sqrt(2)], tolerance=1e-9)
    with pytest.raises(InputError, match="other than 0"):
        repetition([1.0, 0.0])
    with pytest.raises(InputError, match="tolerance"):
        repetition([1.0, 2.0], tolerance=0.0)
