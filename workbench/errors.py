"""The two ways in which the workbench objects: a refused input, and a result outside a method's range."""

import math
from collections.abc import Iterable


class InputError(ValueError):
    """An input that cannot be used.

    The message is one sentence for a person: the quantity, what it was, what is
    allowed, and the cure. The command line prints it and exits with code 2; the
    app shows it beside the control.
    """


class ValidityWarning(UserWarning):
    """A result outside the stated range of the method that made it."""


def checked_number(
    name: str,
    value: object,
    unit: str = "",
    *,
    above: float | None = None,
    at_least: float | None = None,
    below: float | None = None,
    at_most: float | None = None,
    cure: str = "",
) -> float:
    """Return `value` as a float, or raise `InputError` naming quantity, value, range and cure.

    Text, booleans, NaN and infinities are refused. Limits are in the same unit
    as the value; `unit` only appears in the message.
    """
    allowed = _allowed(above, at_least, below, at_most, unit)
    ending = f"; {cure}." if cure else "."
    if isinstance(value, bool | str | bytes) or value is None:
        raise InputError(f"{name} must be a number{allowed}, got {value!r}{ending}")
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise InputError(f"{name} must be a number{allowed}, got {value!r}{ending}") from None
    inside = (
        math.isfinite(number)
        and (above is None or number > above)
        and (at_least is None or number >= at_least)
        and (below is None or number < below)
        and (at_most is None or number <= at_most)
    )
    if not inside:
        with_unit = f"{number:g} {unit}".strip()
        raise InputError(f"{name} must be a finite number{allowed}, got {with_unit}{ending}")
    return number


def checked_choice(name: str, value: object, choices: Iterable[str], cure: str = "") -> str:
    """Return `value` if it is one of `choices`, or raise `InputError` listing them."""
    choices = tuple(choices)
    if value not in choices:
        ending = f"; {cure}." if cure else "."
        raise InputError(f"{name} must be one of {', '.join(choices)}, got {value!r}{ending}")
    return str(value)


def _allowed(
    above: float | None, at_least: float | None, below: float | None, at_most: float | None, unit: str
) -> str:
    """Return the words for a range, such as ' > 0 and <= 5 m'."""
    limits = [
        f"{sign} {limit:g}"
        for sign, limit in ((">", above), (">=", at_least), ("<", below), ("<=", at_most))
        if limit is not None
    ]
    return f" {' and '.join(limits)} {unit}".rstrip() if limits else ""
