"""What the reader hears of directed lines while it is trained. Begin with `test_listening.py`."""
