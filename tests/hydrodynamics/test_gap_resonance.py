import numpy as np
import pytest

from workbench import cache, pipeline
from workbench.conventions import GRAVITY
from workbench.errors import InputError
from workbench.hulls import library
from workbench.hydrodynamics.gap_resonance import gap_resonance
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.radiation_store import usual_tasks


def test_piston_of_a_narrow_gap_is_the_draught_pendulum():
    """b -> 0: the water column of depth T swings like sqrt(g/T)."""
    assert gap_resonance(1e-6, 5.0, 4.0).piston == pytest.approx(np.sqrt(GRAVITY / 4.0), rel=1e-3)
    assert gap_resonance(13.4, 5.2, 2.11).sloshing == pytest.approx(np.sqrt(2 * np.pi * GRAVITY / 13.4))


@pytest.mark.parametrize("name", ["delft-372", "austal-63", "incat-061"])
def test_estimate_is_near_the_first_peak_of_the_panel_method(name):
    design = library.design(name)
    solved = cache._shipped(usual_tasks(design.hull, 0.0)[0].key)
    wave = (
        np.abs(solved.radiated_elevation.sel(radiating_dof="heave").isel(field_y=3))
        .max("field_x")
        .values[:-1]
    )
    first = 1 + int(np.flatnonzero((wave[1:-1] > wave[:-2]) & (wave[1:-1] > wave[2:]))[0])
    found = pipeline.response(design, 0.0)
    estimate = found.hydrodynamics.attrs["gap_piston_frequency"]
    assert estimate == pytest.approx(float(solved.encounter_omega[first]), rel=0.06)
    assert f"near {estimate:.3g} rad/s" in found.hydrodynamics.attrs["warnings"]


def test_tunnel_damping_calms_the_motion_of_the_water_and_is_not_warned_of(twin):
    omega = np.linspace(1.0, 1.8, 5)
    plain, damped = (
        pipeline.response(
            twin, 0.0, [np.pi], omega, PotentialFlowSettings(panels=300, tunnel_damping=damping)
        )
        for damping in (0.0, 0.05)
    )
    highest = [float(np.abs(found.wave_field.radiated_elevation).max()) for found in (plain, damped)]
    assert highest[1] < highest[0]
    assert "resonates" not in damped.hydrodynamics.attrs["warnings"]


def test_bad_gap_is_refused():
    with pytest.raises(InputError, match="gap"):
        gap_resonance(0.0, 2.0, 1.0)
