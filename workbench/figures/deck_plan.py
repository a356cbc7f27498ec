"""Where on the wet deck: banded contours over its plan, bow to the right."""

import numpy as np
import xarray as xr
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from workbench.figures import style

BANDS = 10
_SHAPE = 0.15, 0.2  # height over width of the plan, so that it fits its frame
_THOUSANDS = {"Pa": ("kPa", 1e-3)}


def deck_plan_figure(
    values: xr.DataArray,
    deck: xr.Dataset,
    *,
    mark: tuple[float, float] | None = None,
    mark_label: str = "",
    line_at: float | None = None,
    line_label: str = "",
    nothing: str = "nothing to show",
    size: tuple[float, float] = style.WIDE,
) -> Figure:
    """Banded contours of a quantity over the plan of the deck.

    Parameters
    ----------
    values : (x, y), with ``units`` and ``long_name``; pressures are drawn in kPa.
    deck : from `workbench.geometry.wet_deck.wet_deck_grid`, on the same points.
    mark : (x, y) of a point to mark [m], with its label.
    line_at : value at which a dashed line is drawn, in the units of ``values``, with its label.
    nothing : sentence for a deck on which all values are 0.
    """
    attrs = dict(values.attrs)
    shown_unit, factor = _THOUSANDS.get(attrs.get("units", ""), (attrs.get("units", "1"), 1.0))
    attrs["units"] = shown_unit
    field = np.nan_to_num(values.transpose("x", "y").values) * factor
    edges_x, edges_y = _edges(deck.x.values), _edges(deck.y.values)
    x = np.concatenate([[edges_x[0]], deck.x.values, [edges_x[-1]]])
    y = np.concatenate([[edges_y[0]], deck.y.values, [edges_y[-1]]])
    padded = np.pad(field, 1, mode="edge")
    top = float(field.max())
    with style.drawing():
        figure = style.blank_figure(size)
        axes = style.single_axes(figure, left=0.72, right=1.05, top=0.36)
        levels = MaxNLocator(BANDS, min_n_ticks=5).tick_values(0.0, style.rounded_up(top))
        norm = BoundaryNorm(levels, 256)
        drawn = axes.contourf(
            x,
            y,
            padded.T,
            levels=levels,
            norm=norm,
            cmap=style.COLOUR_MAP,
            extend="max" if top > levels[-1] else "neither",
        )
        if top > levels[1]:
            axes.contour(x, y, padded.T, levels=levels[1:-1], colors="white", linewidths=0.4, alpha=0.6)
        if line_at is not None and field.min() < line_at * factor < top:
            axes.contour(
                x, y, padded.T, levels=[line_at * factor], colors="white", linewidths=2.2, linestyles="--"
            )
            if line_label:
                axes.plot([], [], color="#8b8b7a", linestyle="--", linewidth=2.2, label=line_label)
        if mark is not None and top > 0:
            axes.plot(
                *mark, marker="o", markersize=11, markerfacecolor="none", markeredgecolor="white",
                markeredgewidth=4, linestyle="", clip_on=False,
            )  # fmt: skip
            axes.plot(
                *mark, marker="o", markersize=11, markerfacecolor="none", markeredgecolor=style.WARM,
                markeredgewidth=2.2, linestyle="", clip_on=False, label=mark_label or None,
            )  # fmt: skip
        if top <= 0:
            axes.text(0.5, 0.5, nothing, transform=axes.transAxes, ha="center", va="center", color="white")
        axes.set_xlim(edges_x[0], edges_x[-1])
        axes.set_ylim(edges_y[0], edges_y[-1])
        ratio = (edges_y[-1] - edges_y[0]) / (edges_x[-1] - edges_x[0])
        axes.set_box_aspect(float(np.clip(ratio, *_SHAPE)))
        axes.set_anchor("SW")
        axes.set_xlabel("$x$, forward of amidships [m]  (bow to the right)")
        axes.set_ylabel("$y$, to port [m]")
        axes.spines[["top", "right"]].set_visible(True)
        bar = figure.colorbar(drawn, cax=axes.inset_axes((1.015, 0.0, 0.018, 1.0)))
        bar.set_ticks(levels[:: max(1, len(levels) // 5)])
        bar.outline.set_edgecolor(style.SOFT)
        unit = "" if shown_unit == "1" else f" [{shown_unit}]"
        bar.set_label(unit.strip())
        handles, _ = axes.get_legend_handles_labels()
        title = f"{attrs.get('long_name', values.name)}{unit}"
        axes.set_title(title[0].upper() + title[1:], loc="left")
        if handles:
            axes.legend(
                loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, borderaxespad=0.2, handletextpad=0.4,
                columnspacing=1.2, facecolor="white",
            )  # fmt: skip
    return figure


def _edges(centres: np.ndarray) -> np.ndarray:
    """Edges of equal cells from their centres."""
    step = centres[1] - centres[0] if len(centres) > 1 else 1.0
    return np.concatenate([centres - step / 2, [centres[-1] + step / 2]])
