"""Slam loads of the Incat 98 m by Amin et al.: places, loads, impulses, and the contradictions of the source."""

import numpy as np

from workbench.conventions import KNOT
from workbench.verification import amin_conflicts, published
from workbench.verification.case import Case
from workbench.wet_deck_pressure import strain_impulse
from workbench.wet_deck_pressure.load_distribution import INCAT_061, SHAPES, SlamDistribution, nodal_forces
from workbench.wet_deck_pressure.slam_tables import TONNE_FORCE

SECTION_STIFFNESS = 1.37e7
"""EZ at gauge T1_5 [tonne m], as the impulses of table 4 imply; not printed."""

MODEL_LENGTH, SHIP_LENGTH = 2.5, 112.0
"""Of hull 064 and its model [m]; the model's from other work on it."""

PERCENT = (
    (
        "48",
        "difference of the approaches in the severest slam by the text",
        856.14,
        39.982,
        "48 % is 48.6 points of load over displacement, not a share of the load",
    ),
    (
        "45",
        "difference of the approaches in the severest slam by the conclusions",
        856.14,
        39.982,
        "45 % is the relative difference of the weakest slam",
    ),
    (
        "14",
        "difference of the approaches in the weakest slam",
        773.89,
        44.810,
        "14 % is 14.0 points of load over displacement, not a share of the load",
    ),
)


def cases() -> list[Case]:
    """Return the cases of this module."""
    return [*_table_3_cases(), *_conflict_cases(), *_impulse_cases(), *_distribution_cases()]


def _table_3_cases() -> list[Case]:
    made = []
    for row in published.rows("amin_table_3"):
        name = f"{row['approach']}-{float(row['instant']):.0f}"
        digits = len(row["load_over_displacement"].partition(".")[2])
        common = {"kind": "published", "source": published.citation("amin_table_3")}
        made += [
            Case(
                id=f"amin-ratio-{name}",
                title=f"Load over displacement, slam at {row['instant']} s, {row['approach']} strains",
                published=float(row["load_over_displacement"]),
                computed=lambda row=row: float(row["load_tonne"]) / amin_conflicts.DISPLACEMENT,
                tolerance=0.5 * 10.0**-digits + 1e-9,
                **common,
            ),
            Case(
                id=f"amin-location-{name}",
                title=f"Location of frame {row['frame']}, slam at {row['instant']} s, {row['approach']} strains",
                published=float(row["location_percent"]),
                computed=lambda row=row: (
                    100 * float(INCAT_061.share_of_length(INCAT_061.x(float(row["frame"]))))
                ),
                tolerance=0.051,
                unit="% LWL",
                **common,
            ),
        ]
    return made


def _conflict_cases() -> list[Case]:
    made = []
    for name, label, instant, figure, reason in PERCENT:
        number, tolerance, unit = published.value("amin_numbers", label)
        for way in ("of simultaneous", "of displacement"):
            own = way == "of simultaneous"
            if not own and name == "45":
                continue
            made.append(
                Case(
                    id=f"amin-{name}-percent-{way.removeprefix('of ')}",
                    title=f"{label.capitalize()}, {way.removeprefix('of ')} taken for 100 %",
                    kind="published",
                    source=published.citation("amin_numbers"),
                    published=number,
                    computed=lambda instant=instant, way=way: amin_conflicts.load_differences(instant)[way],
                    tolerance=tolerance if own else 0.7,
                    unit=unit,
                    miss=reason if own else "",
                    miss_figure=figure if own else None,
                    miss_band=0.01 if own else 0.0,
                )
            )
    reason = "the printed distances count from a point near frame 46, not from the gauge at frame 25"
    for column, words, miss in (
        ("gauge_distance", "from 0.3 m forward of frame 25", ""),
        ("printed_distance", "as printed", reason),
    ):
        made.append(
            Case(
                id=f"amin-stiffness-{column.split('_')[0]}",
                title=f"Section stiffness that table 4 implies, distances {words}: range over the mean",
                kind="published",
                source=published.citation("amin_table_4"),
                published=0.0,
                computed=lambda column=column: _scatter(amin_conflicts.section_stiffness(column)),
                tolerance=0.0036,
                note="one gauge has one section; tolerance: rounding of the printed integrals",
                miss=miss,
                miss_figure=0.2908 if miss else None,
                miss_band=0.001 if miss else 0.0,
            )
        )
    return made


