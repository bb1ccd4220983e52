"""When phases fall on the words, and how conflicts between behaviors are resolved. Imports `table` and `idle`.
Begin with `phases.py`, then `anchoring.py`."""
