"""Integration of smooth functions on a uniform grid: running integral of eighth order, principal value."""

from fractions import Fraction
from functools import cache

import numpy as np

ORDER = 8


@cache
def _interval_weights() -> np.ndarray:
    """Weights of eight values for the integral over each of the seven intervals between them, (interval, value).

    In exact fractions: rounded inverses of the matrix of powers leave errors that sums over many intervals carry far.
    """
    weights = np.zeros((ORDER - 1, ORDER))
    for value in range(ORDER):
        basis = [Fraction(1)]
        for other in (node for node in range(ORDER) if node != value):
            scale = Fraction(1, value - other)
            longer = [Fraction(0), *(scale * c for c in basis)]
            basis = [a - other * scale * c for a, c in zip(longer, [*basis, Fraction(0)], strict=True)]
        for start in range(ORDER - 1):
            integral = sum(
                c * Fraction((start + 1) ** (n + 1) - start ** (n + 1), n + 1) for n, c in enumerate(basis)
            )
            weights[start, value] = float(integral)
    return weights


def running_integral(count: int, step: float) -> np.ndarray:
    """Matrix (count, count) that integrates grid values from the first point to each point.

    Each interval is integrated over the polynomial through its eight nearest points.
    """
    weights = step * _interval_weights()
    steps = np.zeros((count, count))
    for i in range(count - 1):
        first = min(max(i - ORDER // 2 + 1, 0), count - ORDER)
        steps[i + 1, first : first + ORDER] = weights[i - first]
    return np.cumsum(steps, axis=0)


def principal_value(count: int, step: float) -> np.ndarray:
    """Matrix (count, count) of the principal value of the integral of g(u')/(exp(u - u') - 1) over u'.

    Alternating points make the rule for the simple pole as good as the trapezoidal rule
    is for a smooth function. Left of the grid g keeps its first value; right of it g is zero.
    """
    beyond = 2 * int(20 / step)
    offset = np.arange(count)[:, None] - np.arange(-beyond, count)[None, :]
    odd = offset % 2 == 1
    kernel = np.zeros(offset.shape)
    kernel[odd] = 2 * step / np.expm1(offset[odd] * step)
    kernel[:, beyond] += kernel[:, :beyond].sum(axis=1)
    return kernel[:, beyond:]
