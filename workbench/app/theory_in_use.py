"""Which theory answers a case."""

import numpy as np

from workbench.app.case import Case
from workbench.app.method_inputs import recommended_theories
from workbench.hydrodynamics.recommended import THEORY_NAMES, RecommendedSettings


def theories_of(case: Case) -> tuple[str, ...]:
    """Return the theories by which the answer to a case is computed, at the headings of its sea."""
    theory = case.theory
    if isinstance(theory, RecommendedSettings):
        condition = case.condition
        around = np.radians([0.0] if condition.sea_state.spreading_exponent is None else range(-90, 91, 15))
        headings = tuple((condition.wave_direction + around).tolist())
        return recommended_theories(case.design.hull.length, condition.speed, headings, theory.quick)
    return (next(name for name in THEORY_NAMES if theory == case.within.of(name)),)
