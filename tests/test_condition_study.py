"""Studies over conditions: files and examples, motions once for each speed, closed form, counting, and the command."""

import csv
import json
import sys

import numpy as np
import pytest
import xarray as xr

from workbench import cli, pipeline, theory_stage
from workbench.condition_runs import condition_rows, slamming_of_conditions
from workbench.condition_study import (
    EXAMPLES,
    ConditionStudy,
    DeckPlace,
    example,
    example_text,
    study_of_text,
)
from workbench.conventions import KNOT
from workbench.errors import InputError
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hulls.library import design
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.impact.pressure import PressureLaw
from workbench.profile_runs import exceedance_of_profile
from workbench.running_state import RunningState
from workbench.sailing import sailing_design
from workbench.sea_energy import wave_energy
from workbench.seas import Condition, SeaState
from workbench.slamming.direct_statistics import direct_statistics
from workbench.slamming.extremes import largest_peak_pressure
from workbench.slamming.operating_profile import OperatingProfile, profile_exceedance
from workbench.slamming.pressure_statistics import largest_pressures
from workbench.slamming.statistics import response_moments

QUICK = StripSettings(stations=21, panels=16, frequencies=12)
SHIP = design("austal-63")
SMALL = """
name = "small"
design = "austal-63"
theory = "strip"
[conditions]
speed_knots = [20, 30]
heading_degrees = [180, 135]
significant_wave_height = [1.0, 4.0]
mean_period = [8]
[slams]
velocity = "{velocity}"
[[places]]
name = "fore deck"
panel = "austal-63 wet deck"
x = [10, 40]
[[places]]
name = "side"
coefficient = 20.0
y = [4.0, 6.7]
"""


def small(velocity="material"):
    return study_of_text(SMALL.format(velocity=velocity))


@pytest.fixture(scope="module")
def found():
    return slamming_of_conditions(SHIP, small(), QUICK, counted=True)


def test_examples_are_the_studies_of_the_source():
    """108 = 2 3 3 6, 84 = 2 7 6, 27 = 3 3 3 conditions (Grande 2002, 5.1, 5.2.1, 5.2.2)."""
    assert [example(name).count for name in EXAMPLES] == [108, 84, 27]
    ferry = example("grande-austal-63")
    assert np.degrees(ferry.wave_directions) == pytest.approx([180 - off for off in (0, 15, 30, 45, 60, 75)])
    assert np.array(ferry.speeds) / KNOT == pytest.approx([20, 30, 40])
    assert (ferry.heights, ferry.periods, ferry.period_kind) == ((3, 4), (8, 10, 12), "mean")
    assert (ferry.hours, ferry.places[0].coefficient) == (1.0, 113.7)
    flying, sailing = example(EXAMPLES[1]), example(EXAMPLES[2])
    assert (min(flying.speeds) / KNOT, max(flying.speeds) / KNOT) == pytest.approx((6, 20))
    assert (flying.periods[0], flying.periods[-1], len(flying.periods)) == (5, 13, 7)
    assert np.degrees(sailing.heels) == pytest.approx([0, -2, -5])
    assert (sailing.heights, sailing.wind_speed, sailing.theory) == ((0.75, 1.5, 2.25), 8.0, "sailing")
    assert [place.coefficient for place in sailing.places] == [2.71, 40.8]
    for name in EXAMPLES:
        assert "Grande" in example(name).source
        design(example(name).design)


def test_motions_are_computed_once_for_each_speed(monkeypatch):
    calls = []
    whole = theory_stage.hydrodynamics

    def watched(*arguments, **more):
        calls.append(arguments[2])
        return whole(*arguments, **more)

    monkeypatch.setattr(theory_stage, "hydrodynamics", watched)
    slamming_of_conditions(SHIP, small(), QUICK)
    assert calls == pytest.approx([20 * KNOT, 30 * KNOT])


def test_every_condition_is_that_of_the_stages(found):
    """Slams, place and largest pressure of one condition by hand from the pipeline."""
    study = small()
    ship = pipeline.response(SHIP, 30 * KNOT, sorted(study.wave_directions), None, QUICK)
    relative = pipeline.deck_response(ship, SHIP.wet_deck, (40, 11))
    condition = Condition(
        speed=30 * KNOT,
        wave_direction=study.wave_directions[1],
        sea_state=SeaState.from_mean_period(4.0, 8.0),
    )
    slam = pipeline.slamming(
        ship, relative, SHIP.wet_deck, condition, law=PressureLaw(name="panel", coefficient=113.7)
    )
    direct = direct_statistics(slam.moments, wet_deck_grid(SHIP.wet_deck, 40, 11).height)
    ahead = direct.slams_per_hour.where((direct.x >= 10) & (direct.x <= 40))
    at = ahead.argmax(("x", "y"))
    one = found.sel(place="fore deck").isel(
        forward_speed=1, wave_direction=1, significant_wave_height=1, period=0
    )
    assert float(one.slams_per_hour) == pytest.approx(float(ahead.max()), rel=1e-9)
    assert float(one.worst_x) == pytest.approx(float(direct.x[at["x"]]))
    assert float(one.mean_entry_velocity) == pytest.approx(float(direct.mean_entry_velocity[at]), rel=1e-9)
    expected = largest_peak_pressure(
        slam.moments, slam.statistics, slam.deck, slam.law, 1025.0, 1.0
    )[at]  # fmt: skip
    assert float(one.most_probable_peak_pressure) == pytest.approx(float(expected), rel=0.05)
    assert float(one.class_per_hour.sum()) == pytest.approx(float(one.slams_per_hour), rel=1e-9)


