"""The computer program of the source (CAT, its Table 1) in its own units, constants and formats.

Kept apart from `workbench.impact.chuang` on purpose: feet, slugs and psi, the
rounded constants of 1975, one slam at a time. It is a second way to the same
numbers, and what a line of the program's printout looked like.

.. [Chuang1975] S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation
    of catamaran cross-structure slamming", NSRDC Report 4653, 1975, Table 1, p. 9.
"""

import math
from typing import NamedTuple

from workbench.errors import InputError

RADIANS = 0.0174533
HALF_DENSITY_PSI = 0.006736
DENSITY = 1.94
"""Fresh water [slug/ft3], fixed in the program; half of it over 144 is `HALF_DENSITY_PSI`."""


class Line(NamedTuple):
    """One line of the printout.

    ``vn``, ``vt`` : normal and tangential velocity [ft/s]; ``x`` : impact angle [degrees];
    ``c`` : back-calculated k [-]; ``k`` : of the prediction line [-]; ``pnc``, ``pnr`` :
    calculated and recorded total pressure [psi].
    """

    vn: float
    vt: float
    x: float
    c: float
    k: float
    pnc: float
    pnr: float

    def text(self) -> str:
        """The two records of the printout in their formats, 3F7.3 F5.3 and F7.5 2F7.3."""
        first = "".join(fortran(value, 7, 3) for value in (self.vn, self.vt, self.x))
        second = fortran(self.k, 7, 5) + fortran(self.pnc, 7, 3) + fortran(self.pnr, 7, 3)
        return f"{first}{fortran(self.c, 5, 3)}\n{second}"


def fortran(value: float, width: int, decimals: int) -> str:
    """Number as F``width``.``decimals`` prints it: without its leading 0 if need be, stars if it does not fit."""
    written = f"{value:.{decimals}f}"
    if len(written) > width:
        written = written.replace("0.", ".", 1) if abs(value) < 1 else written
    return written.rjust(width) if len(written) <= width else "*" * width


def cat(vhea: float, vwav: float, vp: float, td: float, wsd: float, pnr: float) -> Line:
    """Run program CAT for one slam.

    Parameters
    ----------
    vhea, vwav, vp : velocities of heave, wave surface and pitch, downward positive [ft/s].
    td, wsd : pitch (bow up) and wave slope (rising to the bow) [degrees].
    pnr : recorded peak pressure [psi].

    Notes
    -----
    The tangential velocity has the sign of the angle before its modulus is taken.
    Nothing of the roll or of sea water is in the program.
    """
    x = td - wsd
    t, xi = RADIANS * td, RADIANS * x
    vv = vhea - vwav
    vns = vv * math.cos(t) + vp
    vn = vns * math.cos(xi) / math.cos(t) ** 2
    vt = vns * math.sin(xi)
    ppc = HALF_DENSITY_PSI * vt**2
    x = abs(x)
    ak = _constant(x, xi)
    pic = DENSITY * ak * vn**2
    if vn == 0:
        raise InputError(
            "velocities of a slam must not cancel, got a normal velocity of 0 ft/s; k would be infinite."
        )
    return Line(vn, vt, x, (pnr - ppc) / (DENSITY * vn**2), ak, ppc + pic, pnr)


def _constant(x: float, xi: float) -> float:
    """AK of the program: x [degrees], xi [rad]."""
    if x < 2.2:
        return 0.37 * x / 2.2 + 0.5
    if x < 11.0:
        return (
            2.1820894
            - 0.9451815 * x
            + 0.2037541 * x**2
            - 0.0233896 * x**3
            + 0.0013578 * x**4
            - 0.00003132 * x**5
        )
    if x < 20.0:
        return (
            4.748742
            - 1.3450284 * x
            + 0.1576516 * x**2
            - 0.0092976 * x**3
            + 0.0002735 * x**4
            - 0.00000319864 * x**5
        )
    return 0.76856471 * (1.0 + 2.4674 / math.tan(xi) ** 2) / 288.0
