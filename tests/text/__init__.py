"""What is said, as text: `app/text`. Begin with `test_reading.py`."""
