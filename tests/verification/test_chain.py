"""Features of the chain from ship to slams that the table of features names, by number or refusal."""

import dataclasses

import numpy as np
import pytest

from workbench import pipeline
from workbench.errors import InputError
from workbench.hydrodynamics import potential_flow
from workbench.hydrodynamics.radiation import RadiationProblem, radiation
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.impact.pressure import PressureLaw
from workbench.relative_motion import incident_elevation, vertical_motion
from workbench.seas import Condition, SeaState
from workbench.time_domain import Realisation, components_from, records, time_histories, wave_components
from workbench.verification.ship_cases import twin

SETTINGS = PotentialFlowSettings(panels=300)
SEA = SeaState(significant_wave_height=2.0, peak_period=7.0)
HEAD = Condition(speed=0.0, wave_direction=np.pi, sea_state=SEA)


@pytest.fixture(scope="module")
def at_rest():
    return pipeline.response(twin(), 0.0, [np.pi], np.linspace(0.4, 1.6, 13), SETTINGS)


def test_realisations_follow_their_seed():
    first, again, other = (wave_components(HEAD, Realisation(seed=seed), 0.4, 1.6) for seed in (3, 3, 4))
    assert np.all(first.component_phase == again.component_phase)
    assert np.all(first.component_phase != other.component_phase)
    steps = np.diff(first.component_omega)
    assert steps.min() > 0
    assert np.ptp(steps) > 0.5 * steps.mean()  # uneven, so that nothing repeats


def test_time_histories_have_the_spectral_deviations(at_rest):
    components = wave_components(HEAD, Realisation(seed=11), 0.4, 1.6)
    histories = time_histories(components, at_rest.motions, 4 * 3600.0, 0.5)
    slam = pipeline.slamming(
        at_rest, pipeline.deck_response(at_rest, twin().wet_deck, (4, 3)), twin().wet_deck, HEAD
    )
    counted = histories.motion.std("time")
    expected = slam.motion_statistics.motion_std
    for mode in ("heave", "pitch"):
        assert float(counted.sel(dof=mode)) == pytest.approx(float(expected.sel(dof=mode)), rel=0.04)


def test_two_waves_beat():
    components = components_from([1.0, 1.2], [0.5, 0.5], [0.0, 0.0], np.pi, 0.0)
    amplitudes = (components.component_amplitude.values * np.exp(1j * components.component_phase.values))[
        :, None
    ]
    times = np.array([0.0, np.pi / 0.2, 2 * np.pi / 0.2])
    there = records(amplitudes, components.component_frequency.values, times)[0]
    assert there == pytest.approx([1.0, 0.0, 1.0], abs=1e-12)  # together, opposed, together again


def test_wagner_warns_of_small_angles():
    assert any("3 degrees" in sentence for sentence in PressureLaw(name="wagner").validity)
    assert not any("3 degrees" in sentence for sentence in PressureLaw(name="chuang").validity)


def test_a_raised_deck_keeps_the_relative_motion(at_rest):
    deck = twin().wet_deck
    raised = dataclasses.replace(deck, clearance=deck.clearance + 1.0)
    before, after = (pipeline.deck_response(at_rest, plan, (6, 3)) for plan in (deck, raised))
    assert np.all(before.relative_motion == after.relative_motion)
    low, high = (pipeline.slamming(at_rest, before, plan, HEAD) for plan in (deck, raised))
    rate, raised_rate = (slam.statistics.slams_per_hour.max().item() for slam in (low, high))
    assert 0 < raised_rate < 0.7 * rate
    assert high.least_clearance == pytest.approx(low.least_clearance, abs=1e-9)


def test_high_speed_is_warned_of():
    fast = pipeline.response(twin(), 8.0, [np.pi], [0.8, 1.0], SETTINGS)
    assert "Fn 0.40 is above 0.2" in fast.hydrodynamics.attrs["warnings"]


def test_waves_too_short_for_the_panels_are_refused():
    with pytest.raises(InputError, match="eight panel radii"):
        pipeline.response(twin(), 0.0, [np.pi], [1.0, 30.0], SETTINGS)


def test_disturbed_wave_is_incident_radiated_and_diffracted(at_rest):
    relative = pipeline.deck_response(at_rest, twin().wet_deck, (6, 3))
    alone = dataclasses.replace(at_rest, wave_field=None)
    undisturbed = pipeline.deck_response(alone, twin().wet_deck, (6, 3))
    x, y = np.meshgrid(relative.x.values, relative.y.values, indexing="ij")
    wave = incident_elevation(at_rest.motions.wavenumber.values[:, None], np.pi, x, y)
    deck = vertical_motion(at_rest.motions.motion_rao.values, (0, 0, 0), x, y)
    np.testing.assert_allclose(undisturbed.relative_motion.values, wave - deck, atol=1e-12)
    scattered = np.abs(relative.relative_motion.values - undisturbed.relative_motion.values).max(
        axis=(1, 2, 3)
    )
    assert scattered[-3:].min() > 0.1  # waves of the ship's length and shorter are disturbed
    assert scattered[0] < 0.5 * scattered.max()  # long ones hardly are


def test_disturbed_wave_is_capytaines():
    """Diffracted and radiated elevation between the hulls against Capytaine's own solution."""
    import capytaine as cpt  # the second code of this one test

    from workbench.geometry.panels import lid_panels, panels

    hull, omega = twin().hull, 1.1
    x, y = (-10.0, 0.0, 10.0), (-2.0, 0.0, 2.0)
    problem = RadiationProblem(panels=panels(hull, 300), lid=lid_panels(hull), field_x=x, field_y=y)
    ours = radiation(problem, [omega], [np.pi])

    body = potential_flow._body(problem.panels, problem.lid)
    solver = cpt.BEMSolver(
        engine=cpt.DefaultMatrixEngine(green_function=potential_flow._green_function("float64"))
    )
    common = {"body": body, "omega": omega, "rho": 1025.0, "g": 9.80665}
    points = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    heave = solver.solve(cpt.RadiationProblem(radiating_dof="Heave", **common), _check_wavelength=False)
    diffraction = solver.solve(
        cpt.DiffractionProblem(wave_direction=np.pi, **common), _check_wavelength=False
    )
    radiated, diffracted = (
        solver.compute_free_surface_elevation(points, result).reshape(3, 3) for result in (heave, diffraction)
    )
    np.testing.assert_allclose(ours.radiated_elevation.values[0, 2], radiated, atol=1e-3)
    np.testing.assert_allclose(ours.diffracted_elevation.values[0, 0], diffracted, atol=1e-3)
    assert np.abs(radiated).max() > 0.1
