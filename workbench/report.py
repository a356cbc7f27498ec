"""The index page and the figures of a study."""

from typing import TYPE_CHECKING, Any

import jinja2
import numpy as np
from matplotlib.figure import Figure

from workbench import __version__, quantities
from workbench.conventions import KNOT, MODES, TRANSLATIONS
from workbench.figures import (
    clearance,
    counts,
    deck_plan,
    hull_lines,
    motions,
    pressure,
    pressure_area,
    style,
)
from workbench.geometry.sections import surface
from workbench.motions import lead_over_wave
from workbench.verdict import verdict

if TYPE_CHECKING:
    from workbench.study import Study

CAPTIONS = {
    "motions": "Heave, roll and pitch per wave amplitude, and their phases",
    "slams": "Slams per hour over the wet deck",
    "clearance": "Slams per hour at the worst point against clearance",
    "counted": "Counted slams and closed form along the deck",
    "classes": "Slams by entry velocity squared",
    "pressure": "Most probable largest peak pressure over the wet deck",
    "pressures": "Peak pressures of the counted slams",
    "arrangement": "Hulls and wet deck",
    "envelope": "Largest pressure averaged over each panel of the deck, of all slams",
    "pressure-area": "Average pressure against the area averaged over",
}
OF_DECK_PRESSURE = "envelope", "pressure-area"
"""Figures of the pressure over the deck by the wet-deck theory."""


def drawn(figure: Figure, kind: str) -> bytes:
    """Return a figure as PNG or SVG."""
    return style.picture(figure, kind)


def pictures(done: "Study") -> dict[str, Figure]:
    """Return the figures of a study by name."""
    slam, found, worst = done.slam, done.slam.statistics, done.slam.worst_point
    here = found.isel(worst)
    mark = (float(here.x), float(here.y))
    length = done.ship.design.hull.length
    return {
        "motions": motions.motions_figure(
            done.ship.motions,
            lead_over_wave(done.ship.motions),
            wave_direction=slam.condition.wave_direction,
            length=length,
        ),
        "slams": deck_plan.deck_plan_figure(
            found.slams_per_hour,
            slam.deck,
            mark=mark,
            mark_label="worst point",
            nothing="This deck does not slam.",
        ),
        "clearance": clearance.clearance_figure(
            done.curve,
            clearance=slam.clearance,
            slams_per_hour=float(here.slams_per_hour),
            criterion_per_hour=slam.criterion_per_hour,
            least_clearance=slam.least_clearance,
        ),
        "counted": counts.counts_figure(
            found,
            done.counts,
            column=worst["y"],
            hours=done.realisation.hours,
            seed=int(done.realisation.seed),
        ),
        "classes": counts.velocity_classes_figure(done.classes),
        "pressure": deck_plan.deck_plan_figure(
            found.most_probable_peak_pressure, slam.deck, nothing="No slam is expected in this time."
        ),
        "pressures": pressure.pressure_histogram_figure(
            done.events, expected_peak=float(here.most_probable_peak_pressure), hours=slam.hours
        ),
        "arrangement": hull_lines.arrangement_figure(
            *surface(done.ship.design.hull), slam.deck, done.ship.design.masses.centre_of_gravity
        ),
        "envelope": deck_plan.deck_plan_figure(
            done.deck_slams.pressure_envelope, slam.deck, nothing="The deck stays dry."
        ),
        "pressure-area": pressure_area.pressure_area_figure(done.deck_slams),
    }


