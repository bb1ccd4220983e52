"""Frames for other programs, read back. Begin with `test_vmc.py`."""
