import time

import numpy as np
import pytest

from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.faceted import cleaned
from workbench.geometry.hydrostatics import hydrostatics
from workbench.geometry.panels import hull_panels, hull_positions, lid_panels, panels, tunnel_lid
from workbench.geometry.sections import sections, surface
from workbench.hulls import library
from workbench.shapes import HeavyLiftBox, PanelMesh, Wigley

WIGLEY = Wigley(length=40.0, beam=4.0, draught=2.0, depth=5.0)
BOX = HeavyLiftBox(length=40.0, beam=4.0, draught=2.0, depth=5.0)
DELFT = library.design("delft-372").hull.shape
RACING = library.design("catamaran-35").hull.shape
NAMES = [name for name in library.names() if name == "npl-5b" or not name.startswith("npl")]
LIBRARY = [library.design(name).hull for name in NAMES]
HEELED = [
    Hull(shape=DELFT, count=2, spacing=0.7, heel=0.06, trim=0.015),
    Hull(shape=WIGLEY, heel=-0.3),
    Hull(shape=WIGLEY, count=3, spacing=14.0, heel=0.1),
]
TRIMMED = [
    Hull(shape=DELFT, count=2, spacing=0.7, trim=0.02),
    Hull(shape=DELFT, trim=-0.02, sinkage=0.01),
    Hull(shape=WIGLEY, count=3, spacing=12.0, centre_shape=BOX, centre_x=3.0),
]
ALL = [*LIBRARY, *HEELED, *TRIMMED]


def whole(hull, count=1000):
    return panels(hull, count).whole()


@pytest.mark.parametrize("hull", ALL)
def test_the_wetted_surface_is_closed_looks_outwards_and_has_no_empty_panels(hull):
    made = whole(hull)
    size = made.areas.sum()
    assert made.volume > 0.0
    np.testing.assert_allclose(made.area_vectors.sum(axis=0)[:2], 0.0, atol=1e-9 * size)
    assert made.areas.min() > 1e-4 * made.areas.mean()
    assert np.linalg.norm(made.normals, axis=1) == pytest.approx(1.0)
    assert made.vertices[:, 2].max() == 0.0
    edges = np.concatenate([made.faces[:, (k, (k + 1) % 4)] for k in range(4)])
    edges = edges[edges[:, 0] != edges[:, 1]]
    repeated = np.unique(edges, axis=0, return_counts=True)[1]
    assert repeated.max() == 1  # no two panels run along an edge the same way


@pytest.mark.parametrize("hull", ALL)
def test_every_edge_below_the_waterline_has_two_panels(hull):
    made = whole(hull)
    edges = np.concatenate([made.faces[:, (k, (k + 1) % 4)] for k in range(4)])
    edges = np.sort(edges[edges[:, 0] != edges[:, 1]], axis=1)
    pairs, count = np.unique(edges, axis=0, return_counts=True)
    heights = made.vertices[pairs][..., 2].min(axis=1)
    centre_plane = np.abs(made.vertices[pairs][..., 1]).max(axis=1) < 1e-12  # where mirrored halves meet
    assert (count[(heights < -1e-9) & ~centre_plane] == 2).all()


@pytest.mark.parametrize("hull", LIBRARY)
@pytest.mark.parametrize("target", [500, 1000, 2000])
def test_the_number_of_panels_is_near_the_wish(hull, target):
    made = panels(hull, target)
    assert len(made) * (2 if made.mirrored else 1) == pytest.approx(target, rel=0.2)


@pytest.mark.parametrize("hull", LIBRARY)
def test_a_thousand_panels_hold_the_volume_within_two_percent(hull):
    assert panels(hull, 1000).volume == pytest.approx(panels(hull, 20_000).volume, rel=0.02)


def test_the_half_of_an_upright_twin_is_the_whole_port_hull():
    made = panels(Hull(shape=WIGLEY, count=2, spacing=10.0), 600)
    assert made.mirrored
    assert made.vertices[:, 1].min() == pytest.approx(3.0)
    assert made.vertices[:, 1].max() == pytest.approx(7.0)
    assert made.volume == pytest.approx(2 * 4 / 9 * 40 * 4 * 2, rel=0.02)


def test_the_half_of_a_single_hull_is_its_port_side():
    made = panels(Hull(shape=WIGLEY), 600)
    assert made.mirrored
    assert made.vertices[:, 1].min() == 0.0
    outwards = made.normals[:, 1]
    assert (outwards > -1e-9).all()


