"""Narrow focus: which words of a line the speaker stresses against the others, as shares that sum to 1. All modules are
pure functions of words, contours and a recording. Begin with `focus_model.py`; `cues.py` measures, `listeners.py` is a
network of others' that judges emphasis as listeners do."""
