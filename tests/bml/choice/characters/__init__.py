"""Characters and the forms of their gestures: `app/bml/choice/characters`. Begin with `test_characters.py`."""
