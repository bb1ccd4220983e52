"""Tests of the service's benchmarks. Begin with `test_drill.py`."""
