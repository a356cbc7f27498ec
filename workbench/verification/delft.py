"""The Delft 372 catamaran: the measured series of van 't Veer 1998 and the same quantities computed.

Each comparison is a Dataset-like dict of arrays over the measured points, so that
the cases take their figures and the notebook its curves from the same numbers.
"""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from workbench import pipeline
from workbench.conventions import GRAVITY
from workbench.design import Design
from workbench.geometry.hydrostatics import longitudinal_stiffness_about, stiffness_matrix
from workbench.hulls.library import design
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.own_wave import own_wave
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.motions import lead_over_wave, translation_matrix
from workbench.verification import published

LENGTH = 3.0
TREATMENTS = {
    "apart": PotentialFlowSettings(interaction="off"),
    "together": PotentialFlowSettings(interaction="on"),
    "forward-speed": PotentialFlowSettings(interaction="on", speed_treatment="forward-speed"),
    "strip": StripSettings(),
    "high-speed": HighSpeedSettings(),
    "recommended": RecommendedSettings(),
}
"""How the motions are computed: panel method with each hull alone, both as one, and both by Capytaine's own
forward-speed option; strip theory; high-speed theory; and what is recommended at the speed."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """One measured series and the computed one.

    Parameters
    ----------
    abscissa : wavelength over length, or frequency.
    measured, computed : amplitudes over ``abscissa``.
    measured_lead, computed_lead : phases of lead over the wave [rad]; empty where there are none.
    """

    abscissa: np.ndarray
    measured: np.ndarray
    computed: np.ndarray
    measured_lead: np.ndarray
    computed_lead: np.ndarray

    @property
    def mean_difference(self) -> float:
        """Mean absolute difference over the largest measured value [-]."""
        return float(np.abs(self.computed - self.measured).mean() / np.abs(self.measured).max())

    @property
    def peak_ratio(self) -> float:
        """Largest computed over largest measured value [-]."""
        return float(self.computed.max() / self.measured.max())

    @property
    def lead_difference(self) -> float:
        """Mean difference of phase where the measured amplitude is above a quarter of its peak [rad]."""
        away = np.angle(np.exp(1j * (self.computed_lead - self.measured_lead)))
        return float(away[self.measured > 0.25 * self.measured.max()].mean())

    @property
    def largest_lead_difference(self) -> float:
        """Largest difference of phase where the measured amplitude is above a quarter of its peak [rad]."""
        away = np.angle(np.exp(1j * (self.computed_lead - self.measured_lead)))
        return float(np.abs(away[self.measured > 0.25 * self.measured.max()]).max())


@cache
def model() -> Design:
    """The model as towed: KG 0.34 m, pitch gyradius 0.782 m."""
    return design("delft-372")


@cache
def free_model() -> Design:
    """The model as it sailed in the basin: KG 0.278 m, pitch gyradius 0.810 m."""
    masses = model().masses
    return replace(
        model(),
        masses=replace(
            masses, pitch_gyradius=0.810, centre_of_gravity=(*masses.centre_of_gravity[:2], 0.128)
        ),
    )


def wave_frequency(wavelength_over_length) -> np.ndarray:
    """Frequency of deep-water waves of the model [rad/s]."""
    return np.sqrt(2 * np.pi * GRAVITY / (np.asarray(wavelength_over_length) * LENGTH))


@cache
def _response(
    ship: Design, froude_number: float, treatment: str, omega: tuple[float, ...], heading_degrees: float
) -> pipeline.Response:
    speed = froude_number * np.sqrt(GRAVITY * LENGTH)
    return pipeline.response(ship, speed, [np.radians(heading_degrees)], omega, TREATMENTS[treatment])


def motion(
    froude_number: float,
    mode: str,
    treatment: str,
    wavelength_over_length=None,
    heading_degrees: float = 180.0,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Wavelengths over length, amplitude and lead of heave [m/m] or pitch [rad/rad of slope], towed model.

    ``wavelength_over_length`` None takes the measured ones; any order is kept.
    """
    if wavelength_over_length is None:
        table = published.columns("veer_1998_head_sea_motions", froude_number=froude_number)
        wavelength_over_length = table["wavelength_over_length"]
    return _motion(model(), froude_number, mode, treatment, wavelength_over_length, heading_degrees)


