"""The theories behind the one interface: reference values, identities, averages, and what is refused."""

import json
from itertools import pairwise

import numpy as np
import pytest
from typer.testing import CliRunner

from workbench import entry_command
from workbench.errors import InputError
from workbench.impact import chuang, generalised_wagner
from workbench.impact.entry import METHODS, VelocityHistory, entry
from workbench.impact.section import Circle, Parabola, TableSection, Wedge
from workbench.quantities import warnings_of

LOGVINOVICH = {4: (507.0684, 1462.1416), 10: (81.7973, 209.2741), 15: (36.7669, 84.4724), 20: (20.9759, 42.8744),
               30: (9.6196, 15.0857), 40: (5.5586, 6.3521), 45: (4.4348, 4.2049), 60: (2.5399, 1.0778)}  # fmt: skip
"""Peak coefficient and force over rho V**3 t in closed form, evaluated independently."""

FORCES = ("von-karman", "wagner", "generalised-wagner", "logvinovich", "similarity", "nonlinear")


def wedge(degrees, method, velocity=2.0, time=0.5, **more):
    return entry(Wedge(np.radians(degrees)), velocity, method, 1000.0, [time], **more).isel(time=0)


def force_coefficient(found, velocity=2.0, time=0.5):
    return float(found["section_force"]) / (1000.0 * velocity**3 * time)


@pytest.mark.parametrize("degrees", LOGVINOVICH)
def test_logvinovich_in_closed_form(degrees):
    peak, force = LOGVINOVICH[degrees]
    found = wedge(degrees, "logvinovich")
    assert float(found["peak_coefficient"]) == pytest.approx(peak, abs=6e-5, rel=1e-6)
    assert force_coefficient(found) == pytest.approx(force, abs=6e-5, rel=1e-6)


@pytest.mark.parametrize("degrees", [4, 17, 35])
def test_von_karman_and_wagner_in_closed_form(degrees):
    tangent = np.tan(np.radians(degrees))
    found = wedge(degrees, "wagner")
    assert float(found["peak_coefficient"]) == pytest.approx((np.pi / 2 / tangent) ** 2, rel=1e-10)
    assert force_coefficient(found) == pytest.approx(np.pi**3 / 4 / tangent**2, rel=1e-10)
    assert float(found["peak_height"]) == pytest.approx(np.pi / 2 - 1, rel=1e-9)
    found = wedge(degrees, "von-karman")
    assert force_coefficient(found) == pytest.approx(np.pi / tangent**2, rel=1e-10)
    assert np.isnan(float(found["peak_coefficient"]))


@pytest.mark.parametrize(
    "section", [Wedge(0.4), Parabola(2.0), Circle(2.0)], ids=lambda section: section.kind
)
@pytest.mark.parametrize("method", ["wagner", "von-karman"])
def test_impulse_of_a_changing_velocity_is_the_momentum_of_the_added_mass(section, method):
    """Integral of F over time = rho pi c**2 V/2 at its end."""
    times = np.linspace(0, 0.1, 401)
    history = VelocityHistory(tuple(times), tuple(2.0 - 6 * times + 20 * times**2))
    found = entry(section, history, method, 1000.0, times[1:])
    impulse = np.trapezoid(found["section_force"], times[1:])
    momentum = 1000 * np.pi / 2 * found["wetted_half_breadth"] ** 2 * found["entry_velocity"]
    assert impulse == pytest.approx(float(momentum[-1] - momentum[0]), rel=2e-4)


