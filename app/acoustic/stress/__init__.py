"""How much each word stands out: the paper's stressed ratio (§3.1.5), our prominence, and emphasis, which is whichever
of them is set. Every module is a pure function of words and contours and imports the values alone. Begin with
`stress.py`, which follows the paper, then `emphasis.py`, whose measure all later stages use.
"""
