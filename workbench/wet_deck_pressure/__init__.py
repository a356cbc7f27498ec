"""Pressure over the wet deck in time."""