@pytest.mark.parametrize("method", ["logvinovich", "generalised-wagner"])
def test_acceleration_adds_its_own_mass(method):
    """A wedge that speeds up: F grows by the model's added mass times h'' (edge of the positive part aside)."""
    beta = np.radians(15)
    times = np.linspace(0, 1, 11)
    faster = entry(Wedge(beta), VelocityHistory(tuple(times), tuple(2 + 3 * times)), method, 1.0, [0.5]).isel(
        time=0
    )
    depth, speed = float(faster["penetration"]), float(faster["entry_velocity"])
    assert (depth, speed) == pytest.approx((1.375, 3.5))
    steady = entry(Wedge(beta), speed, method, 1.0, [depth / speed]).isel(time=0)
    c = float(steady["wetted_half_breadth"])
    added = (float(faster["section_force"]) - float(steady["section_force"])) / 3
    if method == "logvinovich":
        known = np.pi * c**2 / 2 - 2 * (depth * c - np.tan(beta) * c**2 / 2)
    else:
        flow = generalised_wagner.wedge_flow(beta)
        known = -2 * c**2 * np.trapezoid(flow.potential * flow.slope_factor, flow.stretched)
    assert added == pytest.approx(known, rel=2e-3)


def test_generalised_wagner_flow_at_its_limits():
    """Small deadrise: Wagner; 45 degrees: added mass of a square, 4.754 rho a**2; any: the side ends on the axis."""
    assert generalised_wagner.wedge_flow(1e-4).spread * np.tan(1e-4) == pytest.approx(np.pi / 2, rel=1e-4)
    flow = generalised_wagner.wedge_flow(np.pi / 4)
    assert -8 * np.trapezoid(flow.potential * flow.slope_factor, flow.stretched) == pytest.approx(
        4.754, rel=1e-3
    )
    for degrees in (3, 30, 70, 88):
        assert generalised_wagner.wedge_flow(np.radians(degrees)).position[-2] == pytest.approx(0, abs=1e-4)


@pytest.mark.parametrize(
    ("degrees", "peak", "force"), [(4, 0.005, 0.025), (10, 0.02, 0.025), (20, 0.06, 0.005), (45, 0.1, 0.12)]
)
def test_generalised_wagner_against_the_exact_wedge(degrees, peak, force):
    found, exact = wedge(degrees, "generalised-wagner"), wedge(degrees, "similarity")
    assert float(found["peak_pressure"]) == pytest.approx(float(exact["peak_pressure"]), rel=peak)
    assert float(found["section_force"]) == pytest.approx(float(exact["section_force"]), rel=force)


def test_generalised_wagner_of_any_section():
    """The map of any section gives the closed one of the wedge; of a flat parabola, Wagner's wetting and force."""
    beta = np.radians(25)
    table = TableSection(tuple((y, y * np.tan(beta)) for y in (0.0, 0.7, 3.0)))
    speeding = VelocityHistory((0.0, 0.1, 0.2, 0.3), (2.0, 2.5, 3.0, 3.5))
    found, known = (
        entry(section, speeding, "generalised-wagner", 1.0, [0.3]) for section in (table, Wedge(beta))
    )
    for name in ("wetted_half_breadth", "wetted_rate", "section_force", "peak_pressure"):
        assert float(found[name][0]) == pytest.approx(float(known[name][0]), rel=1e-4)
    shallow = entry(Parabola(1.0), 1.0, "generalised-wagner", 1.0, [1e-5]).isel(time=0)
    assert float(shallow["wetted_half_breadth"]) == pytest.approx(2 * np.sqrt(1e-5), rel=2e-3)
    assert float(shallow["section_force"]) == pytest.approx(2 * np.pi, rel=0.015)


def test_circle_is_a_parabola_at_first_and_steeper_later():
    for method in ("wagner", "logvinovich", "generalised-wagner"):
        first, later = (
            [
                float(entry(section, 1.0, method, 1.0, [h])["section_force"][0])
                for section in (Circle(1.0), Parabola(1.0))
            ]
            for h in (1e-4, 0.1)
        )
        assert first[0] == pytest.approx(first[1], rel=1e-3)
        assert later[0] < 0.97 * later[1]


