"""Idle behavior, and looks aside: `app/behavior/idle`. Begin with `test_idle_behaviors.py`."""
