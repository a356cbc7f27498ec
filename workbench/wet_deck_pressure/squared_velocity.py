"""What the squared velocity takes from the pressure on the deck, as the modified Logvinovich model has it.

On a deck of small slope Bernoulli's equation in full is p/rho = -phi_t - (phi_x**2 + W**2)/2
([Korobkin2004]_). Towards a jet root the second part outgrows the first; the pressure ends where it would
turn negative.

.. [Korobkin2004] A. A. Korobkin, "Analytical models of water impact", European Journal of
    Applied Mathematics 15, 821-838, 2004.
"""

import numpy as np

_REACH = 8.0
_NODES = 97
_STRETCHED = np.linspace(-_REACH, _REACH, _NODES)
_ANGLES = 2 * np.arctan(np.exp(_STRETCHED))
_SINES = np.sin(_ANGLES)


def taken_by_squared_velocity(
    velocity: np.ndarray,
    rate: np.ndarray,
    half: np.ndarray,
    spreads_aft: np.ndarray,
    spreads_fore: np.ndarray,
    angle: np.ndarray,
) -> np.ndarray:
    """Integral of the part of p/rho that the squared velocity takes, from the aft end to panel edges [m3/s2].

    Parameters
    ----------
    velocity, rate : (K, modes) terms of the closing velocity [m/s] and acceleration [m/s2] of each interval.
    half : (K,) half-lengths [m]; spreads_aft, spreads_fore : (K,) speeds of the ends outwards, 0 where they
        recede [m/s].
    angle : (K, edges) of the panel edges, theta in x = m + l cos(theta).

    Notes
    -----
    Where the outer pressure is suction nothing is taken. The integrand is smooth in ln tan(theta/2).
    """
    order = np.arange(1, velocity.shape[1] + 1)
    sines = np.sin(np.outer(order, _ANGLES))
    outer = half[:, None] * (rate / order) @ sines
    at_fore_end, at_aft_end = velocity.sum(axis=1), velocity @ (-1.0) ** (order - 1)
    outer = outer + (spreads_fore * at_fore_end / 2)[:, None] / np.exp(_STRETCHED)
    outer = outer + (spreads_aft * at_aft_end / 2)[:, None] * np.exp(_STRETCHED)
    closing = velocity @ (sines / _SINES)
    along = velocity @ (np.cos(np.outer(order, _ANGLES)) / _SINES)
    taken = np.clip((closing**2 + along**2) / 2, 0.0, np.maximum(outer, 0.0)) * _SINES**2
    step = _STRETCHED[1] - _STRETCHED[0]
    from_aft = np.zeros_like(taken)
    from_aft[:, :-1] = (np.cumsum((taken[:, 1:] + taken[:, :-1])[:, ::-1], axis=1) * step / 2)[:, ::-1]
    with np.errstate(divide="ignore"):
        place = (np.log(np.tan(angle / 2)) + _REACH) / step
    place = np.clip(np.nan_to_num(place, neginf=0.0, posinf=_NODES), 0.0, _NODES - 1 - 1e-9)
    index = place.astype(int)
    flat = np.arange(len(taken))[:, None] * _NODES + index
    low, high = from_aft.ravel()[flat], from_aft.ravel()[flat + 1]
    return half[:, None] * (low + (place - index) * (high - low))
