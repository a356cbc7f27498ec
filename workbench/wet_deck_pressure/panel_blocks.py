"""Pressure against area: averages over blocks of neighbouring panels."""

import numpy as np


def block_sizes(count_x: int, count_y: int) -> list[tuple[int, int]]:
    """Sizes of blocks (along, across) from one panel to the whole deck, each about twice the one before."""
    sizes = [(1, 1)]
    along, across = 1, 1
    while (along, across) != (count_x, count_y):
        if along / count_x <= across / count_y:
            along = min(2 * along, count_x)
        else:
            across = min(2 * across, count_y)
        sizes.append((along, across))
    return sizes


def largest_averages(pressure: np.ndarray, sizes: list[tuple[int, int]]) -> np.ndarray:
    """Largest average of the pressure (time, x, y) over any block of each size, at every time (time, size).

    Costs one running sum and one look-up a size.
    """
    total = np.zeros((len(pressure), pressure.shape[1] + 1, pressure.shape[2] + 1))
    total[:, 1:, 1:] = pressure.cumsum(axis=1).cumsum(axis=2)
    found = np.empty((len(pressure), len(sizes)))
    for index, (along, across) in enumerate(sizes):
        block = (
            total[:, along:, across:]
            - total[:, :-along, across:]
            - total[:, along:, :-across]
            + total[:, :-along, :-across]
        )
        found[:, index] = block.max(axis=(1, 2), initial=-np.inf) / (along * across)
    return found
