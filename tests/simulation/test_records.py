"""Records as a user has them: linear ones, points and slams, files, and what is refused."""

import json
import sys
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from workbench import cli, designs, pipeline, simulate_command, simulation_files, simulation_stage
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.relative_motion import relative_motion
from workbench.running_state import RunningState
from workbench.seas import Condition, SeaState
from workbench.simulate_command import points_of
from workbench.simulation.records import ShipInWaves, simulation
from workbench.simulation_stage import one_theory, simulated_regular_wave, simulated_sea
from workbench.slamming import events
from workbench.time_domain import Realisation, components_from, relative_amplitudes, wave_components

STEP = 0.0111
POINTS = ((0.9, 0.0), (0.9, 0.1), (0.0, 2.0))
SEA = SeaState(significant_wave_height=0.1, peak_period=1.6)


@pytest.fixture(scope="module")
def waves(ship):
    condition = Condition(speed=ship.motions.attrs["speed"], wave_direction=np.pi, sea_state=SEA)
    return wave_components(condition, Realisation(components=60), 1.5, 8.0)


@pytest.fixture(scope="module")
def linear(ship, waves):
    return simulation(ship, waves, 120.0, STEP, forces="linear", points=POINTS)


@pytest.fixture(scope="module")
def non_linear(ship, waves):
    return simulation(ship, waves, 30.0, STEP, points=POINTS, panels=400)


def respond(design, speed):
    return lambda directions, omega: pipeline.response(
        design, speed, directions, omega, PotentialFlowSettings()
    )


def test_linear_records_have_the_spectral_deviations(ship, waves, linear):
    amplitude = waves.component_amplitude.values
    assert float(linear.elevation.std()) == pytest.approx(np.sqrt(np.sum(amplitude**2) / 2), rel=0.03)
    assert set(linear.data_vars) >= {"motion", "elevation", "relative_motion_history"}
    assert "linear_motion" not in linear
    for name in ("motion", "elevation", "relative_motion_history", "slam_count"):
        assert linear[name].attrs["units"]
        assert linear[name].attrs["long_name"]


def test_slams_of_linear_records_are_those_that_are_counted_on_the_deck(ship, waves, linear):
    relative = relative_motion(ship.motions, xr.Dataset(coords={"x": [0.9], "y": [0.0]}))
    rise, slope = relative_amplitudes(waves, ship.motions, relative)
    grid = xr.Dataset(
        {"height": (("x", "y"), linear.deck_height.values[:1, None]), "slope_x": (("x", "y"), [[0.0]])},
        coords={"x": [0.9], "y": [0.0]},
    )
    counted = events.entries(
        rise, slope, waves.component_frequency.values, grid, duration=120.0, time_step=STEP, density=1000.0
    )
    assert counted.sizes["event"] > 3
    assert int(linear.slam_count[0]) == pytest.approx(counted.sizes["event"], abs=1)


@pytest.mark.parametrize("step", [0.011180339887498949, 0.0111, 0.01])
def test_every_step_has_its_record(ship, waves, step):
    """Whatever the rounding of the last time."""
    for samples in (97, 161, 322, 643):
        found = simulation(ship, waves, samples * step, step, forces="linear")
        assert found.sizes["time"] == found.motion.shape[0] == len(found.elevation)
    duration = 36.0
    assert simulation(ship, waves, duration, step, forces="linear").time[-1] >= duration - 1e-9


def test_points_off_the_deck_have_no_slams(linear):
    assert int(linear.slam_count[2]) == -1
    assert np.isnan(linear.deck_height[2])
    assert simulation_files.summary(linear)["points"][2]["slams"] is None


def test_relative_motion_is_water_less_point(ship, waves, non_linear):
    """At the point itself: incident wave less the height of the point, by rotations of any size."""
    x, y = POINTS[1]
    centre = np.array(ship.design.masses.centre_of_gravity)
    motion, times = non_linear.motion.values, non_linear.time.values
    k = waves.component_kx.values * x + waves.component_ky.values * y
    angle = k - np.multiply.outer(times, waves.component_frequency.values) + waves.component_phase.values
    wave = np.cos(angle) @ waves.component_amplitude.values
    roll, pitch = motion[:, 3], motion[:, 4]
    up = (
        motion[:, 2] + centre[2] - np.sin(pitch) * (x - centre[0])
        + np.cos(pitch) * (np.sin(roll) * (y - centre[1]) - np.cos(roll) * centre[2])
    )  # fmt: skip
    size = float(non_linear.relative_motion_history.std())
    np.testing.assert_allclose(non_linear.relative_motion_history.values[:, 1], wave - up, atol=0.02 * size)


