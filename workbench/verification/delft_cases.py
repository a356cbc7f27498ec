"""The Delft 372 catamaran against its towing-tank and basin tests [Veer1998]_.

Amplitudes are compared by their mean absolute difference over the measured peak,
phases by their mean difference. A tenth of the peak and ten degrees count as
agreement; the two test series of the model themselves differ by 0.18 of the peak
in heave and 0.09 in pitch, in part for other gyradii.

.. [Veer1998] R. van 't Veer, "Experimental results of motions, hydrodynamic coefficients and
    wave loads on the 372 catamaran model", Delft University of Technology, reports 1129
    and 1130, 1998.
"""

from collections.abc import Callable, Iterator

import numpy as np

from workbench.conventions import GRAVITY
from workbench.geometry.hydrostatics import hydrostatics, longitudinal_stiffness_about, stiffness_matrix
from workbench.verification import delft, published
from workbench.verification.case import Case

MOTION_TOLERANCE, LEAD_TOLERANCE, PEAK_TOLERANCE = 0.10, 10.0, 0.18
LOAD_TOLERANCE, COEFFICIENT_TOLERANCE = 0.15, 0.20
WORDS = {
    "apart": "hulls apart",
    "together": "hulls together",
    "forward-speed": "hulls together, Capytaine's forward-speed option",
}
TOO_FAST = (
    "the potentials are those of a ship at rest that pulsates at the encounter frequency; the waves of the "
    "moving hull, dynamic lift and trim, all left out, are not small at Fn 0.75"
)
GAP = (
    "the zero-speed Green function keeps waves between the hulls that a ship at speed leaves behind; they "
    "resonate in the computation and hardly in the tank"
)
ALONE = (
    "each hull is solved alone: what of the waves between the hulls is real at Fn 0.30 is missing, and they "
    "raise the peak"
)
DIFFRACTED = (
    "the diffracted wave is that of a hull at rest: at speed its phase is another, most so at the ends, "
    "where the pitch moment is made"
)
BASIN = (
    "the free-sailing series itself lies 0.18 of the peak in heave and 0.09 in pitch from the towing tank's; "
    "beyond that, what is said of the towed model"
)
OPTION = (
    "Capytaine's forward-speed option holds for small speeds, and keeps the waves between the hulls: its "
    "heave peak is 1.68 times the measured one at Fn 0.30 and 2.21 times at Fn 0.75"
)

MISSES: dict[str, float] = {
    "delft-heave-fn03-apart": 0.127,
    "delft-pitch-fn03-together": 0.185,
    "delft-heave-fn03-forward-speed": 0.175,
    "delft-pitch-fn03-forward-speed": 0.221,
    "delft-heave-fn075-apart": 0.183,
    "delft-heave-fn075-apart-lead": 12.3,
    "delft-pitch-fn075-apart": 0.159,
    "delft-pitch-fn075-apart-lead": 24.1,
    "delft-heave-fn075-together": 0.154,
    "delft-heave-fn075-together-lead": 15.0,
    "delft-pitch-fn075-together": 0.146,
    "delft-pitch-fn075-together-lead": 21.2,
    "delft-heave-fn075-forward-speed": 0.359,
    "delft-pitch-fn075-forward-speed": 0.338,
    "delft-added-mass-heave-apart": 0.541,
    "delft-radiation-damping-heave-apart": 0.83,
    "delft-free-heave-180-apart": 0.153,
    "delft-free-heave-195-apart": 0.128,
    "delft-load-pitch-apart-lead": -15.5,
    "delft-added-mass-pitch-apart": 0.309,
    "delft-radiation-damping-pitch-apart": 0.53,
    "delft-free-pitch-180-apart": 0.131,
    "delft-free-pitch-195-apart": 0.146,
    "delft-load-heave-together-lead": -19.6,
    "delft-added-mass-heave-together": 0.49,
    "delft-radiation-damping-heave-together": 0.455,
    "delft-free-heave-180-together": 0.122,
    "delft-free-heave-195-together": 0.14,
    "delft-load-pitch-together-lead": -23.3,
    "delft-added-mass-pitch-together": 0.601,
    "delft-radiation-damping-pitch-together": 0.524,
    "delft-free-pitch-180-together": 0.207,
    "delft-free-pitch-195-together": 0.188,
}
"""Computed figures of the comparisons that are known not to agree."""


def _reason(name: str) -> str:
    """Why a comparison does not agree."""
    if "forward-speed" in name:
        return OPTION
    if "fn075" in name:
        return TOO_FAST
    if "free" in name:
        return BASIN
    if "lead" in name:
        return DIFFRACTED
    return ALONE if name.endswith("apart") else GAP


