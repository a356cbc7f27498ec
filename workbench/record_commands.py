"""Command for measured records."""
