"""Variants: sections kept, displacement kept or grown as stated, and motions that are not computed twice."""

import math
from dataclasses import replace

import numpy as np
import pytest

from workbench import pipeline, theory_stage
from workbench.appendages import Fin, Foil
from workbench.design import Hull
from workbench.errors import InputError
from workbench.geometry.hydrostatics import hydrostatics
from workbench.geometry.sections import sections
from workbench.hulls.library import design
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.motions import motions
from workbench.parametric_study import slamming_of_variants
from workbench.seas import Condition, SeaState
from workbench.shapes import Offsets, PanelMesh, Wigley
from workbench.variants import (
    deck_moved,
    deck_raised,
    flattened,
    lengthened,
    same_motions,
    stretched,
    widened,
)

QUICK = StripSettings(stations=21, panels=16, frequencies=12)
SEA = SeaState.from_mean_period(4.0, 8.0)


def volume(hull):
    return float(hydrostatics(hull, 1025.0, 0.0).volume)


def box(length=20.0, beam=3.0, draught=1.5):
    points = ((0.0, 0.8), (0.5, 1.2), (draught, beam / 2), (3.0, 1.7))
    places = [length * share for share in (-0.5, -0.25, 0.0, 0.25, 0.5)]
    shares = (0.8, 0.9, 1.0, 0.8, 0.5)
    stations = tuple(
        (x, tuple((z, y * share) for z, y in points)) for x, share in zip(places, shares, strict=True)
    )
    return Offsets(stations=stations, draught=draught, length=length)


def mesh(length=20.0, breadth=3.0, draught=1.5):
    x, y = (-length / 2, length / 2), (-breadth / 2, breadth / 2)
    vertices = tuple((a, b, c) for a in x for b in y for c in (-draught, 0.0, 1.0))
    number = {vertex: index for index, vertex in enumerate(vertices)}

    def face(*corners):
        return tuple(number[corner] for corner in corners)

    (x0, x1), (y0, y1) = x, y
    faces = [face((x0, y0, -draught), (x0, y1, -draught), (x1, y1, -draught), (x1, y0, -draught))]
    for low, high in ((-draught, 0.0), (0.0, 1.0)):
        faces += [
            face((x0, y0, low), (x1, y0, low), (x1, y0, high), (x0, y0, high)),
            face((x1, y0, low), (x1, y1, low), (x1, y1, high), (x1, y0, high)),
            face((x1, y1, low), (x0, y1, low), (x0, y1, high), (x1, y1, high)),
            face((x0, y1, low), (x0, y0, low), (x0, y0, high), (x0, y1, high)),
        ]
    return PanelMesh(vertices=vertices, faces=tuple(faces), length=length, draught=draught)


SHAPES = {
    "semi-swath": design("austal-63").hull.shape,
    "slender-racing": design("catamaran-35").hull.shape,
    "round-bilge": design("npl-5b").hull.shape,
    "heavy-lift-box": design("heavy-lift-198").hull.shape,
    "wigley": Wigley(length=20.0, beam=2.0, draught=1.2, depth=2.5),
    "offsets": box(),
    "mesh": mesh(),
}


@pytest.mark.parametrize("name", SHAPES)
def test_a_longer_hull_has_the_same_sections_further_apart(name):
    shape = SHAPES[name]
    longer = stretched(shape, 1.2)
    assert longer.length == pytest.approx(1.2 * shape.length)
    assert (longer.beam, longer.draught, longer.depth) == pytest.approx(
        (shape.beam, shape.draught, shape.depth)
    )
    assert volume(Hull(shape=longer)) == pytest.approx(1.2 * volume(Hull(shape=shape)), rel=2e-3)
    before, after = (sections(Hull(shape=one), 21, 21)[0] for one in (shape, longer))
    np.testing.assert_allclose(after.x, 1.2 * before.x, rtol=1e-6)
    np.testing.assert_allclose(after.areas, before.areas, rtol=2e-3, atol=2e-3 * before.areas.max())


@pytest.mark.parametrize("name", SHAPES)
def test_a_wider_hull_displaces_the_same_at_less_draught(name):
    shape = SHAPES[name]
    wider = flattened(shape, 1.15)
    assert wider.beam == pytest.approx(1.15 * shape.beam)
    assert wider.draught < 0.95 * shape.draught
    assert wider.depth - wider.draught == pytest.approx(shape.depth - shape.draught)
    assert volume(Hull(shape=wider)) == pytest.approx(volume(Hull(shape=shape)), rel=2e-3)


def test_masses_follow_the_length_and_stay_with_the_beam():
    base = design("austal-63")
    longer, wider = lengthened(base, 10.0), widened(base, 0.737)
    ratio = 86.0 / 76.0
    assert longer.masses.mass == pytest.approx(ratio * base.masses.mass)
    assert longer.masses.pitch_gyradius == pytest.approx(ratio * base.masses.pitch_gyradius)
    assert longer.masses.roll_gyradius == base.masses.roll_gyradius
    assert longer.masses.centre_of_gravity == pytest.approx(
        (ratio * base.masses.centre_of_gravity[0], 0.0, base.masses.centre_of_gravity[2])
    )
    assert longer.wet_deck == wider.wet_deck == base.wet_deck
    assert wider.masses == base.masses
    assert wider.hull.shape.beam == pytest.approx(5.2 + 0.737)
    for variant in (longer, wider):
        afloat = hydrostatics(variant.hull, 1025.0, 0.0)
        assert float(afloat.displacement) == pytest.approx(variant.masses.mass, rel=2e-3)
        assert variant.provenance[-1][0] == "variant"
        assert variant.name != base.name


