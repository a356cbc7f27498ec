import dataclasses
import json
import math

import pytest

from workbench.design import Design, Fin, Foil, Hull, MassProperties, WetDeck
from workbench.errors import InputError
from workbench.hulls import library
from workbench.sails import tapered_sail_plan
from workbench.shapes import Wigley

SHAPE = Wigley(length=40.0, beam=4.0, draught=2.0, depth=5.0)
HULL = {"shape": SHAPE, "count": 2, "spacing": 10.0}
DECK = {"aft": -15.0, "fore": 15.0, "width": 6.0, "clearance": 1.5}
MASSES = {
    "mass": 3e5,
    "centre_of_gravity": (0.0, 0.0, 1.0),
    "roll_gyradius": 4.0,
    "pitch_gyradius": 10.0,
    "yaw_gyradius": 10.5,
}


def design(**changes):
    parts = {"hull": Hull(**HULL), "wet_deck": WetDeck(**DECK), "masses": MassProperties(**MASSES)}
    return Design(**{"name": "twin", **parts, **changes})


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"shape": "wigley"}, "hull shape must be a hull shape"),
        ({"count": 4}, "count of hulls must be 1, 2 or 3, got 4"),
        ({"count": "2"}, "count of hulls must be 1, 2 or 3, got '2'"),
        ({"count": True}, "count of hulls must be"),
        ({"count": 1}, "spacing between hulls must be 0 for one hull"),
        ({"spacing": 3.9}, "so that they do not touch, got 3.9 m"),
        ({"spacing": 4.0}, "must be > 4 m"),
        ({"count": 3, "spacing": 7.9}, "must be > 8 m"),
        ({"spacing": 1e9}, "spacing between hulls must be a finite number >= 0 and <= 80 m"),
        ({"spacing": "ten"}, "spacing between hulls must be a number"),
        ({"spacing": math.nan}, "spacing between hulls must be a finite number"),
        ({"centre_shape": SHAPE}, "centre hull needs a count of 3"),
        ({"heel": 1.0}, "heel must be"),
        ({"trim": math.inf}, "trim must be"),
        ({"sinkage": 3.1}, "sinkage must be .* deck edge awash"),
        ({"sinkage": -2.0}, "sinkage must be"),
    ],
)
def test_hulls_that_cannot_float_so_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        Hull(**HULL | changes)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"clearance": 0.0}, "must lie above still water"),
        ({"clearance": -0.5}, "must lie above still water"),
        ({"clearance": "1 m"}, "wet-deck clearance must be a number"),
        ({"fore": -20.0}, "fore end of the wet deck must be"),
        ({"width": 0.0}, "width of the wet deck must be"),
        ({"camber": -0.1}, "camber of the wet deck must be"),
        ({"corner_radius": 1.5}, r"lowest point of the wet deck \(corner radius"),
        ({"vee_depth": 1.5, "vee_width": 2.0}, r"lowest point of the wet deck \(V of the pod"),
        ({"vee_depth": 0.5}, "vee depth and vee width of the wet deck must both be 0 or both > 0"),
        (
            {"centre_bow_depth": 1.6, "centre_bow_length": 5.0, "centre_bow_width": 2.0},
            r"lowest point of the wet deck \(centre bow",
        ),
        ({"trim": math.radians(6)}, r"lowest point of the wet deck \(trim"),
        ({"trim": -math.radians(6)}, r"lowest point of the wet deck \(trim"),
        ({"vee_depth": 0.5, "vee_width": 7.0}, "vee width of the wet deck must be"),
        ({"entry_length": 31.0, "entry_rise": 1.0}, "entry length of the wet deck must be"),
        ({"aft": math.nan}, "aft end of the wet deck must be"),
    ],
)
def test_wet_decks_in_the_water_or_without_extent_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        WetDeck(**DECK | changes)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"mass": 0.0}, "mass must be"),
        ({"mass": 1e12}, "mass must be"),
        ({"centre_of_gravity": 1.0}, "must be three numbers"),
        ({"centre_of_gravity": (0.0, 1.0)}, "must be three numbers"),
        ({"centre_of_gravity": "0,0,1"}, "must be three numbers"),
        ({"centre_of_gravity": (0.0, 0.0, math.nan)}, "z of the centre of gravity must be"),
        ({"centre_of_gravity": (0.0, 0.0, "1")}, "z of the centre of gravity must be a number"),
        ({"roll_gyradius": 0.0}, "roll gyradius must be"),
        ({"pitch_gyradius": -1.0}, "pitch gyradius must be"),
        ({"yaw_gyradius": math.inf}, "yaw gyradius must be"),
        ({"roll_damping_ratio": 1.5}, "roll damping ratio must be"),
    ],
)
def test_masses_that_cannot_be_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence):
        MassProperties(**MASSES | changes)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"name": ""}, "name of the design"),
        ({"name": 3}, "name of the design"),
        ({"title": 3}, "title of the design"),
        ({"hull": SHAPE}, "hull of the design must be a Hull"),
        ({"masses": None}, "masses of the design must be a MassProperties"),
        ({"wet_deck": 1.0}, "wet deck must be a WetDeck or None"),
        ({"density": 1.025}, "density of the water must be .* fresh water is 1000"),
        ({"provenance": (("a", "b"),)}, "provenance entry must be four texts"),
        ({"provenance": (("a", "b", "c", "guess"),)}, "standing of a must be one of"),
        ({"hull": Hull(shape=SHAPE)}, "wet deck needs two or three hulls"),
        ({"wet_deck": WetDeck(**DECK | {"width": 20.0})}, "width of the wet deck must be"),
        ({"wet_deck": WetDeck(**DECK | {"fore": 40.0})}, "fore end of the wet deck must be"),
        ({"masses": MassProperties(**MASSES | {"pitch_gyradius": 50.0})}, "pitch gyradius must be"),
        ({"masses": MassProperties(**MASSES | {"centre_of_gravity": (25, 0, 0)})}, "counted from midships"),
    ],
)
def test_parts_that_do_not_fit_together_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence):
        design(**changes)


