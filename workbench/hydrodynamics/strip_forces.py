"""Forces on the strips of one body: radiation, diffraction, Froude-Krylov, and the terms of speed.

Sway, heave and roll of each section (`sections`, `section_waves`) times their levers: pitch is
-x times heave, yaw x times sway. The Froude-Krylov force in surge, and what it adds in pitch
and yaw, is that of the closed hull, the transom as if it were wet.
"""

from dataclasses import fields
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from workbench.conventions import GRAVITY
from workbench.hydrodynamics.section_waves import (
    Waves,
    froude_krylov_density,
    haskind_density,
    lengthwise_density,
    orbital_decay,
)
from workbench.hydrodynamics.sections import WettedPanels, sectional_matrix
from workbench.hydrodynamics.speed_terms import VENTILATION_FROUDE_NUMBER, force_with_speed, with_speed
from workbench.hydrodynamics.strip_sections import StripBody, Transom
from workbench.hydrodynamics.strip_settings import StripSettings

LARGEST_BATCH = 2_000_000


class StripForces(NamedTuple):
    """Complex forces about the body's axes: (waves, 6, 6), (waves, 6), (waves, 6)."""

    radiation: np.ndarray
    froude_krylov: np.ndarray
    diffraction: np.ndarray


def frequency_nodes(frequency: np.ndarray, count: int, length: float) -> np.ndarray:
    """Frequencies at which sections are solved to serve the given ones [rad/s].

    The given ones themselves when they are few; otherwise closer at the low end, even in
    ln(1 + omega/omega_0) with omega_0 = sqrt(g/length), ``length`` the breadth of a section.
    """
    distinct = np.unique(frequency)
    if len(distinct) <= count:
        return distinct
    scale = np.sqrt(GRAVITY / length)
    ends = np.log1p(distinct[[0, -1]] / scale)
    return scale * np.expm1(np.linspace(*ends, count))


def between_nodes(nodes: np.ndarray, values: np.ndarray, frequency: np.ndarray) -> np.ndarray:
    """Values (nodes, ...) at other frequencies inside the nodes, by a cubic spline."""
    inside = np.clip(frequency, nodes[0], nodes[-1])
    if np.all(np.isin(inside, nodes)):
        return values[np.searchsorted(nodes, inside)]
    return CubicSpline(nodes, values, axis=0)(inside)


def lever_matrix(x: np.ndarray, formulation: str) -> np.ndarray:
    """Sway, heave and roll of sections at x from the six motions of the body, (stations, 3, 6)."""
    matrix = np.zeros((len(x), 3, 6))
    matrix[:, 1, 2], matrix[:, 1, 4] = 1.0, -x
    if formulation == "full":
        matrix[:, 0, 1], matrix[:, 0, 5], matrix[:, 2, 3] = 1.0, x, 1.0
    return matrix


def weights(x: np.ndarray) -> np.ndarray:
    """Weights of the trapezoidal rule over stations x [m]."""
    steps = np.diff(x)
    return (np.append(steps, 0.0) + np.insert(steps, 0, 0.0)) / 2


def dry_transoms(body: StripBody, speed: float, choice: str):
    """Transoms of the body that run dry at this speed."""
    for transom in body.transoms:
        ventilated = speed > VENTILATION_FROUDE_NUMBER * np.sqrt(GRAVITY * transom.draught)
        if speed > 0 and (choice == "dry" or (choice == "auto" and ventilated)):
            yield transom


