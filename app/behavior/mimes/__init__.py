"""Mimes of what a body does, by the verb and its object (`lexicon/acting/mimes.yaml`). Imports the ground floor alone.
Begin with `finding.py`."""
