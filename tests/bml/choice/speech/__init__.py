"""Lead-in, delivery and mouth shapes: `app/bml/choice/speech`. Begin with `test_visemes.py`."""
