import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.hydrostatics import hydrostatics
from workbench.geometry.lines import lines
from workbench.geometry.sections import sections
from workbench.shapes import HeavyLiftBox, RoundBilge, SemiSwath, SlenderRacing

MAIN = {"length": 50.0, "beam": 3.4, "draught": 2.0, "depth": 5.0}
ASKED = {"block_coefficient": 0.45, "lcb": -0.05, "transom_ratio": 0.3}
ROUND = {"deadrise_angle": math.radians(18), "entrance_angle": math.radians(5)}
SAMPLES = [
    RoundBilge(**MAIN, **ASKED, **ROUND),
    RoundBilge(**MAIN, **ASKED | {"transom_ratio": 0.0, "lcb": -0.01}, **ROUND),
    SemiSwath(**MAIN, **ASKED | {"block_coefficient": 0.52}),
    SlenderRacing(**MAIN, **ASKED | {"transom_ratio": 0.1}),
]


@settings(max_examples=60, deadline=None)
@given(
    kind=st.sampled_from([RoundBilge, SemiSwath, SlenderRacing]),
    slenderness=st.floats(9.0, 22.0),
    beam_draught=st.floats(1.0, 2.6),
    block=st.floats(0.38, 0.56),
    lcb=st.floats(-0.07, 0.0),
    transom=st.floats(0.0, 0.7),
)
def test_the_asked_form_is_met_or_refused_with_what_can_be_reached(
    kind, slenderness, beam_draught, block, lcb, transom
):
    beam = 50.0 / slenderness
    values = {
        "length": 50.0,
        "beam": beam,
        "draught": beam / beam_draught,
        "depth": 2.5 * beam / beam_draught,
        "block_coefficient": block,
        "lcb": lcb,
        "transom_ratio": transom,
    }
    if kind is RoundBilge:
        values |= {"deadrise_angle": 0.3, "entrance_angle": math.atan(1.3 / slenderness)}
    try:
        shape = kind(**values)
    except InputError as error:
        refusal = str(error)
    else:
        refusal = ""
    if refusal:
        assert "must be" in refusal
        assert " to " in refusal
        return
    floating = hydrostatics(Hull(shape=shape))
    volume = float(floating.volume)
    assert volume == pytest.approx(block * 50.0 * beam * beam / beam_draught, rel=5e-3)
    assert float(floating.centre_of_buoyancy[0]) / 50.0 == pytest.approx(lcb, abs=5e-3)


@pytest.mark.parametrize("shape", SAMPLES)
def test_main_dimensions_and_transom_are_those_asked_for(shape):
    (part,) = sections(Hull(shape=shape), 121, 81)
    assert part.x[-1] - part.x[0] == pytest.approx(50.0, rel=1e-3)
    assert part.draughts.max() == pytest.approx(2.0, rel=1e-3)
    widest = np.ptp(part.y, axis=1).max()
    assert widest == pytest.approx(3.4, rel=0.02)
    assert part.areas[0] / part.areas.max() == pytest.approx(shape.transom_ratio, abs=0.02)
    made = lines(shape)
    assert made.z.max() == pytest.approx(3.0)
    assert made.z.min() == pytest.approx(-2.0)


def test_the_waterline_enters_at_the_asked_angle():
    shape = SAMPLES[0]
    x = np.array([24.2, 24.6])
    (y, z) = lines(shape).contours(x)
    half = [np.interp(0.0, z[k], y[k]) for k in range(2)]
    assert math.atan((half[0] - half[1]) / 0.4) == pytest.approx(shape.entrance_angle, rel=0.05)


def test_the_keel_amidships_has_the_asked_deadrise():
    y, z = lines(SAMPLES[0]).contours([-2.0])
    slope = (z[0, 1] - z[0, 0]) / (y[0, 1] - y[0, 0])
    assert math.atan(slope) == pytest.approx(SAMPLES[0].deadrise_angle, abs=0.05)


@pytest.mark.parametrize("shape", SAMPLES)
def test_the_lines_are_fair(shape):
    """One rise and one fall of the section areas and of the waterline, and no second corner in the bilge."""
    (part,) = sections(Hull(shape=shape), 81, 61)
    for curve in (part.areas, part.beams):
        top = int(np.argmax(curve))
        assert (np.diff(curve[: top + 1]) > -1e-3 * curve.max()).all()
        assert (np.diff(curve[top:]) < 1e-3 * curve.max()).all()
        bend = np.diff(np.gradient(curve[5:-8], part.x[5:-8])) / curve.max()
        assert np.abs(bend).max() < 0.02


def test_a_semi_swath_is_fuller_below_its_fore_waterline():
    (part,) = sections(Hull(shape=SAMPLES[2]), 81, 61)
    fore = int(np.argmin(np.abs(part.x - 15.0)))
    assert np.ptp(part.y[fore]) > 1.1 * part.beams[fore]
    aft = int(np.argmin(np.abs(part.x + 20.0)))
    assert np.ptp(part.y[aft]) < 1.02 * part.beams[aft]


def test_the_ends_of_a_box_take_volume_from_bow_and_stern():
    box = HeavyLiftBox(**MAIN)
    bow = HeavyLiftBox(**MAIN, bow_length=10.0)
    stern = HeavyLiftBox(**MAIN, stern_length=10.0)
    block = 50.0 * 3.4 * 2.0
    assert float(hydrostatics(Hull(shape=box)).volume) == pytest.approx(block)
    # the mean of 1 - v**2.5 is 1 - 1/3.5; the mean rise of the keel is 0.8/2.8 of the draught
    lost_bow = 10.0 * 3.4 * 2.0 / 3.5
    lost_stern = 10.0 * 3.4 * 2.0 * 0.8 / 2.8
    assert block - float(hydrostatics(Hull(shape=bow)).volume) == pytest.approx(lost_bow, rel=0.02)
    assert block - float(hydrostatics(Hull(shape=stern)).volume) == pytest.approx(lost_stern, rel=0.02)
