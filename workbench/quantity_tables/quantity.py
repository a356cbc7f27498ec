"""One row of the tables."""

from typing import NamedTuple


class Quantity(NamedTuple):
    """Unit (SI, '1' if none), label for axes, and symbol (matplotlib mathtext)."""

    units: str
    long_name: str
    symbol: str
