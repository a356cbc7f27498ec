"""One way to name a design: a library name or a TOML file."""

from dataclasses import replace
from pathlib import Path

from workbench.design import Design
from workbench.errors import InputError
from workbench.files import design_from_toml
from workbench.hulls import library


def names() -> tuple[str, ...]:
    """Names of the library's designs."""
    return tuple(library.names())


def named_design(name: str) -> Design:
    """Return a design of the library by its name."""
    return library.design(name)


def design(name_or_path: str) -> Design:
    """Return a design by its library name, or from a TOML file."""
    text = str(name_or_path)
    if text.endswith(".toml") or "/" in text or "\\" in text:
        return design_from_toml(Path(text))
    return library.design(text)


def with_clearance(chosen: Design, clearance: float | None) -> Design:
    """Return the design with another wet-deck clearance [m] (its own if None); it must have a wet deck."""
    if chosen.wet_deck is None:
        raise InputError(
            f"design must have a wet deck, but {chosen.name} has none; choose a multihull with one."
        )
    if clearance is None:
        return chosen
    return replace(chosen, wet_deck=replace(chosen.wet_deck, clearance=clearance))
