"""The plan of a line, and the movements that show it: `app/acting`. Begin with `test_families.py`."""
