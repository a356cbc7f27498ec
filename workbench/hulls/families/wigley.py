"""The mathematical hull of Wigley.

[Wigley1934] W. C. S. Wigley, "A comparison of experiment and calculated wave-profiles and
    wave-resistances for a form having parabolic waterlines", Proc. Roy. Soc. A 144, 1934, pp. 144-159.
"""

import numpy as np

from workbench.hulls.lines import Lines


def wigley_lines(length: float, beam: float, draught: float, depth: float) -> Lines:
    """Lines of y = B/2 (1 - (2x/L)**2) (1 - (z/T)**2) [m], wall sided above water [Wigley1934]_.

    Volume 4/9 L B T, waterplane 2/3 L B, block coefficient 4/9.
    """
    x = length / 2 * np.linspace(-1.0, 1.0, 81)
    below = draught * np.linspace(-1.0, 0.0, 61)
    z = np.concatenate([below, np.linspace(0.0, depth - draught, 9)[1:]])
    half_breadth = beam / 2 * (1 - (2 * x / length) ** 2)
    y = half_breadth[:, None] * (1 - (np.minimum(z, 0.0) / draught) ** 2)
    return Lines(x, y, np.broadcast_to(z, y.shape).copy())
