import dataclasses
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.errors import InputError
from workbench.shapes import (
    SHAPES,
    HeavyLiftBox,
    Offsets,
    PanelMesh,
    RoundBilge,
    SemiSwath,
    SlenderRacing,
    Wigley,
    shape_from_dict,
)

MAIN = {"length": 40.0, "beam": 2.6, "draught": 1.6, "depth": 4.0}
FINE = {**MAIN, "block_coefficient": 0.45, "lcb": -0.045, "transom_ratio": 0.4}
ROUND = {**FINE, "deadrise_angle": math.radians(20), "entrance_angle": math.radians(4.5)}


def section(x, half_breadth, keel=0.0):
    return x, ((keel, 0.0), (keel + 0.5, 0.8 * half_breadth), (1.5, half_breadth), (2.0, half_breadth))


STATIONS = (
    *(section(x, b) for x, b in ((-10, 0.8), (-5, 1.0), (0, 1.0), (5, 0.7), (9, 0.2))),
    (10.0, ((2.0, 0.0),)),
)


def box_mesh(flip=False, lift=0.0, drop=None):
    x, y, z = 5.0, 0.5, 1.0
    vertices = [(sx * x, sy * y, sz) for sx in (-1, 1) for sy in (-1, 1) for sz in (-z + lift, z + lift)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [f for k, f in enumerate(faces) if k != drop]
    return {"vertices": vertices, "faces": [f[::-1] for f in faces] if flip else faces, "length": 10.0}


SAMPLES = (
    Wigley(**MAIN),
    RoundBilge(**ROUND),
    SemiSwath(**FINE | {"block_coefficient": 0.5, "lcb": -0.05}),
    SlenderRacing(**FINE | {"lcb": -0.06}),
    HeavyLiftBox(**MAIN, bilge_radius=0.3, bow_length=6.0, stern_length=5.0),
    Offsets(stations=STATIONS, draught=1.5, length=20.0),
    PanelMesh(**box_mesh()),
)


def test_every_kind_of_shape_is_sampled_here():
    assert {shape.kind for shape in SAMPLES} == set(SHAPES)


@pytest.mark.parametrize("shape", SAMPLES, ids=lambda shape: shape.kind)
def test_a_shape_is_hashable_and_comes_back_from_its_dictionary(shape):
    again = shape_from_dict(shape.as_dict())
    assert again == shape
    assert hash(again) == hash(shape)


@pytest.mark.parametrize("shape", SAMPLES, ids=lambda shape: shape.kind)
def test_scaling_scales_every_length_and_back_again(shape):
    half = shape.scaled(0.5)
    for name in ("length", "beam", "draught", "depth"):
        assert getattr(half, name) == pytest.approx(getattr(shape, name) / 2)
    assert half.scaled(2.0) == shape


@pytest.mark.parametrize("name", ["length", "beam", "draught", "depth"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf, 1e9, "4", None, True, [4.0]])
def test_main_dimensions_that_cannot_be_are_refused_by_name(name, value):
    with pytest.raises(InputError, match=f"hull {name} must be a .*number >= "):
        Wigley(**MAIN | {name: value})


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"draught": 4.0}, "draught must be less than the depth"),
        ({"beam": 41.0}, "beam of one hull must be less than its length"),
        ({"block_coefficient": 0.8}, r"block coefficient must be 0\.\d+ to 0\.\d+ for this family"),
        ({"block_coefficient": 0.25}, r"block coefficient must be 0\.\d+ to 0\.\d+ for this family"),
        ({"lcb": 0.10}, r"centre of buoyancy must be -0\.\d+ to -?0\.\d+ lengths"),
        ({"lcb": math.nan}, "longitudinal centre of buoyancy must be a finite number"),
        ({"transom_ratio": 1.2}, "transom ratio must be"),
        ({"deadrise_angle": 20.0}, "deadrise angle must be .* rad"),
        ({"entrance_angle": math.radians(30)}, r"entrance angle .* must be .* to .* degrees"),
        ({"entrance_angle": math.radians(0.1)}, r"entrance angle .* must be .* to .* degrees"),
    ],
)
def test_values_outside_a_family_are_refused_with_what_is_allowed(changes, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        RoundBilge(**ROUND | changes)
    assert "\n" not in str(caught.value)


def test_the_range_named_in_a_refusal_can_be_reached():
    with pytest.raises(InputError) as caught:
        RoundBilge(**ROUND | {"block_coefficient": 0.8})
    words = str(caught.value).split()
    most = float(words[words.index("to") + 1])
    RoundBilge(**ROUND | {"block_coefficient": most - 0.02, "lcb": -0.06})


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"bilge_radius": 1.7}, "bilge radius must be"),
        ({"bow_length": 30.0}, "bow length must be"),
        ({"stern_length": -1.0}, "stern length must be"),
    ],
)
def test_impossible_boxes_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence):
        HeavyLiftBox(**MAIN | changes)