def test_same_seed_gives_the_same_records(ship):
    design, speed = ship.design, float(ship.motions.attrs["speed"])
    condition = Condition(speed=speed, wave_direction=np.pi, sea_state=SEA)
    made = [
        simulated_sea(
            design, condition, Realisation(seed=seed, hours=0.002, components=40), respond(design, speed)
        )
        for seed in (1, 1, 2)
    ]
    np.testing.assert_array_equal(made[0].motion, made[1].motion)
    assert not np.allclose(made[0].motion, made[2].motion)
    assert made[0].attrs["seed"] == 1
    assert "Hs 0.1 m" in made[0].attrs["waves"]


def test_records_obey_froudes_law(twin):
    """A ship of twice the size in waves of twice the size moves alike, slower by the root of two."""
    found = []
    for scale in (1.0, 2.0):
        design = twin if scale == 1 else twin.scaled(scale)
        omega = np.linspace(0.4, 1.6, 8) / np.sqrt(scale)
        speed = 5.0 * np.sqrt(scale)
        response = pipeline.response(
            design, speed, [np.pi / 2, np.pi], omega, PotentialFlowSettings(panels=200)
        )
        own = ShipInWaves(design, response.hydrodynamics, response.motions)
        waves = components_from(1.0 / np.sqrt(scale), 0.7 * scale, 0.0, np.pi, speed)
        records = simulation(own, waves, 12.0 * np.sqrt(scale), 0.05 * np.sqrt(scale), panels=300)
        found.append(records.motion.values / [scale, scale, scale, 1, 1, 1])
    size = np.abs(found[0]).max(axis=0)
    for mode in (2, 4):
        np.testing.assert_allclose(found[1][:, mode] / size[mode], found[0][:, mode] / size[mode], atol=2e-3)


def test_following_seas_take_the_waves_that_overtake_the_ship():
    design = designs.named_design("delft-372")
    speed = 0.3 * float(np.sqrt(GRAVITY * design.hull.length))
    condition = Condition(speed=speed, wave_direction=np.radians(30), sea_state=replace(SEA, peak_period=2.5))
    found = simulated_sea(
        design, condition, Realisation(hours=0.002), respond(design, speed), forces="linear"
    )
    assert np.isfinite(found.motion).all()
    assert "is left out" in found.attrs["warnings"]


def test_files_hold_what_was_simulated(tmp_path, non_linear):
    path = simulation_files.write_records(non_linear, tmp_path / "records.csv")
    table = pd.read_csv(path, comment="#")
    np.testing.assert_allclose(table["pitch_rad"], non_linear.motion.sel(dof="pitch"), rtol=1e-5, atol=1e-9)
    np.testing.assert_allclose(
        table["relative_motion_2_m"], non_linear.relative_motion_history[:, 1], rtol=1e-5
    )
    assert path.read_text().startswith("# design: delft-372")
    path = simulation_files.write_records(non_linear, tmp_path / "records.nc")
    with xr.open_dataset(path) as stored:
        np.testing.assert_array_equal(stored.motion, non_linear.motion)
        assert stored.attrs["method"] == non_linear.attrs["method"]
    json.dumps(simulation_files.summary(non_linear), allow_nan=False)


@pytest.mark.parametrize("name", ["records.txt", "missing/records.csv"])
def test_files_that_cannot_be_written_are_refused(tmp_path, name):
    with pytest.raises(InputError, match="out must"):
        simulation_files.checked_path(tmp_path / name)


def test_points_are_read():
    assert points_of("1,2; -3,0.5") == ((1.0, 2.0), (-3.0, 0.5))
    assert points_of(None) == ()
    for text in ("1", "a,b", "1,2,3", "nan,0", ";"):
        with pytest.raises(InputError, match="points must be"):
            points_of(text)


