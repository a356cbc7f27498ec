"""A design pressure on plate, stiffener and grillage, applied as if it were steady.

Bending of small deflections in the elastic range. The load is quasi-static where its
pulse is long against the natural period of the member: see `workbench.impact.pulse_response`.

.. [Timoshenko1959] S. Timoshenko and S. Woinowsky-Krieger, "Theory of plates and shells",
    2nd ed., McGraw-Hill, 1959, sections 2, 28, 44 and table 35.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial import polynomial

from workbench.errors import checked_number

RITZ_TERMS = 7
"""Even powers in each direction for the clamped rectangle; five significant digits of the edge moment."""


@dataclass(frozen=True, kw_only=True)
class Material:
    """Elastic material; steel unless given.

    Parameters
    ----------
    young : modulus [Pa]; poisson : ratio [-]; density : [kg/m3]; yield_stress : [Pa].
    """

    young: float = 206e9
    poisson: float = 0.3
    density: float = 7850.0
    yield_stress: float = 235e6

    def __post_init__(self):
        checked_number("Young's modulus", self.young, "Pa", above=0)
        checked_number("Poisson's ratio", self.poisson, at_least=0, below=0.5)
        checked_number("density of the material", self.density, "kg/m3", above=0)
        checked_number("yield stress", self.yield_stress, "Pa", above=0)

    def plate_rigidity(self, thickness: float) -> float:
        """E t^3/(12 (1 - nu^2)) [N m]."""
        return self.young * thickness**3 / (12 * (1 - self.poisson**2))


class Bending(NamedTuple):
    """Largest bending stress [Pa] and deflection [m] of a member."""

    stress: float
    deflection: float


def clamped_strip(
    pressure: float, width: float, thickness: float, material: Material | None = None
) -> Bending:
    """Long plate between stiffeners, clamped along both: stress p b^2/(2 t^2) at the edge, deflection p b^4/(384 D).

    Parameters
    ----------
    pressure : [Pa]; width : between the stiffeners; thickness : [m].
    """
    material = material or Material()
    checked_plate(width, thickness)
    deflection = pressure * width**4 / (384 * material.plate_rigidity(thickness))
    return Bending(pressure * width**2 / (2 * thickness**2), deflection)


class PlateCoefficients(NamedTuple):
    """Of a clamped rectangle: w D/(p a^4) at the centre, M/(p a^2) at the middle of the long edge and at the centre."""

    deflection: float
    edge_moment: float
    centre_moment: float


def clamped_rectangle_coefficients(aspect: float, poisson: float = 0.3) -> PlateCoefficients:
    """Coefficients of a uniformly loaded clamped rectangle (a few hundred microseconds).

    Parameters
    ----------
    aspect : long side over short side a, >= 1; from 3 on the strip's values hold to 0.1 %.

    Notes
    -----
    Ritz's method with (1 - x^2)^2 (1 - y^2)^2 times even powers, held against the
    published table 35 of [Timoshenko1959]_. The edge moment is counted positive.
    """
    checked_number("aspect ratio", aspect, at_least=1, at_most=5, cure="beyond 5 take the strip")
    base = polynomial.polypow([1, 0, -1], 2)
    shapes = [polynomial.polymul(base, np.eye(2 * n + 1)[2 * n]) for n in range(RITZ_TERMS)]
    nodes, weights = np.polynomial.legendre.leggauss(2 * RITZ_TERMS + 4)
    at = np.array([polynomial.polyval(nodes, shape) for shape in shapes])
    bent = np.array([polynomial.polyval(nodes, polynomial.polyder(shape, 2)) for shape in shapes])
    mass, mixed, stiff = (at * weights) @ at.T, (at * weights) @ bent.T, (bent * weights) @ bent.T
    loads = at @ weights
    # x along the short side a, y along the long side b, both from -1 to 1; r = (a/b)^2
    r = 1 / aspect**2
    cross = np.einsum("ik,jl->ijkl", mixed, mixed.T)
    cross = cross + np.einsum("ik,jl->ijkl", mixed.T, mixed)
    energy = np.einsum("ik,jl->ijkl", stiff, mass) + r * cross + r**2 * np.einsum("ik,jl->ijkl", mass, stiff)
    size = RITZ_TERMS**2
    solved = np.linalg.solve(energy.reshape(size, size), np.outer(loads, loads).ravel()).reshape(
        RITZ_TERMS, RITZ_TERMS
    )
    centre = np.array([polynomial.polyval(0.0, shape) for shape in shapes])
    bent_centre = np.array([polynomial.polyval(0.0, polynomial.polyder(shape, 2)) for shape in shapes])
    bent_edge = np.array([polynomial.polyval(1.0, polynomial.polyder(shape, 2)) for shape in shapes])
    along = bent_centre @ solved @ centre
    across = centre @ solved @ bent_centre
    return PlateCoefficients(
        float(centre @ solved @ centre) / 16,
        float(bent_edge @ solved @ centre) / 4,
        float(-(along + poisson * r * across)) / 4,
    )


def clamped_rectangle(
    pressure: float, short: float, long: float, thickness: float, material: Material | None = None
) -> Bending:
    """Plate field between stiffeners and frames, clamped all round: stress at the middle of the long edge.

    Parameters
    ----------
    pressure : [Pa]; short, long : sides; thickness : [m].
    """
    material = material or Material()
    checked_plate(short, thickness)
    if long > 5 * short:
        return clamped_strip(pressure, short, thickness, material)
    found = clamped_rectangle_coefficients(long / short, material.poisson)
    deflection = found.deflection * pressure * short**4 / material.plate_rigidity(thickness)
    return Bending(6 * found.edge_moment * pressure * short**2 / thickness**2, deflection)


def clamped_beam(
    pressure: float, spacing: float, span: float, modulus: float, inertia: float, young: float = 206e9
) -> Bending:
    """Stiffener with its plating, clamped at the frames: stress q l^2/(12 Z) there, deflection q l^4/(384 E I).

    Parameters
    ----------
    pressure : [Pa]; spacing : of the stiffeners; span : between the frames [m].
    modulus : section modulus [m3]; inertia : second moment of area [m4]; young : [Pa].
    """
    for name, value, unit in (("spacing", spacing, "m"), ("span", span, "m"), ("modulus", modulus, "m3")):
        checked_number(name, value, unit, above=0)
    checked_number("inertia", inertia, "m4", above=0)
    line_load = pressure * spacing
    return Bending(line_load * span**2 / (12 * modulus), line_load * span**4 / (384 * young * inertia))


@dataclass(frozen=True, kw_only=True)
class Beams:
    """One family of beams of a grillage.

    Parameters
    ----------
    spacing : [m]; inertia : with the effective plating [m4]; modulus : [m3].
    """

    spacing: float
    inertia: float
    modulus: float

    def __post_init__(self):
        checked_number("spacing of beams", self.spacing, "m", above=0)
        checked_number("inertia of beams", self.inertia, "m4", above=0)
        checked_number("modulus of beams", self.modulus, "m3", above=0)


class GrillageBending(NamedTuple):
    """Deflection at the centre [m], and bending stress there in the beams along and across [Pa]."""

    deflection: float
    stress_along: float
    stress_across: float


def grillage(
    pressure: float,
    length: float,
    breadth: float,
    along: Beams,
    across: Beams,
    young: float = 206e9,
    terms: int = 49,
) -> GrillageBending:
    """Grillage simply supported all round under a uniform pressure, as an orthotropic plate without torsion.

    Parameters
    ----------
    pressure : [Pa]; length, breadth : of the panel [m].
    along : beams along the length; across : beams along the breadth; young : [Pa].
    terms : largest odd number of half-waves.

    Notes
    -----
    Navier's series ([Timoshenko1959]_ 85) with D = E I/spacing in each direction and no
    twisting stiffness, which is on the safe side. Three beams a direction or more.
    """
    checked_number(
        "length of the grillage", length, "m", above=3 * across.spacing, cure="fewer beams are no grillage"
    )
    checked_number(
        "breadth of the grillage", breadth, "m", above=3 * along.spacing, cure="fewer beams are no grillage"
    )
    rigid_along, rigid_across = young * along.inertia / along.spacing, young * across.inertia / across.spacing
    return _orthotropic(pressure, length, breadth, rigid_along, rigid_across, 0.0, along, across, terms)


def _orthotropic(pressure, length, breadth, rigid_x, rigid_y, twist, along, across, terms) -> GrillageBending:
    half_waves = np.arange(1, terms + 1, 2)
    m, n = half_waves[:, None] / length, half_waves[None, :] / breadth
    load = 16 * pressure / (np.pi**2 * np.outer(half_waves, half_waves))
    stiffness = np.pi**4 * (rigid_x * m**4 + 2 * twist * m**2 * n**2 + rigid_y * n**4)
    signs = (-1.0) ** ((half_waves - 1) // 2)
    shape = load / stiffness * np.outer(signs, signs)
    moment_x = rigid_x * float(np.sum(shape * (np.pi * m) ** 2))
    moment_y = rigid_y * float(np.sum(shape * (np.pi * n) ** 2))
    return GrillageBending(
        float(np.sum(shape)),
        moment_x * along.spacing / along.modulus,
        moment_y * across.spacing / across.modulus,
    )


def checked_plate(width: float, thickness: float) -> None:
    """Refuse a plate whose width or thickness [m] makes it none."""
    checked_number("width of the plate", width, "m", above=0)
    checked_number(
        "thickness of the plate", thickness, "m", above=0, at_most=width / 5, cure="a thicker one is no plate"
    )
