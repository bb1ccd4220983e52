"""Agitation and its features, mostly on synthetic signals: `app/acoustic/agitation`. Begin with
`test_classifier.py`."""
