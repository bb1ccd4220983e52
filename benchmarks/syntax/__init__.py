"""Accuracy of the parser on transcribed speech: `python -m benchmarks.syntax.parser`. Imports `understudy.syntax`, and
the treebanks' reader from `training.parser`."""
