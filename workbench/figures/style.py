"""What all figures share: sizes, type, colours, and how a figure becomes a picture file.

Sizes are in inches of 96 screen pixels. Type is 11 points, so that a figure
shown a little smaller than made still has 10 points.
"""

import io
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

NORMAL = (4.8, 3.3)
WIDE = (9.7, 2.5)
PICTURE_DPI = 150

INK, SOFT, ACCENT, WARM = "#1d2b35", "#55666f", "#0b6393", "#b5482a"
LINES = (
    {"color": "#0b6393", "linestyle": "-", "marker": "o"},
    {"color": "#b5482a", "linestyle": "--", "marker": "s"},
    {"color": "#5b7a1e", "linestyle": "-.", "marker": "^"},
    {"color": "#6b4a8e", "linestyle": ":", "marker": "D"},
)
"""Lines told apart by dash and marker as well as by colour."""

COLOUR_MAP = "cividis"

STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 11,
    "axes.titlesize": 11,
    "axes.labelsize": 11,
    "xtick.labelsize": 11,
    "ytick.labelsize": 11,
    "legend.fontsize": 10.5,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": SOFT,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.8,
    "grid.color": "#dde4e8",
    "grid.linewidth": 0.8,
    "lines.linewidth": 1.8,
    "lines.markersize": 5,
    "legend.frameon": False,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "svg.fonttype": "path",
    "svg.hashsalt": "workbench",
    "mathtext.fontset": "dejavusans",
}


_ONE_AT_A_TIME = threading.RLock()


@contextmanager
def drawing() -> Iterator[None]:
    """Style for drawing; one thread at a time, since matplotlib's settings belong to the process."""
    with _ONE_AT_A_TIME, mpl.rc_context(STYLE):
        yield


def blank_figure(size: tuple[float, float] = NORMAL) -> Figure:
    """Empty figure with the canvas that paints it."""
    figure = Figure(figsize=size)
    FigureCanvasAgg(figure)
    return figure


def single_axes(
    figure: Figure, *, left: float = 0.78, right: float = 0.16, top: float = 0.28, bottom: float = 0.56
) -> Axes:
    """Axes that fill the figure but for margins in inches (some times faster than a layout engine)."""
    width, height = figure.get_size_inches()
    box = (left / width, bottom / height, (width - left - right) / width, (height - top - bottom) / height)
    return figure.add_axes(box)


def message_figure(sentence: str, size: tuple[float, float] = NORMAL) -> Figure:
    """Figure that says why there is nothing to draw."""
    with drawing():
        figure = blank_figure(size)
        figure.text(0.5, 0.5, sentence, ha="center", va="center", color=SOFT, wrap=True)
    return figure


def picture(figure: Figure, kind: str = "png") -> bytes:
    """Bytes of the figure as "png" or "svg"."""
    stream = io.BytesIO()
    options: dict = (
        {"metadata": {"Date": None}}
        if kind == "svg"
        else {
            "dpi": PICTURE_DPI,
            "pil_kwargs": {"compress_level": 1},
        }
    )
    with drawing():
        figure.savefig(stream, format=kind, **options)
    return stream.getvalue()


def rounded_up(value: float) -> float:
    """Least of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten that is not below the value."""
    if not np.isfinite(value) or value <= 0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    steps = np.array([1, 1.5, 2, 3, 4, 5, 6, 8, 10])
    return float(steps[np.argmax(steps * power >= value * (1 - 1e-9))] * power)


def number_words(value: float, digits: int = 3) -> str:
    """Number to some significant digits, without an exponent where it can be read without."""
    value = float(value)
    if not np.isfinite(value) or value == 0 or not 1e-4 <= abs(value) < 1e6:
        return f"{value:.{digits}g}"
    rounded = float(f"{value:.{digits}g}")
    decimals = max(0, digits - 1 - int(np.floor(np.log10(abs(rounded)))))
    return f"{rounded:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{rounded:.0f}"


def grid_behind(axes: Axes | Sequence[Axes]) -> None:
    """Light grid behind the lines."""
    for each in np.atleast_1d(np.asarray(axes, dtype=object)).ravel():
        each.grid(visible=True)
        each.set_axisbelow(True)
