"""Plans which words of a line the body expresses something on, and what, as a director would (paper §3.4).

Begin with `planning.py`: it reads a line in context (`encoder.py`), combines that with the named terms of the line
(`terms.py`, `choice_model.py`) and takes the moments with the highest worth. `families.py` says which behaviours show
what. Imports the values of `model`, `errors` and `yaml_files`.
"""
