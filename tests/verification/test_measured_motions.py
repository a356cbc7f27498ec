"""Measured series are found for their condition alone, in the units of the comparison."""

import numpy as np
import pytest

from workbench.conventions import GRAVITY
from workbench.hulls.library import design
from workbench.verification import delft
from workbench.verification.measured_motions import measured_motions

AT_FROUDE = np.sqrt(GRAVITY * delft.LENGTH)


@pytest.mark.parametrize(
    ("froude", "heading", "names"),
    [
        (0.30, 180.0, ["towing tank, Fn 0.30", "basin, Fn 0.30, 180 deg"]),
        (0.745, 180.9, ["towing tank, Fn 0.75", "basin, Fn 0.75, 180 deg"]),
        (0.30, 195.0, ["basin, Fn 0.30, 195 deg"]), (0.30, 165.5, ["basin, Fn 0.30, 195 deg"]),
        (0.315, 180.0, []), (0.30, 178.5, []), (0.30, 0.0, []), (0.0, 180.0, []),
    ],
)  # fmt: skip
def test_series_of_a_condition(froude, heading, names):
    found = measured_motions(delft.model(), froude * AT_FROUDE, np.radians(heading))
    assert [series.attrs["name"] for series in found] == names


def test_other_ships_have_none():
    assert measured_motions(design("austal-63"), 0.3 * np.sqrt(GRAVITY * 77.0), np.pi) == ()


def test_values_are_those_of_the_cases():
    tank, basin = measured_motions(delft.model(), 0.3 * AT_FROUDE, np.pi)
    for mode in ("heave", "pitch"):
        towed = delft.towed(0.3, mode, "strip")
        free = delft.free(0.3, mode, "strip", 180.0)
        for series, case in ((tank, towed), (basin, free)):
            order = np.argsort(case.abscissa)
            np.testing.assert_allclose(series.motion_ratio.sel(dof=mode), case.measured[order])
            np.testing.assert_allclose(series.motion_lead.sel(dof=mode), case.measured_lead[order])
    assert "report 1129" in tank.attrs["source"]
    assert "report 1130" in basin.attrs["source"]
