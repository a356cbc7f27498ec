import pytest

from workbench.errors import InputError
from workbench.hulls import library
from workbench.hulls.offset_files import offsets_from_csv

ROWS = [
    f"{x},{z},{b * min(1.0, z + 0.2) if z else 0.0:g}"
    for x, b in ((-10, 0.8), (-5, 1.0), (0, 1.0), (5, 0.7), (9, 0.2))
    for z in (0.0, 0.5, 1.5, 2.0)
]
TABLE = "\n".join(["# notes", "x,z,half_breadth", *ROWS, "10,2.0,0"])
SIZE = {"draught": 1.5, "length": 20.0}


def test_rows_may_come_in_any_order_and_unit():
    straight = offsets_from_csv(TABLE, **SIZE)
    shuffled = offsets_from_csv("\n".join(["x,z,half_breadth", *ROWS[::-1], "10,2.0,0"]), **SIZE)
    assert shuffled == straight
    tenth = offsets_from_csv(TABLE, draught=0.15, length=2.0, unit=0.1)
    assert tenth.beam == pytest.approx(straight.beam / 10)


def test_columns_may_come_in_any_order():
    rows = [",".join(reversed(row.split(","))) for row in ROWS]
    assert offsets_from_csv("\n".join(["half_breadth,z,x", *rows, "0,2.0,10"]), **SIZE) == offsets_from_csv(
        TABLE, **SIZE
    )


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "got an empty table"),
        ("# only a note", "got an empty table"),
        ("x,z,half_breadth", "got an empty table"),
        ("a,b,c\n1,2,3", "columns of the offsets must be x, z, half_breadth, got a, b, c"),
        ("x,z,half_breadth\n1,2", "line 2 of the offsets must have 3 numbers, got 2"),
        ("x,z,half_breadth\n1,2,wide", "line 2 of the offsets must be numbers"),
        (TABLE + "\n0,0.5,0.7", "repeats x = 0, z = 0.5"),
        (TABLE.replace("9,0.5,0.14", "9,0.5,-0.14"), "half-breadth at station x = 9 m"),
        (TABLE.replace("9,0.5,0.14", "9,0.5,nan"), "half-breadth at station x = 9 m"),
        ("\n".join(TABLE.splitlines()[:10]), "at least 5 stations"),
    ],
)
def test_tables_that_cannot_be_read_are_refused_in_one_sentence(text, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        offsets_from_csv(text, **SIZE)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("unit", [0.0, -1.0, "dm", None])
def test_a_unit_without_sense_is_refused(unit):
    with pytest.raises(InputError, match="unit of the offsets"):
        offsets_from_csv(TABLE, unit=unit, **SIZE)


def test_the_delft_table_has_its_stations_and_dimensions():
    shape = library.design("delft-372").hull.shape
    assert len(shape.stations) == 27
    assert shape.depth == pytest.approx(0.2)
    assert shape.beam == pytest.approx(0.24, rel=0.015)
