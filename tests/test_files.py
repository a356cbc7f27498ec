import dataclasses
import math
import os
import stat

import meshio
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.design import Design, Fin, Foil, Hull, MassProperties, WetDeck
from workbench.errors import InputError
from workbench.files import design_from_toml, design_to_toml, save_design
from workbench.geometry.hydrostatics import hydrostatics
from workbench.hulls import library
from workbench.hulls.mesh_files import mesh_from_file
from workbench.shapes import PanelMesh, Wigley

PLAIN = """
name = "twin"
[hull]
count = 2
spacing = 10.0
[hull.shape]
kind = "wigley"
length = 40.0
beam = 4.0
draught = 2.0
depth = 5.0
[masses]
mass = 3e5
centre_of_gravity = [0.0, 0.0, 1.0]
roll_gyradius = 4.0
pitch_gyradius = 10.0
yaw_gyradius = 10.5
"""
BOX_FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
BOX_POINTS = [(x, y, z) for x in (-5.0, 5.0) for y in (-0.5, 0.5) for z in (-1.0, 1.0)]


@pytest.mark.parametrize("name", library.names())
def test_every_design_of_the_library_comes_back_equal_from_its_text(name):
    design = library.design(name)
    assert design_from_toml(design_to_toml(design)) == design


@settings(max_examples=50, deadline=None)
@given(
    length=st.floats(5.0, 300.0),
    ratio=st.floats(7.0, 25.0),
    heel=st.floats(-0.3, 0.3),
    clearance=st.floats(0.5, 10.0),
    density=st.floats(950.0, 1100.0),
    title=st.text(max_size=30),
    centre=st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(-5.0, 5.0)),
)
def test_any_design_comes_back_equal_from_its_text(length, ratio, heel, clearance, density, title, centre):
    beam = length / ratio
    design = Design(
        name="any",
        title=title,
        hull=Hull(
            shape=Wigley(length=length, beam=beam, draught=beam / 2, depth=2 * beam),
            count=2,
            spacing=3 * beam,
            heel=heel,
        ),
        wet_deck=WetDeck(aft=-length / 3, fore=length / 3, width=2 * beam, clearance=clearance),
        masses=MassProperties(
            mass=length**3, centre_of_gravity=centre, roll_gyradius=beam, pitch_gyradius=length / 4,
            yaw_gyradius=length / 4,
        ),
        density=density,
        provenance=(("mass", "1 kg", title, "ours"),),
    )  # fmt: skip
    assert design_from_toml(design_to_toml(design)) == design


def test_a_file_is_read_by_its_path(tmp_path):
    path = tmp_path / "twin.toml"
    path.write_text(PLAIN)
    assert design_from_toml(path) == design_from_toml(str(path)) == design_from_toml(PLAIN)
    assert design_from_toml(PLAIN).density == 1025.0


def test_angles_may_be_given_in_degrees():
    made = design_from_toml(PLAIN.replace("count = 2", "count = 2\nheel_degrees = 3.0"))
    assert made.hull.heel == pytest.approx(math.radians(3.0))


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            "spacing =",
            "spacin =",
            r"key of \[hull\] must be one that is known, got 'spacin'; the nearest is 'spacing'",
        ),
        ("mass =", "weight =", r"key of \[masses\] .* got 'weight'"),
        ("[masses]", "[mass]", "the nearest is 'masses'"),
        ('name = "twin"', "", "name must be given in the design"),
        ("mass = 3e5", "", r"mass must be given in \[masses\]"),
        ("beam = 4.0", "", r"beam must be given in \[hull.shape\]"),
        ("beam = 4.0", "beam = nan", "hull beam must be a finite number"),
        ("beam = 4.0", "beam = inf", "hull beam must be a finite number"),
        ("beam = 4.0", 'beam = "4.0"', "hull beam must be a number"),
        ("beam = 4.0", "beam = true", "hull beam must be a number"),
        ("beam = 4.0", "beam = [4.0]", "hull beam must be a number"),
        ("beam = 4.0", "beam = 4.0.0", "must be valid TOML"),
        ("beam = 4.0", "beam = 4.0\nbeam = 5.0", "must be valid TOML"),
        ('kind = "wigley"', 'kind = "boat"', r"kind of \[hull.shape\] must be one of wigley"),
        ('kind = "wigley"', "", r"kind must be given in \[hull.shape\]"),
        ("count = 2", "count = 2.5", "count of hulls must be 1, 2 or 3"),
        ("count = 2", "count = 2\nheel = 0.1\nheel_degrees = 3", "heel of .* must be given once"),
        ("count = 2", "count = 2\nspacing_degrees = 3", "got 'spacing_degrees'"),
        ("count = 2", 'count = 2\nheel_degrees = "3"', "heel must be a number"),
        ("[0.0, 0.0, 1.0]", "[0.0, 1.0]", "must be three numbers"),
        ('name = "twin"', 'name = "twin"\nwet_deck = 3', r"\[wet_deck\] must be a table"),
        ('name = "twin"', 'name = "twin"\nprovenance = "mine"', "provenance must be"),
        ('name = "twin"', 'name = "twin"\nprovenance = ["mine"]', r"\[\[provenance\]\] must be a table"),
        ('kind = "wigley"', 'kind = "wigley"\nfile = "x.csv"', r"key of \[hull.shape\] .* got 'file'"),
    ],
)
def test_mistakes_in_a_file_are_refused_in_one_sentence(old, new, sentence):
    assert old in PLAIN
    with pytest.raises(InputError, match=sentence) as caught:
        design_from_toml(PLAIN.replace(old, new))
    assert str(caught.value).count("\n") == 0


