"""Fine transom-stern demihulls as closed mathematical surfaces.

The waterline, the keel line and the fullness of the sections are given along
the length; every section under water is one cubic of Bezier between keel and
waterline, tangent to the deadrise at the keel and to the flare at the
waterline. Two inner numbers remain: the *fullness* of the sections (0: straight
V, 1: fullest) and the *shift* of the whole form (-1: aft, 1: forward). They are
solved so that the block coefficient and the longitudinal centre of buoyancy
are the ones asked for.

Coordinates here are without dimension: lengths in hull lengths, breadths in
half beams, heights in draughts.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.optimize import root

from workbench.errors import InputError
from workbench.hulls.lines import Lines

BELOW, ABOVE = 25, 9
"""Points of a contour below and above the waterline."""

LEAST_UPPER = 0.3
"""Share of the way to the corner of the upper control point of the straightest section: keeps it round."""

ENTRANCE_RANGE = 0.5, 2.5
"""Slope of the waterline at the bow in half beams per length of the fore body, that gives a fair curve."""


@dataclass(frozen=True)
class FineForm:
    """What is asked of a form; ratios and angles only.

    Parameters
    ----------
    block_coefficient, lcb, transom_ratio : [-]; transom area over the largest section area.
    length_beam, beam_draught, depth_draught : ratios of the main dimensions [-].
    deadrise, entrance : at the keel amidships; half angle of the waterline at the bow [rad].
    bulb : breadth added below the waterline forward, in half beams [-].
    forefoot, overhang : lengths of the rounded forefoot and of the stem above water, in hull lengths.
    keel_rise : exponent of the rise of the keel towards the stern.
    """

    block_coefficient: float
    lcb: float
    transom_ratio: float
    length_beam: float
    beam_draught: float
    depth_draught: float
    deadrise: float
    entrance: float
    bulb: float = 0.0
    forefoot: float = 0.05
    overhang: float = 0.025
    keel_rise: float = 1.7


def fine_form_lines(form: FineForm, length: float, beam: float, draught: float) -> Lines:
    """Lines of the form with the asked block coefficient and centre of buoyancy [m]."""
    x, y, z = _surface(form, *inner_numbers(form))
    return Lines(x * length, y * beam / 2, z * draught)


@lru_cache(maxsize=256)
def inner_numbers(form: FineForm) -> tuple[float, float]:
    """Shift and fullness of the form, or `InputError` with the range that can be reached."""
    _check_entrance(form)

    def mismatch(inner: np.ndarray) -> list[float]:
        block, lcb = _block_and_lcb(form, *inner)
        return [10.0 * (block - form.block_coefficient), 30.0 * (lcb - form.lcb)]

    found = root(mismatch, [0.0, 0.5], tol=1e-6, options={"maxfev": 60})
    shift, fullness = found.x
    off = np.abs(mismatch(found.x))
    if off.max() > 2e-3 or not (-1.0 <= shift <= 1.0 and 0.0 <= fullness <= 1.0):
        _refuse(form)
    return float(shift), float(fullness)


def _check_entrance(form: FineForm) -> None:
    """Refuse an entrance angle that no fair waterline of this length and beam can have."""
    least, most = (np.degrees(np.arctan(slope / form.length_beam)) for slope in ENTRANCE_RANGE)
    angle = np.degrees(form.entrance)
    if not least <= angle <= most:
        raise InputError(
            f"entrance angle of a hull with length/beam {form.length_beam:.3g} must be {least:.3g} to "
            f"{most:.3g} degrees (half angle), got {angle:.3g}; change it or the beam."
        )


def _refuse(form: FineForm) -> None:
    """Raise `InputError` with the reachable block coefficients and centres of buoyancy."""
    fullness = np.linspace(0.0, 1.0, 9)
    table = np.array(
        [[_block_and_lcb(form, shift, full) for full in fullness] for shift in np.linspace(-1, 1, 9)]
    )
    least, most = table[..., 0].min(), table[..., 0].max()
    if not least <= form.block_coefficient <= most:
        raise InputError(
            f"block coefficient must be {least:.3f} to {most:.3f} for this family with the other values as "
            f"they are, got {form.block_coefficient:g}; change it, the deadrise or the transom ratio."
        )
    ends = [
        np.interp(form.block_coefficient, row[:, 0], row[:, 1])
        for row in table
        if row[:, 0].min() <= form.block_coefficient <= row[:, 0].max()
    ]
    raise InputError(
        f"longitudinal centre of buoyancy must be {min(ends):.3f} to {max(ends):.3f} lengths "
        f"from midships for this family with the other values as they are, got {form.lcb:g}; "
        "change it, the block coefficient or the transom ratio."
    )


def _block_and_lcb(form: FineForm, shift: float, fullness: float) -> tuple[float, float]:
    """Return block coefficient and centre of buoyancy over the length."""
    x = _stations(form)
    x = x[x <= 0.5]
    areas = _section_areas(*_wetted(form, x, shift, fullness)[:2])
    volume = np.trapezoid(areas, x)
    return float(volume / 2), float(np.trapezoid(areas * x, x) / volume)


def _section_areas(y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return areas of whole sections (stations,) [half beams x draughts] from half contours below water."""
    return np.sum((y[:, 1:] + y[:, :-1]) * np.diff(z, axis=1), axis=1)


