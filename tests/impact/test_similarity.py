"""Exact wedge: against an independent program, and by checks that the solution does not impose."""

from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from workbench.errors import InputError
from workbench.impact.entry import similarity_instant
from workbench.impact.quadrature import principal_value, running_integral
from workbench.impact.similarity import similarity_solution
from workbench.verification import published

REFERENCE = Path(__file__).parents[1] / "data" / "reference"
ROWS = published.csv_rows(REFERENCE / "wedge_similarity.csv")[1]
PRESSURES = published.csv_rows(REFERENCE / "wedge_similarity_pressure.csv")[1]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["deadrise_deg"])
def test_table_of_the_independent_program(row):
    beta = np.radians(float(row["deadrise_deg"]))
    found = similarity_solution(beta)
    assert 2 * found.peak == pytest.approx(float(row["peak_coefficient"]), rel=4e-6)
    assert found.force == pytest.approx(float(row["force_coefficient"]), rel=2e-6, abs=5e-6)
    assert found.peak_position * np.sin(beta) - 1 == pytest.approx(float(row["peak_height"]), abs=1e-5)
    assert found.wall_length * np.sin(beta) - 1 == pytest.approx(float(row["jet_height"]), abs=6e-6)
    assert np.degrees(found.contact_angle) == pytest.approx(float(row["contact_angle_deg"]), abs=6e-6)


@pytest.mark.parametrize("degrees", [4, 10, 20, 30, 45, 60])
def test_pressure_along_the_wall(degrees):
    rows = [row for row in PRESSURES if row["beta_deg"] == str(degrees)]
    sigma, known = (np.array([float(row[name]) for row in rows]) for name in ("sigma", "Cp"))
    instant = similarity_instant(np.radians(degrees), 1.0, 1.0)
    found = 2 * np.interp(sigma * np.cos(np.radians(degrees)), instant.positions, instant.pressure)
    assert np.abs(found - known).max() < 2e-4 * known.max()  # of linear interpolation in the table


@pytest.mark.parametrize("degrees", [3, 7, 25, 50, 77])
def test_water_raised_is_water_displaced(degrees):
    """Area between free surface and calm water, jet and all, equals the wedge below calm water; far water is calm."""
    beta = np.radians(degrees)
    found = similarity_solution(beta)
    near = found.surface[found.surface.real < 300 / np.tan(beta)]
    place = np.arange(len(near))
    y, z = CubicSpline(place, near.real), CubicSpline(place, near.imag)
    fine = np.linspace(0, place[-1], 20 * len(place))
    raised = (
        float(np.trapezoid(z(fine) * y(fine, 1), fine)) + near[-1].real * near[-1].imag
    )  # far off as 1/y**2
    tip = found.wall_length * np.exp(1j * beta) - 1j
    jet = (tip.imag + near[0].imag) / 2 * (near[0].real - tip.real)
    wall = (tip.imag - 1) / 2 * tip.real
    assert abs(wall + jet + raised) < 3e-4 / (2 * np.tan(beta))
    assert abs(found.surface[-1].imag) < 1e-5


@pytest.mark.parametrize("degrees", [3, 7, 25, 50, 77])
def test_distribution_adds_up_to_the_force(degrees):
    beta = np.radians(degrees)
    found = similarity_solution(beta)
    instant = similarity_instant(beta, 1.0, 1.0)
    assert instant.pressure[0] == pytest.approx(found.apex_pressure)
    assert 2 * np.trapezoid(instant.pressure, instant.positions) == pytest.approx(found.force, rel=1e-3)
    assert instant.cumulative[-1] == pytest.approx(found.force / 2)
    assert np.all(np.diff(instant.positions) > 0)


def test_small_deadrise_tends_to_wagner():
    """At 1 degree: peak, force and heights within 2 % of Wagner's, the jet twice as fast as the spray root."""
    beta = np.radians(1)
    found = similarity_solution(beta)
    assert 2 * found.peak / (np.pi / 2 / np.tan(beta)) ** 2 == pytest.approx(0.99892, abs=1e-5)
    assert found.force / (np.pi**3 / 4 / np.tan(beta) ** 2) == pytest.approx(0.98469, abs=1e-5)
    assert found.wall_length * np.sin(beta) == pytest.approx(np.pi, rel=1e-3)


def test_between_40_and_45_degrees_the_peak_goes_to_the_apex():
    assert similarity_solution(np.radians(40)).peak_position > 1
    assert similarity_solution(np.radians(41)).peak_position == 0
    assert similarity_solution(np.radians(40)).apex_pressure * 2 == pytest.approx(3.17081, abs=1e-5)


@pytest.mark.parametrize("degrees", [0.5, 86.0, np.nan])
def test_outside_its_range_it_is_refused(degrees):
    with pytest.raises(InputError, match="similarity solution"):
        similarity_solution(np.radians(degrees))


def test_running_integral_and_principal_value():
    """Integral of exp(-u**2/2), and the principal value over a symmetric g: odd part of the kernel cancels."""
    u = np.arange(-30.0, 30.05, 0.2)
    g = np.exp(-(u**2) / 2)
    assert (running_integral(len(u), 0.2) @ g)[-1] == pytest.approx(np.sqrt(2 * np.pi), rel=1e-12)
    middle = len(u) // 2
    # 1/(exp(v) - 1) = -1/2 + an odd function of v
    assert (principal_value(len(u), 0.2) @ g)[middle] == pytest.approx(-np.sqrt(2 * np.pi) / 2, rel=1e-9)
