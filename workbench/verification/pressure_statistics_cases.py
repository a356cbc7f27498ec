"""Statistics of slam pressure: Ochi's exponential law, its joint form, counting, extremes, tails and classes.

.. [Ochi1964] M. K. Ochi, "Prediction of occurrence and severity of ship slamming
    at sea", 5th Symp. on Naval Hydrodynamics, Bergen, 1964, pp. 545-596.
"""

from functools import cache

import numpy as np
import xarray as xr

from workbench.conventions import SEAWATER_DENSITY
from workbench.impact.panel_library import computed_panel, panel_coefficient
from workbench.impact.section import Wedge
from workbench.slamming.pressure_classes import expected_classes, pressure_classes
from workbench.slamming.pressure_statistics import (
    counted_exceedance,
    exponential_exceedance,
    joint_exceedance,
    largest_pressures,
    rate_band,
)
from workbench.slamming.tail_fit import panel_slams, tail_extremes
from workbench.verification import counting_cases
from workbench.verification.case import Case

PANEL = panel_coefficient("crowther-318 main beam")
LEVELS = np.linspace(0.0, 3e6, 301)
HOURS, RISK = 100.0, 0.01
OCHI = (
    'M. K. Ochi, "Prediction of occurrence and severity of ship slamming at sea", 5th Symp. on Naval '
    "Hydrodynamics, Bergen, 1964"
)
GARWOOD = 'F. Garwood, "Fiducial limits for the Poisson distribution", Biometrika 28, 437-442, 1936'
SEA = "head sea of 3 m and 8 s at 10 m/s, a point at rest 1.5 m above still water, k = 40.8"


@cache
def _closed_form() -> tuple[xr.Dataset, xr.Dataset, xr.Dataset]:
    moments, statistics = counting_cases.closed_form(0.0)
    return moments, statistics, counting_cases.flat_point(counting_cases.CLEARANCE)


@cache
def _record() -> xr.Dataset:
    """Return 24 hours of entries with the pressures of the panel."""
    record = counting_cases.counted(0.0)
    return record.assign(peak_pressure=("event", PANEL.pressure(record.entry_velocity.values)))


@cache
def _exact() -> xr.Dataset:
    moments, statistics, _ = _closed_form()
    return exponential_exceedance(moments, statistics, LEVELS, PANEL.coefficient, SEAWATER_DENSITY)


def _ochis_largest() -> float:
    """Return rho k m2 (ln(T/(2 pi) sqrt(m2/m0)) - d**2/(2 m0)) for T = 3600 hours."""
    moments, _, _ = _closed_form()
    m0, m2 = (float(moments[f"relative_{name}_std"].item()) ** 2 for name in ("motion", "velocity"))
    cycles = np.log(3600 * HOURS / (2 * np.pi) * np.sqrt(m2 / m0))
    return SEAWATER_DENSITY * PANEL.coefficient * m2 * (cycles - counting_cases.CLEARANCE**2 / (2 * m0))


def _largest(name: str) -> float:
    return float(largest_pressures(_exact(), HOURS, RISK)[name].item())


def _joint_over_exact() -> float:
    moments, statistics, deck = _closed_form()
    joint = joint_exceedance(moments, statistics, deck, LEVELS, PANEL.law, SEAWATER_DENSITY)
    exact = _exact().exceedance_per_hour.values
    there = exact > 1e-5
    ratio = joint.exceedance_per_hour.values[there] / exact[there]
    return float(ratio[np.argmax(np.abs(ratio - 1))])


def _share_in_bands() -> float:
    levels = LEVELS[LEVELS < float(_record().peak_pressure.max())]
    counted = counted_exceedance(_record(), levels, _closed_form()[2])
    exact = _exact().exceedance_per_hour.sel(pressure_level=levels)
    inside = (counted.exceedance_low <= exact) & (exact <= counted.exceedance_high)
    return float(inside.mean())


def _tail() -> xr.Dataset:
    pressures, times = panel_slams(_record(), 0.0, 0.0)
    return tail_extremes(pressures, times, _record().attrs["duration"], HOURS, risk=RISK, tail="exponential")


def _tail_holds() -> float:
    found, inside = _tail(), 0
    for name, exact in (("most_probable", "most_probable_peak_pressure"), ("extreme", "extreme_pressure")):
        inside += float(found[f"{name}_low"]) <= _largest(exact) <= float(found[f"{name}_high"])
    return float(inside)


