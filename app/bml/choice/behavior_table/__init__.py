"""The table of behaviors (lexicon/behaviors.yaml) and the words it may use for faces and eyes. Imports only the ground
floor. Begin with `table.py`.
"""
