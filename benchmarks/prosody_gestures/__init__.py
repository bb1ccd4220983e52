"""Gestures from the voice alone: how well, how fast, how late. Begin with `strokes.py`."""
