"""Tails: known laws come back, bands hold what they say, and too few slams are told."""

import numpy as np
import pytest
import xarray as xr
from scipy.stats import genpareto

from workbench.errors import InputError
from workbench.slamming.tail_fit import deck_slams, panel_slams, tail_extremes

HOURS, DURATION = 30.0, 3 * 3600.0


def drawn(rng, mean_number, shape):
    number = rng.poisson(mean_number)
    sizes = genpareto.rvs(shape, scale=1e5, size=number, random_state=rng)
    return sizes, rng.uniform(0.0, DURATION, number)


def true_largest(mean_number, shape, per_hour):
    return genpareto.isf(per_hour / (mean_number / 3), shape, scale=1e5)


@pytest.mark.parametrize(
    ("tail", "shape", "mean_number"),
    [("exponential", 0.0, 60), ("exponential", 0.0, 400), ("generalised-pareto", 0.1, 600),
     ("generalised-pareto", -0.2, 600)],
)  # fmt: skip
def test_bands_hold_the_largest_pressure_and_the_estimate_is_unbiased(tail, shape, mean_number):
    rng = np.random.default_rng(5)
    truth = {
        "most_probable": true_largest(mean_number, shape, 1 / HOURS),
        "extreme": true_largest(mean_number, shape, -np.log(0.99) / HOURS),
    }
    held, ratios = [], []
    for _ in range(50):
        found = tail_extremes(*drawn(rng, mean_number, shape), DURATION, HOURS, tail=tail)
        for name, value in truth.items():
            held.append(float(found[f"{name}_low"]) <= value <= float(found[f"{name}_high"]))
        ratios.append(float(found.most_probable_peak_pressure) / truth["most_probable"])
    assert np.mean(held) >= 0.96
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.05 if tail == "exponential" else 0.12)


def test_exponential_tail_in_closed_form():
    """u + mean excess times ln(rate hours)."""
    rng = np.random.default_rng(2)
    pressures, times = drawn(rng, 300, 0.0)
    found = tail_extremes(pressures, times, DURATION, HOURS, tail="exponential", count=50)
    ranked = np.sort(pressures)[::-1]
    expected = ranked[50] + (ranked[:50].mean() - ranked[50]) * np.log(50 / 3 * HOURS)
    assert float(found.most_probable_peak_pressure) == pytest.approx(expected, rel=1e-6)
    assert float(found.tail_rate) == pytest.approx(50 / 3)
    assert float(found.tail_threshold) == ranked[50]


def test_shape_and_scale_of_a_pareto_tail_come_back():
    rng = np.random.default_rng(3)
    found = tail_extremes(
        genpareto.rvs(0.2, scale=1e5, size=2000, random_state=rng), rng.uniform(0, DURATION, 2000),
        DURATION, HOURS, count=1999,
    )  # fmt: skip
    assert float(found.tail_shape) == pytest.approx(0.2, abs=0.06)
    assert float(found.tail_scale) == pytest.approx(1e5, rel=0.06)


def test_slams_in_groups_widen_the_band():
    rng = np.random.default_rng(6)
    sizes = rng.exponential(1e5, 400)
    spread = tail_extremes(sizes, rng.uniform(0, DURATION, 400), DURATION, HOURS, tail="exponential")
    bursts = rng.choice([500.0, 4000.0, 9000.0], 400) + rng.uniform(0, 50.0, 400)
    grouped = tail_extremes(sizes, bursts, DURATION, HOURS, tail="exponential")
    assert float(grouped.most_probable_peak_pressure) == float(spread.most_probable_peak_pressure)
    width = [float(one.most_probable_high / one.most_probable_low) for one in (spread, grouped)]
    assert width[1] > 1.5 * width[0]


@pytest.mark.parametrize(
    ("tail", "number"), [("exponential", 8), ("generalised-pareto", 25), ("exponential", 0)]
)
def test_too_few_slams_are_told(tail, number):
    rng = np.random.default_rng(1)
    found = tail_extremes(
        rng.exponential(1e5, number), rng.uniform(0, 100.0, number), 3600.0, 10.0, tail=tail
    )
    assert np.isnan(float(found.most_probable_peak_pressure))
    assert "Too few slams" in found.attrs["warnings"]
    assert str(number) in found.attrs["warnings"]


def test_far_beyond_the_record_is_told():
    rng = np.random.default_rng(1)
    found = tail_extremes(*drawn(rng, 300, 0.0), DURATION, 1e4, tail="exponential")
    assert "drawn out far beyond" in found.attrs["warnings"]
    found = tail_extremes(*drawn(rng, 300, 0.0), DURATION, 0.001, tail="exponential")
    assert "below the threshold" in found.attrs["warnings"]


def test_slams_of_a_panel_and_of_the_deck():
    pressure = np.zeros((3, 2, 1))
    pressure[0, 0, 0], pressure[1, 0, 0], pressure[1, 1, 0] = 1.0, 2.0, 5.0
    record = xr.Dataset(
        {"slam_panel_pressure": (("slam", "x", "y"), pressure), "slam_start": ("slam", [1.0, 2.0, 3.0])},
        coords={"x": [0.0, 1.0], "y": [0.0]},
    )
    assert [list(one) for one in panel_slams(record, 0.1, 0.0)] == [[1.0, 2.0], [1.0, 2.0]]
    assert [list(one) for one in deck_slams(record)] == [[1.0, 5.0], [1.0, 2.0]]
    entries = xr.Dataset(
        {"event_x": ("event", [0.0, 1.0, 0.0]), "event_y": ("event", np.zeros(3)),
         "peak_pressure": ("event", [7.0, 8.0, 9.0]), "event_time": ("event", [1.0, 2.0, 3.0])}
    )  # fmt: skip
    assert [list(one) for one in panel_slams(entries, 0.0, 0.0)] == [[7.0, 9.0], [1.0, 3.0]]


def test_what_cannot_be_fitted_is_refused():
    with pytest.raises(InputError, match="tail must be one of"):
        tail_extremes(np.ones(3), np.ones(3), 1.0, 1.0, tail="normal")
    with pytest.raises(InputError, match="must be as many"):
        tail_extremes(np.ones(3), np.ones(2), 1.0, 1.0)
    with pytest.raises(InputError, match="hours must be"):
        tail_extremes(np.ones(3), np.ones(3), 1.0, 0.0)
