"""Gestures from the voice alone: accuracy, speed and latency. Begin with `strokes.py`."""
