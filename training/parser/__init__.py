"""Trains the speech parser of models/parser: `python -m training.parser --treebanks FOLDER --output FOLDER`."""