@pytest.mark.parametrize("content", [b"\xff\xfe\x00bad", b"[" * 5000, b"name = 3"])
def test_files_that_are_no_design_are_refused(tmp_path, content):
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(InputError):
        design_from_toml(path)


@pytest.mark.parametrize("source", ["missing.toml", "", 3, None])
def test_a_file_that_is_not_there_is_refused(source, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match="design file must be"):
        design_from_toml(source)


def test_saving_writes_the_whole_file_under_its_name(tmp_path):
    design = library.design("educat")
    path = save_design(design, tmp_path / "educat.toml")
    assert design_from_toml(path) == design
    save_design(dataclasses.replace(design, title="second"), path)
    assert design_from_toml(path).title == "second"
    assert os.listdir(tmp_path) == ["educat.toml"]


def test_a_folder_that_cannot_be_written_is_refused(tmp_path):
    design = library.design("educat")
    with pytest.raises(InputError, match="design file must be writable"):
        save_design(design, tmp_path / "missing" / "educat.toml")
    (tmp_path / "taken.toml").mkdir()
    with pytest.raises(InputError, match="design file must be writable"):
        save_design(design, tmp_path / "taken.toml")
    assert os.listdir(tmp_path) == ["taken.toml"]
    if os.geteuid() != 0:
        tmp_path.chmod(stat.S_IRUSR | stat.S_IXUSR)
        with pytest.raises(InputError, match="design file must be writable"):
            save_design(design, tmp_path / "educat.toml")


def test_offsets_may_stand_in_a_file_of_their_own(tmp_path):
    delft = library.design("delft-372")
    rows = [f"{x},{z},{y}" for x, points in delft.hull.shape.stations for z, y in points]
    (tmp_path / "lines.csv").write_text("\n".join(["x,z,half_breadth", *rows]))
    text = PLAIN.split("[hull.shape]")[0].replace("10.0", "0.7") + (
        '[hull.shape]\nkind = "offsets"\nfile = "lines.csv"\ndraught = 0.15\nlength = 3.0\n[masses]'
    )
    path = tmp_path / "delft.toml"
    path.write_text(
        text + PLAIN.split("[masses]")[1].replace("10.0", "0.8").replace("10.5", "0.9").replace("4.0", "0.4")
    )
    made = design_from_toml(path)
    assert made.hull == delft.hull
    assert design_from_toml(design_to_toml(made)) == made
    for old, new, sentence in (
        ("lines.csv", "other.csv", "offsets file must be readable"),
        ("length = 3.0", "", "length must be given"),
        ('file = "lines.csv"', "file = 3", "file of .* must be text"),
        ("draught = 0.15", "draught = 0.15\ndepth = 3", "got 'depth'"),
    ):
        path.write_text(path.read_text().replace(old, new))
        with pytest.raises(InputError, match=sentence):
            design_from_toml(path)
        path.write_text(path.read_text().replace(new or "kind", old if new else "length = 3.0\nkind"))


def triangles():
    return np.array([t for a, b, c, d in BOX_FACES for t in ((a, b, c), (a, c, d))])


@pytest.mark.parametrize("name", ["box.stl", "box.obj", "box.ply", "box.vtk"])
def test_meshes_are_read_from_the_usual_files(tmp_path, name):
    meshio.write(tmp_path / name, meshio.Mesh(np.array(BOX_POINTS) * 100 + 7.0, [("triangle", triangles())]))
    shape = mesh_from_file(tmp_path / name, length=10.0, unit=0.01, waterline=7.0, midships=7.0)
    # y is not moved: the box stands 0.07 m beside its centre plane
    floating = hydrostatics(Hull(shape=shape))
    assert float(floating.volume) == pytest.approx(10.0, rel=1e-5)
    assert float(floating.centre_of_buoyancy[0]) == pytest.approx(0.0, abs=1e-5)
    assert shape.draught == pytest.approx(1.0)


def corners(faces, keep):
    quads = [[BOX_POINTS[k] for k in face] for face in faces]
    return "\n".join(
        " ".join(f"{value:g}" for value in point) for quad in quads if keep(quad) for point in quad
    )


