"""The listeners and their behavior: `app/bml/choice/listeners`. Begin with `test_listening.py`."""
