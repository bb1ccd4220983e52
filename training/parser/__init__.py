"""Trains the speech parser of models/parser: `python -m training.parser --treebanks FOLDER --output FOLDER`. Treebanks
are read, made to look like transcribed speech, trained on with spaCy, and shipped. Imports nothing of the package.
Begin with `__main__.py`.
"""