def test_a_variant_is_a_replacement_and_differs_in_its_hash():
    base = design()
    higher = dataclasses.replace(base, wet_deck=dataclasses.replace(base.wet_deck, clearance=2.0))
    assert higher.hull is base.hull
    assert hash(higher) != hash(base)
    assert design() == base


@pytest.mark.parametrize("name", ["delft-372", "crowther-318", "incat-061", "trimaran-35"])
def test_froude_scaling_scales_masses_with_the_cube_and_lengths_with_the_factor(name):
    ship = library.design(name)
    model = ship.scaled(0.25)
    assert model.masses.mass == pytest.approx(ship.masses.mass / 64)
    assert model.masses.pitch_gyradius == pytest.approx(ship.masses.pitch_gyradius / 4)
    assert model.wet_deck.clearance == pytest.approx(ship.wet_deck.clearance / 4)
    assert model.wet_deck.centre_bow_depth == pytest.approx(ship.wet_deck.centre_bow_depth / 4)
    assert model.hull.spacing == pytest.approx(ship.hull.spacing / 4)
    assert model.hull.shape.draught == pytest.approx(ship.hull.shape.draught / 4)


def test_the_dictionary_of_a_design_is_plain_enough_for_a_content_key():
    for name in library.names():
        made = library.design(name)
        text = json.dumps(made.as_dict(), sort_keys=True, allow_nan=False)
        assert made.hull.shape.kind in text


def test_length_is_that_of_the_longest_hull():
    trimaran = library.design("trimaran-35").hull
    assert trimaran.length == trimaran.centre_shape.length > trimaran.shape.length


FOIL = Foil(name="T-foil", area=4.0, span=3.0, position=(15.0, 0.0, -3.0))
RUDDERS = Fin(name="rudders", area=2.0, span=1.6, position=(-18.0, 5.0, -2.2), pair=True)
SAILS = tapered_sail_plan(10.0, 2.0, 2.0, 30.0, 1.2)


def test_a_design_without_appendages_and_sails_says_nothing_of_them():
    assert list(design().as_dict()) == [
        "name", "title", "density", "hull", "wet_deck", "masses", "provenance",
    ]  # fmt: skip
    fitted = design(appendages=[FOIL, RUDDERS], sail_plan=SAILS)
    assert [one["kind"] for one in fitted.as_dict()["appendages"]] == ["foil", "fin"]
    assert fitted.as_dict()["sail_plan"]["chords"] == (10.0, 2.0)
    assert hash(fitted) != hash(design())
    json.dumps(fitted.as_dict())


def test_appendages_and_sails_scale_with_the_ship():
    model = design(appendages=(FOIL, RUDDERS), sail_plan=SAILS).scaled(0.1)
    foil, rudders = model.appendages
    assert (foil.area, foil.span, *foil.position) == pytest.approx((0.04, 0.3, 1.5, 0.0, -0.3))
    assert rudders.aspect_ratio == pytest.approx(RUDDERS.aspect_ratio)
    assert model.sail_plan.area == pytest.approx(0.01 * SAILS.area)
    assert design().scaled(0.1).sail_plan is None


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"appendages": FOIL}, "appendages must be a tuple of Foil and Fin"),
        ({"appendages": (3,)}, "appendages must be a tuple of Foil and Fin"),
        ({"appendages": (FOIL, FOIL)}, "names of appendages must differ"),
        ({"appendages": (FOIL.scaled(3.0),)}, "x of T-foil must be"),
        ({"appendages": (dataclasses.replace(FOIL, position=(0, 12.0, -3.0)),)}, "y of T-foil must be"),
        ({"sail_plan": 577.0}, "sail plan must be a SailPlan or None"),
    ],
)
def test_appendages_and_sails_that_do_not_fit_are_refused(changes, sentence):
    with pytest.raises(InputError, match=sentence) as caught:
        design(**changes)
    assert "\n" not in str(caught.value)
