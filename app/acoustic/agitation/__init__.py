"""The speaker's agitation (low, medium, high) from the voice alone (paper §3.1.4): features of the utterance (timbre,
effort, dynamics, voice quality) and trained classifiers, optionally relative to the speaker's usual voice. Imports
`signal`. Begin with `classifier.py`, then `utterance_features.py`, which lists the features; `training/agitation`
trains the models."""
