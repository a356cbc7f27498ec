"""Rows as the tables of the Incat document print them."""

import numpy as np
import pytest

from workbench.verification import published
from workbench.verification.amin_cases import SECTION_STIFFNESS
from workbench.wet_deck_pressure.load_distribution import INCAT_061, SlamDistribution, nodal_forces
from workbench.wet_deck_pressure.slam_tables import TONNE_FORCE, impulse_row, load_row


@pytest.mark.parametrize(
    "row", published.rows("amin_table_3"), ids=lambda row: f"{row['approach']}-{row['instant']}"
)
def test_a_load_centred_on_a_frame_has_its_row_of_table_3(row):
    x = float(INCAT_061.x(float(row["frame"])))
    shape = SlamDistribution(x=x, fore_length=8.0, aft_length=8.0, y=5.0, half_width=2.0)
    nodes = x + np.arange(-10, 11) * 0.6
    total = float(row["load_tonne"]) * TONNE_FORCE
    found = load_row(nodal_forces(shape, nodes, np.full(21, 5.0), total=total), 1.845e6, INCAT_061)
    assert found["load_tonne"] == pytest.approx(float(row["load_tonne"]))
    assert found["load_meganewton"] == pytest.approx(float(row["load_tonne"]) * 9.80665e-3)
    assert found["load_over_displacement"] == pytest.approx(float(row["load_over_displacement"]), abs=5.1e-4)
    assert found["location_percent"] == pytest.approx(float(row["location_percent"]), abs=0.05)
    assert found["frame"] == pytest.approx(float(row["frame"]))
    assert found["location_from_transom"] == pytest.approx(1.2 * float(row["frame"]))


@pytest.mark.parametrize("row", published.rows("amin_table_4"), ids=lambda row: row["instant"])
def test_a_slam_has_its_row_of_table_4(row):
    x = float(row["location"]) - 46.2
    found = impulse_row(
        float(row["load_tonne"]) * TONNE_FORCE,
        x,
        30.3 - 46.2,
        float(row["strain_integral"]),
        SECTION_STIFFNESS * TONNE_FORCE,
        INCAT_061,
    )
    assert found["distance"] == pytest.approx(float(row["gauge_distance"]))
    assert found["location_from_transom"] == pytest.approx(float(row["location"]))
    assert found["impulse_tonne_s"] == pytest.approx(float(row["impulse_tonne_s"]), rel=0.0025)
    expected = float(row["impulse_tonne_s"]) / float(row["load_tonne"])
    assert found["effective_duration"] == pytest.approx(expected, rel=0.0025)
    assert "provisional" in found["warnings"]