def _stations(form: FineForm) -> np.ndarray:
    """Return stations from transom to stem head, close in the forefoot and at the foot of the stem."""
    foot = 0.5 - form.forefoot
    return np.concatenate(
        [
            np.linspace(-0.5, foot, 57)[:-1],
            foot + form.forefoot * np.sin(np.linspace(0.0, np.pi / 2, 13))[:-1],
            0.5 + form.overhang * np.linspace(0.0, 1.0, 9) ** 1.5,
        ]
    )


def _surface(form: FineForm, shift: float, fullness: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return x (n,), y and z (n, points) of the whole half surface."""
    x = _stations(form)
    y, z, half_breadth, flare = _wetted(form, np.minimum(x, 0.5), shift, fullness)
    freeboard = form.depth_draught - 1.0
    stem = freeboard * np.clip((x - 0.5) / form.overhang, 0.0, 1.0) ** 0.8
    share = np.linspace(0.0, 1.0, ABOVE)[1:]
    deck = _deck_edge(form, x, shift, half_breadth)
    rise = half_breadth[:, None] + flare[:, None] * share
    rise = rise + (deck - half_breadth - flare)[:, None] * share**2
    height = stem[:, None] + (freeboard - stem)[:, None] * share
    ahead = x >= 0.5
    z = np.where(ahead[:, None], stem[:, None], z)
    y = np.where(ahead[:, None], 0.0, y)
    return x, np.concatenate([y, rise], axis=1), np.concatenate([z, height], axis=1)


def _middle(shift: float) -> float:
    """Return the position of the largest waterline breadth."""
    return -0.04 + 0.08 * shift


def _waterline(form: FineForm, x: np.ndarray, shift: float) -> np.ndarray:
    """Return half-breadths of the waterline."""
    middle = _middle(shift)
    entrance = np.clip(2.0 * np.tan(form.entrance) * form.length_beam * (0.5 - middle), 0.3, 3.0)
    forward = np.clip((x - middle) / (0.5 - middle), 0.0, 1.0)
    aft = np.clip((middle - x) / (middle + 0.5), 0.0, 1.0)
    transom = np.clip(0.62 + 0.4 * form.transom_ratio - 0.1 * shift, 0.3, 0.97)
    return 1.0 + (entrance - 3.0) * forward**2 + (2.0 - entrance) * forward**3 - (1.0 - transom) * aft**2.2


def _keel(form: FineForm, x: np.ndarray, shift: float, transom_draught: float) -> np.ndarray:
    """Return depths of the keel below the waterline."""
    start = 0.0 + 0.22 * shift
    aft = np.clip((start - x) / (start + 0.5), 0.0, 1.0)
    foot = np.clip((x - 0.5 + form.forefoot) / form.forefoot, 0.0, 1.0)
    return (1.0 - (1.0 - transom_draught) * aft**form.keel_rise) * np.sqrt(1.0 - foot**2)


def _deck_edge(form: FineForm, x: np.ndarray, shift: float, half_breadth: np.ndarray) -> np.ndarray:
    """Return half-breadths of the deck edge, which ends at the stem head."""
    middle = _middle(shift)
    forward = np.clip((x - middle) / (0.5 + form.overhang - middle), 0.0, 1.0)
    aft = np.clip((middle - x) / (middle + 0.5), 0.0, 1.0)
    return np.maximum(1.03 * (1.0 - forward**2.4) - 0.06 * aft**2, half_breadth)


def _wetted(
    form: FineForm, x: np.ndarray, shift: float, fullness: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return y, z (n, BELOW) keel to waterline, half-breadths (n,) and flare over the freeboard (n,)."""
    half_breadth = _waterline(form, x, shift)
    flare = 0.5 * (_deck_edge(form, x, shift, half_breadth) - half_breadth)
    transom = _transom_draught(form, shift, fullness)
    depth = _keel(form, x, shift, transom)
    return (*_contours(form, x, half_breadth, depth, flare, shift, fullness), half_breadth, flare)


@lru_cache(maxsize=1024)
def _transom_draught(form: FineForm, shift: float, fullness: float) -> float:
    """Return the depth of the keel at the transom that gives the asked transom area."""
    depths = np.concatenate([[1e-3], np.linspace(0.03, 1.0, 16)])
    x = np.concatenate([np.full(depths.size, -0.5), [_middle(shift)]])
    half_breadth = _waterline(form, x, shift)
    flare = 0.5 * (_deck_edge(form, x, shift, half_breadth) - half_breadth)
    y, z = _contours(form, x, half_breadth, np.append(depths, 1.0), flare, shift, fullness)
    areas = _section_areas(y, z)
    return float(np.interp(form.transom_ratio * areas[-1], areas[:-1], depths))


def _contours(
    form: FineForm,
    x: np.ndarray,
    half_breadth: np.ndarray,
    depth: np.ndarray,
    flare: np.ndarray,
    shift: float,
    fullness: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Return contours y, z (n, BELOW) of cubics of Bezier from keel to waterline."""
    aspect = 2.0 / form.beam_draught  # a draught in half beams
    b, d = np.maximum(half_breadth, 1e-9), np.maximum(depth, 1e-9) * aspect
    chord = np.arctan2(d, b)
    bow = np.clip((x - _middle(shift)) / (0.5 - _middle(shift)), 0.0, 1.0)
    deadrise = form.deadrise + (np.radians(75.0) - form.deadrise) * bow**2
    deadrise = np.minimum(deadrise, 0.9 * chord)
    freeboard = (form.depth_draught - 1.0) * aspect
    lean = np.minimum(np.arctan(flare / freeboard), 0.8 * (np.pi / 2 - chord))
    # the corner where the tangents at the keel and at the waterline meet
    slope = np.tan(deadrise)
    corner_z = (b * slope - d) / (1.0 - slope * np.tan(lean))
    corner_y = b + corner_z * np.tan(lean)
    full = np.clip(fullness, 0.0, 1.0) * (1.0 - 0.55 * bow**1.5)
    zero = np.zeros_like(b)
    keel, edge = np.stack([zero, -d], axis=-1), np.stack([b, zero], axis=-1)
    corner = np.stack([corner_y, corner_z], axis=-1)
    upper = LEAST_UPPER + (1.0 - LEAST_UPPER) * full
    controls = keel, keel + full[:, None] * (corner - keel), edge + upper[:, None] * (corner - edge), edge
    s = np.linspace(0.0, 1.0, BELOW)
    weights = (1 - s) ** 3, 3 * s * (1 - s) ** 2, 3 * s**2 * (1 - s), s**3
    points = sum(w[None, :, None] * control[:, None, :] for w, control in zip(weights, controls, strict=True))
    y, z = points[..., 0], points[..., 1] / aspect
    if form.bulb > 0.0:
        below = np.clip(-z / np.maximum(depth, 1e-9)[:, None], 0.0, 1.0)
        y = y + _bulb(form, x)[:, None] * 6.75 * below**2 * (1.0 - below)
    return y, z


def _bulb(form: FineForm, x: np.ndarray) -> np.ndarray:
    """Return the breadth added below water, from abaft midships to a round nose."""
    rise = np.clip((x + 0.35) / 0.6, 0.0, 1.0)
    nose = np.clip((x - 0.25) / 0.25, 0.0, 1.0)
    return form.bulb * rise**2 * (3 - 2 * rise) * np.sqrt(1.0 - nose**2)
