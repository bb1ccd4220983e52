"""Whole scripts: speed, memory, going on, and what a kill loses. `python -m benchmarks.batch`."""
