"""How well and how fast functions are found, and what the chainer costs. Run `python -m benchmarks.rules.NAME`. Imports
`understudy.rules` and the parser, and for dialogue the treebanks' reader of `training.parser`. Begin with
`functions.py`.
"""
