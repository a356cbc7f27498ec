"""Strip theory: the Delft 372 catamaran in head waves [Veer1998]_, and identities of the speed terms [STF1970]_.

.. [Veer1998] R. van 't Veer, "Experimental results of motions, hydrodynamic coefficients and
    wave loads on the 372 catamaran model", Delft University of Technology report 1129, 1998.
.. [STF1970] N. Salvesen, E. O. Tuck and O. Faltinsen, "Ship motions and sea loads",
    Trans. SNAME 78, 250-287, 1970.
"""

from functools import cache

import numpy as np

from workbench.conventions import GRAVITY, encounter_frequency
from workbench.geometry.hydrostatics import stiffness_matrix
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.hydrodynamics.strip_theory import hydrodynamics
from workbench.motions import lead_over_wave, motions
from workbench.verification import published
from workbench.verification.case import Case
from workbench.verification.delft import LENGTH, Comparison, model, wave_frequency

HEAVE, PITCH = 2, 4


@cache
def towed(froude_number: float, mode: str, interaction: str) -> Comparison:
    """Heave [m/m] or pitch over wave slope in head waves by strips, against the towing tank."""
    table = published.columns("veer_1998_head_sea_motions", froude_number=froude_number)
    ratios = table["wavelength_over_length"]
    omega, back = np.unique(wave_frequency(ratios), return_inverse=True)
    ship = model()
    speed = froude_number * np.sqrt(GRAVITY * LENGTH)
    settings = StripSettings(interaction=interaction)
    found = motions(
        hydrodynamics(ship.hull, ship.density, omega, [np.pi], speed, settings),
        ship.masses,
        stiffness_matrix(ship.hull, ship.masses, ship.density),
    )
    index = {"heave": HEAVE, "pitch": PITCH}[mode]
    amplitude = np.abs(found.motion_rao.values[:, 0, index])
    if mode == "pitch":
        amplitude = amplitude / found.wavenumber.values
    lead = lead_over_wave(found).values[:, 0, index]
    measured_lead = np.radians(table[f"{mode}_lead_deg"])
    return Comparison(ratios, table[mode], amplitude[back], measured_lead, lead[back])


@cache
def _identity() -> tuple[float, float]:
    """A35 - A53 over -2 U B33/omega_e^2, and B35 + B53 over 2 B35 of the ship at rest."""
    hull, speed, omega = model().hull, 2.0, 5.0
    met = float(encounter_frequency(omega, speed, np.pi))
    settings = StripSettings(transom="wet", interaction="off")
    rest = hydrodynamics(hull, 1000.0, [met], [np.pi / 2], 0.0, settings)
    moving = hydrodynamics(hull, 1000.0, [omega], [np.pi], speed, settings)
    a, b = (moving[name].values[0, 0] for name in ("added_mass", "radiation_damping"))
    b_rest = rest.radiation_damping.values[0, 0]
    mass = (a[HEAVE, PITCH] - a[PITCH, HEAVE]) / (-2 * speed / met**2 * b_rest[HEAVE, HEAVE])
    damping = (b[HEAVE, PITCH] + b[PITCH, HEAVE]) / (2 * b_rest[HEAVE, PITCH])
    return float(mass), float(damping)


TOLERANCE = 0.10
MISSES = {
    ("heave", "off"): (
        0.130,
        "each hull alone: waves that the other hull would send back are missing; the heave peak is 28 % low",
    ),
    ("pitch", "off"): (0.102, "each hull alone: the pitch peak is 16 % low, just outside a tenth"),
    ("heave", "on"): (
        0.112,
        "sections solved together keep waves between the hulls that leave lengthwise at speed; the peak is 25 % high",
    ),
    ("pitch", "on"): (
        0.188,
        "sections solved together keep waves between the hulls that leave lengthwise at speed",
    ),
}


def cases() -> list[Case]:
    """Return the cases of this module."""
    made = []
    for (mode, interaction), (figure, reason) in MISSES.items():
        words = {"off": "each hull alone", "on": "hulls together"}[interaction]
        made.append(
            Case(
                id=f"strip-delft-{mode}-{interaction}",
                title=f"{mode} of the Delft 372 at Fn 0.30, head waves, strips, {words}: mean difference over peak",
                kind="published",
                source=published.citation("veer_1998_head_sea_motions"),
                published=0.0,
                computed=lambda mode=mode, interaction=interaction: (
                    towed(0.3, mode, interaction).mean_difference
                ),
                tolerance=TOLERANCE,
                miss=f"{reason}.",
                miss_figure=figure,
                miss_band=0.01,
            )
        )
    source = 'N. Salvesen, E. O. Tuck and O. Faltinsen, "Ship motions and sea loads", Trans. SNAME 78, 250-287, 1970'
    for which, title in enumerate(("A35 - A53 over -2 U B33 / omega_e^2", "B35 + B53 over 2 B35 at rest")):
        made.append(
            Case(
                id=f"strip-identity-{('a35', 'b35')[which]}",
                title=f"{title}, Delft 372, no transom terms",
                kind="closed form",
                source=source,
                published=1.0,
                computed=lambda which=which: _identity()[which],
                tolerance=1e-6,
            )
        )
    return made
