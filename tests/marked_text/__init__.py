"""Texts with marks: `app/marked_text`. Begin with `test_reading.py`."""
