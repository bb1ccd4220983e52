"""Batches: speed, memory, resuming, and what is lost when killed. `python -m benchmarks.batch`."""
