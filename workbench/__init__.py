"""Wet-deck workbench: motions and wet-deck slamming of multihulls, from design to pressure."""

from importlib.metadata import PackageNotFoundError, version

try:
    __version__ = version("wet-deck-workbench")
except PackageNotFoundError:  # a source tree that was never installed
    __version__ = "0+unknown"
