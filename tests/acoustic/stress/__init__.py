"""Stress of words: `app/acoustic/stress` on hand-made contours. Begin with `test_stress.py`."""
