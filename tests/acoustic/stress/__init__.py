"""How words stand out: `app/acoustic/stress` on contours made by hand. Begin with `test_stress.py`."""
