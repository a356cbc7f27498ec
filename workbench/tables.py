"""Results as plain values and as text: what the command line prints and the tables that are written."""

from typing import Any

import numpy as np

from workbench import quantities
from workbench.conventions import KNOT, MODES, ROTATIONS, froude_number
from workbench.design import Design
from workbench.geometry.hydrostatics import equilibrium, hydrostatics, stiffness_matrix
from workbench.hydrodynamics.gap_resonance import gap_resonance
from workbench.motions import lead_over_wave
from workbench.pipeline import Response, Slamming
from workbench.time_domain import Realisation


def particulars(design: Design) -> dict[str, Any]:
    """Particulars, hydrostatics, stiffness about the origin and provenance of a design, in SI units."""
    afloat = hydrostatics(design.hull, design.density, design.masses.centre_of_gravity[2])
    values: dict[str, Any] = {
        "name": design.name,
        "title": design.title,
        "length": design.hull.length,
        "beam": design.hull.beam,
        "density": design.density,
        "masses": design.masses.as_dict(),
        "hull": design.hull.as_dict(),
        "wet_deck": design.wet_deck.as_dict() if design.wet_deck else None,
        "hydrostatics": {
            str(name): {"value": np.asarray(variable).tolist(), "units": variable.attrs["units"]}
            for name, variable in afloat.data_vars.items()
        },
        "hydrostatic_stiffness": stiffness_matrix(design.hull, design.masses, design.density).tolist(),
        "provenance": [
            dict(zip(("quantity", "value", "source", "standing"), entry, strict=True))
            for entry in design.provenance
        ],
        "warnings": list(equilibrium(design.hull, design.masses, design.density)),
    }
    if design.hull.count == 2:
        gap = design.hull.spacing - design.hull.shape.beam
        mean_draught = float(afloat.volume / afloat.waterplane_area)
        values["gap_resonance"] = gap_resonance(gap, design.hull.shape.beam, mean_draught)._asdict()
    for bulky in ("stations", "vertices", "faces"):
        if bulky in values["hull"].get("shape", {}):
            values["hull"]["shape"][bulky] = f"{len(values['hull']['shape'][bulky])} rows"
    return values


def particulars_text(values: dict[str, Any]) -> str:
    """`particulars` for reading."""
    lines = [f"{values['name']}: {values['title']}", ""]
    lines += [f"  {'length':<34} {values['length']:.6g} m", f"  {'beam over all':<34} {values['beam']:.6g} m"]
    for name, entry in values["hydrostatics"].items():
        value = entry["value"]
        shown = (
            f"{value:.6g}" if isinstance(value, float) else np.array2string(np.asarray(value), precision=4)
        )
        if np.ndim(value) < 2:
            lines.append(
                f"  {name.replace('_', ' '):<34} {shown} {entry['units'] if entry['units'] != '1' else ''}"
            )
    masses = values["masses"]
    lines.append(f"  {'mass':<34} {masses['mass']:.6g} kg")
    centre = ", ".join(f"{value:.4g}" for value in masses["centre_of_gravity"])
    lines.append(f"  {'centre of gravity x, y, z':<34} {centre} m")
    gyradii = ", ".join(f"{masses[f'{mode}_gyradius']:.4g}" for mode in ("roll", "pitch", "yaw"))
    lines.append(f"  {'gyradii roll, pitch, yaw':<34} {gyradii} m")
    if values["wet_deck"]:
        deck = values["wet_deck"]
        lines.append(f"  {'wet deck x':<34} {deck['aft']:.4g} to {deck['fore']:.4g} m")
        lines.append(f"  {'wet deck width, clearance':<34} {deck['width']:.4g}, {deck['clearance']:.4g} m")
    if "gap_resonance" in values:
        gap = values["gap_resonance"]
        shown = f"{gap['piston']:.3g} rad/s piston, {gap['sloshing']:.3g} rad/s sloshing"
        lines.append(f"  {'water between hulls resonates at':<34} {shown} (estimates)")
    if values["provenance"]:
        lines += ["", "  provenance"]
        for entry in values["provenance"]:
            lines.append(
                f"  [{entry['standing']:<9}] {entry['quantity']}: {entry['value']} ({entry['source']})"
            )
    return "\n".join(lines)


def motion_table(ship: Response, descending: bool = False) -> dict[str, Any]:
    """Motions at the first heading of a response: amplitudes and phases over frequency.

    Translations per wave amplitude [m/m], rotations [rad/m] with the amplitude per
    wave slope beside; phases in degrees of lead over the wave elevation at the
    centre of gravity; pitch positive bow down.

    Parameters
    ----------
    descending : list from the highest frequency to the lowest, so that wavelengths rise.
    """
    order = slice(None, None, -1) if descending else slice(None)
    one = ship.motions.isel(wave_direction=0, omega=order)
    lead = np.degrees(lead_over_wave(ship.motions).isel(wave_direction=0, omega=order))
    k = one.wavenumber.values
    values: dict[str, Any] = {
        "design": ship.design.name,
        "method": ship.motions.attrs["method"],
        "recommendation": ship.motions.attrs.get("recommendation", ""),
        "speed": ship.speed,
        "froude_number": float(froude_number(ship.speed, ship.design.hull.length)),
        "heading_degrees": float(np.degrees(one.wave_direction)),
        "omega": one.omega.values.tolist(),
        "encounter_frequency": one.encounter_frequency.values.tolist(),
        "wavelength_ratio": (2 * np.pi / k / ship.design.hull.length).tolist(),
    }
    for mode in MODES:
        amplitude = np.abs(one.motion_rao.sel(dof=mode).values)
        values[mode] = {
            "amplitude": amplitude.tolist(),
            "phase_degrees": lead.sel(dof=mode).values.tolist(),
        }
        if mode in ROTATIONS:
            values[mode]["amplitude_per_wave_slope"] = (amplitude / k).tolist()
    values["warnings"] = list(quantities.warnings_of(ship.motions))
    return values


