"""Seas and slamming statistics: spectra, encounter, Ochi's formulas and their inverses."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.conventions import KNOT, encounter_frequency, froude_number
from workbench.impact.pressure import PressureLaw
from workbench.seas import SeaState, period_ratio, wave_spectrum
from workbench.slamming import criteria, extremes, statistics
from workbench.verification import published
from workbench.verification.case import Case
from workbench.verification.counting_cases import flat_point

FOOT = 0.3048
SEA = SeaState(significant_wave_height=3.0, peak_period=8.0)
JONSWAP_SEA = SeaState(significant_wave_height=3.0, peak_period=8.0, spectrum="jonswap", peak_enhancement=7.0)
OCHI = published.citation("ochi_1964_threshold")


def _moments(order: int, sea: SeaState) -> float:
    omega = np.linspace(0.02, 200.0, 400_000) / sea.peak_period
    return float(np.trapezoid(omega**order * wave_spectrum(sea, omega), omega))


def _made_moments(motion_std: float, velocity_std: float) -> xr.Dataset:
    """Moments of a point with given standard deviations and a level, still water surface."""
    values = {
        "relative_motion_std": motion_std,
        "relative_velocity_std": velocity_std,
        "relative_slope_std": 0.0,
        "velocity_slope_covariance": 0.0,
        "motion_slope_covariance": 0.0,
        "upcrossing_rate": velocity_std / motion_std / (2 * np.pi),
    }
    return quantities.dataset(
        {"x": [0.0], "y": [0.0]},
        method="given moments",
        **{name: (("x", "y"), [[number]]) for name, number in values.items()},
    )


def _example() -> xr.Dataset:
    return statistics.slamming_statistics(_made_moments(1.0, 1.2), flat_point(2.0).height, 1.0)


def _largest_pressure(hours: float) -> float:
    moments, deck = _made_moments(1.0, 1.2), flat_point(2.0)
    found = statistics.slamming_statistics(moments, deck.height, 1.0)
    law = PressureLaw(name="panel", coefficient=100.0)
    return float(extremes.largest_peak_pressure(moments, found, deck, law, 1025.0, hours).item()) / 1000


def _rate_at_required_height() -> float:
    moments = _made_moments(1.0, 1.2)
    height = criteria.required_height(moments, 20.0, 1.0)
    return float(statistics.slamming_statistics(moments, height, 1.0).slams_per_hour.item())


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_spectrum_cases(), *_number_cases(), *_ochi_cases()]


def _spectrum_cases() -> list[Case]:
    source = published.citation("spectrum_period_ratios")
    made = []
    orders = (("energy_period", -1), ("mean_period", 1), ("zero_crossing_period", 2))
    for row in published.rows("spectrum_period_ratios"):
        gamma = float(row["peak_enhancement"])
        for column, order in orders:
            made.append(
                Case(
                    id=f"{row['spectrum']}-{gamma:g}-{column}".replace("_", "-").replace(".", "-"),
                    title=f"{column.replace('_', ' ')} over peak period, {row['spectrum']} gamma {gamma:g}",
                    kind="closed form",
                    source=source,
                    published=float(row[column]),
                    computed=lambda order=order, row=row, gamma=gamma: period_ratio(
                        order, row["spectrum"], gamma
                    ),
                    tolerance=1e-6,
                )
            )
    seas = (("bretschneider", SEA), ("jonswap-7", JONSWAP_SEA))
    for name, sea in seas:
        made.append(
            Case(
                id=f"significant-height-{name}",
                title=f"4 sqrt(m0) of a sea of 3 m, {name}",
                kind="closed form",
                source="definition of significant height",
                published=3.0,
                computed=lambda sea=sea: 4 * np.sqrt(_moments(0, sea)),
                tolerance=1e-3,
                unit="m",
            )
        )
    return made


def _number_cases() -> list[Case]:
    """Return encounter frequencies, Froude numbers and thresholds of Grande and Ochi."""
    source = published.citation("grande_2002_numbers")
    computed = {
        "Bretschneider Tp over T01": lambda: SeaState.from_mean_period(3.0, 8.0).peak_period / 8.0,
    }
    for length, name, speeds in (
        (120.0, "COFEA", (15, 25)),
        (86.6, "Austal", (20, 30, 40)),
        (15.2, "Crowther", (10, 20)),
    ):
        for knots in speeds:
            computed[f"{name} Froude number at {knots} kn"] = lambda knots=knots, length=length: float(
                froude_number(knots * KNOT, length)
            )
    for length in ("86.6", "15.2", "35", "8", "120"):
        computed[f"threshold velocity length {length} m"] = lambda length=length: float(
            statistics.threshold_velocity(float(length))
        )
    for knots, period in ((20, 8), (30, 8), (40, 8), (20, 12)):
        computed[f"encounter frequency {knots} kn {period} s head"] = lambda knots=knots, period=period: (
            float(encounter_frequency(2 * np.pi / period, knots * KNOT, np.pi))
        )
    made = []
    for label, compute in computed.items():
        number, tolerance, unit = published.value("grande_2002_numbers", label)
        made.append(
            Case(
                id=f"grande-{label}".lower().replace(" ", "-").replace(".", "-"),
                title=label,
                kind="published",
                source=source,
                published=number,
                computed=compute,
                tolerance=tolerance,
                unit=unit,
            )
        )
    for row in published.rows("baggus_2025_encounter"):
        made.append(
            Case(
                id=f"baggus-encounter-{float(row['omega']):g}",
                title=f"encounter frequency of {row['omega']} rad/s in a current of 0.1 m/s",
                kind="published",
                source=published.citation("baggus_2025_encounter"),
                published=float(row["encounter_omega"]),
                computed=lambda row=row: float(
                    encounter_frequency(float(row["omega"]), float(row["speed"]), np.pi)
                ),
                tolerance=0.001,
                unit="rad/s",
            )
        )
    return made


def _ochi_cases() -> list[Case]:
    row = published.rows("ochi_1964_threshold")[0]
    decay = np.exp(-2.0 - 1.0 / 2.88)
    per_hour = 3600 * 1.2 / (2 * np.pi) * decay
    largest = 1025 * 100.0 * 1.44 * (np.log(3 * 3600 * 1.2 / (2 * np.pi)) - 2.0) / 1000
    example = "sigma of relative motion 1 m, of velocity 1.2 m/s, deck 2 m, threshold 1 m/s"
    return [
        Case(
            id="ochi-threshold",
            title="threshold velocity on 520 ft",
            kind="published",
            source=OCHI,
            published=float(row["threshold_fps"]),
            computed=lambda: float(statistics.threshold_velocity(float(row["length_ft"]) * FOOT)) / FOOT,
            tolerance=0.005 * float(row["threshold_fps"]),
            unit="ft/s",
        ),
        Case(
            id="ochi-probability",
            title="probability of a slam per cycle",
            kind="closed form",
            source=OCHI,
            published=float(decay),
            computed=lambda: float(_example().slamming_probability.item()),
            tolerance=1e-9,
            note=example,
        ),
        Case(
            id="ochi-slams-per-hour",
            title="slams per hour",
            kind="closed form",
            source=OCHI,
            published=float(per_hour),
            computed=lambda: float(_example().slams_per_hour.item()),
            tolerance=1e-6,
            unit="1/h",
            note=example,
        ),
        Case(
            id="ochi-largest-pressure",
            title="most probable largest pressure in 3 h, k = 100",
            kind="closed form",
            source=OCHI,
            published=float(largest),
            computed=lambda: _largest_pressure(3.0),
            tolerance=0.03 * largest,
            unit="kPa",
            note=f"{example}; rho k m2 [ln(T/2pi sqrt(m2/m0)) - d^2/2 m0]; tolerance: its cells of velocity",
        ),
        Case(
            id="required-height-inverts-rate",
            title="slams per hour of a deck at the height required for 20 per hour",
            kind="closed form",
            source=OCHI,
            published=20.0,
            computed=_rate_at_required_height,
            tolerance=1e-9,
            unit="1/h",
        ),
    ]