def test_the_half_of_three_hulls_has_the_port_hull_and_half_of_the_centre_one():
    hull = Hull(shape=WIGLEY, count=3, spacing=12.0, centre_shape=BOX, centre_x=3.0)
    made = panels(hull, 1200)
    assert made.mirrored
    assert made.vertices[:, 1].min() == 0.0
    assert made.volume == pytest.approx(2 * 4 / 9 * 40 * 4 * 2 + 40 * 4 * 2, rel=0.02)
    assert hull_positions(hull) == ((0.0, 6.0), (0.0, -6.0), (3.0, 0.0))


def test_a_heeled_ship_is_not_mirrored_and_its_low_side_carries_more():
    made = panels(Hull(shape=WIGLEY, count=2, spacing=10.0, heel=0.05), 800)
    assert not made.mirrored
    port = hull_panels(Hull(shape=WIGLEY, count=2, spacing=10.0, heel=0.05), 0)
    starboard = hull_panels(Hull(shape=WIGLEY, count=2, spacing=10.0, heel=0.05), 1)
    assert starboard.volume > 1.2 * port.volume  # heel > 0 puts starboard down
    assert made.volume == pytest.approx(port.volume + starboard.volume, rel=0.01)


def test_heel_brings_the_centre_planes_together():
    hull = Hull(shape=WIGLEY, count=2, spacing=10.0, heel=0.2)
    assert hull_positions(hull) == ((0.0, 5.0 * np.cos(0.2)), (0.0, -5.0 * np.cos(0.2)))


def test_a_trim_by_the_bow_moves_buoyancy_forward():
    assert float(hydrostatics(Hull(shape=WIGLEY, trim=0.02)).centre_of_buoyancy[0]) > 1.0


@pytest.mark.parametrize("hull", [*LIBRARY[:6], *HEELED, *TRIMMED])
def test_a_hull_alone_stands_in_its_own_axes(hull):
    for index, (x, y) in enumerate(hull_positions(hull)):
        alone = hull_panels(hull, index, 600)
        assert alone.mirrored == (hull.heel == 0.0)
        moved = alone.whole().translated(x, y)
        every = sections(hull)[index]
        assert moved.vertices[:, 0].max() == pytest.approx(every.x[-1], abs=1e-3 * hull.length)
        assert moved.vertices[:, 1].max() == pytest.approx(every.y.max(), abs=0.02 * hull.shape.beam)
        assert moved.vertices[:, 1].min() == pytest.approx(every.y.min(), abs=0.02 * hull.shape.beam)


def test_only_the_wetted_transom_is_marked():
    made = panels(library.design("incat-061").hull, 1000)
    np.testing.assert_allclose(made.normals[made.is_transom], [[-1.0, 0.0, 0.0]] * made.is_transom.sum())
    assert made.centres[made.is_transom, 0] == pytest.approx(-92.4 / 2)
    assert not panels(Hull(shape=WIGLEY), 600).is_transom.any()
    blunt = panels(Hull(shape=BOX), 600)
    assert blunt.areas[blunt.is_transom].sum() == pytest.approx(4.0)  # half of 4 m by 2 m, aft only


def test_a_panel_size_is_kept_to():
    made = panels(Hull(shape=WIGLEY, count=2, spacing=10.0), panel_size=1.0)
    assert 0.4 < np.sqrt(made.areas.mean()) < 1.1


@pytest.mark.parametrize("hull", [hull for hull in ALL if not hull.heel])
def test_the_lid_fills_the_waterplane(hull):
    lid = lid_panels(hull)
    assert len(lid) > 0
    assert lid.mirrored == panels(hull, 500).mirrored
    assert (lid.normals[:, 2] == -1.0).all()
    assert (lid.vertices[:, 2] == 0.0).all()
    area = float(hydrostatics(hull).waterplane_area)
    assert lid.areas.sum() * (2 if lid.mirrored else 1) == pytest.approx(area, rel=0.03)


@pytest.mark.parametrize("hull", HEELED)
def test_the_lid_of_a_heeled_ship_is_whole(hull):
    lid = lid_panels(hull)
    assert not lid.mirrored
    assert lid.areas.sum() == pytest.approx(float(hydrostatics(hull).waterplane_area), rel=0.03)


def test_the_lid_of_one_hull_stands_in_its_own_axes():
    hull = Hull(shape=WIGLEY, count=2, spacing=10.0)
    lid = lid_panels(hull, 1)
    assert lid.mirrored
    assert lid.vertices[:, 1].min() == 0.0
    assert lid.vertices[:, 1].max() == pytest.approx(2.0, rel=0.01)


def test_the_tunnel_lid_reaches_from_the_centreline_to_the_inner_waterline():
    lid = tunnel_lid(Hull(shape=WIGLEY, count=2, spacing=10.0))
    assert lid.mirrored
    assert lid.vertices[:, 1].min() == 0.0
    assert lid.areas.sum() == pytest.approx(40 * 5 - 40 * 4 / 3, rel=0.01)
    inner = tunnel_lid(Hull(shape=WIGLEY, count=3, spacing=12.0))
    assert inner.areas.sum() == pytest.approx(40 * 6 - 2 * 40 * 4 / 3, rel=0.01)


