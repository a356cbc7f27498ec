import pytest

from workbench.verdict import heading_words, length_words, rate_words, verdict

CASE = {
    "speed_knots": 30.0,
    "significant_wave_height": 3.0,
    "heading_degrees": 180.0,
    "slams_per_hour": 41.2,
    "distance_from_fore_end": 12.1,
    "clearance": 2.4,
    "least_clearance": 2.85,
    "criterion_per_hour": 20.0,
}


def test_deck_that_slams_too_often():
    assert verdict(**CASE) == (
        "At 30 kn in Hs 3 m, head seas, this deck slams 41 times an hour, worst 12 m aft of its fore end; "
        "0.45 m more clearance meets 20 per hour."
    )


def test_deck_that_meets_the_criterion():
    assert verdict(**{**CASE, "slams_per_hour": 4.0, "least_clearance": 2.0, "heading_degrees": 90.0}) == (
        "At 30 kn in Hs 3 m, beam seas, this deck slams 4.0 times an hour, worst 12 m aft of its fore "
        "end, and "
        "meets 20 per hour; 0.40 m less clearance would still meet 20 per hour."
    )


def test_deck_that_never_slams_at_rest_in_a_following_sea():
    words = verdict(
        **{**CASE, "slams_per_hour": 0.0, "least_clearance": 0.0, "speed_knots": 0.0, "heading_degrees": 0.0}
    )
    assert words == (
        "At rest in Hs 3 m, following seas, this deck does not slam; at any clearance it meets 20 per hour."
    )


def test_rate_at_the_criterion_meets_it():
    assert "meets 20 per hour" in verdict(**{**CASE, "slams_per_hour": 20.0, "least_clearance": 2.4})
    assert "more clearance" not in verdict(**{**CASE, "slams_per_hour": 20.0, "least_clearance": 2.4})


def test_worst_at_the_fore_end():
    assert "worst at its fore end" in verdict(**{**CASE, "distance_from_fore_end": 0.001})


@pytest.mark.parametrize(
    ("degrees", "words"),
    [
        (0, "following"), (15, "following"), (45, "quartering"), (75, "beam"), (90, "beam"), (105, "beam"),
        (120, "bow"), (150, "bow"), (165, "head"), (180, "head"), (195, "head"), (225, "bow"), (270, "beam"),
        (315, "quartering"), (350, "following"), (360, "following"),
    ],
)  # fmt: skip
def test_words_for_headings(degrees, words):
    assert heading_words(degrees) == f"{words} seas"


@pytest.mark.parametrize(
    ("rate", "words"),
    [
        (394.4, "394 times an hour"), (9.6, "10 times an hour"), (1.25, "1.2 times an hour"),
        (0.5, "once in 2 hours"), (0.013, "once in 77 hours"), (1e-5, "less than once in 1000 hours"),
    ],
)  # fmt: skip
def test_words_for_rates(rate, words):
    assert rate_words(rate) == words


@pytest.mark.parametrize(
    ("metres", "words"), [(12.2, "12 m"), (0.45, "0.45 m"), (0.031, "3.1 cm"), (0.0042, "4.2 mm")]
)
def test_words_for_lengths(metres, words):
    assert length_words(metres) == words
