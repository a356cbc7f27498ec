"""Parametric studies: changes of the slams that are known not to be those of the source, by how much, and why."""

OFTEN = (
    "with 4 m the stand-in slams 2 to 4 times as often as the tables say at 30 and 40 knots (233 and 217 against 98 "
    "and 51 per hour): what is reached by most waves gains less from a rise or a move; with 3 m, where it slams about "
    "as often as they say, the same changes agree. Clearance, T-foils and sea of the source are not published"
)
HEADING = (
    "15 degrees off the bow a corner of the stand-in's deck slams a twentieth to a third more often than in head seas; "
    "the source has one point of the deck, at a place not published"
)
CROWTHER_OFTEN = (
    "the stand-in slams 1.5 to 29 times as often as the tables say (at 15 knots 1407 and 1140 against 368 and 39 per "
    "hour): nearly every wave reaches pod and beam, whatever is done to them. Clearances, hull lines, canting of the "
    "hulls and sea are not published"
)
CROWTHER_SELDOM = (
    "the stand-in's main beam slams 26 times an hour, the source's 66 times: the rarer the slams, the more a rise "
    "takes away. Clearance and sea are not published"
)
CROWTHER_SIGN = (
    "at 2 degrees of heel, with one hull deep and one nearly out of the water, length and beam of the stand-in's hulls "
    "act the other way on its pod; lines, weights, sails and heeled attitude of the ship are not published, and why "
    "it is so has not been found"
)

MISSES: dict[str, float] = {
    "austal-deck-raised-30-knots-hs4": -45.7,
    "austal-deck-raised-40-knots-hs4": -50.5,
    "austal-deck-aft-40-knots-hs4": -12.8,
    "austal-heading-from-head": 0.0,
    "crowther-pod-aft": 0.0,
    "crowther-pod-longer-10-knots": 33.7,
    "crowther-pod-wider-hulls-10-knots": 30.6,
    "crowther-pod-deck-raised-10-knots": -50.5,
    "crowther-pod-wider-hulls-15-knots": -13.0,
    "crowther-pod-deck-aft-15-knots": -1.2,
    "crowther-pod-deck-raised-15-knots": -22.5,
    "crowther-main-beam-deck-raised-5-knots": -90.4,
    "crowther-main-beam-deck-raised-10-knots": -33.3,
    "crowther-main-beam-deck-raised-15-knots": -32.2,
}
"""Computed figures of the comparisons that are known not to agree [percent, or 0 for no]."""


def reason(name: str) -> str:
    """Why a change of the slams is not that of the source."""
    if name == "austal-heading-from-head":
        return HEADING
    if name.startswith("austal"):
        return OFTEN
    if name == "crowther-main-beam-deck-raised-5-knots":
        return CROWTHER_SELDOM
    if name in ("crowther-pod-longer-10-knots", "crowther-pod-wider-hulls-10-knots"):
        return CROWTHER_SIGN
    return CROWTHER_OFTEN
