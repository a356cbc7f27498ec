"""Loss of pressure ahead of a dry transom: closed forms and quadrature."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from workbench.hydrodynamics.near_transom import relaxation_length, transom_weights


def test_relaxation_length():
    """0.34 B C_V / 2.5 with C_V = U / sqrt(g B): 0.34 m for B = 1 m at C_V = 2.5."""
    assert relaxation_length(1.0, 2.5 * np.sqrt(9.80665)) == pytest.approx(0.34)
    assert relaxation_length(4.0, 10.0) == pytest.approx(0.136 * 4.0 * 10.0 / np.sqrt(9.80665 * 4.0))


def test_weights_are_integrals_of_the_factor():
    edges, transom, length = np.array([5.0, 1.0, -2.0, -3.1, -4.0, -4.5]), -4.0, 0.7
    found = transom_weights(edges, transom, length)
    for cell, (fore, aft) in enumerate(pairwise(edges)):
        start = max(aft, transom)
        whole = quad(lambda x: np.tanh((x - transom) / length), start, max(fore, transom))[0]
        slope = quad(
            lambda x: 1 / (length * np.cosh((x - transom) / length) ** 2), start, max(fore, transom)
        )[0]
        assert found.whole[cell] == pytest.approx(whole, abs=1e-9)
        assert found.slope[cell] == pytest.approx(slope, abs=1e-7)
    assert found.whole[-1] == found.slope[-1] == 0.0
    assert found.last == 0.0


def test_far_ahead_nothing_is_lost_and_without_release_nothing_at_all():
    edges = np.linspace(50.0, 0.0, 101)
    found = transom_weights(edges, 0.0, 1.3)
    np.testing.assert_allclose(found.whole[:60], 0.5, atol=1e-9)
    assert found.slope.sum() == pytest.approx(1.0)
    assert found.whole.sum() == pytest.approx(50.0 - 1.3 * np.log(2.0))
    plain = transom_weights(edges, 0.0, None)
    np.testing.assert_allclose(plain.whole, 0.5)
    assert not plain.slope.any()
    assert plain.last == 1.0
