"""Trains the agitation models of models/agitation (paper §3.1.4): corpora with their labels, recordings as other rooms
and microphones would have them, a fuzzy support vector machine, and the choice between ways of training. Imports the
features from `understudy.acoustic`. Run `python -m training.agitation`; begin with `__main__.py`.
"""
