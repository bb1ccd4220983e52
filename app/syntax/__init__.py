"""Syntactic analysis of a transcript: parts of speech, lemmas, dependencies, phrases and clauses (paper §3.2). A spaCy
pipeline parses; only `parser.py` and `tokens.py` depend on spaCy, the rest uses our own tokens. Imports the data model,
the errors and `transcript`. Begin with `parser.py`."""
