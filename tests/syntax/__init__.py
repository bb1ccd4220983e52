"""Parses, phrases and clauses: `app/syntax` on trees written by hand, and what the shipped parser makes of whole
sentences. Imports `support` for the trees. Begin with `test_phrases.py`, then `test_parser.py`.
"""
