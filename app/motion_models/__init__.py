"""Motion from data: a model learnt from recordings of speech with their motion performs other recordings, or live
speech, with the recorded movements themselves.

`pairs` reads recordings, `bodies` brings their motion to our skeleton; `training` cuts the motion into phrases,
clusters these into kinds (`clustering`) and learns the semi-Markov model of kinds, prosody and affect
(`understudy.prosody_gestures`); `model` is what is learnt, with the recorded units. `performing` decodes a recording
and lays its units (`unit_selection`) over a realized motion, `playing` does so for a live voice; `scoring` has the
measures. Sources: "RTS" is the thesis Real-Time Speech Driven Gesture Animation, "AHG" the paper Affect-Expressive Hand
Gestures (docs/references.md). Conventions: frames of `FRAME_S`, rotations local to the parent as quaternions x y z w.
"""
