"""The listeners and their behavior: `app/behavior/listeners`. Begin with `test_listening.py`."""
