"""Lead-in, delivery and mouth shapes: `app/behavior/speech`. Begin with `test_visemes.py`."""