def _scatter(values: np.ndarray) -> float:
    return float(np.ptp(values) / values.mean())


def _impulse_cases() -> list[Case]:
    made = []
    for row in published.rows("amin_table_4"):
        made.append(
            Case(
                id=f"amin-impulse-{float(row['instant']):.0f}",
                title=f"Impulse of the slam at {row['instant']} s from the strain of gauge T1_5",
                kind="published",
                source=published.citation("amin_table_4"),
                published=float(row["impulse_tonne_s"]),
                computed=lambda row=row: _impulse(
                    float(row["strain_integral"]), float(row["gauge_distance"])
                ),
                tolerance=0.0035 * float(row["impulse_tonne_s"]),
                unit="tonne s",
                note="repaired distance; section stiffness fitted, since it is not printed",
            )
        )
    rows = (
        (
            "half-sine",
            "strain integral of a half sine of 300 microstrain over 0.76 s",
            "second code",
            _half_sine,
        ),
        (
            "half-sine-impulse",
            "impulse of that half sine",
            "second code",
            lambda: _impulse(_half_sine(), 46.74),
        ),
        (
            "duration",
            "effective duration of the largest impulse",
            "published",
            lambda: strain_impulse.effective_duration(286 * TONNE_FORCE, 2241 * TONNE_FORCE),
        ),
        ("scaled", "impulse of the model at ship size", "published", _scaled),
        ("fifth", "aft over forward impulse", "published", lambda: _impulse(2.15e-4, 46.74) / 286),
    )
    for name, label, kind, computed in rows:
        number, tolerance, unit = published.value("amin_numbers", label)
        made.append(
            Case(
                id=f"amin-{name}",
                title=label.capitalize(),
                kind=kind,
                source=published.citation("amin_numbers"),
                published=number,
                computed=computed,
                tolerance=tolerance,
                unit=unit,
            )
        )
    return made


def _impulse(integral: float, lever: float) -> float:
    found = strain_impulse.strain_impulse(integral, SECTION_STIFFNESS * TONNE_FORCE, lever)
    return float(found.slam_impulse) / TONNE_FORCE


def _half_sine() -> float:
    time = np.arange(77) * 0.01
    return strain_impulse.strain_integral(300e-6 * np.sin(np.pi * time / 0.76), 0.01)


def _scaled() -> float:
    ratio = 20 * KNOT / 1.53
    return strain_impulse.scaled_impulse(5.0, ratio, SHIP_LENGTH / MODEL_LENGTH) / TONNE_FORCE


def _distribution_cases() -> list[Case]:
    source = "closed form of the volume and centroid of the load surface"
    made = []
    for shape, total, centre in (
        (SHAPES[0], 0.5 * (6 + 12) * 4 / 3 * 2, (6**2 / 6 - 12**2 / 6) / (0.5 * 18)),
        (SHAPES[1], 2 / 3 * 18 * 2, (6**2 / 4 - 12**2 / 4) / (2 / 3 * 18)),
    ):
        name = "linear" if shape == SHAPES[0] else "quadratic"
        for index, (label, known, unit) in enumerate(
            (("total", total, "m2"), ("resultant from peak", centre, "m"))
        ):
            made.append(
                Case(
                    id=f"amin-{name}-{label.split()[0]}",
                    title=f"Slam load {shape}, {label}",
                    kind="closed form",
                    source=source,
                    published=known,
                    computed=lambda shape=shape, index=index: _load_surface(shape)[index],
                    tolerance=1e-3 * abs(known),
                    unit=unit,
                )
            )
    return made


def _load_surface(shape: str) -> tuple[float, float]:
    """Total and resultant of a load 6 m forward, 12 m aft and 2 m to either side of one line of largest load."""
    load = SlamDistribution(x=20.0, fore_length=6.0, aft_length=12.0, y=0.0, half_width=2.0, shape=shape)
    step_x, step_y = 18.0 / 900, 4.0 / 200
    x, y = np.meshgrid(
        8.0 + step_x * (np.arange(900) + 0.5), -2.0 + step_y * (np.arange(200) + 0.5), indexing="ij"
    )
    found = nodal_forces(load, x.ravel(), y.ravel(), largest=step_x * step_y)
    return found.attrs["total"], found.attrs["resultant_x"] - 20.0
