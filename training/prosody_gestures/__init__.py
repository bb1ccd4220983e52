"""Makes the model that gestures from the voice alone: see models/prosody_gestures/README.md.

`performed` has the rules perform recordings, `performed_lines` reads what they did, `train` learns from it.
"""
