"""Standing, breath, sway and posture: `app/realizer/torso`. Begin with `test_idle.py`."""
