"""Makes the models that gesture from the voice alone: see models/prosody_gestures/README.md.

`performed` has the rules perform recordings, `performed_lines` reads what they did, `train` learns from it.
`train_pairs` learns from recordings with motion, which `motion_pairs` and `bvh` read; `affect` fits how a voice feels.
"""