def motion_text(values: dict[str, Any]) -> str:
    """`motion_table` for reading."""
    lines = [
        f"{values['design']}, {values['method']}, {values['speed'] / KNOT:.2f} kn (Fn {values['froude_number']:.3f}), "
        f"heading {values['heading_degrees']:.0f} degrees",
        "omega   omega_e  lambda/L " + "".join(f"{mode:>16}" for mode in MODES),
        "rad/s   rad/s    -        "
        + "".join(f"{'m/m, deg':>16}" for _ in range(3))
        + "".join(f"{'rad/m, deg':>16}" for _ in range(3)),
    ]
    for i, omega in enumerate(values["omega"]):
        cells = "".join(
            f"{values[mode]['amplitude'][i]:>10.4f}{values[mode]['phase_degrees'][i]:>6.0f}" for mode in MODES
        )
        lines.append(
            f"{omega:<8.4g}{values['encounter_frequency'][i]:<9.4g}{values['wavelength_ratio'][i]:<9.4g}{cells}"
        )
    return "\n".join(lines)


def slamming_table(ship: Response, slam: Slamming, counts, realisation: Realisation) -> dict[str, Any]:
    """Closed-form slamming over the deck, and the worst point with its counted rate, in SI units."""
    worst = slam.worst_point
    found, here, counted = slam.statistics, slam.statistics.isel(worst), counts.isel(worst)
    sea = slam.condition.sea_state
    return {
        "design": ship.design.name,
        "method": ship.motions.attrs["method"],
        "speed": ship.speed,
        "froude_number": found.attrs["froude_number"],
        "heading_degrees": float(np.degrees(slam.condition.wave_direction)),
        "significant_wave_height": sea.significant_wave_height,
        "peak_period": sea.peak_period,
        "spectrum": sea.spectrum,
        "clearance": slam.clearance,
        "threshold_velocity": slam.threshold,
        "criterion_per_hour": slam.criterion_per_hour,
        "hours": realisation.hours,
        "seed": int(realisation.seed),
        "lowest_omega": slam.moments.attrs["lowest_omega"],
        "highest_omega": slam.moments.attrs["highest_omega"],
        "x": found.x.values.tolist(),
        "y": found.y.values.tolist(),
        "height": slam.deck.height.values.tolist(),
        "slams_per_hour": found.slams_per_hour.values.tolist(),
        "slams_per_100_encounters": found.slams_per_100_encounters.values.tolist(),
        "relative_motion_std": slam.moments.relative_motion_std.values.tolist(),
        "relative_velocity_std": slam.moments.relative_velocity_std.values.tolist(),
        "most_probable_peak_pressure": found.most_probable_peak_pressure.values.tolist(),
        "worst_point": {
            "x": float(here.x),
            "y": float(here.y),
            "slams_per_hour": float(here.slams_per_hour),
            "counted_per_hour": float(counted.counted_per_hour),
            "counted_band": [float(counted.counted_band_low), float(counted.counted_band_high)],
            "mean_entry_velocity": float(here.mean_entry_velocity),
            "most_probable_peak_pressure": float(here.most_probable_peak_pressure),
        },
        "least_clearance": slam.least_clearance,
        "warnings": list(quantities.warnings_of(found)),
    }


def slamming_text(values: dict[str, Any]) -> str:
    """`slamming_table` for reading."""
    worst = values["worst_point"]
    low, high = worst["counted_band"]
    return "\n".join(
        [
            f"{values['design']}: {values['speed'] / KNOT:.2f} kn, heading {values['heading_degrees']:.0f} degrees, "
            f"Hs {values['significant_wave_height']:g} m, Tp {values['peak_period']:.3g} s, "
            f"clearance {values['clearance']:g} m",
            f"  worst point x {worst['x']:.3g} m, y {worst['y']:.3g} m",
            f"  slams per hour {worst['slams_per_hour']:.4g} (closed form), "
            f"{worst['counted_per_hour']:.4g} counted, 99 % band {low:.4g} to {high:.4g}",
            f"  mean entry velocity {worst['mean_entry_velocity']:.3g} m/s",
            f"  most probable peak pressure in {values['hours']:g} h "
            f"{worst['most_probable_peak_pressure'] / 1e3:.4g} kPa",
            f"  least clearance for {values['criterion_per_hour']:g} slams per hour {values['least_clearance']:.4g} m",
        ]
    )
