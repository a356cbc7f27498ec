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
from workbench.verification.delft_in_time import towed_in_time
from workbench.verification.delft_misses import MISSES, RUNNING, UNLIKE, reason

MOTION_TOLERANCE, LEAD_TOLERANCE, PEAK_TOLERANCE = 0.10, 10.0, 0.18
LARGEST_LEAD_TOLERANCE, LOAD_TOLERANCE, COEFFICIENT_TOLERANCE = 20.0, 0.15, 0.20
WORDS = {
    "apart": "hulls apart",
    "together": "hulls together",
    "forward-speed": "hulls together, Capytaine's forward-speed option",
    "strip": "strip theory",
    "high-speed": "high-speed theory",
    "recommended": "recommended theory",
}


def _motion_cases(treatment: str) -> Iterator[tuple[str, str, float, str, Callable[[], float]]]:
    """Give the comparisons with the towing tank: amplitude, mean phase and, for what is recommended, largest phase."""
    for froude_number in (0.3, 0.75):
        fn = f"{froude_number:g}".replace(".", "")
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
            if treatment == "recommended":
                yield (
                    f"delft-{key}-largest-lead",
                    f"{words}: largest difference of phase",
                    LARGEST_LEAD_TOLERANCE,
                    "degrees",
                    lambda towed=towed: float(np.degrees(delft.towed(*towed).largest_lead_difference)),
                )


def _in_time_cases() -> Iterator[tuple[str, str, float, str, Callable[[], float]]]:
    """Give the comparisons of the simulation in waves of the measured height with the towing tank."""
    for froude_number in (0.3, 0.75):
        fn = f"{froude_number:g}".replace(".", "")
        for mode in ("heave", "pitch"):
            yield (
                f"delft-{mode}-fn{fn}-in-time",
                f"{mode}, Fn {froude_number}, simulated in waves of the measured height: mean difference",
                MOTION_TOLERANCE,
                "-",
                lambda chosen=(froude_number, mode): towed_in_time(*chosen).mean_difference,
            )


def _load_cases(
    treatment: str, froude_number: float
) -> Iterator[tuple[str, str, float, str, Callable[[], float]]]:
    """Give the comparisons of wave loads, forced oscillation and free sailing at one speed."""
    at = "" if froude_number == 0.3 else f"-fn{froude_number:g}".replace(".", "")
    for mode in ("heave", "pitch"):
        words, chosen = WORDS[treatment], (froude_number, mode, treatment)
        yield (
            f"delft-load-{mode}{at}-{treatment}",
            f"wave exciting force in {mode}, Fn {froude_number}, {words}: mean difference",
            LOAD_TOLERANCE,
            "-",
            lambda chosen=chosen: delft.wave_load(*chosen).mean_difference,
        )
        yield (
            f"delft-load-{mode}{at}-{treatment}-lead",
            f"wave exciting force in {mode}, Fn {froude_number}, {words}: mean difference of phase",
            LEAD_TOLERANCE,
            "degrees",
            lambda chosen=chosen: float(np.degrees(delft.wave_load(*chosen).lead_difference)),
        )
        for quantity in ("added_mass", "radiation_damping"):
            yield (
                f"delft-{quantity}-{mode}{at}-{treatment}".replace("_", "-"),
                f"{quantity.replace('_', ' ')} of {mode}, Fn {froude_number}, {words}: mean difference",
                COEFFICIENT_TOLERANCE,
                "-",
                lambda quantity=quantity, mode=mode: (
                    delft.oscillation(froude_number, mode, quantity, treatment).mean_difference
                ),
            )
        for heading in (180, 195):
            yield (
                f"delft-free-{mode}-{heading}{at}-{treatment}",
                f"{mode} of the free model, Fn {froude_number}, heading {heading} degrees, {words}: mean difference",
                MOTION_TOLERANCE,
                "-",
                lambda chosen=chosen, heading=heading: delft.free(*chosen, float(heading)).mean_difference,
            )


def _force_cases() -> Iterator[tuple[str, str, float, str, Callable[[], float]]]:
    """Give id, title, tolerance, unit and computation of the comparisons with measured series."""
    for treatment in ("apart", "together", "forward-speed", "strip", "recommended"):
        yield from _motion_cases(treatment)
    for treatment in ("apart", "together", "strip", "recommended"):
        yield from _load_cases(treatment, 0.3)
    yield from _load_cases("recommended", 0.75)
    yield from _in_time_cases()


def _closure_cases() -> list[Case]:
    """Return whether the measured series agree among themselves."""
    return [
        Case(
            id=f"delft-heave-from-measured-fn{fn}".replace(".", ""),
            title=f"heave peak from measured coefficients and loads over the measured one, Fn {fn}",
            kind="published",
            source=published.citation("veer_1998_forced_oscillation"),
            published=1.0,
            computed=lambda fn=fn: delft.heave_from_measured(fn),
            tolerance=0.10,
            miss=UNLIKE,
            miss_figure=MISSES[f"delft-heave-from-measured-fn{fn}".replace(".", "")],
            miss_band=0.02,
        )
        for fn in (0.3, 0.75)
    ]


def _attitude_cases() -> list[Case]:
    """Return the running attitude from the ship's own wave against the measured one."""
    made = []
    for froude_number in (0.3, 0.75):
        table = published.columns("veer_1998_running_attitude", froude_number=froude_number)
        for place, (column, unit, tolerance) in enumerate(
            (("sinkage_mm", "mm", 3.0), ("trim_degrees", "degrees", 0.1))
        ):
            name = f"delft-running-{column.split('_')[0]}-fn{froude_number}".replace(".", "")
            made.append(
                Case(
                    id=name,
                    title=f"running {column.split('_')[0]}, Fn {froude_number}, from the ship's own wave",
                    kind="published",
                    source=published.citation("veer_1998_running_attitude"),
                    published=float(table[column][0]),
                    computed=lambda froude_number=froude_number, place=place: delft.running_attitude(
                        froude_number
                    )[place],
                    tolerance=tolerance,
                    unit=unit,
                    miss=RUNNING if name in MISSES else "",
                    miss_figure=MISSES.get(name),
                    miss_band=0.3,
                )
            )
    return made


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
                miss=reason(name) if name in MISSES else "",
                miss_figure=MISSES.get(name),
                miss_band=2.0 if unit == "degrees" else 0.02,
                slow="forward-speed" in name,
            )
        )
    return made + _closure_cases() + _attitude_cases() + _trend_cases()
