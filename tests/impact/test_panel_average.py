"""Averages over panel and time against closed forms, and k of a panel."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact.entry import entry
from workbench.impact.panel_average import moving_mean, panel_coefficient, panel_history, time_averages
from workbench.impact.section import Parabola, TableSection, Wedge

POD = Wedge(np.pi / 4)


def test_mean_of_a_ramp():
    """The mean of a t over a duration T before t is a (t - T/2); before T it is a t**2/(2 T)."""
    times = np.array([0.0, 0.13, 0.5, 1.0, 2.2, 3.0])
    mean = moving_mean(times, 4 * times, 0.7)
    late = times >= 0.7
    assert mean[late] == pytest.approx(4 * (times[late] - 0.35))
    assert mean[~late] == pytest.approx(4 * times[~late] ** 2 / 1.4)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_largest_mean_of_a_half_sine(share):
    """A half sine of duration D averaged over T: 2 D/(pi T) sin(pi T/(2 D)) of its peak."""
    times = np.linspace(0, 3, 6001)
    pulse = np.where(times < 1, np.sin(np.pi * times), 0.0)
    known = 2 / (np.pi * share) * np.sin(np.pi * share / 2)
    assert moving_mean(times, pulse, share).max() == pytest.approx(known, rel=1e-5)


def test_time_averages_of_an_entry():
    """A panel at the keel of a wedge fills as t: its mean over T is the value T/2 before, and falls with T."""
    times = np.linspace(0.01, 1, 100)
    found = entry(Wedge(0.4), 1.0, "similarity", 1000.0, times, [(0, 50), (0.5, 1.0)])
    means = time_averages(found, 0.2)
    rise = found["panel_pressure"].to_numpy()[-1, 0]
    assert float(means["panel_mean"][-1, 0]) == pytest.approx(0.9 * rise, rel=1e-6)
    assert float(means["panel_largest"][0]) == pytest.approx(0.9 * rise, rel=1e-6)
    largest = [
        float(time_averages(found, duration)["panel_largest"][1]) for duration in (1e-4, 0.05, 0.2, 0.6)
    ]
    assert largest[0] == pytest.approx(float(found["panel_pressure"][:, 1].max()), rel=0.01)
    assert np.all(np.diff(largest) < 0)


def test_refusals():
    found = entry(Wedge(0.4), 1.0, "wagner", 1000.0, [1.0])
    with pytest.raises(InputError, match="give it panels"):
        time_averages(found, 0.1)
    with pytest.raises(InputError, match="duration"):
        time_averages(found, 0.0)
    with pytest.raises(InputError, match="distribution"):
        panel_coefficient(Wedge(0.4), (0, 1), "chuang")
    with pytest.raises(InputError, match="outer edge"):
        panel_history(TableSection(((0.0, 0.0), (1.0, 0.3))), (0, 2))


def test_panel_coefficient_of_wagners_outer_pressure_in_closed_form():
    """The average over 0 to b is V c' (c/b) arcsin(b/c), largest where c = b: k = pi c'/V = (pi**2/2) cot(beta)."""
    assert panel_coefficient(Wedge(0.3), (0, 0.7), "wagner") == pytest.approx(
        np.pi**2 / 2 / np.tan(0.3), rel=1e-4
    )


def test_panel_coefficient_has_no_size_on_a_wedge():
    """A wedge is similar to itself: k is that of any panel with the same ratio of its edges."""
    first, second = (panel_coefficient(POD, (0.1 * b, b), "logvinovich") for b in (0.2, 5.0))
    assert first == pytest.approx(second, rel=1e-9)
    narrow, wide = (panel_coefficient(Parabola(1.0), (0.0, b), "logvinovich") for b in (0.2, 0.4))
    assert narrow > wide


def test_pod_against_its_own_peak():
    """The average is below k at the apex, 2.70, and comes near it once the panel is small in the wetted part."""
    averages = [panel_coefficient(POD, (0.0, 0.2), "similarity", beyond) for beyond in (1.0, 2.0, 20.0)]
    assert averages[1] == pytest.approx(2.38, abs=0.01)
    assert averages[0] < averages[1] < averages[2] < 2.7049
    assert averages[2] > 2.58