def _motion(ship, froude_number, mode, treatment, wavelengths, heading_degrees):
    ratios = np.asarray(wavelengths, float)
    distinct, back = np.unique(wave_frequency(ratios), return_inverse=True)
    response = _response(ship, froude_number, treatment, tuple(distinct.tolist()), heading_degrees)
    motions = response.motions
    index = {"heave": 2, "pitch": 4}[mode]
    amplitude = np.abs(motions.motion_rao.values[:, 0, index])
    if mode == "pitch":
        amplitude = amplitude / motions.wavenumber.values
    return ratios, amplitude[back], lead_over_wave(motions).values[:, 0, index][back]


@cache
def towed(froude_number: float, mode: str, treatment: str) -> Comparison:
    """Heave or pitch in head waves against the towing tank."""
    table = published.columns("veer_1998_head_sea_motions", froude_number=froude_number)
    ratios, computed, lead = motion(froude_number, mode, treatment)
    return Comparison(ratios, table[mode], computed, np.radians(table[f"{mode}_lead_deg"]), lead)


@cache
def free(froude_number: float, mode: str, treatment: str, heading_degrees: float) -> Comparison:
    """Heave or pitch (over wave slope) of the free-sailing model."""
    table = published.columns(
        "veer_1998_basin_motions", froude_number=froude_number, heading_deg=heading_degrees
    )
    ratios = table["wavelength_over_length"]
    _, computed, lead = _motion(free_model(), froude_number, mode, treatment, ratios, heading_degrees)
    measured = table["heave"]
    if mode == "pitch":
        wavenumber = 2 * np.pi / (ratios * LENGTH)
        measured = np.radians(table["pitch_deg_per_cm"]) * 100 / wavenumber
    return Comparison(ratios, measured, computed, np.radians(table[f"{_column(mode)}_lead_deg"]), lead)


def _column(mode: str) -> str:
    return "pitch_deg_per_cm" if mode == "pitch" else mode


@cache
def between_tanks(mode: str) -> float:
    """Mean absolute difference of basin and towing tank, Fn 0.30, head waves, over the tank's peak [-]."""
    tank = published.columns("veer_1998_head_sea_motions", froude_number=0.3)
    basin = free(0.3, mode, "apart", 180.0)
    inside = basin.abscissa <= tank["wavelength_over_length"].max()
    inside &= basin.abscissa >= tank["wavelength_over_length"].min()
    there = np.interp(basin.abscissa[inside], tank["wavelength_over_length"], tank[mode])
    return float(np.abs(basin.measured[inside] - there).mean() / tank[mode].max())


@cache
def wave_load(froude_number: float, mode: str, treatment: str) -> Comparison:
    """Heave force [N/m] or pitch moment about the centre of gravity [N] per wave amplitude, model held."""
    table = published.columns("veer_1998_wave_loads", froude_number=froude_number)
    ratios = table["wavelength_over_length"]
    omega = np.sort(wave_frequency(ratios))
    response = _response(model(), froude_number, treatment, tuple(omega.tolist()), 180.0)
    to_origin = np.linalg.inv(translation_matrix(model().masses.centre_of_gravity))
    force = response.hydrodynamics.excitation_force.values[:, 0] @ to_origin
    force = force[::-1] / response.motions.wave_at_reference.values[::-1, :1]
    index, column = {"heave": (2, "force"), "pitch": (4, "moment")}[mode]
    measured = table[column] / (table["wave_amplitude_mm"] / 1000)
    lead = -np.angle(force[:, index])
    return Comparison(
        ratios, measured, np.abs(force[:, index]), np.radians(table[f"{column}_lead_deg"]), lead
    )