def test_refusals_say_what_is_wrong(ship, waves):
    design, speed = ship.design, float(ship.motions.attrs["speed"])
    with pytest.raises(InputError, match="samples"):
        simulation(ship, waves, 0.1, STEP)
    with pytest.raises(InputError, match="samples"):
        simulation(ship, waves, 1e6, STEP)
    with pytest.raises(InputError, match="forces must be one of"):
        simulation(ship, waves, 10.0, STEP, forces="nonlinear")
    with pytest.raises(InputError, match="speed of the wave components"):
        simulation(ship, components_from(4.0, 0.01, 0.0, np.pi, 0.0), 10.0, STEP)
    with pytest.raises(InputError, match="steeper waves break"):
        simulated_regular_wave(design, speed, np.pi, 0.5, 5.0, respond(design, speed), hours=0.01)
    with pytest.raises(InputError, match="omega must be"):
        simulated_regular_wave(design, speed, np.pi, 1e-4, 60.0, respond(design, speed), hours=0.01)


def test_one_theory_serves_all_headings():
    """Where one theory is recommended for all headings it is taken, else strip theory."""
    settings, length = RecommendedSettings(), 70.0
    fast = 0.4 * float(np.sqrt(GRAVITY * length))
    assert one_theory(settings, length, fast, [np.pi]) is settings.high_speed
    assert one_theory(settings, length, fast, [np.pi, 0.3]) is settings.strip
    assert one_theory(settings, length, 0.0, [np.pi, 0.3]) is settings.potential_flow
    assert one_theory(settings.strip, length, 0.0, [np.pi]) is settings.strip


def test_running_attitude_is_that_of_the_wet_hull(monkeypatch):
    """The surface is that of the ship as it runs, as for the hydrodynamics."""
    design, seen = designs.named_design("delft-372"), []
    speed = 0.3 * float(np.sqrt(GRAVITY * design.hull.length))

    def noted(ship, *others, **named):
        seen.append(ship.design.hull.trim)
        return simulation(ship, *others, **named)

    monkeypatch.setattr(simulation_stage, "simulation", noted)
    state = RunningState(running_trim=-0.01)
    simulated_regular_wave(
        design,
        speed,
        np.pi,
        0.01,
        4.0,
        lambda directions, omega: pipeline.response(
            design, speed, directions, omega, StripSettings(), running_state=state
        ),
        hours=0.001,
    )
    assert seen == [-0.01]


@pytest.fixture
def command(monkeypatch):
    if not any(entry.callback is simulate_command.simulate for entry in cli.application.registered_commands):
        kept = list(cli.application.registered_commands)
        monkeypatch.setattr(cli.application, "registered_commands", kept)
        cli.application.command("simulate")(simulate_command.simulate)


def run(capsys, *arguments):
    code = 0
    sys.argv = [
        "workbench",
        "simulate",
        "delft-372",
        "--froude",
        "0.3",
        "--method",
        "potential-flow",
        *map(str, arguments),
    ]
    try:
        cli.main()
    except SystemExit as stop:
        code = stop.code or 0
    captured = capsys.readouterr()
    return code, captured.out, captured.err


@pytest.mark.usefixtures("command")
def test_command_simulates_a_sea_and_a_regular_wave(capsys, tmp_path):
    out = tmp_path / "sea.nc"
    code, text, err = run(
        capsys, "--hs", 0.1, "--tp", 1.6, "--hours", 0.003, "--points", "0.9,0", "--out", out, "--json"
    )
    assert code == 0, err
    values = json.loads(text)
    assert out.exists()
    assert values["forces"] == "non-linear"
    assert values["motions"]["heave"]["std"] > 0
    assert values["points"][0]["slams"] >= 0
    code, text, _ = run(
        capsys, "--regular-wave-amplitude", 0.02, "--omega", 4, "--hours", 0.002, "--linear", "--json"
    )
    values = json.loads(text)
    assert code == 0
    assert values["forces"] == "linear"
    assert "regular waves" in values["waves"]
    code, text, _ = run(
        capsys,
        "--hs",
        0.05,
        "--tp",
        1.6,
        "--spectrum",
        "jonswap",
        "--spreading",
        4,
        "--hours",
        0.001,
        "--linear",
    )
    assert "heave" in text
    assert "jonswap" in text


@pytest.mark.usefixtures("command")
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--hs", 0.1), "peak_period"),
        (("--hs", 0.1, "--tp", 1.6, "--omega", 3), "waves must be given once"),
        (("--hs", 0.1, "--tp", 1.6, "--time-step", 0.5), "time_step must be <="),
        (("--hs", 0.1, "--tp", 1.6, "--out", "here.pdf"), "out must be"),
    ],
)
def test_command_refuses_in_one_sentence(capsys, arguments, words):
    code, text, err = run(capsys, *arguments, "--hours", 0.01)
    assert code == 2
    assert text == ""
    assert words in err
    assert err.count("\n") == 1
