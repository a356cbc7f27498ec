"""Weighing by time: sums by hand, the lifetime extreme against a mixture drawn at random, scatter diagrams, files."""

import numpy as np
import pytest
import xarray as xr

from workbench.conventions import KNOT
from workbench.errors import InputError
from workbench.sea_scatter import ScatterDiagram, scatter_diagram, scatter_of_text
from workbench.seas import Condition, SeaState
from workbench.slamming.operating_profile import (
    OperatingProfile,
    profile_exceedance,
    profile_of_scatter,
    profile_of_text,
    weighted_slams,
)
from workbench.slamming.pressure_statistics import largest_pressures

LEVELS = np.linspace(0.0, 40.0, 401)


def condition(height=2.0, speed=10.0, direction=np.pi):
    sea = SeaState(significant_wave_height=height, peak_period=9.0)
    return Condition(speed=speed, wave_direction=direction, sea_state=sea)


def profile(*shares):
    return OperatingProfile(
        name="made up", shares=shares, conditions=tuple(condition(2.0 + i) for i in range(len(shares)))
    )


def curve(rate, scale, half=None):
    number = rate * np.exp(-LEVELS / scale)[:, None, None] * np.array([1.0, 0.5])[None, :, None]
    dims = ("pressure_level", "x", "y")
    made = xr.Dataset(
        {"exceedance_per_hour": (dims, number)},
        coords={"pressure_level": LEVELS, "x": [0.0, 1.0], "y": [0.0]},
        attrs={"method": "made up", "warnings": f"scale {scale}"},
    )
    if half is not None:
        made["exceedance_low"], made["exceedance_high"] = (
            (dims, np.maximum(number - half, 0.0)), (dims, number + half)
        )  # fmt: skip
    return made


def test_rates_are_weighed_by_their_time():
    rates = xr.DataArray([[10.0, 1.0], [40.0, 0.0]], dims=("condition", "x"), coords={"x": [0.0, 1.0]})
    found = weighted_slams(profile(0.6, 0.1), rates)
    np.testing.assert_allclose(found.slams_per_hour, [10.0, 0.6])
    np.testing.assert_allclose(found.contribution, [[0.6, 1.0], [0.4, 0.0]])
    assert found.attrs["quiet_share"] == pytest.approx(0.3)
    none = weighted_slams(profile(0.5), xr.DataArray([0.0], dims="condition"))
    assert float(none.slams_per_hour) == float(none.contribution[0]) == 0.0


def test_exceedance_over_a_profile_and_who_brings_it():
    made = profile_exceedance(profile(0.9, 0.1), [curve(20.0, 1.0), curve(60.0, 4.0)])
    at = made.isel(x=0, y=0).sel(pressure_level=8.0)
    parts = 0.9 * 20 * np.exp(-8.0), 0.1 * 60 * np.exp(-2.0)
    assert float(at.exceedance_per_hour) == pytest.approx(sum(parts))
    assert float(at.contribution[1]) == pytest.approx(parts[1] / sum(parts))
    assert float(made.contribution.sum("condition").min()) == pytest.approx(1.0)
    np.testing.assert_allclose(made.significant_wave_height, [2.0, 3.0])
    assert made.attrs["warnings"] == "scale 1.0\nscale 4.0"


def test_lifetime_extreme_is_that_of_a_mixture_drawn_at_random():
    """Hours split over two conditions, Poisson slams of exponential pressure in each, the largest of all."""
    hours = 300.0
    found = largest_pressures(
        profile_exceedance(profile(0.7, 0.1), [curve(20.0, 1.0), curve(6.0, 2.5)]), hours, risk=0.2
    ).isel(x=0, y=0)
    rng = np.random.default_rng(4)
    largest = []
    for _ in range(3000):
        sizes = [
            rng.exponential(scale, max(rng.poisson(share * hours * rate), 1)).max()
            for share, rate, scale in ((0.7, 20.0, 1.0), (0.1, 6.0, 2.5))
        ]
        largest.append(max(sizes))
    largest = np.array(largest)
    assert np.mean(largest > float(found.extreme_pressure)) == pytest.approx(0.2, abs=0.025)
    inside = (largest > float(found.largest_low)) & (largest < float(found.largest_high))
    assert inside.mean() == pytest.approx(0.99, abs=0.006)


def test_bands_of_independent_records_add_in_squares():
    made = profile_exceedance(profile(0.5, 0.5), [curve(20.0, 2.0, 3.0), curve(30.0, 2.0, 4.0)])
    first = made.isel(pressure_level=0, x=0, y=0)
    assert float(first.exceedance_high) == pytest.approx(25.0 + 2.5)
    assert float(first.exceedance_low) == pytest.approx(25.0 - 2.5)
    assert float(made.exceedance_low.min()) >= 0.0
    mixed = profile_exceedance(profile(0.5, 0.5), [curve(20.0, 2.0, 3.0), curve(30.0, 2.0)])
    assert "exceedance_low" not in mixed


