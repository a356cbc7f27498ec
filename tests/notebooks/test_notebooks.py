"""Every notebook runs from top to bottom and stores no output; its last cell holds its numbers."""

import ast
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from tests.conftest import VERDICTS

FOLDER = Path(__file__).parents[2] / "notebooks"
NAMES = sorted(path.name for path in FOLDER.glob("*.ipynb"))


def executed(name: str):
    notebook = nbformat.read(FOLDER / name, as_version=4)
    NotebookClient(
        notebook, timeout=560, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}
    ).execute()
    return notebook


def outputs(notebook) -> list:
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


def numbers(notebook) -> dict:
    """Dictionary that the last cell shows."""
    return ast.literal_eval(notebook.cells[-1].outputs[-1].data["text/plain"])


@pytest.mark.parametrize("name", NAMES)
def test_notebook_is_valid_and_stores_no_output(name):
    notebook = nbformat.read(FOLDER / name, as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert code
    assert all(not cell.outputs and cell.execution_count is None for cell in code)


def test_every_notebook_is_run_here():
    tested = {
        "cross-structure-slamming.ipynb",
        "first-steps.ipynb",
        "records.ipynb",
        "verification.ipynb",
        "water-entry.ipynb",
    }
    assert tested <= set(NAMES)
    assert set(NAMES) <= {*tested, "workbench.ipynb"}


@pytest.mark.slow
def test_first_steps():
    notebook = executed("first-steps.ipynb")
    found = numbers(notebook)
    assert found["displacement"] == pytest.approx(1.255e6, rel=0.005)
    assert found["slams_per_hour"] == pytest.approx(56.7, rel=0.05)
    low, high = found["counted_band"]
    assert low < found["slams_per_hour"] < high
    assert low < found["counted_per_hour"] < high
    assert 2e6 < found["largest_pressure"] < 3.5e6
    assert found["least_clearance"] == pytest.approx(3.03, abs=0.05)
    variants = list(found["variants"].values())
    assert variants[0] == found["slams_per_hour"]
    assert all(rate < variants[0] for rate in variants[1:])
    assert found["frames"] > 100
    assert 5 < found["deck_slams"] < 40
    assert 2e5 < found["largest_panel_pressure"] < found["largest_pressure"]
    kinds = [kind for output in outputs(notebook) for kind in output.get("data", {})]
    assert kinds.count("image/png") == 7
    assert kinds.count("application/vnd.jupyter.widget-view+json") == 2


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_verification(request):
    notebook = executed("verification.ipynb")
    found = numbers(notebook)
    request.config.stash[VERDICTS] = found["verdicts"]
    assert found["passed"] is True
    assert found["counts"]["fails"] == 0
    assert found["counts"]["agrees"] > 100
    differences = found["mean_differences"]
    assert differences["heave Fn 0.3 together"] == pytest.approx(0.096, abs=0.02)
    assert differences["pitch Fn 0.3 apart"] == pytest.approx(0.098, abs=0.02)
    assert differences["heave Fn 0.75 apart"] == pytest.approx(0.183, abs=0.02)
    at_30 = {theory: values[3] for theory, values in found["wedge_force"].items()}
    assert at_30["similarity"] == 1.0
    assert at_30["nonlinear"] == pytest.approx(1.0, abs=0.03)
    assert at_30["logvinovich"] == pytest.approx(15.0857 / 14.0201, abs=1e-3)
    assert at_30["wagner"] == pytest.approx(23.2547 / 14.0201, abs=1e-3)
    assert at_30["von-karman"] < 1 < at_30["generalised-wagner"] < 1.1
    assert at_30["chuang"] is None
    theories = found["theories"]
    assert theories["high-speed Fn 0.75"] == pytest.approx(0.054, abs=0.015)
    assert theories["high-speed Fn 0.3"] == pytest.approx(0.057, abs=0.015)
    assert theories["strip Fn 0.3"] == pytest.approx(0.13, abs=0.02)
    assert theories["potential-flow Fn 0.3"] == pytest.approx(0.127, abs=0.02)
    assert sum("image/png" in output.get("data", {}) for output in outputs(notebook)) == 7


@pytest.mark.slow
def test_records():
    notebook = executed("records.ipynb")
    found = numbers(notebook)
    assert found["significant_wave_height"] == pytest.approx(1.8, rel=0.05)
    assert found["wave_error"] < 0.1
    assert found["wrong_sign"] > 3
    assert all(error < 0.03 for error in found["response_errors"].values())
    assert abs(found["lead_error"]) < 0.15
    assert found["ringing_hz"] == pytest.approx(6.0, rel=0.02)
    hits, missed, false = found["by_filter"]
    assert hits + missed == found["slams"] > 20
    assert hits > 0.9 * found["slams"]
    assert false <= 2
    assert found["by_threshold"][2] > 5 * max(false, 1)
    assert found["verdicts"] == {"heave": True, "pitch": True, "vertical acceleration": False}
    assert sum("image/png" in output.get("data", {}) for output in outputs(notebook)) == 6


@pytest.mark.slow
def test_cross_structure_slamming():
    notebook = executed("cross-structure-slamming.ipynb")
    found = numbers(notebook)
    assert found["slams"] == 4
    assert found["excluded"] == [0, 0, 1, 0]
    assert abs(found["k_error"]) < 0.05
    assert found["unshifted_error"] > 0.2
    assert found["mean_ratio"] == pytest.approx(1.036, abs=5e-4)
    assert found["matched_ratio"] == pytest.approx(0.852, abs=1e-3)
    assert found["hayes"] == pytest.approx([1.147, 0.919], abs=1e-3)
    assert found["ratios"] == pytest.approx([5.23, 3.55], abs=0.005)
    assert found["peak_kpa"] == pytest.approx(257, rel=0.05)
    assert found["bulkhead_kpa"] == pytest.approx(532, rel=0.01)
    assert found["limits"] >= 10
    assert sum("image/png" in output.get("data", {}) for output in outputs(notebook)) == 7


@pytest.mark.slow
def test_water_entry():
    notebook = executed("water-entry.ipynb")
    found = numbers(notebook)
    assert found["exact_peak_10"] == pytest.approx(77.69831, rel=1e-4)
    assert found["exact_force_20"] == pytest.approx(42.2716, rel=1e-3)
    force, peak = found["force_over_exact_20"], found["peak_over_exact_30"]
    assert force["wagner"] == pytest.approx(1.384, abs=0.002)
    assert force["von-karman"] == pytest.approx(1.384 * 4 / 9.8696, abs=0.002)
    assert abs(force["generalised-wagner"] - 1) < 0.04
    assert force["chuang"] is None
    assert peak["logvinovich"] == pytest.approx(9.6196 / 6.89476, abs=1e-3)
    assert peak["wagner"] < 1.08
    for method, averages in found["panel_k"].items():
        assert averages == sorted(averages, reverse=True)
        if method != "wagner":
            assert averages[0] < found["exact_peak_10"] * 1.06
            assert averages == pytest.approx(found["panel_k"]["similarity"], rel=0.1)
    assert found["crest_radius"] == pytest.approx(214.7, rel=1e-3)
    assert found["crest_warns_of_air"] is True
    assert found["refused"] == ["chuang", "similarity"]
    own = found["own_panel"]
    assert own["von-karman"] < own["generalised-wagner"] < own["wagner"]
    kinds = [kind for output in outputs(notebook) for kind in output.get("data", {})]
    assert kinds.count("image/png") == 3
    assert kinds.count("application/vnd.jupyter.widget-view+json") == 3


@pytest.mark.slow
@pytest.mark.skipif("workbench.ipynb" not in NAMES, reason="the app's notebook is not here")
def test_app_notebook_shows_the_app():
    notebook = executed("workbench.ipynb")
    kinds = [kind for output in outputs(notebook) for kind in output.get("data", {})]
    assert "application/vnd.jupyter.widget-view+json" in kinds