@cache
def oscillation(froude_number: float, mode: str, quantity: str, treatment: str) -> Comparison:
    """Added mass or damping of forced heave or pitch about the centre of gravity, in SI units.

    ``quantity`` is "added_mass" or "radiation_damping", of the moved mode itself.
    """
    table = published.columns("veer_1998_forced_oscillation", froude_number=froude_number, mode=mode)
    omega = table["frequency"] * np.sqrt(GRAVITY / LENGTH)
    # in beam waves the encounter frequency is the wave's: the coefficients at these very frequencies
    response = _response(model(), froude_number, treatment, tuple(omega.tolist()), 90.0)
    to_origin = np.linalg.inv(translation_matrix(model().masses.centre_of_gravity))
    matrix = response.hydrodynamics[quantity].values[:, 0]
    if quantity == "added_mass" and "stiffness_correction" in response.hydrodynamics:
        # the experiment subtracts the whole hydrostatic stiffness, and books what is missing of it as added mass
        missing = response.hydrodynamics.stiffness_correction.values[0]
        matrix = matrix - missing / omega[:, None, None] ** 2
    matrix = to_origin.T @ matrix @ to_origin
    index = {"heave": 2, "pitch": 4}[mode]
    column = {"added_mass": "added_mass_own", "radiation_damping": "damping_own"}[quantity]
    none = np.zeros(0)
    return Comparison(table["frequency"], table[column], matrix[:, index, index], none, none)


def heave_from_measured(froude_number: float) -> float:
    """Heave peak that follows from the measured coefficients and wave loads, over the measured peak [-].

    Coefficients and loads are interpolated linearly; waves as in the towing-tank motions.
    """
    motion_table = published.columns("veer_1998_head_sea_motions", froude_number=froude_number)
    ratios = motion_table["wavelength_over_length"]
    omega = wave_frequency(ratios)
    speed = froude_number * np.sqrt(GRAVITY * LENGTH)
    encounter = omega + omega**2 / GRAVITY * speed
    masses, hull = model().masses, model().hull
    stiffness = longitudinal_stiffness_about(
        stiffness_matrix(hull, masses, model().density), masses.centre_of_gravity[0]
    )
    system = np.tile(stiffness.astype(complex), (len(omega), 1, 1))
    inertia = masses.mass * np.diag([1.0, masses.pitch_gyradius**2])
    system -= encounter[:, None, None] ** 2 * inertia
    for column, mode in enumerate(("heave", "pitch")):
        table = published.columns("veer_1998_forced_oscillation", froude_number=froude_number, mode=mode)
        frequency = table["frequency"] * np.sqrt(GRAVITY / LENGTH)
        for row, which in ((column, "own"), (1 - column, "cross")):
            added = np.interp(encounter, frequency, table[f"added_mass_{which}"])
            damping = np.interp(encounter, frequency, table[f"damping_{which}"])
            system[:, row, column] += -(encounter**2) * added + 1j * encounter * damping
    loads = published.columns("veer_1998_wave_loads", froude_number=froude_number)
    amplitude = loads["wave_amplitude_mm"] / 1000
    force = np.empty((len(omega), 2), complex)
    for row, name in enumerate(("force", "moment")):
        phasor = loads[name] / amplitude * np.exp(1j * np.radians(loads[f"{name}_lead_deg"]))
        rises = np.argsort(loads["wavelength_over_length"])
        place = loads["wavelength_over_length"][rises]
        real = np.interp(ratios, place, phasor[rises].real)
        force[:, row] = real + 1j * np.interp(ratios, place, phasor[rises].imag)
    heave = np.linalg.solve(system, force[..., None])[:, 0, 0]
    return float(np.abs(heave).max() / motion_table["heave"].max())


@cache
def running_attitude(froude_number: float) -> tuple[float, float]:
    """Computed running sinkage of the centre of gravity [mm, down] and trim [degrees, bow down] of the towed model."""
    ship = model()
    speed = froude_number * np.sqrt(GRAVITY * LENGTH)
    found = own_wave(ship.hull, ship.masses, ship.density, speed, [0.0], [0.0])
    return 1000 * float(found.running_sinkage), float(np.degrees(found.running_trim))
