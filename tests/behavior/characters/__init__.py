"""Characters and the forms of their gestures: `app/behavior/characters`. Begin with `test_overlays.py`."""
