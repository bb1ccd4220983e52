"""The speaker's agitation, low, medium or high, from the voice alone (paper §3.1.4): features of a whole utterance
(timbre, effort, motion, voice quality), judged by trained models, if wished against how the speaker usually sounds.
Imports `signal`. Begin with `agitation.py`, then `utterance_features.py`, which lists what the models see;
`training/agitation` makes them.
"""
