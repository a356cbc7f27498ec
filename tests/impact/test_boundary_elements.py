"""Boundary elements: integrals against quadrature, and flows that are known."""

import numpy as np
import pytest
from scipy.integrate import quad

from workbench.impact.boundary_elements import Boundary, far_dipole, far_source, layers

POINTS = (0.3 - 0.5j, 2.0 - 0.1j, 0.1 - 3.0j, 2.9 + 0.2j)


@pytest.mark.parametrize("point", [0.4 + 0.9j, -3.0 + 0.1j, 1.0 - 0.2j])
def test_influence_of_an_element_against_quadrature(point):
    start, end = 0.2 + 0.1j, 1.4 - 0.5j
    found = layers(np.array([point]), np.array([start, end]))
    length = abs(end - start)
    normal = 1j * (end - start) / length

    def integral(kernel, weight):
        return length * quad(lambda s: weight(s) * kernel(start + s * (end - start)), 0, 1, epsabs=1e-12)[0]

    kernels = (
        lambda x: np.log(abs(x - point)),
        lambda x: ((x - point) * np.conj(normal)).real / abs(x - point) ** 2,
    )
    known = [integral(kernel, weight) for kernel in kernels for weight in (lambda s: 1 - s, lambda s: s)]
    assert [float(part[0, 0]) for part in found] == pytest.approx(known, abs=1e-10)


def test_influence_on_its_own_ends():
    """At the start of an element of length L: integral of log s (1 - s/L) and of log s s/L; no dipole."""
    length = 0.7
    found = layers(np.array([0j, length + 0j]), np.array([0j, length + 0j]))
    whole, second = length * (np.log(length) - 1), length * (np.log(length) / 2 - 0.25)
    assert found.source_second[0, 0] == pytest.approx(second)
    assert found.source_first[0, 0] == pytest.approx(whole - second)
    assert found.source_first[1, 0] == pytest.approx(second)
    assert not found.dipole_first.any()
    assert not found.dipole_second.any()


@pytest.mark.parametrize("point", POINTS)
def test_far_field_against_quadrature(point):
    """The closed integral of eq. 6.7, and that of the normal derivative."""
    edge, z = 3.0, point.imag

    def beyond(kernel):
        return sum(
            quad(kernel, edge, np.inf, args=(side,), epsabs=1e-12)[0] for side in (point.real, -point.real)
        )

    source = beyond(lambda x, at: np.log(np.hypot(x - at, z)) / x**2)
    normal = beyond(lambda x, at: -z / ((x - at) ** 2 + z**2))
    assert far_source(np.array([point]), edge)[0] == pytest.approx(source, abs=1e-10)
    assert far_dipole(np.array([point]), edge)[0] == pytest.approx(normal, abs=1e-10)
    assert far_dipole(np.array([point.real + 0j]), edge)[0] == 0


def test_half_circle_under_a_level_surface():
    """Radius 1, downwards at 1 m/s, phi = 0 on the water: the dipole z/(y**2 + z**2); error of second order."""
    errors = []
    for count in (20, 40):
        body = np.exp(1j * np.linspace(-np.pi / 2, 0, count + 1))
        body[0], body[-1] = -1j, 1.0
        nodes = np.concatenate([body, np.exp(np.linspace(0, np.log(15), count + 1))[1:] + 0j])
        boundary = Boundary(nodes, count, 0)
        potential, flux = boundary.solve(np.zeros(count + 1), -boundary.normal[:count].imag, 0.0)
        errors.append(np.abs(potential[:count] - body[:-1].imag).max())
        assert flux[count // 2 :] == pytest.approx(1 / nodes[count + count // 2 :].real ** 2, rel=2e-2)
    assert errors[1] < 3e-4
    assert errors[0] / errors[1] > 3.5


def test_corner_of_a_cut_and_the_free_surface():
    """The dipole again, with a cut from the circle outwards and a free surface that starts below calm water."""
    count, across = 40, 8
    body = np.exp(1j * np.linspace(-np.pi / 2, -0.9, count + 1))
    body[0] = -1j
    tip = 1.2 * body[-1]
    cut = body[-1] + (tip - body[-1]) * np.arange(1, across) / across
    sloping = tip + (3.0 - tip) * np.linspace(0, 1, 3 * count) ** 1.5
    nodes = np.concatenate([body, cut, sloping, np.linspace(3, 20, 2 * count)[1:] + 0j])
    boundary = Boundary(nodes, count, across)
    exact = nodes.imag / np.abs(nodes) ** 2
    gradient = np.conj(-1j / nodes**2)  # of Re(i/x)
    middle = (body[1:] + body[:-1]) / 2
    flux = (np.conj(-1j / middle**2) * np.conj(boundary.normal[:count])).real
    corner = count + across
    along = sloping[1] - sloping[0]
    slope = float((gradient[corner] * np.conj(along / abs(along))).real)
    potential, normal = boundary.solve(exact[count:], flux, slope)
    assert np.abs(potential[:count] - exact[:count]).max() < 1e-3
    known = (gradient[corner:-1] * np.conj(boundary.normal[corner:])).real
    assert normal[across + 1 : across + 60] == pytest.approx(known[1:60], abs=0.01)
    in_cut = (gradient[count:corner] * np.conj(boundary.normal[count:corner])).real
    assert normal[2:across] == pytest.approx(in_cut[2:], abs=0.02)
