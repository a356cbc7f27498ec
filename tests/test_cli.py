"""The command line as a script uses it: one JSON object on standard output, or one sentence and exit code 2."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

from workbench import cli
from workbench.conventions import GRAVITY, KNOT
from workbench.files import design_to_toml
from workbench.hulls import library


def run(capsys, *arguments):
    """Run the command line in this process; return exit code, standard output and standard error."""
    code = 0
    sys.argv = ["workbench", *map(str, arguments)]
    try:
        cli.main()
    except SystemExit as stop:
        code = stop.code or 0
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_designs_and_show(capsys):
    code, out, _ = run(capsys, "designs", "--json")
    listed = [entry["name"] for entry in json.loads(out)["designs"]]
    assert code == 0
    assert {"delft-372", "austal-63", "crowther-318", "heavy-lift-198-model"} <= set(listed)
    code, out, _ = run(capsys, "show", "delft-372", "--json")
    values = json.loads(out)
    assert code == 0
    assert values["hydrostatics"]["displacement"]["value"] == pytest.approx(87.07, rel=0.01)
    assert all(entry["standing"] in {"published", "derived", "ours"} for entry in values["provenance"])
    code, out, _ = run(capsys, "show", "delft-372")
    assert "displacement" in out
    assert "[published]" in out


def test_rao_prints_what_it_promises(capsys):
    code, out, err = run(
        capsys, "rao", "delft-372", "--method", "potential-flow", "--froude", "0.1", "--heading-degrees", "180",
        "--wavelength-ratio", "1:8:3", "--panels", "300", "--json",
    )  # fmt: skip
    assert code == 0, err
    values = json.loads(out)
    assert values["design"] == "delft-372"
    assert values["method"] == "potential-flow"
    assert values["wavelength_ratio"] == pytest.approx([1, 4.5, 8])
    speed = 0.1 * np.sqrt(GRAVITY * 3.0)
    assert values["speed"] == pytest.approx(speed)
    omega = np.array(values["omega"])
    assert omega == pytest.approx(np.sqrt(2 * np.pi * GRAVITY / (3 * np.array([1, 4.5, 8]))))
    assert values["encounter_frequency"] == pytest.approx((omega + omega**2 / GRAVITY * speed).tolist())
    assert values["heave"]["amplitude"][2] == pytest.approx(1, abs=0.05)
    assert values["pitch"]["amplitude_per_wave_slope"][2] == pytest.approx(1, abs=0.1)
    k = omega[2] ** 2 / GRAVITY
    assert values["pitch"]["amplitude"][2] == pytest.approx(
        values["pitch"]["amplitude_per_wave_slope"][2] * k
    )
    assert values["pitch"]["phase_degrees"][2] == pytest.approx(
        -90, abs=10
    )  # bow down leads by a quarter period
    assert "amplitude_per_wave_slope" not in values["heave"]
    assert set(values) >= {"surge", "sway", "heave", "roll", "pitch", "yaw", "warnings", "froude_number"}
    assert values["sway"]["amplitude"][0] < 1e-9


def test_speed_may_be_given_in_knots(capsys):
    common = ("--omega", "2:3:2", "--panels", "200", "--json")
    speed = 0.1 * np.sqrt(GRAVITY * 3.0)
    _, by_froude, _ = run(capsys, "rao", "delft-372", "--froude", "0.1", *common)
    _, by_knots, _ = run(capsys, "rao", "delft-372", "--speed-knots", f"{speed / KNOT:.15f}", *common)
    first, second = json.loads(by_froude), json.loads(by_knots)
    assert first["heave"]["amplitude"] == pytest.approx(second["heave"]["amplitude"], rel=1e-9)


SLAM = ("--clearance", "0.1", "--hs", "0.15", "--tp", "1.5", "--spectrum", "bretschneider", "--froude", "0")


def test_slam_prints_what_it_promises(capsys):
    code, out, err = run(
        capsys, "slam", "delft-372", *SLAM, "--heading-degrees", "180", "--seed", "3", "--hours", "0.5",
        "--criterion-per-hour", "20", "--deck-points", "12x5", "--json",
    )  # fmt: skip
    assert code == 0, err
    values = json.loads(out)
    shape = (len(values["x"]), len(values["y"]))
    assert shape == (12, 5)
    for name in ("slams_per_hour", "relative_motion_std", "relative_velocity_std"):
        assert np.shape(values[name]) == shape
    worst = values["worst_point"]
    rates = np.array(values["slams_per_hour"])
    assert worst["slams_per_hour"] == pytest.approx(rates.max())
    row, column = np.unravel_index(rates.argmax(), shape)
    assert (worst["x"], worst["y"]) == (values["x"][row], values["y"][column])
    deviation, velocity = (
        np.array(values[f"relative_{part}_std"])[row, column] for part in ("motion", "velocity")
    )
    height = np.array(values["height"])[row, column]
    expected = 3600 / 2 / np.pi * velocity / deviation * np.exp(-(height**2) / 2 / deviation**2)
    assert worst["slams_per_hour"] == pytest.approx(expected)
    assert worst["mean_entry_velocity"] == pytest.approx(np.sqrt(np.pi / 2) * velocity)
    low, high = worst["counted_band"]
    assert low <= worst["counted_per_hour"] <= high
    assert low <= worst["slams_per_hour"] <= high
    assert worst["most_probable_peak_pressure"] > 0

    again = run(
        capsys,
        "slam",
        "delft-372",
        *SLAM,
        "--clearance",
        values["least_clearance"],
        "--deck-points",
        "12x5",
        "--json",
    )
    assert max(map(max, json.loads(again[1])["slams_per_hour"])) == pytest.approx(20, rel=1e-6)


def test_threshold_by_ochi_lowers_the_count(capsys):
    counts = []
    for threshold in ("0", "ochi", "0.3"):
        _, out, _ = run(
            capsys, "slam", "delft-372", *SLAM, "--threshold", threshold, "--deck-points", "6x3", "--json"
        )
        counts.append(json.loads(out)["worst_point"]["slams_per_hour"])
    assert counts[0] > counts[2] > counts[1] > 0
    assert json.loads(out)["threshold_velocity"] == 0.3


def test_a_measured_spectrum_is_read_from_a_file(capsys, tmp_path):
    from workbench.seas import SeaState, wave_spectrum

    omega = np.linspace(2.0, 15.0, 200)
    table = wave_spectrum(SeaState(significant_wave_height=0.15, peak_period=1.5), omega)
    path = tmp_path / "sea.csv"
    path.write_text(
        "# omega, ordinate\n" + "\n".join(f"{a:.8f}, {b:.10f}" for a, b in zip(omega, table, strict=True))
    )
    rates = []
    for more in ((), ("--spectrum-file", path)):
        code, out, err = run(capsys, "slam", "delft-372", *SLAM, *more, "--deck-points", "6x3", "--json")
        assert code == 0, err
        rates.append(json.loads(out)["worst_point"]["slams_per_hour"])
    assert rates[1] == pytest.approx(rates[0], rel=0.05)
    path.write_text("1 2\nx y\n")
    code, out, err = run(capsys, "slam", "delft-372", *SLAM, "--spectrum-file", path, "--json")
    assert (code, out) == (2, "")
    assert "spectrum-file" in err


def test_a_toml_file_is_a_design(capsys, tmp_path):
    path = tmp_path / "own.toml"
    path.write_text(design_to_toml(library.design("delft-372")).replace('name = "delft-372"', 'name = "own"'))
    code, out, _ = run(capsys, "show", path, "--json")
    assert code == 0
    assert json.loads(out)["name"] == "own"


BAD = {
    "unknown design": (("show", "delft-327"), "delft-372"),
    "missing file": (("show", "nowhere/x.toml"), "x.toml"),
    "two speeds": (
        ("rao", "delft-372", "--froude", "0.1", "--speed-knots", "3", "--omega", "2:3:2"),
        "speed",
    ),
    "no speed": (("rao", "delft-372", "--omega", "2:3:2"), "speed"),
    "two ranges": (
        ("rao", "delft-372", "--froude", "0", "--omega", "2:3:2", "--wavelength-ratio", "1:2:3"),
        "omega",
    ),
    "no range": (("rao", "delft-372", "--froude", "0"), "omega"),
    "range of text": (("rao", "delft-372", "--froude", "0", "--omega", "a:b:c"), "omega"),
    "range backwards": (("rao", "delft-372", "--froude", "0", "--omega", "3:2:4"), "omega"),
    "zero frequency": (("rao", "delft-372", "--froude", "0", "--omega", "0:2:4"), "omega"),
    "above panel limit": (("rao", "delft-372", "--froude", "0", "--omega", "2:90:4"), "panels"),
    "heading 400": (
        ("rao", "delft-372", "--froude", "0", "--heading-degrees", "400", "--omega", "2:3:2"),
        "heading",
    ),
    "nan heading": (
        ("rao", "delft-372", "--froude", "0", "--heading-degrees", "nan", "--omega", "2:3:2"),
        "heading",
    ),
    "negative speed": (("rao", "delft-372", "--speed-knots", "-3", "--omega", "2:3:2"), "speed"),
    "nan froude": (("rao", "delft-372", "--froude", "nan", "--omega", "2:3:2"), "froude"),
    "overtaking": (
        (
            "rao",
            "delft-372",
            "--method",
            "high-speed",
            "--froude",
            "0.6",
            "--heading-degrees",
            "0",
            "--omega",
            "2:6:3",
        ),
        "overtakes",
    ),
    "method": (("rao", "delft-372", "--froude", "0", "--omega", "2:3:2", "--method", "magic"), "method"),
    "panels": (("rao", "delft-372", "--froude", "0", "--omega", "2:3:2", "--panels", "3"), "panels"),
    "treatment": (
        ("rao", "delft-372", "--froude", "0", "--omega", "2:3:2", "--speed-treatment", "x"),
        "one of",
    ),
    "hs 0": (("slam", "delft-372", "--hs", "0", "--tp", "2", "--froude", "0"), "significant_wave_height"),
    "tp 0": (("slam", "delft-372", "--hs", "0.1", "--tp", "0", "--froude", "0"), "peak_period"),
    "no tp": (("slam", "delft-372", "--hs", "0.1", "--froude", "0"), "peak_period"),
    "clearance 0": (("slam", "delft-372", *SLAM, "--clearance", "0"), "clearance"),
    "clearance below water": (("slam", "delft-372", *SLAM, "--clearance", "-0.2"), "clearance"),
    "clearance nan": (("slam", "delft-372", *SLAM, "--clearance", "nan"), "clearance"),
    "spectrum": (("slam", "delft-372", *SLAM, "--spectrum", "red"), "spectrum"),
    "threshold": (("slam", "delft-372", *SLAM, "--threshold", "much"), "threshold"),
    "negative threshold": (("slam", "delft-372", *SLAM, "--threshold=-1"), "threshold"),
    "criterion 0": (("slam", "delft-372", *SLAM, "--criterion-per-hour", "0"), "criterion"),
    "hours 0": (("slam", "delft-372", *SLAM, "--hours", "0"), "hours"),
    "seed": (("slam", "delft-372", *SLAM, "--seed", "-4"), "seed"),
    "points": (("slam", "delft-372", *SLAM, "--deck-points", "0x3"), "deck-points"),
    "one hull": (("slam", "cofea", "--hs", "3", "--tp", "8", "--froude", "0"), "wet deck"),
    "law": (("slam", "delft-372", *SLAM, "--pressure-law", "guess"), "pressure law"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_one_sentence_and_exit_code_two(capsys, case):
    arguments, words = BAD[case]
    code, out, err = run(capsys, *arguments, "--json")
    assert code == 2
    assert out == ""
    assert words in err
    assert "Traceback" not in err
    assert len(err.strip().splitlines()) == 1


def test_text_for_a_number_is_refused_by_the_option_itself(capsys):
    code, out, err = run(capsys, "slam", "delft-372", "--hs", "high", "--tp", "2", "--froude", "0", "--json")
    assert code == 2
    assert out == ""
    assert "--hs" in err
    assert "Traceback" not in err


TOML_FAULTS = {
    "unknown key": ("draught = ", "draft = ", "draft"),
    "no number": ("mass = 87.07", 'mass = "heavy"', "mass"),
    "negative": ("mass = 87.07", "mass = -87.07", "mass"),
    "nan": ("mass = 87.07", "mass = nan", "mass"),
    "broken": ("[masses]", "[masses", "TOML"),
}


@pytest.mark.parametrize("fault", TOML_FAULTS)
def test_bad_design_files_are_refused(capsys, tmp_path, fault):
    before, after, words = TOML_FAULTS[fault]
    text = design_to_toml(library.design("delft-372"))
    assert before in text
    path = tmp_path / "bad.toml"
    path.write_text(text.replace(before, after, 1))
    code, out, err = run(capsys, "show", path, "--json")
    assert (code, out) == (2, "")
    assert words in err
    assert "Traceback" not in err


def test_centre_of_gravity_above_the_metacentre_is_refused(capsys, tmp_path):
    text = design_to_toml(library.design("delft-372"))
    path = tmp_path / "top-heavy.toml"
    start = text.index("centre_of_gravity = ")
    end = text.index("]", start) + 1
    path.write_text(text[:start] + "centre_of_gravity = [-0.09, 0.0, 20.0]" + text[end:])
    code, _, err = run(capsys, "rao", path, "--froude", "0", "--omega", "2:3:2")
    assert code == 2
    assert "metacentr" in err


def test_unwritable_folder_is_refused_before_anything_is_computed(capsys, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    code, _, err = run(capsys, "run", "delft-372", "--out", blocked / "results")
    assert code == 2
    assert "must be writable" in err


def test_run_writes_a_whole_study(capsys, tmp_path):
    out = tmp_path / "study"
    code, printed, err = run(
        capsys, "run", "delft-372", "--out", out, "--froude", "0", "--hs", "0.2", "--hours", "0.3"
    )
    assert code == 0, err
    assert printed.strip() == str(out / "index.html")
    names = {str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()}
    assert {
        "results.nc",
        "summary.json",
        "motions.csv",
        "slamming.csv",
        "slams.csv",
        "deck-slams.csv",
        "deck-slams.nc",
        "hardest-slam.csv",
        "hardest-slam.nc",
        "design.toml",
        "animation.html",
    } <= names
    assert {"figures/motions.png", "figures/slams.svg", "figures/clearance.png"} <= names
    assert {"figures/envelope.png", "figures/pressure-area.svg"} <= names
    page = (out / "index.html").read_text()
    assert "this deck slams" in page
    assert "<h2>Pressure over the wet deck</h2>" in page
    assert all(f'href="{name}"' in page for name in names if name.startswith(("deck-slams", "hardest")))
    assert "http" not in page.replace("http-equiv", "")
    import xarray as xr

    with xr.open_dataset(out / "results.nc") as results:
        summary = json.loads((out / "summary.json").read_text())
        assert float(results.slams_per_hour.max()) == pytest.approx(summary["worst_point"]["slams_per_hour"])
        assert results.slams_per_hour.attrs["units"] == "1/h"
    assert sum(1 for line in (out / "slams.csv").read_text().splitlines()) > 10


def test_installed_command_starts_without_the_solver():
    """The console command answers without importing Capytaine, pyvista or the app."""
    code = (
        "import sys; from workbench import cli; sys.argv = ['workbench', 'designs']\n"
        "try:\n    cli.main()\nexcept SystemExit:\n    pass\n"
        "assert not {'pyvista', 'vtk', 'ipywidgets'} & set(sys.modules), 'heavy imports'"
    )
    found = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ},
        timeout=60,
    )
    assert found.returncode == 0, found.stderr
    assert "delft-372" in found.stdout


RAO = ("rao", "delft-372", "--froude", "0.3", "--wavelength-ratio", "1:2:3", "--json")


@pytest.mark.parametrize("method", ["recommended", "strip", "high-speed"])
def test_rao_takes_a_theory(capsys, method):
    code, out, _ = run(capsys, *RAO, "--method", method)
    values = json.loads(out)
    assert code == 0
    assert values["method"] == ("high-speed" if method == "recommended" else method)
    assert ("Recommended at Fn 0.30: high-speed theory" in values["recommendation"]) == (
        method == "recommended"
    )
    assert 0.8 < max(values["heave"]["amplitude"]) < 2.0
    assert values["wavelength_ratio"] == sorted(values["wavelength_ratio"])


def test_theories_and_running_attitude_and_held_modes_reach_the_numbers(capsys):
    def heave(*options):
        code, out, err = run(capsys, *RAO, *options)
        assert code == 0, err
        values = json.loads(out)
        return values["heave"]["amplitude"][0], values["pitch"]["amplitude"][0]

    usual = heave()
    assert heave("--method", "strip") != pytest.approx(usual, rel=0.05)
    assert heave("--interaction", "off") != pytest.approx(usual, rel=0.02)
    assert heave("--running-trim-degrees", "-1", "--running-sinkage", "0.005") != pytest.approx(
        usual, rel=0.01
    )
    assert heave("--lock", "pitch")[1] == 0.0


def test_a_heeled_ship_rolls_in_head_seas_and_wind_damps_on_the_sails(capsys):
    def roll(*options):
        arguments = ("rao", "crowther-318", "--speed-knots", "10", "--omega", "1.9:1.9:1", "--json")
        code, out, err = run(capsys, *arguments, *options)
        assert code == 0, err
        return json.loads(out)["roll"]["amplitude"][0]

    assert roll() == pytest.approx(0.0, abs=1e-9)
    heeled = roll("--heel-degrees", "2")
    assert heeled > 0.005
    assert roll("--heel-degrees", "2", "--wind-speed", "8") != pytest.approx(heeled, rel=0.01)
    assert roll("--heel-degrees", "5", "--method", "strip") == 0.0  # on one hull roll is held


def test_slam_takes_the_waves_between_the_hulls_and_the_own_wave(capsys):
    def least_clearance(*options):
        arguments = ("slam", "austal-63", "--speed-knots", "35", "--hs", "3", "--tp", "8", "--hours", "0.1")
        code, out, err = run(capsys, *arguments, *options, "--deck-points", "12x3", "--json")
        assert code == 0, err
        return json.loads(out)["least_clearance"]

    usual = least_clearance()
    assert least_clearance("--wave-field", "total") != pytest.approx(usual, rel=0.004)
    assert least_clearance("--own-wave") != pytest.approx(usual, rel=0.005)
    assert least_clearance("--method", "strip") != pytest.approx(usual, rel=0.02)


def test_simulate_and_records_work_on_each_other(capsys, tmp_path):
    out = tmp_path / "motions.csv"
    arguments = ("simulate", "austal-63", "--speed-knots", "30", "--hs", "2", "--tp", "8", "--hours", "0.03")
    code, printed, err = run(capsys, *arguments, "--linear", "--out", str(out), "--json")
    assert code == 0, err
    found = json.loads(printed)
    code, printed, err = run(capsys, "records", str(out), "--what", "summary", "--json")
    assert code == 0, err
    text = json.dumps(json.loads(printed))
    assert "heave" in text
    assert found["method"]