def index_page(done: "Study", summary: dict[str, Any], names: list[str], film: bool) -> str:
    """Return the index page of a study's folder."""
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("workbench", "templates"), autoescape=True, trim_blocks=False
    )
    slam, worst = done.slam, summary["worst_point"]
    sentence = verdict(
        speed_knots=done.ship.speed / KNOT,
        significant_wave_height=slam.condition.sea_state.significant_wave_height,
        heading_degrees=summary["heading_degrees"],
        slams_per_hour=worst["slams_per_hour"],
        distance_from_fore_end=done.ship.design.wet_deck.fore - worst["x"],
        clearance=slam.clearance,
        least_clearance=slam.least_clearance,
        criterion_per_hour=slam.criterion_per_hour,
    )
    low, high = worst["counted_band"]
    numbers = [
        ("slams per hour at the worst point, closed form", f"{worst['slams_per_hour']:.4g}", "1/h"),
        ("counted", f"{worst['counted_per_hour']:.4g}", "1/h"),
        ("99 % sampling band of the count", f"{low:.4g} to {high:.4g}", "1/h"),
        ("mean entry velocity", f"{worst['mean_entry_velocity']:.3g}", "m/s"),
        (
            f"most probable peak pressure in {slam.hours:g} h",
            f"{worst['most_probable_peak_pressure'] / 1e3:.4g}",
            "kPa",
        ),
        ("clearance", f"{slam.clearance:.4g}", "m"),
        (
            f"least clearance for {slam.criterion_per_hour:g} slams per hour",
            f"{slam.least_clearance:.4g}",
            "m",
        ),
    ]
    contents = [
        ("results.nc", "motions, statistics and counts with units (netCDF; complex numbers as pairs)"),
        ("summary.json", "the numbers of the command line"),
        ("motions.csv", "motions per wave amplitude"),
        ("slamming.csv", "statistics at every point of the deck"),
        ("slams.csv", "every counted entry of a point of the deck"),
        ("deck-slams.csv", "pressure, force and impulse of every slam, by the wet-deck theory"),
        ("deck-slams.nc", "all of that with the panels' pressures and the envelope (netCDF)"),
        *_hardest_files(done),
        ("design.toml", "the design"),
    ]
    return environment.get_template("index.html.j2").render(
        title=done.scene.attrs["title"],
        verdict=sentence,
        notes=quantities.warnings_of(slam.statistics),
        numbers=numbers,
        motions=_motion_rows(done),
        figures=[(name, CAPTIONS[name]) for name in names if name not in OF_DECK_PRESSURE],
        deck_pressure=_deck_pressure(done),
        files=contents,
        film=film,
        version=__version__,
        solver=done.ship.hydrodynamics.attrs["solver"],
    )


def _motion_rows(done: "Study") -> list[tuple[str, ...]]:
    """Return rows of standard deviations of motion, velocity and acceleration."""
    table = done.slam.motion_statistics
    rows = []
    for mode in MODES:
        factor, unit = (1.0, "m") if mode in TRANSLATIONS else (float(np.degrees(1.0)), "degrees")
        deviations = (
            f"{round(factor * float(table[name].sel(dof=mode)), 6):.3g}"
            for name in ("motion_std", "velocity_std", "acceleration_std")
        )
        rows.append((mode, *deviations, unit + ", /s, /s²"))
    return rows


def _hardest_files(done: "Study") -> list[tuple[str, str]]:
    """Return the files of the hardest slam; none where the deck stays dry."""
    if done.hardest_slam is None:
        return []
    return [
        ("hardest-slam.csv", "force and wetted area of the slam with the largest panel pressure, in time"),
        ("hardest-slam.nc", "pressure of every panel in that slam, in time (netCDF)"),
    ]


def _deck_pressure(done: "Study") -> dict[str, Any]:
    """Return what the page says about the pressure over the deck by the wet-deck theory."""
    slams, count = done.deck_slams, done.deck_slams.sizes["slam"]
    attrs = slams.attrs
    rows = [("slams", f"{count}", f"in {attrs['duration'] / 3600:.3g} h")]
    if count:
        rows += [
            ("largest panel pressure", f"{float(slams.slam_pressure.max()) / 1e3:.4g}", "kPa"),
            ("exceeded in a tenth of the slams", f"{np.quantile(slams.slam_pressure, 0.9) / 1e3:.4g}", "kPa"),
            ("largest force", f"{float(slams.slam_force.max()) / 1e3:.4g}", "kN"),
            ("largest impulse", f"{float(slams.slam_impulse.max()) / 1e3:.4g}", "kN s"),
            ("largest wetted area", f"{float(slams.slam_wetted_area.max()):.4g}", "m²"),
        ]
    return {
        "words": (
            f"Pressures averaged over panels of {attrs['panel_length']:.3g} m by {attrs['strip_width']:.3g} m and over "
            f"{1e3 * attrs['time_step']:.3g} ms, seed {attrs['seed']}; strips of the deck {attrs['strips']}."
        ),
        "numbers": rows,
        "notes": quantities.warnings_of(slams),
        "figures": [(name, CAPTIONS[name]) for name in OF_DECK_PRESSURE],
    }
