import struct

import pytest
from scenes import hull

from workbench.errors import InputError
from workbench.scene import stills
from workbench.scene.stills import deck_contour_picture, film, mesh_picture


def png_size(path) -> tuple[int, int]:
    head = path.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", head[16:24])


@pytest.mark.parametrize("camera", ["under"])
def test_picture_of_the_deck(short_scene, tmp_path, painter, camera):
    path = deck_contour_picture(
        short_scene, tmp_path / "deck.png", field="pressure", camera=camera, size=(640, 400)
    )
    assert png_size(path) == (640, 400)
    assert path.stat().st_size > 5_000
    assert [one.name for one in tmp_path.iterdir()] == ["deck.png"]


def test_picture_of_a_mesh(tmp_path, painter):
    assert png_size(mesh_picture(*hull(12, 5), tmp_path / "mesh.png", size=(480, 320))) == (480, 320)


@pytest.mark.parametrize(("name", "head"), [("film.mp4", b"ftyp"), ("film.gif", b"GIF8")])
def test_short_film(film_scene, tmp_path, painter, name, head):
    path = film(film_scene, tmp_path / name, start=2.0, end=2.3, frames_per_second=10, size=(330, 200))
    assert head in path.read_bytes()[:12]
    assert path.stat().st_size > 2_000


@pytest.mark.parametrize(
    ("name", "options", "words"),
    [
        ("deck.jpg", {}, "must end in .png"),
        ("deck.png", {"time": 99.0}, "Time of the picture"),
        ("deck.png", {"camera": "top"}, "The camera must be one of"),
        ("deck.png", {"field": "depth"}, "The field drawn on the deck must be one of"),
        ("nowhere/deck.png", {}, "does not exist"),
    ],
)
def test_wrong_orders_are_refused(short_scene, tmp_path, name, options, words):
    with pytest.raises(InputError, match=words):
        deck_contour_picture(short_scene, tmp_path / name, **options)


def test_missing_libraries_are_named(short_scene, tmp_path, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.setattr(stills.ctypes.util, "find_library", lambda name: None)
    with pytest.raises(InputError, match="EGL or the OSMesa library"):
        deck_contour_picture(short_scene, tmp_path / "deck.png")
    assert list(tmp_path.iterdir()) == []


def test_failed_painting_leaves_no_file(short_scene, tmp_path, monkeypatch):
    monkeypatch.setattr(stills.sys, "executable", "/bin/false")
    with pytest.raises(RuntimeError, match=r"deck\.png could not be painted"):
        deck_contour_picture(short_scene, tmp_path / "deck.png")
    assert list(tmp_path.iterdir()) == []
