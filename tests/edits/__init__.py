"""Applying edits to a line. Imports `understudy.edits` and `performance`. Begin with `test_applying.py`."""
