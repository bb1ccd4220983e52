"""Tests of what measures the service. Begin with `test_drill.py`."""
