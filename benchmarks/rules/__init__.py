"""How well and how fast functions are found, and what the chainer costs. Run `python -m benchmarks.rules.NAME`. Imports
`understudy.rules` and `performance`. Begin with `functions.py`.
"""