def test_a_gdf_file_is_read_with_its_symmetries(tmp_path):
    path = tmp_path / "box.gdf"
    path.write_text("box\n1.0 9.80665\n0 0\n6\n" + corners(BOX_FACES, lambda quad: True))
    whole = mesh_from_file(path, length=10.0)
    assert float(hydrostatics(Hull(shape=whole)).volume) == pytest.approx(10.0)
    half = [
        [(5, 0, -1), (5, 0.5, -1), (5, 0.5, 0), (5, 0, 0)],
        [(0, 0.5, -1), (0, 0.5, 0), (5, 0.5, 0), (5, 0.5, -1)],
        [(0, 0, -1), (0, 0.5, -1), (5, 0.5, -1), (5, 0, -1)],
    ]
    rows = "\n".join(" ".join(str(value) for point in quad for value in point) for quad in half)
    path.write_text("quarter of a box\n2.0 9.80665\n1 1\n3\n" + rows)
    quarter = mesh_from_file(path, length=10.0)
    assert float(hydrostatics(Hull(shape=quarter)).volume) == pytest.approx(10.0)


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("a.stl", b"nothing of use", "mesh file must be a readable"),
        ("a.stl", b"", "mesh file must have"),
        ("a.obj", b"v 1 2\nf 9 9 9\n", "mesh"),
        ("a.xyz", b"1 2 3", "mesh file must be a readable"),
        ("a.gdf", b"", "GDF file must hold"),
        ("a.gdf", b"t\n1 9.8\n0 0\n5\n1 2 3\n", "GDF file must hold"),
        ("a.gdf", b"t\n1 9.8\n0 0\nmany\n", "GDF file must hold"),
    ],
)
def test_meshes_that_cannot_be_read_are_refused(tmp_path, name, content, sentence):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=sentence):
        mesh_from_file(tmp_path / name, length=10.0)


def test_a_mesh_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(InputError, match="mesh file must exist"):
        mesh_from_file(tmp_path / "none.stl", length=10.0)


def test_a_mesh_may_be_named_in_a_design_or_stand_in_it(tmp_path):
    meshio.write(tmp_path / "box.stl", meshio.Mesh(np.array(BOX_POINTS), [("triangle", triangles())]))
    start, end = PLAIN.split("[hull.shape]")[0], PLAIN[PLAIN.index("[masses]") :]
    end = end.replace("10.", "2.").replace("4.0", "2.0")
    path = tmp_path / "box.toml"
    path.write_text(start + '[hull.shape]\nkind = "mesh"\nfile = "box.stl"\nlength = 10.0\n' + end)
    made = design_from_toml(path)
    assert isinstance(made.hull.shape, PanelMesh)
    assert design_from_toml(design_to_toml(made)) == made


FITTED = (
    PLAIN
    + """
[sail_plan]
heights = [2.0, 10.0, 30.0]
chords = [10, 8.5, 2.0]
lift_coefficient = 1.2
[[appendages]]
kind = "fin"
name = "daggerboards"
area = 2.0
span = 2.5
position = [1.0, 5.0, -3.0]
cant_degrees = 80.0
pair = true
[[appendages]]
kind = "foil"
name = "T-foil"
area = 3.0
span = 3.0
position = [12.0, 0.0, -3.0]
lift_slope = 3.5
"""
)


def test_appendages_are_an_array_of_tables():
    one = FITTED[: FITTED.rindex("[[appendages]]")].replace("[[appendages]]", "[appendages]")
    with pytest.raises(InputError, match=r"appendages must be .* use double brackets"):
        design_from_toml(one)


def test_appendages_and_sails_come_back_equal_from_their_text():
    made = design_from_toml(FITTED)
    boards, foil = made.appendages
    assert isinstance(boards, Fin)
    assert boards.pair
    assert boards.cant == pytest.approx(math.radians(80))
    assert isinstance(foil, Foil)
    assert (foil.cant, foil.lift_slope) == (0.0, 3.5)
    assert made.sail_plan.chords == (10.0, 8.5, 2.0)
    assert design_from_toml(design_to_toml(made)) == made


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('kind = "foil"', "", "kind must be given in"),
        ('kind = "foil"', 'kind = "wing"', "kind of .*appendages.* must be one of foil, fin"),
        ("span = 3.0", "spam = 3.0", "nearest is 'span'"),
        ("span = 3.0", "", "span must be given in"),
        ("lift_coefficient = 1.2", "", "lift_coefficient must be given in"),
        ("heights = [2.0, 10.0, 30.0]", "heights = [2.0, 10.0]", "must be as many"),
        ("pair = true", "pair = 1", "pair of daggerboards must be true or false"),
    ],
)
def test_appendages_and_sails_that_are_written_wrongly_are_refused(old, new, sentence):
    assert old in FITTED
    with pytest.raises(InputError, match=sentence) as caught:
        design_from_toml(FITTED.replace(old, new))
    assert str(caught.value).count("\n") == 0
