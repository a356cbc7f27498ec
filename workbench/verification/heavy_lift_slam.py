"""The slam of [Baggus2025]_ chapter 6 on the library's heavy-lift model: from two waves to pressure, force and impulse.

Hull lines and gyradii are not published, so hull and motions are a stand-in's. Two kinematics:

- "ours": incident, diffracted and radiated waves, and pitch with the sign that goes with them;
- "source": incident and diffracted waves alone, and the pitch term of eqs. 5.5 and 6.1 as printed, +x,
  with responses that count pitch bow down (see `workbench.verification.baggus_relative_motion`).

With the first the stand-in's deck is hardly touched, and amidships. With the second it slams aft, about where and
when the source says. The second was found by trying: incident, diffracted or all waves, and either sign of pitch, on
our responses (and, as a check, on the source's at 9.5 rad/s). Consistent signs wet the aft deck with none of the
three wave fields; the printed sign does with the diffracted waves and, nearer amidships, with all. It
suggests that the source's slam comes of that sign and of the radiated waves it leaves out; on a stand-in it proves
nothing.

.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025.
"""

import dataclasses
from functools import cache

import numpy as np
import xarray as xr

from workbench import pipeline
from workbench.design import WetDeck
from workbench.errors import checked_choice
from workbench.geometry.wet_deck import wet_deck_grid
from workbench.hulls.library import design
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.motions import translation_matrix
from workbench.relative_motion import scattered_elevation
from workbench.repeating_waves import Repetition, repetition
from workbench.slamming.immersion import immersion_map, immersions
from workbench.time_domain import components_from, motion_amplitudes, relative_amplitudes
from workbench.wet_deck_pressure.fitted_pressure import slam_pressure
from workbench.wet_deck_pressure.slam_event import slam_event

KINEMATICS = ("ours", "source")

OMEGA, AMPLITUDE = (9.5, 4.2), 0.0175
"""Of the two waves [rad/s, m] (6.1)."""

AFT, FORE, WIDTH = 0.167, 0.872, 0.166
"""Of the flat part of the deck, x from the aft end (table 5.1), and its width between the radii [m]."""

CELLS = (120, 8)
PANELS = 1000

VARIANTS = tuple((fit, velocity) for fit in ("linear", "quadratic") for velocity in ("mean", "cubic"))
"""Four pressures of the source (6.3)."""


def flat_deck() -> WetDeck:
    """Flat part of the model's wet deck; the radii at its edges are left out, as in the source (5.2)."""
    model = design("heavy-lift-198-model")
    half = model.hull.length / 2
    return dataclasses.replace(
        model.wet_deck,
        aft=AFT - half,
        fore=FORE - half,
        width=WIDTH,
        entry_length=0.0,
        entry_rise=0.0,
        corner_radius=0.0,
    )


@cache
def ship() -> pipeline.Response:
    """Response of the model in the two waves, head on, at rest."""
    return pipeline.response(
        design("heavy-lift-198-model"), 0.0, [np.pi], sorted(OMEGA), PotentialFlowSettings(panels=PANELS)
    )


@cache
def deck() -> xr.Dataset:
    """Grid over the flat deck."""
    return wet_deck_grid(flat_deck(), *CELLS)


def waves() -> xr.Dataset:
    """Both waves, with the time of the source: elevation a sin(k.x - omega t) at the centre of gravity."""
    centre = ship().motions.attrs["centre_of_gravity"][0]
    incident = components_from(OMEGA, AMPLITUDE, -np.pi / 2, np.pi, 0.0)
    return components_from(OMEGA, AMPLITUDE, -np.pi / 2 - incident.component_kx.values * centre, np.pi, 0.0)


def window() -> Repetition:
    """Period after which the two waves nearly repeat (6.1)."""
    return repetition(OMEGA)


def amplitudes(kinematics: str) -> tuple[np.ndarray, np.ndarray]:
    """Relative motion [m] and relative slope [-] on the deck, (component, x, y), by one of `KINEMATICS`."""
    checked_choice("kinematics", kinematics, KINEMATICS)
    components, found = waves(), ship()
    relative = pipeline.deck_response(found, flat_deck(), CELLS)
    rise, slope = relative_amplitudes(components, found.motions, relative)
    if kinematics == "ours":
        return rise, slope
    x, y = np.meshgrid(deck().x.values, deck().y.values, indexing="ij")
    centre = found.motions.attrs["centre_of_gravity"][0]
    moved = motion_amplitudes(components, found.motions)[:, :, None, None]
    total = rise + moved[:, 2] - (x - centre) * moved[:, 4]
    radiated = scattered_elevation(found.wave_field, _at_origin(found), x, y) - scattered_elevation(
        found.wave_field, 0 * _at_origin(found), x, y
    )
    order = np.searchsorted(found.motions.omega.values, components.component_omega.values)
    turned = components.component_amplitude.values * np.exp(1j * components.component_phase.values)
    total = total - turned[:, None, None] * radiated[order, 0]
    return total - moved[:, 2] - (x - centre) * moved[:, 4], slope


def _at_origin(found: pipeline.Response) -> np.ndarray:
    centre = np.asarray(found.motions.attrs["centre_of_gravity"])
    return found.motions.motion_rao.values @ translation_matrix(-centre).T


@cache
def wet(kinematics: str) -> xr.Dataset:
    """Immersions in the window."""
    rise, slope = amplitudes(kinematics)
    return immersions(
        rise, slope, waves().component_frequency.values, deck(), duration=window().period, periodic=True
    )


def immersed(kinematics: str) -> xr.Dataset:
    """Map of the immersions."""
    return immersion_map(wet(kinematics), deck())


@cache
def slam(kinematics: str) -> xr.Dataset:
    """The deepest slam by itself."""
    return slam_event(wet(kinematics), deck())


def pressures(kinematics: str, steps: int = 500) -> dict[tuple[str, str], xr.Dataset]:
    """The four pressures of the source by (fit of the wetted length, impact velocity)."""
    density = design("heavy-lift-198-model").density
    return {
        (fit, velocity): slam_pressure(slam(kinematics), density, fit=fit, velocity=velocity, steps=steps)
        for fit, velocity in VARIANTS
    }


def contact_from_centre(kinematics: str) -> float:
    """Place of first contact from the centre of gravity as the source counts it (table 5.1) [m]."""
    from_aft = slam(kinematics).attrs["contact_x"] + design("heavy-lift-198-model").hull.length / 2
    return from_aft - 0.544


def shortest_interval(kinematics: str) -> float:
    """Shortest time between two entries at the place of first contact within the window [s]."""
    found = wet(kinematics)
    x, y = slam(kinematics).attrs["contact_x"], float(np.abs(deck().y.values).min())
    mine = (np.abs(found.event_x.values - x) < 1e-9) & (np.abs(np.abs(found.event_y.values) - y) < 1e-9)
    times = np.unique(np.round(found.event_time.values[mine], 6))
    return float(np.diff(times).min()) if len(times) > 1 else np.nan