@pytest.mark.parametrize("hull", [Hull(shape=WIGLEY), Hull(shape=WIGLEY, count=2, spacing=9.0, heel=0.1)])
def test_a_tunnel_lid_needs_an_upright_multihull(hull):
    with pytest.raises(InputError, match="tunnel lid needs two or three upright hulls"):
        tunnel_lid(hull)


def mesh_of(shape):
    points, faces = surface(Hull(shape=shape), 71, 61)
    tidy = cleaned(points, faces, np.zeros(len(faces), bool), mirrored=False)
    return PanelMesh(vertices=tidy.vertices, faces=tidy.faces, length=shape.length)


@pytest.mark.parametrize("shape", [WIGLEY, BOX, RACING])
@pytest.mark.parametrize("attitude", [{}, {"heel": 0.1}, {"trim": 0.01, "sinkage": 0.1}])
def test_a_mesh_of_a_hull_gives_what_the_hull_gives(shape, attitude):
    arrangement = {"count": 2, "spacing": 8.0, **attitude}
    mesh = Hull(shape=mesh_of(shape), **arrangement)
    wanted = hydrostatics(Hull(shape=shape, **arrangement))
    found = hydrostatics(mesh)
    assert float(found.volume) == pytest.approx(float(wanted.volume), rel=0.02)
    assert float(found.waterplane_area) == pytest.approx(float(wanted.waterplane_area), rel=0.01)
    lid = lid_panels(mesh)
    area = lid.areas.sum() * (2 if lid.mirrored else 1)
    assert area == pytest.approx(float(wanted.waterplane_area), rel=0.04)
    volume = sum(np.trapezoid(s.areas, s.x) for s in sections(mesh))
    assert volume == pytest.approx(float(wanted.volume), rel=0.03)


@pytest.mark.parametrize(
    ("hull", "sentence"),
    [
        (Hull(shape=WIGLEY, sinkage=-1.99998), "must reach the water"),
        (Hull(shape=WIGLEY, sinkage=-1.99998, heel=1e-6), "ship must reach the water"),
        (Hull(shape=Wigley(length=40, beam=4, draught=2, depth=2.2), heel=0.3), "deck edge .* above water"),
    ],
)
def test_attitudes_that_lift_a_hull_out_or_flood_its_deck_are_refused(hull, sentence):
    with pytest.raises(InputError, match=sentence):
        panels(hull, 500)


def test_a_mesh_that_ends_at_its_waterline_floats_there_only():
    wetted = panels(Hull(shape=WIGLEY), 400).whole()
    mesh = PanelMesh(vertices=wetted.vertices, faces=wetted.faces, length=40.0)
    assert panels(Hull(shape=mesh)).volume == pytest.approx(wetted.volume)
    with pytest.raises(InputError, match="closed below the waterline"):
        panels(Hull(shape=mesh, heel=0.05))


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"target_count": 3}, "number of panels must be"),
        ({"target_count": "many"}, "number of panels must be a number"),
        ({"panel_size": 0.0}, "panel size must be"),
        ({"panel_size": 1e3}, "panel size must be"),
    ],
)
def test_wishes_without_sense_are_refused(arguments, sentence):
    with pytest.raises(InputError, match=sentence):
        panels(Hull(shape=WIGLEY), **arguments)
    with pytest.raises(InputError, match=sentence):
        hull_panels(Hull(shape=WIGLEY), 0, **arguments)


@pytest.mark.parametrize("shape", [WIGLEY, mesh_of(WIGLEY)], ids=lambda shape: shape.kind)
def test_a_flying_hull_is_left_out(shape):
    flying = Hull(shape=shape, count=2, spacing=20.0, heel=0.22)
    made = panels(flying, 500)
    assert made.vertices[:, 1].max() < 0.0
    assert lid_panels(flying).vertices[:, 1].max() < 0.0
    port, starboard = sections(flying)
    assert port.x.size == port.areas.size == port.draughts.size == 0
    assert starboard.x.size > 0
    with pytest.raises(InputError, match="must reach the water"):
        hull_panels(flying, 0)


def test_an_unknown_hull_number_is_refused():
    with pytest.raises(InputError, match="hull number must be 0 to 1, got 2"):
        hull_panels(Hull(shape=WIGLEY, count=2, spacing=9.0), 2)


def test_panels_are_made_quickly():
    hull = Hull(shape=RACING, count=2, spacing=18.0)
    start = time.perf_counter()
    panels(hull, 1000)
    assert time.perf_counter() - start < 0.3
