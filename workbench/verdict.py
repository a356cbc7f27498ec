"""The verdict on a deck in one sentence, and the words for headings."""

NEVER = 1e-3
"""Slams per hour below which a deck is said not to slam."""


def heading_words(heading_degrees: float) -> str:
    """Words for a wave direction: head, bow, beam, quartering or following seas."""
    away = abs((heading_degrees + 180.0) % 360.0 - 180.0)
    limits = ((15.0, "following"), (75.0, "quartering"), (105.0, "beam"), (165.0, "bow"))
    for limit, words in limits:
        if away < limit or (away == limit and words in ("following", "beam")):
            return f"{words} seas"
    return "head seas"


def rate_words(per_hour: float) -> str:
    """Words for a rate: '41 times an hour', 'once in 4 hours', 'less than once in 1000 hours'."""
    if per_hour >= 9.5:
        return f"{per_hour:.0f} times an hour"
    if per_hour >= 1.0:
        return f"{per_hour:.1f} times an hour"
    hours = 1.0 / max(per_hour, 1e-12)
    if hours >= 1000:
        return "less than once in 1000 hours"
    return f"once in {hours:.2g} hours" if hours < 10 else f"once in {float(f'{hours:.2g}'):.0f} hours"


def length_words(metres: float) -> str:
    """A length with its unit; centimetres or millimetres where metres would start with zeros."""
    if abs(metres) >= 9.95:
        return f"{metres:.0f} m"
    if abs(metres) >= 0.1:
        return f"{metres:.2f} m"
    if abs(metres) >= 0.01:
        return f"{100 * metres:.1f} cm"
    return f"{1000 * metres:.1f} mm"


def verdict(
    *,
    speed_knots: float,
    significant_wave_height: float,
    heading_degrees: float,
    slams_per_hour: float,
    distance_from_fore_end: float,
    clearance: float,
    least_clearance: float,
    criterion_per_hour: float,
) -> str:
    """One sentence: how often this deck slams, where worst, and what clearance meets the criterion.

    Parameters
    ----------
    slams_per_hour : at the worst point [1/h]; distance_from_fore_end : of that point, aft [m].
    clearance, least_clearance : present, and least that meets the criterion [m].
    """
    where = (
        f"{'At rest' if speed_knots == 0 else f'At {speed_knots:.3g} kn'} in Hs "
        f"{significant_wave_height:.3g} m, "
        f"{heading_words(heading_degrees)},"
    )
    allowed = f"{criterion_per_hour:.3g} per hour"
    spare = clearance - least_clearance
    if slams_per_hour < NEVER:
        return f"{where} this deck does not slam; {_spare_words(spare, least_clearance, allowed)}."
    place = (
        "worst at its fore end" if distance_from_fore_end < 0.005 * max(clearance, 1e-9) else
        f"worst {length_words(distance_from_fore_end)} aft of its fore end"
    )  # fmt: skip
    slams = f"this deck slams {rate_words(slams_per_hour)}, {place}"
    if slams_per_hour > criterion_per_hour:
        missing = length_words(max(least_clearance - clearance, 0.0))
        return f"{where} {slams}; {missing} more clearance meets {allowed}."
    return f"{where} {slams}, and meets {allowed}; {_spare_words(spare, least_clearance, allowed)}."


def _spare_words(spare: float, least_clearance: float, allowed: str) -> str:
    """Words for how much lower the deck could be."""
    if least_clearance <= 0:
        return f"at any clearance it meets {allowed}"
    return f"{length_words(max(spare, 0.0))} less clearance would still meet {allowed}"