def _force_cases() -> Iterator[tuple[str, str, float, str, Callable[[], float]]]:
    """Give id, title, tolerance, unit and computation of the comparisons with measured series."""
    for froude_number in (0.3, 0.75):
        fn = f"{froude_number:g}".replace(".", "")
        for treatment in delft.TREATMENTS:
            for mode in ("heave", "pitch"):
                key, words = f"{mode}-fn{fn}-{treatment}", f"{mode}, Fn {froude_number}, {WORDS[treatment]}"
                towed = (froude_number, mode, treatment)
                yield (
                    f"delft-{key}",
                    f"{words}: mean difference",
                    MOTION_TOLERANCE,
                    "-",
                    lambda towed=towed: delft.towed(*towed).mean_difference,
                )
                if treatment == "forward-speed":
                    continue
                yield (
                    f"delft-{key}-lead",
                    f"{words}: mean difference of phase",
                    LEAD_TOLERANCE,
                    "degrees",
                    lambda towed=towed: float(np.degrees(delft.towed(*towed).lead_difference)),
                )
    for treatment in ("apart", "together"):
        for mode in ("heave", "pitch"):
            words, chosen = WORDS[treatment], (0.3, mode, treatment)
            yield (
                f"delft-load-{mode}-{treatment}",
                f"wave exciting force in {mode}, Fn 0.3, {words}: mean difference",
                LOAD_TOLERANCE,
                "-",
                lambda chosen=chosen: delft.wave_load(*chosen).mean_difference,
            )
            yield (
                f"delft-load-{mode}-{treatment}-lead",
                f"wave exciting force in {mode}, Fn 0.3, {words}: mean difference of phase",
                LEAD_TOLERANCE,
                "degrees",
                lambda chosen=chosen: float(np.degrees(delft.wave_load(*chosen).lead_difference)),
            )
            for quantity in ("added_mass", "radiation_damping"):
                yield (
                    f"delft-{quantity}-{mode}-{treatment}".replace("_", "-"),
                    f"{quantity.replace('_', ' ')} of {mode}, Fn 0.3, {words}: mean difference",
                    COEFFICIENT_TOLERANCE,
                    "-",
                    lambda quantity=quantity, mode=mode, treatment=treatment: (
                        delft.oscillation(0.3, mode, quantity, treatment).mean_difference
                    ),
                )
            for heading in (180, 195):
                yield (
                    f"delft-free-{mode}-{heading}-{treatment}",
                    f"{mode} of the free model, Fn 0.3, heading {heading} degrees, {words}: mean difference",
                    MOTION_TOLERANCE,
                    "-",
                    lambda chosen=chosen, heading=heading: (
                        delft.free(*chosen, float(heading)).mean_difference
                    ),
                )


def _hydrostatic(name: str) -> float:
    ship = delft.model()
    if name == "displacement":
        return float(hydrostatics(ship.hull, ship.density).displacement)
    matrix = stiffness_matrix(ship.hull, ship.masses, ship.density)
    about = longitudinal_stiffness_about(matrix, ship.masses.centre_of_gravity[0])
    if name == "C33":
        return float(about[0, 0])
    if name == "C35":
        return float(abs(about[0, 1]))
    afloat = hydrostatics(ship.hull, ship.density, 0.0)
    weight = GRAVITY * float(afloat.displacement)
    lever = float(afloat.centre_of_buoyancy[2]) - ship.masses.centre_of_gravity[2]
    return float(about[1, 1] - weight * lever)


NOTES = {
    "C35": "about the centre of gravity; the source prints a magnitude",
    "C55": "closes with the waterplane's part alone, about the centre of gravity; with the parts of buoyancy "
    "and gravity, which the motions here use, it is 5847 N m, 4.8 % less than printed",
}


def _hydrostatic_cases() -> list[Case]:
    return [
        Case(
            id=f"delft-hydrostatics-{name}".lower(),
            title=f"{name} of the Delft 372",
            kind="published",
            source=published.citation("veer_1998_hydrostatics"),
            published=published.value("veer_1998_hydrostatics", name)[0],
            computed=lambda name=name: _hydrostatic(name),
            tolerance=published.value("veer_1998_hydrostatics", name)[1],
            unit=published.value("veer_1998_hydrostatics", name)[2],
            note=NOTES.get(name, ""),
        )
        for name in ("displacement", "C33", "C35", "C55")
    ]


def _trend_cases() -> list[Case]:
    """Return what the measured motions do with speed, which the computed ones must do too."""
    source = published.citation("veer_1998_head_sea_motions")

    def both(compare: Callable[[delft.Comparison, delft.Comparison], bool]) -> float:
        return float(compare(delft.towed(0.3, "heave", "apart"), delft.towed(0.75, "heave", "apart")))

    def longest(series: delft.Comparison) -> float:
        return float(series.abscissa[np.argmax(series.computed)])

    return [
        Case(
            id="delft-trend-heave-grows",
            title="heave peak at Fn 0.75 is more than 1.5 times that at Fn 0.30 (1: yes; measured 1.87)",
            kind="trend",
            source=source,
            published=1.0,
            computed=lambda: both(lambda slow, fast: fast.computed.max() > 1.5 * slow.computed.max()),
            tolerance=0.0,
        ),
        Case(
            id="delft-trend-longer-waves",
            title="heave peak moves to longer waves with speed (1: yes; measured by 0.84 L)",
            kind="trend",
            source=source,
            published=1.0,
            computed=lambda: both(lambda slow, fast: longest(fast) > longest(slow)),
            tolerance=0.0,
        ),
    ]


def cases() -> list[Case]:
    """Return the cases of this module."""
    source = published.citation("veer_1998_head_sea_motions")
    made = _hydrostatic_cases()
    for name, title, tolerance, unit, computed in _force_cases():
        made.append(
            Case(
                id=name,
                title=title,
                kind="published",
                source=published.citation("veer_1998_basin_motions") if "free" in name else source,
                published=0.0,
                computed=computed,
                tolerance=tolerance,
                unit=unit,
                miss=_reason(name) if name in MISSES else "",
                miss_figure=MISSES.get(name),
                miss_band=2.0 if unit == "degrees" else 0.02,
                slow="forward-speed" in name,
            )
        )
    return made + _trend_cases()