def test_counted_slams_agree_and_the_places_are_kept(found):
    busy = found.slams_per_hour > 5
    inside = (found.counted_band_low <= found.slams_per_hour) & (
        found.slams_per_hour <= found.counted_band_high
    )
    assert int(busy.sum()) >= 8
    assert bool(inside.where(busy, True).all())
    assert (np.abs(found.worst_y.sel(place="side")) > 4.0).all()
    assert (found.worst_x.sel(place="fore deck") > 10.0).all()
    ratio = (found.counted_mean_velocity / found.mean_entry_velocity).where(found.slams_per_hour > 50)
    assert float(np.abs(ratio - 1).max()) < 0.15
    low = found.isel(significant_wave_height=0)
    assert float(low.is_slamming.max()) == float(low.slams_per_hour.round().max()) == 0.0


def test_closing_velocity_counts_every_crossing(found):
    closing = slamming_of_conditions(SHIP, small("time-derivative"), QUICK)
    high = {"significant_wave_height": 1}
    assert (closing.slams_per_hour.isel(high) > found.slams_per_hour.isel(high)).all()
    assert closing.attrs["velocity"] == "time-derivative"
    largest = closing.most_probable_peak_pressure / found.most_probable_peak_pressure
    assert float(largest.isel(high).min()) != pytest.approx(1.0, abs=1e-3)


def test_a_heeled_ship_has_her_deck_heeled():
    """Sunk with the ship, lower on the side that is down, to port for a heel below 0; the sailing theory."""
    heel, heading, ship = np.radians(-2.0), np.radians(135.0), design("crowther-318")
    sailing = ConditionStudy(
        name="heeled", speeds=(5.0,), heels=(heel,), wave_directions=(heading,), heights=(1.5,), periods=(4.0,),
        theory="sailing", places=(DeckPlace(name="sides", coefficient=10.0, y=(3.0, 5.0)),),
    )  # fmt: skip
    coarse = StripSettings(formulation="heave-only", stations=15, panels=12, frequencies=10)
    found = slamming_of_conditions(ship, sailing, coarse)
    afloat = sailing_design(ship, heel)
    state = RunningState(locked=("surge", "sway", "yaw"))
    response = pipeline.response(afloat, 5.0, [heading], None, coarse, running_state=state)
    deck = wet_deck_grid(ship.wet_deck, 40, 11)
    height = deck.height - afloat.hull.sinkage - deck.y * np.tan(np.radians(2.0))
    relative = pipeline.deck_response(response, ship.wet_deck, (40, 11))
    condition = sailing.condition(5.0, heading, 1.5, 4.0)
    moments = response_moments(relative, wave_energy(condition, relative.omega, relative.wave_direction))
    slams = direct_statistics(moments, height).slams_per_hour
    assert float(found.slams_per_hour.item()) == pytest.approx(
        float(slams.where(np.abs(deck.y) >= 3.0).max()), rel=1e-9
    )
    assert afloat.hull.sinkage != 0.0


def test_exceedance_over_an_operating_profile():
    seas = [SeaState.from_mean_period(height, 8.0) for height in (3.0, 4.0)]
    parts = tuple(Condition(speed=20 * KNOT, wave_direction=np.pi, sea_state=sea) for sea in seas)
    profile = OperatingProfile(name="two seas", shares=(0.2, 0.1), conditions=parts)
    levels = np.linspace(0.0, 1.5e7, 60)
    law = PressureLaw(name="panel", coefficient=40.0)
    curves = exceedance_of_profile(SHIP, profile, levels, law, QUICK, points=(8, 3))
    whole = profile_exceedance(profile, curves)
    expected = 0.2 * curves[0].exceedance_per_hour + 0.1 * curves[1].exceedance_per_hour
    np.testing.assert_allclose(whole.exceedance_per_hour, expected)
    year, hour = (largest_pressures(whole, hours).extreme_pressure.max() for hours in (8760.0, 1.0))
    assert float(year) > 1.5 * float(hour) > 0
    highest = whole.contribution.isel(condition=1, pressure_level=20)
    assert float(highest.max()) > 0.8  # what is seldom and high brings the high pressures


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('name = "small"', "", "must have a name"),
        ("[20, 30]", "20", "speed_knots must be a list of numbers"),
        ("[20, 30]", "[20, 20]", "speeds of the study must be different"),
        ("[180, 135]", "[400]", "heading_degrees must be"),
        ("mean_period = [8]", "", "must have one of peak_period, mean_period, zero_crossing_period, got 0"),
        ("mean_period = [8]", "mean_period = [1]", "steeper waves break"),
        ("mean_period = [8]", "mean_period = [8]\nheel_degrees = [1]", "heel_degrees must be one for each speed, 2"),
        ("mean_period = [8]", "mean_period = [8]\nwind = 3", "key of [conditions] must be one of"),
        ('"{velocity}"', '"fast"', "velocity of the study must be one of"),
        ('"{velocity}"', '"material"\nthreshold = 1.0', "threshold of the study must be 0"),
        ('"{velocity}"', '"material"\nhours = 0', "hours of the study"),
        ("coefficient = 20.0", "", "either a panel or a coefficient"),
        ("coefficient = 20.0", 'panel = "deck"', "panel must be one of"),
        ("coefficient = 20.0", "coefficient = -2", "coefficient of side"),
        ("x = [10, 40]", "x = [40, 10]", "x of fore deck must go from less to more"),
        ("x = [10, 40]", "x = [40]", "x of fore deck must be two numbers"),
        ('name = "side"', 'name = "fore deck"', "places of the study must have different names"),
        ('theory = "strip"', 'theory = "panels"', "theory of the study must be one of"),
        ("[slams]", "[slam]", "key of study must be one of"),
        ("[conditions]", "[conditions", "study file must be TOML"),
    ],
)  # fmt: skip
def test_studies_that_cannot_be_run_are_refused(old, new, words):
    assert old in SMALL
    with pytest.raises(InputError) as refused:
        study_of_text(SMALL.replace(old, new).replace("{velocity}", "material"))
    assert words in str(refused.value)


