"""From two waves to the pressures of a slam on the heavy-lift model, with our kinematics and with the source's."""

import numpy as np
import pytest

from workbench import quantities
from workbench.time_domain import motion_amplitudes
from workbench.verification import amin_conflicts
from workbench.verification import heavy_lift_slam as chain


def test_flat_deck_is_that_of_the_table():
    deck = chain.deck()
    assert float(deck.area.sum()) == pytest.approx(0.705 * 0.166)
    np.testing.assert_allclose(deck.height, 0.0397, atol=1e-4)


def test_waves_are_the_sines_of_the_source_at_the_centre_of_gravity():
    waves = chain.waves()
    centre = chain.ship().motions.attrs["centre_of_gravity"][0]
    at_centre = waves.component_amplitude * np.exp(1j * (waves.component_phase + waves.component_kx * centre))
    np.testing.assert_allclose(at_centre, -1j * 0.0175)
    assert "only nearly" in chain.window().sentence


def test_the_source_lacks_radiated_waves_and_turns_the_pitch():
    """The two kinematics differ by the radiated waves and by twice the pitch term, and by nothing in heave."""
    ours, slope = chain.amplitudes("ours")
    theirs, same = chain.amplitudes("source")
    np.testing.assert_array_equal(slope, same)
    x = chain.deck().x.values - chain.ship().motions.attrs["centre_of_gravity"][0]
    pitch = motion_amplitudes(chain.waves(), chain.ship().motions)[:, 4]
    radiated = ours - theirs - 2 * x[:, None] * pitch[:, None, None]
    share = np.abs(radiated).max(axis=(1, 2)) / 0.0175
    assert 0.3 < share[0] < 2.0  # of the wave amplitude, in the short waves
    assert 0.1 < share[1] < 0.6 * share[0]  # less in the long ones, which carry the ship


def test_with_the_source_kinematics_the_model_slams_aft_and_with_ours_amidships():
    aft = chain.immersed("source").immersion_depth.sel(x=slice(None, -0.25))
    assert float(aft.max()) == pytest.approx(0.008, abs=0.002)
    ours = chain.immersed("ours")
    assert not ours.ever_wet.sel(x=slice(None, -0.15)).any()
    assert 0.0005 < float(ours.immersion_depth.max()) < 0.003
    counts = chain.immersed("source").immersion_count
    assert int(counts.max()) == 3  # three significant slams, as in the source's figure 6.7
    assert float((counts.sel(x=slice(-0.15, 0.03)) == 0).mean()) > 0.95  # the centre hardly ever wet


@pytest.mark.parametrize("kinematics", chain.KINEMATICS)
def test_four_pressures_have_one_slam_and_finite_loads(kinematics):
    made = chain.pressures(kinematics)
    assert list(made) == [
        ("linear", "mean"),
        ("linear", "cubic"),
        ("quadratic", "mean"),
        ("quadratic", "cubic"),
    ]
    slam = chain.slam(kinematics)
    impulses = []
    for found in made.values():
        assert found.sizes == {"time": 501, "point": slam.sizes["event"]}
        assert float(found.time[-1]) == pytest.approx(slam.attrs["spread"])
        assert np.isfinite(found.deck_pressure.values).all()
        assert float(found.deck_pressure.min()) >= 0.0
        np.testing.assert_allclose(found.deck_force, found.deck_pressure.values @ found.area.values)
        assert np.all(np.diff(found.running_impulse) >= 0)
        impulses.append(float(found.running_impulse[-1]))
        assert any("5 degrees" in note for note in quantities.warnings_of(found))
    assert max(impulses) < 3 * min(impulses)
    if kinematics == "source":  # order: 10-20 N, 0.1-0.25 N s on a model of 14.5 kg
        assert 0.1 < min(impulses) < max(impulses) < 0.3
        assert 0.1 < float(slam.entry_velocity.max()) < 0.3


def test_contradictions_of_the_incat_document_carry_their_numbers():
    found = amin_conflicts.conflicts()
    assert len(found) == 5
    words = " ".join(one.found for one in found)
    for number in ("40.0 %", "44.8 %", "48.6", "14.0", "4.59e+06 to 6.22e+06", "0.24 to 0.24 m", "57.75"):
        assert number in words
    assert amin_conflicts.load_differences(856.14)["of peak"] == pytest.approx(28.56, abs=0.01)
    np.testing.assert_allclose(amin_conflicts.origin_shift(), 0.24, atol=1e-9)
