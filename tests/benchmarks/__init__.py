"""Tests of the benchmarks. Imports `benchmarks`; begin with `test_paths.py`."""
