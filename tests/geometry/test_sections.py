from dataclasses import replace

import numpy as np
import pytest

from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.faceted import cleaned
from workbench.geometry.hydrostatics import hydrostatics
from workbench.geometry.sections import sections, surface
from workbench.hulls import library
from workbench.shapes import HeavyLiftBox, Offsets, Wigley

NAMES = [name for name in library.names() if name == "npl-5b" or not name.startswith("npl")]
L, B, T = 40.0, 4.0, 2.0
WIGLEY = Wigley(length=L, beam=B, draught=T, depth=5.0)
CHINE = ((0.0, 0.0), (0.5, 1.0), (2.0, 1.2))
HARD_CHINE = Offsets(stations=tuple((x, CHINE) for x in np.linspace(-10, 10, 9)), draught=1.5, length=20.0)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("attitude", [{}, {"trim": 0.005}, {"heel": 0.02}])
def test_section_areas_add_up_to_the_volume(name, attitude):
    hull = replace(library.design(name).hull, **attitude)
    volume = sum(np.trapezoid(part.areas, part.x) for part in sections(hull, 81, 61))
    assert volume == pytest.approx(float(hydrostatics(hull).volume), rel=4e-3)


def test_sections_of_a_wigley_hull_are_parabolas():
    (part,) = sections(Hull(shape=WIGLEY), 41, 41)
    taper = 1 - (2 * part.x / L) ** 2
    np.testing.assert_allclose(part.beams, B * taper, atol=2e-3)
    np.testing.assert_allclose(part.areas, 2 / 3 * B * T * taper, atol=0.02)
    np.testing.assert_allclose(part.draughts, T, atol=1e-9)
    expected = B / 2 * taper[:, None] * (1 - (part.z / T) ** 2)
    np.testing.assert_allclose(np.abs(part.y), expected, atol=2e-3)


def test_contours_run_from_the_starboard_to_the_port_waterline():
    port, starboard = sections(Hull(shape=WIGLEY, count=2, spacing=10.0), 21, 20)
    assert port.position == (0.0, 5.0)
    assert starboard.position == (0.0, -5.0)
    assert port.y.shape == (21, 21)  # an odd number of points, so that one is the keel
    np.testing.assert_array_equal(port.z[:, [0, -1]], 0.0)
    assert (np.diff(port.y[10]) > 0.0).all()
    np.testing.assert_allclose(port.y[:, 10], 5.0)
    np.testing.assert_allclose(starboard.y, port.y - 10.0)


@pytest.mark.parametrize("heel", [0.0, 0.03])
def test_a_chine_stays_a_corner(heel):
    (part,) = sections(Hull(shape=HARD_CHINE, heel=heel), 11, 31)
    cosine, sine = np.cos(heel), np.sin(heel)
    for side in (-1.0, 1.0):
        chine = np.array([side * 1.0 * cosine + 1.0 * sine, side * 1.0 * sine - 1.0 * cosine])
        distance = np.hypot(part.y - chine[0], part.z - chine[1]).min(axis=1)
        np.testing.assert_allclose(distance, 0.0, atol=0.005)


def test_a_dry_stern_ends_where_the_keel_meets_the_water():
    lifted = library.design("delft-372").hull.shape
    (part,) = sections(Hull(shape=lifted, sinkage=-0.02))
    # the keel of the table stands 0.13 m high at x = -1.35 m + (0.13 - 0.1247) / slope
    assert -1.42 < part.x[0] < -1.35
    assert part.areas[0] == pytest.approx(0.0, abs=1e-6)
    assert part.x[-1] == pytest.approx(1.47, abs=0.01)


def test_heel_turns_the_sections_about_the_origin():
    heel = 0.1
    (part,) = sections(Hull(shape=HeavyLiftBox(length=L, beam=B, draught=T, depth=4.0), heel=heel), 5, 41)
    corner = (-B / 2 * np.cos(heel) + T * np.sin(heel), -B / 2 * np.sin(heel) - T * np.cos(heel))
    distance = np.hypot(part.y[2] - corner[0], part.z[2] - corner[1])
    assert distance.min() < 1e-9
    assert part.draughts[2] == pytest.approx(-corner[1])


@pytest.mark.parametrize("name", NAMES)
def test_the_surface_is_a_closed_body_that_looks_outwards(name):
    hull = library.design(name).hull
    points, faces = surface(hull)
    assert len(faces) < 12_000
    body = cleaned(points, faces, np.zeros(len(faces), bool), mirrored=False)
    np.testing.assert_allclose(body.area_vectors.sum(axis=0), 0.0, atol=1e-9 * body.areas.sum())
    above = points[:, 2].max()
    assert above == pytest.approx(hull.shape.depth - hull.shape.draught, rel=0.05)
    assert body.volume > float(hydrostatics(hull).volume)


@pytest.mark.parametrize(("stations", "points"), [(2, 21), (21, 2), ("x", 21), (21, None), (10**6, 21)])
def test_numbers_of_stations_without_sense_are_refused(stations, points):
    with pytest.raises(InputError, match="number of "):
        sections(Hull(shape=WIGLEY), stations, points)