def test_ships_and_places_that_do_not_fit_are_refused():
    with pytest.raises(InputError, match="cofea has none"):
        slamming_of_conditions(design("cofea"), small(), QUICK)
    far = study_of_text(SMALL.format(velocity="material").replace("[10, 40]", "[60, 70]"))
    with pytest.raises(InputError, match="place fore deck must hold a point"):
        slamming_of_conditions(SHIP, far, QUICK)
    many = SMALL.format(velocity="material").replace("[1.0, 4.0]", str([1 + i / 1000 for i in range(2000)]))
    with pytest.raises(InputError, match="conditions must be 5000 at most, got 8000"):
        study_of_text(many)
    with pytest.raises(InputError, match="example study must be one of"):
        example_text("grande")


def run(capsys, *arguments):
    """Run the command in this process; return exit code, standard output and standard error."""
    code = 0
    sys.argv = ["workbench", "conditions", *map(str, arguments)]
    try:
        cli.main()
    except SystemExit as stop:
        code = stop.code or 0
    captured = capsys.readouterr()
    return code, captured.out, captured.err


@pytest.fixture
def quick_study(tmp_path, monkeypatch):
    """A study file, with the strip theory made quick."""
    monkeypatch.setattr(
        "workbench.hydrodynamics.recommended.RecommendedSettings.of", lambda self, method: QUICK
    )
    path = tmp_path / "small.toml"
    path.write_text(SMALL.format(velocity="material"))
    return path


def test_command_writes_tables_and_figures_and_prints_json(capsys, quick_study, found):
    folder = quick_study.parent
    code, out, err = run(
        capsys, "austal-63", quick_study, "--out", folder / "a.csv", "--figures", folder / "figures", "--json"
    )
    assert code == 0, err
    values = json.loads(out)
    assert len(values["rows"]) == 16
    table = {(line["place"], line["significant_wave_height"]): line for line in values["slamming"]}
    assert table["fore deck", 4.0] == {
        "place": "fore deck", "significant_wave_height": 4.0, "conditions_with_slams": 4, "conditions": 4,
    }  # fmt: skip
    assert table["fore deck", 1.0]["conditions_with_slams"] == 0
    lines = [line for line in (folder / "a.csv").read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    assert len(rows) == 16
    expected = condition_rows(found)[1]
    assert float(rows[1]["slams_per_hour"]) == pytest.approx(expected["slams_per_hour"], rel=1e-5)
    assert rows[1]["heading_degrees"] == "180"
    assert sorted(path.name for path in (folder / "figures").iterdir()) == [
        "fore-deck-hs1.png", "fore-deck-hs4.png", "side-hs1.png", "side-hs4.png",
    ]  # fmt: skip
    code, out, err = run(capsys, "austal-63", quick_study, "--out", folder / "a.nc")
    assert code == 0
    assert "slams in 4 of 4 conditions" in out
    assert "Most slams:" in out
    with xr.open_dataset(folder / "a.nc") as kept:
        np.testing.assert_allclose(kept.slams_per_hour, found.slams_per_hour)


def test_command_refuses_in_one_sentence(capsys, tmp_path):
    for arguments, words in (
        (("austal-63", "grande"), "STUDY must be a TOML file or one of grande-austal-63"),
        (("austal-63", tmp_path / "none.toml"), "STUDY must be a file that can be read"),
        (("austal-63", "grande-austal-63", "--out", "a.txt"), "--out must end in .csv or .nc"),
    ):
        code, out, err = run(capsys, *arguments)
        assert (code, out) == (2, "")
        assert words in err
        assert len(err.strip().splitlines()) == 1
