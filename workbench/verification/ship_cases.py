"""What must hold for any ship: symmetry, energy, reciprocity, long waves; and Capytaine's own solution."""

from functools import cache

import numpy as np
import xarray as xr

from workbench import pipeline
from workbench.conventions import GRAVITY, wavenumber
from workbench.design import Design, Hull, MassProperties, WetDeck
from workbench.geometry.hydrostatics import hydrostatics
from workbench.geometry.panels import lid_panels, panels
from workbench.hydrodynamics import forward_speed, potential_flow
from workbench.hydrodynamics.forward_speed import RadiatingBody
from workbench.hydrodynamics.radiation import RadiationProblem, frequency_solution, mode_normals, radiation
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.shapes import Wigley
from workbench.verification.case import Case, relative_difference

OMEGA = np.array([0.7, 1.0, 1.3])
DENSITY = 1025.0
AROUND = np.radians(np.arange(0.0, 360.0, 5.0))
OBLIQUE = np.array([np.pi, np.radians(135.0)])
LONG_WAVE = 100.0
"""Length of the long waves over that of the ship [-]."""

HASKIND = "M. D. Haskind, 1957; J. N. Newman, J. Ship Research 6(3), 10-17, 1962"
LINEAR = "linear theory: a small ship follows the surface of long waves"


@cache
def twin() -> Design:
    """Two Wigley hulls of 40 m, 10 m apart, floating level, with a plain wet deck."""
    hull = Hull(shape=Wigley(length=40.0, beam=4.0, draught=2.0, depth=4.0), count=2, spacing=10.0)
    return Design(
        name="wigley-twin",
        hull=hull,
        wet_deck=WetDeck(aft=-15.0, fore=15.0, width=6.0, clearance=1.5),
        masses=MassProperties(
            mass=float(hydrostatics(hull, DENSITY).displacement),
            centre_of_gravity=(0.0, 0.0, 1.0),
            roll_gyradius=4.5,
            pitch_gyradius=10.0,
            yaw_gyradius=10.5,
        ),
        density=DENSITY,
    )


@cache
def _problem() -> RadiationProblem:
    hull = twin().hull
    return RadiationProblem(panels=panels(hull, 500), lid=lid_panels(hull))


@cache
def _at_rest(around: bool = False) -> xr.Dataset:
    """Hydrodynamics of the twin at rest."""
    directions = AROUND if around else OBLIQUE
    return forward_speed.hydrodynamics([RadiatingBody(_solved())], OMEGA, directions, 0.0, DENSITY)


@cache
def _solved() -> xr.Dataset:
    return radiation(_problem(), OMEGA)


def _scaled_forces() -> np.ndarray:
    """Radiation force omega**2 A + i omega B over the geometric means of its diagonal (omega, 6, 6)."""
    found = _at_rest()
    omega = OMEGA[:, None, None]
    force = omega**2 * found.added_mass.values[:, 0] + 1j * omega * found.radiation_damping.values[:, 0]
    scale = np.sqrt(np.abs(np.einsum("fii->fi", force)))
    return force / (scale[:, :, None] * scale[:, None, :])


def _asymmetry() -> float:
    force = _scaled_forces()
    return float(np.abs(force - np.swapaxes(force, 1, 2)).max())


def _least_damping() -> float:
    """Least eigenvalue of the scaled symmetric part of the damping."""
    damping = _scaled_forces().imag
    return float(np.linalg.eigvalsh((damping + np.swapaxes(damping, 1, 2)) / 2).min())


def _far_field_damping(mode: int) -> float:
    """Damping from the energy of the radiated waves over damping from the pressure: the one farthest from 1.

    B_jj = k omega/(4 pi rho g**2) times the integral of |F_j|**2 over all headings:
    by Haskind, F_j(beta) is the wave that mode j sends to beta + pi, and its power
    is that of the damping. In deep water, where the group goes with g/(2 omega).
    """
    found = _at_rest(around=True)
    force = np.abs(found.excitation_force.values[..., mode]) ** 2
    integral = force.sum(axis=1) * (AROUND[1] - AROUND[0])
    radiated = wavenumber(OMEGA) * OMEGA / (4 * np.pi * DENSITY * GRAVITY**2) * integral
    ratio = radiated / found.radiation_damping.values[:, 0, mode, mode]
    return float(ratio[np.argmax(np.abs(ratio - 1))])


def _haskind_difference(mode: int) -> float:
    """Largest difference of the diffraction force by Haskind from that by the diffraction potential [-]."""
    problem = _problem()
    modes = mode_normals(problem.panels.centres, problem.panels.normals)[mode]
    parity = 1.0 if mode in (0, 2, 4) else -1.0
    weights = np.concatenate([modes, parity * modes]) * np.tile(problem.panels.areas, 2)
    direct = []
    for omega in OMEGA:
        potential = frequency_solution(problem, omega, [(omega, beta) for beta in OBLIQUE])["diffraction"]
        direct.append(-1j * DENSITY * omega * potential @ weights)
    return relative_difference(_at_rest().diffraction_force.values[..., mode], np.array(direct))


