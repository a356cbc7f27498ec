"""The named designs: published vessels, and stand-ins where the hull lines are not published.

Every design says in its ``provenance`` which of its figures is published,
which is derived from published ones, and which is ours, and why.
"""

import difflib
from collections.abc import Callable
from functools import cache, partial

from workbench.design import Design
from workbench.errors import InputError
from workbench.hulls.vessels import cruising, delft, ferries, heavy_lift, naval, npl, sailing

_DESIGNS: dict[str, Callable[[], Design]] = {
    "delft-372": delft.delft_372,
    "austal-63": ferries.austal_63,
    "crowther-318": sailing.crowther_318,
    "crowther-318-modified": sailing.crowther_318_modified,
    "sally-malay": cruising.sally_malay,
    "educat": naval.educat,
    "catamaran-35": sailing.catamaran_35,
    "trimaran-35": sailing.trimaran_35,
    "cofea": naval.cofea,
    "asr-5116": naval.asr_5116,
    "hayes": naval.hayes,
    **{f"npl-{model}": partial(npl.npl_model, model) for model in npl.RATIOS},
    "incat-061": ferries.incat_061,
    "incat-064": ferries.incat_064,
    "heavy-lift-198": heavy_lift.heavy_lift_198,
    "heavy-lift-198-model": heavy_lift.heavy_lift_198_model,
}


def names() -> tuple[str, ...]:
    """Names of all designs of the library."""
    return tuple(_DESIGNS)


def design(name: str) -> Design:
    """Return the design of that name; an unknown name is refused with the closest ones."""
    if not isinstance(name, str) or name not in _DESIGNS:
        close = difflib.get_close_matches(str(name), _DESIGNS, n=3, cutoff=0.3) or list(_DESIGNS)
        raise InputError(
            f"design must be one of the library, got {name!r}; the closest names are {', '.join(close)}."
        )
    return _made(name)


@cache
def _made(name: str) -> Design:
    return _DESIGNS[name]()