def test_all_hulls_of_a_trimaran_change_in_proportion():
    base = design("trimaran-35")
    longer, wider = lengthened(base, 2.8), widened(base, 0.06)
    assert longer.hull.centre_shape.length / base.hull.centre_shape.length == pytest.approx(36.8 / 34.0)
    assert longer.hull.shape.length / base.hull.shape.length == pytest.approx(36.8 / 34.0)
    assert wider.hull.centre_shape.beam / base.hull.centre_shape.beam == pytest.approx(1.1)


def test_appendages_stay_at_their_station_and_fins_under_the_keel():
    foil = Foil(name="foil", area=6.0, span=4.0, position=(28.0, 9.3, -3.5), pair=True)
    fin = Fin(name="fin", area=2.0, span=1.0, position=(-30.0, 9.3, -3.6), pair=True)
    base = replace(design("austal-63"), appendages=(foil, fin))
    assert lengthened(base, 7.6).appendages[0].position == pytest.approx((30.8, 9.3, -3.5))
    wider = widened(base, 0.737)
    rise = base.hull.shape.draught - wider.hull.shape.draught
    assert wider.appendages[1].position == pytest.approx((-30.0, 9.3, -3.6 + rise))


def test_a_deck_is_moved_and_raised_and_nothing_else():
    base = design("austal-63")
    aft, up = deck_moved(base, 3.0), deck_raised(base, 0.5)
    assert (aft.wet_deck.aft, aft.wet_deck.fore) == (-39.0, 30.0)
    assert aft.wet_deck.clearance == base.wet_deck.clearance
    assert up.wet_deck == replace(base.wet_deck, clearance=3.1)
    assert same_motions(aft) == same_motions(up) == same_motions(base)
    assert same_motions(lengthened(base, 1.0)) != same_motions(base)
    assert deck_raised(deck_moved(aft, -3.0), 0.0).wet_deck == base.wet_deck


def test_a_moved_deck_runs_no_hydrodynamics_again(monkeypatch):
    calls = {"hydrodynamics": 0, "motions": 0}

    def counted(name, function):
        def wrapper(*arguments, **more):
            calls[name] += 1
            return function(*arguments, **more)

        return wrapper

    monkeypatch.setattr(theory_stage, "hydrodynamics", counted("hydrodynamics", theory_stage.hydrodynamics))
    monkeypatch.setattr(pipeline, "motions", counted("motions", motions))
    base = design("austal-63")
    seas = [Condition(speed=speed, wave_direction=np.pi, sea_state=SEA) for speed in (10.0, 15.0)]
    decks = [base, deck_moved(base, 3.0), deck_raised(base, 0.5), deck_moved(deck_raised(base, 0.2), 1.0)]
    found = slamming_of_variants(decks, seas, QUICK)
    assert calls == {"hydrodynamics": 2, "motions": 2}  # once for each speed
    slamming_of_variants([*decks, lengthened(base, 10.0)], seas, QUICK)
    assert calls == {"hydrodynamics": 6, "motions": 6}

    rate = found.slams_per_hour.values
    np.testing.assert_allclose(found.change_of_slams.values, rate / rate[0] - 1.0)
    assert (rate[1:] < rate[0]).all()
    assert found.worst_x.values[1, 0] == pytest.approx(found.worst_x.values[0, 0] - 3.0, abs=2.0)
    ship = pipeline.response(base, 15.0, (np.pi,), None, QUICK)
    raised = deck_raised(base, 0.5)
    whole = pipeline.slamming(ship, pipeline.deck_response(ship, raised.wet_deck), raised.wet_deck, seas[1])
    assert rate[2, 1] == pytest.approx(float(whole.statistics.slams_per_hour.max()))


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: lengthened(design("austal-63"), -60.0), "added length must be a finite number > -38"),
        (lambda: lengthened(design("austal-63"), math.nan), "added length"),
        (lambda: widened(design("austal-63"), 9.0), "added beam of a hull must be"),
        (lambda: deck_moved(design("cofea"), 1.0), "cofea has none"),
        (lambda: deck_raised(design("austal-63"), -3.0), "rise of the wet deck must be"),
        (
            lambda: widened(replace(design("austal-63"), hull=replace(design("austal-63").hull, trim=0.01)), 0.1),
            "must float upright",
        ),
        (lambda: slamming_of_variants([design("cofea")], []), "must be designs with a wet deck"),
        (lambda: slamming_of_variants([design("austal-63")], []), "conditions must be at least one"),
    ],
)  # fmt: skip
def test_what_cannot_be_varied_is_refused(make, words):
    with pytest.raises(InputError, match=words):
        make()