@pytest.mark.parametrize("method", FORCES)
def test_averages_over_the_whole_are_the_force_and_parts_add_up(method):
    found = wedge(25, method, panels=[(0, 8), (0, 1), (1, 1.5), (1.5, 8), (7, 8)])
    panel = found["panel_pressure"].to_numpy()
    assert panel[0] * 8 * 2 == pytest.approx(float(found["section_force"]), rel=1e-3)
    assert panel[1] + 0.5 * panel[2] + 6.5 * panel[3] == pytest.approx(8 * panel[0], rel=1e-12)
    assert panel[4] == pytest.approx(0, abs=1e-6 * panel[0])


@pytest.mark.parametrize("method", ["generalised-wagner", "logvinovich", "similarity"])
def test_averages_are_those_of_the_distribution(method):
    """Trapezoidal rule over the pressure points inside each panel."""
    edges = np.array([0.0, 0.4, 1.3, 2.0])
    found = wedge(25, method, panels=list(pairwise(edges)))
    y, pressure = (found[name].to_numpy() for name in ("pressure_position", "section_pressure"))
    fine = np.linspace(0, 2, 4001)
    running = np.append(
        0, np.cumsum((np.interp(fine, y, pressure)[1:] + np.interp(fine, y, pressure)[:-1]) / 2)
    )
    known = np.diff(np.interp(edges, fine, running) * fine[1]) / np.diff(edges)
    assert found["panel_pressure"].to_numpy() == pytest.approx(known, rel=2e-3)


def test_average_of_wagners_outer_pressure_in_closed_form():
    """(1/c) int_0^c of V c c'/sqrt(c**2 - y**2) = pi V c'/2, though the pressure is infinite at the edge."""
    c = np.pi / (2 * np.tan(0.2))
    found = entry(Wedge(0.2), 1.0, "wagner", 1.0, [1.0], panels=[(0, c), (0, c / 2)]).isel(time=0)
    assert found["panel_pressure"].to_numpy() == pytest.approx([np.pi / 2 * c, np.pi / 3 * c], rel=1e-5)


def test_similar_at_all_times_and_velocities():
    early, late = wedge(30, "similarity", 1.0, 0.1), wedge(30, "similarity", 4.0, 2.0)
    assert force_coefficient(early, 1.0, 0.1) == pytest.approx(force_coefficient(late, 4.0, 2.0))
    assert force_coefficient(early, 1.0, 0.1) == pytest.approx(14.02010, abs=1e-5)
    assert float(late["jet_height"]) == pytest.approx(1.83295 * 8, rel=1e-5)
    assert float(late["peak_height"]) == pytest.approx(0.42541 * 8, rel=1e-4)
    assert float(late["section_pressure"].max()) == pytest.approx(float(late["peak_pressure"]), rel=1e-3)


def test_chuang_through_the_same_interface():
    for degrees in (1.0, 2.2, 11.0, 20.0, 35.0):
        found = wedge(degrees, "chuang")
        k = 288 * float(chuang.impact_coefficient(np.radians(degrees)))
        assert float(found["peak_coefficient"]) == pytest.approx(k)
        assert np.isnan(float(found["section_force"]))


