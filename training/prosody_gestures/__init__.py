"""Makes the models that gesture from the voice alone: see models/prosody_gestures/README.md.

`performed` has the rules perform recordings, `performed_lines` reads what they did, `train` learns from it; `affect`
fits how a voice feels. Motion is learnt from recordings with motion by `understudy motion-model train`; `own_motion`
makes those of ours from which the shipped model has learnt (models/motion/README.md).
"""