def strip_forces(
    body: StripBody,
    potentials: list[np.ndarray],
    nodes: np.ndarray,
    waves: Waves,
    speed: float,
    density: float,
    settings: StripSettings,
) -> StripForces:
    """Forces on one body for waves with a crest at the body's axes amidships.

    Parameters
    ----------
    potentials : of `radiation_potentials` for each group of the body, at ``nodes`` [rad/s].
    """
    transoms = tuple(dry_transoms(body, speed, settings.transom))
    distinct, back = np.unique(waves.encounter, return_inverse=True)
    at_rest, line = _radiation(body, potentials, nodes, distinct, transoms, settings)
    scale = density * distinct[:, None, None] ** 2
    radiation = with_speed(scale * at_rest, scale * line, speed / (1j * distinct))[back]
    found = StripForces(radiation, *np.zeros((2, len(waves.omega), 6), complex))
    largest = max(potential[0].size for potential in potentials)
    batch = max(1, LARGEST_BATCH // largest)
    for start in range(0, len(waves.omega), batch):
        chosen = slice(start, start + batch)
        some = Waves(*(values[chosen] for values in waves))
        froude_krylov, diffraction, end = _wave_forces(body, potentials, nodes, some, transoms, settings)
        ratio = speed / (1j * some.encounter)
        found.froude_krylov[chosen] = density * froude_krylov
        found.diffraction[chosen] = density * force_with_speed(diffraction, end, ratio)
    return found


def _radiation(body, potentials, nodes, frequency, transoms, settings) -> tuple[np.ndarray, np.ndarray]:
    """Sum over the strips and density at dry transoms of -int phi_k n_j dl (frequency, 6, 6)."""
    lever, share = lever_matrix(body.x, settings.formulation), weights(body.x)
    line = np.zeros((len(frequency), 6, 6), complex)
    at_rest = np.zeros_like(line)
    for number, (group, potential) in enumerate(zip(body.groups, potentials, strict=True)):
        own = lever[group.stations]
        at_nodes = np.einsum(
            "s,sja,nsjk,skb->nab",
            share[group.stations],
            own,
            sectional_matrix(group.panels, potential),
            own,
            optimize=True,
        )
        at_rest += at_encounter(nodes, at_nodes, frequency)
        for transom in transoms:
            if transom.group == number:
                last, part = own[transom.row], potential[:, [transom.row]][..., transom.columns]
                at_nodes = sectional_matrix(transom_panels(group.panels, transom), part)[:, 0]
                line += at_encounter(nodes, last.T @ at_nodes @ last, frequency)
    return at_rest, line


def _wave_forces(body, potentials, nodes, waves, transoms, settings) -> tuple[np.ndarray, ...]:
    """Froude-Krylov force, diffraction force at rest and its density at dry transoms over density (waves, 6)."""
    lever, share = lever_matrix(body.x, settings.formulation), weights(body.x)
    froude_krylov, diffraction, end = np.zeros((3, len(waves.omega), 6), complex)
    for number, (group, potential) in enumerate(zip(body.groups, potentials, strict=True)):
        own, panels, x = lever[group.stations], group.panels, body.x[group.stations]
        elevation = orbital_decay(panels, x, waves)
        there = at_encounter(nodes, potential, waves.encounter)
        forces = haskind_density(panels, there, elevation, waves)
        diffraction += np.einsum("s,sja,wsj->wa", share[group.stations], own, forces, optimize=True)
        for transom in transoms:
            if transom.group == number:
                at_end = elevation[:, [transom.row]][..., transom.columns]
                part = there[:, [transom.row]][..., transom.columns]
                forces = haskind_density(transom_panels(panels, transom), part, at_end, waves)
                end += forces[:, 0] @ own[transom.row]
        forces = froude_krylov_density(panels, elevation)
        froude_krylov += np.einsum("s,sja,wsj->wa", share[group.stations], own, forces, optimize=True)
        if settings.formulation == "full":
            forces = lengthwise_density(panels, elevation, waves)
            froude_krylov[:, [0, 4, 5]] += np.einsum("s,wsj->wj", share[group.stations], forces)
    return froude_krylov, diffraction, end


def at_encounter(nodes: np.ndarray, values: np.ndarray, encounter: np.ndarray) -> np.ndarray:
    """Complex values (nodes, ...) at signed encounter frequencies; the conjugate at negative ones."""
    found = between_nodes(nodes, values, np.abs(encounter))
    negative = encounter < 0
    if negative.any():
        found[negative] = np.conj(found[negative])
    return found


def transom_panels(panels: WettedPanels, transom: Transom) -> WettedPanels:
    """Panels of the last section of one hull."""
    return WettedPanels(
        *(getattr(panels, field.name)[[transom.row]][:, transom.columns] for field in fields(panels))
    )
