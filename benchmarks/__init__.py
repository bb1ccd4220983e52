"""Scripts that measure Understudy; each prints its figures: `python -m benchmarks.NAME`."""
