"""What a table of offsets must be before a hull can be made of it."""

from itertools import pairwise

from workbench.errors import InputError, checked_number

LEAST_STATIONS = 5
LEAST_POINTS = 3


def checked_stations(stations: object, draught: float, length: float) -> tuple:
    """Return the stations as tuples of floats, or raise `InputError` saying what is wrong with them.

    Parameters
    ----------
    stations : (x, ((z, half_breadth), ...)) [m], rising x, each with rising z.
    draught, length : of the waterline [m].
    """
    try:
        stations = tuple((x, tuple((z, y) for z, y in points)) for x, points in stations)  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        raise InputError(
            f"offsets must be stations (x, ((z, half_breadth), ...)), got {str(stations)[:60]!r}; "
            "give each station as its x and its points from the keel upwards."
        ) from None
    if not stations:
        raise InputError("table of offsets must have points, got an empty table; give x, z, half_breadth.")
    checked = tuple(_checked_station(x, points) for x, points in stations)
    positions = [x for x, _ in checked]
    for x, following in pairwise(positions):
        if following == x:
            raise InputError(f"stations must differ in x, got x = {x:g} m twice; remove or merge one.")
        if following < x:
            raise InputError(
                f"stations must be sorted from aft to forward, got x = {following:g} m after {x:g} m; "
                "sort the table by x."
            )
    with_section = [station for station in checked if len(station[1]) > 1]
    if len(with_section) < LEAST_STATIONS:
        raise InputError(
            f"table of offsets must have at least {LEAST_STATIONS} stations with a section, "
            f"got {len(with_section)}; add stations."
        )
    lowest = min(points[0][0] for _, points in checked)
    if lowest >= draught:
        raise InputError(
            f"draught must be above the lowest offset ({lowest:g} m), got {draught:g} m; "
            "the hull does not reach the water: raise the draught or check the keel datum."
        )
    for x, points in with_section:
        if points[0][0] < draught and points[-1][0] <= draught:
            raise InputError(
                f"offsets at station x = {x:g} m must reach above the waterline at z = {draught:g} m, "
                f"they end at z = {points[-1][0]:g} m; add points up to the deck edge or reduce the draught."
            )
    extent = positions[-1] - positions[0]
    if not 0.8 * length <= extent <= 1.5 * length:
        raise InputError(
            f"stations must span 0.8 to 1.5 times the hull length ({length:g} m), got {extent:g} m; "
            "check the unit of the offsets and the length."
        )
    return checked


def _checked_station(x: object, points: tuple) -> tuple:
    """Return one station as floats."""
    x = checked_number("station x", x, "m")
    if not points:
        raise InputError(f"station x = {x:g} m must have points, got none; add them or remove the station.")
    checked = []
    for z, y in points:
        z = checked_number(f"offset height z at station x = {x:g} m", z, "m")
        y = checked_number(
            f"half-breadth at station x = {x:g} m, z = {z:g} m",
            y,
            "m",
            at_least=0.0,
            cure="give half-breadths of one hull about its own centre plane",
        )
        checked.append((z, y))
    if len(checked) == 1 and checked[0][1] > 0.0:
        raise InputError(
            f"station x = {x:g} m must have at least {LEAST_POINTS} points, or one point with "
            f"half-breadth 0 on the profile of the stem, got one with half-breadth {checked[0][1]:g} m; "
            "add the points of the section."
        )
    if 1 < len(checked) < LEAST_POINTS:
        raise InputError(
            f"station x = {x:g} m must have at least {LEAST_POINTS} points, got {len(checked)}; add points."
        )
    for (z, y), (z_next, y_next) in pairwise(checked):
        if (z, y) == (z_next, y_next):
            raise InputError(f"station x = {x:g} m has the point z = {z:g} m twice; remove one.")
        if z_next < z:
            raise InputError(
                f"points of station x = {x:g} m must be sorted from the keel upwards, got z = {z_next:g} m "
                f"after {z:g} m; sort the table by z."
            )
    return x, tuple(checked)
