"""Chuang's prediction for a ship as a text to read, with the limits of the method."""

from typing import Any

import jinja2
import numpy as np

from workbench import __version__
from workbench.conventions import KNOT
from workbench.cross_structure import CrossStructure
from workbench.figures.style import number_words
from workbench.impact.design_load import SIDE_SHARE
from workbench.impact.slam_table import Agreement
from workbench.quantities import warnings_of

LIMITS = (
    "Head seas; the effect of the ship's heading was not investigated.",
    "Flat bottom of the cross structure, without deadrise.",
    "Verified by towed models in regular waves and by twelve slams of one ship at sea.",
    "Local loads of the cross structure only; bending and whipping of the whole ship are not in it.",
    "No percentage is known by which more clearance lowers the pressure; it lowers the number of slams.",
    "Elasticity of the bottom is not resolved: the two thicknesses tested differ too little.",
    "The peak lasts some milliseconds on some square feet; means over a panel are two to six times lower.",
)
"""Limits of the method, as the source states them."""


def report_values(found: CrossStructure) -> dict[str, Any]:
    """Return the prediction as plain values, SI and radians, for JSON."""
    here = found.slams.isel(found.worst)
    wave = found.motion.wave
    slams = found.timing.slams

    def number(name: str) -> float | None:
        value = float(here[name])
        return value if np.isfinite(value) else None

    return {
        "name": found.name,
        "speed": wave.speed,
        "wave_height": 2 * wave.amplitude,
        "wave_period": wave.period,
        "wavelength": wave.wavelength,
        "encounter_period": 2 * np.pi / wave.encounter_frequency,
        "heave_amplitude": found.motion.heave_amplitude,
        "pitch_amplitude": found.motion.pitch_amplitude,
        "natural_periods": found.natural_periods,
        "slams": slams,
        "worst_point": {
            "x": float(here.x),
            "y": float(here.y),
            **{
                name: number(name)
                for name in ("normal_velocity", "impact_angle", "pressure_constant", "peak_pressure", "attitude",
                             "wave_slope", "event_time")
            },
        },
        "timing": list(found.timing.notes),
        "bulkhead_pressure": found.bulkhead_pressure,
        "design_peak": float(found.load.design_pressure.max()) if found.load is not None else None,
        "limits": list(LIMITS),
        "warnings": list(warnings_of(found.slams, *([] if found.load is None else [found.load]))),
    }  # fmt: skip


def report_text(found: CrossStructure, agreements: dict[str, Agreement] | None = None) -> str:
    """Return the prediction as Markdown.

    Parameters
    ----------
    found : from `workbench.cross_structure.cross_structure`.
    agreements : of the method with records by their name, from `workbench.impact.slam_table.agreement`.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("workbench", "templates"),
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["words"] = number_words
    environment.filters["degrees"] = lambda value: number_words(np.degrees(value))
    environment.filters["kilo"] = lambda value: number_words(value / 1e3)
    environment.filters["knots"] = lambda value: number_words(value / KNOT)
    load = None
    if found.load is not None:
        ends = found.load.isel(x=[-1, 0])
        load = [
            (float(s), float(p), SIDE_SHARE * float(p))
            for s, p in zip(ends.station, found.load.attrs["area_share"] * ends.design_line, strict=True)
        ]
    return environment.get_template("cross_structure.md.j2").render(
        values=report_values(found), load=load, agreements=agreements or {}, version=__version__
    )
