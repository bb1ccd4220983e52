"""Trains the models of affect in models/affect: acted corpora with the tones of their recordings, an expert for each,
and the gate between them. Uses the features, conditions and support vector machines of `training/agitation`. Run
`python -m training.affect`; begin with `__main__.py`."""
