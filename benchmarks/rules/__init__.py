"""Accuracy and speed of deriving functions, and the cost of the chainer. Run `python -m benchmarks.rules.NAME`. Imports
`understudy.rules` and the parser, and for dialogue the treebanks' reader of `training.parser`. Begin with
`functions.py`."""
