"""Speech as it comes. Begin with `test_events.py`."""
