import numpy as np
import pytest

from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.heeled import heeled
from workbench.geometry.hydrostatics import hydrostatics
from workbench.geometry.mesh import wet_hulls
from workbench.shapes import HeavyLiftBox, Wigley

SHAPE = Wigley(length=40.0, beam=4.0, draught=2.0, depth=6.0)
TWIN = Hull(shape=SHAPE, count=2, spacing=10.0)
MASS = float(hydrostatics(TWIN, 1025.0).displacement)


@pytest.mark.parametrize("heel", np.radians([-12.0, -4.0, 0.0, 4.0, 12.0]))
def test_ship_displaces_its_mass_at_any_heel(heel):
    found = heeled(TWIN, MASS, 1025.0, heel)
    assert found.heel == heel
    assert float(hydrostatics(found, 1025.0).displacement) == pytest.approx(MASS, rel=2e-3)


def test_upright_ship_stays_and_a_heavier_one_sinks():
    assert heeled(TWIN, MASS, 1025.0, 0.0).sinkage == pytest.approx(0.0, abs=2e-3)
    box = Hull(shape=HeavyLiftBox(
        length=60.0, beam=8.0, draught=3.0, depth=8.0, bilge_radius=0.0, bow_length=0.0, stern_length=0.0
    ))  # fmt: skip
    sunk = heeled(box, 1025.0 * 60 * 8 * 3.5, 1025.0, 0.0)
    assert sunk.sinkage == pytest.approx(0.5, rel=1e-3)


def test_a_ship_may_fly_a_hull_and_not_drown_one():
    light = heeled(TWIN, 0.5 * MASS, 1025.0, np.radians(16.0))
    assert len(wet_hulls(light)) == 1
    with pytest.raises(InputError, match="deck edge dry, got 28 degrees"):
        heeled(TWIN, 2.5 * MASS, 1025.0, np.radians(28.0))
    with pytest.raises(InputError, match="mass must be"):
        heeled(TWIN, 0.0, 1025.0, 0.0)