def _classes_apart() -> float:
    """Return the largest difference of slams in a class, counted against closed form, in deviations of the count."""
    moments, statistics, deck = _closed_form()
    hours = counting_cases.HOURS
    expected = expected_classes(moments, statistics, deck, PANEL.coefficient, SEAWATER_DENSITY, hours)
    limits = np.concatenate([[0.0], expected.class_limit.values[:-1], [np.inf]])
    number, _ = np.histogram(_record().entry_velocity.values ** 2, bins=limits)
    wanted = expected.class_per_hour.values * hours
    return float(np.max(np.abs(number - wanted) / np.sqrt(wanted)))


def _mean_class_pressure_ratio() -> float:
    """Return the mean pressure of the classes over that of the slams themselves."""
    classes = pressure_classes(_record(), PANEL.coefficient, SEAWATER_DENSITY)
    weighed = float((classes.class_pressure * classes.class_per_hour).sum() / classes.class_per_hour.sum())
    return weighed / float(_record().peak_pressure.mean())


def _pod() -> float:
    return computed_panel(
        Wedge(np.radians(45.0)), 0.0, 0.2, name="pod", vessel="crowther-318", panel="pod, 0.4 m wide",
        section_direction="transverse", method="logvinovich",
    ).coefficient  # fmt: skip


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [
        Case(
            id="pressure-most-probable-largest", kind="closed form", source=OCHI, published=_ochis_largest() / 1e3,
            title="most probable largest pressure of 100 h from the exceedance curve against Ochi's formula",
            computed=lambda: _largest("most_probable_peak_pressure") / 1e3, tolerance=1e-6, unit="kPa", note=SEA,
        ),
        Case(
            id="pressure-of-a-risk", kind="closed form", source=OCHI, unit="kPa", tolerance=0.8,
            title="pressure exceeded in 100 h with a risk of 1 %: Ochi's largest of 100 h over the risk",
            published=(_ochis_largest() + _scale() * np.log(1 / RISK)) / 1e3,
            computed=lambda: _largest("extreme_pressure") / 1e3,
            note="Ochi takes alpha for -ln(1 - alpha), 0.5 % apart at 1 %, which is 0.7 kPa",
        ),
        Case(
            id="pressure-joint-law", kind="second method", source=OCHI, published=1.0, tolerance=0.01,
            title="joint law over exponential law of a fixed k, where they are furthest apart, down to 1e-5 per hour",
            computed=_joint_over_exact, note=SEA,
        ),
        Case(
            id="pressure-counted-in-bands", kind="second method", source=OCHI, published=1.0, tolerance=0.03,
            title="share of pressures at which the 99 % band of 24 h counted holds the exponential law",
            computed=_share_in_bands, note=SEA,
        ),
        Case(
            id="pressure-garwood-low", kind="published", source=GARWOOD, published=3.717, tolerance=5e-4,
            title="lower end of the 99 % band of 10 counted", computed=lambda: float(rate_band(10.0)[0]),
        ),
        Case(
            id="pressure-garwood-high", kind="published", source=GARWOOD, published=21.398, tolerance=5e-4,
            title="upper end of the 99 % band of 10 counted", computed=lambda: float(rate_band(10.0)[1]),
        ),
        Case(
            id="pressure-tail", kind="second method", source=OCHI, published=2.0, tolerance=0.0,
            title="largest of 100 h, most probable and of 1 % risk, in the bands of a tail fitted to 24 h (2: both)",
            computed=_tail_holds, note=SEA,
        ),
        Case(
            id="pressure-classes-counted", kind="second method", published=0.0, tolerance=3.5,
            title="slams in five classes of velocity squared, 24 h counted, largest difference in deviations",
            source='K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, 2002, 4.3',
            computed=_classes_apart, note=SEA,
        ),
        Case(
            id="pressure-classes-mean", kind="closed form", published=1.0, tolerance=1e-12,
            title="mean pressure of the five classes over that of all slams",
            source='K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, 2002, 7.1.2',
            computed=_mean_class_pressure_ratio,
        ),
        Case(
            id="panel-pod-computed", kind="second method", published=2.71, tolerance=0.06,
            title="k of the pod, wedge of 45 degrees, by the modified Logvinovich model",
            source='K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, 2002, table 7.2',
            computed=_pod,
            note="the source by boundary elements; the generalised Wagner model gives 2.86, the exact wedge 2.59 at "
            "ten times the depth of the panel and 2.705 at the apex",
        ),
    ]  # fmt: skip


def _scale() -> float:
    moments, _, _ = _closed_form()
    return SEAWATER_DENSITY * PANEL.coefficient * float(moments.relative_velocity_std.item()) ** 2