@pytest.mark.parametrize(
    ("degrees", "method", "words"),
    [
        (2, "logvinovich", "air is trapped"), (2.9, "similarity", "air is trapped"), (31, "wagner", "38 % at 20"),
        (46, "logvinovich", "below 45 degrees"), (46, "generalised-wagner", "11 % more force"),
        (50, "similarity", "jet tip"), (10, "von-karman", "no pile-up"), (10, "chuang", "neither force"),
    ],
)  # fmt: skip
def test_what_lies_outside_is_said(degrees, method, words):
    assert words in " ".join(warnings_of(wedge(degrees, method)))
    assert words not in " ".join(warnings_of(wedge(15, "generalised-wagner")))


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"velocity": 0.0}, "water exit"), ({"velocity": -2.0}, "water exit"), ({"velocity": np.nan}, "velocity"),
        ({"method": "magic"}, "method must be one of"),
        ({"density": 0.0}, "density"), ({"times": [0.0]}, "time after first contact"), ({"times": [2.0, 1.0]}, "grow"),
        ({"panels": [(1.0, 0.5)]}, "outer edge"), ({"section": Circle(1.0), "method": "similarity"}, "wedges only"),
        ({"section": Parabola(1.0), "method": "chuang"}, "wedges only"),
        ({"section": Wedge(1.3), "method": "logvinovich"}, "<= 70 degrees"),
        ({"velocity": VelocityHistory((0.0, 2.0), (1.0, 2.0)), "method": "similarity"}, "constant velocity"),
        ({"velocity": VelocityHistory((0.0, 0.5), (1.0, 2.0))}, "after the end"),
        ({"section": TableSection(((0.0, 0.0), (1.0, 0.3))), "method": "generalised-wagner"}, "end of the section"),
    ],
)  # fmt: skip
def test_refusals(given, words):
    values = {"section": Wedge(0.3), "velocity": 1.0, "method": "wagner", "times": [1.0], **given}
    with pytest.raises(InputError, match=words):
        entry(**values)


@pytest.mark.parametrize("given", [((0.0,), (1.0,)), ((0.1, 1.0), (1.0, 1.0)), ((0.0, 1.0), (1.0, -1.0))])
def test_velocity_histories_are_checked(given):
    with pytest.raises(InputError):
        VelocityHistory(*given)


def command(*words):
    from typer import Typer

    application = Typer()
    application.command()(entry_command.entry)
    return CliRunner().invoke(application, [*words, "--json"])


@pytest.mark.parametrize("method", METHODS)
def test_command_prints_one_object(method):
    done = command("--section", "wedge", "--deadrise-degrees", "20", "--method", method, "--velocity", "3")
    values = json.loads(done.stdout)
    assert (values["section"], values["method"]) == ("wedge", method)
    assert values["k"] == values["peak_pressure_coefficient"]
    if method == "similarity":
        assert values["k"] == pytest.approx(17.73499, abs=1e-4)
        assert values["force_coefficient"] == pytest.approx(42.27155, abs=1e-4)
        assert values["peak_height"] == pytest.approx(0.50786, abs=1e-4)
        assert values["wetted_rate"] == pytest.approx(1.50786 / np.tan(np.radians(20)), rel=1e-4)


@pytest.mark.parametrize("method", ["nonlinear", "von-karman", "chuang"])
def test_command_prints_a_history(method):
    words = ("--deadrise-degrees", "40", "--method", method, "--velocity", "4", "--penetration", "0.2")
    values = json.loads(command(*words, "--history", "4").stdout)
    history = values["history"]
    assert set(history) == {"time", "penetration", "force_per_length", "peak_pressure", "wetted_half_breadth"}
    assert history["penetration"] == pytest.approx([0.05, 0.1, 0.15, 0.2])
    assert history["time"] == pytest.approx([0.0125, 0.025, 0.0375, 0.05])
    for name in ("force_per_length", "peak_pressure", "wetted_half_breadth"):
        assert history[name][-1] == values[name]
        assert (history[name][0] is None) == (values[name] is None)
    assert "history" not in json.loads(command(*words).stdout)
    assert "history" in str(command(*words, "--history", "-1").exception)


def test_command_reads_a_section(tmp_path):
    path = tmp_path / "section.csv"
    path.write_text("# a bow section\ny,z\n0,0\n1,0.2\n2,0.6\n")
    values = json.loads(command("--section", str(path), "--method", "logvinovich").stdout)
    assert values["section"] == "table"
    assert values["force_coefficient"] is None
    assert values["force_per_length"] > 0
    for text in ("y,z\n0,0\n1,x\n", "y,z\n0\n1\n"):
        path.write_text(text)
        assert "two numbers" in str(command("--section", str(path)).exception)
    assert "CSV file" in str(command("--section", str(tmp_path / "none.csv")).exception)
    assert "--deadrise-degrees" in str(command().exception)
    assert "--radius" in str(command("--section", "circle").exception)
