"""The records command: tables as text, JSON and CSV; one sentence and exit code 2 for what is refused."""

import json
import sys

import numpy as np
import pytest
from random_seas import sines

from workbench import cli, record_commands
from workbench.conventions import GRAVITY
from workbench.records.reading import channel, read_record

if all(one.name != "records" for one in cli.application.registered_commands):
    cli.application.command("records")(record_commands.records)

TIME = np.arange(0, 600, 0.05)
SEA = sines(height=2.0, peak_period=6.0, low=0.8, high=3.0, count=150)


@pytest.fixture(scope="module")
def trial(tmp_path_factory):
    path = tmp_path_factory.mktemp("trial") / "trial.csv"
    acceleration = SEA.at(TIME, -0.8 * SEA.omega**2) / GRAVITY + np.random.default_rng(1).normal(
        0, 0.01, len(TIME)
    )
    for blow in (100.0, 250.0, 400.0):
        after = TIME - blow
        ringing = np.where(after >= 0, np.exp(-1.5 * np.maximum(after, 0)) * np.sin(30 * after), 0.0)
        acceleration += 0.5 * ringing
    columns = [TIME, SEA.at(TIME), SEA.at(TIME, 0.8), acceleration, 2 * np.sin(1.5 * TIME + 0.3)]
    np.savetxt(path, np.stack(columns, axis=1), delimiter=",", comments="", fmt="%.6f",
               header="time [s],bow wave [m],heave [m],bow acceleration [g],model [mm]")  # fmt: skip
    return path


def run(capsys, *arguments):
    """Run the command line in this process; return exit code, standard output and standard error."""
    code = 0
    sys.argv = ["workbench", "records", *map(str, arguments)]
    try:
        cli.main()
    except SystemExit as stop:
        code = stop.code or 0
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def columns_of(capsys, *arguments):
    code, out, err = run(capsys, *arguments, "--json")
    assert code == 0, err
    return json.loads(out)["columns"], json.loads(out)["warnings"]


def test_summary(capsys, trial):
    found, _ = columns_of(capsys, trial)
    assert found["channel"] == ["bow wave", "heave", "bow acceleration", "model"]
    assert found["unit"] == ["m", "m", "m/s2", "m"]
    assert found["standard deviation"][0] == pytest.approx(np.std(SEA.at(TIME)), rel=1e-3)
    assert found["zero-crossing period [s]"][3] == pytest.approx(2 * np.pi / 1.5, rel=1e-3)
    code, out, _ = run(capsys, trial)
    assert code == 0
    assert "12000 samples, 20 a second" in out
    assert "bow acceleration" in out


def test_spectra_and_response(capsys, trial):
    found, _ = columns_of(capsys, trial, "--what", "spectra", "--channel", "bow wave", "--segment", 1024)
    area = np.trapezoid(found["bow wave [(m)2 s/rad]"], found["frequency [rad/s]"])
    assert area == pytest.approx(np.var(SEA.at(TIME)), rel=0.1)
    found, notes = columns_of(
        capsys, trial, "--what", "response", "--wave", "bow wave", "--channel", "heave", "--rate", 5,
        "--speed-knots", 10, "--segment", 256,
    )  # fmt: skip
    assert np.array(found["heave [m per m]"]) == pytest.approx(0.8, abs=0.02)
    assert np.array(found["heave lead [rad]"]) == pytest.approx(0.0, abs=0.02)
    met, omega = np.array(found["encounter frequency [rad/s]"]), np.array(found["wave frequency [rad/s]"])
    assert met == pytest.approx(omega + omega**2 / GRAVITY * 10 * 1852 / 3600)
    assert not any("segments" in note for note in notes)


def test_fit(capsys, trial):
    found, _ = columns_of(capsys, trial, "--what", "fit", "--channel", "model")
    assert found["amplitude"] == pytest.approx([0.002], rel=1e-3)
    assert found["phase [rad]"] == pytest.approx([0.3], abs=0.01)
    assert found["frequency [rad/s]"] == pytest.approx([1.5], rel=1e-4)


def test_displacement_is_written_so_that_it_can_be_read_again(capsys, trial, tmp_path):
    out = tmp_path / "moved.csv"
    code, printed, err = run(capsys, trial, "--what", "displacement", "--out", out)
    assert code == 0
    assert "12000 lines in all" in printed
    assert "0.1 Hz" in err
    again = read_record(out)
    found = channel(again, "bow acceleration displacement")[600:-600]
    known = SEA.at(TIME, 0.8)[600:-600]
    assert np.std(found - known) < 0.08 * np.std(known)
    assert [path.name for path in tmp_path.iterdir()] == ["moved.csv"]


@pytest.mark.parametrize("more", [(), ("--ringing-hz", 4.77, "--ringing-ratio", 0.05), ("--threshold", 2.5)])
def test_slams(capsys, trial, more):
    found, _ = columns_of(capsys, trial, "--what", "slams", "--quickest-hz", 1.5, *more)
    assert found["time [s]"] == pytest.approx([100.0, 250.0, 400.0], abs=0.3)
    assert found["channel"] == ["bow acceleration"] * 3


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--what", "everything"), "what must be one of summary"),
        (("--what", "response"), "give --wave"),
        (("--what", "response", "--wave", "sea"), "channel must be one of"),
        (("--channel", "sea"), "channel must be one of"),
        (("--what", "spectra", "--segment", "100000"), "must be at least 5000 s long"),
        (("--what", "slams", "--channel", "heave"), "a channel in m/s2 or g"),
        (("--out", "/nowhere/at/all.csv"), "out must be a file that can be written"),
        (("--rate", "100"), "thinned out"),
    ],
)
def test_refusals_are_one_sentence_and_code_2(capsys, trial, arguments, said):
    code, out, err = run(capsys, trial, *arguments)
    assert code == 2
    assert not out
    assert said in err
    assert err.count("\n") == 1


def test_a_bad_file_is_refused_and_leaves_nothing_behind(capsys, trial, tmp_path):
    code, _, err = run(capsys, tmp_path / "none.csv", "--out", tmp_path / "out.csv")
    assert code == 2
    assert "check the path" in err
    assert not list(tmp_path.iterdir())
    code, _, err = run(capsys, trial, "--out", trial)
    assert code == 2
    assert "another file" in err
    text = trial.read_text().splitlines()
    gap = tmp_path / "gap.csv"
    gap.write_text("\n".join([*text[:200], *text[204:]]))
    code, _, err = run(capsys, gap)
    assert code == 2
    assert "the longest gap of 0.25 s" in err
    code, _, err = run(capsys, gap, "--longest-gap", 0.5, "--json")
    assert code == 0
