"""Which words of a line the body means something with, and what: the plan that a director would make (paper §3.4).

`planning.py` is where to begin: it reads a line in context (`encoder.py`), weighs that with the named terms of the line
(`terms.py`, `choice_model.py`) and takes the moments that are worth most. `families.py` says which behaviours show
what, `notes.py` puts a director's own notes in. Imports the values of `model`, `errors` and `yaml_files`.
"""
