"""What the ship looks like: body plan, profile and plan, with the wet deck."""

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from workbench.figures import style
from workbench.geometry.sections import HullSections

STATIONS_DRAWN = 11
_SKIN = "#c9d6de"


def body_plan_figure(sections: HullSections) -> Figure:
    """Wetted sections of one hull about its own centre plane: fore half right, aft half left."""
    aft, fore = sections.x[0], sections.x[-1]
    middle = (aft + fore) / 2
    with style.drawing():
        figure = style.blank_figure()
        axes = style.single_axes(figure)
        for wanted in np.linspace(aft, fore, STATIONS_DRAWN + 2)[1:-1]:
            row = int(np.argmin(np.abs(sections.x - wanted)))
            half = sections.y.shape[1] // 2
            ahead = sections.x[row] >= middle
            side = slice(half, None) if ahead else slice(None, half + 1)
            axes.plot(
                sections.y[row, side] - sections.position[1], sections.z[row, side],
                color=style.ACCENT if ahead else style.WARM, linestyle="-" if ahead else "--", linewidth=1.3,
            )  # fmt: skip
        axes.plot([], [], color=style.WARM, linestyle="--", label="aft half")
        axes.plot([], [], color=style.ACCENT, linestyle="-", label="fore half")
        axes.axhline(0, color=style.SOFT, linewidth=1)
        axes.axvline(0, color=style.SOFT, linewidth=0.6)
        axes.set_aspect("equal", adjustable="datalim")
        axes.set_xlabel("distance from the hull's centre plane [m]")
        axes.set_ylabel("height above still water [m]")
        axes.legend(loc="lower right")
        style.grid_behind(axes)
    return figure


def arrangement_figure(
    vertices: np.ndarray, faces: np.ndarray, deck: xr.Dataset | None, centre_of_gravity: Sequence[float]
) -> Figure:
    """Profile above, plan below, of the hulls and the wet deck, to one scale.

    Parameters
    ----------
    vertices, faces : from `workbench.geometry.sections.surface`.
    deck : from `workbench.geometry.wet_deck.wet_deck_grid`, or None.
    centre_of_gravity : (x, y, z) [m].
    """
    corners = vertices[faces]
    length = np.ptp(vertices[:, 0])
    margin = 0.02 * length
    ends = vertices[:, 0].min() - margin, vertices[:, 0].max() + margin
    heights = [vertices[:, 2].min(), vertices[:, 2].max(), centre_of_gravity[2]]
    if deck is not None:
        heights += [float(deck.height.min()), float(deck.height.max())]
    upright = min(heights) - margin, max(heights) + margin
    beam = np.abs(vertices[:, 1]).max() + margin
    with style.drawing():
        figure, profile, plan = _to_scale(ends, upright, (-beam, beam))
        for axes, pair in ((profile, (0, 2)), (plan, (0, 1))):
            skin = PolyCollection(corners[..., pair], facecolor=_SKIN, edgecolor=_SKIN, linewidth=0.4)
            axes.add_collection(skin)
        profile.axhline(0, color=style.ACCENT, linewidth=1.4, label="still water")
        if deck is not None:
            _draw_deck(profile, plan, deck, 0.004 * length)
        x_g, y_g, z_g = centre_of_gravity
        for axes, at in ((profile, z_g), (plan, y_g)):
            axes.plot(
                x_g, at, marker="P", color=style.INK, linestyle="", markersize=8, label="centre of gravity"
            )
            style.grid_behind(axes)
        profile.set_ylabel("$z$ [m]")
        plan.set_ylabel("$y$, to port [m]")
        plan.set_xlabel("$x$, forward of amidships [m]  (bow to the right)")
        profile.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, borderaxespad=0.1)
    return figure


def _to_scale(ends, upright, across):
    """Return a figure with axes for profile and plan in which a metre is as long in all directions."""
    left, right, top, between, bottom = 0.78, 0.16, 0.36, 0.36, 0.56
    wide = style.WIDE[0] - left - right
    scale = wide / (ends[1] - ends[0])
    high, deep = scale * (upright[1] - upright[0]), scale * (across[1] - across[0])
    height = top + high + between + deep + bottom
    figure = style.blank_figure((style.WIDE[0], height))
    plan = figure.add_axes((left / style.WIDE[0], bottom / height, wide / style.WIDE[0], deep / height))
    profile = figure.add_axes(
        (left / style.WIDE[0], (bottom + deep + between) / height, wide / style.WIDE[0], high / height)
    )
    for axes, limits in ((profile, upright), (plan, across)):
        axes.set_xlim(*ends)
        axes.set_ylim(*limits)
        axes.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
    profile.tick_params(labelbottom=False)
    return figure, profile, plan


def _draw_deck(profile, plan, deck: xr.Dataset, thickness: float) -> None:
    """Draw the deck's side view and outline."""
    x, y, height = deck.x.values, deck.y.values, deck.height.values
    profile.fill_between(
        x, height.min(axis=1), height.max(axis=1) + thickness, color=style.WARM, label="wet deck"
    )
    step_x, step_y = x[1] - x[0], y[1] - y[0]
    left, right, half = x[0] - step_x / 2, x[-1] + step_x / 2, y[-1] + step_y / 2
    outline = [left, right, right, left, left], [-half, -half, half, half, -half]
    plan.fill(*outline, color=style.WARM, alpha=0.25, linewidth=0)
    plan.plot(*outline, color=style.WARM, linewidth=1.2)
