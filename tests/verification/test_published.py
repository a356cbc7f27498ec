"""Tables of published numbers: their heads, and the long ones row by row."""

from pathlib import Path

import pytest

from workbench.verification import impact_cases, published

FOLDER = Path(__file__).parents[1] / "data" / "published"
OURS = sorted(
    path.stem for path in FOLDER.glob("*.csv") if "couser" not in path.stem and "delft372" not in path.stem
)
TABLE_2 = published.rows("chuang_1975_table_2")


def test_folder_is_that_of_the_checkout():
    assert published.published_folder() == FOLDER
    assert len(OURS) >= 15


@pytest.mark.parametrize("name", OURS)
def test_head_gives_citation_place_tolerance_and_repairs(name):
    head, rows = published.csv_rows(FOLDER / f"{name}.csv")
    assert any(str(year) in head[0] for year in range(1930, 2030))
    assert any(line.startswith("tolerance:") for line in head)
    assert any(line.startswith("repaired:") for line in head)
    assert rows
    assert all(None not in row and None not in row.values() for row in rows)


@pytest.mark.parametrize(
    "row", TABLE_2, ids=lambda row: f"run-{row['run']}-{row['case'] or 'single'}-{row['table']}"
)
def test_every_row_of_table_2_closes_or_is_known_not_to(row):
    assert impact_cases.printed_slam_agrees(row) == (row["closes"] == "yes")


@pytest.mark.parametrize(
    "row", TABLE_2, ids=lambda row: f"run-{row['run']}-{row['case'] or 'single'}-{row['table']}"
)
def test_repaired_columns_are_named(row):
    columns = [name.removeprefix("printed_") for name in row if name.startswith("printed_")]
    different = {name for name in columns if row[name] != row[f"printed_{name}"]}
    assert different == set(row["repaired"].split())


@pytest.mark.parametrize(
    "row", published.rows("chuang_1975_table_a1"), ids=lambda row: f"{row['event']}-{row['case']}"
)
def test_full_scale_slams_have_the_printed_k(row):
    assert float(impact_cases.ship_slam(row).coefficient) == pytest.approx(float(row["k"]), abs=0.0014)
