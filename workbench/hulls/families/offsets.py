"""A hull from its table of offsets."""

import numpy as np

from workbench.hulls.lines import Lines, evenly_spaced, smooth_contour

POINTS = 81


def offsets_lines(stations: tuple, draught: float) -> Lines:
    """Lines through a table of offsets [m].

    Parameters
    ----------
    stations : (x, ((z, half_breadth), ...)) from aft to forward, z from low to high above the keel
        datum; a station of one point on the centreline gives the profile of stem or stern there.
    draught : height of the waterline above the keel datum [m].

    Notes
    -----
    Ahead of the last station with a section (and abaft the first) the
    waterlines run straight to the profile.
    """
    full = [k for k, (_, points) in enumerate(stations) if len(points) > 1]
    contours = {k: _contour(stations[k][1]) for k in full}
    for end, others in ((full[-1], stations[full[-1] + 1 :]), (full[0], stations[: full[0]])):
        for station in others:
            k = stations.index(station)
            contours[k] = _contour_at_profile(stations[end], others, station)
    x = np.array([stations[k][0] for k in sorted(contours)])
    grid = np.stack([contours[k] for k in sorted(contours)])
    return Lines(x, grid[..., 0], grid[..., 1] - draught)


def _contour(points: tuple) -> np.ndarray:
    """Return (y, z) evenly spaced from the centreline to the deck edge."""
    table = np.array([(y, z) for z, y in points], float)
    if table[0, 0] > 0.0:  # a flat bottom: the centreline point is not tabulated
        table = np.concatenate([[[0.0, table[0, 1]]], table])
    return smooth_contour(table, POINTS)


def _contour_at_profile(end_station: tuple, profile: tuple, station: tuple) -> np.ndarray:
    """Return the contour between a last section and the stem (or stern) profile."""
    x_end, end_points = end_station
    x_here, ((z_here, _),) = station
    z_end, y_end = np.array(end_points, float).T
    outward = sorted([(z_end[0], x_end), *((points[0][0], x) for x, points in profile)])
    profile_z, profile_x = np.array(outward).T
    z = np.linspace(z_here, max(z_end[-1], z_here), POINTS)
    x_profile = np.interp(z, profile_z, profile_x)
    reach = np.where(np.abs(x_profile - x_end) > 0, x_profile - x_end, 1.0)
    share = np.clip((x_profile - x_here) / reach, 0.0, 1.0)
    y = np.interp(z, z_end, y_end) * share
    y[0] = 0.0
    return evenly_spaced(np.stack([y, z], axis=1), POINTS)
