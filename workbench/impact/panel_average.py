"""Pressure averaged over a panel and over time, and the largest of it: what a structure feels.

The peak of an impact is too short and too local to load a panel; its average over the panel and over a duration
near the natural period of the structure is the realistic load ([Grande2002]_ 6.2).

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, chapters 6 and 7.
"""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.errors import InputError, checked_number
from workbench.impact.entry import METHODS, entry
from workbench.impact.nonlinear_start import first_penetration
from workbench.impact.section import Section

INSTANTS = 80
WETTED_BEYOND = 2.0
"""The panel is followed until the wetted half-breadth by Wagner's theory is so many times its outer edge."""


def time_averages(found: xr.Dataset, duration: float) -> xr.Dataset:
    """Average the panel pressures of an entry over a duration before each instant.

    Parameters
    ----------
    found : of `workbench.impact.entry.entry`, with panels.
    duration : of the average [s], above 0.

    Returns
    -------
    ``panel_mean`` (time, panel), the moving mean [Pa]; ``panel_largest`` (panel), its largest value [Pa].

    Notes
    -----
    Pressure varies linearly between instants and is zero until first contact at time 0; the
    instants must be close beside the duration and the rise of the pressure.
    """
    checked_number("duration of the average", duration, "s", above=0)
    if "panel_pressure" not in found:
        raise InputError("The entry has no panel pressures to average; give it panels.")
    times = np.concatenate([[0.0], found["time"].to_numpy()])
    pressure = found["panel_pressure"].to_numpy()
    mean = np.column_stack([moving_mean(times, np.append(0.0, row), duration)[1:] for row in pressure.T])
    return quantities.dataset(
        {"time": found["time"], "panel": found["panel"]},
        method=found.attrs["method"],
        warnings=quantities.warnings_of(found),
        panel_mean=(("time", "panel"), mean),
        panel_largest=("panel", mean.max(axis=0)),
    )


def moving_mean(times: np.ndarray, values: np.ndarray, duration: float) -> np.ndarray:
    """Mean of a history over a duration before each time; linear between the times, zero before the first.

    Parameters
    ----------
    times : growing [s]; values : (time,); duration : [s].
    """
    running = np.concatenate([[0.0], np.cumsum(np.diff(times) * (values[1:] + values[:-1]) / 2)])
    begin = np.maximum(times - duration, times[0])
    cell = np.clip(np.searchsorted(times, begin, side="right") - 1, 0, len(times) - 2)
    into = begin - times[cell]
    slope = (values[cell + 1] - values[cell]) / (times[cell + 1] - times[cell])
    return (running - running[cell] - into * (values[cell] + slope * into / 2)) / duration


def panel_history(
    section: Section,
    panel: tuple[float, float],
    method: str = "generalised-wagner",
    velocity: float = 1.0,
    density: float = 1.0,
    beyond: float = WETTED_BEYOND,
) -> xr.Dataset:
    """Return the entry at constant velocity while a panel gets wet, for the average pressure over it.

    Parameters
    ----------
    section, method : as for `workbench.impact.entry.entry`; a method with a distribution.
    panel : inner and outer half-breadth [m].
    velocity : downwards [m/s]; density : of the water [kg/m3].
    beyond : wetted half-breadth at the end by Wagner's theory, over the outer edge; the section may end before.
    """
    inner, outer = panel
    checked_number("outer edge of the panel", outer, "m", above=inner, at_most=section.reach)
    checked_number("wetted half-breadth over the outer edge", beyond, at_least=1)
    last = section.mean_height(min(beyond * outer, section.reach * 0.9 if outer < section.reach else outer))
    first = max(section.mean_height(inner), last / INSTANTS)
    if method == "nonlinear":
        first = max(first, first_penetration(section))
    depths = np.linspace(first, last, INSTANTS)
    return entry(section, velocity, method, density, depths / velocity, [panel])


def panel_coefficient(
    section: Section,
    panel: tuple[float, float],
    method: str = "generalised-wagner",
    beyond: float = WETTED_BEYOND,
) -> float:
    """Largest average pressure over a panel over rho V**2/2, as the panel gets wet at constant velocity: its k [-].

    Parameters
    ----------
    section, panel, method, beyond : as for `panel_history`.

    Notes
    -----
    k of [Grande2002]_ tables 7.1-7.3, without average over time. Where the largest pressure is at
    the apex (wedges above about 42 degrees), the average over a panel there
    grows to that of the apex as the water goes on; k then depends on ``beyond``.
    """
    if method not in METHODS or method == "chuang":
        raise InputError(f"k of a panel needs a method with a distribution of pressure, got {method!r}.")
    found = panel_history(section, panel, method, beyond=beyond)
    return float(found["panel_pressure"].max() / 0.5)
