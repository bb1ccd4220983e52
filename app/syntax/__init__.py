"""Words in; parts of speech, lemmas, dependencies, phrases and clauses out (paper §3.2). A spaCy pipeline parses; all
that knows spaCy is in `parser.py` and `tokens.py`, the rest works on our own tokens. Imports the values, the errors and
`transcript`. Begin with `parser.py`.
"""
