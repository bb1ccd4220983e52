"""Corpora, degradations, choosing and the fuzzy support vector machine of `training/agitation`, on data made in the
test. Begin with `test_choosing.py`.
"""
