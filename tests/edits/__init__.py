"""Edits made again on a line. Imports `understudy.edits` and `performance`. Begin with `test_applying.py`."""
