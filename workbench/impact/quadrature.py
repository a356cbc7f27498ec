"""Integration of smooth functions on a uniform grid: running integral of eighth order, principal value."""

import numpy as np

ORDER = 8


def running_integral(count: int, step: float) -> np.ndarray:
    """Matrix (count, count) that integrates grid values from the first point to each point.

    Each interval is integrated over the polynomial through its eight nearest points.
    """
    nodes = np.arange(ORDER)
    power = np.arange(1, ORDER + 1)
    coefficients = np.linalg.inv(np.vander(nodes.astype(float), ORDER, increasing=True))
    steps = np.zeros((count, count))
    for i in range(count - 1):
        first = min(max(i - ORDER // 2 + 1, 0), count - ORDER)
        start = float(i - first)
        moments = ((start + 1) ** power - start**power) / power
        steps[i + 1, first : first + ORDER] = step * moments @ coefficients
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
