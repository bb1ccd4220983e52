"""Stress of words: the paper's stressed ratio (§3.1.5), perceived prominence, and emphasis, which is based on the
configured one of the two. All modules are pure functions of words and contours and import only the data model. Begin
with `stress.py`, which follows the paper and ends with the measure that all later stages use.
"""
