"""Panels of the source with where they come from, and k computed by the theories of water entry."""

import dataclasses

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.impact.panel_library import PANELS, PanelCoefficient, computed_panel, panel_coefficient
from workbench.impact.pressure import PressureLaw
from workbench.impact.section import TableSection, Wedge

POD = {"name": "pod", "vessel": "crowther-318", "panel": "pod", "section_direction": "transverse"}


def test_published_panels_and_their_pressures():
    """Tables 7.1-7.3 of Grande 2002: 113.7, 2.71, 40.8; 932 kPa at 4 m/s."""
    assert [panel.coefficient for panel in PANELS] == [113.7, 2.71, 40.8]
    assert panel_coefficient("austal-63 wet deck").pressure(4.0) / 1e3 == pytest.approx(932.0, abs=0.5)
    assert panel_coefficient("crowther-318 pod").pressure(4.0, 1025.0) == pytest.approx(22_222.0)
    for panel in PANELS:
        assert "Grande" in panel.source
        assert "table 7" in panel.source
        assert "SLAM2D" in panel.method
        assert panel.law == PressureLaw(name="panel", coefficient=panel.coefficient)
    assert [panel.section_direction for panel in PANELS] == ["longitudinal", "transverse", "longitudinal"]


@pytest.mark.parametrize("method", ["generalised-wagner", "logvinovich"])
def test_pod_computed_is_the_published_pod(method):
    """45 degrees, 0.4 m wide: 2.71 by the boundary elements of the source; theories of small deadrise within 6 %."""
    found = computed_panel(Wedge(np.radians(45.0)), 0.0, 0.2, method=method, **POD)
    assert found.coefficient == pytest.approx(2.71, rel=0.06)
    assert found.source == "computed here"
    assert method in found.method


def test_wagners_average_in_closed_form():
    """Outer pressure pi cot(b)/sqrt(1 - s**2) averaged over [0, c], c the edge: pi/2 times pi cot(b)."""
    wedge = Wedge(np.radians(10.0))
    found = computed_panel(wedge, 0.0, 0.5, method="wagner", **POD)
    assert found.coefficient == pytest.approx(np.pi**2 / 2 / np.tan(np.radians(10.0)), rel=0.03)


def test_panels_away_from_the_apex_are_hit_less_than_the_peak():
    table = TableSection(((0.0, 0.0), (1.0, 0.15), (2.0, 0.4)))
    found = computed_panel(table, 0.5, 0.9, method="logvinovich", **POD)
    assert 5.0 < found.coefficient < (np.pi / 2 / 0.15) ** 2


def test_a_panel_says_whose_it_is():
    with pytest.raises(InputError, match="panel must be one of austal-63 wet deck"):
        panel_coefficient("bow")
    with pytest.raises(InputError, match="source of the panel must be text"):
        PanelCoefficient(**POD, coefficient=2.0, method="guess", source="")
    with pytest.raises(InputError, match="section direction of pod"):
        dataclasses.replace(PANELS[0], name="pod", section_direction="up")
    with pytest.raises(InputError, match="coefficient of pod"):
        PanelCoefficient(**POD, coefficient=0.0, method="guess", source="mine")
    with pytest.raises(InputError, match="no average over a panel"):
        computed_panel(Wedge(0.3), 0.0, 0.2, method="chuang", **POD)
    with pytest.raises(InputError, match="outer edge"):
        computed_panel(Wedge(0.3), 0.2, 0.1, **POD)
