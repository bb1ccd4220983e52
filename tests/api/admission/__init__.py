"""Tests of who may come in, and of what every answer carries. Begin with `test_access.py`."""