def test_north_atlantic():
    """Means of the table, and its sum (IACS Rec. 34 Rev. 1: 3.407 m, 8.862 s)."""
    diagram = scatter_diagram("north-atlantic")
    assert diagram.mean_height == pytest.approx(3.407, abs=5e-4)
    assert diagram.shares.sum(axis=0) @ np.array(diagram.periods) == pytest.approx(8.862, abs=5e-4)
    assert np.sum(diagram.occurrences) == pytest.approx(100_000.0, abs=0.05)
    assert "Recommendation No. 34" in diagram.source
    share, sea = diagram.seas()[0]
    assert (share, sea.significant_wave_height) == (pytest.approx(1.3e-5), 0.5)
    assert sea.peak_period == pytest.approx(3.5 * 1.408, rel=1e-3)


def test_profile_of_a_scatter_diagram():
    diagram = scatter_of_text(
        "# seas\nHs,6,8\n1,30,10\n3,5,45\n6,,10\n", name="bay", period_kind="mean", source="made up"
    )
    made = profile_of_scatter(
        diagram,
        {np.pi: 0.75, np.pi / 2: 0.25},
        [(2.0, 18.0), (4.0, 9.0)],
        share_at_sea=0.5,
        spectrum="jonswap",
    )
    assert len(made.shares) == 8
    assert sum(made.shares) == pytest.approx(0.5 * 0.9)
    assert made.quiet_share == pytest.approx(0.55)
    assert made.speeds == (9.0, 18.0)
    first = made.conditions[0]
    assert (first.speed, first.wave_direction, first.sea_state.spectrum) == (18.0, np.pi, "jonswap")
    assert made.shares[0] == pytest.approx(0.5 * 0.3 * 0.75)
    assert all(
        one.speed == (18.0 if one.sea_state.significant_wave_height < 2 else 9.0) for one in made.conditions
    )


def test_profile_of_a_file():
    text = (
        "# ferry\nshare,speed_knots,heading_degrees,significant_wave_height,mean_period\n"
        "0.25, 30, 180, 2.0, 7\n0.5,20,90,3.0,8\n"
    )
    made = profile_of_text(text, name="ferry")
    assert made.shares == (0.25, 0.5)
    assert made.conditions[0].speed == pytest.approx(30 * KNOT)
    assert made.conditions[1].wave_direction == pytest.approx(np.pi / 2)
    assert made.conditions[1].sea_state == SeaState.from_mean_period(3.0, 8.0)


HEAD = "share,speed_knots,heading_degrees,significant_wave_height,peak_period\n"


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: profile(0.7, 0.4), "sum to 1 at most, got 1.1"),
        (lambda: profile(0.7, 0.0), "share of the time must be a finite number > 0"),
        (lambda: OperatingProfile(name="a", shares=(0.5,), conditions=()), "a share for each of its conditions"),
        (lambda: OperatingProfile(name="a", shares=(0.5,), conditions=(1,)), "of the class Condition"),
        (lambda: profile_of_text("share,speed\n1,2\n"), "must have the columns share, speed_knots"),
        (lambda: profile_of_text(""), "got nothing"),
        (lambda: profile_of_text(HEAD + "0.5,20,180,x,9\n"), "significant_wave_height of row 1 must be a number"),
        (lambda: profile_of_text(HEAD + "0.5,20,400,2,9\n"), "heading_degrees of row 1"),
        (lambda: scatter_of_text("Hs,6\n1,a\n", name="b"), "scatter diagram must be numbers"),
        (lambda: scatter_of_text("Hs,6,8\n1,2\n", name="b"), "1 rows of 2 numbers"),
        (lambda: scatter_of_text("Hs,6\n1,0\n", name="b"), "an occurrence above 0"),
        (lambda: scatter_of_text("Hs,8,6\n1,0,1\n", name="b"), "periods of the scatter diagram must grow"),
        (lambda: scatter_diagram("nowhere"), "scatter diagram must be one of north-atlantic"),
        (
            lambda: profile_of_scatter(scatter_diagram("north-atlantic"), {np.pi: 0.5}, [(9.0, 5.0)]),
            "sum of the shares of headings",
        ),
        (
            lambda: profile_of_scatter(scatter_diagram("north-atlantic"), {np.pi: 1.0}, [(0.2, 5.0)]),
            "speeds must reach the lowest sea of the diagram, 0.5 m, got 0.2 m",
        ),
        (lambda: profile_exceedance(profile(0.5, 0.5), [curve(1.0, 1.0)]), "one for each condition, 2, got 1"),
        (
            lambda: profile_exceedance(profile(0.5, 0.5), [curve(1.0, 1.0), curve(1.0, 1.0).isel(x=[0])]),
            "same x",
        ),
        (
            lambda: weighted_slams(profile(0.5, 0.5), xr.DataArray([1.0], dims="condition")),
            "for each condition of the profile, 2, got 1",
        ),
        (lambda: ScatterDiagram(name="a", heights=(1.0,), periods=(6.0,), occurrences=((-1.0,),)), "occurrences"),
    ],
)  # fmt: skip
def test_what_cannot_be_weighed_is_refused(make, words):
    with pytest.raises(InputError, match=words):
        make()
