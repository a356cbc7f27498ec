"""Measure and print: ``python -m tests.benchmarks [name ...]``.

Every figure is the median of several runs on this machine, as it is loaded now;
where there is a rival, both are measured in turn and their ratio is printed.
"""

import resource
import statistics
import sys
import time
from collections.abc import Callable

import numpy as np

from tests.benchmarks import app, simulation, theories, wet_deck
from workbench import pipeline
from workbench.conventions import GRAVITY
from workbench.hulls import library
from workbench.hydrodynamics import potential_flow
from workbench.seas import Condition, SeaState
from workbench.time_domain import Realisation, record_blocks, relative_amplitudes, wave_components

Row = tuple[str, str, str]


def median_time(action: Callable[[], object], runs: int = 5) -> float:
    """Median wall time of an action [s], after one run that is not counted."""
    action()
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def ship():
    """The shipped 76 m catamaran at 30 knots in head seas, on 400 deck points."""
    design = library.design("austal-63")
    found = pipeline.response(design, 15.4333)
    relative = pipeline.deck_response(found, design.wet_deck, (40, 10))
    sea = SeaState(significant_wave_height=3.0, peak_period=8.0)
    return design, found, relative, Condition(speed=15.4333, wave_direction=np.pi, sea_state=sea)


def slider() -> list[Row]:
    """A slider's change to statistics of the whole deck: 400 points, 48 frequencies."""
    design, found, relative, condition = ship()
    heights = iter(np.linspace(2.0, 3.0, 100))

    def action():
        sea = SeaState(significant_wave_height=next(heights), peak_period=8.0)
        moved = Condition(speed=condition.speed, wave_direction=np.pi, sea_state=sea)
        return pipeline.slamming(found, relative, design.wet_deck, moved)

    seconds = median_time(action, 15)
    return [
        ("slider to whole-deck statistics, 400 points x 48 frequencies", f"{seconds:.3f} s", "at most 0.1 s")
    ]


def hour() -> list[Row]:
    """One hour at 20 Hz of relative motion on 400 deck points, against a numpy loop over the components."""
    design, found, relative, condition = ship()
    components = wave_components(condition, Realisation(), 0.1, 2.5)
    rise, _ = relative_amplitudes(components, found.motions, relative)
    flat, frequency = rise.reshape(len(rise), -1), components.component_frequency.values

    def ours(duration=3600.0):
        kept = np.empty((flat.shape[1], int(duration * 20) + 1), np.float32)
        for start, block in record_blocks(flat, frequency, duration, 0.05):
            kept[:, start : start + block.shape[1]] = block
        return kept

    def loop(duration):
        times = (np.arange(int(duration * 20) + 1) * 0.05).astype(np.float32)
        kept = np.zeros((flat.shape[1], len(times)), np.float32)
        for amplitude, omega in zip(flat, frequency.astype(np.float32), strict=True):
            size, phase = np.abs(amplitude).astype(np.float32), np.angle(amplitude).astype(np.float32)
            kept += size[:, None] * np.cos(omega * times[None, :] - phase[:, None])
        return kept

    np.testing.assert_allclose(ours(20.0), loop(20.0), atol=2e-3)
    seconds = median_time(ours, 3)
    start = time.perf_counter()
    loop(360.0)
    rival = 10 * (time.perf_counter() - start)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    counted = median_time(
        lambda: pipeline.counted_slams(
            found, relative, pipeline.slamming(found, relative, design.wet_deck, condition), Realisation()
        ),
        1,
    )
    return [
        (
            "one hour at 20 Hz on 400 points",
            f"{seconds:.2f} s, peak memory {memory:.2f} GB",
            "at most 3 s, 2 GB",
        ),
        (
            "numpy loop over components (six minutes, times ten) / ours",
            f"{rival / seconds:.0f}",
            "at least 10",
        ),
        ("counting all slams of that hour, velocities, angles, pressures", f"{counted:.2f} s", ""),
    ]


def capytaine() -> list[Row]:
    """Delft 372, about 1000 panels, 30 frequencies, head seas, six modes: against Capytaine called directly."""
    import capytaine as cpt

    from workbench.geometry.panels import lid_panels, panels
    from workbench.hydrodynamics.forward_speed import RadiatingBody, hydrodynamics
    from workbench.hydrodynamics.radiation import RadiationProblem, radiation

    hull = library.design("delft-372").hull
    wetted, lid = panels(hull, 1000), lid_panels(hull)
    omega = np.linspace(2.0, 9.0, 30)
    potential_flow.prepared_green_function()
    body = potential_flow._body(wetted, lid)
    green_function = cpt.Delhommeau(gf_singularities="low_freq")

    def direct():
        solver = cpt.BEMSolver(engine=cpt.DefaultMatrixEngine(green_function=green_function))
        common = {"body": body, "rho": 1000.0, "g": GRAVITY}
        for frequency in omega:
            problems = [
                cpt.RadiationProblem(radiating_dof=dof, omega=frequency, **common) for dof in body.dofs
            ]
            problems.append(cpt.DiffractionProblem(omega=frequency, wave_direction=np.pi, **common))
            solver.solve_all(problems, progress_bar=False, keep_details=False, _check_wavelength=False)

    def ours():
        solved = radiation(RadiationProblem(panels=wetted, lid=lid), omega)
        return hydrodynamics([RadiatingBody(solved)], omega, [np.pi], 0.0, 1000.0)

    ratios, ours_seconds, direct_seconds = [], [], []
    for _ in range(3):
        for action, kept in ((ours, ours_seconds), (direct, direct_seconds)):
            start = time.perf_counter()
            action()
            kept.append(time.perf_counter() - start)
        ratios.append(ours_seconds[-1] / direct_seconds[-1])
    return [
        (
            f"Delft 372, {2 * len(wetted)} panels and lid, 30 frequencies, six modes: ours / Capytaine directly",
            f"{statistics.median(ratios):.2f} "
            f"({statistics.median(ours_seconds):.1f} s / {statistics.median(direct_seconds):.1f} s)",
            "at most 1.2",
        )
    ]


BENCHMARKS = {
    "slider": slider,
    "hour": hour,
    "capytaine": capytaine,
    "theories": theories.theories,
    "app": app.page,
    "simulation": simulation.hour,
    "wet-deck": wet_deck.hour,
}


def main(names: list[str]) -> None:
    """Run the named benchmarks, or all."""
    for name in names or list(BENCHMARKS):
        for what, measured, wanted in BENCHMARKS[name]():
            print(f"{what:<88} {measured:<34} {wanted}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
