"""Benchmarks: times and ratios against named alternatives, measured in one run by ``make bench``."""
