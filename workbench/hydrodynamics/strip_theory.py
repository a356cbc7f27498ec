"""Strip theory of Salvesen, Tuck and Faltinsen for ships of one to three hulls, upright or heeled.

Sections oscillate in their planes (`sections`), strips add up to forces (`strip_forces`), speed
enters as in `speed_terms`. Every hull has its own wetted contours in the ship's axes, so that
heel, trim and unequal immersion need nothing more: the heave, roll and pitch of a sailing
multihull ([Grande2002]_ 2.1-2.32) come out of the same sums; its own reduced form, heave of
single hulls alone, is ``formulation="heave-only"``.

Where the source's printed equations disagree with their derivation, the derivation is used:
U/omega_e^2 in 2.15, 2.19, 2.20 (printed U/omega_e), t_jk = omega_e^2 a - i omega_e b (printed
-i omega_e a in 2.18), a_54 = a_45 in 2.32, k y sin(beta) in A1.95-A1.96.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002.
"""

from collections.abc import Sequence

import numpy as np
import xarray as xr

from workbench import __version__
from workbench.conventions import encounter_frequency, wavenumber
from workbench.design import Hull
from workbench.errors import checked_number
from workbench.hydrodynamics.coefficients import coefficient_set
from workbench.hydrodynamics.section_waves import Waves
from workbench.hydrodynamics.sections import radiation_potentials
from workbench.hydrodynamics.strip_forces import frequency_nodes, strip_forces
from workbench.hydrodynamics.strip_sections import StripBody, strip_bodies
from workbench.hydrodynamics.strip_settings import StripSettings, validity_warnings

SOLVER_VERSION = f"workbench strips {__version__}"
MOST_TOGETHER = 600
"""Most frequencies at which hulls are solved together."""
LEAST_ENCOUNTER = 0.02
"""Encounter frequencies nearer 0 than this share of the wave's count as this far from it."""


def met_waves(omega: np.ndarray, wave_directions: np.ndarray, speed: float) -> Waves:
    """Every frequency with every direction, flattened (omega first)."""
    frequency, direction = (part.ravel() for part in np.meshgrid(omega, wave_directions, indexing="ij"))
    encounter = encounter_frequency(frequency, speed, direction)
    least = LEAST_ENCOUNTER * frequency
    encounter = np.where(np.abs(encounter) < least, np.where(encounter < 0, -least, least), encounter)
    return Waves(frequency, direction, encounter)


def body_potentials(body: StripBody, nodes: np.ndarray) -> list[np.ndarray]:
    """Radiation potentials of the sections of each group of a body at frequencies [rad/s]."""
    return [radiation_potentials(group.sections, wavenumber(nodes)) for group in body.groups]


def hydrodynamics(
    hull: Hull,
    density: float,
    omega: Sequence[float],
    wave_directions: Sequence[float],
    speed: float,
    settings: StripSettings | None = None,
    *,
    warnings: Sequence[str] = (),
) -> xr.Dataset:
    """Added mass, damping and wave forces of a ship at speed by strips, about the origin.

    Parameters
    ----------
    hull : all hulls, in the attitude in which they float; one that flies is left out.
    density : [kg/m3]; omega : wave frequencies [rad/s]; wave_directions : [rad]; speed : [m/s].
    settings : choices of strip theory; None takes the usual ones.
    warnings : go before the method's own in the attributes of the result.

    Returns
    -------
    Dataset of `coefficient_set`, method "strip".

    Notes
    -----
    Slender hulls, encounter frequencies that are not low, Fn up to about 0.35; deep water. No
    added mass, damping and diffraction in surge (its Froude-Krylov force is exact). Where the
    ship overtakes the waves, the encounter frequency is negative and the sections answer with
    the conjugate of their answer at its size; within 2 % of the wave's frequency from zero, the
    sections are taken at 2 %. Forty frequencies by seven headings cost some 0.3 s with each
    hull alone; hulls together some 0.02 s for each encounter frequency.
    """
    settings = StripSettings() if settings is None else settings
    checked_number("density", density, "kg/m3", above=0)
    checked_number("speed", speed, "m/s", at_least=0)
    omega = np.array([checked_number("omega", value, "rad/s", above=0) for value in omega])
    directions = np.array([checked_number("wave direction", value, "rad") for value in wave_directions])
    waves = met_waves(omega, directions, speed)
    together = settings.interacts(hull.count, speed, hull.length)
    bodies = strip_bodies(hull, settings.stations, settings.panels, together)
    nodes = section_frequencies(bodies, waves, settings, together)

    count = len(waves.omega)
    radiation = np.zeros((count, 6, 6), complex)
    froude_krylov, diffraction = np.zeros((2, count, 6), complex)
    computed = {}
    for body in bodies:
        key = id(body.groups)
        if key not in computed:
            potentials = body_potentials(body, nodes)
            computed[key] = strip_forces(body, potentials, nodes, waves, speed, density, settings)
        own = computed[key]
        shift = np.eye(6)  # motions of the body's axes from motions of the ship's
        shift[0, 5], shift[2, 3] = -body.y, body.y
        phase = np.exp(1j * wavenumber(waves.omega) * body.y * np.sin(waves.direction))[:, None]
        radiation += shift.T @ own.radiation @ shift
        froude_krylov += phase * (own.froude_krylov @ shift)
        diffraction += phase * (own.diffraction @ shift)

    shape = (len(omega), len(directions))
    encounter = waves.encounter[:, None, None]
    speed_limits = validity_warnings(settings, hull.count, speed, hull.length)
    overtaken = ("In some of these waves the ship overtakes them: strip theory is least sure there.",)
    return coefficient_set(
        omega,
        directions,
        speed,
        density,
        added_mass=(radiation.real / encounter**2).reshape(*shape, 6, 6),
        radiation_damping=(radiation.imag / encounter).reshape(*shape, 6, 6),
        froude_krylov_force=froude_krylov.reshape(*shape, 6),
        diffraction_force=diffraction.reshape(*shape, 6),
        solver=SOLVER_VERSION,
        method="strip",
        warnings=(*warnings, *speed_limits, *(overtaken if np.any(waves.encounter < 0) else ())),
    )


def section_frequencies(
    bodies: Sequence[StripBody], waves: Waves, settings: StripSettings, together: bool
) -> np.ndarray:
    """Frequencies at which the sections of all bodies are solved [rad/s].

    Hulls together resonate too sharply for a curve through few frequencies: they are
    solved at every one, up to `MOST_TOGETHER`.
    """
    breadth = max(float(np.ptp(group.panels.y, axis=1).max()) for body in bodies for group in body.groups)
    count = MOST_TOGETHER if together else settings.frequencies
    return frequency_nodes(np.abs(waves.encounter), count, breadth)
