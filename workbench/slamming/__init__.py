"""Slamming of the wet deck: closed-form statistics, counted events, extremes and criteria."""
