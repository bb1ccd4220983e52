"""The characters (lexicon/characters): who moves, with their own entries of the table, and the forms of their gestures
at a level of agitation. Imports `table` and `idle`. Begin with `overlays.py`."""