@pytest.mark.parametrize(
    ("stations", "sentence"),
    [
        ((), "got an empty table"),
        ("some text", "offsets must be stations"),
        (STATIONS[:3], "at least 5 stations"),
        (STATIONS[::-1], "sorted from aft to forward"),
        (STATIONS[:1] + STATIONS, "got x = -10 m twice"),
        (
            (*STATIONS[:4], (9.0, ((0.0, 0.0), (0.5, -0.2), (1.5, 0.2), (2.0, 0.3))), STATIONS[5]),
            "half-breadth",
        ),
        (
            (*STATIONS[:4], (9.0, ((0.0, 0.0), (1.5, 0.2), (0.5, 0.2), (2.0, 0.3))), STATIONS[5]),
            "keel upwards",
        ),
        ((*STATIONS[:4], (9.0, ((0.0, 0.0), (0.5, 0.2), (0.5, 0.2), (2.0, 0.3))), STATIONS[5]), "twice"),
        ((*STATIONS[:4], (9.0, ((0.0, 0.0), (0.5, 0.2), (1.2, 0.2))), STATIONS[5]), "above the waterline"),
        ((*STATIONS[:4], (9.0, ((0.0, 0.0), (2.0, 0.2))), STATIONS[5]), "at least 3 points"),
        ((*STATIONS[:4], (9.0, ()), STATIONS[5]), "must have points"),
        ((*STATIONS[:5], (10.0, ((2.0, 0.1),))), "one point with half-breadth 0"),
        ((*STATIONS[:4], (9.0, ((0.0, 0.0), (0.5, math.nan), (2.0, 0.2))), STATIONS[5]), "finite number"),
        ((*STATIONS[:4], (9.0, ((0.0, 0.0), (0.5, "a"), (2.0, 0.2))), STATIONS[5]), "must be a number"),
        (tuple((x / 3, points) for x, points in STATIONS), "span 0.8 to 1.5 times the hull length"),
        (tuple((x, tuple((z + 5, y) for z, y in p)) for x, p in STATIONS), "does not reach the water"),
    ],
)
def test_offsets_that_make_no_hull_are_refused_in_one_sentence(stations, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        Offsets(stations=stations, draught=1.5, length=20.0)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("mesh", "sentence"),
    [
        (box_mesh(flip=True), "normals of the panel mesh must point into the water"),
        (box_mesh(lift=5.0), "must reach below still water"),
        (box_mesh(drop=4), "must be closed below the waterline"),
        (box_mesh() | {"faces": []}, "faces of the panel mesh"),
        (box_mesh() | {"vertices": []}, "vertices of the panel mesh"),
        (box_mesh() | {"vertices": [(math.nan, 0, 0)] * 8}, "NaN"),
        (box_mesh() | {"faces": [(0, 1, 99)]}, "vertex numbers"),
        (box_mesh() | {"faces": [*box_mesh()["faces"], (0, 0, 1, 1)]}, "without area"),
        (box_mesh() | {"faces": [(0, 2, 3, 1), *box_mesh()["faces"][1:]]}, "same way round"),
        (box_mesh() | {"length": 100.0}, "as long as the hull length"),
    ],
)
def test_meshes_that_make_no_hull_are_refused_in_one_sentence(mesh, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        PanelMesh(**mesh)
    assert "\n" not in str(caught.value)


def test_a_mesh_may_be_open_at_the_waterline_and_above():
    assert PanelMesh(**box_mesh(drop=5)).beam == pytest.approx(1.0)


def test_an_unknown_kind_is_refused_with_the_known_ones():
    with pytest.raises(InputError, match=r"kind of hull shape must be one of wigley, .*, got 'boat'"):
        shape_from_dict({"kind": "boat"})
    with pytest.raises(InputError, match="must have a kind"):
        shape_from_dict({"length": 3.0})


def test_fields_are_frozen_and_by_keyword_only():
    with pytest.raises(dataclasses.FrozenInstanceError):
        SAMPLES[0].length = 3.0
    with pytest.raises(TypeError):
        Wigley(40.0, 2.6, 1.6, 4.0)


@settings(max_examples=40, deadline=None)
@given(
    length=st.floats(1.0, 150.0),
    slenderness=st.floats(6.0, 30.0),
    beam_draught=st.floats(0.8, 3.0),
    factor=st.floats(0.2, 3.0),
)
def test_a_wigley_hull_of_any_size_scales(length, slenderness, beam_draught, factor):
    beam = length / slenderness
    hull = Wigley(length=length, beam=beam, draught=beam / beam_draught, depth=2 * beam / beam_draught)
    assert hull.scaled(factor).beam == pytest.approx(beam * factor)
