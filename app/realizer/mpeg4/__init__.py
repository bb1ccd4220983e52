"""MPEG-4 face and body animation (Gesture Engine §4): one ASCII file of body, one of face parameters. Begin with
`bap.py`."""
