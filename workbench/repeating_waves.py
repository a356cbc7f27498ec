"""Waves of several frequencies that repeat: the period after which they do, exactly or nearly.

.. [Baggus2025] K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a
    heavy-lift catamaran in head seas", MSc thesis, Delft University of Technology, 2025, 6.1 and 6.2.
"""

from dataclasses import dataclass

import numpy as np

from workbench.errors import InputError, checked_number

MOST_CYCLES = 200
"""Periods of the fastest wave within which a repetition is looked for [-]."""


@dataclass(frozen=True)
class Repetition:
    """After which time waves repeat.

    Parameters
    ----------
    period : [s], whole periods of the fastest wave.
    cycles : whole periods of each wave in it, in the order of the frequencies.
    mismatch : largest relative difference between a frequency and the one that would repeat exactly [-].
    sentence : for a person; empty where the waves repeat exactly.
    """

    period: float
    cycles: tuple[int, ...]
    mismatch: float
    sentence: str = ""


def repetition(frequency, tolerance: float = 0.01, most_cycles: int = MOST_CYCLES) -> Repetition:
    """Shortest time after which waves repeat within a tolerance.

    Parameters
    ----------
    frequency : encounter frequencies [rad/s], of either sign, not 0.
    tolerance : largest relative difference of a frequency from a whole ratio [-].
    most_cycles : of the fastest wave.

    Notes
    -----
    [Baggus2025]_ 6.2 takes 9.5 and 4.2 rad/s as 9 : 4, 0.5 % off, and nine short periods as the window.
    A tolerance of 1e-9 asks for waves that repeat exactly.
    """
    omega = np.abs(np.atleast_1d(np.asarray(frequency, float)))
    if not omega.size or not np.all(np.isfinite(omega)) or np.any(omega == 0):
        raise InputError("encounter frequencies of waves that repeat must be finite and other than 0 rad/s.")
    checked_number("tolerance of the repetition", tolerance, above=0, below=0.5)
    fastest = omega.max()
    for count in range(1, int(most_cycles) + 1):
        cycles = np.round(omega / fastest * count)
        if np.any(cycles < 1):
            continue
        off = np.abs(omega / (cycles / count * fastest) - 1)
        if off.max() <= tolerance:
            return _repetition(omega, cycles.astype(int), float(off.max()), count, fastest)
    raise InputError(
        f"frequencies must be in whole ratios within {tolerance:g} and {most_cycles} periods of the fastest "
        f"({fastest:g} rad/s), which {', '.join(f'{one:g}' for one in omega)} rad/s are not; "
        "change one of them, or give the length of the record yourself."
    )


def _repetition(omega, cycles, mismatch, count, fastest) -> Repetition:
    period = 2 * np.pi * count / fastest
    sentence = ""
    if mismatch > 1e-9:
        worst = int(np.argmax(np.abs(omega * count / (cycles * fastest) - 1)))
        slip = np.degrees(omega[worst] * period - 2 * np.pi * cycles[worst])
        sentence = (
            f"The waves repeat only nearly: {count} periods at {fastest:g} rad/s take {period:.4g} s, "
            f"{cycles[worst]} at {omega[worst]:g} rad/s {2 * np.pi * cycles[worst] / omega[worst]:.4g} s "
            f"({100 * mismatch:.2g} % apart), so that one of them is {slip:.2g} degrees off at the end."
        )
    return Repetition(float(period), tuple(int(one) for one in cycles), mismatch, sentence)
