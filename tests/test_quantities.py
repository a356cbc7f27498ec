import numpy as np
import pytest

from workbench import quantities
from workbench.errors import InputError, checked_choice, checked_number


def test_every_variable_is_labelled():
    made = quantities.dataset(
        {"omega": [1.0]}, method="m", warnings=["a", "b", "a"], added_mass=("omega", [2.0])
    )
    assert made.added_mass.attrs["units"] == "kg, kg m, kg m2"
    assert made.omega.attrs["long_name"] == "wave frequency"
    assert quantities.warnings_of(made) == ("a", "b")
    assert made.attrs["method"] == "m"
    assert quantities.axis_label(made.omega) == r"wave frequency $\omega$ [rad/s]"


def test_names_outside_the_table_cannot_enter_a_result():
    with pytest.raises(KeyError):
        quantities.dataset(wave_height=1.0)


@pytest.mark.parametrize("value", ["2", None, True, float("nan"), float("inf"), np.nan, [1], -1.0, 0.0, 11.0])
def test_numbers_out_of_range_are_refused(value):
    with pytest.raises(InputError, match=r"draught must be a .*number > 0 and <= 10 m.*give it in metres"):
        checked_number("draught", value, "m", above=0, at_most=10, cure="give it in metres")


def test_numbers_in_range_pass():
    assert checked_number("draught", np.float32(2.5), "m", above=0) == 2.5
    assert checked_choice("law", "a", ("a", "b")) == "a"
    with pytest.raises(InputError, match="law must be one of a, b, got 'c'"):
        checked_choice("law", "c", ("a", "b"))
