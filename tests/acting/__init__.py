"""What an audience reads in which movement: `app/acting`. Begin with `test_families.py`."""
