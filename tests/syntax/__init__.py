"""Parses, phrases and clauses: `app/syntax` on trees written by hand, and the shipped parser on sentences of its own
tests. Imports `support` for the trees. Begin with `test_phrases.py`, then `test_parser.py`.
"""
