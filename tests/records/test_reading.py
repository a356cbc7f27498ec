"""Records as they come from a logger: read and mended on request, or refused with one clear sentence."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY, KNOT
from workbench.errors import InputError
from workbench.quantities import warnings_of
from workbench.records.reading import ReadingSettings, channel, channel_unit, read_record, record
from workbench.records.units import si_unit, split_label

TIME = np.arange(0, 20, 0.1)
WAVE = np.sin(1.3 * TIME)


def written(tmp_path, text, name="trial.csv"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


def table(time=TIME, values=WAVE, head="time [s], wave [m]", separator=","):
    rows = [f"{t:.4f}{separator}{v:.8g}" for t, v in zip(time, values, strict=True)]
    return "\n".join([head, *rows]) + "\n"


def test_a_table_is_read_in_si_units(tmp_path):
    head = "# a trial\n#run 3\ntime [ms]; bow, wave (mm); pitch [deg]; a [g]; speed [kn]\n"
    rows = "".join(
        f"{1000 * t:.1f};{1000 * w:.5f};{2.0};{0.5};{10}\n" for t, w in zip(TIME, WAVE, strict=True)
    )
    found = read_record(written(tmp_path, head + rows))
    assert [str(name) for name in found.channel.values] == ["bow, wave", "pitch", "a", "speed"]
    assert channel(found, "bow, wave") == pytest.approx(WAVE, abs=1e-8)
    assert channel(found, "pitch") == pytest.approx(np.radians(2.0))
    assert channel(found, "a") == pytest.approx(0.5 * GRAVITY)
    assert channel(found, "speed") == pytest.approx(10 * KNOT)
    assert channel_unit(found, "pitch") == "rad"
    assert found.time.values == pytest.approx(TIME)
    assert found.attrs["time_step"] == pytest.approx(0.1)
    assert found.measured.attrs["units"]


@pytest.mark.parametrize("separator", [",", ";", "\t", " "])
def test_separators(tmp_path, separator):
    head = separator.join(["time[s]", "wave[m]"])
    found = read_record(written(tmp_path, table(head=head, separator=separator)))
    assert channel(found, "wave") == pytest.approx(WAVE, abs=1e-7)


def test_decimal_comma_with_semicolons(tmp_path):
    text = table(head="time [s];wave [m]", separator=";").replace(".", ",")
    assert channel(read_record(written(tmp_path, text)), "wave") == pytest.approx(WAVE, abs=1e-7)


def test_columns_without_a_unit_are_si_and_said_to_be(tmp_path):
    found = read_record(written(tmp_path, table(head="t,wave")))
    assert channel_unit(found, "wave") == "?"
    assert "wave" in warnings_of(found)[0]


def test_units_of_names():
    assert split_label(" pitch rate (deg/s) ") == ("pitch rate", "deg/s")
    assert split_label("plain") == ("plain", "")
    assert si_unit("kn") == ("m/s", KNOT)
    assert si_unit("kN") == ("N", 1000.0)
    with pytest.raises(InputError, match="furlong"):
        si_unit("furlong", "wave")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "at least 8 samples"),
        (table(TIME[:5], WAVE[:5]), "at least 8 samples"),
        (table(head="0.0, 1.0"), "must name the columns"),
        (table() + "20.0\n", "line 202 .* 2 values, got 1"),
        (table() + "20.0, up\n", "line 202 .* 'up' for wave"),
        (table(head="pitch [deg], wave [m]"), "first column .* must be time"),
        (table(head="time [s], wave [yard]"), "unit of wave .* 'yard'"),
        (table(TIME[::-1]), "must increase"),
        (table(head="time [s]", separator=" "), "at least one channel"),
    ],
)
def test_tables_that_cannot_be_used_are_refused_with_their_place(tmp_path, text, said):
    with pytest.raises(InputError, match=said):
        read_record(written(tmp_path, text))


def test_unreadable_files_are_refused(tmp_path):
    with pytest.raises(InputError, match="check the path"):
        read_record(tmp_path / "none.csv")
    (tmp_path / "film.csv").write_bytes(b"\xff\xfe\x00\x01")
    with pytest.raises(InputError, match="not text"):
        read_record(tmp_path / "film.csv")


def gapped(first, last):
    values = WAVE.copy()
    values[first:last] = np.nan
    return values


def test_gaps_are_refused_with_their_place_and_filled_on_request():
    values = gapped(50, 54)
    with pytest.raises(InputError, match=r"wave has 4 missing samples, the longest gap of 0\.5 s at 5 s"):
        record(TIME, values, ["wave"], ["m"])
    found = record(TIME, values, ["wave"], ["m"], ReadingSettings(longest_gap=0.5))
    assert channel(found, "wave") == pytest.approx(WAVE, abs=0.01)
    assert channel(found, "wave")[:50] == pytest.approx(WAVE[:50], abs=0)
    assert "4 of 200" in warnings_of(found)[0]


def test_gaps_longer_than_allowed_or_at_an_end_stay_refused():
    with pytest.raises(InputError, match=r"at most 0\.4 s"):
        record(TIME, gapped(50, 54), ["wave"], ["m"], ReadingSettings(longest_gap=0.4))
    with pytest.raises(InputError, match="begin and end"):
        record(TIME, gapped(0, 2), ["wave"], ["m"], ReadingSettings(longest_gap=5.0))


def test_missing_rows_are_gaps():
    kept = np.r_[0:80, 84:200]
    with pytest.raises(InputError, match=r"4 missing samples, the longest gap of 0\.5 s at 8 s"):
        record(TIME[kept], WAVE[kept], ["wave"], ["m"])
    found = record(TIME[kept], WAVE[kept], ["wave"], ["m"], ReadingSettings(longest_gap=0.6))
    assert found.time.values == pytest.approx(TIME)
    assert channel(found, "wave") == pytest.approx(WAVE, abs=0.01)


def test_uneven_steps_are_refused_and_resampled_on_request(rng):
    uneven = TIME + rng.uniform(-0.03, 0.03, len(TIME))
    values = np.sin(1.3 * uneven)
    with pytest.raises(InputError, match=r"evenly spaced .* ask for resampling"):
        record(uneven, values, ["wave"], ["m"])
    found = record(uneven, values, ["wave"], ["m"], ReadingSettings(resample=True))
    assert channel(found, "wave") == pytest.approx(np.sin(1.3 * found.time.values), abs=2e-4)
    slower = record(uneven, values, ["wave"], ["m"], ReadingSettings(resample=True, time_step=0.2))
    assert slower.attrs["time_step"] == pytest.approx(0.2)
    assert np.diff(slower.time.values) == pytest.approx(0.2)


def test_resampling_does_not_hide_a_gap(rng):
    uneven = TIME + rng.uniform(-0.03, 0.03, len(TIME))
    values = np.sin(1.3 * uneven)
    values[50:70] = np.nan
    with pytest.raises(InputError, match="longest gap of"):
        record(uneven, values, ["wave"], ["m"], ReadingSettings(resample=True))


def test_times_rounded_by_the_logger_are_even():
    rounded = np.round(np.arange(300) / 30.0, 3)
    found = record(rounded, np.sin(rounded), ["wave"], ["m"])
    assert found.attrs["time_step"] == pytest.approx(1 / 30, rel=1e-4)


@pytest.mark.parametrize(
    ("time", "said"),
    [
        (np.r_[0:9, 8], "after 8 s comes 8 s"),
        (np.r_[0:8, np.nan], "missing at sample 9"),
        (np.arange(5), "at least 8"),
    ],
)
def test_times_that_cannot_be_used_are_refused(time, said):
    with pytest.raises(InputError, match=said):
        record(time, np.ones(len(time)), ["wave"], ["m"])


def test_settings_refuse_what_makes_no_sense():
    with pytest.raises(InputError, match="together with resample"):
        ReadingSettings(time_step=0.1)
    with pytest.raises(InputError, match="longest_gap"):
        ReadingSettings(longest_gap=-1.0)
    with pytest.raises(InputError, match="channel must be one of wave"):
        channel(record(TIME, WAVE, ["wave"], ["m"]), "heave")
