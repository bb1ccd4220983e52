"""What is done unasked, and when the eyes leave: `app/bml/choice/idle`. Begin with `test_idle_behaviors.py`."""
