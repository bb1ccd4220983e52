"""Trains the choice of gestures, head movements and faces on directed lines (models/acting).

`directed.py` reads the lines: those of ../shared/directing, and those of our own in `lines/`. `encoder.py` fine-tunes
the reader with PyTorch, `exporting.py` writes it for numpy, `weights.py` fits what the named terms add to it.
"""
