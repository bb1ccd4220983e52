"""Tests of the scripts that measure. Imports `benchmarks`; begin with `test_paths.py`."""
