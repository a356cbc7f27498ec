"""What forward speed adds to radiation and diffraction forces of hulls at rest [STF1970]_.

Speed enters through the encounter frequency, through the m-terms of pitch and yaw in a
uniform stream, through the convective pressure by the Ogilvie-Tuck theorem and, behind
a transom that runs dry, through its end terms.

With exp(-i omega_e t) and x forward (complex conjugate of [Grande2002]_ A1.87, A1.97-A1.99,
which use exp(+i omega_e t); where the thesis prints other signs, in T_6k and T_j6, these
are the ones that m_6 = -n_2 gives)::

    F_jk = F0_jk                       F0_jk = omega_e^2 A0_jk + i omega_e B0_jk
    F_5k += U/(i omega_e) F0_3k        F_j5 -= U/(i omega_e) F0_j3     (pitch)
    F_6k -= U/(i omega_e) F0_2k        F_j6 += U/(i omega_e) F0_j2     (yaw)
    F_jk -= U/(i omega_e) t_jk         t_jk = omega_e^2 a_jk + i omega_e b_jk of the last section
    D_5 += U/(i omega_e) D_3,  D_6 -= U/(i omega_e) D_2,  D_j -= U/(i omega_e) d_j

where the columns 5 and 6 of t have their own speed terms, D_j is the diffraction force
and d_j its density per length at the transom.

.. [STF1970] N. Salvesen, E. O. Tuck and O. Faltinsen, "Ship motions and sea loads",
    Trans. SNAME 78, 250-287, 1970.
.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, appendix 1.
"""

import numpy as np

VENTILATION_FROUDE_NUMBER = 2.5
"""Froude number on the transom draught from which the transom is taken to run dry [-]."""


def with_speed(at_rest: np.ndarray, line: np.ndarray, ratio: np.ndarray) -> np.ndarray:
    """Radiation forces (frequency, 6 j, 6 k) with their speed terms.

    Parameters
    ----------
    at_rest : F0 (frequency, 6, 6); line : t of a dry transom, 0 without one.
    ratio : U/(i omega_e) (frequency,) [m].
    """
    ratio = ratio[:, None]

    def columns(force):
        full = force.copy()
        full[:, :, 4] -= ratio * force[:, :, 2]
        full[:, :, 5] += ratio * force[:, :, 1]
        return full

    moving, end = columns(at_rest), columns(line)
    full = moving.copy()
    full[:, 4, :] += ratio * moving[:, 2, :]
    full[:, 5, :] -= ratio * moving[:, 1, :]
    return full - ratio[:, :, None] * end


def force_with_speed(at_rest: np.ndarray, end: np.ndarray, ratio: np.ndarray) -> np.ndarray:
    """Diffraction forces (waves, 6) with their speed terms; ``end`` is their density at a dry transom."""
    force = at_rest - ratio[:, None] * end
    force[:, 4] += ratio * at_rest[:, 2]
    force[:, 5] -= ratio * at_rest[:, 1]
    return force
