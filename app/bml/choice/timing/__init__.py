"""When phases fall on the words, and how conflicts between behaviors are resolved. Imports `behavior_table` and `idle`.
Begin with `phases.py`, then `candidates.py`."""
