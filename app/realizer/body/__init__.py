"""The body: its skeleton, how thick it is, how far joints turn, where parts touch, and the value that a motion is.
Imports `geometry`. Begin with `skeleton.py` and `motion.py`.
"""
