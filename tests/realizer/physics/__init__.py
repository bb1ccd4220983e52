"""Motion with mass: `app/realizer/physics`. Begin with `test_tracking.py`."""
