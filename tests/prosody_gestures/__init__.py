"""The semi-Markov model and what is built on it. Begin with `test_viterbi.py`, which searches all paths by hand."""