@cache
def _by_capytaine() -> dict[str, np.ndarray]:
    problem = _problem()
    return potential_flow.forward_speed_coefficients(
        problem.panels, problem.lid, OMEGA[1:2], OBLIQUE, 0.0, DENSITY
    )


def _capytaine_difference(name: str) -> float:
    """Largest difference from Capytaine's own problem-by-problem solution, over heave, pitch and roll [-]."""
    ours, theirs = _at_rest()[name].values[1:2], _by_capytaine()[name]
    if ours.ndim == 4:
        return max(relative_difference(ours[..., j, j], theirs[..., j, j]) for j in (2, 3, 4))
    return max(relative_difference(ours[..., j], theirs[..., j]) for j in (2, 3, 4))


@cache
def _in_long_waves() -> tuple[pipeline.Response, xr.Dataset]:
    settings = PotentialFlowSettings(panels=400, wave_field="incident")
    omega = np.sqrt(2 * np.pi * GRAVITY / (LONG_WAVE * 40.0))
    ship = pipeline.response(twin(), 0.0, OBLIQUE, [omega], settings)
    return ship, pipeline.deck_response(ship, twin().wet_deck, (8, 4))


def _long_wave_heave() -> float:
    return float(np.abs(_in_long_waves()[0].motions.motion_rao.values[0, 0, 2]))


def _long_wave_pitch() -> float:
    """Pitch over wave slope; bow down where the surface falls forward, so of the sign -i k cos(beta)."""
    motions = _in_long_waves()[0].motions
    slope = -1j * float(motions.wavenumber[0]) * np.cos(np.pi)
    return float((motions.motion_rao.values[0, 0, 4] / slope).real)


def _long_wave_relative_motion() -> float:
    return float(np.abs(_in_long_waves()[1].relative_motion).max())


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_potential_cases(), *_long_wave_cases()]


def _potential_cases() -> list[Case]:
    note = "two Wigley hulls of 40 m at 0.7, 1.0 and 1.3 rad/s, 500 panels"
    made = [
        Case(
            id="radiation-symmetric",
            title="added mass and damping at rest: largest difference of jk and kj, scaled",
            kind="closed form",
            source=HASKIND,
            published=0.0,
            computed=_asymmetry,
            tolerance=0.015,
            note=note,
        ),
        Case(
            id="damping-not-negative",
            title="damping at rest: least eigenvalue, scaled, where it is below zero",
            kind="closed form",
            source="a ship that radiates waves loses energy",
            published=0.0,
            computed=lambda: min(_least_damping(), 0.0),
            tolerance=0.005,
            note=note,
        ),
    ]
    for mode, name in ((2, "heave"), (3, "roll"), (4, "pitch")):
        made += [
            Case(
                id=f"energy-{name}",
                title=f"{name} damping by the energy of the radiated waves over that by pressure",
                kind="second method",
                source=HASKIND,
                published=1.0,
                computed=lambda mode=mode: _far_field_damping(mode),
                tolerance=0.05,
                note=note,
            ),
            Case(
                id=f"haskind-{name}",
                title=f"{name} diffraction force by Haskind's relation against the diffraction potential",
                kind="second method",
                source=HASKIND,
                published=0.0,
                computed=lambda mode=mode: _haskind_difference(mode),
                tolerance=0.015,
                note=note,
            ),
        ]
    names = {
        "added_mass": 1e-3,
        "radiation_damping": 1e-3,
        "froude_krylov_force": 1e-3,
        "diffraction_force": 0.015,
    }
    for name, tolerance in names.items():
        made.append(
            Case(
                id=f"capytaine-{name.replace('_', '-')}",
                title=f"{name.replace('_', ' ')} at 1 rad/s against Capytaine's own solution",
                kind="second code",
                source="M. Ancellin and F. Dias, J. Open Source Software 4(36), 1341, 2019",
                published=0.0,
                computed=lambda name=name: _capytaine_difference(name),
                tolerance=tolerance,
                note="heave, roll, pitch; same panels and Green function, other assembly, Haskind's force",
            )
        )
    return made


def _long_wave_cases() -> list[Case]:
    note = f"two Wigley hulls of 40 m in waves of {LONG_WAVE:g} ship lengths"
    titles = {
        "long-wave-heave": ("heave over wave amplitude, head waves", 1.0, _long_wave_heave, 0.01),
        "long-wave-pitch": ("pitch over wave slope with its sign, head waves", 1.0, _long_wave_pitch, 0.01),
        "long-wave-relative-motion": (
            "largest relative motion of the deck over wave amplitude, head and bow waves",
            0.0,
            _long_wave_relative_motion,
            0.01,
        ),
    }
    return [
        Case(
            id=name,
            title=title,
            kind="closed form",
            source=LINEAR,
            published=known,
            computed=computed,
            tolerance=tolerance,
            note=note,
        )
        for name, (title, known, computed, tolerance) in titles.items()
    ]
