import numpy as np
import pytest

from workbench import quantities
from workbench.errors import InputError
from workbench.wet_deck_pressure.strain_impulse import (
    effective_duration,
    scaled_impulse,
    strain_impulse,
    strain_integral,
)


def test_integral_is_the_trapezium_rule():
    assert strain_integral([0.0, 2e-4, 1e-4], 0.01) == pytest.approx(0.01 * 2.5e-4)
    exact = 300e-6 * 2 * 0.76 / np.pi
    fine = strain_integral(300e-6 * np.sin(np.linspace(0, np.pi, 7601)), 1e-4)
    assert fine == pytest.approx(exact, rel=1e-6)


def test_impulse_of_a_known_load_comes_back():
    """A load F over a time at a lever x bends by F x, strains by F x/EZ."""
    load, lever, stiffness = 2e7, 40.0, 1.3e11
    strain = np.full(51, load * lever / stiffness)
    found = strain_impulse(strain_integral(strain, 0.01), stiffness, lever)
    assert float(found.slam_impulse) == pytest.approx(load * 0.5)
    assert effective_duration(float(found.slam_impulse), load) == pytest.approx(0.5)
    assert "provisional" in found.attrs["warnings"]
    assert len(quantities.warnings_of(found)) == 1


@pytest.mark.parametrize(("lever", "words"), [(3.5, "changes the impulse by 17 %"), (-4.9, "means nothing")])
def test_short_and_negative_levers_are_warned_of(lever, words):
    assert any(words in note for note in quantities.warnings_of(strain_impulse(1e-4, 1e11, lever)))


def test_impulse_goes_with_speed_volume_and_density():
    assert scaled_impulse(5.0, 6.0, 40.0) == pytest.approx(5 * 6 * 64000)
    assert scaled_impulse(5.0, 6.0, 40.0, 1.025) == pytest.approx(1.025 * 5 * 6 * 64000)
    assert scaled_impulse(1.0, np.sqrt(9.0), 9.0) == pytest.approx(9.0**3.5)  # by Froude's law


@pytest.mark.parametrize(
    "call",
    [
        lambda: strain_integral([100.0, 200.0]),
        lambda: strain_integral([1e-4]),
        lambda: strain_integral([1e-4, np.nan]),
        lambda: strain_impulse(1e-4, 1e11, 0.0),
        lambda: strain_impulse(1e-4, 0.0, 10.0),
        lambda: scaled_impulse(1.0, 0.0, 10.0),
        lambda: effective_duration(1.0, 0.0),
    ],
)
def test_bad_inputs_are_refused(call):
    with pytest.raises(InputError):
        call()
