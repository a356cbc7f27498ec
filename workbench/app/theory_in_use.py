"""Which theory answers a case."""

from collections.abc import Iterable

import numpy as np

from workbench.app.case import Case
from workbench.app.method_inputs import recommended_theories
from workbench.app.model import Findings
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


def relevant(sentences: Iterable[str], found: Findings) -> tuple[str, ...]:
    """Return the sentences less those that are about theories of other headings alone."""
    used = theories_of(found.case)
    said = {
        name: str(found.ship.hydrodynamics.attrs.get(f"{name} warnings", "")).split("\n")
        for name in THEORY_NAMES
    }
    others = {line for name in THEORY_NAMES if name not in used for line in said[name]}
    others -= {line for name in used for line in said[name]}
    return tuple(line for line in sentences if line not in others)
