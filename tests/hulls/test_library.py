import time

import pytest

from workbench.errors import InputError
from workbench.hulls import library

EXPECTED = {
    "delft-372", "austal-63", "crowther-318", "educat", "catamaran-35", "trimaran-35", "cofea", "asr-5116",
    "crowther-318-modified", "sally-malay",
    "hayes", "npl-3b", "npl-4a", "npl-4b", "npl-4c", "npl-5a", "npl-5b", "npl-5c", "npl-6a", "npl-6b",
    "npl-6c",
    "incat-061", "incat-064", "heavy-lift-198", "heavy-lift-198-model",
}  # fmt: skip


def test_the_library_has_its_designs():
    assert set(library.names()) == EXPECTED


@pytest.mark.parametrize("name", library.names())
def test_every_design_says_where_its_figures_come_from(name):
    design = library.design(name)
    assert design.name == name
    assert design.title
    standings = {standing for *_, standing in design.provenance}
    assert "published" in standings
    assert standings <= {"published", "derived", "ours"}
    assert len(design.provenance) >= 5
    for quantity, value, source, _ in design.provenance:
        assert quantity
        assert value
        assert source
        assert "shared" not in source
    given = " ".join(quantity for quantity, *_ in design.provenance).lower()
    assert "gyradi" in given
    assert (
        design.wet_deck is None or "wet deck" in given or "cross structure" in given or "main beam" in given
    )


@pytest.mark.parametrize(
    ("name", "figures"),
    [
        ("delft-372", {"mass": 87.07, "spacing": 0.70, "draught": 0.15, "length": 3.0}),
        ("crowther-318", {"mass": 3700.0, "beam": 15.2 / 22}),
        ("crowther-318-modified", {"beam": 15.2 / 22, "length": 14.9 + 1.9, "mass": 3700.0 * 16.8 / 14.9}),
        ("educat", {"mass": 2000.0, "length": 6.80}),
        ("catamaran-35", {"mass": 24_000.0, "clearance": 2.5}),
        ("trimaran-35", {"mass": 24_000.0, "clearance": 2.5}),
        ("cofea", {"mass": 4.242e6, "length": 120.0, "draught": 4.6, "pitch_gyradius": 30.0}),
        ("asr-5116", {"mass": 362.87, "length": 3.3254, "clearance": 0.18415, "width": 0.4826}),
        ("npl-5b", {"length": 1.6, "beam": 1.6 / 11, "spacing": 0.32, "pitch_gyradius": 0.4}),
        ("incat-061", {"mass": 1.845e6, "length": 92.4, "spacing": 21.7, "centre_bow_length": 23.1}),
        ("incat-064", {"mass": 2.8e6, "length": 105.6, "draught": 3.93, "centre_bow_length": 20.06}),
        ("heavy-lift-198", {"mass": 84.662e6, "depth": 26.0, "draught": 10.5, "clearance": 7.14}),
        ("heavy-lift-198-model", {"mass": 14.52, "length": 1.1, "draught": 0.0583, "clearance": 0.0397}),
    ],
)
def test_published_particulars_are_kept(name, figures):
    design = library.design(name)
    for quantity, value in figures.items():
        owners = (design.masses, design.wet_deck, design.hull.shape, design.hull)
        owner = next(part for part in owners if hasattr(part, quantity))
        assert getattr(owner, quantity) == pytest.approx(value, rel=1e-3), quantity


@pytest.mark.parametrize(
    ("name", "closest"),
    [("delft372", "delft-372"), ("npl5b", "npl-5b"), ("incat", "incat-06"), ("", "delft-372")],
)
def test_an_unknown_name_is_refused_with_the_closest(name, closest):
    with pytest.raises(InputError, match=closest):
        library.design(name)


@pytest.mark.parametrize("name", [None, 3, "../secret"])
def test_what_is_no_name_is_refused(name):
    with pytest.raises(InputError, match="design must be one of the library"):
        library.design(name)


@pytest.mark.parametrize("name", ["delft-372", "austal-63", "heavy-lift-198"])
def test_a_design_is_made_quickly(name):
    start = time.perf_counter()
    library._DESIGNS[name]()
    assert time.perf_counter() - start < 0.15


# K. Grande, MSc thesis, Curtin University of Technology, 2002: what each vessel of it has that is published
GRANDE_VESSELS = {
    "crowther-318": ("15.2 m", "10.8 m", "3700 kg", "about 22", "semi-SWATH"),
    "crowther-318-modified": ("17.1 m (56 ft)",),
    "austal-63": ("86.6 m", "24.0 m", "40 kn", "semi-SWATH", "T-foils"),
    "educat": ("8 m", "6.80 m", "2.79 m", "2.0 t", "rubber"),
    "cofea": ("120 m", "4.6 m", "4242 t", "20 m (not used)", "0.633, 0.925", "-0.336 m", "0.25 lengths"),
    "catamaran-35": ("35 m", "21 m", "24000 kg", "2.5 m", "577 m2"),
    "trimaran-35": ("35 m", "21 m", "24000 kg", "2.5 m", "577 m2"),
    "sally-malay": ("36 ft", "stretched from 30 ft", "daggerboards", "fractional", "6 to 9 kn"),
}


@pytest.mark.parametrize("name", GRANDE_VESSELS)
def test_vessels_of_grande_have_all_that_is_published_of_them(name):
    provenance = library.design(name).provenance
    given = " | ".join(value for _, value, source, standing in provenance if standing == "published")
    for figure in GRANDE_VESSELS[name]:
        assert figure in given


@pytest.mark.parametrize("name", GRANDE_VESSELS)
def test_what_the_source_does_not_give_is_said_to_be_missing(name):
    entries = {quantity: (value, reason) for quantity, value, reason, standing in library.design(name).provenance
               if standing == "ours"}  # fmt: skip
    assert any("missing" in reason or "not given" in reason for _, reason in entries.values())
    gravity = next(quantity for quantity in entries if quantity.startswith("centre of gravity"))
    assert "missing" in entries[gravity][1] or "not given" in entries[gravity][1]


def test_cofea_says_that_her_table_is_not_consistent():
    reasons = {quantity: reason for quantity, _, reason, _ in library.design("cofea").provenance}
    assert "not consistent" in reasons["beam"]
    for coefficients, tonnes in (((0.633, 0.925), 6626.0), ((0.592, 0.948), 6351.0)):
        block = coefficients[0] * coefficients[1]
        assert 1.025 * block * 120.0 * 20.0 * 4.6 == pytest.approx(tonnes, rel=1e-3)  # against 4242, 4229


def test_the_modified_crowther_is_the_crowther_stretched():
    built, modified = library.design("crowther-318"), library.design("crowther-318-modified")
    assert modified.hull.length - built.hull.length == pytest.approx(17.1 - 15.2)
    assert modified.hull.shape.draught == built.hull.shape.draught
    assert modified.wet_deck == built.wet_deck
    assert modified.sail_plan == built.sail_plan
