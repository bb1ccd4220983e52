"""The table of behaviors (lexicon/behaviors.yaml) and the lexemes it may use for faces and eyes. Imports only the
ground floor. Begin with `behavior_table.py`."""
