"""Makes the models that gesture from the voice alone: see models/prosody_gestures/README.md.

`performed` has the rules perform recordings and keeps what they did beside what was heard; `pairs` reads that, and the
recordings with motion of others; `train` learns the models that ship.
"""
