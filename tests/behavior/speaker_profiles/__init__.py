"""A speaker's profile on a line: `app/behavior/speaker_profiles`. Begin with `test_gesture_scripts.py`."""
