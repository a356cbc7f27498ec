import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact import chuang, wagner
from workbench.impact.pressure import PressureLaw, peak_pressure

PSI, FOOT, SLUG_PER_CUBIC_FOOT = 6894.757, 0.3048, 515.3788


def test_panel_pressures_of_the_source():
    """Grande 2002, 7.1.1: k = 113.7 at 4 m/s gives 932 kPa; pod 22.2, main beam 334.6 kPa (rho 1025)."""
    for name, expected in (
        ("austal-63 wet deck", 932.34),
        ("crowther-318 pod", 22.22),
        ("crowther-318 main beam", 334.56),
    ):
        k = wagner.PANEL_COEFFICIENTS[name]
        assert wagner.impact_pressure(4.0, k, 1025.0) / 1e3 == pytest.approx(expected, abs=0.01)


def test_wagners_wedge_coefficients():
    """k(45) = pi**2/4; wedges of the same k as the source's panels (8.38 and 13.82 degrees)."""
    assert wagner.impact_coefficient(np.radians(45)) == pytest.approx(2.4674, abs=1e-4)
    assert wagner.impact_coefficient(np.radians(8.38)) == pytest.approx(113.7, rel=2e-3)
    assert wagner.impact_coefficient(np.radians(-13.82)) == pytest.approx(40.8, rel=2e-3)


def test_wagner_stops_at_the_air_cushion():
    assert wagner.impact_coefficient(0.0) == wagner.impact_coefficient(np.radians(3.0))
    assert wagner.impact_coefficient(np.radians(4)) < wagner.impact_coefficient(0.0)


@pytest.mark.parametrize(
    ("degrees", "program", "text"),
    [
        (0, 0.500000, 0.320000), (0.28, 0.547091, 0.365360), (1, 0.668182, 0.515000), (1.53, 0.757318, 0.655516),
        (2, 0.836364, 0.801666), (2.2, 0.870001, 0.870001), (5, 0.377084, 0.377084), (9.45, 0.175184, 0.175184),
        (11, 0.143337, 0.143337), (15, 0.082496, 0.082496), (20, 0.052373, 0.052373), (25, 0.032950, 0.032950),
        (45, 0.009253, 0.009253),
    ],
)  # fmt: skip
def test_chuangs_k(degrees, program, text):
    assert chuang.impact_coefficient(np.radians(degrees)) == pytest.approx(program, abs=1e-6)
    assert chuang.impact_coefficient(-np.radians(degrees)) == pytest.approx(program, abs=1e-6)
    assert chuang.impact_coefficient(np.radians(degrees), "text") == pytest.approx(text, abs=1e-6)


def us(heave, wave, pitch_velocity, pitch, slope, recorded, rho=1.94, roll=0.0):
    method = chuang.method_one(
        heave * FOOT, wave * FOOT, pitch_velocity * FOOT, np.radians(pitch), np.radians(slope),
        rho * SLUG_PER_CUBIC_FOOT, np.radians(roll),
    )  # fmt: skip
    back = chuang.back_calculated_coefficient(recorded * PSI, method, rho * SLUG_PER_CUBIC_FOOT)
    return method, float(back)


def test_method_one_reproduces_run_9():
    """NSRDC 4653 run 9, case I, by the source's program: V_n 3.727 ft/s, 4.72 psi, back-calculated k 0.126."""
    method, back = us(1.73, 0.0, 1.97, -9.45, 0.0, 3.41)
    assert float(method.normal_velocity) / FOOT == pytest.approx(3.72710, abs=1e-5)
    assert abs(float(method.tangential_velocity)) / FOOT == pytest.approx(0.60364, abs=1e-5)
    assert float(method.coefficient) == pytest.approx(0.17518, abs=1e-5)
    assert float(method.total_pressure) / PSI == pytest.approx(4.72352, rel=2e-4)
    assert back == pytest.approx(0.12644, rel=5e-4)


@pytest.mark.parametrize(
    ("inputs", "pressure", "back"),
    [
        ((1.98, 1.06, 0.71, -6.54, -5.01, 3.47), 3.97459, 0.66117),
        ((3.231, -1.176, 1.33, -11.01, 5.174, 6.937), 4.50379, 0.11225),
        ((3.83, -1.59, 0.93, -14.7, 6.96, 3.34), 3.2746, 0.04531),
        ((3.01, 3.52, 8.8, -5.52, -3.17, 95.0, 1.99, 4.0), 56.608, 0.68592),
        ((0.0, 0.0, 20.6, -8.0, 0.0, 150.0, 1.99, 3.24), 170.868, 0.17467),
    ],
)
def test_method_one_in_every_branch_and_at_full_scale(inputs, pressure, back):
    method, found = us(*inputs)
    assert float(method.total_pressure) / PSI == pytest.approx(pressure, rel=3e-4)
    assert found == pytest.approx(back, rel=5e-4)


def test_peak_pressure_resolves_the_velocity_on_the_water():
    angle = np.radians(12.0)
    expected = 144 * chuang.impact_coefficient(angle) * 1025 * (3 * np.cos(angle)) ** 2
    expected += 1025 * (3 * np.sin(angle)) ** 2 / 2
    assert peak_pressure(PressureLaw(), 3.0, angle, 1025.0) == pytest.approx(expected)
    assert peak_pressure(PressureLaw(), 3.0, -angle, 1025.0) == pytest.approx(expected)
    assert peak_pressure(
        PressureLaw(name="panel", coefficient=113.7), 4.0, [0.0, 0.1], 1025.0
    ) == pytest.approx([932_340, 932_340])


@pytest.mark.parametrize(
    "given", [{"name": "slender"}, {"name": "panel"}, {"name": "panel", "coefficient": -1}]
)
def test_bad_laws_are_refused(given):
    with pytest.raises(InputError):
        PressureLaw(**given)
