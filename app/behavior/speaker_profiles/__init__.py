"""Applies a speaker's gesture profile to a performance: the gestures of its script, and the habits of head, eyes and
posture (NGS §3.3). Imports `profiles`. Begin with `gesture_scripts.py`."""
