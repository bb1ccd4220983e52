"""Idle behavior, and looks aside: `app/bml/choice/idle`. Begin with `test_idle_behaviors.py`."""
